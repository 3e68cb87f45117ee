"""A mooring system as both readers of input files describe it."""

from __future__ import annotations

from dataclasses import dataclass, field

from .cells import Notes

WORLD, VESSEL = "world", "vessel"
Vector = tuple[float, float, float]
ZERO: Vector = (0.0, 0.0, 0.0)


@dataclass
class LineType:
    """Properties of a kind of wire or chain, in SI units.

    Attributes
    ----------
    damping_n_s
        BA, N s; if negative, minus the share of the critical damping of a segment; `None` for the engine's
        default.
    """

    name: str
    line: int
    diameter_m: float
    mass_kg_per_m: float
    stiffness_n: float
    damping_n_s: float | None
    bending_n_m2: float
    drag_across: float
    drag_along: float
    added_mass_across: float
    added_mass_along: float
    notes: Notes = field(default_factory=Notes)


@dataclass
class Point:
    """A point that lines connect to.

    Attributes
    ----------
    body
        The body that carries it, `WORLD`, or `None` for a free point.
    position_m
        In the world, or in the drawing frame of its body.
    """

    name: str
    line: int
    body: str | None
    position_m: Vector
    mass_kg: float = 0.0
    volume_m3: float = 0.0
    drag_area_m2: float = 0.0
    added_mass: float = 0.0

    @property
    def is_bare(self) -> bool:
        """Whether it is free and has neither mass, volume nor drag."""
        return self.body is None and not (self.mass_kg or self.volume_m3 or self.drag_area_m2)


@dataclass
class Segment:
    """A line of one type between two points, in segments of the input file."""

    name: str
    line: int
    kind: LineType
    ends: tuple[str, str]
    length_m: float
    segments: int


@dataclass
class Body:
    """A body that carries points.

    Attributes
    ----------
    motion
        `held`, `fixed`, `pinned` (held at its origin, free to turn) or `free`.
    orientation_rad
        Roll, pitch, yaw (intrinsic z-y-x angles).
    """

    name: str
    line: int | None
    motion: str
    position_m: Vector = ZERO
    orientation_rad: Vector = ZERO
    mass_kg: float = 0.0
    centre_m: Vector = ZERO
    moments_kg_m2: Vector = ZERO
    volume_m3: float = 0.0
    drag_areas_m2: Vector = ZERO
    added_mass: Vector = ZERO


@dataclass
class Water:
    """Sea, seabed and gravity; `depth_m` is 0 if the file does not give it."""

    depth_m: float = 0.0
    density_kg_m3: float = 1025.0
    gravity_m_s2: float = 9.80665
    stiffness_n_per_m3: float = 3e6
    damping_n_s_per_m3: float = 3e5
    friction: float = 0.0


@dataclass
class Deck:
    """All of an input file that has a counterpart in a scenario, and notes on the rest."""

    file: str
    title: str = ""
    water: Water = field(default_factory=Water)
    step_s: float | None = None
    record_every_s: float | None = None
    types: dict[str, LineType] = field(default_factory=dict)
    bodies: dict[str, Body] = field(default_factory=dict)
    points: dict[str, Point] = field(default_factory=dict)
    lines: list[Segment] = field(default_factory=list)
    notes: Notes = field(default_factory=Notes)

"""Records that a simulation returns: state, inputs, lines, events, warnings, limits, lever moves,
wave systems.

Units are SI, angles in radians; the world's z points up.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, TypedDict

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


@dataclass(frozen=True)
class State:
    """State of a simulation at one instant.

    Attributes
    ----------
    time_s
        Time, s.
    q
        Positions: of a floating body x, y, z (m, world) and the quaternion w, x, y, z; then
        joint positions (rad or m). Held coordinates are included.
    v
        Velocities: of a floating body the world velocity of its centre of mass (m/s) and the
        angular velocity in body axes (rad/s); then joint rates (rad/s or m/s).
    s
        Further states: those of forces, drives and the energy ledger.
    """

    time_s: float
    q: NDArray[np.float64]
    v: NDArray[np.float64]
    s: NDArray[np.float64]


@dataclass(frozen=True)
class Input:
    """An input of a run; it keeps its value until it is set again.

    Attributes
    ----------
    name, unit
        Name and unit.
    lower, upper, value
        Bounds and present value, in the unit.
    signal
        Signal that sets the input, which `Simulation.set_input` then refuses; None for a free input.
    """

    name: str
    unit: str
    lower: float
    upper: float
    value: float
    signal: str | None = None


@dataclass(frozen=True)
class LimitBounds:
    """Bounds that a limit sets to its column, in the column's SI unit; None where there is no bound.

    `percentile` is the percentage of the rows that must be within them; 100 for all.
    """

    name: str
    column: str
    at_least: float | None
    at_most: float | None
    percentile: float = 100.0


@dataclass(frozen=True)
class DrawnLine:
    """A line that a picture draws: the rope of a load, a mooring line, a tube.

    Attributes
    ----------
    name
        Name of the element of the line.
    style
        ``rope``, ``barrel``, ``rod`` or ``pin``.
    radius_m
        Radius, m; 0 if the line is too thin to be drawn to scale.
    points_m
        World coordinates, m, shape (points, 3); one point for a pin.
    """

    name: str
    style: str
    radius_m: float
    points_m: NDArray[np.float64]


@dataclass(frozen=True)
class Event:
    """An event of an element, located inside a step.

    Attributes
    ----------
    time_s
        Time of the event, located to 1e-12 s.
    element
        The element that watched for it.
    code
        Kind of event, in words joined by ``_``, such as ``goes_slack``.
    what
        Name of the event.
    """

    time_s: float
    element: str
    code: str
    what: str


REPEATING = frozenset({"goes_slack", "comes_taut", "touches", "leaves", "slides", "holds"})
"""Codes of repeating events of ropes and contacts; every other event is the start, the end or a failure of
something."""

PARTS = "parts"
"""Code of the event of a rope at its breaking load, and of its warning."""

STEP_BEGINS = "step_begins"
"""Code of the event at the start of a step of the operation."""

OFF_BALANCE = "energy_off_balance"
"""Code of the warning about the energy balance."""


@dataclass(frozen=True)
class Warning:
    """A warning of a run, for example: a rod that represents a rope is in compression, or a hull heels too
    far.

    Attributes
    ----------
    time_s
        Time of the warning, s.
    code
        Cause of the warning, in words joined by ``_``, such as ``large_heel``.
    name
        A joint, a closed loop, a body, a force or a drive.
    value, bound, unit
        The value that exceeds its bound, the bound, and the unit of both; None and an empty unit if the
        warning has no number.
    text
        The text of the warning.
    """

    time_s: float
    code: str
    name: str
    value: float | None
    bound: float | None
    unit: str
    text: str


@dataclass(frozen=True)
class Limit:
    """Result of a limit of the scenario in the rows of a run.

    Attributes
    ----------
    name
        Name of the limit in the scenario.
    column
        The column of the results.
    unit
        Unit of all numbers here.
    at_least, at_most
        The smallest and the largest allowed value; None if that side has no bound.
    percentile
        Percentage of the rows that must be within the bounds; 100 for all.
    held
        Whether the limit held; None if no row counted.
    worst, worst_time_s
        Value nearest to a bound, or farthest beyond it, and its time, s; with a percentile below 100 of the
        rows without the allowed share of the worst.
    """

    name: str
    column: str
    unit: str
    at_least: float | None
    at_most: float | None
    percentile: float
    held: bool | None
    worst: float | None
    worst_time_s: float | None


@dataclass(frozen=True)
class LeverMove:
    """An input set by hand.

    Attributes
    ----------
    time_s
        Time at the end of the preceding step, s.
    input
        Name of the input.
    value
        The value, in the unit of the input.
    """

    time_s: float
    input: str
    value: float


class WaveSystem(TypedDict):
    """Energy of a wave system, with equal shares in its directions: see `Simulation.sea_spectra`."""

    name: str
    directions_rad: list[float]
    band_rad_s: tuple[float, float] | None
    nodes_rad_s: list[float]
    density_m2_s: list[float]
    variance_m2: float
    lines: list[tuple[float, float, float]]

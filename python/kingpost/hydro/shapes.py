"""Parametric hulls: a box, Wigley's hull, a sphere, a hemisphere.

Each shape is a few patches on the part x >= 0, y >= 0 (or only y >= 0) of the hull; reflections complete it.
A patch is a grid of points with normals on either side.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from ..errors import HydrodynamicsError
from .surface import LARGEST_M, SMALLEST_M

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Grid = NDArray[np.float64]


@dataclass(frozen=True)
class Shape(ABC):
    """A parametric hull; its keel is `draught_m` under the water plane z = 0."""

    reflections: ClassVar[tuple[int, ...]] = (0, 1)
    """Axes along which the part of the hull is mirrored: 0 is x, 1 is y."""
    stretched: ClassVar[tuple[int, ...]] = (2,)
    """Axes along which the mesh is stretched to restore the volume lost to flat panels."""

    if TYPE_CHECKING:
        # A field of some shapes, a property of others.
        @property
        def draught_m(self) -> float: ...

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            if not math.isfinite(value) or value <= 0:
                raise HydrodynamicsError(f"hull.{field.name}", f"{value:g}", "a number greater than 0")
            if field.name.endswith("_m") and not SMALLEST_M <= value <= LARGEST_M:
                allowed = f"metres, from {SMALLEST_M:g} to {LARGEST_M:g}"
                raise HydrodynamicsError(f"hull.{field.name}", f"{value:g}", allowed)

    @property
    @abstractmethod
    def wetted_area_m2(self) -> float:
        """Approximate wetted area of the whole hull, to choose the panel size."""

    @abstractmethod
    def wetted(self, size_m: float) -> list[Grid]:
        """Patches under the water plane, with panels of approximately the stated size."""

    @abstractmethod
    def dry(self, size_m: float) -> list[Grid]:
        """Patches above the water plane and the deck; they meet the wetted patches of the same size."""


def divisions(length: float, size: float, least: int = 2) -> int:
    """Number of panels of approximately a given size along a length."""
    return max(least, math.ceil(length / size - 1e-9))


def toward_edge(extent: float, count: int) -> Grid:
    """Stations from 0 to an edge, closer together at the edge, because the flow turns round it."""
    even = np.linspace(0, 1, count + 1)
    return extent * (even + np.sin(np.pi / 2 * even)) / 2


def patch(first: Grid, second: Grid, place: Callable[[Grid, Grid], tuple[Grid | float, ...]]) -> Grid:
    """Grid of the points place(u, v), with u from the first stations and v from the second."""
    u, v = first[:, None], second[None, :]
    return np.stack(np.broadcast_arrays(*place(u, v)), axis=-1).astype(float)


def check_freeboard(draught: float, depth: float) -> None:
    """Refuse a deck that is not above the water."""
    if depth <= draught:
        found = f"a depth of {depth:g} m at a draught of {draught:g} m: a hull that cannot float"
        raise HydrodynamicsError("hull", found, "depth_m greater than draught_m")


@dataclass(frozen=True)
class Box(Shape):
    """A box barge; `depth_m` is from keel to deck."""

    length_m: float
    beam_m: float
    draught_m: float
    depth_m: float

    def __post_init__(self) -> None:
        super().__post_init__()
        check_freeboard(self.draught_m, self.depth_m)

    @property
    def wetted_area_m2(self) -> float:
        return self.length_m * self.beam_m + 2 * self.draught_m * (self.length_m + self.beam_m)

    def _stations(self, size: float) -> tuple[Grid, Grid]:
        x, y = self.length_m / 2, self.beam_m / 2
        return toward_edge(x, divisions(x, size)), toward_edge(y, divisions(y, size))

    def wetted(self, size_m: float) -> list[Grid]:
        x, y = self._stations(size_m)
        z = -toward_edge(self.draught_m, divisions(self.draught_m, size_m))
        bottom = patch(x, y, lambda x, y: (x, y, -self.draught_m))
        return [bottom, *self._walls(x, y, z)]

    def dry(self, size_m: float) -> list[Grid]:
        freeboard = self.depth_m - self.draught_m
        x, y = self._stations(size_m)
        z = np.linspace(0, freeboard, divisions(freeboard, size_m, least=1) + 1)
        deck = patch(x, y, lambda x, y: (x, y, freeboard))
        return [deck, *self._walls(x, y, z)]

    def _walls(self, x: Grid, y: Grid, z: Grid) -> list[Grid]:
        side = patch(x, z, lambda x, z: (x, self.beam_m / 2, z))
        end = patch(y, z, lambda y, z: (self.length_m / 2, y, z))
        return [side, end]


@dataclass(frozen=True)
class Wigley(Shape):
    """Wigley's parabolic hull, wall-sided above the water.

    Half breadth y = (B/2) (1 - (2x/L)^2) (1 - (z/T)^2) (J. M. J. Journee, Experiments and calculations
    on four Wigley hull forms, Delft report 909, 1992, with its coefficients a2 = c = 0); block
    coefficient 4/9.
    """

    length_m: float
    beam_m: float
    draught_m: float
    depth_m: float

    def __post_init__(self) -> None:
        super().__post_init__()
        check_freeboard(self.draught_m, self.depth_m)

    @property
    def wetted_area_m2(self) -> float:
        return self.length_m * (2 * self.draught_m + self.beam_m / 2)

    def _half_breadth(self, x: Grid, z: Grid) -> Grid:
        along = 1 - (2 * x / self.length_m) ** 2
        return self.beam_m / 2 * along * (1 - (np.minimum(z, 0) / self.draught_m) ** 2)

    def _x(self, size: float) -> Grid:
        return toward_edge(self.length_m / 2, divisions(self.length_m / 2, size))

    def wetted(self, size_m: float) -> list[Grid]:
        z = -toward_edge(self.draught_m, divisions(self.draught_m + self.beam_m / 4, size_m))
        return [patch(self._x(size_m), z, lambda x, z: (x, self._half_breadth(x, z), z))]

    def dry(self, size_m: float) -> list[Grid]:
        freeboard = self.depth_m - self.draught_m
        z = np.linspace(0, freeboard, divisions(freeboard, size_m, least=1) + 1)
        across = np.linspace(0, 1, divisions(self.beam_m / 2, size_m) + 1)
        side = patch(self._x(size_m), z, lambda x, z: (x, self._half_breadth(x, z), z))
        deck = patch(self._x(size_m), across,
                     lambda x, part: (x, part * self._half_breadth(x, 0 * x), freeboard))  # fmt: skip
        return [side, deck]


@dataclass(frozen=True)
class Sphere(Shape):
    """A sphere, half submerged."""

    radius_m: float

    stretched: ClassVar[tuple[int, ...]] = (0, 1, 2)

    @property
    def draught_m(self) -> float:
        """Draught, m: the radius."""
        return self.radius_m

    @property
    def wetted_area_m2(self) -> float:
        return _SPHERICAL_AREA * self.radius_m**2

    def wetted(self, size_m: float) -> list[Grid]:
        return [_spherical(self.radius_m, size_m)]

    def dry(self, size_m: float) -> list[Grid]:
        return [_spherical(self.radius_m, size_m) * np.array([1, 1, -1])]


@dataclass(frozen=True)
class Hemisphere(Shape):
    """A half sphere under the water and a round wall above it; `depth_m` is from its foot to its deck."""

    radius_m: float
    depth_m: float

    stretched: ClassVar[tuple[int, ...]] = (0, 1, 2)

    def __post_init__(self) -> None:
        super().__post_init__()
        check_freeboard(self.radius_m, self.depth_m)

    @property
    def draught_m(self) -> float:
        """Draught, m: the radius."""
        return self.radius_m

    @property
    def wetted_area_m2(self) -> float:
        return _SPHERICAL_AREA * self.radius_m**2

    def wetted(self, size_m: float) -> list[Grid]:
        return [_spherical(self.radius_m, size_m)]

    def dry(self, size_m: float) -> list[Grid]:
        a, freeboard = self.radius_m, self.depth_m - self.radius_m
        count = divisions(np.pi / 2 * a, size_m)
        angles = np.linspace(0, np.pi / 2, count + 1)
        heights = np.linspace(0, freeboard, divisions(freeboard, size_m, least=1) + 1)
        rings = np.linspace(0, a, count + 1)
        wall = patch(angles, heights, lambda angle, z: (a * np.cos(angle), a * np.sin(angle), z))
        deck = patch(angles, rings, lambda angle, r: (r * np.cos(angle), r * np.sin(angle), freeboard))
        return [wall, deck]


_SPHERICAL_AREA = math.pi**2
"""Number of panels of a half sphere of radius 1, if all were as large as on the water line."""


def _spherical(radius: float, size: float) -> Grid:
    angles = np.linspace(0, np.pi / 2, divisions(np.pi / 2 * radius, size) + 1)
    return radius * patch(angles, angles, lambda polar, angle: (
        np.sin(polar) * np.cos(angle), np.sin(polar) * np.sin(angle), -np.cos(polar)))  # fmt: skip

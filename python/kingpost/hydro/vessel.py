"""An offshore vessel by its main dimensions and block coefficient."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from ..errors import HydrodynamicsError
from .shapes import Shape, check_freeboard, divisions, patch

if TYPE_CHECKING:
    from .shapes import Grid

_FINE = 801


@dataclass(frozen=True)
class OffshoreVessel(Shape):
    """A vessel with a plumb bow, round bilges, and a wide stern that rises to a transom.

    The lines are plausible, but not those of a built ship. Sections are quarters of superellipses,
    (y/b)^n + (-z/d)^n = 1 with half breadth b(x), local draught d(x) and fullness n(x). Forward the
    half breadth goes to zero as 1 - u^f over the entrance of 0.5 L, u from 0 to 1; aft the bottom
    rises as 1 - (1 - 0.3) u^f over the run of 0.45 L. The exponent f is solved for the given block
    coefficient. Above the water the sides are vertical.
    """

    length_m: float
    beam_m: float
    draught_m: float
    depth_m: float
    block_coefficient: float

    reflections: ClassVar[tuple[int, ...]] = (1,)
    entrance: ClassVar[float] = 0.5
    run: ClassVar[float] = 0.45
    transom: ClassVar[float] = 0.30
    """Draught of the transom as a fraction of the draught."""
    fullest: ClassVar[float] = 7.0
    """Exponent of the sections amidships: a midship coefficient of 0.97."""
    finest: ClassVar[float] = 1.6
    """Exponent of the sections at the stem."""
    powers: ClassVar[tuple[float, float]] = (1.2, 8.0)

    def __post_init__(self) -> None:
        super().__post_init__()
        check_freeboard(self.draught_m, self.depth_m)
        least, most = (self._fullness(power) for power in self.powers)
        if not least <= self.block_coefficient <= most:
            raise HydrodynamicsError(
                "hull.block_coefficient", f"{self.block_coefficient:g}",
                f"a number from {least:.3f} to {most:.3f}, which this family of hulls can have",
            )  # fmt: skip

    @cached_property
    def power(self) -> float:
        """The exponent f for a block coefficient, by bisection."""
        low, high = self.powers
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if self._fullness(middle) < self.block_coefficient else (low, middle)
        return (low + high) / 2

    def _fullness(self, power: float) -> float:
        """Block coefficient for an exponent, by the trapezoidal rule over sections."""
        along = np.linspace(-0.5, 0.5, _FINE)
        breadth, draught, exponent = self._lines(along, power)
        return float(np.trapezoid(breadth * draught * _section_coefficient(exponent), along))

    def _lines(self, along: Grid, power: float) -> tuple[Grid, Grid, Grid]:
        """Half breadth over B/2, local draught over T and exponent at stations x/L."""
        bow = np.clip((along - 0.5 + self.entrance) / self.entrance, 0, 1)
        stern = np.clip((self.run - 0.5 - along) / self.run, 0, 1)
        breadth = 1 - bow**power
        draught = 1 - (1 - self.transom) * stern**power
        exponent = self.fullest + (self.finest - self.fullest) * bow**2
        return breadth, draught, exponent

    @property
    def wetted_area_m2(self) -> float:
        return self.length_m * (0.8 * self.beam_m + 1.7 * self.draught_m)

    def _stations(self, size: float) -> tuple[Grid, Grid]:
        """Stations x/L, and fractions along the girth."""
        count = divisions(self.length_m, size)
        girth = divisions(self.beam_m / 2 + self.draught_m, size, least=4)
        return np.linspace(-0.5, 0.5, count + 1), np.linspace(0, 1, girth + 1)

    def _across(self, size: float) -> Grid:
        # The deck and the transom need few triangles; the shell needs those of the closed hull.
        return np.linspace(0, 1, divisions(self.beam_m / 4, size, least=1) + 1)

    def _heights(self, size: float) -> Grid:
        freeboard = self.depth_m - self.draught_m
        return np.linspace(0, freeboard, divisions(freeboard, size, least=1) + 1)

    def wetted(self, size_m: float) -> list[Grid]:
        stations, girth = self._stations(size_m)
        half_breadth, draught, exponent = self._lines(stations, self.power)
        rows = [
            _section(self.beam_m / 2 * b, self.draught_m * d, n, girth)
            for b, d, n in zip(half_breadth, draught, exponent, strict=True)
        ]
        along = zip(self.length_m * stations, rows, strict=True)
        shell = np.stack([np.insert(row, 0, x, axis=1) for x, row in along])
        # Copies of the last section that shrink to a point on the water line.
        transom = np.stack([shell[0] * [1, part, part] for part in self._across(size_m)])
        return [shell, transom]

    def dry(self, size_m: float) -> list[Grid]:
        stations, _ = self._stations(size_m)
        half = self.beam_m / 2 * self._lines(stations, self.power)[0]
        index = np.arange(len(stations))
        x, y = self.length_m * stations, half
        heights, across = self._heights(size_m), self._across(size_m)
        side = patch(index, heights, lambda k, z: (x[k], y[k], z))
        deck = patch(index, across, lambda k, part: (x[k], part * y[k], heights[-1]))
        transom = patch(across, heights, lambda part, z: (-self.length_m / 2, part * half[0], z))
        return [side, deck, transom]


def _section(half_breadth: float, draught: float, exponent: float, girth: Grid) -> Grid:
    """Points (y, z) of a section from its keel to the water line, evenly along its girth."""
    angle = np.linspace(0, np.pi / 2, _FINE)
    y = half_breadth * np.sin(angle) ** (2 / exponent)
    z = -draught * np.cos(angle) ** (2 / exponent)
    z[-1] = 0.0
    length = np.concatenate([[0], np.hypot(np.diff(y), np.diff(z)).cumsum()])
    return np.stack([np.interp(girth * length[-1], length, along) for along in (y, z)], axis=1)


def _section_coefficient(exponent: Grid) -> Grid:
    """Area of a superellipse's quarter over its bounding rectangle: G(1 + 1/n)^2 / G(1 + 2/n)."""
    from math import gamma

    return np.vectorize(lambda n: gamma(1 + 1 / n) ** 2 / gamma(1 + 2 / n))(exponent)

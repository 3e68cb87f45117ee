"""A long hull of a ship's midship section, to compare with a two-dimensional flume test."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..hydro.database import Water
from ..hydro.meshes import parametric
from ..hydro.shapes import Shape, divisions, patch
from ..hydro.solve import solve

Array = np.ndarray


@dataclass(frozen=True)
class RoundBilge(Shape):
    """A box whose bilges are quarter circles, its ends flat; all lengths in m."""

    length_m: float
    beam_m: float
    draught_m: float
    bilge_m: float
    slender: float = 1.0
    """Length over width of the panels of the sides: the flow hardly changes along the hull."""

    @property
    def wetted_area_m2(self) -> float:
        return self.length_m * (self.beam_m + 2 * self.draught_m) + 2 * self.beam_m * self.draught_m

    def _curves(self, size: float) -> list[Array]:
        """Bottom, bilge and side of a half section, (points, y and z), from the keel up."""
        flat, up = self.beam_m / 2 - self.bilge_m, self.draught_m - self.bilge_m
        across = np.linspace(0, flat, divisions(flat, size) + 1)
        angle = np.linspace(0, np.pi / 2, divisions(np.pi / 2 * self.bilge_m, size) + 1)
        rise = np.linspace(-up, 0, divisions(up, size) + 1)
        return [
            np.column_stack([across, np.full(len(across), -self.draught_m)]),
            np.column_stack([flat + self.bilge_m * np.sin(angle), -up - self.bilge_m * np.cos(angle)]),
            np.column_stack([np.full(len(rise), self.beam_m / 2), rise]),
        ]

    def _share(self, size: float) -> Array:
        """Stations across an end, equal to those of the flat bottom, so that their points meet."""
        bottom = self._curves(size)[0]
        return bottom[:, 0] / bottom[-1, 0]

    def _along(self, size: float) -> Array:
        return np.linspace(0, self.length_m / 2, divisions(self.length_m / 2, self.slender * size) + 1)

    def wetted(self, size_m: float) -> list[Array]:
        x = self._along(size_m)
        bottom, bilge, side = self._curves(size_m)
        patches = []
        for curve in (bottom, bilge, side):
            along = np.arange(len(curve))
            patches.append(patch(x, along, lambda x, at, c=curve: (x, c[at, 0], c[at, 1])))
        share = self._share(size_m)
        edge = np.concatenate([bilge, side[1:]])
        along = np.arange(len(edge))
        end = patch(share, along, lambda s, at: (self.length_m / 2, s * edge[at, 0], edge[at, 1]))
        return [*patches, end]

    def dry(self, size_m: float) -> list[Array]:
        x = self._along(size_m)
        y, height = self.beam_m / 2, self.draught_m / 2
        z = np.linspace(0, height, 3)
        share = self._share(size_m)
        return [
            patch(x, z, lambda x, z: (x, y, z)),
            patch(share, z, lambda s, z: (self.length_m / 2, s * y, z)),
            patch(x, share, lambda x, s: (x, s * y, height)),
        ]

    @property
    def area_m2(self) -> float:
        """Wetted area of the section."""
        return self.beam_m * self.draught_m - (2 - np.pi / 2) * self.bilge_m**2


@dataclass(frozen=True)
class OfAMetre:
    """Coefficients of a metre of a section about the water plane, and beam waves' forces to port.

    Attributes
    ----------
    added_mass, damping
        (frequency, 6, 6).
    excitation
        (frequency, 6), complex, per metre of wave amplitude.
    """

    added_mass: Array
    damping: Array
    excitation: Array


def of_a_metre(shape: RoundBilge, lengths_m: tuple[float, float], water: Water, omega: Array, panel_m: float):
    """Coefficients of a metre of a section: the difference of two hulls that differ only in length.

    This cancels the effect of their ends.
    """
    short, long = (_solved(replace(shape, length_m=length), water, omega, panel_m) for length in lengths_m)
    way = lengths_m[1] - lengths_m[0]
    return OfAMetre(*((b - a) / way for a, b in zip(short, long, strict=True)))


def _solved(shape: RoundBilge, water: Water, omega: Array, panel_m: float) -> tuple[Array, Array, Array]:
    panels = round(shape.wetted_area_m2 / panel_m**2)
    found = solve(parametric(shape, "section", panels), water, omega, 4, with_lid=False)
    to_port = 1
    return found.added_mass, found.radiation_damping, (found.froude_krylov + found.diffraction)[:, to_port]

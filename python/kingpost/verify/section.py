"""A long hull of a ship's midship section: what a two-dimensional flume test stands beside."""

from __future__ import annotations

from dataclasses import dataclass

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
        """Stations across an end, those of the flat bottom, so that their points meet."""
        bottom = self._curves(size)[0]
        return bottom[:, 0] / bottom[-1, 0]

    def wetted(self, size_m: float) -> list[Array]:
        x = np.linspace(0, self.length_m / 2, divisions(self.length_m / 2, size_m) + 1)
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
        x = np.linspace(0, self.length_m / 2, divisions(self.length_m / 2, size_m) + 1)
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


def of_unit_length(
    beam_m: float, draught_m: float, bilge_m: float, water: Water, frequencies: Array, panel_m: float
) -> tuple[Array, Array]:
    """Added mass and damping (frequency, 6, 6) of a metre of the section, about the water plane.

    The difference of two hulls that differ in their length alone: what their ends do falls out.
    """
    short, long = 12 * beam_m, 20 * beam_m
    found = []
    for length in (short, long):
        shape = RoundBilge(length, beam_m, draught_m, bilge_m)
        panels = round(shape.wetted_area_m2 / panel_m**2)
        found.append(solve(parametric(shape, "section", panels), water, frequencies, 4, with_lid=False))
    per_metre = [
        (b - a) / (long - short)
        for a, b in (
            (found[0].added_mass, found[1].added_mass),
            (found[0].radiation_damping, found[1].radiation_damping),
        )
    ]
    return per_metre[0], per_metre[1]

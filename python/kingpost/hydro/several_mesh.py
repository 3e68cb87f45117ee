"""Several hulls as one mesh: each placed in the frame of the first, with their common planes of symmetry."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .panels import Panels, completed, lid
from .symmetry import SIGNS

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .meshes import HullMeshes
    from .several import Place

ALIGNED = 1e-9
"""Largest difference, in radians and in sizes of the cluster, of hulls that count as in line: rounding."""


@dataclass(frozen=True)
class Member:
    """One of the hulls to be solved together."""

    name: str
    place: Place
    hull: HullMeshes


@dataclass(frozen=True)
class Cluster:
    """The wetted panels of all hulls, in the axes of the first hull.

    Attributes
    ----------
    panels, owners
        The panels, or the part of them to mirror, and the hull of each.
    cover
        Panels of the lids of that part, or `None`.
    reflections
        Axes along which the part is mirrored to give all hulls.
    origins_m, headings_rad
        (hull, 2) and (hull).
    signs
        (reflection, hull, 6): signs of each hull's motions, in its own axes, under each reflection.
    """

    panels: Panels
    owners: NDArray[np.int64]
    cover: Panels | None
    reflections: tuple[int, ...]
    origins_m: NDArray[np.float64]
    headings_rad: NDArray[np.float64]
    signs: NDArray[np.int64]

    @classmethod
    def of(cls, members: Sequence[Member], with_lids: Sequence[bool]) -> Cluster:
        """Place all hulls; each with a lid or without."""
        origins, headings = relative_places([one.place for one in members])
        planes = _planes(members, origins, headings)
        parts, covers, owners = [], [], []
        for k, (one, with_lid) in enumerate(zip(members, with_lids, strict=True)):
            mirrored = [axes[k] for axes in planes.values()]
            rest = [axis for axis in one.hull.reflections if axis not in mirrored]
            part = completed(one.hull.panels, rest)
            parts.append(turned(part, origins[k], headings[k]))
            owners.append(np.full(len(part.faces), k))
            if with_lid:
                cover = completed(lid(one.hull.panels, one.hull.panel_size_m), rest)
                covers.append(turned(cover, origins[k], headings[k]))
        signs = [[SIGNS[axis] for axis in axes] for axes in planes.values()]
        return cls(
            _joined(parts), np.concatenate(owners), _joined(covers) if covers else None, tuple(planes),
            origins, headings, np.array(signs, dtype=np.int64).reshape(len(planes), len(members), 6),
        )  # fmt: skip

    @property
    def lid_panels(self) -> int:
        """Panels of all lids."""
        return 0 if self.cover is None else len(self.cover.faces) * 2 ** len(self.reflections)

    @property
    def couplings(self) -> NDArray[np.bool_]:
        """The entries of a matrix of all motions that can differ from zero."""
        flat = self.signs.reshape(len(self.reflections), 6 * len(self.headings_rad))
        allowed = np.ones((flat.shape[1], flat.shape[1]), dtype=bool)
        for signs in flat:
            allowed &= np.outer(signs, signs) > 0
        return allowed

    def motions(self, centres: NDArray[np.float64]) -> NDArray[np.float64]:
        """Displacements of all hulls' panels by each motion of each hull, shape (6 hulls, panels, 3).

        Parameters
        ----------
        centres
            Centres of the panels, mirror images included.
        """
        count = len(self.headings_rad)
        owners = np.tile(self.owners, 2 ** len(self.reflections))
        found = np.zeros((count, 6, len(centres), 3))
        for k in range(count):
            own = owners == k
            arm = centres[own] - [*self.origins_m[k], 0.0]
            for axis, direction in enumerate(rotation(self.headings_rad[k]).T):
                found[k, axis, own] = direction
                found[k, 3 + axis, own] = np.cross(direction, arm)
        return found.reshape(6 * count, len(centres), 3)


def relative_places(places: Sequence[Place]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Origins (hull, 2) and headings of all hulls in the axes of the first."""
    first = places[0]
    origins = np.array([[one.x_m - first.x_m, one.y_m - first.y_m] for one in places])
    headings = np.array([one.heading_rad - first.heading_rad for one in places])
    return origins @ rotation(first.heading_rad)[:2, :2], headings


def rotation(heading_rad: float) -> NDArray[np.float64]:
    """From a hull's axes to the common ones."""
    c, s = np.cos(heading_rad), np.sin(heading_rad)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])


def turned(panels: Panels, origin_m: NDArray[np.float64], heading_rad: float) -> Panels:
    """Panels of a hull at its place."""
    moved = panels.vertices @ rotation(heading_rad).T + np.array([*origin_m, 0.0])
    return Panels(moved, panels.faces)


def _planes(
    members: Sequence[Member], origins: NDArray[np.float64], headings: NDArray[np.float64]
) -> dict[int, list[int]]:
    """Axes along which all hulls together are their own mirror image, each with the axis of every hull that
    lies along it: every hull is symmetric about the plane."""
    size = max(float(np.abs(origins).max()), *(one.hull.particulars.length_m for one in members))
    found = {}
    for axis in (0, 1):
        axes = []
        for one, origin, heading in zip(members, origins, headings, strict=True):
            along = rotation(heading)[axis, :2]
            own = int(np.abs(along).argmax())
            straight = abs(along[1 - own]) < ALIGNED and abs(origin[axis]) < ALIGNED * size
            if straight and own in one.hull.reflections:
                axes.append(own)
        if len(axes) == len(members):
            found[axis] = axes
    return found


def _joined(parts: Sequence[Panels]) -> Panels:
    starts = np.cumsum([0, *(len(part.vertices) for part in parts[:-1])])
    faces = [part.faces + start for part, start in zip(parts, starts, strict=True)]
    return Panels(np.concatenate([part.vertices for part in parts]), np.concatenate(faces))

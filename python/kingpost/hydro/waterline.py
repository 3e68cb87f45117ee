"""A hull's water line: its pieces, points on them, and the flare of the hull there."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .surface import SAME_POINT

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .panels import Panels

    Array = NDArray[np.float64]

MOST_POINTS = 24
"""Largest number of Gauss points on a line; longer lines are divided."""
KNUCKLE = 0.5
"""Difference of the flares of two panels, one below the other, from which there is an edge between them."""


@dataclass(frozen=True)
class Points:
    """Points of a surface or a line, with outward normals and areas or lengths."""

    at_m: Array
    normals: Array
    weights: Array

    def joined(self, other: Points) -> Points:
        """Both as one."""
        return Points(*(
            np.concatenate([getattr(self, name), getattr(other, name)])
            for name in ("at_m", "normals", "weights")
        ))  # fmt: skip


@dataclass(frozen=True)
class Waterline:
    """Straight pieces of a hull's water line.

    Attributes
    ----------
    starts_m, ends_m
        Their ends, shape (pieces, 3), with the hull on the right.
    flare
        Outward growth of the hull with height, -n_z / |n_h|.
    """

    starts_m: Array
    ends_m: Array
    flare: Array

    def points(self, each: int = 1) -> tuple[Points, Array]:
        """Gauss points on each piece, with horizontal normals away from the hull, and the flare there."""
        along = self.ends_m - self.starts_m
        length = np.linalg.norm(along, axis=1)
        normals = np.stack([-along[:, 1], along[:, 0], 0 * length], axis=1) / length[:, None]
        part, weight = gauss(each, 1.0)
        at = self.starts_m[:, None] + part[:, None] * along[:, None]
        found = Points(
            at.reshape(-1, 3), np.repeat(normals, each, axis=0), np.outer(length, weight).reshape(-1)
        )
        return found, np.repeat(self.flare, each)


def waterline(panels: Panels) -> Waterline:
    """The open edges of a wetted hull on the water plane.

    The flare of flat panels holds at their centres. It is extrapolated to the water plane from the panel at
    the edge and the one below it: on a sphere of 900 panels the flare at the edge, which should be 0, would
    make nine tenths of the error of the pitch moment. Triangles, and panels above a knuckle, keep their own.
    """
    vertices, faces = panels.vertices, panels.faces
    on_plane = np.abs(vertices[:, 2]) < SAME_POINT * np.ptp(vertices, axis=0).max()
    following = np.roll(faces, -1, axis=1)
    owner, side = np.nonzero(on_plane[faces] & on_plane[following] & (faces != following))
    starts, ends = faces[owner, side], following[owner, side]
    diagonals = vertices[faces[:, 2:]] - vertices[faces[:, :2]]
    normals = np.cross(diagonals[:, 0], diagonals[:, 1])
    with np.errstate(divide="ignore", invalid="ignore"):
        flares = -normals[:, 2] / np.hypot(normals[:, 0], normals[:, 1])
    heights = vertices[faces][:, :, 2].mean(axis=1)
    owners = _owners(faces)
    found = flares[owner]
    for number, panel in enumerate(owner):
        # The side opposite to the water line.
        start, end = faces[panel, (side[number] + 2) % 4], faces[panel, (side[number] + 3) % 4]
        lower = owners.get((end, start)) if faces[panel, 2] != faces[panel, 3] else None
        if lower is not None and abs(flares[lower] - flares[panel]) < KNUCKLE:
            slope = (flares[panel] - flares[lower]) / (heights[panel] - heights[lower])
            found[number] -= slope * heights[panel]
    return Waterline(vertices[starts], vertices[ends], found)


def _owners(faces: NDArray[np.int64]) -> dict[tuple[int, int], int]:
    """The panel of each directed edge."""
    edges = np.stack([faces, np.roll(faces, -1, axis=1)], axis=2)
    return {tuple(edge): number for number, four in enumerate(edges.tolist()) for edge in four}


def gauss(length_m: float, spacing_m: float, least: int = 1) -> tuple[Array, Array]:
    """Gauss-Legendre points and weights on (0, 1), for a line of some length."""
    count = max(least, int(np.ceil(length_m / spacing_m)))
    pieces = -(-count // MOST_POINTS)
    at, weight = np.polynomial.legendre.leggauss(-(-count // pieces))
    at, weight = (at + 1) / 2 / pieces, weight / 2 / pieces
    starts = np.arange(pieces)[:, None] / pieces
    return (starts + at).reshape(-1), np.tile(weight, pieces)

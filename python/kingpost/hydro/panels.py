"""Panels of four corners for the panel method, and a lid of panels inside the water line."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from .surface import SAME_POINT, Surface, cut_polygon, open_edges

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Grid = NDArray[np.float64]


@dataclass(frozen=True)
class Panels:
    """Panels by their corners, counter-clockwise seen from the water; a triangle repeats its last corner."""

    vertices: NDArray[np.float64]
    faces: NDArray[np.int64]

    @property
    def surface(self) -> Surface:
        """The panels cut into triangles."""
        a, b, c, d = self.faces.T
        halves = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
        return Surface(self.vertices, halves).welded()

    @property
    def corner_lists(self) -> list[list[int]]:
        """Corners of each panel, three or four."""
        return [face[:3] if face[2] == face[3] else face for face in self.faces.tolist()]


def of_triangles(surface: Surface) -> Panels:
    """Triangles as panels."""
    return Panels(surface.vertices, surface.triangles[:, [0, 1, 2, 2]])


def of_patches(patches: Sequence[Grid], inside: Grid) -> Panels:
    """Panels from grids of points, with normals that point away from a point inside the hull."""
    return _welded(corners_of(patches, inside))


def corners_of(patches: Sequence[Grid], inside: Grid) -> Grid:
    """Corners of the panels of grids, shape (panels, 4, 3), points not merged."""
    return np.concatenate([_quads(grid, inside) for grid in patches])


def under_water(quads: Grid) -> Panels:
    """Make panels from their corners: cut those that cross the water plane z = 0, leave out those above
    it."""
    size = np.ptp(quads.reshape(-1, 3), axis=0).max()
    quads = quads.copy()
    quads[..., 2][np.abs(quads[..., 2]) < SAME_POINT * size] = 0.0
    z = quads[..., 2]
    wet, across = (z < 0).any(axis=1), (z > 0).any(axis=1)
    pieces = [piece for quad in quads[wet & across] for piece in _pieces(quad)]
    return _welded(np.concatenate([quads[wet & ~across], np.array(pieces).reshape(-1, 4, 3)]))


def _pieces(quad: Grid) -> list[Grid]:
    """The submerged part of a panel, as panels of three or four corners."""
    above = quad[:, 2]
    if (above[[0, 2]].max() < 0 < above[[1, 3]].min()) or (above[[1, 3]].max() < 0 < above[[0, 2]].min()):
        # A panel so twisted that two opposite corners are wet becomes two triangles.
        return [piece for half in ([0, 1, 2, 2], [0, 2, 3, 3]) for piece in _pieces(quad[half])]
    polygon = cut_polygon(quad, above, 0.0, 2)
    polygon = [point for point, next_ in zip(polygon, np.roll(polygon, -1, axis=0), strict=True)
               if (point != next_).any()]  # fmt: skip
    last = len(polygon) - 1
    return [np.array([polygon[i] for i in (0, k, k + 1, min(k + 2, last))]) for k in range(1, last, 2)]


def mirrored(quads: Grid, axis: int) -> Grid:
    """The mirror images of panels along an axis, again counter-clockwise seen from the water.

    Their diagonals between the first and the third corner are mirror images too.
    """
    image = quads[:, [0, 3, 2, 1]]
    image[..., axis] *= -1
    return image


def completed(panels: Panels, axes: Sequence[int]) -> Panels:
    """Panels and their mirror images along some axes."""
    quads = panels.vertices[panels.faces]
    for axis in axes:
        quads = np.concatenate([quads, mirrored(quads, axis)])
    return _welded(quads) if axes else panels


def _quads(grid: Grid, inside: Grid) -> Grid:
    """Corners of a grid's panels, shape (panels, 4, 3)."""
    corners = [grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]]
    quads = np.stack([corner.reshape(-1, 3) for corner in corners], axis=1)
    normals = np.cross(quads[:, 2] - quads[:, 0], quads[:, 3] - quads[:, 1])
    outward = np.einsum("pi,pi->", normals, quads.mean(axis=1) - inside) > 0
    return quads if outward else quads[:, ::-1]


def _welded(quads: Grid) -> Panels:
    """Merge equal points and leave out panels without area."""
    points = quads.reshape(-1, 3)
    size = np.ptp(points, axis=0).max()
    keys = np.round(points / (SAME_POINT * size)).astype(np.int64)
    _, first, index = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    faces = index.reshape(-1, 4)
    repeated = faces == np.roll(faces, 1, axis=1)
    triangle = repeated.sum(axis=1) == 1
    # The three corners after the repeated one; the last is repeated.
    after = repeated[triangle].argmax(axis=1)[:, None] + [1, 2, 3, 3]
    faces[triangle] = np.take_along_axis(faces[triangle], after % 4, axis=1)
    a, b, c, d = faces.T
    kept = (a != b) & (b != c) & (a != c) & (a != d) & (b != d)
    return Panels(points[first], faces[kept])


def lid(wetted: Panels, size: float) -> Panels:
    """Panels on the water plane inside the water line, against irregular frequencies.

    Crossings of the water line bound transverse strips between stations along x; the strips are divided
    evenly.
    The part of a hull that will be mirrored along y ends at y = 0.
    """
    surface = wetted.surface
    edges = surface.vertices[open_edges(surface)]
    tolerance = SAME_POINT * np.ptp(surface.vertices, axis=0).max()
    water_line = edges[np.abs(edges[:, :, 2]).max(axis=1) < tolerance][:, :, :2]
    quads: list[Grid] = []
    stations = _stations(water_line[:, :, 0], size)
    for left, right in pairwise(stations):
        quads += _strips(water_line, left, right, size)
    return _welded(np.array(quads))


def _stations(x: Grid, size: float) -> Grid:
    """The corners of the water line, thinned or divided to a spacing of approximately one panel size."""
    kept = [x.min()]
    for value in np.unique(x)[1:]:
        if value - kept[-1] > 0.7 * size:
            kept.append(value)
    kept[-1] = x.max() if len(kept) > 1 else kept[-1]
    if len(kept) == 1:
        kept.append(x.max())
    parts = [
        np.linspace(start, end, max(1, round((end - start) / size)) + 1)[:-1] for start, end in pairwise(kept)
    ]
    return np.append(np.concatenate(parts), kept[-1])


def _strips(water_line: Grid, left: float, right: float, size: float) -> list[Grid]:
    inset = 1e-6 * (right - left)
    at_left, at_right = _crossings(water_line, left + inset), _crossings(water_line, right - inset)
    if len(at_left) != len(at_right):
        at_left = at_right = _crossings(water_line, (left + right) / 2)
    quads = []
    for k in range(0, len(at_left) - 1, 2):
        width = max(at_left[k + 1] - at_left[k], at_right[k + 1] - at_right[k])
        part = np.linspace(0, 1, max(1, round(width / size)) + 1)
        y_left = at_left[k] + part * (at_left[k + 1] - at_left[k])
        y_right = at_right[k] + part * (at_right[k + 1] - at_right[k])
        for i in range(len(part) - 1):
            corners = [(left, y_left[i]), (left, y_left[i + 1]), (right, y_right[i + 1]), (right, y_right[i])]
            quads.append(np.array([(*corner, 0.0) for corner in corners]))
    return quads


def _crossings(water_line: Grid, x: float) -> Grid:
    """Where the line of constant x crosses the water line, from starboard to port, or from y = 0."""
    start, end = water_line[:, 0], water_line[:, 1]
    crossing = (start[:, 0] - x) * (end[:, 0] - x) < 0
    start, end = start[crossing], end[crossing]
    part = (x - start[:, 0]) / (end[:, 0] - start[:, 0])
    y = np.sort(start[:, 1] + part * (end[:, 1] - start[:, 1]))
    return np.insert(y, 0, 0.0) if len(y) % 2 else y

"""Surfaces of flat triangles: closed or not, cut by planes, and exact integrals over them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..errors import HydrodynamicsError
from .database import Waterplane

if TYPE_CHECKING:
    from numpy.typing import NDArray

SMALLEST_M, LARGEST_M = 0.01, 2000.0
"""Allowed extents of a hull: others are probably not in metres."""
SAME_POINT = 1e-7
"""Points nearer than this fraction of the surface's size are merged."""


@dataclass(frozen=True)
class Surface:
    """Triangles by the indices of their corners, counter-clockwise seen from outside.

    >>> box = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
    >>> tetrahedron = Surface(box, np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]))
    >>> round(tetrahedron.volume, 6)
    0.166667
    """

    vertices: NDArray[np.float64]
    triangles: NDArray[np.int64]

    @property
    def corners(self) -> NDArray[np.float64]:
        """Corners of each triangle, shape (triangles, 3, 3)."""
        return self.vertices[self.triangles]

    @property
    def area_vectors(self) -> NDArray[np.float64]:
        """Outward normals with the triangles' areas as lengths, m2."""
        a, b, c = np.moveaxis(self.corners, 1, 0)
        return np.cross(b - a, c - a) / 2

    @property
    def midpoints(self) -> NDArray[np.float64]:
        """Midpoints of each triangle's edges: a mean over them is exact for quadratic functions."""
        return (self.corners + np.roll(self.corners, -1, axis=1)) / 2

    @property
    def area(self) -> float:
        """Area, m2."""
        return float(np.linalg.norm(self.area_vectors, axis=1).sum())

    @property
    def volume(self) -> float:
        """Volume inside a closed surface, m3: (1/3) Int x . n dS; negative when normals point inwards."""
        return float(np.einsum("ti,ti->", self.corners.mean(axis=1), self.area_vectors) / 3)

    def mirrored(self, axis: int) -> Surface:
        """Mirror image along an axis, again with outward normals."""
        turned = self.vertices.copy()
        turned[:, axis] *= -1
        return Surface(turned, self.triangles[:, ::-1])

    def joined(self, other: Surface) -> Surface:
        """Both surfaces as one, with equal points merged."""
        vertices = np.concatenate([self.vertices, other.vertices])
        shifted = other.triangles + len(self.vertices)
        return Surface(vertices, np.concatenate([self.triangles, shifted])).welded()

    def welded(self) -> Surface:
        """Merge equal points; leave out triangles without area and unused points."""
        corners, triangles = np.unique(self.triangles, return_inverse=True)
        vertices = self.vertices[corners]
        size = max(np.ptp(vertices, axis=0).max() if len(vertices) else 0.0, SMALLEST_M)
        grid = np.round(vertices / (SAME_POINT * size)).astype(np.int64)
        _, first, index = np.unique(grid, axis=0, return_index=True, return_inverse=True)
        triangles = index.reshape(-1)[triangles.reshape(-1, 3)]
        a, b, c = triangles.T
        triangles = triangles[(a != b) & (b != c) & (c != a)]
        used, numbered = np.unique(triangles, return_inverse=True)
        return Surface(vertices[first[used]], numbered.reshape(-1, 3))

    def below(self, height: float = 0.0, axis: int = 2) -> Surface:
        """The part where the coordinate along an axis is at most the given one; open at the cut."""
        return _below(self, height, axis)

    def refined(self, longest: float) -> Surface:
        """Halve triangles across their longest edges until no edge is longer than stated."""
        corners = self.corners
        while True:
            edges = np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2)
            long = edges.max(axis=1) > longest
            if not long.any():
                break
            # Rotated so that the longest edge runs from the first corner to the second.
            first = edges[long].argmax(axis=1)[:, None]
            a, b, c = (corners[long][np.arange(long.sum()), (first[:, 0] + k) % 3] for k in range(3))
            middle = (a + b) / 2
            halves = [np.stack([a, middle, c], axis=1), np.stack([middle, b, c], axis=1)]
            corners = np.concatenate([corners[~long], *halves])
        return Surface(corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3)).welded()


def _below(surface: Surface, height: float, axis: int) -> Surface:
    """Each triangle is kept, dropped, or cut into one or two (Sutherland-Hodgman)."""
    above = surface.vertices[:, axis] - height
    above[np.abs(above) < SAME_POINT * np.ptp(surface.vertices, axis=0).max()] = 0.0
    signs = above[surface.triangles]
    kept = surface.triangles[(signs <= 0).all(axis=1) & (signs < 0).any(axis=1)]
    pieces: list[list[NDArray[np.float64]]] = []
    for triangle in surface.triangles[(signs > 0).any(axis=1) & (signs < 0).any(axis=1)]:
        polygon = cut_polygon(surface.vertices[triangle], above[triangle], height, axis)
        pieces += [[polygon[0], polygon[k], polygon[k + 1]] for k in range(1, len(polygon) - 1)]
    cut_points = np.array(pieces, float).reshape(-1, 3)
    numbers = len(surface.vertices) + np.arange(len(cut_points)).reshape(-1, 3)
    vertices = np.concatenate([surface.vertices, cut_points])
    return Surface(vertices, np.concatenate([kept, numbers])).welded()


def cut_polygon(
    corners: NDArray[np.float64], above: NDArray[np.float64], height: float, axis: int
) -> list[NDArray[np.float64]]:
    """Corners of the part of a polygon that is below a height along an axis.

    Parameters
    ----------
    above
        Height of each corner above it, m.

    >>> square = np.array([[0, 0, -1], [2, 0, -1], [2, 0, 1], [0, 0, 1.0]])
    >>> [point.tolist() for point in cut_polygon(square, square[:, 2], 0.0, 2)]
    [[0.0, 0.0, -1.0], [2.0, 0.0, -1.0], [2.0, 0.0, 0.0], [0.0, 0.0, 0.0]]
    """
    polygon = []
    ends, over_ends = np.roll(corners, -1, axis=0), np.roll(above, -1)
    for p, q, over_p, over_q in zip(corners, ends, above, over_ends, strict=True):
        if over_p <= 0:
            polygon.append(p)
        if over_p * over_q < 0:
            cut = p + over_p / (over_p - over_q) * (q - p)
            cut[axis] = height
            polygon.append(cut)
    return polygon


@dataclass(frozen=True)
class Particulars:
    """Hydrostatic integrals of a hull: volume, centre of buoyancy and waterplane."""

    volume_m3: float
    centre_of_buoyancy_m: NDArray[np.float64]
    waterplane: Waterplane
    length_m: float
    beam_m: float
    draught_m: float

    @property
    def block_coefficient(self) -> float:
        """Volume as a fraction of length x beam x draught."""
        return self.volume_m3 / (self.length_m * self.beam_m * self.draught_m)


def particulars(wetted: Surface) -> Particulars:
    """Integrals over the wetted surface, exact for its triangles.

    The waterplane z = 0 closes the surface and adds nothing to integrals with z as a factor, so with
    the outward normal n: V = Int z n_z dS, V x_B = Int x z n_z dS, V z_B = (1/2) Int z^2 n_z dS; and since
    Int n_z f(x, y) dS vanishes over the closed surface, the waterplane's moments are
    -Int f n_z dS over the wetted one (Gauss's theorem).
    """
    normal_z = wetted.area_vectors[:, 2]
    x, y, z = np.moveaxis(wetted.midpoints, 2, 0)

    def integral(values: NDArray[np.float64]) -> float:
        return float(values.mean(axis=1) @ normal_z)

    volume = integral(z)
    moments = np.array([integral(x * z), integral(y * z), integral(z * z) / 2])
    ones = np.ones_like(x)
    plane = Waterplane(
        -integral(ones),
        -np.array([integral(x), integral(y)]),
        -np.array([integral(x * x), integral(x * y), integral(y * y)]),
    )
    length, beam, _ = np.ptp(wetted.vertices, axis=0)
    centre = moments / volume if volume else np.zeros(3)
    return Particulars(volume, centre, plane, float(length), float(beam), float(-wetted.vertices[:, 2].min()))


def open_edges(surface: Surface) -> NDArray[np.int64]:
    """Edges that belong to only one triangle, as pairs of vertices."""
    directed = _directed_edges(surface)
    _, first, counts = np.unique(np.sort(directed, axis=1), axis=0, return_index=True, return_counts=True)
    return directed[first[counts == 1]]


def check_closed(surface: Surface, file: str | None) -> None:
    """Refuse a surface that is not closed, or whose normals do not all point outwards."""
    edges = open_edges(surface)
    if len(edges):
        middles = surface.vertices[edges].mean(axis=1)
        # An edge on the water plane may be meant to be open.
        point = middles[np.abs(middles[:, 2]).argmax()]
        raise HydrodynamicsError(
            "hull",
            f"a mesh with holes: {len(edges)} open edges, one at ({_point(point)}) m",
            "a closed mesh, or one that is open at the water plane z = 0 only: close the holes, merge equal "
            "points, give panels side by side the same corners" + _half(surface, edges),
            file,
        )
    check_outward(surface, surface.volume, file)


def check_outward(surface: Surface, volume: float, file: str | None) -> None:
    """Refuse a surface whose normals disagree or point inwards."""
    directed, counts = np.unique(_directed_edges(surface), axis=0, return_counts=True)
    if (counts > 1).any():
        point = surface.vertices[directed[counts > 1][0]].mean(axis=0)
        raise HydrodynamicsError(
            "hull",
            f"normals that disagree across {int((counts > 1).sum())} edges, one at ({_point(point)}) m",
            "normals that all point outwards and edges that two faces share: recalculate them in the program "
            "that made the mesh",
            file,
        )
    if volume <= 0:
        raise HydrodynamicsError(
            "hull",
            f"normals that point inwards: a volume of {volume:g} m3",
            "outward normals: turn them with --flip-normals",
            file,
        )


def _half(surface: Surface, edges: NDArray[np.int64]) -> str:
    size = np.ptp(surface.vertices, axis=0).max()
    for axis, name in ((0, "x"), (1, "y")):
        if np.abs(surface.vertices[edges, axis]).max() < 1e-6 * size:
            return f"; all holes lie on {name} = 0: mirror this half of a hull"
    return ""


def _directed_edges(surface: Surface) -> NDArray[np.int64]:
    return np.concatenate([surface.triangles[:, [i, j]] for i, j in ((0, 1), (1, 2), (2, 0))])


def _point(point: NDArray[np.float64]) -> str:
    return ", ".join(f"{value:.3g}" for value in point)

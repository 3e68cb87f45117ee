"""Whether hulls at their places overlap, by their meshes."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np

from ..errors import HydrodynamicsError
from .meshes import whole
from .several_mesh import relative_places, rotation

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .several_mesh import Member

    Triangles = NDArray[np.float64]

TOUCHING = 1e-6
"""Hulls nearer than this fraction of their size touch: rounding of their points."""
AT_ONCE = 2_000_000
"""Pairs of points and triangles that are compared at a time, to limit the memory."""


def check_apart(members: Sequence[Member]) -> None:
    """Refuse hulls that overlap or touch, by their names.

    Raises
    ------
    HydrodynamicsError
        For the first such pair.
    """
    hulls = placed_triangles(members)
    for i, j in combinations(range(len(members)), 2):
        if not overlap(hulls[i], hulls[j]):
            continue
        one, other = members[i], members[j]
        raise HydrodynamicsError(
            "--at",
            f"{one.name} at {one.place.described}, which overlaps or touches {other.name} at "
            f"{other.place.described}",
            "places with water between the hulls",
        )


def gaps_m(members: Sequence[Member]) -> dict[tuple[int, int], float]:
    """Least distance of each pair of wetted hulls, m."""
    hulls = placed_triangles(members)
    return {(i, j): distance(hulls[i], hulls[j]) for i, j in combinations(range(len(members)), 2)}


def placed_triangles(members: Sequence[Member]) -> list[Triangles]:
    """Triangles (triangle, corner, 3) of each wetted hull, in the axes of the first."""
    origins, headings = relative_places([one.place for one in members])
    found = []
    for one, origin, heading in zip(members, origins, headings, strict=True):
        corners = whole(one.hull.panels.surface, one.hull.reflections).corners
        found.append(corners @ rotation(heading).T + [*origin, 0.0])
    return found


def overlap(one: Triangles, other: Triangles) -> bool:
    """Whether two wetted hulls overlap or touch.

    They do if their surfaces cross, or if a part of one is inside the other.
    """
    size = max(float(np.ptp(some.reshape(-1, 3), axis=0).max()) for some in (one, other))
    if distance(one, other, at_most=2 * TOUCHING * size) <= TOUCHING * size:
        return True
    return any(
        _crosses(a, b) or (winding(a.mean(axis=1), b) > 0.5).any() for a, b in ((one, other), (other, one))
    )


def distance(one: Triangles, other: Triangles, at_most: float = np.inf) -> float:
    """Least distance of the corners of either from the surface of the other, m; those of boxes farther apart
    than `at_most` are not looked at."""
    least = np.inf
    for points, surface in ((one, other), (other, one)):
        corners = np.unique(points.reshape(-1, 3), axis=0)
        corners = corners[_near(corners[:, None], surface, at_most)]
        kept = surface[_near(surface, points, at_most)]
        if not len(corners) or not len(kept):
            continue
        for some in np.array_split(corners, -(-len(corners) * len(kept) // AT_ONCE)):
            least = min(least, float(_distances(some, kept).min()))
    return least


def _near(some: Triangles, others: Triangles, margin: float) -> NDArray[np.bool_]:
    """Find those whose box meets the box of all others, widened by a margin."""
    low, high = others.min(axis=(0, 1)) - margin, others.max(axis=(0, 1)) + margin
    return ((some.max(axis=1) >= low) & (some.min(axis=1) <= high)).all(axis=1)


def _distances(points: NDArray[np.float64], triangles: Triangles) -> NDArray[np.float64]:
    """Distance of each point from each triangle, (point, triangle)."""
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    normals = normals / np.linalg.norm(normals, axis=1, keepdims=True)
    above = points @ normals.T - np.einsum("ti,ti->t", triangles[:, 0], normals)
    inside = np.ones(above.shape, dtype=bool)
    least = np.full(above.shape, np.inf)
    for k in range(3):
        start, along = triangles[:, k], triangles[:, (k + 1) % 3] - triangles[:, k]
        arm = points[:, None] - start
        inside &= np.einsum("pti,ti->pt", arm, np.cross(normals, along)) >= 0
        part = np.clip(np.einsum("pti,ti->pt", arm, along) / (along**2).sum(axis=1), 0.0, 1.0)
        least = np.minimum(least, np.linalg.norm(arm - part[..., None] * along, axis=2))
    return np.where(inside, np.abs(above), least)


def _crosses(edges_of: Triangles, surface: Triangles) -> bool:
    """Whether an edge of one surface passes through a triangle of the other (Moeller and Trumbore)."""
    edges_of, surface = edges_of[_near(edges_of, surface, 0.0)], surface[_near(surface, edges_of, 0.0)]
    if not len(edges_of) or not len(surface):
        return False
    start = edges_of.reshape(-1, 3)
    along = np.roll(edges_of, -1, axis=1).reshape(-1, 3) - start
    a, u, v = surface[:, 0], surface[:, 1] - surface[:, 0], surface[:, 2] - surface[:, 0]
    for some in np.array_split(np.arange(len(start)), -(-len(start) * len(surface) // AT_ONCE)):
        side = np.cross(along[some, None], v[None])
        volume = np.einsum("pti,ti->pt", side, u)
        with np.errstate(divide="ignore", invalid="ignore"):
            arm = start[some, None] - a[None]
            first = np.einsum("pti,pti->pt", arm, side) / volume
            turned = np.cross(arm, u[None])
            second = np.einsum("pti,pi->pt", turned, along[some]) / volume
            at = np.einsum("pti,ti->pt", turned, v) / volume
            met = (first >= 0) & (second >= 0) & (first + second <= 1) & (at >= 0) & (at <= 1)
        if met.any():
            return True
    return False


def winding(points: NDArray[np.float64], wetted: Triangles) -> NDArray[np.float64]:
    """How often a wetted hull with its mirror image above the water encloses points: 1 inside, 0 outside.

    The sum of solid angles over 4 pi (A. Van Oosterom and J. Strackee, IEEE Transactions on Biomedical
    Engineering 30(2), 1983).
    """
    image = wetted[:, ::-1] * [1.0, 1.0, -1.0]
    closed = np.concatenate([wetted, image])
    found = np.zeros(len(points))
    near = _near(points[:, None], wetted, 0.0)
    for some in np.array_split(np.flatnonzero(near), -(-int(near.sum()) * len(closed) // AT_ONCE) or 1):
        a, b, c = (closed[None, :, k] - points[some, None] for k in range(3))
        la, lb, lc = (np.linalg.norm(one, axis=2) for one in (a, b, c))
        volume = np.einsum("pti,pti->pt", a, np.cross(b, c))
        ab, bc, ca = ((x * y).sum(axis=2) for x, y in ((a, b), (b, c), (c, a)))
        below = la * lb * lc + ab * lc + bc * la + ca * lb
        found[some] = (2 * np.arctan2(volume, below)).sum(axis=1) / (4 * np.pi)
    return found

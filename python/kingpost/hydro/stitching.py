"""Joins mesh panels that do not meet edge to edge.

Patches that were meshed separately have neighbouring points that are nearly equal, or two panels along an
edge where the neighbour has one. Nearly equal points are merged. A triangle (a, b, c) whose open
edge a, b has points p, q of other open edges on it becomes (a, p, c), (p, q, c), (q, b, c), so that both
sides have the same edges; where the edge bends, this also closes the sliver between the panels. Nothing is
moved by more than `NEAR` of an edge, and an edge that stays open is a hole. The edge of the water plane is
not a seam, even if its two sides are close.
"""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING

import numpy as np

from .surface import SAME_POINT, Surface, open_edges

if TYPE_CHECKING:
    from numpy.typing import NDArray

NEAR = 0.05
"""Tolerance, as a fraction of the length of an edge, within which a point counts as on the edge or its
ends."""
ROUNDS = 12
MOST_EDGES = 6000


def stitched(surface: Surface) -> Surface:
    """The surface with coinciding open edges joined; the same surface if none can be joined."""
    before = len(open_edges(surface))
    if not 0 < len(_seams(surface)) <= MOST_EDGES:
        return surface
    found = _merged(surface)
    for _ in range(ROUNDS):
        split = _split(found)
        if split is None:
            break
        found = split
    return found if len(open_edges(found)) < before else surface


def _seams(surface: Surface) -> NDArray[np.int64]:
    """Open edges except those at the top: a hull without a deck is open at its water plane. If panels lie in
    that plane, a deck, its edges may be seams too."""
    edges = open_edges(surface)
    height = surface.vertices[:, 2]
    top = height > height.max() - SAME_POINT * np.ptp(surface.vertices, axis=0).max()
    if top[surface.triangles].all(axis=1).any():
        return edges
    return edges[~top[edges].all(axis=1)]


def _merged(surface: Surface) -> Surface:
    """Merge points of seams that are nearer than `NEAR` of the shortest open edge."""
    ends = surface.vertices[open_edges(surface)]
    tolerance = NEAR * float(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).min())
    numbers = np.unique(_seams(surface))
    points = surface.vertices[numbers]
    order = np.argsort(points[:, 0], kind="stable")
    stands_for = np.arange(len(surface.vertices))
    for rank, i in enumerate(order):
        if stands_for[numbers[i]] != numbers[i]:
            continue
        for j in order[rank + 1 :]:
            if points[j, 0] - points[i, 0] > tolerance:
                break
            if np.linalg.norm(points[j] - points[i]) <= tolerance:
                stands_for[numbers[j]] = numbers[i]
    return Surface(surface.vertices, stands_for[surface.triangles]).welded()


def _split(surface: Surface) -> Surface | None:
    """Divide one seam of each triangle at the points of other seams on it; `None` if there are no such
    points."""
    edges = _seams(surface)
    owners = _owners(surface)
    numbers = np.unique(edges)
    points = surface.vertices[numbers]
    gone: set[int] = set()
    added: list[list[int]] = []
    for a, b in edges:
        triangle, apex = owners[int(a), int(b)]
        on = [] if triangle in gone else _between(surface.vertices[a], surface.vertices[b], points)
        on = [int(numbers[k]) for k in on if numbers[k] not in (a, b, apex)]
        if on:
            gone.add(triangle)
            chain = [int(a), *on, int(b)]
            added += [[p, q, apex] for p, q in itertools.pairwise(chain)]
    if not added:
        return None
    kept = np.delete(surface.triangles, sorted(gone), axis=0)
    return Surface(surface.vertices, np.concatenate([kept, np.array(added)])).welded()


def _owners(surface: Surface) -> dict[tuple[int, int], tuple[int, int]]:
    """The triangle of each directed edge and its third corner."""
    found = {}
    for number, (a, b, c) in enumerate(surface.triangles.tolist()):
        found[a, b], found[b, c], found[c, a] = (number, c), (number, a), (number, b)
    return found


def _between(a: NDArray[np.float64], b: NDArray[np.float64], points: NDArray[np.float64]) -> NDArray[np.intp]:
    """The points between a and b that are nearer to the line than `NEAR` of its length, in order."""
    line = b - a
    length = float(np.linalg.norm(line))
    along = (points - a) @ line / length**2
    off = np.linalg.norm(points - a - along[:, None] * line, axis=1)
    on = np.flatnonzero((along > NEAR) & (along < 1.0 - NEAR) & (off <= NEAR * length))
    return on[np.argsort(along[on], kind="stable")]

"""Sections of a hull's mesh: the mesh cut by planes across the ship."""

from __future__ import annotations

import numpy as np

from ..errors import RollDampingError
from ..hydro.surface import Surface
from .sections import Array, Sections, estimated_bilge_radius

STATIONS = 40
# The eddies of a section with less than this share of the largest area are negligible.
SMALLEST = 1e-3


def cut(hull: Surface, stations: int = STATIONS) -> Sections:
    """Sections of a hull at stations in the middle of equal lengths.

    A plane x = constant cuts each triangle in a segment from (y1, z1) to (y2, z2), and all segments have the
    same sense about the section. By Green's theorem the area under the water plane is the sum of (y1 z2 - y2
    z1) / 2, exact for the mesh, because the water plane z = 0 contributes nothing.

    Parameters
    ----------
    hull
        Triangles, x forward, z up, z = 0 on the water plane; parts above it are left out.
    stations
        Number of sections.

    Raises
    ------
    RollDampingError
        If no part of the hull is in the water, or the number of stations is too small.

    >>> from kingpost.hydro.shapes import Box
    >>> from kingpost.hydro.meshes import parametric
    >>> mesh = parametric(Box(20, 10, 2, 5), "box", 100).hull
    >>> found = cut(Surface(mesh.vertices_m, mesh.triangles), 4)
    >>> found.x_m.tolist(), found.area_m2.round(9).tolist()
    ([-7.5, -2.5, 2.5, 7.5], [20.0, 20.0, 20.0, 20.0])
    """
    if stations < 3:
        raise RollDampingError("stations", f"{stations}", "3 or more")
    wetted = hull.below()
    if not len(wetted.triangles):
        raise RollDampingError("hull", "no part under the water plane", "a hull that floats")
    ends = wetted.vertices[:, 0].min(), wetted.vertices[:, 0].max()
    step = (ends[1] - ends[0]) / stations
    x = ends[0] + step * (np.arange(stations) + 0.5)
    measures = np.array([_measures(wetted, place) for place in x])
    beam, draught, area = measures.T
    kept = area > SMALLEST * area.max()
    beam, draught = beam[kept], draught[kept]
    area = np.minimum(area[kept], beam * draught)
    radius = estimated_bilge_radius(beam, draught, area)
    length = np.full(kept.sum(), step)
    return Sections(x[kept], length, beam, draught, area, radius, (float(ends[0]), float(ends[1])))


def _measures(wetted: Surface, x: float) -> tuple[float, float, float]:
    """Beam, draught and area of the section that a plane across the ship cuts from the mesh."""
    pieces = _pieces(wetted, x)
    if not len(pieces):
        return 0.0, 0.0, 0.0
    (y1, z1), (y2, z2) = pieces[:, 0].T, pieces[:, 1].T
    points = pieces.reshape(-1, 2)
    area = abs(float(np.sum(y1 * z2 - y2 * z1)) / 2)
    return float(np.ptp(points[:, 0])), float(-points[:, 1].min()), area


def _pieces(wetted: Surface, x: float) -> Array:
    """Ends (y, z) of the segments in the plane, shape (segments, 2, 2), with the same sense about the
    section."""
    corners = wetted.corners
    over = corners[:, :, 0] - x
    # A corner in the plane counts as ahead of it: every triangle then has two crossings or none.
    ahead = over >= 0
    crossed = ahead.any(axis=1) & ~ahead.all(axis=1)
    corners, over, ahead = corners[crossed], over[crossed], ahead[crossed]
    following = np.roll(np.arange(3), -1)
    leaves = ahead & ~ahead[:, following]
    enters = ~ahead & ahead[:, following]
    rows = np.arange(len(corners))
    ends = []
    for edge in (leaves.argmax(axis=1), enters.argmax(axis=1)):
        p, q = corners[rows, edge], corners[rows, following[edge]]
        over_p, over_q = over[rows, edge], over[rows, following[edge]]
        part = over_p / (over_p - over_q)
        ends.append((p + part[:, None] * (q - p))[:, 1:])
    return np.stack(ends, axis=1)

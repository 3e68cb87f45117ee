"""A vertical prism around one hull and the water plane inside it, with points to integrate over.

The prism's contour is parallel to the convex outline of the hull in plan. Corners that turn by much more
than a right angle are cut.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..errors import HydrodynamicsError
from .surface import SAME_POINT
from .waterline import Points, Waterline, gauss, waterline

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from .panels import Panels

    Array = NDArray[np.float64]

STRAIGHT = 1e-4
"""Distance of a corner from a straight side, as a fraction of the hull's length, below which it is on it."""
SHARPEST = 1.7
"""Largest turn of a contour at one corner, rad: a rectangle keeps its corners."""
TOWARD_HULL = 4
"""Points across the water plane between the water line and the prism."""
ROUGH = 0.35
"""Distance from the hull, in pieces of the water line, within which velocities show the edges of the panels:
their ripples fade as exp(-2 pi r / piece), by this distance to a tenth."""


@dataclass(frozen=True)
class ControlSurface:
    """Prism around a hull.

    Attributes
    ----------
    shell
        Points of its sides and of its bottom below the hull.
    rim
        Points of its contour on the water plane.
    water_plane
        Points between the water line and the contour; `None` if the water line is not a single line that is
        wholly seen from its centre, as with a moonpool.
    """

    shell: Points
    rim: Points
    water_plane: Points | None


def outline(panels: Panels) -> Array:
    """Corners of the convex outline of a hull in plan, counter-clockwise."""
    from scipy.spatial import ConvexHull

    plan = panels.vertices[np.unique(panels.faces)][:, :2]
    size = np.ptp(plan, axis=0).max()
    corners = plan[ConvexHull(plan).vertices]
    kept = [corners[0]]
    for corner, after in zip(corners[1:], np.roll(corners, -2, axis=0)[:-1], strict=True):
        chord = after - kept[-1]
        aside = chord[0] * (corner - kept[-1])[1] - chord[1] * (corner - kept[-1])[0]
        # Corners on a straight side are left out.
        if abs(aside) > STRAIGHT * size * np.linalg.norm(chord):
            kept.append(corner)
    return np.array(kept)


def _parts(polygon: Array, points: Array) -> bool:
    """Whether a side of a convex polygon, counter-clockwise, has all points beyond it."""
    along = np.roll(polygon, -1, axis=0) - polygon
    from_start = points[:, None] - polygon
    side = along[:, 0] * from_start[..., 1] - along[:, 1] * from_start[..., 0]
    return bool((side < 0).all(axis=0).any())


def distance(first: Array, second: Array) -> float:
    """Least distance between two convex outlines; 0 if they overlap."""
    if not any(_parts(one, other) for one, other in ((first, second), (second, first))):
        return 0.0
    gaps = []
    for points, polygon in ((first, second), (second, first)):
        start, along = polygon, np.roll(polygon, -1, axis=0) - polygon
        from_start = points[:, None] - start
        part = np.clip((from_start * along).sum(-1) / (along**2).sum(-1), 0, 1)
        gaps.append(np.linalg.norm(from_start - part[..., None] * along, axis=-1).min())
    return float(min(gaps))


def parallel(corners: Array, away_m: float) -> Array:
    """Corners of the contour at a distance from a convex outline."""
    along = np.roll(corners, -1, axis=0) - corners
    angles = np.arctan2(along[:, 1], along[:, 0])
    found = []
    for corner, before, after in zip(corners, np.roll(angles, 1), angles, strict=True):
        turn = max((after - before + np.pi) % (2 * np.pi) - np.pi, 0.0)
        pieces = int(np.ceil(turn / SHARPEST))
        for piece in range(pieces):
            # Outward is to the right of the direction along the outline.
            middle = before + (piece + 0.5) * turn / pieces - np.pi / 2
            reach = away_m / np.cos(turn / pieces / 2)
            found.append(corner + reach * np.array([np.cos(middle), np.sin(middle)]))
    return np.array(found)


def control_surface(
    panels: Panels, away_m: float, spacing_m: float, depth_m: float | None = None
) -> ControlSurface:
    """Prism at a distance from a hull, on all sides and below it.

    Parameters
    ----------
    spacing_m
        Largest distance between points, approximately.
    depth_m
        Depth of the water, if it is finite. The prism goes down to the middle between keel and sea bed at
        most; for a hull that stands on the sea bed it has no bottom.
    """
    if not away_m > 0:
        raise HydrodynamicsError(
            "hulls", "hulls whose outlines meet in plan", "hulls with a gap between them"
        )
    contour = parallel(outline(panels), away_m)
    keel = float(panels.vertices[:, 2].min())
    clearance = np.inf if depth_m is None else depth_m + keel
    bottom = keel - min(away_m, clearance / 2)
    shell, rim = _sides(contour, bottom, spacing_m)
    if clearance > SAME_POINT * away_m:
        shell = shell.joined(_bottom(contour, bottom, spacing_m))
    return ControlSurface(shell, rim, _water_plane(waterline(panels), contour))


def beyond(start: float) -> tuple[Array, Array]:
    """Points on (start, 1) and weights with which they integrate polynomials over (0, 1).

    >>> at, weights = beyond(0.2)
    >>> bool((at > 0.2).all()), round(float(weights @ at**3), 12)
    (True, 0.25)
    """
    at = start + (1 - start) * gauss(1.0, 1.0, TOWARD_HULL)[0]
    powers = np.arange(len(at))[:, None]
    return at, np.linalg.solve(at**powers, 1 / (powers[:, 0] + 1))


def _sides(contour: Array, bottom: float, spacing: float) -> tuple[Points, Points]:
    down, part = gauss(-bottom, spacing, 4)
    shell, rim = [], []
    for start, end in zip(contour, np.roll(contour, -1, axis=0), strict=True):
        length = float(np.linalg.norm(end - start))
        at, weight = gauss(length, spacing)
        line = np.pad(start + at[:, None] * (end - start), ((0, 0), (0, 1)))
        normal = np.array([end[1] - start[1], start[0] - end[0], 0.0]) / length
        normals = np.tile(normal, (len(at), 1))
        rim.append(Points(line, normals, weight * length))
        wall = line[:, None] + (down * bottom)[:, None] * np.array([0.0, 0.0, 1.0])
        areas = np.outer(weight * length, -bottom * part)
        shell.append(Points(wall.reshape(-1, 3), np.repeat(normals, len(down), axis=0), areas.reshape(-1)))
    return _all(shell), _all(rim)


def _bottom(contour: Array, z: float, spacing: float) -> Points:
    centre = contour.mean(axis=0)
    pieces = []
    for start, end in zip(contour, np.roll(contour, -1, axis=0), strict=True):
        out = float(np.linalg.norm((start + end) / 2 - centre))
        outward = gauss(out, spacing, 3)
        sideways = gauss(float(np.linalg.norm(end - start)), spacing)
        pieces.append(_between(np.array([centre, centre]), np.array([start, end]), outward, sideways, z))
    found = _all(pieces)
    return Points(found.at_m, np.tile([0.0, 0.0, -1.0], (len(found.weights), 1)), found.weights)


def _water_plane(line: Waterline, contour: Array) -> Points | None:
    """Sectors between the water line and the contour, seen from the water line's centre."""
    if not len(line.flare):
        return None
    starts, ends = line.starts_m[:, :2], line.ends_m[:, :2]
    lengths = np.linalg.norm(ends - starts, axis=1)
    centre = lengths @ (starts + ends) / 2 / lengths.sum()
    # Seen from above, the water line runs clockwise, with the hull on its right; from `ends` to `starts` is
    # counter-clockwise.
    seen = _turn(ends - centre, starts - centre)
    if (seen <= 0).any() or abs(seen.sum() - 2 * np.pi) > 1e-3:
        return None
    pieces = []
    corners = _angle(contour - centre)
    for begin, end, turn in zip(ends, starts, seen, strict=True):
        first = _angle(begin - centre)
        cuts = (corners - first) % (2 * np.pi)
        cuts = np.concatenate([[0.0], np.sort(cuts[(cuts > 1e-9) & (cuts < turn - 1e-9)]), [turn]])
        rays = np.stack([np.cos(first + cuts), np.sin(first + cuts)], axis=1)
        inner = centre + rays * _reach(begin - centre, end - centre, rays)[:, None]
        outer = centre + rays * _to_contour(contour - centre, rays)[:, None]
        for n in range(len(cuts) - 1):
            part = slice(n, n + 2)
            width = np.linalg.norm(outer[part] - inner[part], axis=1).mean()
            out = beyond(min(ROUGH * float(np.linalg.norm(end - begin)) / width, 0.5))
            pieces.append(_between(inner[part], outer[part], out, gauss(1.0, 1.0), 0.0))
    return _all(pieces)


def _between(
    inner: Array, outer: Array, outward: tuple[Array, Array], sideways: tuple[Array, Array], z: float
) -> Points:
    """Points of the quadrilateral between two lines, mapped bilinearly from the unit square."""
    u, v = (grid.reshape(-1, 1) for grid in np.meshgrid(outward[0], sideways[0], indexing="ij"))
    weight = np.outer(outward[1], sideways[1]).reshape(-1)
    low, high = inner[0] + v * (inner[1] - inner[0]), outer[0] + v * (outer[1] - outer[0])
    by_u = high - low
    by_v = (1 - u) * (inner[1] - inner[0]) + u * (outer[1] - outer[0])
    area = np.abs(by_u[:, 0] * by_v[:, 1] - by_u[:, 1] * by_v[:, 0]) * weight
    at = np.concatenate([low + u * by_u, np.full((len(u), 1), z)], axis=1)
    return Points(at, np.tile([0.0, 0.0, 1.0], (len(u), 1)), area)


def _reach(start: Array, end: Array, rays: Array) -> Array:
    """Lengths along rays from the origin to the line through two points."""
    normal = np.array([end[1] - start[1], start[0] - end[0]])
    with np.errstate(divide="ignore"):
        return (normal @ start) / (rays @ normal)


def _to_contour(contour: Array, rays: Array) -> Array:
    """Lengths along rays from the origin to a convex contour around it."""
    every = [_reach(a, b, rays) for a, b in zip(contour, np.roll(contour, -1, axis=0), strict=True)]
    return np.where(np.array(every) > 0, every, np.inf).min(axis=0)


def _angle(plan: Array) -> Array:
    return np.arctan2(plan[..., 1], plan[..., 0])


def _turn(first: Array, second: Array) -> Array:
    """Angles between pairs of vectors, positive counter-clockwise."""
    cross = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
    return np.arctan2(cross, (first * second).sum(axis=1))


def _all(pieces: Sequence[Points]) -> Points:
    return Points(*(
        np.concatenate([getattr(piece, name) for piece in pieces]) for name in ("at_m", "normals", "weights")
    ))  # fmt: skip

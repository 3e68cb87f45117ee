"""Faces of solids: triangles with their colours, in the axes of a body."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

SIDES = 24
"""Sides of a round solid."""


@dataclass(frozen=True)
class Faces:
    """Triangles, counter-clockwise from outside.

    Attributes
    ----------
    corners
        Shape (triangles, 3, 3), m.
    colours
        Red, green and blue, 0 to 1; shape (triangles, 3).
    """

    corners: NDArray[np.float64]
    colours: NDArray[np.float64]

    @property
    def box(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Smallest and largest coordinates of the corners, m; zeros without triangles."""
        if not len(self.corners):
            return np.zeros(3), np.zeros(3)
        return self.corners.min(axis=(0, 1)), self.corners.max(axis=(0, 1))

    def moved(self, by_m: ArrayLike) -> Faces:
        """The faces moved by a vector, m."""
        return Faces(self.corners + np.asarray(by_m, float), self.colours)


def joined(parts: Iterable[Faces]) -> Faces:
    """All faces of several solids.

    >>> len(joined([cuboid((1, 1, 1), (0, 0, 0)), cuboid((2, 2, 2), (1, 1, 1))]).corners)
    32
    """
    every = list(parts)
    if not every:
        return Faces(np.empty((0, 3, 3)), np.empty((0, 3)))
    return Faces(
        np.concatenate([one.corners for one in every]), np.concatenate([one.colours for one in every])
    )


def painted(corners: NDArray[np.float64], colour: ArrayLike) -> Faces:
    """Faces of one colour."""
    return Faces(corners, np.tile(np.asarray(colour, float), (len(corners), 1)))


def cuboid(edges_m: Sequence[float], colour: ArrayLike) -> Faces:
    """A box about the origin."""
    x, y = edges_m[0] / 2, edges_m[1] / 2
    plan = [(-x, -y), (x, -y), (x, y), (-x, y)]
    return lofted([(-edges_m[2] / 2, plan), (edges_m[2] / 2, plan)], colour)


def round_bar(radius_m: float, length_m: float, axis: str, colour: ArrayLike) -> Faces:
    """A round bar about the origin along ``x``, ``y`` or ``z``."""
    turns = np.linspace(0.0, 2 * np.pi, SIDES, endpoint=False)
    plan = [(radius_m * np.cos(turn), radius_m * np.sin(turn)) for turn in turns]
    upright = lofted([(-length_m / 2, plan), (length_m / 2, plan)], colour)
    # Cyclic changes of the axes keep the faces counter-clockwise.
    order = {"z": (0, 1, 2), "x": (2, 0, 1), "y": (1, 2, 0)}[axis]
    return Faces(upright.corners[:, :, order], upright.colours)


def ball(radius_m: float, colour: ArrayLike) -> Faces:
    """A ball about the origin."""
    levels = np.linspace(-np.pi / 2, np.pi / 2, SIDES // 2 + 1)
    turns = np.linspace(0.0, 2 * np.pi, SIDES, endpoint=False)
    # Not quite zero at the poles, where a plan would have no direction.
    plans = [
        (radius_m * np.sin(level), [(reach * np.cos(turn), reach * np.sin(turn)) for turn in turns])
        for level in levels
        for reach in [radius_m * max(np.cos(level), 1e-6)]
    ]
    return lofted(plans, colour)


Plan = Sequence[tuple[float, float]]


def lofted(levels: Sequence[tuple[float, Plan]], colour: ArrayLike) -> Faces:
    """A solid through plans at ascending heights, closed below and above; all plans are counter-clockwise,
    star-shaped about their middle, and have the same number of points."""
    rings = [np.array([(x, y, z) for x, y in plan]) for z, plan in levels]
    faces = [_band(low, high) for low, high in pairwise(rings)]
    faces += [_lid(rings[0])[:, ::-1], _lid(rings[-1])]
    return painted(np.concatenate(faces), colour)


def _band(low: NDArray[np.float64], high: NDArray[np.float64]) -> NDArray[np.float64]:
    """Triangles between two rings of points."""
    after, above = np.roll(low, -1, axis=0), np.roll(high, -1, axis=0)
    return np.concatenate([np.stack([low, after, above], 1), np.stack([low, above, high], 1)])


def _lid(ring: NDArray[np.float64]) -> NDArray[np.float64]:
    """Triangles from the middle of a ring of points to its sides."""
    middle = np.broadcast_to(ring.mean(axis=0), ring.shape)
    return np.stack([middle, ring, np.roll(ring, -1, axis=0)], 1)


def below(faces: NDArray[np.float64], height_m: float, sign: float = 1.0) -> NDArray[np.float64]:
    """The parts of triangles below a height; above it if `sign` is -1.

    >>> one = np.array([[[0, 0, -1], [1, 0, -1], [0, 0, 1]]], float)
    >>> below(one, 0.0)[:, :, 2].max(), below(one, 5.0).shape
    (np.float64(0.0), (1, 3, 3))
    """
    depths = sign * (height_m - faces[:, :, 2])
    whole = faces[(depths >= 0).all(axis=1)]
    cut = (depths > 0).any(axis=1) & (depths < 0).any(axis=1)
    parts = [whole]
    for corners, depth in zip(faces[cut], depths[cut], strict=True):
        kept: list[NDArray[np.float64]] = []
        for k in range(3):
            here, there = depth[k], depth[(k + 1) % 3]
            if here >= 0:
                kept.append(corners[k])
            if here * there < 0:
                kept.append(corners[k] + here / (here - there) * (corners[(k + 1) % 3] - corners[k]))
        parts.append(
            np.array([[kept[0], kept[k], kept[k + 1]] for k in range(1, len(kept) - 1)]).reshape(-1, 3, 3)
        )
    return np.concatenate(parts)

"""Perspective camera that has everything in its picture."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

FIELD_RAD = np.radians(32.0)
"""Vertical field of view: that of the app."""
MARGIN = 1.12
"""Ratio of the eye's distance to the distance at which the points just fill the picture."""
EDGE = 1.02
"""Ratio of distances below which a camera steps back."""
UP = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True)
class Camera:
    """Eye, and the axes of the picture.

    Attributes
    ----------
    eye_m
        Position of the eye, world.
    back, right, top
        Unit vectors from the target to the eye, to the right and up in the picture.
    aspect
        Width over height of the picture.
    """

    eye_m: NDArray[np.float64]
    back: NDArray[np.float64]
    right: NDArray[np.float64]
    top: NDArray[np.float64]
    aspect: float

    def depths(self, points_m: NDArray[np.float64]) -> NDArray[np.float64]:
        """Distance of points along the direction of view, m; negative behind the eye."""
        return (self.eye_m - points_m) @ self.back

    def seen(self, points_m: NDArray[np.float64]) -> NDArray[np.float64]:
        """Points in the picture: x from -1, left, to 1; y from -1, bottom, to 1; 1 over the depth, 1/m."""
        from_eye = points_m - self.eye_m
        nearness = 1 / -(from_eye @ self.back)
        tangent = np.tan(FIELD_RAD / 2)
        x = from_eye @ self.right * nearness / (tangent * self.aspect)
        return np.stack([x, from_eye @ self.top * nearness / tangent, nearness], axis=-1)

    def holds(self, points_m: NDArray[np.float64]) -> bool:
        """Whether all points are in the picture, not at its very edge."""
        if (self.depths(points_m) <= 0).any():
            return False
        return bool((np.abs(self.seen(points_m)[..., :2]) < 1 / EDGE).all())


def fitted(
    points_m: NDArray[np.float64], direction: ArrayLike, aspect: float, margin: float = MARGIN
) -> Camera:
    """Camera that looks against a direction and has all points in its picture, with equal margins.

    Parameters
    ----------
    points_m
        Shape (points, 3).
    direction
        From the target to the eye; not vertical.
    aspect
        Width over height of the picture.
    margin
        Ratio of the eye's distance to the smallest possible one.

    >>> cube = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
    >>> bool(fitted(cube, (0, -1, 0.5), 1.5).holds(cube))
    True
    """
    back, right, top = _axes(direction)
    tangents = np.tan(FIELD_RAD / 2) * np.array([aspect, 1.0])
    target = (points_m.min(axis=0) + points_m.max(axis=0)) / 2
    distance = _fit(points_m - target, back, right, top, tangents)
    # The middle of what is seen depends on the distance: eight rounds leave less than a pixel.
    for _ in range(8):
        from_target = points_m - target
        depth = distance - from_target @ back
        for axis in (right, top):
            values = from_target @ axis / depth
            target = target + (values.min() + values.max()) / 2 * distance * axis
        distance = _fit(points_m - target, back, right, top, tangents)
    return Camera(target + margin * distance * back, back, right, top, aspect)


def following(
    target_m: NDArray[np.float64], direction: ArrayLike, distance_m: float, aspect: float
) -> Camera:
    """Camera that looks against a direction at a point, from a distance."""
    back, right, top = _axes(direction)
    return Camera(target_m + distance_m * back, back, right, top, aspect)


def _axes(direction: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Unit vectors to the eye, to the right and up."""
    back = np.asarray(direction, float) / np.linalg.norm(direction)
    right = np.cross(UP, back)
    right /= np.linalg.norm(right)
    return back, right, np.cross(back, right)


def _fit(
    points: NDArray[np.float64],
    back: NDArray[np.float64],
    right: NDArray[np.float64],
    top: NDArray[np.float64],
    tangents: NDArray[np.float64],
) -> float:
    """Smallest distance of the eye at which points about the target are in the picture."""
    needed = np.maximum(np.abs(points @ right) / tangents[0], np.abs(points @ top) / tangents[1])
    return float(max((points @ back + needed).max(), 1e-3))

"""Consequences of a hull's planes of symmetry for its coefficients."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

SIGNS = {0: np.array([-1, 1, 1, 1, -1, -1]), 1: np.array([1, -1, 1, -1, 1, -1])}
"""Signs of surge to yaw under a reflection along x (0) and along y (1); rotations are axial vectors."""


def reflected_direction(index: int, axis: int, count: int) -> int | None:
    """Index of the mirror image of a wave direction 2 pi index / count, if the grid has it.

    >>> reflected_direction(1, 1, 12), reflected_direction(1, 0, 12), reflected_direction(1, 0, 5)
    (11, 5, None)
    """
    if axis == 1:
        return -index % count
    return (count // 2 - index) % count if count % 2 == 0 else None


def independent_directions(count: int, reflections: Sequence[int]) -> list[int]:
    """Indices of the directions whose mirror images fill the circle.

    >>> independent_directions(12, (0, 1))
    [0, 1, 2, 3]
    """
    return sorted({min(_images(index, count, reflections)) for index in range(count)})


def _images(index: int, count: int, reflections: Sequence[int]) -> dict[int, NDArray[np.int64]]:
    """The mirror images of a direction, each with the signs of its force."""
    images = {index: np.ones(6, dtype=np.int64)}
    for axis in reflections:
        for at, signs in list(images.items()):
            image = reflected_direction(at, axis, count)
            if image is not None and image not in images:
                images[image] = signs * SIGNS[axis]
    return images


def whole_circle(
    forces: NDArray, directions: Sequence[int], count: int, reflections: Sequence[int]
) -> NDArray:
    """Forces (frequency, direction, 6) for the whole circle from those for the independent directions.

    If a direction is its own mirror image, the forces that the symmetry forbids are zero.
    """
    circle = np.empty((len(forces), count, 6), dtype=forces.dtype)
    for k, index in enumerate(directions):
        allowed = np.ones(6)
        for axis in reflections:
            if reflected_direction(index, axis, count) == index:
                allowed *= SIGNS[axis] > 0
        for image, signs in _images(index, count, reflections).items():
            circle[:, image] = forces[:, k] * allowed * signs
    return circle + 0.0


def allowed_couplings(reflections: Sequence[int]) -> NDArray[np.bool_]:
    """Find the entries of a 6 x 6 matrix of the hull that can differ from zero."""
    allowed = np.ones((6, 6), dtype=bool)
    for axis in reflections:
        allowed &= np.outer(SIGNS[axis], SIGNS[axis]) > 0
    return allowed

"""Excitation round the whole circle of wave directions, from the directions that a file has.

Mirror images: in the plane y = 0 a wave towards b becomes one towards -b, and sway, roll and yaw change their
sign; in x = 0 it becomes one towards pi - b, and surge, pitch and yaw change their sign. For a body of
revolution, a wave rotated by an angle gives forces rotated by that angle.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from ...errors import HydrodynamicsError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .foreign import Foreign, Options

SIDES = np.array([1.0, -1.0, 1.0, -1.0, 1.0, -1.0])
ENDS = np.array([-1.0, 1.0, 1.0, 1.0, -1.0, -1.0])
# Directions of a body of revolution, every 15 degrees.
OF_REVOLUTION = 24
TOLERANCE = 1e-4


class Circle:
    """The directions of a file, and the symmetry that completes the circle: the given one, otherwise that of
    the file."""

    def __init__(self, foreign: Foreign, options: Options) -> None:
        self.directions, self.options, self.file = foreign.directions_rad, options, foreign.file
        if options.hull_symmetry is None and foreign.hull_symmetry is not None:
            self.options = replace(options, hull_symmetry=foreign.hull_symmetry)

    def whole(self, forces: NDArray) -> tuple[NDArray[np.float64], NDArray]:
        """Directions of the whole circle and forces (frequency, direction, 6) on them."""
        return whole_circle(self.directions, forces, self.options, self.file)


def whole_circle(
    directions: NDArray[np.float64], excitation: NDArray[np.complex128], options: Options, file: str
) -> tuple[NDArray[np.float64], NDArray[np.complex128]]:
    """A regular grid of the whole circle from 0 and the excitation (frequency, direction, 6) on it.

    Raises
    ------
    HydrodynamicsError
        If the file's directions and their mirror images by `hull_symmetry` do not form such a grid.
    """
    found, values = _distinct(directions, excitation)
    if _regular(found) and len(found) > 2:
        return _grid(len(found)), values
    symmetry = options.asked("hull_symmetry", file)
    if symmetry == "revolution":
        return _turned(found[0], values[:, 0])
    if symmetry == "both_planes":
        found, values = _distinct(np.append(found, np.pi - found), _beside(values, values * ENDS))
    if symmetry in ("port_starboard", "both_planes"):
        found, values = _distinct(np.append(found, -found), _beside(values, values * SIDES))
    if not _regular(found) or len(found) < 3:
        degrees = ", ".join(f"{value:.4g}" for value in np.degrees(np.unique(np.round(directions, 6))))
        allowed = "directions that are evenly round the circle, with their mirror images by hull_symmetry"
        raise HydrodynamicsError(
            "wave_directions", f"{degrees} deg with hull_symmetry {symmetry}", allowed, file
        )
    return _grid(len(found)), values


def _grid(count: int) -> NDArray[np.float64]:
    return 2.0 * np.pi * np.arange(count) / count


def _beside(first: NDArray[np.complex128], second: NDArray[np.complex128]) -> NDArray[np.complex128]:
    return np.concatenate([first, second], axis=1)


def _distinct(
    directions: NDArray[np.float64], values: NDArray[np.complex128]
) -> tuple[NDArray[np.float64], NDArray[np.complex128]]:
    """Directions in increasing order from 0 to 2 pi, each once: the first of equal ones."""
    turned = np.mod(directions, 2.0 * np.pi)
    turned = np.where(turned > 2.0 * np.pi - TOLERANCE, 0.0, turned)
    _, first = np.unique(np.round(turned / TOLERANCE), return_index=True)
    first = first[np.argsort(turned[first])]
    return turned[first], values[:, first]


def _regular(directions: NDArray[np.float64]) -> bool:
    return bool(np.abs(directions - _grid(len(directions))).max() < 10 * TOLERANCE)


def _turned(
    direction: float, values: NDArray[np.complex128]
) -> tuple[NDArray[np.float64], NDArray[np.complex128]]:
    directions = _grid(OF_REVOLUTION)
    found = []
    for angle in directions - direction:
        c, s = np.cos(angle), np.sin(angle)
        turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
        found.append(values @ np.kron(np.eye(2), turn).T)
    return directions, np.stack(found, axis=1)

"""Pictures of a simulation in its present state."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ..errors import KingpostError, shortened
from .backdrop import Backdrop, Surroundings
from .camera import Camera, fitted, following
from .paint import paint
from .scene import Scene, threads

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ..simulation.simulate import Simulation

Viewpoint = str | Sequence[float]
VIEWS = {
    "free": (-0.62, -1.0, 0.62),
    "load": (-0.62, -1.0, 0.62),
    "side": (0.0, -1.0, 0.1),
    "top": (0.0, -0.002, 1.0),
}
"""Directions from the target to the eye by the name of the view: those of the app."""
FOLLOWED, OF_MODEL = 9.0, 0.25
"""Distance of the eye that follows the load: sizes of the load, at least this share of the model's size."""
SIZE_PX = (960, 540)
LARGEST_PX = 8192


class Drawing:
    """Pictures of a simulation, whose parts are built once and moved for each picture.

    The camera has every body in its picture: it steps back when one leaves it, and never comes nearer.

    Parameters
    ----------
    simulation
        The simulation, drawn in its present state by each call of `picture`.
    view
        ``free``, from the starboard quarter, ``side``, ``top``, ``load``, which follows the load, a
        direction from the scene to the eye, or the positions of the eye and its target relative to the first
        body, along the axes of the world, m.
    size_px
        Width and height, pixels.

    >>> from kingpost import Simulation
    >>> Drawing(Simulation("paper"), size_px=(64, 36)).picture().shape
    (36, 64, 3)
    """

    def __init__(
        self, simulation: Simulation, view: Viewpoint = "free", size_px: tuple[int, int] = SIZE_PX
    ) -> None:
        self.simulation = simulation
        self.size_px = checked_size(size_px)
        self._view = checked_view(view)
        self._direction = _direction(self._view)
        self._follows = view == "load"
        poses = simulation.poses()
        self._scene = Scene(simulation.scenario.model, poses)
        self._camera: Camera | None = None
        self._drawn_from: Camera | None = None
        self._backdrop: Backdrop | None = None
        corners = self._scene.corners_m(poses)
        self._floor_m = float(corners[:, 2].min())
        self._size_m = float(np.linalg.norm(np.ptp(corners, axis=0)))

    def picture(self) -> NDArray[np.uint8]:
        """Draw the present state: red, green and blue, shape (height, width, 3)."""
        poses, lines = self.simulation.poses(), self.simulation.lines()
        corners = self._scene.corners_m(poses)
        camera = self._placed(poses, corners)
        if self._backdrop is None or camera is not self._drawn_from:
            self._backdrop = Backdrop(camera, self._surroundings(corners), self.size_px)
            self._drawn_from = camera
        return paint(self._scene.faces(poses, lines), threads(lines), camera, self._backdrop)

    def _surroundings(self, corners: NDArray[np.float64]) -> Surroundings:
        lowest, highest = float(corners[:, 2].min()), float(corners[:, 2].max())
        size = max(self._size_m, float(np.linalg.norm(np.ptp(corners, axis=0))))
        return Surroundings(
            has_sea=self._scene.has_sea,
            is_submerged=self._scene.has_sea and highest < 0,
            floor_m=self._floor_m - 0.02 * self._size_m,
            size_m=size,
            # A path of some depths of the deepest body: it has to be seen.
            clear_m=max(0.35 * size, -2.5 * lowest),
        )

    def _placed(self, poses: NDArray[np.float64], corners: NDArray[np.float64]) -> Camera:
        aspect = self.size_px[0] / self.size_px[1]
        if len(self._view) == 6:
            target = poses[0, :3] + self._view[3:]
            return following(target, self._direction, float(np.linalg.norm(self._direction)), aspect)
        if self._follows:
            own = self._scene.corners_m(poses, [self._scene.watched])
            size = float(np.linalg.norm(np.ptp(own, axis=0)))
            distance = max(FOLLOWED * size, OF_MODEL * self._size_m)
            return following(own.mean(axis=0), self._direction, distance, aspect)
        if self._camera is None or not self._camera.holds(corners):
            self._camera = fitted(corners, self._direction, aspect)
        return self._camera


def checked_view(view: Viewpoint) -> tuple[float, ...]:
    """Direction of a view, or eye and target.

    Raises
    ------
    KingpostError
        If the name is unknown, or the numbers are not three or six, not finite, or of a vertical view.

    >>> checked_view("side")
    (0.0, -1.0, 0.1)
    """
    if isinstance(view, str) and view in VIEWS:
        return VIEWS[view]
    try:
        numbers = () if isinstance(view, str) else tuple(float(part) for part in view)
    except (TypeError, ValueError):
        numbers = ()
    if len(numbers) in (3, 6) and np.isfinite(numbers).all() and np.hypot(*_direction(numbers)[:2]) > 0:
        return numbers
    allowed = f"{', '.join(VIEWS)}, a direction of three numbers, or six of eye and target; none vertical"
    raise KingpostError(f"camera: found {shortened(repr(view))}, allowed: {allowed}")


def _direction(view: Sequence[float]) -> NDArray[np.float64]:
    """From the target to the eye."""
    return np.array(view[:3]) - np.array(view[3:] if len(view) == 6 else [0.0, 0.0, 0.0])


def checked_size(size_px: Sequence[int]) -> tuple[int, int]:
    """Width and height of a picture, pixels.

    Raises
    ------
    KingpostError
        If they are not two whole numbers from 1 to 8192.

    >>> checked_size((640, 360))
    (640, 360)
    """
    try:
        width, height = size_px
        fits = all(1 <= one <= LARGEST_PX and one == int(one) for one in (width, height))
    except (TypeError, ValueError):
        fits = False
    if not fits:
        found = shortened(repr(size_px))
        raise KingpostError(f"size_px: found {found}, allowed: width and height, 1 to {LARGEST_PX}")
    return int(width), int(height)

"""Frames of episodes, drawn without a browser."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..errors import KingpostError, RunError
from ..pictures import Drawing, Viewpoint
from ..pictures.drawing import checked_size, checked_view
from ..scenario import Scenario
from ..simulation.simulate import Simulation
from .episodes import Episodes
from .task import Task

RENDER_MODES = ("rgb_array",)
FRAME_PX = (640, 360)


def metadata(task: Task) -> dict[str, Any]:
    """Render modes and frames per second: a frame for each control step.

    >>> from kingpost.learn import anti_sway
    >>> metadata(anti_sway())
    {'render_modes': ['rgb_array'], 'render_fps': 20.0}
    """
    return {"render_modes": [*RENDER_MODES], "render_fps": round(1 / task.control_period_s, 9)}


def frames_of(
    episodes: Episodes, render_mode: str | None, camera: Viewpoint, size_px: tuple[int, int]
) -> list[Frames]:
    """The frames of each copy; none without a render mode.

    Raises
    ------
    KingpostError
        If the render mode, the camera or the size is unknown.
    """
    if render_mode is None:
        return []
    if render_mode not in RENDER_MODES:
        raise KingpostError(
            f"render_mode: found {render_mode!r}, allowed: {', '.join(RENDER_MODES)}, or None"
        )
    return [Frames(episodes, copy, camera, size_px) for copy in range(episodes.count)]


class Frames:
    """Frames of the episodes of one copy.

    A plain simulation repeats the inputs of the episode, which gives the same bits as the copy. It does so
    when a frame is requested: an episode without a frame costs nothing.

    Parameters
    ----------
    episodes
        The episodes.
    copy
        Number of the copy.
    camera, size_px
        As in `kingpost.picture`.

    Examples
    --------
    >>> from kingpost.learn import anti_sway
    >>> episodes = Episodes(anti_sway(), 1)
    >>> frames = Frames(episodes, 0, "free", (64, 36))
    >>> episodes.begin({0: np.random.default_rng(0)})
    >>> frames.begin()
    >>> frames.frame().shape
    (36, 64, 3)
    """

    def __init__(
        self, episodes: Episodes, copy: int, camera: Viewpoint = "free", size_px: tuple[int, int] = FRAME_PX
    ) -> None:
        self._episodes, self.copy = episodes, copy
        checked_view(camera), checked_size(size_px)
        self._how = camera, size_px
        self._drawing: Drawing | None = None
        self._pending: list[np.ndarray] | None = None

    def begin(self) -> None:
        """Begin an episode, with the overrides that the copy has drawn."""
        self._drawing, self._pending = None, []

    def act(self) -> None:
        """Note the inputs of the last control step."""
        if self._pending is not None:
            self._pending.append(self._episodes.inputs[self.copy].copy())

    def frame(self) -> np.ndarray:
        """Draw the present state: red, green and blue, shape (height, width, 3).

        After a failure of the simulation it is that of the last good step.
        """
        if self._pending is None:
            raise KingpostError("render: found no episode, allowed: after reset()")
        if self._drawing is None:
            based_on = self._episodes.task.based_on
            overrides = tuple(self._episodes.variants[self.copy])
            simulation = Simulation(Scenario(based_on.text, based_on.file, overrides))
            self._drawing = Drawing(simulation, *self._how)
        self._catch_up(self._drawing.simulation)
        return self._drawing.picture()

    def _catch_up(self, simulation: Simulation) -> None:
        pending, self._pending = self._pending or [], []
        task = self._episodes.task
        for inputs in pending:
            for name, value in zip(task.action_names, inputs.tolist(), strict=True):
                simulation.set_input(name, value)
            try:
                simulation.step(task.steps)
            except RunError:
                return

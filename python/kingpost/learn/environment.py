"""One environment in the interface of Gymnasium."""

from __future__ import annotations

from typing import Any

import gymnasium
import numpy as np

from .episodes import Episodes, check_options
from .rendering import FRAME_PX, Viewpoint, frames_of, metadata
from .task import LARGEST_OBSERVATION, Task


def spaces(task: Task) -> tuple[gymnasium.spaces.Box, gymnasium.spaces.Box]:
    """Observation and action space of one environment.

    >>> from kingpost.learn import anti_sway
    >>> spaces(anti_sway())[1]
    Box(-1.0, 1.0, (2,), float32)
    """
    largest = LARGEST_OBSERVATION
    seen = gymnasium.spaces.Box(-largest, largest, (len(task.seen),), np.float32)
    return seen, gymnasium.spaces.Box(-1.0, 1.0, (len(task.set),), np.float32)


class ShipCraneEnv(gymnasium.Env[np.ndarray, np.ndarray]):
    """A task on any scenario as an environment.

    Actions from -1 to 1 are the scenario's inputs between their bounds; observations are columns of its
    results over their scales. An episode is terminated when the simulation fails, when the task is done, or,
    if the task has `limits`, when a limit of the scenario is exceeded; ``info["ended_by"]`` gives the reason.
    It is truncated at the task's duration.

    Parameters
    ----------
    task
        The task, with its names, units and bounds (`task.action_names`, `task.observation_units`, ...).
    max_episode_steps
        Control steps in an episode; default: those of the task's duration.
    render_mode
        ``rgb_array``: `render` returns the picture of the present state; default: no pictures.
    camera, size_px
        Viewpoint and size of the pictures, as in `kingpost.picture`.

    Examples
    --------
    >>> from kingpost.learn import ShipCraneEnv, anti_sway
    >>> env = ShipCraneEnv(anti_sway())
    >>> observation, info = env.reset(seed=1)
    >>> observation, reward, terminated, truncated, info = env.step(np.array([0.5, 0], dtype=np.float32))
    >>> reward < 0
    True
    """

    def __init__(
        self,
        task: Task,
        max_episode_steps: int | None = None,
        render_mode: str | None = None,
        camera: Viewpoint = "free",
        size_px: tuple[int, int] = FRAME_PX,
    ) -> None:
        self.metadata = metadata(task)
        self.render_mode = render_mode
        self.task = task
        self.observation_space, self.action_space = spaces(task)
        self.episodes = Episodes(task, 1, 1, max_episode_steps)
        self._frames = frames_of(self.episodes, render_mode, camera, size_px)

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[np.ndarray, dict[str, Any]]:
        """Begin an episode; the same seed gives the same episode to the last bit. There are no options."""
        check_options(options)
        super().reset(seed=seed)
        self.episodes.begin({0: self.np_random})
        for frames in self._frames:
            frames.begin()
        return self.episodes.observations()[0], {}

    def step(self, action: np.ndarray) -> tuple[np.ndarray, float, bool, bool, dict[str, Any]]:
        """Take a control step.

        Raises
        ------
        KingpostError
            If an action is NaN or not within -1 to 1.
        """
        seen, rewards, terminated, truncated = self.episodes.step(np.asarray(action)[None])
        for frames in self._frames:
            frames.act()
        info = {"ended_by": self.episodes.ended_by(0)} if terminated[0] else {}
        return seen[0], float(rewards[0]), bool(terminated[0]), bool(truncated[0]), info

    def render(self) -> np.ndarray | None:  # type: ignore[override]
        """Draw the present state: red, green and blue, shape (height, width, 3). Return `None` without a
        render mode."""
        return self._frames[0].frame() if self._frames else None

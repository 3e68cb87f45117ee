"""Vector environment: many environments that step in one call."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from gymnasium.utils import seeding
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space

from ..errors import KingpostError
from .environment import spaces
from .episodes import Episodes, check_options
from .rendering import FRAME_PX, Viewpoint, frames_of, metadata
from .task import Task


def _mode(given: AutoresetMode | str) -> AutoresetMode:
    """Gymnasium's mode by its name or its value.

    >>> _mode("SAME_STEP") == _mode("SameStep") == AutoresetMode.SAME_STEP
    True
    """
    named = AutoresetMode.__members__.get(given) if isinstance(given, str) else None
    try:
        return named or AutoresetMode(given)
    except ValueError as error:
        allowed = ", ".join(AutoresetMode.__members__)
        raise KingpostError(f"autoreset_mode: found {given!r}, allowed: {allowed}") from error


class ShipCraneVectorEnv(VectorEnv[np.ndarray, np.ndarray, np.ndarray]):
    """Many environments of one task: one call steps all, over SIMD lanes and threads.

    Each gives the same bits as a `ShipCraneEnv` with the same seed, for any number of threads and
    environments.

    Parameters
    ----------
    task
        The task.
    num_envs
        Number of environments.
    threads
        Threads that compute; 0 takes as many as the machine has.
    autoreset_mode
        ``SAME_STEP``: an episode that ends begins anew in the same step, and ``info["final_obs"]`` has its
        last observation. ``NEXT_STEP``: it begins anew in the next step, whose action is not used and whose
        reward is 0. ``DISABLED``: by ``reset(options={"reset_mask": ...})`` only.
    max_episode_steps
        Control steps in an episode; default: those of the task's duration.
    render_mode
        ``rgb_array``: `render` returns a picture of each environment; default: no pictures.
    camera, size_px
        Viewpoint and size of the pictures, as in `kingpost.picture`.

    Examples
    --------
    >>> from kingpost.learn import ShipCraneVectorEnv, anti_sway
    >>> envs = ShipCraneVectorEnv(anti_sway(), 8)
    >>> observations, info = envs.reset(seed=1)
    >>> observations.shape
    (8, 12)
    >>> envs.step(np.zeros((8, 2), dtype=np.float32))[1].shape
    (8,)
    """

    def __init__(
        self,
        task: Task,
        num_envs: int = 1,
        threads: int = 0,
        autoreset_mode: AutoresetMode | str = AutoresetMode.NEXT_STEP,
        max_episode_steps: int | None = None,
        render_mode: str | None = None,
        camera: Viewpoint = "free",
        size_px: tuple[int, int] = FRAME_PX,
    ) -> None:
        self.autoreset_mode = _mode(autoreset_mode)
        self.metadata = {**metadata(task), "autoreset_mode": self.autoreset_mode}
        self.render_mode = render_mode
        self.task, self.num_envs = task, num_envs
        self.single_observation_space, self.single_action_space = spaces(task)
        self.episodes = Episodes(task, num_envs, threads, max_episode_steps)
        self._frames = frames_of(self.episodes, render_mode, camera, size_px)
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)
        self._random: list[np.random.Generator | None] = [None] * num_envs
        self._ended = np.zeros(num_envs, dtype=np.bool_)

    def reset(
        self, *, seed: int | Sequence[int | None] | None = None, options: dict[str, Any] | None = None
    ) -> tuple[np.ndarray, dict[str, Any]]:
        """Begin episodes in all environments, or in those of ``options["reset_mask"]``.

        With a seed s, environment i has the seed s + i; a list gives one seed for each environment.
        """
        check_options(options, "reset_mask")
        mask = np.asarray((options or {}).get("reset_mask", np.ones(self.num_envs, dtype=np.bool_)))
        if mask.dtype != np.bool_ or mask.shape != (self.num_envs,) or not mask.any():
            raise KingpostError(
                f"reset_mask: found {mask!r}, allowed: {self.num_envs} booleans, at least one of them true"
            )
        seeds = [seed + i for i in range(self.num_envs)] if isinstance(seed, int | np.integer) else seed
        seeds = [None] * self.num_envs if seeds is None else list(seeds)
        if len(seeds) != self.num_envs:
            raise KingpostError(f"seed: found {len(seeds)} seeds, allowed: {self.num_envs}")
        which = np.flatnonzero(mask)
        for i in which:
            if (own := seeds[i]) is not None or self._random[i] is None:
                self._random[i] = seeding.np_random(None if own is None else int(own))[0]
        self._begin(which)
        return self.episodes.observations(), {}

    def step(
        self, actions: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, dict[str, Any]]:
        """Take a control step in every environment.

        Raises
        ------
        KingpostError
            If an action is NaN or not within -1 to 1; the error names the environment.
        """
        ended = self._ended.copy()
        if self.autoreset_mode == AutoresetMode.DISABLED and ended.any():
            first = int(np.flatnonzero(ended)[0])
            raise KingpostError(
                f"step: found environment {first} at the end of its episode, allowed: after reset"
            )
        seen, rewards, terminated, truncated = self.episodes.step(actions)
        for frames in self._frames:
            frames.act()
        if self.autoreset_mode == AutoresetMode.NEXT_STEP and ended.any():
            self._begin(np.flatnonzero(ended))
            seen = self.episodes.observations()
            rewards = np.where(ended, 0.0, rewards)
            terminated, truncated = terminated & ~ended, truncated & ~ended
        self._ended = terminated | truncated
        info = self._reasons(terminated)
        if self.autoreset_mode == AutoresetMode.SAME_STEP and self._ended.any():
            which = np.flatnonzero(self._ended)
            last = np.full(self.num_envs, None, dtype=object)
            for i in which:
                last[i] = seen[i]
            final: dict[str, Any] = {"final_obs": last, "_final_obs": self._ended.copy()}
            final |= {"final_info": info, "_final_info": self._ended.copy()}
            self._begin(which)
            seen, info = self.episodes.observations(), final
        return seen, rewards, terminated, truncated, info

    def render(self) -> tuple[np.ndarray, ...] | None:
        """Draw the present state of each environment; `None` without a render mode."""
        return tuple(frames.frame() for frames in self._frames) if self._frames else None

    def _begin(self, which: np.ndarray) -> None:
        drawn = {int(i): self._random[i] for i in which}
        self.episodes.begin({i: random for i, random in drawn.items() if random is not None})
        for frames in self._frames:
            if frames.copy in which:
                frames.begin()
        self._ended[which] = False

    def _reasons(self, terminated: np.ndarray) -> dict[str, Any]:
        if not terminated.any():
            return {}
        reasons = np.full(self.num_envs, None, dtype=object)
        for i in np.flatnonzero(terminated):
            reasons[i] = self.episodes.ended_by(int(i))
        return {"ended_by": reasons, "_ended_by": terminated.copy()}

"""Registration of the environments with Gymnasium."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any, ClassVar

import gymnasium

from .environment import ShipCraneEnv
from .rendering import FRAME_PX, RENDER_MODES, Viewpoint
from .task import Task
from .tasks import anti_sway, anti_sway_at_sea, heave_compensation, landing, roll_reduction, three_axis
from .vector import ShipCraneVectorEnv

IDS: dict[str, Callable[..., Task]] = {
    "Kingpost/AntiSway-v0": anti_sway,
    "Kingpost/AntiSwayAtSea-v0": anti_sway_at_sea,
    "Kingpost/HeaveCompensation-v0": heave_compensation,
    "Kingpost/Landing-v0": landing,
    "Kingpost/RollReduction-v0": roll_reduction,
    "Kingpost/ThreeAxis-v0": three_axis,
}
"""The task of each name."""


Span = tuple[float, float]


def _late(task: Task, delay_s: Span | None) -> Task:
    return task if delay_s is None else replace(task, delay_s=delay_s)


class _One:
    """Makes one environment of a task."""

    metadata: ClassVar[dict[str, Any]] = {"render_modes": [*RENDER_MODES]}

    def __init__(self, task: Callable[..., Task]) -> None:
        self.task = task

    def __call__(
        self,
        max_episode_steps: int | None = None,
        delay_s: Span | None = None,
        render_mode: str | None = None,
        camera: Viewpoint = "free",
        size_px: tuple[int, int] = FRAME_PX,
        **options: Any,
    ) -> ShipCraneEnv:
        task = _late(self.task(**options), delay_s)
        return ShipCraneEnv(task, max_episode_steps, render_mode, camera, size_px)


class _Many:
    """Makes many environments of a task."""

    def __init__(self, task: Callable[..., Task]) -> None:
        self.task = task

    def __call__(
        self,
        num_envs: int = 1,
        threads: int = 0,
        autoreset_mode: Any = gymnasium.vector.AutoresetMode.NEXT_STEP,
        max_episode_steps: int | None = None,
        delay_s: Span | None = None,
        render_mode: str | None = None,
        camera: Viewpoint = "free",
        size_px: tuple[int, int] = FRAME_PX,
        **options: Any,
    ) -> ShipCraneVectorEnv:
        task = _late(self.task(**options), delay_s)
        return ShipCraneVectorEnv(
            task, num_envs, threads, autoreset_mode, max_episode_steps, render_mode, camera, size_px
        )


def register() -> None:
    """Register the environments that are not registered yet."""
    for name, task in IDS.items():
        if name not in gymnasium.registry:
            gymnasium.register(name, entry_point=_One(task), vector_entry_point=_Many(task))

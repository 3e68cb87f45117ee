"""Predictive control of `Kingpost/AntiSway-v0` with plans that are sampled on copies of the simulation."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from .cross_entropy import CrossEntropy, Sampling
from .episodes import Episodes
from .policies import Policy, in_units
from .pretrained import trained
from .task import Task
from .tasks.anti_sway import target


class _Sampled:
    """Policy that plans for each episode separately; the goals follow from the first observations."""

    def __init__(self, task: Task, plans: Sampling, foreseen: Mapping[str, Any] | None) -> None:
        self.task, self.plans, self.foreseen = task, plans, foreseen
        self.planners: list[CrossEntropy] = []

    def __call__(self, seen: np.ndarray) -> np.ndarray:
        if not self.planners:
            guide = trained("Kingpost/AntiSway-v0").of(self.task)
            goals = self._goals(seen)
            self.planners = [
                CrossEntropy(self.task, goal, self.plans, guide, foreseen=self.foreseen) for goal in goals
            ]
        return np.stack([planner.action() for planner in self.planners])

    def _goals(self, seen: np.ndarray) -> list[list[float]]:
        now, start = in_units(self.task, seen), Episodes(self.task, 1, 1)
        start.begin({0: np.random.default_rng(0)})
        slews = start.columns["slew.joint_position"] - now["slew_error"]
        luffs = start.columns["luff.joint_position"] - now["luff_error"]
        return [target(float(slew), float(luff)) for slew, luff in zip(slews, luffs, strict=True)]


def cem_mpc(task: Task, plans: Sampling | None = None, foreseen: Mapping[str, Any] | None = None) -> Policy:
    """Return a controller whose plans, by the cross-entropy method, improve the trained policy. Its model are
    copies of the simulation.

    Parameters
    ----------
    task
        `anti_sway`, also on a ship. The copies follow the motion of the episode, so that the base's future
        motion is known.
    plans
        Settings of the sampling.
    foreseen
        Sea that plans assume if it is not known ahead: fields or parameters with their values.

    >>> from kingpost.learn import anti_sway
    >>> few = Sampling(horizon_s=1, guided_s=0, knots=2, candidates=4, elites=2, iterations=1)
    >>> cem_mpc(anti_sway(), few)(np.zeros((1, 12))).shape
    (1, 2)
    """
    return _Sampled(task, Sampling() if plans is None else plans, foreseen)

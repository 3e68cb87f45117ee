"""Classical controllers in the environments, to compare learned ones with."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from .task import Task

Policy = Callable[[np.ndarray], np.ndarray]
"""Actions from observations, a row for each environment. A policy with a memory is made anew for each run."""

SWING_PERIOD_S = 9.0
"""Period that the shaped inputs are for: hook and load of `anti_sway` as one pendulum, 2 pi sqrt(L / g)."""
SLOW = 0.2
"""Speed towards the target, 1/s, of the controller with feedback of the swing."""
FOLLOW = 0.5
"""Speed of slew or luff for each angle of swing, 1/s: near the square root of g / L."""


def do_nothing(task: Task) -> Policy:
    """All inputs in the middle of their range."""
    return lambda seen: np.zeros((len(seen), len(task.set)))


def _seen(task: Task, seen: np.ndarray) -> dict[str, np.ndarray]:
    """Observations by name in their units."""
    return {one.name: seen[:, k].astype(np.float64) * one.scale for k, one in enumerate(task.seen)}


def _limited(task: Task, speeds: list[np.ndarray]) -> np.ndarray:
    """Speeds as actions."""
    highest = [high for _, high in task.bounds]
    return np.clip(np.stack(speeds, axis=1) / highest, -1.0, 1.0)


def proportional(task: Task) -> Policy:
    """Speeds in proportion to the distance from the target, without regard to the swing."""

    def policy(seen: np.ndarray) -> np.ndarray:
        now = _seen(task, seen)
        return _limited(task, [-0.4 * now["slew_error"], -0.4 * now["luff_error"]])

    return policy


def swing_feedback(task: Task) -> Policy:
    """The same with feedback of the swing: the tip follows the load (a PD controller on the swing)."""

    def policy(seen: np.ndarray) -> np.ndarray:
        now = _seen(task, seen)
        slew = -SLOW * now["slew_error"] + FOLLOW * now["swing_across"]
        luff = -SLOW * now["luff_error"] - FOLLOW * now["swing_along"]
        return _limited(task, [slew, luff])

    return policy


class _Shaped:
    """Half of each command now, half of it half a period of the swing later (ZV shaper: Singer & Seering,
    J. Dyn. Sys. Meas. Control 112, 1990, 76-82)."""

    def __init__(self, task: Task) -> None:
        self.task = task
        self.command = proportional(task)
        self.past: list[np.ndarray] = []
        self.delay = round(0.5 * SWING_PERIOD_S / task.control_period_s)

    def __call__(self, seen: np.ndarray) -> np.ndarray:
        self.past.append(self.command(seen))
        late = self.past[-1 - self.delay] if len(self.past) > self.delay else np.zeros_like(self.past[-1])
        return 0.5 * self.past[-1] + 0.5 * late


DRUM_M = 0.15
"""Height for each radian of the drum in `heave_compensation`: 0.6 m of rope over four falls."""


def feed_forward(task: Task) -> Policy:
    """The winch pays out what the tip rises, with feedback of the load's height and speed."""

    def policy(seen: np.ndarray) -> np.ndarray:
        now = _seen(task, seen)
        rise = now["boom.tip.point_velocity.z"] + now["height_error"] + 2.0 * now["lift.velocity.z"]
        return _limited(task, [rise / DRUM_M])

    return policy


def feedback(task: Task) -> Policy:
    """Feedback of the load's height and speed alone (PD)."""

    def policy(seen: np.ndarray) -> np.ndarray:
        now = _seen(task, seen)
        return _limited(task, [(now["height_error"] + 2.0 * now["lift.velocity.z"]) / DRUM_M])

    return policy


BASELINES: dict[str, dict[str, Callable[[Task], Policy]]] = {
    "Kingpost/AntiSway-v0": {
        "do nothing": do_nothing,
        "proportional": proportional,
        "proportional, shaped": _Shaped,
        "swing feedback": swing_feedback,
    },
    "Kingpost/HeaveCompensation-v0": {
        "do nothing": do_nothing,
        "height feedback": feedback,
        "tip feed-forward and height feedback": feed_forward,
    },
}
"""Baselines of each environment by their names."""

"""Classical controllers for the environments: baselines for learned controllers."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from .landing_baselines import QuietMoment, constant_lowering, deck_following, slow_near_deck
from .policies import Policy, do_nothing, in_units, limited
from .task import Task

SWING_PERIOD_S = 9.0
"""Swing period for the input shaper, s: hook and load of `anti_sway` as one pendulum, 2 pi sqrt(L / g)."""
SLOW = 0.2
"""Gain from the distance to the target to a speed, 1/s, in `swing_feedback`."""
FOLLOW = 0.5
"""Gain from the swing angle to the speed of slewing or luffing, 1/s: near the square root of g / L."""


def proportional(task: Task) -> Policy:
    """Set speeds proportional to the distance from the target, without feedback of the swing."""

    def policy(seen: np.ndarray) -> np.ndarray:
        now = in_units(task, seen)
        return limited(task, [-0.4 * now["slew_error"], -0.4 * now["luff_error"]])

    return policy


def swing_feedback(task: Task) -> Policy:
    """Make a proportional policy with feedback of the swing: the tip follows the load (a PD controller)."""

    def policy(seen: np.ndarray) -> np.ndarray:
        now = in_units(task, seen)
        slew = -SLOW * now["slew_error"] + FOLLOW * now["swing_across"]
        luff = -SLOW * now["luff_error"] - FOLLOW * now["swing_along"]
        return limited(task, [slew, luff])

    return policy


class _Shaped:
    """Shape the commands: half of each now, half of it half a swing period later (ZV shaper: Singer &
    Seering, J. Dyn. Sys. Meas. Control 112, 1990, 76-82)."""

    def __init__(self, task: Task) -> None:
        self.task = task
        self.command = proportional(task)
        self.past: list[np.ndarray] = []
        self.delay = round(0.5 * SWING_PERIOD_S / task.control_period_s)

    def __call__(self, seen: np.ndarray) -> np.ndarray:
        self.past.append(self.command(seen))
        late = self.past[-1 - self.delay] if len(self.past) > self.delay else np.zeros_like(self.past[-1])
        return 0.5 * self.past[-1] + 0.5 * late


PID_GAINS = {
    "error": (0.2110, 0.1992),
    "integral": (6e-5, 2.4e-5),
    "rate": (0.0030, -0.0067),
    "swing": (0.5036, 0.4926),
    "swing_rate": (-0.1683, -0.1453),
}
"""Gains of slewing and luffing on errors (1/s), their integrals (1/s^2) and rates, and on the swing (1/s) and
its rate. They were found by a random search of 1000 steps, scored on 32 episodes with seeds from 2 000 000
on."""


class _Pid:
    """PID on the distance from the target, PD on the swing; the integral is held while a speed is at its
    limit."""

    def __init__(self, task: Task) -> None:
        self.task = task
        self.integral: np.ndarray | None = None
        self.highest = np.array([high for _, high in task.bounds])
        self.gains = {name: np.array(pair) for name, pair in PID_GAINS.items()}

    def __call__(self, seen: np.ndarray) -> np.ndarray:
        now, gains = in_units(self.task, seen), self.gains
        error = np.stack([now["slew_error"], now["luff_error"]], axis=1)
        if self.integral is None:
            self.integral = np.zeros_like(error)
        rate = np.stack([now["slew.joint_velocity"], now["luff.joint_velocity"]], axis=1)
        swing = np.stack([now["swing_across"], -now["swing_along"]], axis=1)
        along = now["pendant.second.joint_velocity"] + now["luff.joint_velocity"]
        swing_rate = np.stack([now["pendant.first.joint_velocity"], -along], axis=1)
        speed = gains["swing"] * swing + gains["swing_rate"] * swing_rate - gains["rate"] * rate
        speed -= gains["error"] * error + gains["integral"] * self.integral
        self.integral += np.where(np.abs(speed) < self.highest, error, 0.0) * self.task.control_period_s
        return np.clip(speed / self.highest, -1.0, 1.0)


DRUM_M = 0.15
"""Load height per radian of the drum in `heave_compensation`, m/rad: 0.6 m of rope over four falls."""


def feed_forward(task: Task) -> Policy:
    """Pay out rope at the rate at which the tip rises, with feedback of the load's height and speed."""

    def policy(seen: np.ndarray) -> np.ndarray:
        now = in_units(task, seen)
        rise = now["boom.tip.point_velocity.z"] + now["height_error"] + 2.0 * now["lift.velocity.z"]
        return limited(task, [rise / DRUM_M])

    return policy


def feedback(task: Task) -> Policy:
    """Feed back the load's height and speed only (PD)."""

    def policy(seen: np.ndarray) -> np.ndarray:
        now = in_units(task, seen)
        return limited(task, [(now["height_error"] + 2.0 * now["lift.velocity.z"]) / DRUM_M])

    return policy


ROLL_RATE_GAIN_S = 21.0
"""Share of a drive's largest torque per rad/s of roll rate, as in the gallery's scenario."""


def roll_rate_feedback(task: Task) -> Policy:
    """Return a policy that feeds back the roll rate: it drives the two gimbals in opposite directions, with
    torques proportional to the roll rate."""

    def policy(seen: np.ndarray) -> np.ndarray:
        push = ROLL_RATE_GAIN_S * in_units(task, seen)["hull.angular_velocity.x"]
        return np.clip(np.stack([push, -push], axis=1), -1.0, 1.0)

    return policy


ERROR_PER_S = 2.0
"""Gain from a position error to a speed, 1/s."""
SHARE = 0.5
"""Share of a measured speed that one control step removes; like `ERROR_PER_S` the best of a few values."""
ROPE_M = 0.6
"""Rope length per radian of the drum in `three_axis`, m/rad; equal to the change of the load's height."""


def tip_and_height(task: Task) -> Policy:
    """Return a policy that corrects the speed of each drive by the velocity and the position error: of the
    tip for slewing and luffing, of the load's height for the winch.

    A radian of slewing moves the tip by the reach, one of luffing by its height over the foot of the boom.
    """

    def policy(seen: np.ndarray) -> np.ndarray:
        now = in_units(task, seen)
        across = SHARE * now["speed_across"] + ERROR_PER_S * now["error_across"]
        along = SHARE * now["speed_along"] + ERROR_PER_S * now["error_along"]
        up = SHARE * now["lift.velocity.z"] + ERROR_PER_S * now["height_error"]
        slewing = now["slew.joint_velocity"] - across / now["reach"]
        luffing = now["luff.joint_velocity"] - along / now["tip_rise_over_foot"]
        return limited(task, [slewing, luffing, now["winch.joint_velocity"] + up / ROPE_M])

    return policy


ANTI_SWAY: dict[str, Callable[[Task], Policy]] = {
    "do nothing": do_nothing,
    "proportional": proportional,
    "proportional, shaped": _Shaped,
    "swing feedback": swing_feedback,
    "PID, tuned": _Pid,
}

BASELINES: dict[str, dict[str, Callable[[Task], Policy]]] = {
    "Kingpost/AntiSway-v0": ANTI_SWAY,
    "Kingpost/AntiSwayAtSea-v0": ANTI_SWAY,
    "Kingpost/HeaveCompensation-v0": {
        "do nothing": do_nothing,
        "height feedback": feedback,
        "tip feed-forward and height feedback": feed_forward,
    },
    "Kingpost/Landing-v0": {
        "do nothing": do_nothing,
        "constant lowering": constant_lowering,
        "slow near the deck": slow_near_deck,
        "wait for a quiet moment": QuietMoment,
        "follow the deck": deck_following,
    },
    "Kingpost/RollReduction-v0": {
        "do nothing: dampers alone": do_nothing,
        "feedback of the roll rate": roll_rate_feedback,
    },
    "Kingpost/ThreeAxis-v0": {
        "do nothing": do_nothing,
        "tip and height": tip_and_height,
    },
}
"""Baselines of each environment by their names."""

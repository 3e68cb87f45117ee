"""Controllers that set a load down, to compare learned ones with."""

from __future__ import annotations

import numpy as np

from .policies import Policy, in_units, limited
from .task import Task

DRUM_M = 0.15
"""Height for each radian of the drum in `landing`: 0.6 m of rope over four falls."""
LOWERING_M_S = 0.5
"""Constant speed of lowering. Like the numbers below it is the best of a few, on 16 episodes with seeds from
70 000 on."""
SOFT_M_S = 0.25
"""Speed of lowering near the deck without regard to its motion."""
FOLLOWING_M_S, FOLLOWING_PER_S = 0.1, 0.3
"""Speed at which the load closes with a deck that the winch follows: at least, and for each metre of
height, 1/s."""
STAND_OFF_M = 1.0
"""Height over the deck at which the load waits."""
APPROACH_M_S, APPROACH_PER_S = 1.0, 0.5
"""Highest speed down to that height, and the speed for each metre above it, 1/s."""
PERIOD_S, AHEAD_S = 9.0, 4.0
"""Period and time of the prediction of deck and tip."""
CALM_M_S, PATIENCE_M_S2 = 0.2, 0.02
"""Predicted speed of the impact that is calm enough, and its growth with the time of waiting."""


def constant_lowering(task: Task) -> Policy:
    """Lower at a constant speed, also after the load has landed."""
    return lambda seen: limited(task, [np.full(len(seen), LOWERING_M_S / DRUM_M)])


def _approach(now: dict[str, np.ndarray]) -> np.ndarray:
    """Speed of lowering towards the height of waiting, m/s."""
    return np.clip(APPROACH_PER_S * (now["height_over_deck"] - STAND_OFF_M), -APPROACH_M_S, APPROACH_M_S)


def _set_down(task: Task, now: dict[str, np.ndarray], speed: np.ndarray) -> np.ndarray:
    """This speed of lowering, m/s; after the first contact the winch pays out as fast as it can."""
    return limited(task, [np.where(now["has_touched"] > 0.5, np.inf, speed / DRUM_M)])


def slow_near_deck(task: Task) -> Policy:
    """Lower fast, at the end slowly, whatever the deck does; then pay out."""

    def policy(seen: np.ndarray) -> np.ndarray:
        now = in_units(task, seen)
        return _set_down(task, now, np.maximum(_approach(now), SOFT_M_S))

    return policy


def deck_following(task: Task) -> Policy:
    """The winch takes up the motion of deck and tip and lowers, slowly near the deck; then it pays out."""

    def policy(seen: np.ndarray) -> np.ndarray:
        now = in_units(task, seen)
        closing = np.clip(FOLLOWING_PER_S * now["height_over_deck"], FOLLOWING_M_S, APPROACH_M_S)
        return _set_down(task, now, closing + now["tip_heave_rate"] - now["deck_heave_rate"])

    return policy


class QuietMoment:
    """Waits over the deck, lowers when the predicted impact is soft: the longer it waits, the less it asks.

    The rise z of the deck over the tip is predicted from z and its rate by a sine of one period.
    """

    def __init__(self, task: Task) -> None:
        self.task, rate = task, 2.0 * np.pi / PERIOD_S
        self.ahead = np.arange(0.0, AHEAD_S, task.control_period_s)
        self.cosine, self.sine = np.cos(rate * self.ahead), np.sin(rate * self.ahead)
        self.rate, self.waited, self.lowering = rate, np.array(0.0), np.array(False)

    def __call__(self, seen: np.ndarray) -> np.ndarray:
        now = in_units(self.task, seen)
        near = now["height_over_deck"] < 2.0 * STAND_OFF_M
        self.waited = self.waited + near * self.task.control_period_s
        self.lowering = self.lowering | (self._impact(now) <= CALM_M_S + PATIENCE_M_S2 * self.waited)
        return _set_down(self.task, now, np.where(self.lowering, SOFT_M_S, _approach(now)))

    def _impact(self, now: dict[str, np.ndarray]) -> np.ndarray:
        """Speed of the impact if the load were lowered from now on; infinite if there is none in time."""
        rise = (now["deck_heave"] - now["tip_heave"])[:, None]
        rises = (now["deck_heave_rate"] - now["tip_heave_rate"])[:, None]
        later = rise * self.cosine + rises * self.sine / self.rate
        speeds = SOFT_M_S + rises * self.cosine - rise * self.rate * self.sine
        met = now["height_over_deck"][:, None] - SOFT_M_S * self.ahead <= later - rise
        first = np.take_along_axis(speeds, met.argmax(axis=1)[:, None], axis=1)[:, 0]
        return np.where(met.any(axis=1), first, np.inf)

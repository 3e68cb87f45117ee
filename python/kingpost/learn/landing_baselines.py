"""Classical controllers that set a load down: baselines for learned controllers."""

from __future__ import annotations

import numpy as np

from .policies import Policy, in_units, limited
from .task import Task

DRUM_M = 0.15
"""Load height per radian of the drum in `landing`, m/rad: 0.6 m of rope over four falls."""
LOWERING_M_S = 0.5
"""Constant speed of lowering. Like the numbers below, it is the best of a few values on 16 episodes with
seeds from 70 000 on."""
SOFT_M_S = 0.25
"""Speed of lowering near the deck, independent of the deck's motion."""
FOLLOWING_M_S, FOLLOWING_PER_S = 0.1, 0.3
"""Closing speed of the load to a deck that the winch follows: lower limit, and gain on the height, 1/s."""
STAND_OFF_M = 1.0
"""Height over the deck at which the load waits."""
APPROACH_M_S, APPROACH_PER_S = 1.0, 0.5
"""Largest speed of lowering to the waiting height, and gain on the height above it, 1/s."""
PERIOD_S, AHEAD_S = 9.0, 4.0
"""Period of the motion that is predicted for deck and tip, and prediction time."""
CALM_M_S, PATIENCE_M_S2 = 0.2, 0.02
"""Accepted predicted impact speed, and its increase with the waiting time."""


def constant_lowering(task: Task) -> Policy:
    """Lower at a constant speed, also after the load has landed."""
    return lambda seen: limited(task, [np.full(len(seen), LOWERING_M_S / DRUM_M)])


def _approach(now: dict[str, np.ndarray]) -> np.ndarray:
    """Speed of lowering towards the waiting height, m/s."""
    return np.clip(APPROACH_PER_S * (now["height_over_deck"] - STAND_OFF_M), -APPROACH_M_S, APPROACH_M_S)


def _set_down(task: Task, now: dict[str, np.ndarray], speed: np.ndarray) -> np.ndarray:
    """Lower at this speed, m/s; after the first contact pay out at the largest speed of the winch."""
    return limited(task, [np.where(now["has_touched"] > 0.5, np.inf, speed / DRUM_M)])


def slow_near_deck(task: Task) -> Policy:
    """Lower fast, then slowly near the deck, independent of its motion; then pay out."""

    def policy(seen: np.ndarray) -> np.ndarray:
        now = in_units(task, seen)
        return _set_down(task, now, np.maximum(_approach(now), SOFT_M_S))

    return policy


def deck_following(task: Task) -> Policy:
    """Follow the motion of deck and tip with the winch while lowering, slowly near the deck; then pay out."""

    def policy(seen: np.ndarray) -> np.ndarray:
        now = in_units(task, seen)
        closing = np.clip(FOLLOWING_PER_S * now["height_over_deck"], FOLLOWING_M_S, APPROACH_M_S)
        return _set_down(task, now, closing + now["tip_heave_rate"] - now["deck_heave_rate"])

    return policy


class QuietMoment:
    """Wait over the deck, and lower if the predicted impact speed is low enough; the accepted speed increases
    with the waiting time. The rise z of the deck over the tip is predicted from z and its rate by a sine of
    one period.
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
        """Impact speed if the load were lowered from now on; infinite if there is no impact within the
        prediction time."""
        rise = (now["deck_heave"] - now["tip_heave"])[:, None]
        rises = (now["deck_heave_rate"] - now["tip_heave_rate"])[:, None]
        later = rise * self.cosine + rises * self.sine / self.rate
        speeds = SOFT_M_S + rises * self.cosine - rise * self.rate * self.sine
        met = now["height_over_deck"][:, None] - SOFT_M_S * self.ahead <= later - rise
        first = np.take_along_axis(speeds, met.argmax(axis=1)[:, None], axis=1)[:, 0]
        return np.where(met.any(axis=1), first, np.inf)

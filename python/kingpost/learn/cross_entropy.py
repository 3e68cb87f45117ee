"""Predictive control by sampling: the cross-entropy method on copies of the simulation."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..errors import KingpostError
from .episodes import Episodes
from .policies import Policy, do_nothing
from .task import Task


@dataclass(frozen=True)
class Sampling:
    """Settings of the sampling of plans.

    Attributes
    ----------
    horizon_s
        Length of a plan, s.
    guided_s
        Time after the plan in which the guide alone controls, s; the rewards of this time count too.
    knots
        Number of points of a plan, at least 2, the first now and the last at the horizon; the plan is linear
        between them.
    candidates
        Number of plans that are tried in each iteration.
    elites
        Number of best plans, to which mean and spread are fitted.
    kept
        Number of elites that are tried again in the next iteration and, shifted in time, in the next plan.
    iterations
        Number of iterations for each plan.
    every_s
        Time between two plans, s.
    spread
        Standard deviation of the first iteration, in actions.
    least_spread
        Lower bound of the standard deviation.
    seed
        Seed of all random numbers.

    Raises
    ------
    KingpostError
        If a number is outside its range.

    >>> Sampling(candidates=16, elites=20)
    Traceback (most recent call last):
    kingpost.errors.KingpostError: elites: found 20, allowed: 1 to 16, the candidates
    """

    horizon_s: float = 4.0
    guided_s: float = 8.0
    knots: int = 5
    candidates: int = 32
    elites: int = 6
    kept: int = 3
    iterations: int = 3
    every_s: float = 0.5
    spread: float = 0.3
    least_spread: float = 0.02
    seed: int = 1

    def __post_init__(self) -> None:
        for name in ("horizon_s", "every_s", "spread", "least_spread"):
            if not (math.isfinite(value := getattr(self, name)) and value > 0):
                raise KingpostError(f"{name}: found {value}, allowed: a number greater than 0")
        if not (math.isfinite(self.guided_s) and self.guided_s >= 0):
            raise KingpostError(f"guided_s: found {self.guided_s}, allowed: 0 or more")
        for name, least in (("knots", 2), ("candidates", 2), ("iterations", 1), ("kept", 0)):
            if getattr(self, name) < least:
                raise KingpostError(f"{name}: found {getattr(self, name)}, allowed: {least} or more")
        if not 1 <= self.elites <= self.candidates:
            allowed = f"1 to {self.candidates}, the candidates"
            raise KingpostError(f"elites: found {self.elites}, allowed: {allowed}")

    def steps(self, name: str, control_period_s: float) -> int:
        """Convert ``horizon_s`` or ``every_s`` to control steps."""
        steps = round(getattr(self, name) / control_period_s)
        if steps < 1:
            allowed = f"at least {control_period_s}, the control period"
            raise KingpostError(f"{name}: found {getattr(self, name)}, allowed: {allowed}")
        return steps


class CrossEntropy:
    """Plans by the cross-entropy method (Rubinstein, *Methodology and Computing in Applied Probability* 1,
    1999; for control de Boer et al., *Annals of Operations Research* 134, 2005; with elites that are kept
    Pinneri et al., *Conf. Robot Learning*, 2020).

    A plan is added to the actions of a guide, a controller without internal state. The model is the engine
    itself: each candidate is a copy of the scenario in its present state, controlled by the guide and the
    plan; its score is the sum of the task's rewards. The plan of zeros is always among the candidates. The
    same seed gives the same actions to the last bit, whatever the number of threads. The method is for tasks
    whose episodes all begin in the same state: a copy receives every action of the scenario, so that the
    state is known. The goal is given. The future excitation is known too; with `foreseen`, plans continue
    from the true state in another sea.

    Parameters
    ----------
    task
        The task, without drawn scenarios.
    goal
        Goal of the episode.
    sampling
        Settings of the sampling.
    guide
        Controller that the plans improve; default: one that does nothing.
    threads
        Threads that compute; 0 takes as many as the machine has.
    foreseen
        Fields or parameters of the scenario with the values that plans assume; default: its own.

    Examples
    --------
    >>> from kingpost.learn import anti_sway
    >>> few = Sampling(horizon_s=1, guided_s=0, knots=2, candidates=4, elites=2, iterations=1)
    >>> plan = CrossEntropy(anti_sway(), [1.0, -0.8, 14.0, 15.0], few, threads=1)
    >>> plan.action().shape
    (2,)
    """

    def __init__(
        self,
        task: Task,
        goal: list[float],
        sampling: Sampling | None = None,
        guide: Policy | None = None,
        threads: int = 0,
        foreseen: Mapping[str, Any] | None = None,
    ) -> None:
        self.task, self.sampling = task, Sampling() if sampling is None else sampling
        self.guide = do_nothing(task) if guide is None else guide
        self.hold = self.sampling.steps("every_s", task.control_period_s)
        self.steps = self.sampling.steps("horizon_s", task.control_period_s)
        candidates = [foreseen or {}] * self.sampling.candidates
        own = [*candidates, {}] if foreseen else candidates
        self.copies = Episodes(task, len(own), threads, own=own)
        self.copies.begin({copy: np.random.default_rng(0) for copy in range(len(own))})
        self.copies.goals = np.tile(np.asarray(goal, np.float64), (len(own), 1))
        self.copies.mark(len(own) - 1)
        self.random = np.random.default_rng(self.sampling.seed)
        self.taken = 0
        self.best = np.zeros((1, self.sampling.knots, len(task.set)))

    def action(self) -> np.ndarray:
        """Return the next action, from a new plan or from the last one. The action is assumed to be
        executed."""
        if self.taken % self.hold == 0:
            self._replan()
        self.copies.resume()
        plans = np.tile(self.best[0], (self.copies.count, 1, 1))
        chosen = self._steered(plans, self.taken % self.hold)
        self.copies.step(chosen)
        self.copies.mark(self.copies.count - 1)
        self.taken += 1
        return chosen[-1]

    def _steered(self, plans: np.ndarray, step: int) -> np.ndarray:
        """Sum of the guide's actions and the plans."""
        guided = self.guide(self.copies.observations())
        return np.clip(guided + (at_knot(plans, self._knot(step)) if step < self.steps else 0.0), -1.0, 1.0)

    def _knot(self, step: float) -> float:
        return step * (self.sampling.knots - 1) / self.steps

    def _replan(self) -> None:
        """Shift the best plans by the time since the last planning, and improve them."""
        sampling = self.sampling
        if self.taken:
            since = self._knot(self.hold)
            last = sampling.knots - 1
            later = [at_knot(self.best, min(k + since, last)) for k in range(sampling.knots)]
            self.best = np.stack(later, axis=1)
        mean, spread = self.best[0], np.full(self.best[0].shape, sampling.spread)
        for _ in range(sampling.iterations):
            drawn = self.random.standard_normal((sampling.candidates, *mean.shape))
            tried = np.clip(mean + spread * drawn, -2.0, 2.0)
            known = [np.zeros_like(mean), mean, *self.best[: sampling.kept]][: sampling.candidates]
            tried[: len(known)] = known
            self.best = tried[np.argsort(-self.scores(tried), kind="stable")[: sampling.elites]]
            mean, spread = self.best.mean(axis=0), np.maximum(self.best.std(axis=0), sampling.least_spread)

    def scores(self, plans: np.ndarray) -> np.ndarray:
        """Sum of the rewards of each plan from the present state, including the time of the guide alone."""
        self.copies.resume()
        count, every = len(plans), self.copies.count
        plans = np.concatenate([plans, np.zeros((every - count, *plans.shape[1:]))])
        sums, going = np.zeros(every), np.ones(every, np.bool_)
        for step in range(self.steps + round(self.sampling.guided_s / self.task.control_period_s)):
            _, rewards, terminated, _ = self.copies.step(self._steered(plans, step))
            sums += np.where(going, rewards, 0.0)
            going &= ~terminated
        return sums[:count]


def at_knot(plans: np.ndarray, place: float) -> np.ndarray:
    """Interpolate plans between two knots.

    >>> at_knot(np.array([[[0.0], [1.0], [4.0]]]), 1.5)
    array([[2.5]])
    """
    below = min(int(place), plans.shape[1] - 2)
    share = place - below
    return (1.0 - share) * plans[:, below] + share * plans[:, below + 1]

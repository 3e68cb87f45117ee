"""Predictive control by sampling: the cross-entropy method over the engine's own copies."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .episodes import Episodes
from .task import Task


@dataclass(frozen=True)
class Sampling:
    """How a plan is sampled.

    Attributes
    ----------
    horizon_s
        Length of a plan, s.
    knots
        Actions of a plan; each is held for its share of the horizon.
    candidates
        Plans that are tried in each iteration.
    elites
        The best of them, to which mean and spread are fitted.
    iterations
        Iterations for each plan.
    every_s
        Time between two plans, s.
    spread
        Standard deviation of the actions of the first iteration.
    least_spread
        What it does not fall below.
    seed
        Seed of all that is drawn.
    """

    horizon_s: float = 8.0
    knots: int = 8
    candidates: int = 32
    elites: int = 6
    iterations: int = 3
    every_s: float = 0.5
    spread: float = 0.6
    least_spread: float = 0.05
    seed: int = 1


class CrossEntropy:
    """Plans by the cross-entropy method (Rubinstein, *Methodology and Computing in Applied Probability* 1,
    1999; for control de Boer et al., *Annals of Operations Research* 134, 2005).

    The model is the engine itself: each candidate is a copy of the scenario in its present state that takes
    the actions of the plan; its score is the task's reward of the plan. The same seed gives the same actions
    to the last bit, whatever the number of threads. It is for tasks whose episodes begin alike: the copies
    take every action as the scenario does, so that their state is known; the goal is given, not guessed.

    Parameters
    ----------
    task
        The task, without drawn scenarios.
    goal
        The numbers that the episode is about.
    sampling
        How plans are sampled.
    threads
        Threads that compute; 0 takes as many as the machine has.

    Examples
    --------
    >>> from kingpost.learn import anti_sway
    >>> few = Sampling(horizon_s=1, knots=2, candidates=4, elites=2, iterations=1)
    >>> plan = CrossEntropy(anti_sway(), [1.0, -0.8, 14.0, 15.0], few, threads=1)
    >>> plan.action().shape
    (2,)
    """

    def __init__(
        self, task: Task, goal: list[float], sampling: Sampling | None = None, threads: int = 0
    ) -> None:
        self.task, self.sampling = task, Sampling() if sampling is None else sampling
        self.copies = Episodes(task, self.sampling.candidates, threads)
        self.copies.begin({copy: np.random.default_rng(0) for copy in range(self.sampling.candidates)})
        self.copies.goals = np.tile(np.asarray(goal, np.float64), (self.sampling.candidates, 1))
        self.copies.mark()
        self.random = np.random.default_rng(self.sampling.seed)
        self.taken = 0
        self.hold = round(self.sampling.every_s / task.control_period_s)
        self.plan = np.zeros((self.sampling.knots, len(task.set)))

    def action(self) -> np.ndarray:
        """The next action, of a new plan or of the last one; it counts as taken."""
        if self.taken % self.hold == 0:
            self._replan()
        chosen = self.plan[self._knot(self.taken % self.hold)].copy()
        self.copies.resume()
        self.copies.step(np.tile(chosen, (self.sampling.candidates, 1)))
        self.copies.mark()
        self.taken += 1
        return chosen

    def _steps(self) -> int:
        return round(self.sampling.horizon_s / self.task.control_period_s)

    def _knot(self, step: int) -> int:
        return step * self.sampling.knots // self._steps()

    def _replan(self) -> None:
        """Moves the plan on by the time since the last one, and improves it."""
        sampling = self.sampling
        if self.taken:
            since = self.hold * sampling.knots / self._steps()
            later = np.minimum(np.arange(sampling.knots) + since, sampling.knots - 1)
            below = np.floor(later).astype(int)
            above = np.minimum(below + 1, sampling.knots - 1)
            self.plan = self.plan[below] + (later - below)[:, None] * (self.plan[above] - self.plan[below])
        spread = np.full_like(self.plan, sampling.spread)
        for _ in range(sampling.iterations):
            drawn = self.random.standard_normal((sampling.candidates, *self.plan.shape))
            tried = np.clip(self.plan + spread * drawn, -1.0, 1.0)
            tried[0] = self.plan
            best = tried[np.argsort(-self.scores(tried), kind="stable")[: sampling.elites]]
            self.plan, spread = best.mean(axis=0), np.maximum(best.std(axis=0), sampling.least_spread)

    def scores(self, plans: np.ndarray) -> np.ndarray:
        """The sum of rewards of each plan from here on."""
        count = self.sampling.candidates
        self.copies.resume()
        sums, going = np.zeros(count), np.ones(count, np.bool_)
        for step in range(self._steps()):
            _, rewards, terminated, _ = self.copies.step(plans[:, self._knot(step)])
            sums += np.where(going, rewards, 0.0)
            going &= ~terminated
        return sums

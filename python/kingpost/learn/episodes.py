"""Episodes of a task in many copies that step together: the common part of single and vector environments."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ..engine import engine
from ..errors import KingpostError
from .delays import Delays
from .task import LARGEST_OBSERVATION, Columns, Task

SEED = "simulation.seed"
SEEDS = 2**31
FAILED = -1
BEFORE = "before."


def check_options(options: Mapping[str, Any] | None, *allowed: str) -> None:
    """Refuse unknown options of a reset.

    Raises
    ------
    KingpostError
        If an option has an unknown name.

    >>> check_options({"load_t": 3})
    Traceback (most recent call last):
        ...
    kingpost.errors.KingpostError: options: found 'load_t', allowed: none; randomised varies parameters
    """
    unknown = [name for name in options or {} if name not in allowed]
    if unknown:
        known = ", ".join(allowed) or "none"
        raise KingpostError(f"options: found {unknown[0]!r}, allowed: {known}; randomised varies parameters")


def checked_rewards(rewards: object, count: int) -> np.ndarray:
    """Check the rewards of a step, one for each environment.

    Raises
    ------
    KingpostError
        If a reward function returned an array of another shape, such as one number for all environments.

    >>> checked_rewards([0.5, 1], 2)
    array([0.5, 1. ])
    """
    given = np.asarray(rewards)
    if given.shape != (count,) or given.dtype.kind not in "fiub":
        found = f"an array of the shape {given.shape}" if given.shape else repr(rewards)
        raise KingpostError(f"reward: found {found}, allowed: {count} numbers, one for each environment")
    return given.astype(float)


class Episodes:
    """Copies of a task's scenario, each in a separate episode.

    Parameters
    ----------
    task
        The task.
    count
        Number of copies.
    threads
        Threads that compute; 0 takes as many as the machine has. The results do not depend on it.
    episode_steps
        Control steps of an episode; default: the task's.
    own
        Fields or parameters of the scenario with one value for each copy; default: none.

    Attributes
    ----------
    variants
        Overrides of each copy in its episode, by name.
    inputs
        Inputs of the last control step, shape (copies, inputs).

    Examples
    --------
    >>> from kingpost.learn import anti_sway
    >>> episodes = Episodes(anti_sway(), 2, threads=1)
    >>> episodes.begin({0: np.random.default_rng(0), 1: np.random.default_rng(1)})
    >>> observations, rewards, terminated, truncated = episodes.step(np.zeros((2, 2)))
    >>> rewards.shape, bool(terminated.any())
    ((2,), False)
    """

    def __init__(
        self,
        task: Task,
        count: int,
        threads: int = 0,
        episode_steps: int | None = None,
        own: Sequence[Mapping[str, Any]] = (),
    ) -> None:
        if count < 1:
            raise KingpostError(f"num_envs: found {count}, allowed: 1 or more")
        if threads < 0:
            raise KingpostError(f"threads: found {threads}, allowed: 0 or more")
        self.task, self.count, self.threads = task, count, threads
        self._own = [list(values.items()) for values in own] or [[]] * count
        self.episode_steps = task.episode_steps if episode_steps is None else episode_steps
        self.taken = np.zeros(count, dtype=np.int64)
        self.goals: np.ndarray | None = None
        self.variants: list[list[tuple[str, Any]]] = [[] for _ in range(count)]
        self.inputs = np.zeros((count, len(task.set)))
        self._lower = np.array([low for low, _ in task.bounds])
        self._upper = np.array([high for _, high in task.bounds])
        self._half = 0.5 * (self._upper - self._lower)
        self._scales = np.array([one.scale for one in task.seen])
        self._read = np.empty(count * len(task.read))
        longest = task.delay_steps[1]
        self._late = Delays(count, longest, len(task.seen)) if longest else None
        self._kept = [task.read.index(name) for name in task.before]
        self._before = np.empty((count, len(task.before)))
        self._done = np.zeros(count, dtype=np.bool_)
        self._status = np.zeros(count, dtype=np.int64)
        self._nothing = np.empty(0)
        self._marked: tuple[np.int64, np.ndarray, np.ndarray, np.ndarray] | None = None
        self._marked_late: tuple[int, np.ndarray] | None = None
        self._copies: engine.VectorEnsemble | None = None

    def begin(self, which: dict[int, np.random.Generator]) -> None:
        """Begin episodes of these copies; the first call names all of them."""
        variants = {copy: self._drawn(random) + self._own[copy] for copy, random in which.items()}
        for copy, variant in variants.items():
            self.variants[copy] = variant
        if self._copies is None:
            self._copies = self._made([variants[copy] for copy in range(self.count)])
        else:
            fixed = not self.task.randomised and not self.task.seeded
            rows = [[copy, None if fixed else variant] for copy, variant in variants.items()]
            self._copies.restart(json.dumps(rows))
        self._copies.advance(0, self._nothing, self._read, self._status)
        table = self._read.reshape(self.count, -1)
        for copy, random in which.items():
            start = dict(zip(self.task.read, table[copy].tolist(), strict=True))
            goal = np.asarray(self.task.goal(random, start), dtype=np.float64)
            if self.goals is None:
                self.goals = np.zeros((self.count, len(goal)))
            self.goals[copy] = goal
            self.taken[copy] = 0
            self._before[copy] = table[copy, self._kept]
        if self._late is not None:
            now, (least, longest) = self._now(), self.task.delay_steps
            for copy, random in which.items():
                self._late.begin(copy, int(random.integers(least, longest + 1)), now[copy])

    def step(self, actions: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Take a control step: observations, rewards, and which episodes are terminated or truncated."""
        if self._copies is None or self.goals is None:
            raise KingpostError("step: found no episode, allowed: after reset()")
        actions = self._checked(actions)
        inputs = self._lower + (actions + 1.0) * self._half
        self.inputs = inputs = np.clip(inputs, self._lower, self._upper)
        self._before = self._read.reshape(self.count, -1)[:, self._kept]
        self._copies.advance(self.task.steps, inputs.ravel(), self._read, self._status)
        self.taken += 1
        columns, failed = self.columns, self._status != 0
        rewards = checked_rewards(self.task.reward(columns, self.goals, actions), self.count)
        if failed.any():
            rewards = np.where(failed, self.task.failure_reward, rewards)
        if self.task.done is not None:
            self._done = self.task.done(columns, self.goals)
        terminated = failed | self._done
        if self._late is not None:
            self._late.push(self._now())
        return self.observations(), rewards, terminated, ~terminated & (self.taken >= self.episode_steps)

    def mark(self, copy: int = 0) -> None:
        """Store the state of one copy and of its episode for `resume`."""
        if self._copies is None or self.goals is None:
            raise KingpostError("mark: found no episode, allowed: after reset()")
        self._copies.mark(copy)
        read = self._read.reshape(self.count, -1)
        self._marked = (
            self.taken[copy],
            self.goals[copy].copy(),
            read[copy].copy(),
            self._before[copy].copy(),
        )
        self._marked_late = None if self._late is None else self._late.of(copy)

    def resume(self) -> None:
        """Set all copies to the state stored by `mark`. Each copy keeps its overrides: in another sea it then
        meets other waves."""
        if self._copies is None or self.goals is None or self._marked is None:
            raise KingpostError("resume: found no mark, allowed: after mark()")
        self._copies.resume()
        self.taken[:], self.goals[:], self._read.reshape(self.count, -1)[:], self._before[:] = self._marked
        self._status[:], self._done[:] = 0, False
        if self._late is not None and self._marked_late is not None:
            self._late.set_all(self._marked_late)

    @property
    def columns(self) -> Columns:
        """Columns as last read."""
        table = self._read.reshape(self.count, -1)
        found = {name: table[:, k] for k, name in enumerate(self.task.read)}
        return found | {BEFORE + name: self._before[:, k] for k, name in enumerate(self.task.before)}

    def observations(self) -> np.ndarray:
        """Observations after the delay, a row for each copy."""
        return self._now() if self._late is None else self._late.seen()

    def _now(self) -> np.ndarray:
        """Observations without delay, a row for each copy."""
        found = np.empty((self.count, len(self._scales)))
        columns, goals = self.columns, np.empty((self.count, 0)) if self.goals is None else self.goals
        for k, one in enumerate(self.task.seen):
            found[:, k] = columns[one.name] if one.value is None else one.value(columns, goals)
        found /= self._scales
        return np.clip(found, -LARGEST_OBSERVATION, LARGEST_OBSERVATION).astype(np.float32)

    def failed(self, copy: int) -> bool:
        """Whether an episode failed or exceeded a limit, so that its reward is that of a failure."""
        return bool(self._status[copy] != 0)

    def ended_by(self, copy: int) -> str:
        """Why an episode was terminated: an error of the run, the limit that was exceeded, or ``done``."""
        status = int(self._status[copy])
        if status == FAILED and self._copies is not None:
            return str(self._copies.failure(copy))
        if status:
            return f"limit {list(self.task.based_on.resolved['limits'])[status - 1]} exceeded"
        return "done" if self._done[copy] else ""

    def _checked(self, actions: Any) -> np.ndarray:
        shape = (self.count, len(self.task.set))
        try:
            given = np.asarray(actions, dtype=np.float64)
        except (TypeError, ValueError) as error:
            raise KingpostError(f"actions: found {actions!r}, allowed: numbers from -1 to 1") from error
        if given.shape != shape:
            raise KingpostError(f"actions: found the shape {given.shape}, allowed: {shape}")
        inside = np.abs(given) <= 1.0
        if not inside.all():
            copy, k = np.argwhere(~inside)[0]
            name, place = self.task.action_names[k], f" of environment {copy}" if self.count > 1 else ""
            raise KingpostError(f"action {name}{place}: found {given[copy, k]:g}, allowed: -1 to 1")
        return given

    def _drawn(self, random: np.random.Generator) -> list[tuple[str, Any]]:
        """Overrides of the scenario for an episode, with its drawn values."""
        drawn: list[tuple[str, Any]] = list(self.task.based_on.overrides)
        drawn += [(name, float(random.uniform(*span))) for name, span in self.task.randomised.items()]
        return [*drawn, (SEED, int(random.integers(SEEDS)))] if self.task.seeded else drawn

    def _made(self, variants: Sequence[list[tuple[str, Any]]]) -> engine.VectorEnsemble:
        scenario, task = self.task.based_on, self.task
        asked = (list(task.action_names), list(task.read), task.limits, self.threads)
        return engine.VectorEnsemble(
            scenario.text, scenario.file, scenario.files, json.dumps(variants), asked
        )

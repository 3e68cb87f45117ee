"""Task of a controller: a scenario, its inputs as actions, columns as observations, a reward."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

import numpy as np

from ..errors import KingpostError
from ..scenario import Scenario, load
from ..simulation.simulate import Simulation

LARGEST_OBSERVATION = 10.0
"""Largest magnitude of an observation, in scales; beyond it observations are clipped."""
FARTHEST = 1e5
"""Widest range of an input without bounds in the task: half of a wider range is not a useful unit."""

Columns = Mapping[str, np.ndarray]
"""Columns of results by name: a value for each environment, in SI units."""
Goal = np.ndarray
"""Goal of an episode, such as a target: a row for each environment."""


@dataclass(frozen=True)
class Observation:
    """A scaled observation of a controller: ``value / scale``, clipped to ten scales on either side.

    Parameters
    ----------
    name
        Name of the observation; the name of a column unless `value` is given.
    scale
        The size that counts as 1, in `unit`.
    unit
        Unit of the value; default: the unit of the column.
    value
        Function of columns and goal that returns one number for each environment; default: the column `name`.
    """

    name: str
    scale: float = 1.0
    unit: str = ""
    value: Callable[[Columns, Goal], np.ndarray] | None = None


@dataclass(frozen=True)
class Action:
    """An input that a controller sets: an action of -1 is `lower`, 1 is `upper`.

    Parameters
    ----------
    name
        An input of the scenario.
    lower, upper
        In the input's unit; default: the input's own bounds.
    """

    name: str
    lower: float | None = None
    upper: float | None = None


def no_goal(random: np.random.Generator, start: Mapping[str, float]) -> Sequence[float]:
    """Return an empty goal: the task is the same in every episode.

    >>> no_goal(np.random.default_rng(0), {})
    ()
    """
    return ()


@dataclass(frozen=True)
class Task:
    """A task on any scenario.

    Parameters
    ----------
    scenario
        A scenario, a file or a name of the gallery.
    actions
        Inputs, by name or as an `Action`.
    observations
        Columns by name, or as an `Observation`.
    reward
        The reward of a control step from columns, goal and actions (-1 to 1), one for each environment. It is
        made of sums, products, square roots and comparisons only, so that its bits do not depend on how many
        environments there are.
    columns
        Further columns that reward and observations need.
    before
        Columns whose values before the control step reward and observations also need, each as
        ``before.NAME``; at the start of an episode they equal the present values.
    done
        Whether an episode has reached its end, from columns and goal, one for each environment; default:
        never.
    control_period_s
        Time between two actions, s: a whole number of the scenario's steps.
    duration_s
        Length of an episode, s.
    goal
        Function that draws the goal of an episode from the columns at its start.
    randomised
        Parameters or paths of fields with their range: each episode draws a value from it.
    delay_s
        Least and largest delay of the observations, s: each episode draws a whole number of control steps in
        this range. Reward and end of the episode are not delayed.
    seeded
        Whether each episode draws a seed of its sea, gusts and noise.
    limits
        Whether an episode ends when a limit of the scenario is exceeded.
    failure_reward
        The reward of the step in which the simulation fails or a limit is exceeded, instead of `reward`.

    Examples
    --------
    >>> task = Task(
    ...     "lowering_by_winch",
    ...     [Action("hoist", -5, 5)],
    ...     ["lift.velocity.z"],
    ...     reward=lambda columns, goal, actions: -abs(columns["lift.velocity.z"]),
    ... )
    >>> task.action_units
    ('rad',)
    """

    scenario: Scenario | str | Path
    actions: Sequence[Action | str]
    observations: Sequence[Observation | str]
    reward: Callable[[Columns, Goal, np.ndarray], np.ndarray]
    columns: Sequence[str] = ()
    before: Sequence[str] = ()
    done: Callable[[Columns, Goal], np.ndarray] | None = None
    control_period_s: float = 0.05
    duration_s: float = 40.0
    goal: Callable[[np.random.Generator, Mapping[str, float]], Sequence[float]] = no_goal
    randomised: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    delay_s: tuple[float, float] = (0.0, 0.0)
    seeded: bool = False
    limits: bool = False
    failure_reward: float = -100.0

    def __post_init__(self) -> None:
        for what, given in (("actions", self.actions), ("observations", self.observations)):
            if isinstance(given, str) or not given:
                raise KingpostError(f"{what}: found {given!r}, allowed: a list of at least one name")
        self._check_period(self._simulation.step_s)
        if not self.duration_s >= self.control_period_s:
            raise KingpostError(
                f"duration_s: found {self.duration_s}, allowed: at least control_period_s, "
                f"{self.control_period_s}"
            )
        if not 0 <= self.delay_s[0] <= self.delay_s[1] <= self.duration_s:
            allowed = f"from 0 to duration_s, {self.duration_s}"
            raise KingpostError(f"delay_s: found {self.delay_s[0]} to {self.delay_s[1]}, allowed: {allowed}")
        for name, (low, high) in self.randomised.items():
            if not low <= high:
                raise KingpostError(f"randomised {name}: found {low} to {high}, allowed: from low to high")
        self._check_ends()
        unknown = [name for name in self.read if name not in self._units]
        if unknown:
            raise KingpostError(f"column {unknown[0]}: no such column in {self.based_on.title}")
        for one in self.bounds:
            if not abs(one[1] - one[0]) < 2 * FARTHEST:
                raise KingpostError(f"actions: found bounds {one}, allowed: an Action with narrower ones")

    def _check_period(self, step_s: float) -> None:
        """Refuse a control period that is not a whole number of steps, within 1e-6 of a step."""
        steps = self.control_period_s / step_s
        if not steps >= 1 - 1e-9 or abs(steps - round(steps)) > 1e-6:
            raise KingpostError(
                f"control_period_s: found {self.control_period_s}, allowed: a whole number of steps of "
                f"{step_s} s"
            )

    def _check_ends(self) -> None:
        """Refuse a range of `randomised` with an end that the scenario refuses: an episode could fail
        later."""
        for end, which in enumerate(("low", "high") if self.randomised else ()):
            ends = {name: float(span[end]) for name, span in self.randomised.items()}
            try:
                variant = self.based_on.with_overrides(ends)
            except KingpostError as error:
                raise KingpostError(f"randomised, at the {which} end of each range: {error}") from error
            self._check_period(variant.resolved["simulation"]["step_s"])

    @cached_property
    def based_on(self) -> Scenario:
        """The scenario."""
        return self.scenario if isinstance(self.scenario, Scenario) else load(self.scenario)

    @cached_property
    def _simulation(self) -> Simulation:
        return Simulation(self.based_on)

    @cached_property
    def _units(self) -> dict[str, str]:
        """The unit of every column."""
        channels = self._simulation.channels
        return {
            name: unit
            for channel in channels
            for name, unit in zip(channel["columns"], channel["units"], strict=True)
        }

    @cached_property
    def seen(self) -> tuple[Observation, ...]:
        """The observations."""
        return tuple(Observation(one) if isinstance(one, str) else one for one in self.observations)

    @cached_property
    def set(self) -> tuple[Action, ...]:
        """The actions."""
        return tuple(Action(one) if isinstance(one, str) else one for one in self.actions)

    @cached_property
    def read(self) -> tuple[str, ...]:
        """The columns that are read after each control step."""
        own = [one.name for one in self.seen if one.value is None]
        return tuple(dict.fromkeys([*own, *self.columns, *self.before]))

    @cached_property
    def bounds(self) -> list[tuple[float, float]]:
        """Lower and upper bound of each input, in its unit."""
        inputs = self._simulation.inputs
        found = []
        for action in self.set:
            if action.name not in inputs:
                allowed = ", ".join(inputs) or "none: this scenario has no inputs"
                raise KingpostError(f"action {action.name}: no such input, allowed: {allowed}")
            one = inputs[action.name]
            low, high = one.lower if action.lower is None else action.lower, action.upper
            high = one.upper if high is None else high
            if not one.lower <= low < high <= one.upper:
                raise KingpostError(
                    f"action {action.name}: found {low} to {high}, "
                    f"allowed: within {one.lower} to {one.upper} {one.unit}"
                )
            found.append((low, high))
        return found

    @property
    def action_names(self) -> tuple[str, ...]:
        """Names of the inputs."""
        return tuple(one.name for one in self.set)

    @property
    def action_units(self) -> tuple[str, ...]:
        """Units of the inputs."""
        return tuple(self._simulation.inputs[one.name].unit for one in self.set)

    @property
    def observation_names(self) -> tuple[str, ...]:
        """Names of the observations."""
        return tuple(one.name for one in self.seen)

    @property
    def observation_units(self) -> tuple[str, ...]:
        """Units of the observations before they are divided by their scales."""
        return tuple(one.unit or self._units.get(one.name, "") for one in self.seen)

    @property
    def steps(self) -> int:
        """Steps of the integrator in a control step."""
        return round(self.control_period_s / self._simulation.step_s)

    @property
    def delay_steps(self) -> tuple[int, int]:
        """Least and largest delay of the observations, in control steps."""
        return round(self.delay_s[0] / self.control_period_s), round(self.delay_s[1] / self.control_period_s)

    @property
    def episode_steps(self) -> int:
        """Control steps in an episode."""
        return max(1, round(self.duration_s / self.control_period_s))

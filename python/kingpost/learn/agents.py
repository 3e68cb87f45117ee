"""Distribution of a task's actions among several controllers."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..errors import KingpostError
from .task import Columns, Goal, Task


@dataclass(frozen=True)
class Agent:
    """One of several controllers of a task.

    Parameters
    ----------
    actions
        The actions of the task that it sets, by name.
    observations
        The observations of the task that it sees, by name; default: all.
    reward
        Reward function as in a `Task`, of columns, goal and the actions of all agents in the order of the
        task. Default: the reward of the task, common to all agents.

    Examples
    --------
    >>> from kingpost.learn import Agent
    >>> Agent(["hoist"], ["height_error", "lift.velocity.z"]).actions
    ['hoist']
    """

    actions: Sequence[str]
    observations: Sequence[str] | None = None
    reward: Callable[[Columns, Goal, np.ndarray], np.ndarray] | None = None


@dataclass(frozen=True)
class Share:
    """Share of an agent in a task: indices of its actions and observations, and its reward."""

    sets: np.ndarray
    sees: np.ndarray
    reward: Callable[[Columns, Goal, np.ndarray], np.ndarray] | None


def one_for_each_action(task: Task) -> dict[str, Agent]:
    """Make one agent for each action, with the action's name, that observes everything.

    >>> from kingpost.learn import three_axis
    >>> list(one_for_each_action(three_axis()))
    ['slewing', 'luffing', 'hoist']
    """
    return {name: Agent([name]) for name in task.action_names}


def places(task: Task, agents: Mapping[str, Agent | Sequence[str]]) -> dict[str, Share]:
    """Compute the share of each agent.

    Raises
    ------
    KingpostError
        If an action has no agent or several, or a name is unknown.

    >>> from kingpost.learn import three_axis
    >>> places(three_axis(), {"boom": ["slewing", "luffing"], "winch": ["hoist"]})["boom"].sets
    array([0, 1])
    """
    found: dict[str, Share] = {}
    agent_of: dict[str, str] = {}
    for name, given in agents.items():
        agent = given if isinstance(given, Agent) else Agent(given)
        sets = _indices(f"agent {name}, actions", agent.actions, task.action_names)
        for action in agent.actions:
            if action in agent_of:
                raise KingpostError(
                    f"agent {name}: found action {action}, allowed: one agent for each action, and it has "
                    f"{agent_of[action]}"
                )
            agent_of[action] = name
        seen = task.observation_names if agent.observations is None else agent.observations
        sees = _indices(f"agent {name}, observations", seen, task.observation_names)
        found[name] = Share(sets, sees, agent.reward)
    if missing := [name for name in task.action_names if name not in agent_of]:
        raise KingpostError(f"agents: found none for action {missing[0]}, allowed: one for each action")
    return found


def _indices(what: str, names: Sequence[str], known: Sequence[str]) -> np.ndarray:
    if isinstance(names, str) or not names:
        raise KingpostError(f"{what}: found {names!r}, allowed: a list of at least one name")
    for name in names:
        if name not in known:
            raise KingpostError(f"{what}: found {name}, allowed: {', '.join(known)}")
    return np.array([known.index(name) for name in names])

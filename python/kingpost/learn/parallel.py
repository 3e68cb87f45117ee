"""Several controllers that share a task, in the interface of PettingZoo; it needs the extra `pettingzoo`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import gymnasium
import numpy as np
from gymnasium.utils import seeding
from pettingzoo import ParallelEnv

from ..errors import KingpostError
from .agents import Agent, one_for_each_action, places
from .episodes import Episodes, check_options, checked_rewards
from .task import LARGEST_OBSERVATION, Task


class ShipCraneParallelEnv(ParallelEnv[str, np.ndarray, np.ndarray]):
    """A task on any scenario whose actions are distributed among agents that act simultaneously.

    The episodes are those of `ShipCraneEnv` with the same seed and the same actions, to the last bit. All
    agents end at the same time.

    Parameters
    ----------
    task
        The task.
    agents
        Each agent by its name: an `Agent`, or the names of its actions. Each action of the task has
        one agent. Default: an agent for each action, with its name.
    max_episode_steps
        Control steps in an episode; default: those of the task's duration.

    Raises
    ------
    KingpostError
        If an action has no agent or several, or a name is unknown.

    Examples
    --------
    >>> from kingpost.learn import Agent, ShipCraneParallelEnv, three_axis
    >>> env = ShipCraneParallelEnv(three_axis(), {
    ...     "boom": ["slewing", "luffing"],
    ...     "winch": Agent(["hoist"], ["height_error", "lift.velocity.z", "winch.joint_velocity"]),
    ... })
    >>> seen, infos = env.reset(seed=1)
    >>> {agent: own.shape for agent, own in seen.items()}
    {'boom': (14,), 'winch': (3,)}
    >>> actions = {"boom": np.zeros(2, dtype=np.float32), "winch": np.ones(1, dtype=np.float32)}
    >>> seen, rewards, terminations, truncations, infos = env.step(actions)
    >>> rewards["boom"] == rewards["winch"] < 0
    True
    """

    def __init__(
        self,
        task: Task,
        agents: Mapping[str, Agent | Sequence[str]] | None = None,
        max_episode_steps: int | None = None,
    ) -> None:
        self.metadata = {"name": "kingpost", "render_modes": []}
        self.render_mode = None
        self.task = task
        self.shares = places(task, one_for_each_action(task) if agents is None else agents)
        self.possible_agents = list(self.shares)
        self.agents: list[str] = []
        largest, box = LARGEST_OBSERVATION, gymnasium.spaces.Box
        self.observation_spaces = {
            name: box(-largest, largest, (len(share.sees),), np.float32)
            for name, share in self.shares.items()
        }
        self.action_spaces = {
            name: box(-1.0, 1.0, (len(share.sets),), np.float32) for name, share in self.shares.items()
        }
        self.episodes = Episodes(task, 1, 1, max_episode_steps)
        self._random: np.random.Generator | None = None

    def observation_space(self, agent: str) -> gymnasium.spaces.Space[np.ndarray]:
        """The space of an agent's observations."""
        return self.observation_spaces[agent]

    def action_space(self, agent: str) -> gymnasium.spaces.Space[np.ndarray]:
        """The space of an agent's actions."""
        return self.action_spaces[agent]

    def reset(
        self, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[dict[str, np.ndarray], dict[str, dict[str, Any]]]:
        """Begin an episode; the same seed gives the same episode to the last bit. There are no options."""
        # PettingZoo's checker passes an option named `options`.
        check_options(options, "options")
        if seed is not None or self._random is None:
            self._random = seeding.np_random(seed)[0]
        self.episodes.begin({0: self._random})
        self.agents = list(self.possible_agents)
        return self._shared(self.state()), {name: {} for name in self.agents}

    def step(
        self, actions: Mapping[str, np.ndarray]
    ) -> tuple[
        dict[str, np.ndarray],
        dict[str, float],
        dict[str, bool],
        dict[str, bool],
        dict[str, dict[str, Any]],
    ]:
        """Take a control step with the actions of all agents.

        Raises
        ------
        KingpostError
            If an agent's actions are missing, or an action is NaN or not within -1 to 1.
        """
        if not self.agents:
            raise KingpostError("step: found no agent in an episode, allowed: after reset()")
        given = self._joined(actions)
        seen, rewards, terminated, truncated = self.episodes.step(given)
        agents, info = self.agents, {"ended_by": self.episodes.ended_by(0)} if terminated[0] else {}
        if terminated[0] or truncated[0]:
            self.agents = []
        return (
            self._shared(seen[0]),
            {name: self._reward(name, given, float(rewards[0])) for name in agents},
            dict.fromkeys(agents, bool(terminated[0])),
            dict.fromkeys(agents, bool(truncated[0])),
            {name: dict(info) for name in agents},
        )

    def state(self) -> np.ndarray:
        """All observations of the task, for centralised training."""
        return self.episodes.observations()[0]

    def _joined(self, actions: Mapping[str, np.ndarray]) -> np.ndarray:
        """Join the actions of all agents in the order of the task."""
        if set(actions) != set(self.agents):
            raise KingpostError(f"actions: found those of {list(actions)}, allowed: {self.agents}")
        joined = np.empty((1, len(self.task.set)))
        for name, share in self.shares.items():
            own = np.asarray(actions[name])
            if own.shape != (len(share.sets),):
                raise KingpostError(
                    f"actions of {name}: found the shape {own.shape}, allowed: {(len(share.sets),)}"
                )
            joined[0, share.sets] = own
        return joined

    def _shared(self, seen: np.ndarray) -> dict[str, np.ndarray]:
        return {name: seen[share.sees] for name, share in self.shares.items()}

    def _reward(self, name: str, actions: np.ndarray, of_task: float) -> float:
        own, episodes = self.shares[name].reward, self.episodes
        if own is None or episodes.goals is None or episodes.failed(0):
            return of_task
        return float(checked_rewards(own(episodes.columns, episodes.goals, actions), 1)[0])

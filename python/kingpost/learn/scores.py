"""Scores of controllers, and the table of all of them."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from .benchmarks import benchmarks
from .policies import Policy
from .registered import IDS
from .task import Task
from .tasks import anti_sway
from .vector import ShipCraneVectorEnv

EPISODES = 16
FIRST_SEED = 50_000
"""First seed of the scored episodes: do not train with these seeds."""


def score(
    task: Task,
    policy: Callable[[Task], Policy],
    episodes: int = EPISODES,
    seed: int = FIRST_SEED,
    threads: int = 0,
) -> np.ndarray:
    """Compute the sum of rewards of each of many episodes under a controller.

    Parameters
    ----------
    task
        The task.
    policy
        Function that makes the controller.
    episodes
        Number of episodes; episode i has the seed `seed` + i.
    seed
        The first seed.
    threads
        Threads that compute; 0 takes as many as the machine has.

    Returns
    -------
    numpy.ndarray
        Sum of rewards of each episode.

    >>> from kingpost.learn import BASELINES, anti_sway
    >>> bool(score(anti_sway(), BASELINES["Kingpost/AntiSway-v0"]["do nothing"], 2).mean() < 0)
    True
    """
    envs = ShipCraneVectorEnv(task, episodes, threads)
    seen, _ = envs.reset(seed=seed)
    acts, sums, going = policy(task), np.zeros(episodes), np.ones(episodes, dtype=np.bool_)
    for _ in range(task.episode_steps):
        seen, rewards, terminated, truncated, _ = envs.step(np.asarray(acts(seen)))
        sums += np.where(going, rewards, 0.0)
        going &= ~(terminated | truncated)
        if not going.any():
            break
    return sums


def cases() -> dict[str, tuple[Task, dict[str, Callable[[Task], Policy]]]]:
    """Return the tasks that are scored, by title, each with its controllers."""
    found = {}
    for name, task in IDS.items():
        found[name] = (task(), benchmarks(name))
        if task is anti_sway:
            found[f"{name}, on_a_ship=True"] = (anti_sway(on_a_ship=True), benchmarks(name))
            found[f"{name}, at_sea=True"] = (anti_sway(at_sea=True), benchmarks(name, at_sea=True))
    return found


def table(episodes: int = EPISODES) -> str:
    """Table of the scores of all controllers in Markdown, the best first."""
    lines = []
    for name, (task, policies) in cases().items():
        found = {label: score(task, policy, episodes) for label, policy in policies.items()}
        ordered = sorted(found.items(), key=lambda pair: -float(pair[1].mean()))
        lines += [
            f"**{name}**",
            "",
            "| controller | mean | standard deviation | worst |",
            "| --- | --- | --- | --- |",
        ]
        lines += [
            f"| {label} | {sums.mean():.2f} | {sums.std():.2f} | {sums.min():.2f} |"
            for label, sums in ordered
        ]
        lines.append("")
    return "\n".join(lines)

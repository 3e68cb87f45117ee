"""Several agents that share a task: PettingZoo's checks, the single environment, invalid distributions of
actions."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import kingpost.learn
import numpy as np
import pytest
from kingpost.errors import KingpostError
from kingpost.learn import (
    BASELINES,
    Agent,
    ShipCraneEnv,
    ShipCraneParallelEnv,
    Task,
    landing,
    roll_reduction,
    three_axis,
)
from lanes import sampled
from pettingzoo.test import api_test, parallel_api_test, parallel_seed_test
from pettingzoo.utils import parallel_to_aec

SEED = 11
SPLITS = {
    "three drives": (three_axis, None),
    "boom and winch": (
        three_axis,
        {"boom": ["luffing", "slewing"], "winch": Agent(["hoist"], ["height_error", "lift.velocity.z"])},
    ),
    "two gyros": (roll_reduction, None),
    "one agent": (landing, None),
}

KEPT = ["two gyros"]


def made(name: str, steps: int = 25) -> ShipCraneParallelEnv:
    task, agents = SPLITS[name]
    return ShipCraneParallelEnv(task(), agents, steps)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("name", sampled(SPLITS, keep=KEPT))
def test_pettingzoo_s_checker_finds_nothing(name: str) -> None:
    parallel_api_test(made(name), 60)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("name", sampled(SPLITS, keep=KEPT))
def test_pettingzoo_s_check_of_seeds_finds_nothing(name: str) -> None:
    parallel_seed_test(lambda: made(name), 25)


# It recommends names with a number, as of equal players; these are the names of the drives.
@pytest.mark.filterwarnings("ignore:We recommend agents to be named")
def test_the_agents_take_turns_behind_pettingzoo_s_conversion() -> None:
    api_test(parallel_to_aec(made("three drives")), 60)


@pytest.mark.parametrize("name", sampled(SPLITS, keep=KEPT))
def test_an_episode_of_agents_is_that_of_the_single_environment_to_the_last_bit(name: str) -> None:
    shared = made(name)
    task = shared.task
    alone = ShipCraneEnv(task, 25)
    seen, _ = shared.reset(seed=SEED)
    whole, _ = alone.reset(seed=SEED)
    random = np.random.default_rng(5)
    while shared.agents:
        for agent, share in shared.shares.items():
            assert np.array_equal(seen[agent], whole[share.sees])
        assert np.array_equal(shared.state(), whole)
        action = random.uniform(-1, 1, len(task.set)).astype(np.float32)
        split = {agent: action[share.sets] for agent, share in shared.shares.items()}
        seen, rewards, terminations, truncations, _ = shared.step(split)
        whole, reward, terminated, truncated, _ = alone.step(action)
        assert set(rewards.values()) == {reward}
        assert set(terminations.values()) == {terminated}
        assert set(truncations.values()) == {truncated}
    assert truncated


def test_a_seed_is_an_episode_and_without_one_the_next_is_another() -> None:
    shared = made("two gyros")
    nothing = {agent: np.zeros(1, dtype=np.float32) for agent in shared.possible_agents}

    def last(seed: int | None) -> np.ndarray:
        shared.reset(seed=seed)
        while shared.agents:
            shared.step(nothing)
        return shared.state()

    first, second = last(SEED), last(None)
    assert not np.array_equal(first, second)
    assert np.array_equal(first, last(SEED))
    assert np.array_equal(second, last(None))


@pytest.mark.thorough
def test_three_agents_that_know_their_own_axis_only_do_as_well_as_one_controller_of_all() -> None:
    """The parts of the baseline, each from its own observations, give the baseline's sum of rewards."""
    task = three_axis()
    policy = BASELINES["Kingpost/ThreeAxis-v0"]["tip and height"](task)
    own = {
        "slewing": ["reach", "error_across", "speed_across", "slew.joint_velocity"],
        "luffing": ["tip_rise_over_foot", "error_along", "speed_along", "luff.joint_velocity"],
        "hoist": ["height_error", "lift.velocity.z", "winch.joint_velocity"],
    }
    shared = ShipCraneParallelEnv(task, {name: Agent([name], names) for name, names in own.items()}, 200)
    alone = ShipCraneEnv(task, 200)
    seen, _ = shared.reset(seed=SEED)
    whole, _ = alone.reset(seed=SEED)
    by_agents = by_one = 0.0
    while shared.agents:
        actions = {}
        for agent, share in shared.shares.items():
            # What the others see is 1 here, and does not count.
            known = np.ones((1, len(task.seen)), dtype=np.float32)
            known[0, share.sees] = seen[agent]
            actions[agent] = policy(known)[0, share.sets]
        seen, rewards, *_ = shared.step(actions)
        whole, reward, *_ = alone.step(policy(whole[None])[0])
        by_agents, by_one = by_agents + rewards["hoist"], by_one + reward
    assert by_agents == by_one < 0


def test_agents_can_have_rewards_of_their_own() -> None:
    effort = lambda columns, goal, actions: -actions[:, 1] * actions[:, 1]  # noqa: E731
    winch = Agent(
        ["hoist"], ["height_error"], lambda columns, goal, actions: -abs(columns["lift.velocity.z"])
    )
    env = ShipCraneParallelEnv(
        three_axis(), {"slew": ["slewing"], "luff": Agent(["luffing"], None, effort), "winch": winch}
    )
    env.reset(seed=SEED)
    given = {"slew": np.zeros(1), "luff": np.full(1, 0.5), "winch": np.zeros(1)}
    rewards = env.step(given)[1]
    assert rewards["luff"] == -0.25
    assert rewards["winch"] == -abs(env.episodes.columns["lift.velocity.z"][0])
    assert rewards["slew"] == env.task.reward(env.episodes.columns, env.episodes.goals, np.zeros((1, 3)))[0]


def test_an_episode_that_fails_ends_for_all_agents_with_the_failure_s_reward() -> None:
    task = three_axis(randomised=False)
    fragile = Task(
        task.based_on.with_overrides({"simulation.rate_limit": 0.2}),
        task.actions,
        ["hull.roll"],
        reward=lambda columns, goal, actions: columns["hull.roll"],
        control_period_s=0.1,
    )
    zero = lambda columns, goal, actions: 0.0 * columns["hull.roll"]  # noqa: E731
    env = ShipCraneParallelEnv(
        fragile, {"boom": ["slewing", "luffing"], "winch": Agent(["hoist"], None, zero)}
    )
    env.reset(seed=SEED)
    while env.agents:
        _, rewards, terminations, _, infos = env.step({"boom": np.zeros(2), "winch": np.ones(1)})
    assert rewards == {"boom": -100.0, "winch": -100.0}
    assert terminations == {"boom": True, "winch": True}
    assert infos["winch"]["ended_by"].startswith("diverged at ")
    with pytest.raises(KingpostError, match="found no agent in an episode, allowed: after reset"):
        env.step({})


@pytest.mark.parametrize(
    ("agents", "message"),
    [
        (
            {"boom": ["slewing", "luffing"]},
            "agents: found none for action hoist, allowed: one for each action",
        ),
        (
            {"boom": ["slewing", "luffing"], "winch": ["hoist", "luffing"]},
            "agent winch: found action luffing, allowed: one agent for each action, and it has boom",
        ),
        ({"boom": ["slew"]}, "agent boom, actions: found slew, allowed: slewing, luffing, hoist"),
        ({"boom": "slewing"}, "agent boom, actions: found 'slewing', allowed: a list of at least one name"),
        ({"boom": Agent(["slewing"], ["roll"])}, "agent boom, observations: found roll, allowed: reach, "),
        ({"boom": Agent(["slewing"], [])}, "agent boom, observations: found [], allowed: a list of at least"),
    ],
)
def test_an_invalid_distribution_of_actions_is_refused_with_the_allowed_ones(
    agents: dict, message: str
) -> None:
    with pytest.raises(KingpostError, match=re.escape(message)):
        ShipCraneParallelEnv(three_axis(), agents)


def test_actions_that_are_missing_or_of_another_shape_are_refused_by_agent() -> None:
    env = made("two gyros")
    env.reset(seed=SEED)
    port, starboard = env.agents
    with pytest.raises(KingpostError, match="actions: found those of"):
        env.step({port: np.zeros(1)})
    with pytest.raises(
        KingpostError, match=rf"actions of {starboard}: found the shape \(2,\), allowed: \(1,\)"
    ):
        env.step({port: np.zeros(1), starboard: np.zeros(2)})
    with pytest.raises(KingpostError, match=rf"action {starboard}: found nan, allowed: -1 to 1"):
        env.step({port: np.zeros(1), starboard: np.full(1, np.nan)})


def test_without_pettingzoo_the_error_names_the_extra(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delitem(sys.modules, "kingpost.learn.parallel")
    monkeypatch.setitem(sys.modules, "pettingzoo", None)
    with pytest.raises(KingpostError, match=r'found no PettingZoo, allowed: with pip install "kingpost\[pet'):
        _ = kingpost.learn.ShipCraneParallelEnv
    assert not hasattr(kingpost.learn, "ShipCraneParallelEnvs")
    assert "ShipCraneParallelEnv" not in kingpost.learn.__all__


def test_the_example_of_the_page_runs() -> None:
    page = (Path(__file__).parents[2] / "docs" / "learning.md").read_text(encoding="utf-8")
    (block,) = (text for text in re.findall(r"```python\n(.*?)```", page, re.DOTALL) if "ParallelEnv" in text)
    exec(compile(block, "docs/learning.md", "exec"), {})

"""The policy trained on a ship in waves: its score, unused seas, and its observations."""

from __future__ import annotations

import numpy as np
import pytest
from kingpost.errors import KingpostError
from kingpost.learn import (
    BASELINES,
    NeuralPolicy,
    ShipCraneVectorEnv,
    anti_sway,
    anti_sway_at_sea,
    benchmarks,
    score,
    trained,
)

ENVIRONMENT = "Kingpost/AntiSwayAtSea-v0"
UNUSED = {"episodes": 32, "seed": 70_000}
"""Episodes, each with its sea, that are in no training, tuning or table."""


@pytest.fixture(scope="module")
def policy() -> NeuralPolicy:
    return trained(ENVIRONMENT)


@pytest.fixture(scope="module")
def learned(policy) -> float:
    return float(score(anti_sway_at_sea(), policy.of, **UNUSED).mean())


def test_the_stored_weights_give_the_stored_score(policy) -> None:
    """Tolerance: tanh of another processor differs by a rounding unit, which 800 steps keep below 1e-6."""
    found = score(anti_sway_at_sea(), policy.of)
    assert found.mean() == pytest.approx(policy.about["score"]["mean"], abs=1e-6)
    assert found.min() == pytest.approx(policy.about["score"]["worst"], abs=1e-6)


@pytest.mark.thorough
def test_on_unused_seas_the_policy_beats_classical_controllers_and_the_policy_of_the_fixed_base(
    learned,
) -> None:
    """Source: docs/learning.md, measured on other seas: PID is 8 behind, the other policy 4 to 5."""
    others = BASELINES[ENVIRONMENT] | {"fixed base": trained("Kingpost/AntiSway-v0").of}
    best = max(score(anti_sway_at_sea(), make, **UNUSED).mean() for make in others.values())
    assert learned > best + 2.0


@pytest.mark.thorough
def test_on_unused_seas_the_policy_beats_linear_predictive_control(policy) -> None:
    """Four episodes, because each plan is a quadratic program."""
    few = {"episodes": 4, "seed": 70_000}
    predictive = benchmarks(ENVIRONMENT)["predictive (`kingpost.mpc`)"]
    assert (
        score(anti_sway_at_sea(), policy.of, **few).mean()
        > score(anti_sway_at_sea(), predictive, **few).mean()
    )


def test_each_episode_has_its_own_sea_and_one_seed_always_the_same() -> None:
    envs = ShipCraneVectorEnv(anti_sway_at_sea(), 3, 2)
    rolls = []
    for seeds in ([1, 2, 3], [2, 1, 3]):
        envs.reset(seed=seeds)
        for _ in range(100):
            envs.step(np.zeros((3, 2)))
        rolls.append(envs.episodes.columns["hull.yaw"].copy())
    assert np.array_equal(rolls[0][[1, 0, 2]], rolls[1])
    assert len(set(rolls[0])) == 3


def test_the_observations_over_the_ground_are_the_rotated_position_and_velocity_of_the_load() -> None:
    task = anti_sway_at_sea()
    envs = ShipCraneVectorEnv(task, 2, 1)
    envs.reset(seed=5)
    for _ in range(60):
        envs.step(np.full((2, 2), 0.4))
    columns, goals = envs.episodes.columns, envs.episodes.goals
    now = {one.name: one.value(columns, goals) for one in task.seen[-4:]}
    off = [columns[f"load.position.{axis}"] - goals[:, 2 + k] for k, axis in enumerate("xy")]
    speed = [columns[f"load.velocity.{axis}"] for axis in "xy"]
    for name, parts in (("off", off), ("speed", speed)):
        along, across = now[f"load_{name}_along"], now[f"load_{name}_across"]
        assert np.allclose(along**2 + across**2, np.square(parts).sum(axis=0), rtol=1e-12)
    heading = columns["hull.yaw"] + columns["slew.joint_position"]
    assert np.allclose(now["load_off_along"], off[0] * np.cos(heading) + off[1] * np.sin(heading), rtol=1e-12)


def test_a_policy_acts_the_same_in_a_task_with_more_observations() -> None:
    few, more = anti_sway(at_sea=True), anti_sway_at_sea()
    policy = trained("Kingpost/AntiSway-v0")
    seen = np.random.default_rng(1).normal(size=(5, len(more.seen)))
    own = policy(seen[:, : len(few.seen)])
    assert np.array_equal(policy.of(more)(seen), own)
    assert np.allclose(policy.begun_for(more, ENVIRONMENT)(seen), own, atol=1e-15)


def test_a_task_without_the_observations_of_a_policy_is_refused(policy) -> None:
    with pytest.raises(KingpostError, match="allowed: a task with load_off_along, load_off_across"):
        policy.of(anti_sway())

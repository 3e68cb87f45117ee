"""Landing on a deck in the sea: its reward and end by hand, its bits, and what its controllers score."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from gymnasium.vector import SyncVectorEnv
from kingpost.learn import BASELINES, ShipCraneEnv, ShipCraneVectorEnv, landing, score
from kingpost.learn.tasks.landing import DECK_RATE, LOAD_RATE

NAME = "Kingpost/Landing-v0"
SEED = 11
GAP, IMPULSE = "cargo_deck.contact_gap", "cargo_deck.contact_impulse"
STRETCH = "hoist_rope.rope_stretch"


def lowered(envs, steps: int, speeds: np.ndarray) -> list[list[np.ndarray]]:
    """Observations, rewards and ends of every step at these speeds of the winch."""
    first, _ = envs.reset(seed=SEED)
    return [[first], *([np.array(part) for part in envs.step(speeds[:, None])[:4]] for _ in range(steps))]


def same(one: list, other: list, rows: slice = slice(None)) -> bool:
    return all(
        np.array_equal(a[rows], b[rows])
        for left, right in zip(one, other, strict=True)
        for a, b in zip(left, right, strict=True)
    )


@pytest.fixture(scope="module")
def landed() -> tuple[list[dict[str, float]], list[float], str]:
    """The columns and rewards of an episode at half speed, and why it ended."""
    env = ShipCraneEnv(landing())
    env.reset(seed=SEED)
    rows, rewards, ended = [{name: float(v[0]) for name, v in env.episodes.columns.items()}], [], False
    while not ended:
        _, reward, ended, truncated, info = env.step(np.array([0.5], dtype=np.float32))
        assert not truncated
        rows.append({name: float(values[0]) for name, values in env.episodes.columns.items()})
        rewards.append(reward)
    return rows, rewards, info["ended_by"]


def test_a_landing_ends_on_the_deck_with_half_a_metre_of_slack_on_each_fall(landed) -> None:
    rows, _, why = landed
    assert why == "done"
    assert rows[-1][STRETCH] <= -2.0 < rows[-2][STRETCH]
    assert rows[-1][GAP] <= 0.02
    assert rows[-1][IMPULSE] > rows[-2][IMPULSE] > 0.0 == rows[0][IMPULSE]


def test_columns_before_a_step_equal_those_after_the_previous_step(landed) -> None:
    rows, _, _ = landed
    for earlier, later in pairwise(rows):
        assert all(later[f"before.{name}"] == earlier[name] for name in (GAP, IMPULSE, STRETCH, LOAD_RATE))
    assert rows[0][f"before.{GAP}"] == rows[0][GAP]


def test_the_reward_counts_time_height_and_the_speed_of_each_impact(landed) -> None:
    rows, rewards, _ = landed
    impacts = 0
    for (earlier, later), reward in zip(pairwise(rows), rewards, strict=True):
        expected = -0.01 - 0.005 * max(later[GAP], 0.0)
        if earlier[GAP] > 0 and later[IMPULSE] > earlier[IMPULSE]:
            expected -= 20 * max(earlier[DECK_RATE] - earlier[LOAD_RATE], 0.0) ** 2
            impacts += 1
        if earlier[IMPULSE] > 0:
            expected -= 0.1 * (later[GAP] > 0.02) + 0.5 * (earlier[STRETCH] <= 0 < later[STRETCH])
        assert reward == pytest.approx(expected, rel=1e-12)
    assert impacts >= 1


def test_the_speed_of_the_first_impact_is_the_rate_of_the_gap_before_it(landed) -> None:
    """Within the relative acceleration of load and deck over a control step, and the deck's slope."""
    rows, _, _ = landed
    touch = next(k for k, row in enumerate(rows) if row[IMPULSE] > 0)
    rate = (rows[touch - 2][GAP] - rows[touch - 1][GAP]) / 0.1
    speed = rows[touch - 1][DECK_RATE] - rows[touch - 1][LOAD_RATE]
    assert speed > 0.2
    assert speed == pytest.approx(rate, abs=0.06)


@pytest.mark.parametrize("mode", ["SameStep", "NextStep"])
def test_landings_have_the_same_bits_whatever_the_threads_and_the_number_of_environments(mode: str) -> None:
    """Over ends that come at different times, and new episodes behind them."""
    speeds = np.array([0.9, 1.0, 0.8, 0.6, 0.95], dtype=np.float32)
    few = ShipCraneVectorEnv(landing(), 2, 1, mode)
    many = ShipCraneVectorEnv(landing(), 5, 2, mode)
    one, other = lowered(few, 130, speeds[:2]), lowered(many, 130, speeds)
    assert np.sum([step[2][:2] for step in one[1:]]) >= 2
    assert same(one, other, slice(0, 2))


@pytest.mark.parametrize("mode", ["SameStep", "NextStep"])
def test_the_native_vector_lands_as_gymnasium_s_over_single_environments(mode: str) -> None:
    speeds = np.array([1.0, 0.9], dtype=np.float32)
    native = ShipCraneVectorEnv(landing(), 2, 1, mode)
    peer = SyncVectorEnv([lambda: ShipCraneEnv(landing())] * 2, autoreset_mode=native.autoreset_mode)
    assert same(lowered(native, 125, speeds), lowered(peer, 125, speeds))


def test_a_load_that_leaves_the_deck_again_lowers_the_reward(landed) -> None:
    env = ShipCraneEnv(landing())
    env.reset(seed=SEED)
    touch = next(k for k, row in enumerate(landed[0]) if row[IMPULSE] > 0)
    rewards = [
        env.step(np.array([0.5 if k < touch else -1.0], dtype=np.float32))[1] for k in range(touch + 40)
    ]
    assert env.episodes.columns[GAP][0] > 0.02
    assert rewards[-1] < -0.1


@pytest.mark.thorough
def test_a_quiet_moment_beats_constant_lowering_and_a_winch_that_follows_the_deck_beats_both() -> None:
    policies = BASELINES[NAME]
    labels = ["do nothing", "constant lowering", "wait for a quiet moment", "follow the deck"]
    means = [score(replace(landing(), duration_s=30.0), policies[label], 4).mean() for label in labels]
    assert means == sorted(means)
    assert means[-1] > 0.5 * means[1]


def test_observations_of_the_landing_have_units() -> None:
    task = landing()
    units = dict(zip(task.observation_names, task.observation_units, strict=True))
    assert units["height_over_deck"] == units["deck_heave"] == units["slack"] == "m"
    assert units["relative_speed"] == units["tip_heave_rate"] == "m/s"
    assert units["hook_load"] == units["deck_force"] == "N"
    assert task.action_units == ("rad/s",)

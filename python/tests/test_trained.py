"""Trained policies: reproducible bits, stored scores, comparison with classical controllers, errors."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from kingpost.errors import KingpostError
from kingpost.learn import (
    BASELINES,
    IDS,
    NeuralPolicy,
    ShipCraneVectorEnv,
    Training,
    anti_sway,
    benchmarks,
    read_policy,
    score,
    train,
    trained,
)
from kingpost.learn.__main__ import main
from kingpost.learn.benchmarks import CALM
from kingpost.learn.cem_mpc import cem_mpc
from kingpost.learn.cross_entropy import CrossEntropy, Sampling
from kingpost.learn.episodes import Episodes

ENVIRONMENT = "Kingpost/AntiSway-v0"
FEW = Training(generations=2, pairs=2, episodes=2, hidden=(4,), seed=5)


@pytest.fixture(scope="module")
def policy() -> NeuralPolicy:
    return trained(ENVIRONMENT)


def test_the_same_seed_trains_the_same_weights_whatever_the_threads() -> None:
    one, other = (train(anti_sway(), ENVIRONMENT, FEW, threads=threads) for threads in (1, 2))
    assert np.array_equal(one.numbers, other.numbers)
    assert np.abs(one.numbers).max() > 0


def test_the_stored_weights_give_the_stored_score(policy) -> None:
    """Tolerance: tanh of another processor differs by a rounding unit, which 800 steps keep below 1e-6."""
    found = score(anti_sway(), lambda task: policy)
    assert found.mean() == pytest.approx(policy.about["score"]["mean"], abs=1e-6)
    assert found.min() == pytest.approx(policy.about["score"]["worst"], abs=1e-6)


@pytest.mark.thorough
def test_the_policy_beats_every_classical_controller_on_unused_seeds(policy) -> None:
    """Source: 16 episodes that are in no training, tuning or table."""
    given = {"episodes": 16, "seed": 70_000}
    learned = score(anti_sway(), lambda task: policy, **given).mean()
    classical = {
        name: score(anti_sway(), make, **given).mean() for name, make in BASELINES[ENVIRONMENT].items()
    }
    assert learned > max(classical.values())


@pytest.mark.thorough
def test_the_policy_is_within_ten_percent_of_predictive_control(policy) -> None:
    """Source: the target of this project; four episodes, because each plan is a quadratic program."""
    given = {"episodes": 4, "seed": 70_000}
    learned = score(anti_sway(), lambda task: policy, **given).mean()
    assert (
        learned
        > 1.1 * score(anti_sway(), benchmarks(ENVIRONMENT)["predictive (`kingpost.mpc`)"], **given).mean()
    )


def test_the_file_of_a_policy_has_the_names_of_its_environment(policy) -> None:
    task = anti_sway()
    assert (policy.observations, policy.units) == (task.observation_names, task.observation_units)
    assert (policy.actions, policy.action_units) == (task.action_names, task.action_units)
    assert np.array(policy.bounds) == pytest.approx(np.array(task.bounds))
    assert policy.control_period_s == task.control_period_s


def test_the_file_of_a_policy_reads_back_equal(policy, tmp_path) -> None:
    policy.save(tmp_path / "policy.json")
    again = read_policy(tmp_path / "policy.json")
    assert again.json() == policy.json()
    assert np.array_equal(again.numbers, policy.numbers)


def test_the_command_trains_and_writes_a_file(tmp_path, capsys) -> None:
    words = ["--generations", "1", "--pairs", "1", "--episodes", "1", "--hidden", "3"]
    main(["train", str(tmp_path / "mine.json"), *words])
    mine = read_policy(tmp_path / "mine.json")
    assert mine.layers[0][0].shape == (3, 12)
    assert mine.about["training"]["generations"] == 1
    assert "mean score" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("change", "expected"),
    [
        (lambda file: file.pop("layers"), "found no policy"),
        (lambda file: file["layers"][0]["biases"].pop(), r"layers.0: found weights of the shape \(16, 12\)"),
        (lambda file: file["layers"].pop(), "layers: found 16 outputs, allowed: 2"),
        (lambda file: file["layers"][0]["biases"].__setitem__(0, float("nan")), "layers.0: found NaN"),
    ],
)
def test_a_wrong_file_is_reported(change, expected, policy, tmp_path) -> None:
    file = json.loads(policy.json())
    change(file)
    (tmp_path / "policy.json").write_text(json.dumps(file), encoding="utf-8")
    with pytest.raises(KingpostError, match=expected):
        read_policy(tmp_path / "policy.json")


@pytest.mark.thorough
@pytest.mark.parametrize("environment", [ENVIRONMENT, "Kingpost/AntiSwayAtSea-v0"])
def test_the_page_has_every_controller_and_the_scores_that_are_measured_now(environment: str) -> None:
    """Source: the same seeds. Those that plan are slow: their rows are only looked for."""
    page = (Path(__file__).parents[2] / "docs" / "learning.md").read_text(encoding="utf-8")
    of_task = page.split(f"**{environment}**")[1].split("\n**")[0]
    rows = dict(line.strip("| ").split(" | ", 1) for line in of_task.splitlines() if line.startswith("| "))
    for name, make in benchmarks(environment).items():
        assert name in rows
        if "predictive" not in name and name != "do nothing":
            sums = score(IDS[environment](), make)
            assert rows[name] == f"{sums.mean():.2f} | {sums.std():.2f} | {sums.min():.2f}"


def test_plans_by_sampling_have_the_same_bits_for_any_number_of_threads() -> None:
    few = Sampling(horizon_s=2, guided_s=1, knots=4, candidates=8, elites=3, iterations=2, every_s=0.25)
    goal = [1.0, -0.8, 11.3, 17.6]
    one, other = (CrossEntropy(anti_sway(), goal, few, threads=threads) for threads in (1, 2))
    taken = [np.array([plan.action() for _ in range(8)]) for plan in (one, other)]
    assert np.array_equal(*taken)
    assert not np.array_equal(taken[0], np.array([CrossEntropy(anti_sway(), goal, few).action()] * 8))


@pytest.mark.thorough
def test_sampled_plans_beat_their_guide_policy_on_a_moving_base() -> None:
    """Source: the plan of zeros, the policy itself, is among the candidates, and the model is the engine."""
    task = replace(anti_sway(on_a_ship=True), duration_s=16.0)
    few = Sampling(horizon_s=4, guided_s=4, candidates=12, elites=4, iterations=2, every_s=1.0)
    with_plans = score(task, lambda task: cem_mpc(task, few), 2)
    alone = score(task, lambda _: trained(ENVIRONMENT), 2)
    assert (with_plans > alone + 1.0).all(), f"{with_plans} against {alone}"


def test_the_copies_of_a_plan_have_the_bits_of_the_scenario() -> None:
    """Source: the same bits: what the copies took is what an environment takes with the same actions."""
    few = Sampling(horizon_s=1, guided_s=0, knots=2, candidates=6, elites=2, iterations=1, every_s=0.25)
    envs = ShipCraneVectorEnv(anti_sway(), 1, 1)
    seen, _ = envs.reset(seed=3)
    plan = CrossEntropy(anti_sway(), envs.episodes.goals[0].tolist(), few)
    for _ in range(12):
        seen, *_ = envs.step(plan.action()[None])
        plan.copies.resume()
        assert np.array_equal(plan.copies.observations(), np.tile(seen, (6, 1)))


def test_plans_without_knowledge_of_the_waves_start_from_the_true_state() -> None:
    """Source: the same bits. The last copy meets the ship's own sea, the others calm water from her state."""
    few = Sampling(horizon_s=1, guided_s=0, knots=2, candidates=6, elites=2, iterations=1, every_s=0.25)
    envs = ShipCraneVectorEnv(anti_sway(at_sea=True), 1, 1)
    seen, _ = envs.reset(seed=3)
    plan = CrossEntropy(envs.task, envs.episodes.goals[0].tolist(), few, foreseen=CALM)
    for _ in range(200):
        seen, *_ = envs.step(plan.action()[None])
        plan.copies.resume()
        assert np.array_equal(plan.copies.observations(), np.tile(seen, (7, 1)))
    plan.copies.step(np.zeros((7, 2)))
    after = plan.copies.observations()
    assert np.array_equal(after[:6], np.tile(after[0], (6, 1)))
    assert not np.array_equal(after[0], after[6])


@pytest.mark.thorough
def test_plans_without_knowledge_of_the_waves_beat_the_policy_on_a_ship() -> None:
    """Source: measured over 16 episodes of 40 s (docs/learning.md); here two of 20 s."""
    task = replace(anti_sway(at_sea=True), duration_s=20.0)
    few = Sampling(horizon_s=4, guided_s=4, candidates=12, elites=4, iterations=2, every_s=1.0)
    with_plans = score(task, lambda task: cem_mpc(task, few, CALM), 2)
    alone = score(task, lambda _: trained(ENVIRONMENT), 2)
    assert with_plans.mean() > alone.mean() + 1.0, f"{with_plans} against {alone}"


def test_a_moving_base_together_with_a_ship_is_refused() -> None:
    with pytest.raises(KingpostError, match="found both, allowed: at most one"):
        anti_sway(on_a_ship=True, at_sea=True)


def test_resume_before_mark_is_refused() -> None:
    episodes = Episodes(anti_sway(), 2, 1)
    with pytest.raises(KingpostError, match="mark: found no episode, allowed: after reset"):
        episodes.mark()
    episodes.begin({0: np.random.default_rng(0), 1: np.random.default_rng(1)})
    with pytest.raises(KingpostError, match="resume: found no mark, allowed: after mark"):
        episodes.resume()


def test_an_environment_without_a_policy_is_reported() -> None:
    with pytest.raises(KingpostError, match="found Kingpost/Nothing, allowed: Kingpost/AntiSway-v0"):
        trained("Kingpost/Nothing")


@pytest.mark.parametrize(
    ("changed", "expected"),
    [
        ({"every_s": 0.02}, "every_s: found 0.02, allowed: at least 0.05, the control period"),
        ({"horizon_s": 0.02}, "horizon_s: found 0.02, allowed: at least 0.05, the control period"),
        ({"every_s": float("nan")}, "every_s: found nan, allowed: a number greater than 0"),
        ({"guided_s": -1}, "guided_s: found -1, allowed: 0 or more"),
        ({"knots": 1}, "knots: found 1, allowed: 2 or more"),
        ({"elites": 40}, "elites: found 40, allowed: 1 to 32, the candidates"),
    ],
)
def test_the_error_for_impossible_plan_settings_names_the_field(changed: dict, expected: str) -> None:
    with pytest.raises(KingpostError, match=expected):
        CrossEntropy(anti_sway(), [1.0, -0.8, 14.0, 15.0], Sampling(**changed), threads=1)

"""Environments: Gymnasium's own checks and vectoriser, the plain simulation, mistakes of a controller."""

from __future__ import annotations

import re
import shutil
from dataclasses import replace
from pathlib import Path

import gymnasium
import kingpost
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from gymnasium.vector import AutoresetMode, SyncVectorEnv
from kingpost.errors import KingpostError
from kingpost.learn import (
    BASELINES,
    IDS,
    Action,
    ShipCraneEnv,
    ShipCraneVectorEnv,
    Task,
    anti_sway,
    heave_compensation,
    roll_reduction,
    score,
    three_axis,
)
from kingpost.learn.episodes import Episodes
from lanes import sampled

SEED = 11


def actions(steps: int, count: int, wide: int = 2) -> np.ndarray:
    return np.random.default_rng(5).uniform(-1, 1, (steps, count, wide)).astype(np.float32)


def rolled(envs, steps: int, given: np.ndarray) -> list[tuple[np.ndarray, ...]]:
    """Observations, rewards and ends of every step."""
    first, _ = envs.reset(seed=SEED)
    return [
        (first.copy(),),
        *(tuple(np.array(part) for part in envs.step(given[k])[:4]) for k in range(steps)),
    ]


def same(one: list, other: list, rows: slice = slice(None)) -> bool:
    pairs = zip(one, other, strict=True)
    return all(
        np.array_equal(a[rows], b[rows]) for left, right in pairs for a, b in zip(left, right, strict=True)
    )


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("name", sampled(IDS, keep=["Kingpost/AntiSway-v0"]))
def test_gymnasium_s_checker_finds_nothing(name: str) -> None:
    check_env(gymnasium.make(name).unwrapped, skip_render_check=True)


def test_a_step_is_that_of_the_plain_simulation_to_the_last_bit() -> None:
    task = anti_sway()
    given = actions(30, 5)
    envs = ShipCraneVectorEnv(task, 5, threads=2)
    envs.reset(seed=SEED)
    plain = kingpost.Simulation(task.based_on)
    columns = [name for channel in plain.channels for name in channel["columns"]]
    for k in range(30):
        envs.step(given[k])
        for name, (low, high), action in zip(task.action_names, task.bounds, given[k, 3], strict=True):
            plain.set_input(name, low + (float(action) + 1.0) * (0.5 * (high - low)))
        plain.step(task.steps)
    row = dict(zip(columns, plain._engine.row(), strict=True))
    assert {name: values[3] for name, values in envs.episodes.columns.items()} == {
        name: row[name] for name in task.read
    }


@pytest.mark.parametrize("mode", ["SameStep", "NextStep"])
@pytest.mark.parametrize("randomised", [False, True])
def test_bits_do_not_depend_on_threads_and_on_the_number_of_environments(mode: str, randomised: bool) -> None:
    given = actions(25, 9)
    few = ShipCraneVectorEnv(anti_sway(randomised), 2, 1, mode, max_episode_steps=10)
    many = ShipCraneVectorEnv(anti_sway(randomised), 9, 2, mode, max_episode_steps=10)
    assert same(rolled(few, 25, given[:, :2]), rolled(many, 25, given), slice(0, 2))


@pytest.mark.parametrize("mode", [AutoresetMode.SAME_STEP, AutoresetMode.NEXT_STEP])
def test_the_native_vector_equals_gymnasium_s_vector_of_single_environments(mode: AutoresetMode) -> None:
    given = actions(25, 3)
    native = ShipCraneVectorEnv(anti_sway(), 3, 1, mode, max_episode_steps=10)
    makers = [lambda: ShipCraneEnv(anti_sway(), max_episode_steps=10)] * 3
    peer = SyncVectorEnv(makers, autoreset_mode=mode)
    assert native.metadata["autoreset_mode"] == peer.metadata["autoreset_mode"]
    assert same(rolled(native, 25, given), rolled(peer, 25, given))
    native.reset(seed=SEED), peer.reset(seed=SEED)
    for k in range(10):
        ours, theirs = native.step(given[k])[4], peer.step(given[k])[4]
    if mode == AutoresetMode.SAME_STEP:
        assert all(np.array_equal(a, b) for a, b in zip(ours["final_obs"], theirs["final_obs"], strict=True))
    else:
        assert ours == theirs == {}


def test_the_registered_name_makes_the_native_vector() -> None:
    envs = gymnasium.make_vec("Kingpost/AntiSway-v0", 4, vectorization_mode="vector_entry_point")
    assert isinstance(envs, ShipCraneVectorEnv)
    assert isinstance(envs.metadata["autoreset_mode"], AutoresetMode)


def test_resetting_one_environment_does_not_change_the_others() -> None:
    given = actions(20, 6)
    one, other = (ShipCraneVectorEnv(anti_sway(), 6, 1) for _ in range(2))
    one.reset(seed=SEED), other.reset(seed=SEED)
    for k in range(20):
        if k == 7:
            other.reset(seed=SEED, options={"reset_mask": np.arange(6) == 2})
        seen, beside = one.step(given[k])[0], other.step(given[k])[0]
        assert np.array_equal(np.delete(seen, 2, 0), np.delete(beside, 2, 0))
    fresh = ShipCraneVectorEnv(anti_sway(), 6, 1)
    fresh.reset(seed=SEED)
    for k in range(7, 20):
        seen = fresh.step(given[k])[0]
    assert np.array_equal(seen[2], beside[2])


def reach(mode: str, scenario: kingpost.Scenario | Path, limits: bool = False) -> ShipCraneVectorEnv:
    rewards = lambda columns, goal, actions: -abs(columns["slew.joint_position"])  # noqa: E731
    task = Task(scenario, ["slewing"], ["slew.joint_position"], rewards, limits=limits)
    return ShipCraneVectorEnv(task, 6, 2, mode)


@pytest.mark.parametrize("mode", ["SameStep", "NextStep"])
def test_a_failed_environment_gives_the_reason_and_restarts_while_the_others_continue(mode: str) -> None:
    scenario = anti_sway().based_on.with_overrides({"simulation.rate_limit": 0.06})
    envs = reach(mode, scenario)
    envs.reset(seed=SEED)
    given = np.zeros((6, 1), dtype=np.float32)
    given[4] = 1
    for _ in range(100):
        seen, rewards, terminated, truncated, info = envs.step(given)
        if terminated.any():
            break
    assert terminated.tolist() == [False, False, False, False, True, False]
    assert rewards[4] == envs.task.failure_reward
    assert not truncated.any()
    why = (info if mode == "NextStep" else info["final_info"])["ended_by"][4]
    assert why.startswith("diverged at ")
    assert "allowed: finite, and rates of at most 0.06" in why
    seen, rewards, terminated, *_ = envs.step(np.zeros_like(given))
    assert not terminated.any()
    assert abs(seen[4, 0]) < 1e-6


def test_an_exceeded_limit_of_the_scenario_ends_an_episode(tmp_path: Path) -> None:
    path = tmp_path / "limited.yaml"
    limit = "limits:\n  slew: {column: slew.joint_position, within: 1, unit: deg}\n"
    base = anti_sway().based_on
    path.write_text(base.text + limit, encoding="utf-8")
    shutil.copy(Path(base.file).with_name("double_pendulum_crane.yaml"), tmp_path)
    envs = reach("NextStep", path, limits=True)
    envs.reset(seed=SEED)
    given = np.zeros((6, 1), dtype=np.float32)
    given[1] = -1
    while not (step := envs.step(given))[2].any():
        assert (abs(step[0]) <= np.radians(1)).all()
    assert step[2].tolist() == [False, True, False, False, False, False]
    assert step[4]["ended_by"][1] == "limit slew exceeded"


@pytest.mark.parametrize(("bad", "found"), [(np.nan, "nan"), (1.5, "1.5"), (-np.inf, "-inf")])
def test_an_action_outside_the_box_is_refused_by_name(bad: float, found: str) -> None:
    envs = ShipCraneVectorEnv(anti_sway(), 3, 1)
    envs.reset(seed=SEED)
    given = np.zeros((3, 2), dtype=np.float32)
    given[2, 1] = bad
    with pytest.raises(
        KingpostError, match=f"action luffing of environment 2: found {found}, allowed: -1 to 1"
    ):
        envs.step(given)


def test_errors_name_the_wrong_value_and_the_allowed_ones() -> None:
    reward = lambda columns, goal, actions: columns["time"]  # noqa: E731
    with pytest.raises(KingpostError, match="action hoist: no such input, allowed: slewing, luffing"):
        Task(anti_sway().based_on, ["hoist"], ["time"], reward)
    with pytest.raises(KingpostError, match=r"action slewing: found -9 to 9, allowed: within -0\.1"):
        Task(anti_sway().based_on, [Action("slewing", -9, 9)], ["time"], reward)
    with pytest.raises(KingpostError, match="column nothing: no such column in A pedestal crane"):
        Task(anti_sway().based_on, ["slewing"], ["nothing"], reward)
    with pytest.raises(
        KingpostError, match=r"control_period_s: found 0.015, allowed: a whole number of steps"
    ):
        Task(anti_sway().based_on, ["slewing"], ["time"], reward, control_period_s=0.015)
    with pytest.raises(KingpostError, match="found no episode, allowed: after reset"):
        ShipCraneEnv(anti_sway()).step(np.zeros(2))
    with pytest.raises(KingpostError, match="num_envs: found 0, allowed: 1 or more"):
        ShipCraneVectorEnv(anti_sway(), 0)
    with pytest.raises(
        KingpostError, match="autoreset_mode: found 'never', allowed: NEXT_STEP, SAME_STEP, DISABLED"
    ):
        ShipCraneVectorEnv(anti_sway(), 1, autoreset_mode="never")


@pytest.mark.parametrize(
    ("randomised", "message"),
    [
        ({"rope_length_m": (1.0, 20.0), "crane_x_m": (0.0, 1.0)}, "randomised, at the low end of each range"),
        (
            {"simulation.step_s": (0.01, 0.013)},
            "control_period_s: found 0.05, allowed: a whole number of steps",
        ),
    ],
)
def test_a_range_with_an_invalid_end_is_refused_when_the_task_is_made(randomised, message) -> None:
    with pytest.raises(KingpostError, match=message):
        replace(anti_sway(), randomised=randomised)


def test_observations_have_names_and_units() -> None:
    task = heave_compensation()
    assert task.action_units == ("rad/s",)
    names = dict(zip(task.observation_names, task.observation_units, strict=True))
    assert names["height_error"] == "m"
    assert names["boom.tip.point_velocity.z"] == "m/s"
    assert names["hull.roll"] == "rad"


def test_another_seed_is_another_sea_and_the_same_seed_the_same() -> None:
    def seen(seed: int) -> np.ndarray:
        envs = ShipCraneVectorEnv(heave_compensation(), 2, 1)
        envs.reset(seed=seed)
        return np.array([envs.step(np.zeros((2, 1)))[0] for _ in range(200)][-1])

    one = seen(3)
    assert np.array_equal(one, seen(3))
    # Environment i of seed s is environment i - 1 of seed s + 1.
    assert np.array_equal(one[1], seen(4)[0])
    assert not np.array_equal(one[0], one[1])


@pytest.mark.thorough
def test_feedback_of_the_swing_beats_a_controller_without_it() -> None:
    by_name = {
        label: score(anti_sway(), policy, 8).mean()
        for label, policy in BASELINES["Kingpost/AntiSway-v0"].items()
    }
    worst_first = sorted(by_name, key=by_name.__getitem__)
    assert worst_first == [
        "do nothing",
        "proportional",
        "proportional, shaped",
        "swing feedback",
        "PID, tuned",
    ]


@pytest.mark.parametrize(
    "name",
    sampled(["Kingpost/RollReduction-v0", "Kingpost/ThreeAxis-v0"], keep=["Kingpost/RollReduction-v0"]),
)
def test_feedback_halves_the_cost_of_doing_nothing(name: str) -> None:
    nothing, acting = (score(IDS[name](), policy, 4).mean() for policy in BASELINES[name].values())
    assert 0.5 * nothing < acting < 0


def test_the_torques_of_the_baseline_equal_those_of_the_scenario_s_controller() -> None:
    """The gallery's `state_feedback` has the gains of this baseline, which sees single precision."""
    task = replace(roll_reduction(randomised=False), seeded=False, control_period_s=0.05)
    envs = ShipCraneVectorEnv(task, 1, 1)
    seen, _ = envs.reset(seed=SEED)
    act = BASELINES["Kingpost/RollReduction-v0"]["feedback of the roll rate"](task)
    plain = kingpost.Simulation(kingpost.load("roll_reduction_gyros").with_overrides(active=True))
    place = [name for channel in plain.channels for name in channel["columns"]].index("hull.roll")
    rolls = []
    for _ in range(2000):
        seen = envs.step(act(seen))[0]
        plain.step(1)
        rolls.append((envs.episodes.columns["hull.roll"][0], plain._engine.row()[place]))
    by_baseline, by_engine = np.array(rolls).T
    assert abs(by_baseline).max() > 0.01
    assert abs(by_baseline - by_engine).max() < 1e-5 * abs(by_engine).max()


def test_the_tip_s_parts_along_and_across_the_boom_are_a_turn_of_its_velocity() -> None:
    task = three_axis(randomised=False)
    envs = ShipCraneVectorEnv(task, 2, 1)
    envs.reset(seed=SEED)
    for _ in range(100):
        seen = envs.step(np.zeros((2, 3)))[0]
    now = {one.name: seen[:, k] * one.scale for k, one in enumerate(task.seen)}
    columns = envs.episodes.columns
    over_ground = [columns[f"boom.tip.point_velocity.{axis}"] for axis in "xy"]
    assert np.allclose(
        now["speed_along"] ** 2 + now["speed_across"] ** 2, np.square(over_ground).sum(axis=0), rtol=1e-5
    )
    assert np.allclose(now["reach"] ** 2 + now["tip_rise_over_foot"] ** 2, 30.0**2, rtol=1e-6)
    assert (columns["lift.position.y"] > 10).all()


def test_the_examples_of_the_page_run() -> None:
    page = (Path(__file__).parents[2] / "docs" / "learning.md").read_text(encoding="utf-8")
    blocks = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    # That of several agents runs in test_learn_agents.py.
    blocks = [block for block in blocks if "ParallelEnv" not in block]
    assert len(blocks) == 5
    for block in blocks:
        exec(compile(block, "docs/learning.md", "exec"), {})


@pytest.mark.parametrize("name", ["Kingpost/AntiSway-v0", "Kingpost/HeaveCompensation-v0"])
def test_each_episode_draws_the_delay_of_its_observations(name: str) -> None:
    """Source: the same episodes without delay, whose actions do not depend on what is seen."""
    made = {"vectorization_mode": "vector_entry_point", "threads": 2}
    prompt = gymnasium.make_vec(name, 6, **made)
    late = gymnasium.make_vec(name, 6, delay_s=(0.05, 0.2), **made)
    history = [prompt.reset(seed=SEED)[0]]
    seen = [late.reset(seed=SEED)[0]]
    for given in actions(12, 6)[:, :, : prompt.single_action_space.shape[0]]:
        for envs, rows in ((prompt, history), (late, seen)):
            rows.append(envs.step(given)[0])
    steps = late.unwrapped.episodes._late.steps
    assert steps.min() >= 1
    assert steps.max() <= 4
    assert len(set(steps)) > 1
    for k, row in enumerate(seen):
        expected = [history[max(0, k - late_by)][copy] for copy, late_by in enumerate(steps)]
        assert np.array_equal(row, expected)


def test_resumed_copies_have_the_delayed_observations_of_the_marked_one() -> None:
    task = replace(anti_sway(), delay_s=(0.1, 0.3))
    episodes = Episodes(task, 3, 1)
    episodes.begin({copy: np.random.default_rng(copy) for copy in range(3)})
    for given in actions(9, 3):
        episodes.step(given)
    episodes.mark(1)
    marked, given = episodes.observations()[1], actions(8, 3)[:, :1].repeat(3, axis=1)
    for again in range(2):
        episodes.resume()
        assert np.array_equal(episodes.observations(), np.tile(marked, (3, 1))), again
        rows = [episodes.step(row)[0] for row in given]
        assert all(np.array_equal(row, np.tile(row[0], (3, 1))) for row in rows)


@pytest.mark.parametrize("delay_s", [(-0.1, 0.1), (0.2, 0.1), (0.0, 100.0), (0.0, float("nan"))])
def test_an_impossible_delay_is_refused(delay_s: tuple[float, float]) -> None:
    with pytest.raises(KingpostError, match=r"delay_s: found .* allowed: from 0 to duration_s"):
        replace(anti_sway(), delay_s=delay_s)


def test_a_single_reward_for_all_environments_is_refused() -> None:
    task = replace(anti_sway(), reward=lambda columns, goal, actions: -1.0)
    episodes = Episodes(task, 3)
    episodes.begin({k: np.random.default_rng(k) for k in range(3)})
    with pytest.raises(
        KingpostError, match=r"reward: found -1\.0, allowed: 3 numbers, one for each environment"
    ):
        episodes.step(np.zeros((3, len(task.actions))))


def test_unknown_options_of_reset_are_refused() -> None:
    with pytest.raises(KingpostError, match="options: found 'load_t', allowed: none; randomised"):
        ShipCraneEnv(anti_sway()).reset(options={"load_t": 3})

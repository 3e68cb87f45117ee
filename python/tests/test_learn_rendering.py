"""Frames of learning environments: Gymnasium's checker, the states that they show, many environments."""

from __future__ import annotations

import gymnasium
import kingpost
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from kingpost import KingpostError, picture
from kingpost.learn import ShipCraneEnv, ShipCraneVectorEnv, Task, anti_sway
from kingpost.learn.rendering import FRAME_PX

SMALL = {"render_mode": "rgb_array", "size_px": (96, 54)}
PUSH = np.array([1.0, -1.0], dtype=np.float32)


@pytest.mark.filterwarnings("error")
def test_gymnasium_s_checker_finds_nothing_in_the_frames() -> None:
    env = gymnasium.make("Kingpost/AntiSway-v0", render_mode="rgb_array")
    assert env.metadata["render_modes"] == ["rgb_array"]
    assert env.metadata["render_fps"] == 20.0
    check_env(env.unwrapped)
    env.reset(seed=1)
    frame = env.render()
    assert frame.shape == (FRAME_PX[1], FRAME_PX[0], 3)
    assert frame.dtype == np.uint8


def test_a_frame_is_the_picture_of_the_plain_simulation_with_the_same_inputs() -> None:
    """Source: the plain simulation, whose steps are those of an environment to the last bit."""
    task = anti_sway()
    env = ShipCraneEnv(task, **SMALL)
    env.reset(seed=3)
    plain = kingpost.Simulation(task.based_on)
    first = env.render()
    assert np.array_equal(first, picture(plain, size_px=(96, 54)))
    for _ in range(25):
        env.step(PUSH)
        for name, (low, high), action in zip(task.action_names, task.bounds, PUSH, strict=True):
            plain.set_input(name, low + (float(action) + 1.0) * (0.5 * (high - low)))
        plain.step(task.steps)
    assert not np.array_equal(env.render(), first)
    assert np.array_equal(env._frames[0]._drawing.simulation.poses(), plain.poses())


def test_frames_are_those_of_the_drawn_scenario_and_of_each_episode() -> None:
    env = ShipCraneEnv(anti_sway(randomised=True), **SMALL)
    env.reset(seed=1)
    overrides = dict(env.episodes.variants[0])
    drawn = env._frames[0]
    env.render()
    assert dict(drawn._drawing.simulation.scenario.overrides) == overrides
    start = env.render()
    env.step(PUSH)
    env.reset(seed=1)
    assert np.array_equal(env.render(), start)


def test_a_vector_has_a_frame_of_each_environment_also_after_a_reset_of_its_own() -> None:
    envs = ShipCraneVectorEnv(anti_sway(), 2, 1, max_episode_steps=6, **SMALL)
    single = ShipCraneEnv(anti_sway(), **SMALL)
    envs.reset(seed=5)
    single.reset(seed=6)
    actions = np.stack([PUSH, -PUSH])
    for _ in range(4):
        envs.step(actions)
        single.step(actions[1])
    frames = envs.render()
    assert len(frames) == 2
    assert np.array_equal(frames[1], single.render())
    assert not np.array_equal(*frames)
    # The episodes end after six steps and begin anew in the seventh.
    for _ in range(3):
        envs.step(actions)
    assert np.array_equal(*envs.render())


def test_a_failed_episode_shows_its_last_good_step() -> None:
    scenario = anti_sway().based_on.with_overrides({"simulation.rate_limit": 0.06})
    reward = lambda columns, goal, actions: -columns["time"]  # noqa: E731
    task = Task(scenario, ["slewing"], ["slew.joint_position"], reward, columns=["time"])
    env = ShipCraneEnv(task, **SMALL)
    env.reset(seed=0)
    ended = False
    while not ended:
        ended = env.step(np.ones(1, dtype=np.float32))[2]
    assert env.render().shape == (54, 96, 3)


def test_without_a_render_mode_there_are_no_frames() -> None:
    env = ShipCraneEnv(anti_sway())
    env.reset(seed=0)
    assert env.render() is None
    assert ShipCraneVectorEnv(anti_sway(), 2).render() is None


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"render_mode": "human"}, "render_mode: found 'human', allowed: rgb_array, or None"),
        ({**SMALL, "camera": "crow"}, "camera: found 'crow', allowed: free"),
        ({**SMALL, "size_px": (0, 3)}, r"size_px: found \(0, 3\), allowed"),
    ],
)
def test_wrong_options_of_frames_are_refused(given: dict, message: str) -> None:
    with pytest.raises(KingpostError, match=message):
        ShipCraneEnv(anti_sway(), **given)


def test_a_frame_before_an_episode_is_refused() -> None:
    with pytest.raises(KingpostError, match=r"render: found no episode, allowed: after reset\(\)"):
        ShipCraneEnv(anti_sway(), **SMALL).render()

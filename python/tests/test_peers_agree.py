"""MuJoCo and Pinocchio against each other, and against the published case: checks of the test harness."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")
pytest.importorskip("pinocchio", reason="Pinocchio is not installed")

import kingpost
import mujoco
import pinocchio
from peers import cases, states
from peers.mujoco_peer import MujocoPeer
from peers.pinocchio_peer import PinocchioPeer
from peers.tree import Array, Tree, UnsupportedByPeersError, read

# one row that three independent codes give: ship's centre held, crane at the centre, no load, tower motor
# alone, t = 0.5 s. Roll, pitch and yaw rate, slew rate, luff rate in rad/s; slew and luff angle in rad
TRUTH_RATES = [-0.07719, 0.19709, -0.12348, 6.6699, 0.0338]
TRUTH_ANGLES = [1.7159, 0.0632]
TRUTH_STEPS, TRUTH_STEP_S = 500, 0.001


@pytest.mark.parametrize(("hold_translation", "hold_rotation"), cases.HOLDS)
def test_translators_agree_on_every_feature(hold_translation: bool, hold_rotation: bool) -> None:
    tree = read(cases.every_feature(hold_translation=hold_translation, hold_rotation=hold_rotation))
    first, second = MujocoPeer(tree), PinocchioPeer(tree)
    random = np.random.default_rng(64)
    for _ in range(50):
        q, v = states.random_state(tree, random)
        extra = random.uniform(-1e4, 1e4, int(tree.free().sum()))
        expected = second.acceleration(q, v, extra)
        assert cases.difference(first.acceleration(q, v, extra), expected) < 1e-11


def test_translators_agree_on_every_joint() -> None:
    tree = read(cases.every_joint())
    first, second = MujocoPeer(tree), PinocchioPeer(tree)
    random = np.random.default_rng(65)
    for _ in range(50):
        q, v = states.random_state(tree, random)
        extra = random.uniform(-1e3, 1e3, int(tree.free().sum()))
        expected = second.acceleration(q, v, extra)
        assert cases.difference(first.acceleration(q, v, extra), expected) < 1e-11


@pytest.mark.parametrize("more", [{"mode": "held"}, {"friction": {"torque_N_m": 1.0}}])
def test_a_feature_of_an_axis_that_the_peers_lack_is_refused_by_name(more: dict[str, Any]) -> None:
    shape = {"sphere": {"radius_m": 1.0}}
    hook = {"universal": {"first_axis": [1, 0, 0], "second_axis": [0, 1, 0], "second": more}}
    with pytest.raises(UnsupportedByPeersError, match=f"joint bob: .*({next(iter(more))}|held)"):
        read({"bodies": {"bob": {"mass_kg": 1.0, "shape": shape, "joint": hook}}})


def test_a_lone_moving_point_is_refused_with_its_name() -> None:
    bob = {"mass_kg": 1.0, "shape": {"point": {}}, "joint": {"prismatic": {"axis": [0, 0, 1]}}}
    with pytest.raises(UnsupportedByPeersError, match="body bob"):
        MujocoPeer(read({"bodies": {"bob": bob}}))


def truth_tree() -> Tree:
    """The paper's model as the row of truth has it."""
    return read(kingpost.load("paper", crane_x_m=0.0, crane_y_m=0.0, motor_1=True).resolved)


def assert_truth(rates: Array, angles: Array) -> None:
    np.testing.assert_allclose(rates, TRUTH_RATES, atol=5e-5)
    np.testing.assert_allclose(angles, TRUTH_ANGLES, atol=5e-5)


def test_pinocchio_agrees_with_the_published_row() -> None:
    tree = truth_tree()
    peer = PinocchioPeer(tree)
    start = states.at_rest(tree)
    tau, h = peer.force(*start), TRUTH_STEP_S
    q, v = peer.configuration(start[0]), peer.velocity(*start)

    def rate(q: Array, v: Array) -> Array:
        return np.array(pinocchio.aba(peer.model, peer.data, q, v, tau))

    def move(q: Array, step: Array) -> Array:
        return np.array(pinocchio.integrate(peer.model, q, step))

    for _ in range(TRUTH_STEPS):
        a1 = rate(q, v)
        v2 = v + h / 2 * a1
        a2 = rate(move(q, h / 2 * v), v2)
        v3 = v + h / 2 * a2
        a3 = rate(move(q, h / 2 * v2), v3)
        v4 = v + h * a3
        a4 = rate(move(q, h * v3), v4)
        q = move(q, h / 6 * (v + 2 * v2 + 2 * v3 + v4))
        v = v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)
    assert_truth(v, q[-2:])


def test_mujoco_agrees_with_the_published_row() -> None:
    tree = truth_tree()
    peer = MujocoPeer(tree)
    peer.acceleration(*states.at_rest(tree))
    assert peer.model.opt.timestep == TRUTH_STEP_S
    for _ in range(TRUTH_STEPS):
        mujoco.mj_step(peer.model, peer.data)
    assert_truth(peer.data.qvel, peer.data.qpos[-2:])

"""Accelerations against MuJoCo and Pinocchio: the paper's model, and one with every feature."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from importlib import import_module
from pathlib import Path
from typing import Any

import kingpost
import numpy as np
import pytest
from lanes import sampled
from peers import cases, states
from peers.tree import Tree, read

KEPT = [case for case in cases.CASES if sum(case.values()) in (0, 1, len(case))]
"""Nothing, each switch alone, and all of them."""
PEERS = {"mujoco": "MujocoPeer", "pinocchio": "PinocchioPeer"}


@pytest.fixture(params=PEERS)
def make_peer(request: pytest.FixtureRequest) -> Callable[[Tree], Any]:
    """Builds one of the other engines' models; skipped with a word where that is not installed."""
    pytest.importorskip(request.param, reason=f"{request.param} is not installed")
    return getattr(import_module(f"peers.{request.param}_peer"), PEERS[request.param])


@pytest.mark.parametrize("case", sampled(cases.CASES, keep=KEPT), ids=cases.name)
def test_accelerations_of_the_papers_model(
    case: Mapping[str, bool], make_peer: Callable[[Tree], Any]
) -> None:
    scenario = kingpost.load("paper", cases.overrides(case))
    simulation, tree = kingpost.Simulation(scenario), read(scenario.resolved)
    peer = make_peer(tree)
    assert len(simulation.coordinates) == tree.free().sum() == (5 if case["hold_centre"] else 8)
    for q, v, extra in cases.states(tree, case):
        simulation.set_state(q, v)
        expected = peer.acceleration(q, v, extra)
        assert cases.difference(simulation.acceleration(extra), expected) < cases.TOLERANCE


def test_accelerations_with_every_joint(tmp_path: Path, make_peer: Callable[[Tree], Any]) -> None:
    path = tmp_path / "every_joint.yaml"
    path.write_text(json.dumps(cases.every_joint()))
    scenario = kingpost.load(path)
    simulation, tree = kingpost.Simulation(scenario), read(scenario.resolved)
    np.testing.assert_allclose(simulation.state.q, states.at_rest(tree)[0], atol=1e-15)
    peer, random = make_peer(tree), np.random.default_rng(33)
    for _ in range(50):
        q, v = states.random_state(tree, random)
        extra = random.uniform(-1e3, 1e3, int(tree.free().sum()))
        simulation.set_state(q, v)
        expected = peer.acceleration(q, v, extra)
        assert cases.difference(simulation.acceleration(extra), expected) < cases.TOLERANCE


def test_there_are_enough_random_states() -> None:
    assert len(cases.CASES) * cases.STATES_PER_CASE >= 50


@pytest.mark.parametrize(("hold_translation", "hold_rotation"), cases.HOLDS)
def test_accelerations_with_every_feature(
    hold_translation: bool, hold_rotation: bool, tmp_path: Path, make_peer: Callable[[Tree], Any]
) -> None:
    entry = cases.every_feature(hold_translation=hold_translation, hold_rotation=hold_rotation)
    path = tmp_path / "every_feature.yaml"
    path.write_text(json.dumps(entry))
    scenario = kingpost.load(path)
    simulation, tree = kingpost.Simulation(scenario), read(scenario.resolved)
    np.testing.assert_allclose(simulation.state.q, states.at_rest(tree)[0], atol=1e-15)
    peer, random = make_peer(tree), np.random.default_rng(46)
    for _ in range(50):
        q, v = states.random_state(tree, random)
        extra = random.uniform(-1e4, 1e4, int(tree.free().sum()))
        simulation.set_state(q, v)
        expected = peer.acceleration(q, v, extra)
        assert cases.difference(simulation.acceleration(extra), expected) < cases.TOLERANCE

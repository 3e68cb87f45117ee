"""Accelerations against Pinocchio at random states: the paper's model, and one with every feature."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path

import pytest

pytest.importorskip("pinocchio", reason="Pinocchio is not installed")

import kingpost
import numpy as np
from peers import cases, states
from peers.pinocchio_peer import PinocchioPeer
from peers.tree import read


@pytest.mark.parametrize("case", cases.CASES, ids=cases.name)
def test_accelerations_of_the_papers_model(case: Mapping[str, bool]) -> None:
    scenario = kingpost.load("paper", cases.overrides(case))
    simulation, tree = kingpost.Simulation(scenario), read(scenario.resolved)
    peer = PinocchioPeer(tree)
    assert len(simulation.coordinates) == tree.free().sum() == (5 if case["hold_centre"] else 8)
    for q, v, extra in cases.states(tree, case):
        simulation.set_state(q, v)
        expected = peer.acceleration(q, v, extra)
        assert cases.difference(simulation.acceleration(extra), expected) < cases.TOLERANCE


def test_the_states_are_many() -> None:
    assert len(cases.CASES) * cases.STATES_PER_CASE >= 50


@pytest.mark.parametrize(("hold_translation", "hold_rotation"), cases.HOLDS)
def test_accelerations_with_every_feature(
    hold_translation: bool, hold_rotation: bool, tmp_path: Path
) -> None:
    entry = cases.every_feature(hold_translation=hold_translation, hold_rotation=hold_rotation)
    path = tmp_path / "every_feature.yaml"
    path.write_text(json.dumps(entry))
    scenario = kingpost.load(path)
    simulation, tree = kingpost.Simulation(scenario), read(scenario.resolved)
    np.testing.assert_allclose(simulation.state.q, states.at_rest(tree)[0], atol=1e-15)
    peer, random = PinocchioPeer(tree), np.random.default_rng(46)
    for _ in range(50):
        q, v = states.random_state(tree, random)
        extra = random.uniform(-1e4, 1e4, int(tree.free().sum()))
        simulation.set_state(q, v)
        expected = peer.acceleration(q, v, extra)
        assert cases.difference(simulation.acceleration(extra), expected) < cases.TOLERANCE

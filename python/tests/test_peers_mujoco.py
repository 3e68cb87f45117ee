"""Accelerations against MuJoCo at random states of the paper's model."""

from __future__ import annotations

from collections.abc import Mapping

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

import kingpost
from peers import cases
from peers.mujoco_peer import MujocoPeer
from peers.tree import read


@pytest.mark.parametrize("case", cases.CASES, ids=cases.name)
def test_accelerations_of_the_papers_model(case: Mapping[str, bool]) -> None:
    scenario = kingpost.load("paper", cases.overrides(case))
    simulation, tree = kingpost.Simulation(scenario), read(scenario.resolved)
    peer = MujocoPeer(tree)
    assert len(simulation.coordinates) == tree.free().sum() == (5 if case["hold_centre"] else 8)
    for q, v, extra in cases.states(tree, case):
        simulation.set_state(q, v)
        expected = peer.acceleration(q, v, extra)
        assert cases.difference(simulation.acceleration(extra), expected) < cases.TOLERANCE


def test_the_states_are_many() -> None:
    assert len(cases.CASES) * cases.STATES_PER_CASE >= 50

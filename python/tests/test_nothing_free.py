"""A ship whose every joint is held or moves as prescribed: no tool fails on a system without unknowns.

Source: with no coordinate, M* is 0 x 0, there are no modes, and waves of any frequency move nothing.
"""

from __future__ import annotations

import kingpost
import numpy as np
import pytest
from kingpost.cli import main

HELD = {
    "bodies.ship.joint.floating.hold_translation": True,
    "bodies.ship.joint.floating.hold_rotation": True,
    "bodies.load.enabled": False,
    "simulation.duration_s": 0.1,
}
ASSIGNMENTS = [f"--set={path}={str(value).lower()}" for path, value in HELD.items()]


@pytest.fixture
def simulation() -> kingpost.Simulation:
    return kingpost.Simulation(kingpost.load("barge", HELD))


def test_the_matrices_of_a_model_without_free_coordinates_have_no_rows(
    simulation: kingpost.Simulation,
) -> None:
    assert simulation.coordinates == []
    assert simulation.mass_matrix().shape == (0, 0)
    assert simulation.acceleration().size == 0
    matrices = simulation.moving_frame()
    assert matrices["M_star"].shape == (0, 0)
    assert matrices["N_star"].shape == (0, 0)


def test_a_model_without_free_coordinates_has_only_modes_of_the_waters_memory(
    simulation: kingpost.Simulation,
) -> None:
    assert simulation.settle().iterations == 0
    found = kingpost.modes("barge", HELD)
    assert (found["memory_share"] == 1.0).all()


def test_waves_do_not_move_a_model_without_free_coordinates(simulation: kingpost.Simulation) -> None:
    found = simulation.wave_response([0.0, 1.0], [0.5, 1.0])
    assert np.abs(found["real"]).max() == 0.0
    assert np.abs(found["imaginary"]).max() == 0.0


@pytest.mark.parametrize("command", ["check", "modes", "rao", "run"])
def test_each_command_succeeds_without_free_coordinates(
    command: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([command, "barge", *ASSIGNMENTS]) == 0
    assert "the engine failed" not in capsys.readouterr().err

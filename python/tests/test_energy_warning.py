"""The warning of an energy that does not balance is the same wherever the world's origin is."""

from __future__ import annotations

import warnings
from pathlib import Path

import kingpost
import numpy as np
import pytest
from kingpost.results import entries
from kingpost.simulation.records import OFF_BALANCE

PENDULUM = """version: 1
title: A pendulum
simulation: {{integrator: {integrator}, step_s: {step_s}, duration_s: 4, record_every_s: 0.1}}
bodies:
  bob:
    mass_t: 1
    shape: {{sphere: {{radius_m: 0.3}}}}
    joint:
      revolute:
        axis: [0, 1, 0]
        position_m: [0, 0, {height_m}]
        child_position_m: [0, 0, 5]
        initial_angle_deg: 20
forces: {{gravity: {{gravity: {{}}}}}}
"""


def energy_warnings(tmp_path: Path, integrator: str, step_s: float, height_m: float) -> list[str]:
    path = tmp_path / "pendulum.yaml"
    path.write_text(
        PENDULUM.format(integrator=integrator, step_s=step_s, height_m=height_m), encoding="utf-8"
    )
    found = entries.warnings_of(kingpost.run(path))
    return [one["text"] for one in found if one["code"] == OFF_BALANCE]


@pytest.mark.parametrize("height_m", [0.0, 400.0, -3000.0])
def test_an_energy_error_gives_a_warning_at_any_height(height_m: float, tmp_path: Path) -> None:
    """Source: forward Euler adds energy to a pendulum: (1 + h^2 g / L) each step, 8 % here."""
    (text,) = energy_warnings(tmp_path, "forward_euler", 0.01, height_m)
    (at_origin,) = energy_warnings(tmp_path, "forward_euler", 0.01, 0.0)
    assert text.split(":")[0] == at_origin.split(":")[0]


@pytest.mark.parametrize("height_m", [0.0, 3000.0])
def test_rounding_gives_no_energy_warning_at_any_distance_of_the_origin(
    height_m: float, tmp_path: Path
) -> None:
    assert energy_warnings(tmp_path, "rk4", 0.01, height_m) == []


def test_a_loop_of_runs_shows_a_warning_of_one_kind_once() -> None:
    coarse = {"simulation.duration_s": 1.5, "simulation.step_s": 0.02, "motor_2": True}
    with warnings.catch_warnings(record=True) as shown:
        warnings.simplefilter("default")
        for x in np.linspace(-10, -9, 4):
            kingpost.run("paper", coarse, crane_x_m=x)
    assert len(shown) == 1
    with warnings.catch_warnings(record=True) as shown:
        warnings.simplefilter("always")
        for x in np.linspace(-10, -9, 4):
            kingpost.run("paper", coarse, crane_x_m=x)
    assert len(shown) == 4

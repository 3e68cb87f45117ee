"""U-tanks against closed forms: period, coupled modes, mass, pump, energy, and what a user gets wrong."""

from __future__ import annotations

import copy
from typing import Any

import kingpost
import numpy as np
import pytest

G = 9.80665
RHO = 1000.0
TANK = {
    "body": "ship",
    "position_m": [2.0, 0.5, 3.0],
    "column_distance_m": 16.0,
    "column_length_m": 5.0,
    "column_breadth_m": 2.5,
    "column_height_m": 6.0,
    "level_m": 3.0,
    "duct_height_m": 1.0,
    "density_kg_m3": RHO,
}
AREA = 5.0 * 2.5
FLOW_MASS = RHO * AREA**2 * (2 * 3.0 / AREA + 16.0 / (5.0 * 1.0))
"""m_t = rho A^2 integral ds / A(s)."""
ABOUT_AXIS = RHO * AREA * 16.0 * (3.0 - 3.0)
FREQUENCY = np.sqrt(2 * RHO * AREA * G / FLOW_MASS)
ROLL = {"revolute": {"axis": [1, 0, 0], "position_m": [0, 0, 0], "child_position_m": [0, 0, 0]}}
MASS, INERTIA, STIFFNESS = 4.0e6, 2.0e8, 6.0e7


def scenario(joint: dict[str, Any] | None = None, **changed: Any) -> kingpost.Scenario:
    ship = {
        "parent": "world",
        "mass_kg": MASS,
        "inertia": {"tensor": {"moments_kg_m2": [INERTIA, 9e8, 9e8]}},
        "joint": joint or {"fixed": {}},
    }
    tree = {
        "version": 1,
        "title": "A tank",
        "simulation": {"step_s": 0.02, "duration_s": 20, "record_every_s": 0.1},
        "bodies": {"ship": ship},
        "forces": {"gravity": {"gravity": {}}, "tank": {"u_tank": copy.deepcopy(TANK) | changed}},
    }
    return kingpost.load(tree)


def sprung() -> dict[str, Any]:
    joint = copy.deepcopy(ROLL)
    joint["revolute"]["spring"] = {"stiffness_N_m_per_rad": STIFFNESS, "rest_rad": 0.0}
    return joint


def rocking(**changed: Any) -> kingpost.Scenario:
    """A ship that rolls about an axis through its centre, with a spring."""
    return scenario(sprung(), **changed)


def test_in_a_ship_at_rest_the_level_swings_at_the_period_of_the_books_whatever_its_height():
    ds = kingpost.run(rolling_held(initial_rise_m=1.5))
    time = ds["time"].values
    found = ds.kingpost["tank.level_port"].values
    # The potential is exactly quadratic; RK4 with 0.02 s errs by (w h)^5 / 120 a step.
    assert np.allclose(found, 3.0 + 1.5 * np.cos(FREQUENCY * time), atol=1e-6)
    assert np.allclose(found + ds.kingpost["tank.level_starboard"].values, 6.0, atol=1e-12)


def rolling_held(**changed: Any) -> kingpost.Scenario:
    joint = copy.deepcopy(ROLL)
    joint["revolute"]["mode"] = "held"
    return scenario(joint, **changed)

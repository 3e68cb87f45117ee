"""U-tanks compared with closed forms: period, coupled modes, mass, pump, energy; and errors of users."""

from __future__ import annotations

import copy
import json
from typing import Any

import kingpost
import numpy as np
import pytest

G = 9.80665
RHO = 1000.0
TANK = {
    "body": "ship",
    "position_m": [2.0, 0.0, -1.0],
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
COUPLING = RHO * AREA * 16.0 * (3.0 - (-1.0))
"""Momentum about the axis of roll for a rate of the level: rho A times twice the area in the path."""
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
    return kingpost.Scenario(json.dumps(tree), "tank.json")


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


def frozen_liquid() -> tuple[float, float, float]:
    """Mass, height of the centre, moment about the axis of roll of the liquid at rest: three boxes."""
    cells = 400
    boxes = [(-8.0, 2.5, -1.5, 3.5), (8.0, 2.5, -1.5, 3.5), (0.0, 13.5, -1.5, 1.0)]
    mass = height = moment = 0.0
    for middle, breadth, bottom, depth in boxes:
        of = RHO * 5.0 * breadth * depth
        z = bottom + depth * (np.arange(cells) + 0.5) / cells
        y = middle + breadth * ((np.arange(cells) + 0.5) / cells - 0.5)
        mass += of
        height += of * z.mean()
        moment += of * ((y**2).mean() + (z**2).mean())
    return mass, height / mass, moment


def matrices() -> tuple[np.ndarray, np.ndarray]:
    """M and K of roll and level about the upright position (Lloyd, *Seakeeping*, 1989, ch. 13)."""
    mass, height, moment = frozen_liquid()
    inertia = np.array([[INERTIA + moment, COUPLING], [COUPLING, FLOW_MASS]])
    across = RHO * G * AREA * 16.0
    stiffness = np.array([[STIFFNESS - mass * G * height, across], [across, 2 * RHO * G * AREA]])
    return inertia, stiffness


def test_roll_and_level_have_the_two_modes_of_the_coupled_equations():
    inertia, stiffness = matrices()
    expected = np.sqrt(np.sort(np.linalg.eigvals(np.linalg.solve(inertia, stiffness)).real)) / (2 * np.pi)
    found = np.sort(np.asarray(kingpost.modes(rocking())["frequency"]))
    # Differences of the analysis: 1e-6; the boxes are summed over 400 cells: 1e-6.
    assert np.allclose(found, expected, rtol=1e-5)


def test_frozen_liquid_is_a_rigid_mass_of_the_ship():
    _, stiffness = matrices()
    _, _, moment = frozen_liquid()
    found = float(np.asarray(kingpost.modes(rocking(enabled=False))["frequency"])[0])
    assert found == pytest.approx(np.sqrt(stiffness[0, 0] / (INERTIA + moment)) / (2 * np.pi), rel=1e-5)


def test_a_shifted_weight_heels_a_ship_by_the_metacentric_height_less_the_two_levels():
    """Source: tan(heel) = m y / (M GM) (Barrass & Derrett, *Ship Stability for Masters and Mates*). The rest
    is of the order of the heel, 1e-3, times the change of form; measured 1.5e-5."""
    weight = {
        "parent": "hull",
        "mass_t": 5,
        "shape": {"point": {}},
        "joint": {"fixed": {"position_m": [0, 2, 0]}},
    }
    off = {"heel_control": False, "hydrostatics": "mesh", "bodies.weight": weight}
    ship = kingpost.load("anti_heeling_tank", off)
    (hull,) = ship.hydrostatics["hulls"]
    tank = ship.resolved["forces"]["tank"]["u_tank"]
    area = tank["column_length_m"] * tank["column_breadth_m"]
    expected = 1025.0 * area * tank["column_distance_m"] ** 2 / 2 / hull["mass_kg"]
    (surface,) = hull["free_surfaces"]
    assert surface["correction_m"] == pytest.approx([expected, 0.0], rel=1e-4, abs=1e-6)
    assert [load["body"] for load in hull["hanging"]] == ["load"]
    heel = -5e3 * 2.0 / (hull["mass_kg"] * hull["metacentric_height_m"][0])
    assert hull["heel_rad"] == pytest.approx(heel, rel=1e-4)


def test_the_energy_closes_with_losses_and_a_pump_at_large_angles():
    joint = sprung()
    joint["revolute"]["initial_angle_rad"] = 0.15
    pump = {"pressure_limit_Pa": 2.0e4, "flow_limit_m3_s": 20.0}
    given = scenario(joint, damping_ratio=0.05, loss_coefficient=2.0, pump=pump)
    errors = []
    for step_s in (0.04, 0.02):
        simulation = kingpost.Simulation(given.with_overrides({"simulation.step_s": step_s}))
        simulation.set_input("tank", -0.7)
        errors.append(float(np.abs(simulation.run()["energy_error"]).max()))
    # RK4; the loss, quadratic in the flow, has a kink in its curvature where the flow turns.
    assert errors[1] < errors[0] / 6
    assert errors[1] < 1e-5 * 0.5 * STIFFNESS * 0.15**2


def test_the_pump_raises_the_level_until_the_weight_of_the_difference_balances_its_pressure():
    pump = {"pressure_limit_Pa": 2.0e4, "flow_limit_m3_s": 20.0}
    simulation = kingpost.Simulation(rolling_held(damping_ratio=0.7, pump=pump))
    simulation.set_input("tank", 0.5)
    ds = simulation.run()
    difference = ds.kingpost["tank.level_port"][-1] - ds.kingpost["tank.level_starboard"][-1]
    assert float(difference) == pytest.approx(0.5 * 2.0e4 / (RHO * G), rel=1e-3)
    power, flow = ds.kingpost["tank.pump_power"], ds.kingpost["tank.tank_flow"]
    assert float(power.max()) <= 0.25 * 2.0e4 * 20.0
    assert float(np.abs(power - ds.kingpost["tank.pump_pressure"] * flow).max()) < 1e-6


def test_a_level_that_reaches_the_top_of_a_column_is_warned_of():
    pump = {"pressure_limit_Pa": 9.0e4, "flow_limit_m3_s": 90.0}
    simulation = kingpost.Simulation(rolling_held(column_height_m=5.0, pump=pump))
    simulation.set_input("tank", 1.0)
    with pytest.warns(kingpost.KingpostWarning, match="top of a column"):
        simulation.run()


@pytest.mark.parametrize(
    ("field", "value", "said"),
    [
        ("level_m", 6.5, "less than column_height_m"),
        ("column_breadth_m", 16.0, "less than column_distance_m"),
        ("duct_height_m", 7.0, "less than twice level_m"),
        ("initial_rise_m", -2.8, "less than the depth down to the duct"),
        ("body", "barge", "one of ship"),
    ],
)
def test_an_impossible_tank_is_refused_with_its_field(field: str, value: Any, said: str):
    with pytest.raises(kingpost.ScenarioError, match=said) as caught:
        kingpost.Simulation(scenario(**{field: value}))
    assert f"forces.tank.u_tank.{field}" in str(caught.value)

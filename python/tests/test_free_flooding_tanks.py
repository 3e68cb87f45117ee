"""Tanks open to the sea against closed forms: level, period, coupled modes, waves, stability, air, energy."""

from __future__ import annotations

import copy
import json
from typing import Any

import kingpost
import numpy as np
import pytest

G, RHO = 9.80665, 1000.0
LENGTH, BREADTH, LEVEL, OPENING, PASSAGE = 5.0, 2.5, 4.0, 2.0, 0.4
AREA = LENGTH * BREADTH
TANK = {
    "body": "ship",
    "position_m": [0.0, 7.0, -LEVEL],
    "length_m": LENGTH,
    "breadth_m": BREADTH,
    "height_m": 7.0,
    "level_m": LEVEL,
    "opening_area_m2": OPENING,
    "passage_length_m": PASSAGE,
    "loss_coefficient": 0.0,
}
RADIUS = np.sqrt(OPENING / np.pi)
ENDS = 8 * RADIUS / (3 * np.pi) * (2 - 1.25 * np.sqrt(OPENING / AREA))
"""End corrections of the opening: Rayleigh, *The Theory of Sound*, sec. 307; inside less by Ingard (1953)."""
FLOW_MASS = RHO * AREA * LEVEL + RHO * AREA**2 * (PASSAGE + ENDS) / OPENING
STIFFNESS = RHO * G * AREA
FREQUENCY = np.sqrt(STIFFNESS / FLOW_MASS)
ROLL = {"revolute": {"axis": [1, 0, 0], "position_m": [0, 0, 0], "child_position_m": [0, 0, 0]}}
INERTIA, ROLL_STIFFNESS = 2.0e8, 8.0e7
PUMP = {"pressure_limit_Pa": 2.0e4, "flow_limit_m3_s": 40.0}


def scenario(
    joint: dict[str, Any] | None = None, tanks: dict[str, Any] | None = None, **changed: Any
) -> kingpost.Scenario:
    ship = {
        "parent": "world",
        "mass_kg": 4.0e6,
        "inertia": {"tensor": {"moments_kg_m2": [INERTIA, 9e8, 9e8]}},
        "joint": joint or {"fixed": {}},
    }
    waves = changed.pop("waves", {})
    given = tanks or {"tank": {}}
    forces = {
        name: {"free_flooding_tank": copy.deepcopy(TANK) | changed | own} for name, own in given.items()
    }
    tree = {
        "version": 1,
        "title": "Tanks open to the sea",
        "simulation": {"step_s": 0.02, "duration_s": 20, "record_every_s": 0.1},
        "sea": {"density_kg_m3": RHO, **waves},
        "bodies": {"ship": ship},
        "forces": {"gravity": {"gravity": {}}, **forces},
    }
    return kingpost.Scenario(json.dumps(tree), "tank.json")


def sprung(angle_rad: float = 0.0) -> dict[str, Any]:
    joint = copy.deepcopy(ROLL)
    joint["revolute"]["spring"] = {"stiffness_N_m_per_rad": ROLL_STIFFNESS, "rest_rad": 0.0}
    joint["revolute"]["initial_angle_rad"] = angle_rad
    return joint


PAIR = {"port": {"position_m": [0, 7.0, -LEVEL]}, "starboard": {"position_m": [0, -7.0, -LEVEL]}}


def test_in_a_ship_at_rest_the_level_swings_about_that_of_the_sea_at_its_period():
    ds = kingpost.run(scenario(initial_rise_m=1.2, level_m=LEVEL))
    found = ds.kingpost["tank.water_level"].values
    # The potential is exactly quadratic; RK4 with 0.02 s errs by (w h)^5 / 120 a step.
    assert np.allclose(found, LEVEL + 1.2 * np.cos(FREQUENCY * ds["time"].values), atol=1e-6)


def test_the_water_comes_to_the_level_of_the_sea_whatever_level_the_scenario_states():
    given = scenario(position_m=[0, 7, -5.0], level_m=4.0, damping_ratio=0.2)
    ds = kingpost.run(given.with_overrides({"simulation.begin_at_equilibrium": True}))
    assert np.allclose(ds.kingpost["tank.water_level"].values, 5.0, atol=1e-6)


def matrices() -> tuple[np.ndarray, np.ndarray]:
    """M and K of roll and the two levels about the upright position, from the Lagrangian of the docs."""
    mass, y, centre = RHO * AREA * LEVEL, 7.0, -LEVEL / 2
    own = mass * (BREADTH**2 + LEVEL**2) / 12
    inertia = INERTIA + 2 * (own + mass * (y**2 + centre**2))
    coupling = [mass * y, -mass * y]
    m = np.diag([inertia, FLOW_MASS, FLOW_MASS])
    k = np.diag([ROLL_STIFFNESS - 2 * mass * G * centre, STIFFNESS, STIFFNESS])
    for i, side in enumerate([1.0, -1.0], start=1):
        m[0, i] = m[i, 0] = coupling[i - 1]
        k[0, i] = k[i, 0] = STIFFNESS * y * side
    return m, k


def test_roll_and_levels_have_the_modes_of_the_coupled_equations():
    m, k = matrices()
    expected = np.sqrt(np.sort(np.linalg.eigvals(np.linalg.solve(m, k)).real)) / (2 * np.pi)
    found = np.sort(np.asarray(kingpost.modes(scenario(sprung(), PAIR))["frequency"]))
    # Differences of the analysis: 1e-6.
    assert np.allclose(found, expected, rtol=1e-5)


def test_with_the_openings_closed_the_water_is_a_rigid_mass_of_the_ship():
    m, k = matrices()
    found = np.asarray(kingpost.modes(scenario(sprung(), PAIR, enabled=False))["frequency"])
    assert found == pytest.approx([np.sqrt(k[0, 0] / m[0, 0]) / (2 * np.pi)], rel=1e-5)


WAVE = {"waves": {"swell": {"regular": {"height_m": 0.4, "period_s": 9.0, "direction_deg": 90}}}}


def expected_level_in_waves() -> complex:
    """Amplitude of the level at y = 7 m, with the crest of waves along y over y = 0 at t = 0."""
    omega = 2 * np.pi / 9.0
    k = omega**2 / G
    critical = 2 * np.sqrt(STIFFNESS * FLOW_MASS)
    force = STIFFNESS * 0.2 * np.exp(-k * LEVEL) * np.exp(1j * k * 7.0)
    # e^(-i w t): the damping force is +i w c.
    return force / (STIFFNESS - omega**2 * FLOW_MASS - 1j * omega * 0.3 * critical)


def test_waves_move_the_level_by_their_pressure_at_the_opening():
    given = scenario(damping_ratio=0.3, waves=WAVE).with_overrides(
        {"simulation.duration_s": 90, "sea.ramp_s": 10}
    )
    ds = kingpost.run(given)
    time, level = ds["time"].values, ds.kingpost["tank.water_level"].values - LEVEL
    late = time > 90 - 3 * 9.0 + 1e-9
    fit = 2 * np.mean(level[late] * np.exp(1j * 2 * np.pi / 9.0 * time[late]))
    # The pressure by Wheeler's stretching differs from the linear by k times the elevation, 1 %.
    assert fit == pytest.approx(expected_level_in_waves(), rel=2e-2)


LINEAR = {"control": False} | {
    f"forces.tank_{side}.free_flooding_tank.{field}": value
    for side in ("port", "starboard")
    for field, value in (("loss_coefficient", 0.0), ("damping_ratio", 0.3))
}


def test_the_response_to_regular_waves_is_that_of_a_run():
    given, period_s = kingpost.load("roll_reduction_flooded_tanks", LINEAR), 10.0
    columns = ["hull.roll", "tank_port.water_level", "tank_starboard.water_level"]
    omega = 2 * np.pi / period_s
    expected = kingpost.wave_response(given, columns, [np.pi / 2], [omega])
    swell = {"swell": {"regular": {"height_m": 0.1, "period_s": period_s, "direction_deg": 90}}}
    ds = kingpost.run(given.with_overrides({"sea.waves": swell, "simulation.duration_s": 400}))
    time = ds["time"].values
    late = time >= 400 - 10 * period_s + 1e-9
    for column in columns:
        found = 2 * abs(np.mean(ds.kingpost[column].values[late] * np.exp(1j * omega * time[late])))
        # Of the first order in the steepness of the waves, 2e-3, and in the change of the roll's inertia.
        amplitude = float(expected["response"].sel(column=column).squeeze())
        assert found == pytest.approx(0.05 * amplitude, rel=1e-2), column


@pytest.mark.parametrize("one_side", [False, True])
def test_a_shifted_weight_heels_a_ship_by_her_waterplane_without_the_open_tanks(one_side: bool):
    """Source: lost waterplane (Barrass & Derrett, *Ship Stability for Masters and Mates*, ch. on bilging);
    tan(heel) = m y / (M GM). With one tank alone the centre of flotation moves too."""
    weight = {
        "parent": "hull",
        "mass_t": 4,
        "shape": {"point": {}},
        "joint": {"fixed": {"position_m": [0, 0, 0]}},
    }
    off = {"control": False, "hydrostatics": "mesh", "bodies.weight": weight}
    if one_side:
        off |= {"forces.tank_starboard.free_flooding_tank.enabled": False}
    heels, reports = [], []
    for y in (-2.0, 2.0):
        place = {"bodies.weight.joint.fixed.position_m": [0, y, 0]}
        (hull,) = kingpost.load("roll_reduction_flooded_tanks", off | place).hydrostatics["hulls"]
        heels.append(hull["heel_rad"])
        reports.append(hull)
    (hull, _) = reports
    assert len(hull["free_surfaces"]) == (1 if one_side else 2)
    metacentric_height = np.mean([report["metacentric_height_m"][0] for report in reports])
    # The weights of ship and water together, as the report has them, are what she displaces.
    assert hull["mass_kg"] == pytest.approx(hull["displacement_kg"], rel=1e-6)
    turned = 4e3 * 4.0 / (hull["mass_kg"] * metacentric_height)
    assert heels[0] - heels[1] == pytest.approx(turned, rel=2e-4)


def test_the_pump_lifts_the_water_by_its_pressure_over_the_specific_weight():
    simulation = kingpost.Simulation(scenario(damping_ratio=0.7, air_pump=PUMP))
    simulation.set_input("tank", -0.5)
    ds = simulation.run()
    assert float(ds.kingpost["tank.water_level"][-1]) == pytest.approx(LEVEL + 1.0e4 / (RHO * G), rel=1e-3)
    assert float(ds.kingpost["tank.air_pressure"][-1]) == pytest.approx(-1.0e4, rel=1e-6)
    assert (ds.kingpost["tank.air_power"].values >= 0.0).all()


def test_within_its_flow_the_pump_follows_the_command_with_its_lag():
    pump = {"pressure_limit_Pa": 2.0e4, "flow_limit_m3_s": 400.0, "response_time_s": 0.8}
    simulation = kingpost.Simulation(scenario(damping_ratio=0.1, initial_rise_m=0.5, air_pump=pump))
    simulation.set_input("tank", 0.6)
    ds = simulation.run()
    expected = 1.2e4 * (1.0 - np.exp(-ds["time"].values / 0.8))
    # RK4: (h / T)^4 / 120 of the command.
    assert np.allclose(ds.kingpost["tank.air_pressure"].values, expected, atol=1e-3)


def test_the_air_above_a_pump_that_gives_no_flow_is_a_spring():
    """w^2 = (rho g A + 1.4 p_atm A / h) / m with the height h of the air; to first order in the rise."""
    pump = {"pressure_limit_Pa": 2.0e4, "flow_limit_m3_s": 1e-9}
    simulation = kingpost.Simulation(scenario(initial_rise_m=1e-3, air_pump=pump))
    ds = simulation.run()
    # At the start, with the level raised, the air has the pressure of the atmosphere.
    air = 1.4 * 101325.0 * AREA / (7.0 - LEVEL)
    frequency = np.sqrt((STIFFNESS + air) / FLOW_MASS)
    rest = 1e-3 * air / (STIFFNESS + air)
    expected = LEVEL + rest + (1e-3 - rest) * np.cos(frequency * ds["time"].values)
    assert np.allclose(ds.kingpost["tank.water_level"].values, expected, atol=2e-6)


def test_the_energy_closes_with_losses_pump_and_waves_at_large_angles():
    given = scenario(
        sprung(0.15), PAIR, damping_ratio=0.05, loss_coefficient=2.6, air_pump=PUMP, waves=WAVE
    ).with_overrides({"sea.waves.swell.regular.height_m": 2.0})
    errors = []
    for step_s in (0.04, 0.02):
        simulation = kingpost.Simulation(given.with_overrides({"simulation.step_s": step_s}))
        simulation.set_input("port", -0.7)
        simulation.set_input("starboard", 0.4)
        errors.append(float(np.abs(simulation.run()["energy_error"]).max()))
    # RK4; the loss, quadratic in the flow, has a kink in its curvature where the flow turns.
    assert errors[1] < errors[0] / 6
    assert errors[1] < 1e-5 * 0.5 * ROLL_STIFFNESS * 0.15**2


def test_a_tank_out_of_the_water_drains_and_gives_a_warning():
    given = scenario(position_m=[0, 7, 0.5], damping_ratio=0.3, loss_coefficient=2.6)
    with pytest.warns(kingpost.KingpostWarning, match="air reached its opening"):
        ds = kingpost.run(given)
    # It stands on the stop, 50 times as stiff as the levels.
    assert float(ds.kingpost["tank.water_level"][-1]) == pytest.approx(0.0, abs=0.15)


def test_a_level_that_reaches_the_top_gives_a_warning():
    pump = {"pressure_limit_Pa": 6.0e4, "flow_limit_m3_s": 60.0}
    simulation = kingpost.Simulation(scenario(loss_coefficient=2.6, air_pump=pump))
    simulation.set_input("tank", -1.0)
    with pytest.warns(kingpost.KingpostWarning, match=r"its water reached its top, 7 m"):
        simulation.run()


@pytest.mark.parametrize(
    ("field", "value", "said"),
    [
        ("level_m", 7.5, "less than height_m"),
        ("initial_rise_m", 3.2, "less than the room above the level"),
        ("initial_rise_m", -4.1, "less than the depth down to the opening"),
        ("opening_area_m2", 13.0, "at most length_m times breadth_m"),
        ("body", "barge", "one of ship"),
        ("air_pump", PUMP | {"pressure_limit_Pa": 2e5}, "less than the pressure of the atmosphere"),
    ],
)
def test_an_impossible_tank_is_refused_with_its_field(field: str, value: Any, said: str):
    with pytest.raises(kingpost.ScenarioError, match=said) as caught:
        kingpost.Simulation(scenario(**{field: value}))
    assert f"forces.tank.free_flooding_tank.{field}" in str(caught.value)


@pytest.mark.thorough
def test_the_pumped_tanks_of_the_gallery_reduce_roll_at_resonance_by_more_than_half():
    def roll(**given: Any) -> float:
        ds = kingpost.run(kingpost.load("roll_reduction_flooded_tanks", given))
        return float(np.degrees(ds.kingpost["hull.roll"].values[500:]).std())

    closed, passive, pumped = roll(tanks=False), roll(control=False), roll()
    assert pumped < 0.5 * closed
    assert pumped < passive < closed

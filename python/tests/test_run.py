"""The paper's case through Python: the calibration row, what a dataset carries, overrides."""

from __future__ import annotations

import json

import kingpost
import numpy as np
import pytest
from samples import TRUTH


def at_the_end(results) -> dict[str, float]:
    last = results.isel(time=-1)
    rate = last["angular_velocity"].sel(body="ship")
    joint = {name: last.sel(coordinate=name) for name in ("slew", "luff")}
    return {
        "pitch rate": rate.sel(axis="y").item(),
        "yaw rate": rate.sel(axis="z").item(),
        "roll rate": rate.sel(axis="x").item(),
        **{f"{name} rate": values["joint_velocity"].item() for name, values in joint.items()},
        **{name: values["joint_position"].item() for name, values in joint.items()},
    }


def test_the_calibration_run_gives_the_digits_of_three_independent_codes(calibration):
    """Source: samples.TRUTH."""
    found = at_the_end(calibration)
    for name, (value, tolerance) in TRUTH.items():
        assert found[name] == pytest.approx(value, abs=tolerance), name


def test_work_of_the_motor_is_kinetic_energy_and_momentum_stays_zero(calibration):
    """Source: conservation; RK4 at 1 ms leaves errors far below the 7e-7 of 10 ms."""
    last = calibration.isel(time=-1)
    assert last["kinetic_energy"].item() == pytest.approx(last["work_by_drives"].item(), rel=1e-9)
    assert last["momentum_error"].item() < 1e-4
    assert np.abs(last["angular_momentum"]).max() < 1e-4


def test_the_work_of_a_constant_motor_torque_is_torque_times_angle(calibration):
    """Source: the work of a constant torque is torque times angle, 100,000 N m here."""
    turned = calibration["joint_position"].sel(coordinate="slew")[-1].item()
    assert calibration["work_by_drives"][-1].item() == pytest.approx(1e5 * turned, rel=1e-9)


def test_a_dataset_has_the_dimensions_and_variables_of_the_contract(calibration):
    """Source: the project's public contract."""
    sizes = {"time": 51, "body": 3, "axis": 3, "coordinate": 2, "joint": 3, "quaternion": 4}
    for name, size in sizes.items():
        assert calibration.sizes[name] == size, name
    dims = {
        "position": ("time", "body", "axis"),
        "orientation": ("time", "body", "quaternion"),
        "roll": ("time", "body"),
        "velocity": ("time", "body", "axis"),
        "angular_velocity": ("time", "body", "axis"),
        "acceleration": ("time", "body", "axis"),
        "joint_position": ("time", "coordinate"),
        "joint_velocity": ("time", "coordinate"),
        "joint_force": ("time", "coordinate"),
        "joint_reaction": ("time", "joint", "component"),
        "point_position": ("time", "point", "axis"),
        "kinetic_energy": ("time",),
        "potential_energy": ("time",),
        "work_done": ("time",),
        "energy_dissipated": ("time",),
        "linear_momentum": ("time", "axis"),
        "angular_momentum": ("time", "axis"),
    }
    for name, expected in dims.items():
        assert calibration[name].dims == expected, name
    assert list(calibration["body"].values) == ["ship", "tower", "arm"]
    assert list(calibration["coordinate"].values) == ["slew", "luff"]
    assert calibration["time"].values == pytest.approx(np.linspace(0, 0.5, 51))


def test_every_variable_has_a_unit_a_name_and_a_frame(calibration):
    """Source: the project's public contract."""
    for name, variable in calibration.variables.items():
        if "time" not in variable.dims:
            continue
        assert set(variable.attrs) >= {"long_name", "description", "frame", "column"}, name
        assert ("units" in variable.attrs) != (f"{name}_unit" in calibration.coords), name
        frames = ("world", "body", "joint", "loop", "surface", "slow_frame", "heading", "none")
        assert variable.attrs["frame"] in frames
    assert calibration["angular_velocity"].attrs["units"] == "rad/s"
    assert calibration["angular_velocity"].attrs["frame"] == "body"


def test_a_dataset_stores_the_scenario_that_made_it(calibration, tmp_path):
    """Source: reproducibility; the stored scenario, run again, gives the same bits."""
    stored = tmp_path / "again.json"
    stored.write_text(calibration.attrs["scenario"], encoding="utf-8")
    again = kingpost.run(stored)
    for name in calibration.data_vars:
        assert np.array_equal(again[name], calibration[name]), name


def test_a_dataset_contains_versions_seed_status_gravity_and_density(calibration):
    """Source: the project's public contract; this case has neither gravity nor water."""
    attributes = calibration.attrs
    assert json.loads(attributes["versions"])["kingpost"] == kingpost.__version__
    assert attributes["seed"] == 0
    assert attributes["status"] == "finished"
    assert attributes["gravity_m_s2"] == 0
    assert attributes["water_density_kg_m3"] == 0


def test_a_run_with_gravity_has_it_in_the_attributes():
    """Source: the standard acceleration, 9.80665 m/s2."""
    results = kingpost.run("paper", {"simulation.duration_s": 0.02}, gravity=True)
    assert results.attrs["gravity_m_s2"] == 9.80665


def test_setting_a_parameter_equals_setting_the_path_that_it_writes():
    """Source: the parameter mechanism, one meaning for every way to set a value."""
    by_name = kingpost.load("paper", crane_x_m=3, motor_2=True)
    path = "bodies.tower.joint.revolute.position_m.0"
    by_path = kingpost.load("paper", {path: 3, "drives.motor_2.motor.enabled": True})
    one, other = (kingpost.Simulation(scenario) for scenario in (by_name, by_path))
    one.step(20)
    other.step(20)
    assert np.array_equal(one.row(), other.row())


def test_overrides_take_numpy_numbers():
    """Source: arrays are where overrides of a sweep come from."""
    scenario = kingpost.load("paper", crane_x_m=np.float64(2.5), motor_1=np.bool_(False))
    assert scenario.resolved["drives"]["motor_1"]["motor"]["enabled"] is False


def test_the_last_value_of_an_override_counts():
    """Source: the documented order of overrides."""
    scenario = kingpost.load("paper", crane_x_m=1).with_overrides(crane_x_m=2)
    assert scenario.resolved["bodies"]["tower"]["joint"]["revolute"]["position_m"][0] == 2


def test_a_run_accepts_a_scenario_with_further_overrides():
    """Source: the public contract of `run`."""
    scenario = kingpost.load("paper", {"simulation.duration_s": 0.02})
    assert float(kingpost.run(scenario, {"simulation.duration_s": 0.04}).time[-1]) == pytest.approx(0.04)


def test_the_published_default_position_is_the_stern_corner():
    """Source: the paper's Table 2: 10 m aft, 5 m to starboard; both motors' torques."""
    resolved = kingpost.load("paper").resolved
    assert resolved["bodies"]["tower"]["joint"]["revolute"]["position_m"] == [-10, -5, 0]
    torques = [resolved["drives"][name]["motor"]["torque_N_m"] for name in ("motor_1", "motor_2")]
    assert torques == [100_000, 70_000]

"""A run that diverges stops, says when and which body, and keeps what it computed."""

from __future__ import annotations

import kingpost
import numpy as np
import pytest
import xarray
from kingpost.cli import main

EULER = {
    "simulation.integrator": "forward_euler",
    "simulation.step_s": 0.05,
    "simulation.record_every_s": 0.05,
}
CRANE = {"centre": {"crane_x_m": 0, "crane_y_m": 0}, "corner": {"crane_x_m": -10, "crane_y_m": -5}}
MOTORS = {"motor_1": True, "motor_2": True, "load": False}


@pytest.mark.parametrize("place", CRANE)
def test_forward_euler_at_50_ms_diverges_and_keeps_the_results(place):
    """Source: known blow-up of both motors, no load, held: past 1,000 rad/s after about 1.1 s."""
    with pytest.raises(kingpost.RunError) as caught:
        kingpost.run("paper", {**EULER, **CRANE[place], **MOTORS})
    error = caught.value
    assert 0.5 < error.time_s < 3
    assert error.body in ("ship", "tower", "arm")
    assert error.limit == 1e4
    assert abs(error.value) > error.limit or not np.isfinite(error.value)
    assert error.body in str(error)
    times = error.results["time"].values
    assert len(times) > 10
    assert times[-1] < error.time_s + 1e-9
    assert np.isfinite(error.results["angular_velocity"]).all()
    assert np.abs(error.results["angular_velocity"]).max() < 1e4
    assert error.results.attrs["status"] == str(error)


@pytest.mark.parametrize("place", CRANE)
def test_the_command_ends_with_exit_code_1_and_the_file_written(place, tmp_path, capsys):
    """Source: the public contract: 1 the run failed, what was computed kept."""
    output = tmp_path / "diverged.nc"
    overrides = {**EULER, **CRANE[place], **MOTORS}
    settings = [f"--set={name}={value}".replace("True", "on").replace("False", "off")
                for name, value in overrides.items()]  # fmt: skip
    assert main(["run", "paper", *settings, "-o", str(output)]) == 1
    shown = capsys.readouterr()
    *warnings, error = shown.err.splitlines()
    assert error.startswith("error: ")
    assert [line[:16] for line in warnings] == ["warning: energy:"]
    assert str(output) in shown.out
    with xarray.load_dataset(output, engine="h5netcdf") as results:
        assert results.attrs["status"] in shown.err
        assert results.sizes["time"] > 10


def test_a_lower_rate_limit_stops_a_healthy_run():
    """Source: the tower of the calibration run passes 5 rad/s before 0.5 s."""
    with pytest.raises(kingpost.RunError) as caught:
        kingpost.run("paper", {"simulation.rate_limit": 5.0}, crane_x_m=0, crane_y_m=0)
    assert 0.3 < caught.value.time_s < 0.5
    assert caught.value.limit == 5


def test_stepping_by_hand_stops_at_the_last_good_step():
    """Source: the public contract of `Simulation.step`."""
    simulation = kingpost.Simulation(kingpost.load("paper", {**EULER, **CRANE["centre"], **MOTORS}))
    with pytest.raises(kingpost.RunError) as caught:
        simulation.step(60)
    assert simulation.time_s <= caught.value.time_s
    assert np.isfinite(simulation.row()).all()

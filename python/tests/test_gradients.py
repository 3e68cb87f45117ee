"""Gradients of runs by dual numbers against central differences of runs."""

from __future__ import annotations

import itertools
from collections.abc import Iterator

import kingpost
import numpy as np
import pandas
import pytest
import xarray
from kingpost import gallery
from kingpost.results import frame, write
from lanes import THOROUGH, sampled
from samples import SMALL

SHORT = {"simulation.duration_s": 0.2, "simulation.record_every_s": 0.1}
ROUNDING = 1e-11
"""Of a run's numbers: what some hundred steps leave of double precision."""


KEPT = {
    ("barge", "significant_height_m"): "a wave height",
    ("dual_draglink_heave_compensation", "cylinder_stiffness"): "a stiffness",
    ("flexible_boom", "youngs_modulus"): "the modulus of a boom that bends",
    ("heave_compensation", "position_gain_per_s"): "a controller",
    ("lowering_by_winch", "load_t"): "a mass, on a rope",
    ("offshore_vessel", "rope_length_m"): "a rope",
    ("offshore_vessel_on_dp", "wind_speed_m_s"): "a wind",
    ("paper", "crane_x_m"): "a place",
    ("roll_reduction_tank", "tank_damping_ratio"): "a damping",
}
"""One number of each class. The thorough lane reads all of the gallery, which takes a while to collect."""
KEPT_WITHOUT = [("barge", "peak_period_s"), ("slew_without_swing", "slew_time_s")]


def numeric_parameters() -> Iterator[tuple[bool, tuple[str, str]]]:
    """The parameters of the gallery whose value is a number, and whether they have a derivative."""
    for name in gallery.names():
        scenario = kingpost.load(name)
        written = {about["name"]: about["writes"] for about in scenario.resolved["parameters"]}
        for parameter in scenario.model["parameters"]:
            value = parameter["value"]
            if isinstance(value, int | float) and not isinstance(value, bool):
                yield is_smooth(written[parameter["name"]]), (name, parameter["name"])


def is_smooth(writes: list[str]) -> bool:
    """Whether a parameter changes neither which waves the sea is the sum of, anything but a height, nor when
    a step of an operation ends."""
    return not any(
        (path.startswith("sea.waves.") and not path.endswith("height_m"))
        or (path.startswith("operation.") and path.endswith("_s"))
        for path in writes
    )


def in_waves(name: str) -> dict[str, bool | float]:
    """A short run; waves run where there are any, from the start.

    It begins where the bodies are put: where along surge, sway and yaw a free ship comes to rest is no
    function of its parameters. The engine's tests hold the derivatives of an equilibrium.
    """
    parameters = kingpost.load(name).resolved["parameters"]
    waves = any(parameter["name"] == "waves" for parameter in parameters)
    here = {"simulation.begin_at_equilibrium": False}
    return SHORT | here | ({"waves": True, "sea.ramp_s": 0} if waves else {})


NUMBERS = list(numeric_parameters()) if THOROUGH else []
SMOOTH = [pair for smooth, pair in NUMBERS if smooth] if THOROUGH else list(KEPT)
NOT_SMOOTH = [pair for smooth, pair in NUMBERS if not smooth] if THOROUGH else KEPT_WITHOUT


def inside(parameter: dict) -> tuple[float, float]:
    """A value of a parameter with room on both sides, and a step to either."""
    value = float(parameter["value"])
    lower, upper = parameter.get("range") or (value - max(1, abs(value)), value + max(1, abs(value)))
    room = 0.02 * (upper - lower)
    return min(max(value, lower + room), upper - room), 1e-4 * (upper - lower)


@pytest.fixture
def without_a_look_at_the_step(monkeypatch) -> None:
    """The warning about a step that is too long needs all eigenvalues: half the time of these tests."""
    monkeypatch.setattr("kingpost.simulation.step_limit.warning", lambda *_: None)


@pytest.mark.usefixtures("without_a_look_at_the_step")
@pytest.mark.parametrize(("name", "parameter"), sampled(SMOOTH, keep=KEPT))
def test_derivatives_agree_with_central_differences_to_their_error(name, parameter):
    """Source: differences with steps h and 2 h, whose own error is a third of what they differ by,
    and rounding over the step. At an event derivatives follow the flow, differences the steps of the
    scheme: there they may differ by what half the step of the scheme changes."""
    (about,) = (p for p in kingpost.load(name).model["parameters"] if p["name"] == parameter)
    value, step = inside(about)
    scenario = kingpost.load(name, in_waves(name))
    found = kingpost.gradient(scenario, parameter, {parameter: value})

    half_step = {"simulation.step_s": scenario.model["step_s"] / 2}
    runs = kingpost.Batch(scenario, {parameter: [value + by * step for by in (1, -1, 2, -2)]}).run()
    fine, coarse = (_difference(runs, first) / (2 * by * step) for first, by in ((0, 1), (2, 2)))
    of_the_scheme = 0 * fine
    if kingpost.run(scenario, {parameter: value}).sizes["event"]:
        finer = kingpost.Batch(scenario, {parameter: [value + step, value - step]}, half_step).run()
        of_the_scheme = fine - _difference(finer, 0) / (2 * step)
    # Where the work of the drives passes zero, the energy and the momentum in play, roots of squares, have a
    # kink.
    work = runs["work_by_drives"]
    kink = bool((work.isel(run=2) * work.isel(run=3) < 0).any())
    compared = 0
    for variable in fine.data_vars:
        exact = found[f"{variable}_derivative"].isel(parameter=0)
        assert np.isfinite(exact).all(), variable
        # The ledger's errors are themselves of the size of rounding.
        if str(variable).endswith("_error") or not exact.size:
            continue
        bound = 2 * np.abs(fine[variable] - coarse[variable]).max()
        bound += ROUNDING * (np.abs(found[variable]).max() + scale(found, str(variable))) / step
        bound += np.abs(of_the_scheme[variable]).max()
        holds = np.abs(exact - fine[variable]).max() <= bound
        assert holds or (kink and str(variable).endswith("_scale")), variable
        compared += 1
    assert compared > 10


def _difference(runs: xarray.Dataset, first: int) -> xarray.Dataset:
    """Difference of a run of a batch and of the next."""
    ahead, behind = (runs.isel(run=run, drop=True).reset_coords(drop=True) for run in (first, first + 1))
    return ahead - behind


@pytest.mark.parametrize(("name", "parameter"), sampled(NOT_SMOOTH, keep=KEPT_WITHOUT))
def test_a_sea_of_other_waves_and_a_time_of_an_operation_have_no_derivative(name, parameter):
    """Source: the public contract: one realisation of a sea changes continuously by its height alone, and an
    operation looks at its times at the steps."""
    with pytest.raises(kingpost.ScenarioError, match=f"^{parameter}: found a number without a derivative"):
        kingpost.gradient(kingpost.load(name, in_waves(name)), parameter)


def scale(run: xarray.Dataset, variable: str) -> float:
    """Numbers that a variable is the difference of; an angle that symmetry makes zero has the rounding
    of the others."""
    energies = [np.abs(run[name]).max().item() for name in ("kinetic_energy", "potential_energy")]
    unit = run[variable].attrs.get("units")
    if unit == "rad":
        angles = [run[name] for name in run.data_vars if run[name].attrs.get("units") == unit]
        return max(np.abs(angle).max().item() for angle in angles if angle.size)
    is_wrench = unit is None and run[f"{variable}_unit"].dims == ("component",)
    return max(energies) if is_wrench or unit in ("J", "N", "N m", "N m s") else 0.0


def test_a_gradient_contains_the_run_and_its_derivatives(tmp_path):
    """Source: the public contract."""
    names = ["crane_x_m", "bodies.arm.mass_kg", "crane_y_m", "crane_z_m", "bodies.tower.mass_kg"]
    found = kingpost.gradient("paper", names, SHORT)
    run = kingpost.run("paper", SHORT)
    for name, variable in run.data_vars.items():
        if "time" not in variable.dims:
            continue
        xarray.testing.assert_identical(found[name], variable)
        assert found[f"{name}_derivative"].dims == ("parameter", *variable.dims)
        assert found[f"{name}_derivative"].attrs["frame"] == variable.attrs["frame"]
    assert found.parameter.values.tolist() == names
    assert found.parameter_unit.values.tolist() == ["m", "", "m", "m", ""]
    alone = kingpost.gradient("paper", "crane_z_m", SHORT)
    assert np.array_equal(alone.roll_derivative[0], found.roll_derivative.sel(parameter="crane_z_m"))
    again = xarray.load_dataset(write(found, tmp_path / "gradient.nc"), engine="h5netcdf")
    xarray.testing.assert_identical(again, found)
    table = pandas.read_parquet(write(found, tmp_path / "gradient.parquet"))
    pandas.testing.assert_frame_equal(table, frame(found), check_exact=True)
    assert "ship.roll_derivative.bodies.arm.mass_kg" in table.columns


def test_the_work_of_a_motor_is_torque_times_angle_with_its_derivative():
    """Source: W = T a; dW/dT = a + T da/dT."""
    found = kingpost.gradient("paper", "drives.motor_1.motor.torque_N_m", SHORT).isel(time=-1)
    angle = found.sel(coordinate="slew")
    expected = angle.joint_position + 1e5 * angle.joint_position_derivative[0]
    assert found.work_by_drives_derivative[0].item() == pytest.approx(expected.item(), rel=1e-9)


@pytest.mark.parametrize("name", ["torque_history", "motor_2", "nothing", "simulation.step_s"])
def test_a_parameter_without_a_derivative_is_refused(name):
    """Source: the public contract: what switches, is not there, or changes how the run is stepped."""
    with pytest.raises(kingpost.ScenarioError):
        kingpost.gradient("paper", name)


def test_no_names_are_refused():
    """Source: the public contract."""
    with pytest.raises(kingpost.KingpostError, match="at least one name"):
        kingpost.gradient("paper", [])


def test_a_run_that_diverges_keeps_its_results(tmp_path):
    """Source: the public contract of `run`: the error carries the results until then."""
    path = tmp_path / "small.yaml"
    path.write_text(SMALL, encoding="utf-8")
    settings = {"simulation.rate_limit": 0.1, "simulation.duration_s": 1}
    with pytest.raises(kingpost.RunError) as plain:
        kingpost.run(path, settings)
    with pytest.raises(kingpost.RunError) as caught:
        kingpost.gradient(path, "mass", settings)
    assert caught.value.time_s == plain.value.time_s
    assert caught.value.results is not None
    assert caught.value.results.sizes["time"] == plain.value.results.sizes["time"]
    assert caught.value.results.attrs["status"] == str(plain.value)
    assert np.isfinite(caught.value.results.joint_position_derivative).all()


def test_progress_is_called_for_every_four_names():
    """Source: the public contract: once through the run for every four names."""
    heard: list[float] = []
    names = [f"bodies.{body}.mass_kg" for body in ("arm", "tower")] + ["crane_x_m", "crane_y_m", "crane_z_m"]
    kingpost.gradient("paper", names, {"simulation.duration_s": 2}, progress=heard.append)
    restarts = sum(later < earlier for earlier, later in itertools.pairwise(heard))
    assert restarts == 1


def test_a_stopped_gradient_keeps_its_results():
    """Source: the public contract: the results until then, for the names that were reached."""
    heard: list[float] = []

    def stop_in_the_second_round(time_s: float) -> None:
        heard.append(time_s)
        if any(later < earlier for earlier, later in itertools.pairwise(heard)) and time_s > 0.5:
            raise KeyboardInterrupt

    names = ["crane_x_m", "crane_y_m", "crane_z_m", "bodies.arm.mass_kg", "bodies.tower.mass_kg",
             "bodies.ship.mass_kg", "bodies.arm.joint.revolute.initial_rate_rad_s",
             "bodies.tower.joint.revolute.initial_rate_rad_s", "drives.motor_1.motor.torque_N_m"]  # fmt: skip
    with pytest.raises(KeyboardInterrupt) as caught:
        kingpost.gradient("paper", names, {"simulation.duration_s": 2}, progress=stop_in_the_second_round)
    found = caught.value.results
    assert found.parameter.values.tolist() == names[:8]
    assert 0.5 < found.time.values[-1] < 2
    assert found.attrs["status"] == "interrupted"
    assert np.isfinite(found.roll_derivative).all()

"""The longest stable step compared with runs."""

from __future__ import annotations

import kingpost
import numpy as np
import pytest
from kingpost import gallery
from kingpost.analysis.stable_step import stable_step
from kingpost.cli import main
from kingpost.simulation.step_limit import longest_step_s, warning

STEP = "simulation.step_s"


def roll_of(step_s: float) -> np.ndarray:
    """Of a vessel whose crane's cylinders are stiff, deg, every half second."""
    overrides = {STEP: step_s, "simulation.duration_s": 5, "simulation.record_every_s": 0.5}
    return np.degrees(
        kingpost.run("vessel_knuckle_boom", overrides)["roll"].sel(body="vessel_hull").to_numpy()
    )


def test_a_cylinder_is_stable_below_the_limit_and_not_beyond() -> None:
    """Source: runs at 10 ms and at 2 ms agree, one at 25 ms does not, and the limit is between."""
    limit = stable_step("vessel_knuckle_boom")
    assert limit is not None
    assert 0.01 < limit < 0.02
    fine, short, long = (roll_of(step_s) for step_s in (0.002, 0.01, 0.025))
    size = np.ptp(fine)
    assert np.abs(short - fine).max() < 1e-3 * size
    assert np.abs(long - fine).max() > 0.05 * size


@pytest.mark.parametrize("scheme", ["dormand_prince", "generalized_alpha", "implicit_midpoint", "newmark"])
def test_schemes_without_a_limit_have_none(scheme: str) -> None:
    scenario = kingpost.load("flexible_boom", {"simulation.integrator": scheme, STEP: 0.01})
    assert stable_step(scenario) is None
    assert kingpost.Simulation(scenario).model_warnings == []


def test_a_damped_motion_has_the_limit_of_its_scheme() -> None:
    """Source: 1 + z of Euler's method ends at z = -2, the polynomial of Kutta's at -2.785."""
    euler, kutta = (
        stable_step(kingpost.load("flexible_boom", {"simulation.integrator": scheme}))
        for scheme in ("forward_euler", "rk4")
    )
    assert euler is not None
    assert kutta is not None
    assert kutta / euler == pytest.approx(2.785293563405282 / 2, rel=1e-3)


def of_winch(damping: float, step_s: float) -> kingpost.Scenario:
    """An anchor on 200 m of wire with mass, from a winch of 335 t m2 with this damping, kN m s/rad."""
    path = "drives.hoist.controlled_drive.damping_kN_m_s_per_rad"
    overrides = {path: damping, STEP: step_s, "simulation.duration_s": 30}
    return kingpost.load("deep_water_lowering", overrides)


def test_a_stiff_winch_on_a_line_limits_the_step() -> None:
    """Source: damping over inertia is 59.7 1/s; to it add at most the drum's friction, 2 % of 902 kN smoothed
    over 10 mm/s at 1.5 m, and the waves of the line, radius^2 sqrt(EA m): 12.2 and 1.0 1/s. Runs balance
    below the limit and not beyond."""
    limit = stable_step(of_winch(20_000, 0.05))
    assert limit is not None
    assert 2.785293563405282 / (59.7 + 12.2 + 1.0) < limit < 2.785293563405282 / 59.7
    [warned] = kingpost.Simulation(of_winch(20_000, 0.05)).model_warnings
    assert "is too long for rk4" in warned
    off = {}
    for step_s in (0.035, 0.05):
        run = kingpost.run(of_winch(20_000, step_s))
        off[step_s] = float(np.abs(run.energy_error).max() / run.energy_scale.max())
    assert off[0.035] < 1e-4
    assert off[0.05] > 0.1
    assert kingpost.Simulation(of_winch(5_000, 0.05)).model_warnings == []


def test_motions_without_damping_and_growing_motions_set_no_short_limit() -> None:
    """Source: Kutta's polynomial is stable to |z| = sqrt(8) on the imaginary axis; what grows by itself grows
    at any step."""
    swing = np.array([[0.0, 1.0, 0.0], [-9.0, 0.0, 0.0], [0.0, 0.0, -1.0]])
    line = np.array([False, False, True])
    assert longest_step_s("rk4", swing, line, 0.05) == pytest.approx(np.sqrt(8) / 3, rel=1e-3)
    grows = np.diag([0.1, -10.0, -1.0])
    assert longest_step_s("rk4", grows, line, 0.05) == pytest.approx(0.2785293563405282, rel=1e-3)


def test_a_matrix_that_is_not_finite_is_reported() -> None:
    linear = np.array([[np.nan]]), np.array([False])
    settings = {"integrator": "rk4", "step_s": 0.05}
    assert "not estimated" in str(warning(settings, lambda: linear))


def test_every_scenario_of_the_gallery_has_a_stable_step(shown) -> None:
    warned = {
        name: shown[name]["model_warnings"] for name in gallery.names() if shown[name]["model_warnings"]
    }
    # Its four chains have no inertia.
    massless = "offshore_vessel_moored_quasi_static"
    assert list(warned) == [massless]
    assert all("its inertia and drag are left out" in text for text in warned[massless])


def test_check_and_run_warn_about_a_step_that_is_too_long(capsys, tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["check", "vessel_knuckle_boom", "--set", f"{STEP}=0.02"]) == 0
    assert "the step of 0.02 s is too long for rk4" in capsys.readouterr().err
    short = ["--set", "simulation.duration_s=0.1", "--set", "simulation.record_every_s=0.1"]
    main(["run", "vessel_knuckle_boom", "--set", f"{STEP}=0.02", *short])
    assert "grows with steps longer than 0.018 s" in capsys.readouterr().err

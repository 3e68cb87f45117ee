"""Runs of lines with mass in waves: derivatives of peaks and means, lanes, snapshots, and the ledger of long
runs."""

from __future__ import annotations

import copy
from functools import cache
from typing import Any

import kingpost
import numpy as np
import pytest
import xarray
from kingpost.verify.models import GRAVITY, G, scenario, settings
from line_cases import between, fixed, hanging, section

HEIGHT = "sea.waves.sea.jonswap.significant_height_m"
OF_SECTION = "forces.fore.line.sections.0."
VALUES = {
    OF_SECTION + "axial_stiffness_N": (5e8, 1e-4),
    OF_SECTION + "unstretched_length_m": (60.0, 1e-5),
    OF_SECTION + "drag_across": (1.3, 1e-4),
    HEIGHT: (2.0, 1e-4),
}
"""Values, and steps of differences as shares of them: shorter for the length, which stretches the line."""


@cache
def moored(duration_s: float = 8.0) -> kingpost.Scenario:
    """A buoy of 60 t in irregular waves on two chains with clump weights, which lie on the seabed."""
    upper = section(
        60.0,
        4,
        mass_kg_per_m=120.0,
        diameter_m=0.14,
        axial_stiffness_N=5e8,
        damping_time_s=0.01,
        drag_across=1.3,
        drag_along=0.05,
        added_mass_along=0.5,
    )
    lower = {**upper, "unstretched_length_m": 70.0}
    upper["clump_weight"] = {"mass_kg": 3000, "volume_m3": 0.5, "drag_area_m2": 1.0}

    def line(anchor_m: list[float]) -> dict[str, Any]:
        ends = {
            "first": {"body": "buoy", "position_m": [0, 0, -2.5]},
            "second": {"body": "world", "position_m": anchor_m},
        }
        rest = {"seabed": {"friction": 0.7}, "points_along": 5}
        return {"line": {**ends, "sections": copy.deepcopy([upper, lower]), **rest}}

    ball = {"sphere": {"radius_m": 3.0}}
    buoy = {
        "mass_kg": 60e3,
        "shape": ball,
        # Where it rests, to 1 mm.
        "joint": {"floating": {"hold_rotation": True, "initial": {"position_m": [0, 0, -0.833]}}},
    }
    water = {
        "body": "buoy",
        "shape": ball,
        "added_mass": {"coefficients": [0.5, 0.5, 0.5]},
        "drag": {"coefficients": [0.8, 0.8, 0.8]},
    }
    waves = {"jonswap": {"significant_height_m": 2.0, "peak_period_s": 8.0, "gamma": 3.3}}
    forces = {"fore": line([110, 0, -50]), "aft": line([-110, 0, -50]), "water": {"submerged": water}}
    return scenario(
        {"buoy": buoy},
        GRAVITY | forces,
        simulation=settings(0.05, duration_s, integrator="rk4"),
        sea={"depth_m": 50, "waves": {"sea": waves}},
    )


@cache
def derivatives() -> xarray.Dataset:
    """Four names cost about one run."""
    return kingpost.gradient(moored(), list(VALUES))


@pytest.mark.parametrize("path", VALUES, ids=[path.rsplit(".", 1)[1] for path in VALUES])
def test_peak_and_mean_tension_in_irregular_waves_have_the_derivatives_of_differences(path):
    """Source: differences with steps h and 2 h, whose error is a third of their difference. The derivative
    of a peak is that of its row."""
    value, share = VALUES[path]
    step = share * value
    found = derivatives().sel(parameter=path)
    runs = kingpost.Batch(moored(), {path: [value + by * step for by in (1, -1, 2, -2)]}).run()
    tension, peak = (
        found["line_tension"].sel(line="fore"),
        int(found["line_tension"].sel(line="fore").argmax("time")),
    )
    exact = found["line_tension_derivative"].sel(line="fore")
    of_runs = runs["line_tension"].sel(line="fore")
    assert 0 < peak < tension.sizes["time"] - 1
    for derivative, numbers in (
        (float(exact.mean()), of_runs.mean("time")),
        (float(exact[peak]), of_runs.max("time")),
    ):
        plus, minus, twice, back = (float(number) for number in numbers)
        fine, coarse = (plus - minus) / (2 * step), (twice - back) / (4 * step)
        # Newton's method leaves 1e-12 of the tension.
        bound = 2 * abs(fine - coarse) + 1e-6 * abs(derivative) + 1e-11 * float(tension.max()) / step
        assert abs(derivative - fine) <= bound, (derivative, fine, coarse)
        assert abs(derivative) > 10 * bound


def equal(found: xarray.Dataset, alone: xarray.Dataset) -> None:
    """Compares all variables over time bit by bit."""
    compared = [str(name) for name in alone.data_vars if "time" in alone[name].dims]
    assert {"line_tension", "line_tension_along", "line_touchdown", "energy_error"} < set(compared)
    for name in compared:
        np.testing.assert_array_equal(found[name].values, alone[name].values, err_msg=name)


def test_lanes_of_different_seas_have_the_bits_of_single_runs():
    """Source: the runs one by one; the lanes differ in their waves, contacts and slack parts."""
    heights = [0.0, 0.5, 2.0, 4.0, 2.5]
    found = kingpost.Batch(moored(4.0), {HEIGHT: [max(height, 1e-3) for height in heights]}).run()
    for run, height in enumerate(heights):
        equal(found.isel(run=run), kingpost.run(moored(4.0), {HEIGHT: max(height, 1e-3)}))


def test_a_run_in_waves_goes_on_from_a_snapshot_with_the_same_bits():
    """Source: the run without a break; the snapshot is taken in the middle of a cycle of the waves."""
    whole = kingpost.Simulation(moored(4.0))
    rows = []
    for _ in range(80):
        whole.step(1)
        rows.append(whole.row().copy())
        if len(rows) == 37:
            snapshot = whole.snapshot()
    again = kingpost.Simulation(moored(4.0))
    again.step(5)
    again.restore(snapshot)
    for row in rows[37:]:
        again.step(1)
        np.testing.assert_array_equal(again.row(), row)


def lowered() -> kingpost.Scenario:
    """A load of 40 t in waves, on 100 m of wire under a tip that moves in surge and heave; at rest first."""
    ball = {"sphere": {"radius_m": 1.2}}
    moves = {"oscillation": {"amplitude_m": 1.0, "period_s": 9.0, "ramp_s": 20.0}}
    tip = fixed([0, 0, 20]) | {
        "joint": {"prismatic": {"axis": [0.6, 0, 0.8], "position_m": [0, 0, 20], "mode": moves}}
    }
    place = {"position_m": [0, 0, -80.05]}
    load = {
        "mass_kg": 40e3,
        "shape": ball,
        "joint": {"floating": {"hold_rotation": True, "initial": place}},
    }
    coefficients = {"coefficients": [0.5, 0.5, 0.5]}
    water = {"body": "load", "shape": ball, "added_mass": coefficients, "drag": coefficients}
    part = section(100.0, 6, diameter_m=0.07, damping_time_s=0.01)
    more = {"record_every_s": 1.0, "integrator": "rk4", "begin_at_equilibrium": True}
    return scenario(
        {"tip": tip, "load": load},
        between("tip", "load", part) | {"water": {"submerged": water}},
        simulation=settings(0.05, 1000.0) | more,
        sea={"depth_m": 200, "waves": {"swell": {"regular": {"height_m": 2.0, "period_s": 9.0}}}},
    )


def test_the_energy_of_a_load_in_waves_balances_as_well_after_ten_times_as_long():
    """Source: conservation. Wire and load turn work of the tip and the waves into heat; the residual may be a
    share of it, but the share must not grow."""
    found = kingpost.run(lowered())
    residual, heat = np.abs(found.energy_error.values), found.energy_dissipated.values
    tenth, whole = (residual[: time + 1].max() / heat[time] for time in (100, 1000))
    # Steps of 50 ms, 0.66 rad of the load's oscillation on the wire, leave 3.5e-4; steps of 12.5 ms 0.8e-4.
    assert whole < 4e-4
    # Waves and tip have the same period, and the start of 20 s has less heat: 3 % of difference.
    assert whole < 1.1 * tenth


@pytest.mark.thorough
@pytest.mark.parametrize("step_s", [0.05, 0.025])
def test_the_energy_of_a_load_that_swings_on_a_wire_balances_to_second_order_after_50_swings(step_s):
    """Source: conservation. It is released at 15 m from the vertical; the wire has the damping of steel."""
    given = hanging(
        40e3,
        section(100.0, 6, damping_time_s=0.01),
        floats=True,
        aside_rad=0.15,
        step_s=step_s,
        duration_s=1000.0,
        record_every_s=1.0,
    )
    found = kingpost.run(given)
    residual = np.abs(found.energy_error.values)
    swinging = 40e3 * G * 100.0 * (1 - np.cos(0.15))
    # Second order in the step; 75 J and 14 J of 440 kJ were measured.
    assert residual.max() < 2.5e-4 * swinging * (step_s / 0.05) ** 2
    # In proportion to the time.
    assert residual.max() < 11 * residual[:101].max()
    reached = np.abs(found.position.sel(body="load", axis="x").values[-30:]).max()
    assert reached == pytest.approx(15.0, rel=5e-3)


def test_a_load_that_swings_on_a_wire_gets_no_warning_of_a_step_that_is_stable():
    """Source: the fastest motion of load and wire is 9 rad/s: RK4 is stable up to 2.8 rad per step."""
    found = kingpost.Simulation(hanging(40e3, section(100.0, 6, damping_time_s=0.01), floats=True))
    assert found.model_warnings == []


def test_the_rest_of_a_load_on_a_wire_has_the_derivatives_of_its_closed_form():
    """Source: the load rests at L (1 + (M + m L / 2) g / EA) below the top."""
    load_kg, length, part = 2e3, 1000.0, section(1000.0, 2)
    stiffness, mass = part["axial_stiffness_N"], part["mass_kg_per_m"]
    names = ["bodies.load.mass_kg", "forces.line.line.sections.0.axial_stiffness_N"]
    closed = [-length * G / stiffness, length * (load_kg + mass * length / 2) * G / stiffness**2]
    given = hanging(load_kg, part, duration_s=0.05, begin_at_equilibrium=True)
    found = kingpost.gradient(given, names).joint_position_derivative.values[:, 0].ravel()
    # Rounding of positions of 1000 m, 1e-13 m, over the stretch of 0.2 m: 5e-13, amplified by less than 1e4.
    np.testing.assert_allclose(found, closed, rtol=1e-8)

"""Drag on lines in the response to a random sea: closed form of one motion, runs, lines without drag."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

import kingpost
import numpy as np
import pytest
from kingpost.analysis import random_sea, response, spectral
from kingpost.results.columns import column
from scipy.special import erf

GRAVITY, DENSITY, DIAMETER, LENGTH = 9.80665, 1000.0, 0.3, 19.9
SPRING_N_PER_M, DRAG, MASS_KG_PER_M, ENDS_KG = 4e4, 1.2, 100.0, 11e3
SLIDE = "slide.joint_position"

SLIDER: dict[str, Any] = {
    "version": 1,
    "title": "A taut line on a slider beside a hull in waves",
    "simulation": {"step_s": 0.02, "duration_s": 600, "record_every_s": 0.2, "begin_at_equilibrium": True},
    "sea": {
        "density_kg_m3": DENSITY,
        "waves": {"wind_sea": {"jonswap": {"significant_height_m": 3, "peak_period_s": 7, "gamma": 1}}},
    },
    "bodies": {
        "hemisphere": {
            "mass_t": 261.746,
            "inertia": {"radii_of_gyration": {"radii_m": [2.5, 2.5, 2.8]}},
            "centre_of_mass_m": [0, 0, -1.875],
            "joint": {"floating": {"initial": {"position_m": [0, 0, -1.875]}}},
        },
        "slider": {
            "mass_t": 10,
            "shape": {"sphere": {"radius_m": 0.1}},
            "joint": {
                "prismatic": {
                    "name": "slide",
                    "axis": [1, 0, 0],
                    "position_m": [8, 0, -5],
                    "spring": {"stiffness_N_per_m": SPRING_N_PER_M},
                }
            },
        },
        "foot": {
            "parent": "slider",
            "mass_t": 1,
            "shape": {"sphere": {"radius_m": 0.1}},
            "joint": {"fixed": {"position_m": [0, 0, -20]}},
        },
    },
    "forces": {
        "gravity": {"gravity": {}},
        "hold": {"soft_hold": {"body": "hemisphere"}},
        "water": {"hydrodynamics": {"body": "hemisphere", "database": "gallery:hydro/sphere.hydro.json"}},
        "line": {
            "line": {
                "first": {"body": "slider", "position_m": [0, 0, 0]},
                "second": {"body": "foot", "position_m": [0, 0, 0]},
                "sections": [
                    {
                        "unstretched_length_m": LENGTH,
                        "elements": 1,
                        "mass_kg_per_m": MASS_KG_PER_M,
                        "diameter_m": DIAMETER,
                        "axial_stiffness_kN": 1e6,
                        "drag_across": DRAG,
                        "drag_along": 0,
                        "added_mass_across": 1,
                    }
                ],
            }
        },
    },
}
"""A vertical line with a tension of 5 MN: it moves like a bar, with a slider that moves along the waves."""

CHAIN: dict[str, Any] = {
    "version": 1,
    "title": "A vessel with a chain at her bow",
    "simulation": {"step_s": 0.05, "duration_s": 1000, "record_every_s": 0.25, "begin_at_equilibrium": True},
    "sea": {
        "waves": {
            "wind_sea": {
                "jonswap": {"significant_height_m": 2.5, "peak_period_s": 8, "gamma": 1, "direction_deg": 180}
            }
        },
        "ramp_s": 30,
    },
    "parts": {"vessel": {"part": "offshore_hull", "prefix": ""}},
    "forces": {
        "gravity": {"gravity": {}},
        "hold": {"soft_hold": {"body": "hull"}},
        "chain": {
            "line": {
                "first": {"body": "hull", "position_m": [38, 0, 4]},
                "second": {"body": "world", "position_m": [255, 0, -100]},
                "sections": [
                    {
                        "unstretched_length_m": 260,
                        "elements": 10,
                        "mass_kg_per_m": 80,
                        "diameter_m": 0.115,
                        "axial_stiffness_kN": 350000,
                        "damping_time_s": 0.02,
                        "drag_across": 1.3,
                        "drag_along": 0.1,
                    }
                ],
                "seabed": {"friction": 0.7, "depth_m": 100},
                "points_along": 3,
            }
        },
    },
}
"""A chain that its drag tightens in waves: at rest between its ends it would have a sixth of that tension."""


def written(folder: Path, given: dict[str, Any], **section: Any) -> Path:
    """The scenario as a file, with these fields of the section of its line instead."""
    changed = copy.deepcopy(given)
    (line,) = (force["line"] for force in changed["forces"].values() if "line" in force)
    line["sections"][0] |= section
    path = folder / "scenario.yaml"
    path.write_text(json.dumps(changed))
    return path


def slider(folder: Path, current_m_s: float = 0.0, **section: Any) -> kingpost.Simulation:
    overrides = {"sea.current_m_s": [current_m_s, 0]} if current_m_s else {}
    return kingpost.Simulation(kingpost.load(written(folder, SLIDER, **section), overrides))


def deviation_and_mean(simulation: kingpost.Simulation, current: float) -> tuple[float, float]:
    """Deviation and mean of one motion with the drag and the inertia of three thirds of a line, by iteration.

    M x'' + k x = Sum c_i E[|r| r] + Sum m_i a_i, r = c + u - x': with the deviation s of r the mean force is
    (c^2 + s^2) erf(c / (2^1/2 s)) + c s (2/pi)^1/2 exp(-c^2 / 2 s^2), its slope 2 c erf + 2 s (2/pi)^1/2 exp.
    """
    covered = response.frequencies_that_all_cover(simulation.scenario)
    omega = np.linspace(covered[0], covered[-1], 20001)
    ((sea,),) = simulation.sea_spectra(omega)
    variances = np.asarray(sea["density_m2_s"]) * random_sea.trapezoidal(omega)
    heights, lengths = np.array([-5.0, -15.0, -25.0]), LENGTH * np.array([1, 4, 1]) / 6
    displaced = DENSITY * np.pi / 4 * DIAMETER**2
    velocity = omega * np.exp(np.outer(heights, omega**2 / GRAVITY))
    mass = ENDS_KG + (MASS_KG_PER_M + displaced) * LENGTH
    inertial = 2 * displaced * lengths @ (-1j * omega * velocity)
    per_square = 0.5 * DENSITY * DRAG * DIAMETER * lengths
    sigma = np.ones(3)
    for _ in range(100):
        ratio = current / sigma / np.sqrt(2)
        bell = sigma * np.sqrt(2 / np.pi) * np.exp(-(ratio**2))
        slope = per_square * 2 * (current * erf(ratio) + bell)
        x = inertial + slope @ velocity
        x = x / (SPRING_N_PER_M - omega**2 * mass - 1j * omega * slope.sum())
        sigma = np.sqrt(np.abs(velocity + 1j * omega * x) ** 2 @ variances)
    mean = per_square @ ((current**2 + sigma**2) * erf(ratio) + current * bell) / SPRING_N_PER_M
    return float(np.sqrt(np.abs(x) ** 2 @ variances)), float(mean)


@pytest.mark.parametrize("current_m_s", [0.0, 0.8])
def test_one_motion_has_the_deviation_by_borgman_and_the_mean_in_a_current(
    current_m_s: float, tmp_path: Path
) -> None:
    """Source: E[|r| r] of a Gaussian r and its slope (Borgman 1967), iterated for one motion in the test."""
    simulation = slider(tmp_path, current_m_s)
    expected, mean = deviation_and_mean(simulation, current_m_s)
    found = kingpost.spectral_response(simulation, [SLIDE])
    # The line bends by a thousandth of its motion, and the response is interpolated between frequencies.
    assert float(found.standard_deviation[0]) == pytest.approx(expected, rel=1e-3)
    assert float(found["mean"][0]) == pytest.approx(mean, rel=1e-3, abs=1e-9)
    assert found.attrs["drag"] == f"{spectral.STOCHASTIC}: line"
    assert "leaves out its inertia" not in found.attrs.get("warning", "")


def test_a_line_without_drag_is_at_rest_between_its_ends_to_the_last_bit(tmp_path: Path) -> None:
    """Source: the response of columns without a sea."""
    simulation = slider(tmp_path, drag_across=0)
    (systems,) = simulation.sea_spectra([], random_sea.SPREAD)
    names = [SLIDE, "line.line_tension", "hemisphere.position.z"]
    waves = (random_sea.directions_of(systems), random_sea.nodes_of(systems))
    sea = random_sea.random_sea(simulation, systems)
    found, still = (spectral.transfer(simulation, names, *waves, (), given) for given in (sea, None))
    assert found.linearised == []
    assert np.array_equal(found.squares, still.squares)
    assert found.warnings == still.warnings
    assert any("leaves out its inertia" in one for one in found.warnings)
    assert kingpost.spectral_response(simulation, [SLIDE]).attrs["drag"] == spectral.NO_DRAG


def test_in_a_calm_sea_a_line_with_drag_has_no_drag(tmp_path: Path) -> None:
    """Source: drag that vanishes with the motion: the same amplitudes with a hundredth of the coefficient."""
    sea = {"waves": {"directions_rad": [0.0], "frequencies_rad_s": [1.0]}, "variances_m2": [[0.0]]}
    calm = [
        slider(tmp_path, drag_across=drag)
        .column_response([0.0], [1.0], [SLIDE], sea=sea)["amplitudes"]
        .item()
        for drag in (1.2, 0.012)
    ]
    # The least variance of the drag, 1e-12 m^2/s^2, beside a relative velocity of some 0.3 m/s.
    assert calm[0] == pytest.approx(calm[1], rel=1e-5)


def test_a_regular_wave_has_a_warning_and_wrong_variances_are_refused(tmp_path: Path) -> None:
    simulation = slider(tmp_path)
    swell = {"swell": {"regular": {"height_m": 1, "period_s": 6}}}
    given = simulation.scenario.with_overrides({"sea.waves": swell})
    assert spectral.REGULAR in kingpost.spectral_response(given, [SLIDE]).attrs["warning"]
    waves = {"directions_rad": [0.0], "frequencies_rad_s": [1.0, 1.2]}
    for variances in ([], [[0.1]], [[0.1, -1.0]]):
        with pytest.raises(kingpost.KingpostError, match=r"variances_m2: found .*, allowed: 2 numbers"):
            simulation.column_response([0.0], [1.0], sea={"waves": waves, "variances_m2": variances})


def cut_slider(is_cut: bool) -> dict[str, Any]:
    """The slider with its line in two sections, or in two lines that are fastened to each other there."""
    given = copy.deepcopy(SLIDER)
    line = given["forces"]["line"]["line"]
    half = line["sections"][0] | {"unstretched_length_m": LENGTH / 2}
    line["sections"] = [half] if is_cut else [half, half]
    if is_cut:
        lower = {"first": line.pop("second"), "second_on": {"line": "line", "section": 0}, "sections": [half]}
        line["second_free"] = True
        given["forces"]["lower"] = {"line": lower}
    return given


def test_lines_fastened_to_each_other_respond_as_one_line(tmp_path: Path) -> None:
    """Source: the whole line, with the same nodes: a straight one has the same tangents at the joint."""
    found = []
    for is_cut in (False, True):
        path = tmp_path / f"{is_cut}.yaml"
        path.write_text(json.dumps(cut_slider(is_cut)))
        simulation = kingpost.Simulation(kingpost.load(path))
        response_of = kingpost.spectral_response(simulation, [SLIDE])
        found.append(float(response_of.standard_deviation[0]))
        names = "line, lower" if is_cut else "line"
        assert response_of.attrs["drag"] == f"{spectral.STOCHASTIC}: {names}"
    # The iteration for the variances of the velocities ends within 1e-4 of them.
    assert found[1] == pytest.approx(found[0], rel=1e-4)


def test_other_linear_responses_say_that_they_leave_the_drag_out(tmp_path: Path) -> None:
    found = kingpost.wave_response(slider(tmp_path), [SLIDE], [0.0], [1.0])
    assert "line: the response has this line at rest between its ends" in found.attrs["warning"]


@pytest.mark.thorough
def test_runs_over_seeds_have_the_deviations_of_a_chain(tmp_path: Path) -> None:
    """Source: the engine in time. Of a Gaussian process the variance in a record of T has the variance
    2 pi / T Int S^2 dw (Bendat & Piersol, *Random Data*, 2010, sec. 8.2.2), over all runs an n-th of it."""
    seeds, start_s, duration_s = 6, 60.0, 1000.0
    path = written(tmp_path, CHAIN)
    names = ["chain.line_tension", "chain.line_end_tension", "chain.point_2.line_tension_along", "hull.pitch"]
    runs = kingpost.Batch(path, {"simulation.seed": list(range(seeds))}).run(threads=1)
    simulation = kingpost.Simulation(kingpost.load(path))
    (systems,) = simulation.sea_spectra([], random_sea.SPREAD)
    sea = random_sea.random_sea(simulation, systems)
    exact = spectral.transfer(simulation, names, [np.pi], random_sea.nodes_of(systems), (), sea)
    ((density,),) = simulation.sea_spectra(exact.omega_rad_s)
    spectra = np.asarray(density["density_m2_s"])[:, None] * exact.squares[0]
    m0, m00 = (np.einsum("kc,k->c", spectra**n, exact.weights) for n in (1, 2))
    error = np.sqrt(2 * np.pi / (seeds * (duration_s - start_s)) * m00) / (2 * np.sqrt(m0))
    for name, sigma, standard_error in zip(names, np.sqrt(m0), error, strict=True):
        series = column(runs, name)
        measured = float(np.sqrt(series.sel(time=series.time > start_s).var("time").mean()))
        # The deviation of |u| u is 3^1/2 sigma^2, that of linear drag (8/pi)^1/2 sigma^2: where drag alone
        # makes the tension, a run has 8.5 % more.
        by_drag = 0.0 if name == "hull.pitch" else (np.sqrt(3 * np.pi / 8) - 1) * sigma
        assert abs(measured - sigma) < 3 * standard_error + by_drag, (name, measured, sigma, standard_error)


@pytest.mark.thorough
def test_the_drag_of_four_chains_in_a_current_is_found(tmp_path: Path) -> None:
    """Nodes that hardly touch the seabed would rise and land in turns with the mean drag of an iteration."""
    given = copy.deepcopy(CHAIN)
    chain = given["forces"].pop("chain")["line"]
    chain["sections"][0] |= {"unstretched_length_m": 285, "elements": 6}
    for k, (x, y) in enumerate([(1, 1), (1, -1), (-1, 1), (-1, -1)]):
        ends = {"first": [38 * x, (4 if x > 0 else 8) * y, 4], "second": [255 * x, 150 * y, -100]}
        bodies = {"first": "hull", "second": "world"}
        placed = {end: {"body": bodies[end], "position_m": place} for end, place in ends.items()}
        given["forces"][f"chain_{k}"] = {"line": chain | placed}
    given["sea"]["current_m_s"] = [-0.6, 0]
    given["sea"]["waves"]["wind_sea"]["jonswap"]["direction_deg"] = 150
    path = tmp_path / "moored.json"
    path.write_text(json.dumps(given))
    simulation = kingpost.Simulation(kingpost.load(path))
    (systems,) = simulation.sea_spectra([], random_sea.SPREAD)
    sea = random_sea.random_sea(simulation, systems)
    assert sea is not None
    # Every sixth frequency is enough for the iteration.
    thin = [6 * np.array(row)[::6] for row in sea["variances_m2"]]
    waves = sea["waves"] | {"frequencies_rad_s": sea["waves"]["frequencies_rad_s"][::6]}
    given_sea = {"waves": waves, "variances_m2": [row.tolist() for row in thin]}
    found = simulation.column_response([2.6], [0.5], ["chain_0.line_tension"], sea=given_sea)
    assert found["linearised"] == [f"chain_{k}" for k in range(4)]
    assert np.isfinite(found["amplitudes"]).all()

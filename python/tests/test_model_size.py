"""Models of many bodies: quantities that grow with the square of their number are limited before memory is
exhausted."""

from __future__ import annotations

import resource
from pathlib import Path

import kingpost
import pytest
from kingpost import KingpostError

FREE = 400
"""Bodies; 2,400 free coordinates."""


AFLOAT = """version: 1
title: a list of weights
simulation: {step_s: 0.05, duration_s: 2, record_every_s: 0.2}
bodies:
  hull:
    mass_t: 400
    centre_of_mass_m: [0, 0, 2.5]
    inertia: {radii_of_gyration: {radii_m: [3.5, 6, 6]}}
    joint: {floating: {initial: {position_m: [0, 0, 0.5]}}}
WEIGHTS
forces:
  gravity: {gravity: {}}
  water: {hydrodynamics: {body: hull, database: gallery:hydro/barge.hydro.json, origin_m: [0, 0, 2]}}
"""


@pytest.fixture(scope="module")
def many(tmp_path_factory: pytest.TempPathFactory) -> kingpost.Scenario:
    path = tmp_path_factory.mktemp("many") / "many.yaml"
    body = "mass_t: 1, shape: {box: {length_m: 1, width_m: 1, height_m: 1}}"
    bodies = "".join(
        f"  b{i}: {{{body}, joint: {{floating: {{initial: {{position_m: [{3 * i}, 0, 0]}}}}}}}}\n"
        for i in range(FREE)
    )
    text = "version: 1\ntitle: many\nsimulation: {step_s: 0.01, duration_s: 0.02}\nbodies:\n"
    path.write_text(f"{text}{bodies}forces: {{gravity: {{gravity: {{}}}}}}\n", encoding="utf-8")
    return kingpost.load(path)


def test_a_run_of_many_free_bodies_skips_the_estimate_of_the_stable_step(many: kingpost.Scenario) -> None:
    simulation = kingpost.Simulation(many)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    *_, of_the_others, left_out = simulation.model_warnings
    assert of_the_others == f"gravity acts and nothing carries {FREE - 5} more bodies: they fall"
    assert left_out.startswith(
        f"the longest stable step is not estimated: {12 * FREE} states, more than 1000"
    )
    simulation.step(2)
    grown_mb = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024
    # One matrix of all states has 184 MB.
    assert grown_mb < 100


def test_matrices_of_many_coordinates_are_refused_by_name(many: kingpost.Scenario) -> None:
    with pytest.raises(KingpostError, match="linearize: found 2400 free coordinates, allowed: at most 2000"):
        kingpost.Simulation(many).linearize()
    with pytest.raises(
        KingpostError, match="no equilibrium is sought: 2400 free coordinates, allowed: at most 2000"
    ):
        kingpost.Simulation(many).settle()
    for field, value in (("form", "moving_frame"), ("integrator", "newmark")):
        with pytest.raises(
            KingpostError, match=f"simulation.{field}: found one with matrices, of 2400 coordinates"
        ):
            many.with_overrides({f"simulation.{field}": value})


def test_the_cost_of_fixed_weights_is_linear_in_their_number(tmp_path: Path) -> None:
    """Source: a ship's list of weights has hundreds of items; three hundred took 23 s to check."""
    weights = "".join(
        f"  b{i}: {{parent: hull, mass_t: 0.01, shape: {{box: {{length_m: 1, width_m: 1, height_m: 1}}}}, "
        f"joint: {{fixed: {{position_m: [0, 0, {0.01 * i:.2f}]}}}}}}\n"
        for i in range(300)
    )
    path = tmp_path / "weights.yaml"
    path.write_text(AFLOAT.replace("WEIGHTS", weights), encoding="utf-8")
    used = resource.getrusage(resource.RUSAGE_SELF).ru_utime
    hulls = kingpost.load(path).hydrostatics["hulls"]
    assert hulls[0]["mass_kg"] == pytest.approx(403_000)
    # Processor seconds, not the clock's: by the cube of the number they were 23.
    assert resource.getrusage(resource.RUSAGE_SELF).ru_utime - used < 10

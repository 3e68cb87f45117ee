"""A box that lists by its ballast, compared with Capytaine on the heeled hull."""

from __future__ import annotations

import json
from pathlib import Path

import kingpost
import numpy as np
import pytest
from kingpost.results import entries

PEERS = Path(__file__).parent / "peers"
LIST_DEG = 5.0
# `kingpost hydro box:length_m=100,beam_m=24,draught_m=5,depth_m=9 --panels 600 --directions 24 --heel-deg 5`
# made it; at the peak of roll its panels are worth 3 % (see listed_box.py on its own).
DATABASE = PEERS / "listed_5.hydro.json"
ROWS = {"sway": ("displacement", "y"), "heave": ("displacement", "z"), "roll": ("rotation", "roll")}


@pytest.fixture(scope="module")
def truth() -> dict:
    return json.loads((PEERS / "listed_box.json").read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def case(truth: dict) -> dict:
    return next(case for case in truth["cases"] if case["list_deg"] == LIST_DEG)


@pytest.fixture(scope="module")
def listing(tmp_path_factory: pytest.TempPathFactory, truth: dict, case: dict) -> Path:
    """A scenario whose ballast lists the box, at rest on its mesh."""
    centre, roll = case["centre_of_gravity_m"], case["roll_damping_N_m_s"]
    start = {"position_m": centre, "orientation_rad": [float(np.radians(LIST_DEG)), 0, 0]}
    water = {"body": "hull", "database": str(DATABASE), "origin_m": [0, 0, 0], "hydrostatics": "mesh"}
    scenario = {
        "version": 1,
        "title": "A box that lists",
        "simulation": {"step_s": 0.05, "duration_s": 10, "begin_at_equilibrium": True},
        "bodies": {
            "hull": {
                "mass_kg": truth["mass_kg"],
                "centre_of_mass_m": centre,
                "inertia": {"radii_of_gyration": {"radii_m": truth["radii_of_gyration_m"]}},
                "joint": {"floating": {"initial": start}},
            }
        },
        "forces": {
            "gravity": {"gravity": {}},
            "water": {"hydrodynamics": water},
            "bilges": {"viscous_damping": {"body": "hull", "angular_N_m_s": [roll, 0, 0]}},
        },
    }
    path = tmp_path_factory.mktemp("listed") / "box.yaml"
    path.write_text(json.dumps(scenario), encoding="utf-8")
    return path


def test_the_response_of_a_listed_box_equals_capytaines_for_the_heeled_hull(listing, truth, case) -> None:
    """Within 5 % of the largest response to head or beam seas, most of it the panels of the database."""
    directions = truth["directions_deg"]
    found = kingpost.rao(listing, np.radians(directions), truth["frequencies_rad_s"])
    for motion, (quantity, axis) in ROWS.items():
        of_hull = (
            {"point": "hull", "axis": axis} if quantity == "displacement" else {"body": "hull", "angle": axis}
        )
        ours = found[quantity].sel(of_hull).to_numpy()
        parts = [case["response"][f"{direction:g}"][motion] for direction in directions]
        theirs = np.array([np.hypot(part["real"], part["imaginary"]) for part in parts])
        assert np.abs(ours - theirs).max() < 0.05 * theirs.max(), motion


def test_a_hull_in_the_attitude_of_its_coefficients_gives_no_warning(listing) -> None:
    run = kingpost.run(listing)
    assert run.sizes["warning"] == 0
    roll = np.degrees(run["roll"].sel(body="hull").to_numpy())
    assert np.abs(roll - LIST_DEG).max() < 0.01


def test_a_hull_in_another_attitude_than_its_coefficients_gives_a_warning(listing) -> None:
    """Source: the ballast put back amidships lets it come upright, 5 degrees off."""
    run = kingpost.run(listing, overrides={"bodies.hull.centre_of_mass_m": [0, 0, 1]})
    (warning,) = (one for one in entries.warnings_of(run) if one["code"] == "mean_heel_off_data")
    assert "its hydrodynamic coefficients are for 5.00 deg" in warning["text"]
    assert abs(warning["value"]) > warning["bound"] > 0
    assert warning["unit"] == "deg"

"""Hydrostatics of the gallery's ships, as numbers and as printed by `kingpost check`."""

from __future__ import annotations

import re

import kingpost
import numpy as np
import pytest
from kingpost.cli import main
from kingpost.reports import model as model_report


def test_the_hydrostatics_of_the_barge_are_the_closed_forms_of_a_box() -> None:
    """Source: 410 t on 20 x 10 m; KB = T / 2, BM = B^2 / (12 T), KG by the masses of the file."""
    found = kingpost.load("barge").hydrostatics
    (hull,) = found["hulls"]
    draught = 410e3 / (1025 * 20 * 10)
    # It heels by half a degree under its crane: cosines are off by 5e-5, radii by tan^2.
    assert hull["displacement_kg"] == pytest.approx(410e3, rel=1e-5)
    assert hull["draught_m"] == pytest.approx(draught, rel=1e-4)
    assert hull["keel_to_buoyancy_m"] == pytest.approx(draught / 2, rel=1e-3)
    radii = [size**2 / (12 * draught) for size in (10, 20)]
    assert hull["metacentric_radius_m"] == pytest.approx(radii, rel=5e-4)
    assert hull["fluid_keel_to_gravity_m"][0] == pytest.approx(2.5, abs=1e-3)
    rise = hull["fluid_keel_to_gravity_m"][0] - hull["keel_to_gravity_m"]
    assert rise == pytest.approx(1 * 4 / 410, rel=1e-3)
    assert found["warnings"] == []


def test_the_present_position_of_the_crane_is_used() -> None:
    """Source: the moment of the load about the middle line; the crane swings from astern to port."""
    simulation = kingpost.Simulation("barge")
    before = simulation.hydrostatics()["hulls"][0]
    simulation.step(int(35 / 0.02))
    state = simulation.state
    after = simulation.hydrostatics()["hulls"][0]
    # Load and half the arm go 7 and 3.5 m to port: 1 t x 7 m + 0.5 t x 3.5 m over W GM.
    slewed = np.deg2rad(90)
    moment = (1.0 * 7.0 + 0.5 * 3.5) * np.sin(slewed)
    change = moment / (410 * before["metacentric_height_m"][0])
    assert before["heel_rad"] - after["heel_rad"] == pytest.approx(change, rel=0.02)
    assert np.array_equal(simulation.state.q, state.q), "the simulation itself does not move"


def test_check_prints_how_a_ship_floats(capsys) -> None:
    """Source: the numbers of `Scenario.hydrostatics`."""
    assert main(["check", "barge"]) == 0
    shown = capsys.readouterr().out
    (hull,) = kingpost.load("barge").hydrostatics["hulls"]
    for label, value, unit in [
        ("displacement", hull["displacement_kg"] / 1000, "t"),
        ("draught", hull["draught_m"], "m"),
        ("heel", abs(np.rad2deg(hull["heel_rad"])), "deg"),
        ("trim", abs(np.rad2deg(hull["trim_rad"])), "deg"),
        ("KB", hull["keel_to_buoyancy_m"], "m"),
        ("BM", hull["metacentric_radius_m"][0], "m"),
        ("KM", hull["keel_to_metacentre_m"][0], "m"),
        ("KG", hull["keel_to_gravity_m"], "m"),
        ("GM, fluid", hull["metacentric_height_m"][0], "m"),
        ("GM, solid", hull["solid_metacentric_height_m"][0], "m"),
    ]:
        (number,) = re.findall(rf"^{label} +(-?[\d.]+) {unit}\b", shown, re.MULTILINE)
        assert float(number) == pytest.approx(value, abs=0.6 * 10 ** -len(number.partition(".")[2])), label
    assert re.search(r"^load +pendant +1 t +4\.000 m +100 % +100 %$", shown, re.MULTILINE)
    side = "starboard" if hull["heel_rad"] > 0 else "port"
    end = "bow" if hull["trim_rad"] > 0 else "stern"
    assert re.search(rf"^heel .* deg +to {side}$", shown, re.MULTILINE)
    assert re.search(rf"^trim .* deg +by the {end}$", shown, re.MULTILINE)
    (arms,) = re.findall(r"^GZ, m +(.*)$", shown, re.MULTILINE)
    expected = [point["arm_m"] for point in hull["righting_arm"]["points"]]
    assert np.allclose([float(arm) for arm in arms.split()], expected, atol=6e-4)
    assert "warning" not in shown


def test_check_prints_the_reduction_of_gm_by_a_slack_tank(capsys) -> None:
    """Source: rho l b^3 / (12 M) across, rho b l^3 / (12 M) along. The barge heels by half a degree, whose
    tan^2 is 1e-4: so much larger is i."""
    size = {"length_m": 6, "breadth_m": 8, "height_m": 2, "filling": 0.5}
    tank = {"slack_tank": {"body": "ship", "position_m": [0, 0, -1], **size}}
    without = kingpost.load("barge")
    shown = model_report.text(kingpost.load("barge", {"forces.ballast": tank}), [])
    across, along = (1025 * moment / (12 * 410e3) for moment in (6 * 8**3, 8 * 6**3))
    assert f"free surfaces: GM -{across:.3f} m, -{along:.3f} m lengthwise" in shown
    row = rf"^ballast +ship +49.200 t +[\d.]+ m +-{across:.3f} m +-{along:.3f} m$"
    assert re.search(row, shown, re.MULTILINE)
    (fluid,) = re.findall(r"^GM, fluid +([\d.]+) m", shown, re.MULTILINE)
    gm = without.hydrostatics["hulls"][0]["metacentric_height_m"][0]
    assert float(fluid) == pytest.approx(gm - across, abs=2e-3)
    assert "free surfaces" in shown
    assert "slack tank" not in model_report.text(without, [])


def test_the_righting_arms_of_a_crane_to_port_and_to_starboard_are_the_same(capsys) -> None:
    """Source: the two are mirror images, and settle to 1e-10; the side of the load is the lesser."""
    heels, largest = [], []
    for side, slew in (("port", 90), ("starboard", -90)):
        overrides = ["load_t=40", f"bodies.pedestal.joint.revolute.initial_angle_deg={slew}"]
        assert main(["check", "offshore_vessel", *(a for pair in overrides for a in ("--set", pair))]) == 0
        shown, warned = capsys.readouterr()
        (heel,) = re.findall(rf"^heel +([\d.]+) deg +to {side}$", shown, re.MULTILINE)
        (top,) = re.findall(
            rf"^righting arms of the mesh to {side}: largest GZ ([\d.]+) m", shown, re.MULTILINE
        )
        assert f"warning: hull: heel {float(heel):.2f} deg to {side}" in warned
        heels.append(float(heel))
        largest.append(float(top))
    assert heels[0] == pytest.approx(heels[1], abs=2e-4)
    assert largest[0] == pytest.approx(largest[1], abs=2e-3)


def test_check_warns_that_the_ship_of_the_paper_floats_at_5_85_cm(capsys) -> None:
    """Source: 12 t on 20 x 10 m of sea water; atan(2 T / B), atan(2 T / L)."""
    assert main(["check", "paper_true_draught"]) == 0
    shown, warned = capsys.readouterr()
    assert (
        "warning: ship: it floats at 0.0585 m: its bottom comes out of the water at about 0.67 deg of heel "
        "or 0.34 deg of trim (warned of below 3 deg)"
    ) in warned
    assert "the database's draught, upright" not in shown + warned, "nothing of its loads is linear"


def test_check_reports_where_a_ship_leaves_its_database_and_that_a_ship_sinks(capsys) -> None:
    assert main(["check", "barge", "--set", "load_t=5", "--set", "bodies.ship.mass_t=380"]) == 0
    assert "% apart: linear hydrodynamics hold near the database's draught" in capsys.readouterr().err
    assert main(["check", "barge", "--set", "bodies.ship.mass_t=1100"]) == 2
    assert "a hull that cannot float: 1102.000 t displace" in capsys.readouterr().err


def test_a_body_that_does_not_float_has_no_hydrostatics(capsys) -> None:
    assert kingpost.load("paper").hydrostatics == {"hulls": [], "warnings": []}
    assert main(["check", "paper"]) == 0
    assert "afloat" not in capsys.readouterr().out

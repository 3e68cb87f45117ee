"""`kingpost convert`: a mooring system of MoorDyn becomes a scenario; all that is left out is listed."""

from __future__ import annotations

import json
import math
from functools import partial

import kingpost
import pytest
from kingpost.cli import main
from kingpost.convert import convert
from mooring_decks import LINES, POINTS, resolved, where, write_deck


@pytest.fixture
def deck(tmp_path):
    """A function that writes a deck, with replacements, and returns its path."""
    return partial(write_deck, tmp_path)


def test_a_deck_becomes_a_scenario_that_can_run(deck, tmp_path, capsys) -> None:
    """Source: the numbers of the deck, and MoorDyn's manual on the meaning of its columns."""
    output = tmp_path / "chain.yaml"
    assert main(["convert", deck(), "-o", str(output)]) == 0
    assert f"written  {output}" in capsys.readouterr().out
    assert main(["check", str(output), "--quiet"]) == 0
    found = kingpost.load(str(output)).resolved
    assert found["title"] == "A chain and a wire from an anchor"
    assert (found["simulation"]["step_s"], found["simulation"]["record_every_s"]) == (0.005, 0.5)
    assert (found["sea"]["depth_m"], found["sea"]["density_kg_m3"]) == (200, 1020)
    assert found["forces"]["gravity"]["gravity"]["acceleration_m_s2"] == 9.81
    line = found["forces"]["line_1_2"]["line"]
    assert (line["first"]["body"], line["first"]["position_m"]) == ("world", [779.6, 0, -200])
    assert (line["second"]["body"], line["second"]["position_m"]) == ("vessel", [0, 0, -14])
    assert line["seabed"]["friction"] == 0.4
    assert (line["seabed"]["stiffness_N_per_m3"], line["seabed"]["damping_time_s"]) == (2e6, 0.05)
    chain, wire = line["sections"]
    assert chain["axial_stiffness_N"] == 3.27e9
    assert [
        wire[name] for name in ("added_mass_across", "added_mass_along", "drag_across", "drag_along")
    ] == [0.9, 0.2, 1.1, 0.01]
    assert [section["elements"] for section in (chain, wire)] == [10, 6], "half the segments, rounded up"
    joint = found["bodies"]["vessel"]["joint"]["floating"]
    assert joint["hold_translation"]
    assert joint["hold_rotation"]


def test_damping_as_a_share_of_the_critical_one_is_converted(deck) -> None:
    """Source: MoorDyn's BA = zeta L/N sqrt(EA m), over EA."""
    chain, wire = resolved(deck())["forces"]["line_1_2"]["line"]["sections"]
    assert chain["damping_time_s"] == pytest.approx(65.4e6 / 3.27e9)
    assert wire["damping_time_s"] == pytest.approx(0.8 * 405 / 11 * math.sqrt(5e8 * 40) / 5e8)
    assert "0.8 of the critical damping" in where(convert(deck()).notes.converted)[19, "line_2:"]


def test_all_that_is_left_out_is_listed_by_line(deck, capsys) -> None:
    """Source: the lines of the deck."""
    assert main(["convert", deck(), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert {(one["line"], one["text"]) for one in found["left_out"]} == {
        (8, "spare"),
        (18, "outputs p"),
        (23, "1 3 2 0 1e6"),
        (33, "RK4 tScheme"),
        (34, "100 TmaxIC"),
        (37, "FairTen1"),
        (38, "AnchTen1"),
    }
    assert all(one["why"] for one in found["left_out"] + found["converted"])
    assert {one["line"] for one in found["converted"]} == {7, 13, 19, None}
    assert (found["lines"], found["bodies"]) == (["line_1_2"], ["vessel"])
    assert "#   line 7" not in found["scenario"]
    assert "bending_stiffness_N_m2: 12" in found["scenario"]


def test_the_list_is_printed_and_the_title_can_be_given(deck, tmp_path, capsys) -> None:
    output = str(tmp_path / "moored.yaml")
    assert main(["convert", deck(), "-o", output, "--name", "Moored"]) == 0
    shown = capsys.readouterr().out
    assert shown.startswith("Moored\n")
    assert "lines 37-38  FairTen1 ..." in shown
    assert main(["convert", deck(), "-o", output, "--quiet"]) == 0
    assert capsys.readouterr().out == ""
    assert main(["convert", deck()]) == 0
    assert kingpost.scenario.Scenario(capsys.readouterr().out, "printed.yaml").title.startswith("A chain")


def test_the_tension_at_rest_is_that_of_the_elastic_catenary(deck) -> None:
    """Source: the closed form of an elastic line on a rigid seabed without friction."""
    whole = deck(
        ("405       20       p", "850       80       -"),
        ("1        2        850", "1        3        850"),
        ("2   wire      2        3        405       11       -\n", ""),
        ("9.81    g\n", ""),
        ("0.4     Fric", "0       Fric"),
        ("1020    rho\n", ""),
        ("2e6     kBot", "3e6     kBot"),
    )
    scenario = kingpost.scenario.Scenario(convert(whole).text, whole)
    scenario["simulation.duration_s"] = 0.5
    ds = kingpost.run(scenario)
    tension = ds["line_end_tension"].sel(line="line_1").isel(time=-1)
    assert float(tension) == pytest.approx(2435.56e3, rel=2e-3)


THIRD = "4   Fairlead    0  10 -14  0 0 0 0\n"


def test_a_free_point_with_mass_between_two_lines_is_a_clump_weight(deck) -> None:
    old = "2   Free        390    0  -107.0  0     0       0    0"
    found = resolved(deck((old, "2   Free 390 0 -107 4e3 2.0 1.5 0.6")))
    assert set(found["bodies"]) == {"vessel"}
    first, second = found["forces"]["line_1_2"]["line"]["sections"]
    weight = {"mass_kg": 4000, "volume_m3": 2.0, "drag_area_m2": 1.5, "added_mass": 0.6}
    assert first["clump_weight"] == weight
    assert second.get("clump_weight") is None


WEIGHT = ("2   Free        390    0  -107.0  0     0       0    0", "2   Free 390 0 -107 4e3 2.0 1.5 0.6")


@pytest.mark.parametrize("is_bare", [False, True])
def test_three_lines_that_meet_at_a_free_point_are_fastened_to_one_of_them(deck, is_bare) -> None:
    """Source: the numbers of the deck."""
    path = deck(
        (POINTS, POINTS + THIRD), (LINES, LINES + "3 wire 2 4 405 11 -\n"), *([] if is_bare else [WEIGHT])
    )
    found = resolved(path)
    assert set(found["bodies"]) == {"vessel"}
    assert found["simulation"]["integrator"] == "rk4"
    lines = {name: force["line"] for name, force in found["forces"].items() if "line" in force}
    assert set(lines) == {"line_1", "line_2", "line_3"}
    assert lines["line_1"]["second_free"]
    weight = {"mass_kg": 4000, "volume_m3": 2.0, "drag_area_m2": 1.5, "added_mass": 0.6}
    assert lines["line_1"]["sections"][0].get("clump_weight") == (None if is_bare else weight)
    for name, place in [("line_2", [0, 0, -14]), ("line_3", [0, 10, -14])]:
        assert (lines[name]["first"]["body"], lines[name]["first"]["position_m"]) == ("vessel", place)
        assert lines[name]["second_on"] == {"line": "line_1", "section": 0}
    assert "second_on" in where(convert(path).notes.converted)[13, "point_2"]


def test_lines_between_two_joints_are_sections(deck) -> None:
    """Lines of two anchors meet below, those of two fairleads above; the line between continues one."""
    more = "4 Fixed 700 200 -200 0 0 0 0\n5 Free 100 0 -60 0 0 0 0\n6 Coupled 0 10 -14 0 0 0 0\n"
    lines = "3 chain 4 2 405 20 -\n4 wire 5 3 120 11 -\n5 wire 5 6 120 11 -\n"
    path = deck((POINTS, POINTS + more), (LINES, "2 wire 2 5 405 11 -\n" + lines))
    found = resolved(path)["forces"]
    on = {name: force["line"].get("second_on") for name, force in found.items() if "line" in force}
    assert on == {
        "line_1": None,
        "line_3": {"line": "line_1", "section": 0},
        "line_4_2": {"line": "line_1", "section": 0},
        "line_5": {"line": "line_4_2", "section": 0},
    }


def test_lines_in_a_circle_of_free_points_are_connected_by_bodies(deck) -> None:
    """Two lines side by side between two free points: a circle, which `second_on` does not have."""
    more = "4 Free 100 0 -60 4e3 0 0 0\n"
    lines = "2 wire 2 4 405 11 -\n3 wire 2 4 405 11 -\n4 wire 4 3 120 11 -\n"
    found = resolved(deck((POINTS, POINTS + more), (LINES, lines)))
    assert set(found["bodies"]) == {"vessel", "point_2", "point_4"}
    assert 0 < found["bodies"]["point_2"]["mass_kg"] < 1000
    assert found["simulation"]["integrator"] == "dormand_prince"


def test_a_deck_without_a_body_gets_one(deck) -> None:
    points = "3 Fixed 0 0 -14 0 0 0 0\n4 Fixed 0 10 -14 0 0 0 0\n"
    path = deck((POINTS, points), (LINES, LINES + "3 wire 2 4 405 11 -\n"))
    assert set(resolved(path)["bodies"]) == {"fixed_points"}


def test_a_line_to_a_free_point_ends_freely(deck) -> None:
    path = deck((LINES, "2 wire 3 2 405 11 -\n"), ("1   chain     1        2        405", "1 chain 1 3 850"))
    line = resolved(path)["forces"]["line_2"]["line"]
    assert line["second_free"]
    assert line["first"]["body"] == "vessel"


def test_both_ends_on_one_body_get_a_body_beside_it(deck) -> None:
    path = deck(("3   Coupled ", "3   Fixed "))
    line = resolved(path)["forces"]["line_1_2"]["line"]
    assert (line["first"]["body"], line["second"]["body"]) == ("world", "fixed_points")


def test_a_deck_in_the_columns_of_the_first_version_is_read(deck) -> None:
    """Source: MoorDyn's manual on the input files of its version 1."""
    path = deck(
        (
            "chain     0.333  685.0   3.27e9  65.4e6    0    1.2  1.0  0.05  0.5",
            "chain 0.333 685 3.27e9 65.4e6 1.0 0.5 1.2 0.05",
        ),
        (
            "wire      0.1    40.0    5.0e8   -0.8      12   1.1  0.9  0.01  0.2",
            "wire 0.1 40 5.0e8 -0.8 0.9 0.2 1.1 0.01",
        ),
        ("spare     0.1    40.0    5.0e8   -0.8      0    1.1  0.9  0.01  0.2\n", ""),
        ("- POINTS -", "- CONNECTION PROPERTIES -"),
        ("- LINES -", "- LINE PROPERTIES -"),
        ("3   Coupled     0      0  -14.0   0     0       0    0", "3 Vessel 0 0 -14 0 0 0 0 5 0 0"),
        ("1   chain     1        2        405       20 ", "1 chain 405 20 1 2"),
        ("2   wire      2        3        405       11 ", "2 wire 405 11 2 3"),
    )
    assert convert(path).notes.left_out[0].text == "FX, FY, FZ 0 0 5"
    new, old = (resolved(each)["forces"]["line_1_2"]["line"] for each in (path, deck()))
    assert new == old


def test_stiffness_with_several_values_or_by_a_curve_is_one_number(deck, tmp_path) -> None:
    """Source: the first value; the slope to the last point of the curve, 2e6 N / 0.1."""
    path = deck(
        ("3.27e9  65.4e6", "3.27e9|5e9|0.4  65.4e6|1e6"),
        ("5.0e8   -0.8      12", "curve.txt  ba.txt  ei.txt"),
    )
    (tmp_path / "curve.txt").write_text(
        "strain tension\n(-) (N)\n---\n0.0 0.0\n0.1 2.0e6\n", encoding="utf-8"
    )
    chain, wire = resolved(path)["forces"]["line_1_2"]["line"]["sections"]
    assert (chain["axial_stiffness_N"], chain["damping_time_s"]) == (3.27e9, 65.4e6 / 3.27e9)
    assert (wire["axial_stiffness_N"], wire["damping_time_s"]) == (2e7, 0.01)
    assert {key for key in where(convert(path).notes.left_out) if key[0] in (6, 7)} == {
        (6, "EA"),
        (6, "BA"),
        (7, "EA"),
        (7, "BA"),
        (7, "EI"),
    }


@pytest.mark.parametrize(
    ("old", "new", "field", "value"),
    [
        ("200     WtrDpth", "300 depth", "sea.depth_m", 300),
        ("200     WtrDpth", "bed.dat WtrDpth", "sea.depth_m", 200),
        ("200     WtrDpth", "150 WtrDpth", "sea.depth_m", 200),
        ("9.81    g", "9.8 gravity", "forces.gravity.gravity.acceleration_m_s2", 9.8),
        ("1020    rho", "1000 WtrDnsty", "sea.density_kg_m3", 1000),
        ("0.005   dtM", "10 dtM", "simulation.step_s", 0.05),
        ("0.005   dtM", "0.5 cfl", "simulation.step_s", 0.01),
        ("0.5     dtOut", "1e9 dtOut", "simulation.record_every_s", 0.1),
        ("0.4     FrictionCoefficient", "0.3 MU_KA", "forces.line_1_2.line.seabed.friction", 0.3),
        (
            "1   Fixed       779.6  0  -200.0",
            "1 Fixed 779.6 0 seabed",
            "forces.line_1_2.line.first.position_m.2",
            -200,
        ),
    ],
)
def test_options_are_read_by_each_of_their_names(deck, old, new, field, value) -> None:
    found = resolved(deck((old, new)))
    for name in field.split("."):
        found = found[int(name)] if isinstance(found, list) else found[name]
    assert found == value


@pytest.mark.parametrize(
    ("option", "is_listed"),
    [
        ("1 Currents", True),
        ("0 Currents", False),
        ("1.0 StatDynFricScale", False),
        ("0.5 MC", True),
        ("3 anything", True),
        ("bed.txt SeafloorFile", True),
        ("7", True),
    ],
)
def test_options_without_a_counterpart_are_listed_unless_they_have_no_effect(deck, option, is_listed) -> None:
    notes = convert(deck(("100     TmaxIC", option))).notes.left_out
    assert (option in [note.text for note in notes]) == is_listed


def test_a_scenario_that_cannot_start_is_written_and_the_exit_code_is_1(deck, tmp_path, capsys) -> None:
    output = tmp_path / "taut.yaml"
    path = deck(("405       20", "100       20"), ("405       11", "100       11"))
    assert main(["convert", path, "-o", str(output)]) == 1
    assert "is converted, but cannot run" in capsys.readouterr().err
    assert output.exists()

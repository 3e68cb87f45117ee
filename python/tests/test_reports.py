"""Reports of the command line on a model and on a run, compared with the numbers that they show."""

from __future__ import annotations

import re

import kingpost
import numpy as np
import pytest
from kingpost.cli import main
from kingpost.reports import model as model_report
from kingpost.reports.run import summary
from kingpost.results import entries

SHORT = {"simulation.duration_s": 0.2}

FLOATS = """\
version: 1
title: a barge and a buoy
simulation: {step_s: 0.01, duration_s: 0.1}
bodies:
  barge:
    mass_t: 100
    shape: {box: {length_m: 10, width_m: 5, height_m: 2}}
    joint: {floating: {}}
  buoy:
    mass_t: 1
    shape: {sphere: {radius_m: 1}}
    joint: {floating: {initial: {position_m: [20, 0, 0]}}}
  mast:
    parent: barge
    mass_t: 1
    shape: {box: {length_m: 1, width_m: 1, height_m: 4}}
    joint: {revolute: {axis: [0, 0, 1]}}
"""
GRAVITY = "  gravity: {gravity: {}}\n"
FENDER = "  fender: {viscous_damping: {body: barge, linear_N_s_m: [1, 1, 1]}}\n"
FORCES = f"forces:\n{GRAVITY}"
ROPE = """\
loops:
  rope:
    first: {body: mast, position_m: [10, 0, 0]}
    second: {body: buoy, position_m: [-5, 0, 0]}
    constraints: [{distance: {length_m: 5}}]
"""
LEG = """\
drives:
  leg:
    cylinder: {first: {body: world}, second: {body: mast, position_m: [0, 0, 2]}, shortest_m: 1, longest_m: 3,
      speed_limit_m_s: 1, push_limit_N: 1, pull_limit_N: 1, stiffness_N_per_m: 1, damping_N_s_per_m: 1}
"""


def test_check_prints_targets_prescribed_rates_and_unsupported_bodies(tmp_path, capsys):
    """Source: the fields of the file, as they stand there."""
    text = kingpost.load("paper").text
    servo = "{servo: {joint: luff, target_deg: 90, stiffness_N_m_per_rad: 1, damping_N_m_s_per_rad: 1, "
    text = text.replace(
        "drives:\n  motor_1:", f"drives:\n  lift: {servo}torque_limit_kN_m: 2}}}}\n  motor_1:"
    )
    text = text.replace("name: slew\n", "name: slew\n        mode: {prescribed: {rate_rad_s: 0.25}}\n")
    path = tmp_path / "crane.yaml"
    path.write_text(text)
    assert main(["check", str(path), "--set", "motor_1=off", "--set", "gravity=on"]) == 0
    shown = capsys.readouterr().out
    assert re.search(
        r"^lift +servo +on +joint luff, target 90 deg, .*torque limit 2 kN m$", shown, re.MULTILINE
    )
    assert re.search(r"^slew +rate 14\.324 deg/s, history constant$", shown, re.MULTILINE)
    assert "falls" not in shown
    assert main(["check", "paper", "--set", "gravity=on", "--set", "hold_centre=off"]) == 0
    assert "warning: gravity acts and nothing carries ship: it falls" in capsys.readouterr().err


def test_check_prints_loops_and_cylinders(capsys):
    """Source: the fields of the file, as they stand there."""
    assert main(["check", "dual_draglink_crane"]) == 0
    shown = capsys.readouterr().out
    assert re.search(r"^drag_link_pin +drag_link_port and jib +x, z$", shown, re.MULTILINE)
    (line,) = (line for line in shown.splitlines() if line.startswith("luffing"))
    (law,) = kingpost.load("dual_draglink_crane").resolved["drives"]["luffing"].values()
    assert re.match(
        r"luffing +cylinder +on +first body column, first position \[1\.6, 0, -1\] m, second", line
    )
    for label, value, unit in (
        ("shortest", law["shortest_m"], "m"),
        ("longest", law["longest_m"], "m"),
        ("push limit", law["push_limit_N"] / 1e3, "kN"),
        ("speed limit", law["speed_limit_m_s"], "m/s"),
        ("target length", law["target"]["length"]["length_m"], "m"),
    ):
        assert f", {label} {value:g} {unit}" in line, label


def test_a_summary_has_the_largest_loop_reaction_loop_error_and_cylinder_force():
    """Source: the results that it sums up."""
    scenario = kingpost.load("dual_draglink_crane", SHORT)
    results = kingpost.run(scenario)
    shown = summary(results, scenario)
    reaction = results.loop_reaction.sel(loop="drag_link_pin").values[:, :3]
    largest_kn = np.linalg.norm(reaction, axis=1).max() / 1e3
    assert word(shown, "drag_link_pin", 1) == pytest.approx(largest_kn, rel=1e-4)
    worst = np.abs(results.loop_error.values).max()  # printed with two digits
    assert word(shown, "loop error, largest:", 1) == pytest.approx(worst, rel=0.05)
    force = results.cylinder_force.sel(cylinder="luffing").values
    (line,) = (
        line
        for line in shown.splitlines()
        if line.startswith("luffing") and "force of a cylinder" in line and "stops" not in line
    )
    *_, last, least, most, unit = line.split()
    expected = [value / 1e3 for value in (force[-1], force.min(), force.max())]
    assert [float(word) for word in (last, least, most)] == pytest.approx(expected, rel=1e-4)
    assert unit == "kN"


def test_a_summary_distinguishes_the_tensions_at_the_two_ends_of_a_rope():
    """Source: the descriptions of the engine's channels."""
    scenario = kingpost.load("lowering_by_winch", SHORT)
    results = kingpost.run(scenario)
    shown = [re.split(r"  +", line)[:2] for line in summary(results, scenario).splitlines()]
    (rope,) = results["rope"].values.tolist()
    tensions = [words for name, words, *_ in (row for row in shown if len(row) > 1) if "tension" in words]
    assert tensions == [results[name].attrs["description"] for name in ("rope_tension", "rope_first_tension")]
    assert [rope, tensions[0]] in shown


@pytest.mark.parametrize("name", kingpost.gallery.names())
def test_outputs_of_forces_and_drives_have_unique_descriptions(name, shown):
    """Source: a summary falls back on them where two quantities have one short name."""
    descriptions = [channel["description"] for channel in shown[name]["channels"] if channel["of_elements"]]
    assert len(set(descriptions)) == len(descriptions)


def word(text: str, label: str, number: int) -> float:
    """The n-th word behind a line's label, as a number."""
    (line,) = (line for line in text.splitlines() if line.startswith(f"{label} "))
    return float(line[len(label) :].split()[number - 1])


def test_a_summary_states_that_dormand_prince_chooses_its_steps():
    """Source: Scheme::dormand_prince; largest_step_s of the file."""
    settings = {"simulation.integrator": "dormand_prince", "simulation.dormand_prince.largest_step_s": 0.05}
    scenario = kingpost.load("paper", {**SHORT, **settings})
    shown = summary(kingpost.run(scenario), scenario)
    assert "0.2 s by dormand_prince in steps that it chooses, at most 0.05 s, " in shown
    assert "in steps of" not in shown
    assert "in steps of" not in model_report.text(scenario, [])


@pytest.mark.parametrize("name", ["dual_draglink_crane", "knuckle_boom_crane"])
def test_a_drawn_cylinder_has_the_length_in_the_results(name):
    """Source: two ways to one length: the points to draw; the channel of the run."""
    scenario = kingpost.load(name)
    simulation = kingpost.Simulation(scenario)
    simulation.step(500)
    poses = simulation.poses()
    bodies = [body["name"] for body in scenario.model["bodies"]]

    def place(pin):
        pose = poses[bodies.index(pin["body"])]
        w, r, p = pose[3], pose[4:], np.array(pin["position_m"])
        return pose[:3] + p + 2 * np.cross(r, np.cross(r, p) + w * p)

    row = simulation.row()
    channel = next(channel for channel in simulation.channels if channel["variable"] == "cylinder_length")
    drawn = {(line.name, line.style): line.points_m for line in simulation.lines()}
    for i, cylinder in enumerate(channel["labels"][0]):
        barrel, rod = drawn[cylinder, "barrel"], drawn[cylinder, "rod"]
        length = np.linalg.norm(rod[-1] - barrel[0])
        assert length == pytest.approx(row[channel["offset"] + i], abs=1e-12)
        law = scenario.resolved["drives"][cylinder]["cylinder"]
        assert law["shortest_m"] < length < law["longest_m"]
        # The rod comes out of the barrel.
        assert np.linalg.norm(rod[0] - barrel[0]) < np.linalg.norm(barrel[1] - barrel[0]) < length
    for loop in scenario.model["loops"]:
        assert place(loop["first"]) == pytest.approx(place(loop["second"]), abs=1e-9)


@pytest.mark.parametrize(("text", "falls"), [
    (FLOATS, []),
    (FLOATS + FORCES, ["barge", "buoy"]),
    (FLOATS + FORCES + FENDER, ["barge", "buoy"]),
    (FLOATS + FORCES + LEG, ["buoy"]),
    (FLOATS + FORCES + ROPE, ["barge", "buoy"]),
    (FLOATS + FORCES + ROPE + LEG, []),
])  # fmt: skip
def test_an_unsupported_body_falls(text, falls, tmp_path):
    """Source: with gravity something has to tie each floating body to the world; damping does not."""
    path = tmp_path / "floats.yaml"
    path.write_text(text, encoding="utf-8")
    scenario = kingpost.load(path)
    words = [f"gravity acts and nothing carries {name}: it falls" for name in falls]
    assert scenario.model["warnings"] == words
    shown = model_report.text(scenario, []).splitlines()
    assert [line for line in shown if line.startswith("warning: gravity")] == [
        f"warning: {word}" for word in words
    ]


def test_the_water_carries_a_ship_and_without_it_a_ship_falls():
    """Source: Archimedes; the results carry what was warned of."""
    falls = ["gravity acts and nothing carries ship: it falls"]
    paper = kingpost.load("paper", {"simulation.duration_s": 0.001}, gravity=True, hold_centre=False)
    assert paper.model["warnings"] == falls
    assert entries.model_warnings_of(kingpost.run(paper)) == falls
    assert kingpost.load("barge").model["warnings"] == []


def test_modes_of_the_waters_memory_are_printed_only_on_request(capsys):
    """Source: the barge's natural motions are three rigid ones that the water makes stiff, three that its
    soft hold does, of 120 s, and the load's two swings; frequency times period is 1 by name; participation
    factors of all states add up to 1."""
    assert main(["modes", "barge"]) == 0
    text = capsys.readouterr().out
    lines = text.splitlines()
    start = next(i for i, line in enumerate(lines) if line.startswith("mode "))
    rows = [line.split() for line in lines[start + 1 : lines.index("", start)]]
    swinging = [row for row in rows if row[2] == "oscillation"]
    assert {row[1] for row in swinging} == {
        "ship.x",
        "ship.y",
        "ship.yaw",
        "ship.z",
        "ship.roll",
        "ship.pitch",
        "pendant.first",
        "pendant.second",
    }
    assert all(abs(float(row[3]) * float(row[4]) - 1) < 2e-4 for row in swinging)
    assert "natural frequency, Hz  natural period, s" in lines[start]
    assert "radiation" not in text
    assert "modes of the water's memory of radiated waves (--all shows them)" in text
    assert main(["modes", "barge", "--all"]) == 0
    assert "radiation" in capsys.readouterr().out


def test_a_ship_on_dynamic_positioning_has_damped_modes_of_surge_sway_and_yaw():
    """Source: the eigenvalues of A, between 40 and 100 s; forces in N beside motions in m cost no digits."""
    scenario = kingpost.load("offshore_vessel_on_dp", waves=False)
    found = kingpost.modes(scenario)
    simulation = kingpost.Simulation(scenario)
    simulation.settle()
    values = np.linalg.eigvals(simulation.linearize().A.values)
    slow = [value for value in values if value.imag > 0 and 40 < 2 * np.pi / abs(value) < 100]
    # Filters in a row are damped as much as can be.
    slow = [value for value in slow if -value.real < 0.8 * abs(value)]
    # Surge, sway and yaw, and the heading on average, along which the hull feels the current.
    assert len(slow) == 4
    eigenvalues = found["eigenvalue_real"].values + 1j * found["eigenvalue_imaginary"].values
    for value in slow:
        assert np.abs(eigenvalues - value).min() < 1e-4 * abs(value)
        assert -value.real > 0.4 * abs(value)
    named = {str(name) for name in found["named_after"].values}
    assert {"hull.x", "hull.y", "hull.yaw"} <= named


def test_check_prints_where_a_hull_stands_that_is_drawn_from_its_keel(tmp_path, capsys) -> None:
    """A hull whose centre of mass is drawn one metre forward and two over the keel."""
    path = tmp_path / "hull.yaml"
    path.write_text(
        "{version: 1, title: A hull, bodies: {hull: {mass_t: 10, centre_of_mass_m: [1, 0, 2], "
        "shape: {sphere: {radius_m: 1}}, joint: {floating: {initial: {drawing_frame_m: [10, 0, -3]}}}}}}"
    )
    assert main(["check", str(path)]) == 0
    rows = [line.split("  ") for line in capsys.readouterr().out.splitlines()]
    placed = [[cell.strip() for cell in row if cell] for row in rows if row[0] == "hull"]
    assert ["hull", "11.000, 0.000, -1.000", "10.000, 0.000, -3.000"] in placed

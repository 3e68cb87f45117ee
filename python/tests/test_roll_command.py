"""`kingpost roll-damping`: both methods, printed and written output, errors, and the commands of the page."""

import math
import re
import shlex
from pathlib import Path

import kingpost
import numpy as np
import pytest
import roll_samples as samples
from kingpost import cli
from kingpost.hydro import read
from kingpost.roll_damping.radiated import radiated

PAGE = Path(__file__).resolve().parents[2] / "docs" / "roll_damping.md"
BLOCKS = re.findall(r"```(\w*)\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
HULL = "box:length_m=80,beam_m=18,draught_m=6,depth_m=9"
SECTIONS = ["roll-damping", "sections", HULL, "--kg-m", "7", "--period-s", "10"]
DECAY = ["roll-damping", "decay", str(samples.FOLDER / "kvlcc2_decay_21338.csv")]


def test_the_commands_and_examples_of_the_page_run(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "decay.csv").write_text((samples.FOLDER / "kvlcc2_decay_21338.csv").read_text())
    (tmp_path / "sections.csv").write_text((samples.FOLDER / "kvlcc2_sections.csv").read_text())
    ran = 0
    for language, block in BLOCKS:
        for line in block.replace("\\\n", "").splitlines() if not language else ():
            if line.startswith("kingpost "):
                assert cli.main(shlex.split(line)[1:]) == 0, line
                ran += 1
        if language == "python":
            exec(compile(block, PAGE.name, "exec"), {})
            ran += 1
    assert ran >= 4
    assert "B1 " in capsys.readouterr().out


def test_the_printed_forces_of_a_hull_are_valid_in_a_scenario(tmp_path, capsys):
    output = tmp_path / "forces.yaml"
    keels = ["--bilge-keels", "breadth_m=0.4,length_m=30", "--body", "rod"]
    assert cli.main([*SECTIONS, *keels, "-o", str(output)]) == 0
    shown = capsys.readouterr().out
    assert "keels, force" in shown
    assert output.read_text() in shown
    scenario = tmp_path / "scenario.yaml"
    body = (
        "bodies: {rod: {mass_kg: 1, inertia: {tensor: {moments_kg_m2: [1, 1, 1]}}, joint: {floating: {}}}}\n"
    )
    head = "version: 1\ntitle: x\nsimulation: {step_s: 0.1, duration_s: 1}\n"
    scenario.write_text(head + body + output.read_text())
    forces = kingpost.load(scenario).resolved["forces"]
    assert forces["roll_damping"]["viscous_damping"]["angular_N_m_s"][0] > 0
    assert forces["roll_drag"]["quadratic_damping"]["angular_N_m_s2"][0] > 0


def test_a_decay_test_prints_its_period_and_without_inertia_no_forces(capsys):
    assert cli.main(DECAY) == 0
    shown = capsys.readouterr().out
    assert re.search(r"natural period\s+2\.5", shown)
    assert "forces:" not in shown
    assert cli.main([*DECAY, "--mass-kg", "994.3", "--gm-m", "0.0843"]) == 0
    shown = capsys.readouterr().out
    assert "quadratic_damping" in shown
    # Two terms of a fit with two terms, both positive.
    assert "within 0.0% of it from 3." in shown


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ([*SECTIONS, "--bilge-keels", "breadth_m=-1,length_m=30"], "bilge_keels.breadth_m: found -1"),
        ([*SECTIONS, "--bilge-keels", "breadth=1"], "--bilge-keels: found 'breadth=1'"),
        ([*SECTIONS, "--bilge-keels", "breadth_m=0.4"], "--bilge-keels: found 'breadth_m=0.4'"),
        ([*SECTIONS, "--bilge-keels", "breadth_m=x,length_m=3"], "--bilge-keels breadth_m: found 'x'"),
        ([*SECTIONS, "--amplitudes-deg", "0"], "amplitudes_rad: found 0"),
        ([*SECTIONS, "-o", "forces.txt"], "unknown ending"),
        ([*DECAY, "--mass-kg", "3"], "--gm-m: found none, allowed: --mass-kg and --gm-m together"),
        (
            [*DECAY, "--inertia-kg-m2", "3", "--mass-kg", "3"],
            "--inertia-kg-m2: found --mass-kg or --gm-m too",
        ),
        ([*DECAY, "--inertia-kg-m2", "-3"], "--inertia-kg-m2: found -3"),
        ([*DECAY, "--kg-m", "3"], "--database: found none"),
        ([*DECAY, "--column", "sway"], "columns: found time_s, roll_rad"),
        (
            [*DECAY, "--mass-kg", "nan", "--gm-m", "1"],
            "--mass-kg: found nan, allowed: a number greater than 0",
        ),
        (["roll-damping", "decay", "none.csv"], "none.csv: found No such file"),
    ],
)
def test_wrong_input_of_the_command_roll_damping_gives_one_error_line(words, message, capsys):
    assert cli.main(words) == 2
    error = capsys.readouterr().err
    assert error.startswith("error: ")
    assert message in error
    assert error.count("\n") == 1


def test_the_forces_exclude_the_radiation_damping_of_the_hulls_database(tmp_path, capsys):
    """A synthetic decay of the gallery's vessel: with its database less damping is left for the forces."""
    path = tmp_path / "decay.csv"
    time = np.arange(0, 150, 0.3)
    roll = 10 * np.exp(-0.02 * time) * np.cos(0.55 * time)
    path.write_text("time_s,roll_deg\n" + "\n".join(f"{t},{x}" for t, x in zip(time, roll, strict=True)))
    words = ["roll-damping", "decay", str(path), "--inertia-kg-m2", "3e8", "--model", "linear"]
    database = kingpost.gallery.folder() / "hydro" / "offshore_vessel.hydro.json"
    left = []
    for more in ([], ["--database", str(database), "--kg-m", "6.5"]):
        assert cli.main([*words, *more]) == 0
        shown = capsys.readouterr().out
        left.append(float(re.search(r"angular_N_m_s: \[([\d.]+),", shown)[1]))
    waves = radiated(read(database), 6.5, math.hypot(0.55, 0.02))[1]
    # exp(-0.02 t) cos 0.55 t has p1 = 0.04 and omega0^2 = 0.55^2 + 0.02^2; the forces have six digits.
    assert left[0] == pytest.approx(0.04 * 3e8, rel=1e-4)
    assert left[0] - left[1] == pytest.approx(waves, rel=1e-3)


def test_forces_without_an_inertia_are_not_written(tmp_path, capsys):
    assert cli.main([*DECAY, "-o", str(tmp_path / "forces.yaml")]) == 2
    assert "--output: found no inertia" in capsys.readouterr().err

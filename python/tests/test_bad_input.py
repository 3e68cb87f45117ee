"""Wrong input: one error with its place, from Python and from the command line alike."""

from __future__ import annotations

import os

import kingpost
import pytest
from kingpost.cli import main
from samples import SMALL

# What is replaced in the small scenario, by what, the line of the error and its field. The line
# is where the wrong value stands, counted in SMALL.
WRONG = {
    "a wrong type": ("mass_kg: 1000", "mass_kg: heavy", 11, "bodies.box.mass_kg"),
    "an unknown field": ("mass_kg: 1000", "mass_kilo: 1000", 11, "bodies.box"),
    "a negative mass": ("mass_kg: 1000", "mass_kg: -5", 11, "bodies.box.mass_kg"),
    "a broken inertia": ("[10, 40, 40]", "[10, 40, 90]", 17, "bodies.boom.inertia.tensor"),
    "an unknown parent": ("parent: box", "parent: boat", 15, "bodies.boom.parent"),
    "two bodies of one name": ("  boom:\n", "  box:\n", 14, "bodies"),
    "step zero": ("step_s: 0.01,", "step_s: 0,", 8, "simulation.step_s"),
    "not a number": ("mass_kg: 1000", "mass_kg: .nan", 11, "bodies.box.mass_kg"),
    "a drive of no joint": ("joint: hinge, t", "joint: knuckle, t", 21, "drives.motor.motor.joint"),
}
CYCLE = SMALL.replace("joint: {floating: {hold_translation: false}}", "parent: boom\n    joint: {fixed: {}}")


@pytest.mark.parametrize("what", WRONG)
def test_a_wrong_value_is_reported_with_its_place(what, tmp_path, capsys):
    """Source: the line counted in the file, the field's path."""
    old, new, line, field = WRONG[what]
    assert SMALL.count(old) == 1
    error = refused(SMALL.replace(old, new).encode(), tmp_path, capsys)
    assert error.line == line
    assert error.field.startswith(field)
    assert error.found
    assert error.allowed


def test_bodies_whose_joints_form_a_cycle_are_refused(tmp_path, capsys):
    """Source: a tree has no cycle."""
    error = refused(CYCLE.encode(), tmp_path, capsys)
    assert error.field.startswith("bodies.")
    assert error.field.endswith("parent")


@pytest.mark.parametrize(
    "content",
    [b"", b"# nothing here\n", b"\x89PNG\r\n\x1a\n\x00\x00\xff", b"[project]\nname = 'x'\n", b"a,b\n1,2\n"],
    ids=["empty", "comments only", "a picture", "another format", "a table"],
)
def test_a_file_that_is_not_a_scenario_is_refused(content, tmp_path, capsys):
    """Source: the exit code and the one line of the public contract."""
    refused(content, tmp_path, capsys)


def refused(content: bytes, folder, capsys) -> kingpost.ScenarioError:
    """The error from Python; from the command line it must be the same text, in one line."""
    path = folder / "wrong.yaml"
    path.write_bytes(content)
    with pytest.raises(kingpost.ScenarioError) as caught:
        kingpost.load(path)
    assert str(path) in str(caught.value)
    for command in (["check"], ["run"]):
        assert main([*command, str(path)]) == 2
        shown = capsys.readouterr()
        assert shown.out == ""
        assert one_line(shown.err) == f"error: {' '.join(str(caught.value).split())}"
    return caught.value


def one_line(text: str) -> str:
    assert text.count("\n") == 1, text
    return text.rstrip("\n")


@pytest.mark.parametrize(
    ("assignment", "says"),
    [
        ("no_such=1", "no_such"),
        ("bodies.ship.mass_kg=-5", "--set bodies.ship.mass_kg"),
        ("bodies.ship.mass=5", "bodies.ship"),
        ("crane_x_m=99", "crane_x_m"),
        ("torque_history=square", "torque_history"),
        ("motor_1=maybe", "motor_1"),
        ("simulation.step_s=nan", "simulation.step_s"),
        ("motor_1", "motor_1"),
    ],
)
def test_a_wrong_setting_is_refused_by_name(assignment, says, capsys):
    """Source: the public contract: exit code 2, one line that names the setting."""
    assert main(["run", "paper", "--set", assignment]) == 2
    assert says in one_line(capsys.readouterr().err)


def test_a_wrong_setting_from_python_is_a_scenario_error():
    """Source: the same mechanism as --set."""
    with pytest.raises(kingpost.ScenarioError, match="no_such"):
        kingpost.load("paper", no_such=1)
    with pytest.raises(kingpost.ScenarioError, match=r"bodies\.ship\.mass_kg"):
        kingpost.load("paper", {"bodies.ship.mass_kg": float("nan")})
    with pytest.raises(kingpost.ScenarioError, match="crane_x_m"):
        kingpost.load("paper", crane_x_m=object())


def test_a_misspelt_gallery_name_gets_the_nearest_name_as_a_suggestion(capsys):
    """Source: the gallery has `paper`."""
    assert main(["run", "papre"]) == 2
    assert "did you mean 'paper'" in one_line(capsys.readouterr().err)
    with pytest.raises(kingpost.ScenarioError, match="did you mean 'paper'"):
        kingpost.load("papre")


@pytest.mark.parametrize("name", ["nowhere.yaml", "no/such/file", "."])
def test_the_error_for_a_missing_file_states_that_it_is_missing(name, capsys):
    """Source: the public contract: exit code 2, one line."""
    assert main(["check", name]) == 2
    assert name in one_line(capsys.readouterr().err)


@pytest.mark.parametrize("output", ["out.xlsx", "out", "no/such/folder/out.nc", "/proc/out.nc", "."])
def test_an_output_that_cannot_be_written_is_refused_before_the_run(output, tmp_path, monkeypatch, capsys):
    """Source: the public contract; nothing is simulated, so nothing is printed."""
    monkeypatch.chdir(tmp_path)
    assert main(["run", "paper", "-o", output]) == 2
    shown = capsys.readouterr()
    assert shown.out == ""
    assert output in one_line(shown.err)
    assert os.listdir(tmp_path) == []


@pytest.mark.parametrize(
    "arguments", [[], ["fly"], ["run"], ["run", "paper", "--fast"], ["serve", "--port", "x"]]
)
def test_a_wrong_command_line_gives_one_error_line_and_exit_code_2(arguments, capsys):
    """Source: the public contract."""
    with pytest.raises(SystemExit) as ended:
        main(arguments)
    assert ended.value.code == 2
    assert one_line(capsys.readouterr().err).startswith("error: ")


def test_overrides_that_are_not_a_dictionary_are_refused():
    """Source: the signature of `kingpost.run`."""
    with pytest.raises(kingpost.KingpostError, match=r"overrides: found \[1\], allowed: a dictionary"):
        kingpost.run("paper", [1])


@pytest.mark.parametrize("n", [-1, 1.5, True, "2"])
def test_a_count_of_steps_that_is_not_a_number_is_refused(n):
    """Source: the signature of `Simulation.step`."""
    simulation = kingpost.Simulation("paper")
    with pytest.raises(kingpost.KingpostError, match=r"n: found .*, allowed: a whole number from 0 to 1e.15"):
        simulation.step(n)
    assert simulation.time_s == 0


def test_a_missing_local_database_is_not_replaced_by_the_gallerys(tmp_path, capsys):
    """Source: another hull of the same name is another ship; the error says where the file should be."""
    path = tmp_path / "sphere.yaml"
    text = kingpost.load("sphere_decay").text
    path.write_text(text.replace("gallery:hydro/", "hydro/"))
    assert main(["check", str(path)]) == 2
    says = one_line(capsys.readouterr().err)
    assert "forces.water.hydrodynamics.database: found no file hydro/sphere.hydro.json" in says
    assert f"looked for {tmp_path / 'hydro' / 'sphere.hydro.json'}" in says
    # The gallery's own names the gallery's, from wherever it lies.
    path.write_text(text)
    assert kingpost.load(path).files.keys() == {"gallery:hydro/sphere.hydro.json"}

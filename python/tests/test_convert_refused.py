"""Wrong input files of `kingpost convert` are refused with file, line, column, field, found and allowed."""

from __future__ import annotations

from functools import partial

import pytest
from kingpost.cli import main
from kingpost.convert import convert
from kingpost.errors import ScenarioError
from mooring_decks import MOORPY, write_deck


@pytest.fixture
def deck(tmp_path):
    """A function that writes a deck, with replacements, and returns its path."""
    return partial(write_deck, tmp_path)


WRONG = [
    (
        "0.333  685.0",
        "steel  685.0",
        "6:11: LINE TYPES.Diam: found 'steel', allowed: a number greater than 0",
    ),
    ("0.333  685.0", "0  685.0", "6:11: LINE TYPES.Diam: found '0', allowed: a number greater than 0"),
    ("0.333  685.0", "0.333  -685.0", "LINE TYPES.Mass/m: found '-685.0'"),
    ("0.333  685.0", "0.333  nan", "LINE TYPES.Mass/m: found 'nan'"),
    ("3.27e9", "1e200", "LINE TYPES.EA: found '1e200', allowed: 0, or a number from 1e-30 to 1e+30"),
    ("3.27e9", "1e999", "LINE TYPES.EA: found '1e999'"),
    (
        "3.27e9",
        "none.txt",
        "found 'none.txt', allowed: a number greater than 0, N, or a file beside this one",
    ),
    ("1.2  1.0  0.05  0.5", "1.2  1.0", "6:54: LINE TYPES: found 8 values, allowed: 10"),
    (
        "1.2  1.0  0.05  0.5",
        "-1.2  1.0  0.05  0.5",
        "LINE TYPES.Cd: found '-1.2', allowed: a number of at least 0",
    ),
    ("spare ", "wire ", "8:1: LINE TYPES.name: found 'wire', allowed: another name than that of line 7"),
    ("3   Coupled", "3   Hanging", "14:5: POINTS.attachment: found 'Hanging', allowed: Fixed, Coupled"),
    ("3   Coupled", "3   Body1", "POINTS.attachment: found 'Body1', allowed: one of the 0 bodies in BODIES"),
    ("3   Coupled", "5   Coupled", "14:1: POINTS.ID: found '5', allowed: 3: numbers rise by one from 1"),
    ("779.6  0", "far  0", "POINTS.X: found 'far', allowed: a number"),
    (
        "2   Free        390    0  -107.0  0     0       0    0",
        "2 Free 390 0",
        "POINTS: found 4 values, allowed: 9",
    ),
    (
        "1   chain     1        2",
        "1   rope     1        2",
        "18:5: LINES.LineType: found 'rope', allowed: one of chain",
    ),
    (
        "1   chain     1        2",
        "1   chain     1        9",
        "LINES.AttachB: found '9', allowed: a number of POINTS, from 1 to 3",
    ),
    ("1   chain     1        2", "1   chain     1        R1A", "LINES.AttachB: found 'R1A'"),
    (
        "1   chain     1        2",
        "1   chain     2        2",
        "LINES.AttachB: found '2', allowed: another point",
    ),
    ("405       20", "0       20", "LINES.UnstrLen: found '0', allowed: a number greater than 0"),
    ("405       20", "405       0", "LINES.NumSegs: found '0', allowed: a whole number of at least 1"),
    ("405       20", "405       2.5", "LINES.NumSegs: found '2.5'"),
    ("0.005   dtM", "0   dtM", "25:1: OPTIONS.dtM: found '0', allowed: a number greater than 0"),
    ("9.81    g", "-9.81    g", "OPTIONS.g: found '-9.81'"),
    ("1020    rho", "0    rho", "OPTIONS.rho: found '0', allowed: a number greater than 0"),
    ("2e6     kBot", "soft     kBot", "OPTIONS.kBot: found 'soft'"),
    ("- LINE TYPES -", "- ROD TYPES -", "LINE TYPES: found no section LINE TYPES"),
    (
        "1   chain     1        2        405       20       p\n"
        "2   wire      2        3        405       11       -\n",
        "",
        "15: LINES: found a section LINES without rows",
    ),
]


@pytest.mark.parametrize(("old", "new", "said"), WRONG)
def test_a_wrong_deck_is_refused_with_the_place(deck, capsys, tmp_path, old, new, said) -> None:
    path, output = deck((old, new)), tmp_path / "none.yaml"
    assert main(["convert", path, "-o", str(output)]) == 2
    error = capsys.readouterr().err
    assert said in error
    assert path in error
    assert not output.exists()
    with pytest.raises(ScenarioError) as raised:
        convert(path)
    assert raised.value.allowed


@pytest.mark.parametrize("content", ["", "no sections\n", "--- title ---\n", "\0\1\2"])
def test_a_file_without_sections_is_refused(deck, content) -> None:
    with pytest.raises(ScenarioError, match="allowed: a MoorDyn input file"):
        convert(deck(text=content))
    with pytest.raises(ScenarioError, match=r"allowed: a (MoorPy file|mapping)"):
        convert(deck(text=content or "\n", name="empty.yaml"))


def test_a_file_that_does_not_exist_and_the_input_as_output_are_refused(deck, tmp_path, capsys) -> None:
    assert main(["convert", str(tmp_path / "none.txt")]) == 2
    assert "No such file" in capsys.readouterr().err
    path = deck(text=MOORPY, name="moorpy.yaml")
    assert main(["convert", path, "-o", path]) == 2
    assert "allowed: another file than the input" in capsys.readouterr().err
    assert main(["convert", path, "-o", str(tmp_path / "scenario.txt")]) == 2
    assert "allowed: .yaml, .yml" in capsys.readouterr().err

"""`kingpost convert` of MoorPy's YAML files."""

from __future__ import annotations

from functools import partial

import pytest
from kingpost.convert import convert
from kingpost.errors import ScenarioError
from mooring_decks import MOORPY, resolved, write_deck


@pytest.fixture
def deck(tmp_path):
    """A function that writes a deck, with replacements, and returns its path."""
    return partial(write_deck, tmp_path)


@pytest.mark.parametrize("is_raft", [False, True])
def test_a_file_of_moorpy_becomes_a_scenario(deck, tmp_path, is_raft) -> None:
    """Source: the numbers of the file; in a file of RAFT they stand under `mooring`."""
    text = MOORPY
    if is_raft:
        text = "site: {g: 9.81}\nmooring:\n" + "".join(f"  {line}\n" for line in MOORPY.splitlines())
    path = deck(text=text, name="moorpy.yaml")
    found = resolved(path)
    assert set(found["bodies"]) == {"vessel"}
    assert (found["sea"]["depth_m"], found["sea"]["density_kg_m3"]) == (200, 1020)
    assert found["forces"]["gravity"]["gravity"]["acceleration_m_s2"] == (9.81 if is_raft else 9.80665)
    (line,) = (force["line"] for force in found["forces"].values() if "line" in force)
    assert (line["first"]["body"], line["second"]["body"]) == ("world", "vessel")
    section, upper = line["sections"]
    assert section["clump_weight"]["mass_kg"] == 5000
    assert upper.get("clump_weight") is None
    assert (section["elements"], section["drag_across"], section["added_mass_across"]) == (20, 1.2, 1)
    shift = 2 * is_raft
    assert {(note.line, note.text) for note in convert(path).notes.left_out} == {
        (4 + shift, "anchor_type: suction"),
        (11 + shift, "cost: 10"),
    }


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("water_depth: 200", "water_depth: deep", "1:14: water_depth: found 'deep', allowed: a number"),
        ("type: vessel", "type: boat", "6:28: points.2.type: found 'boat', allowed: fixed"),
        ("[0, 0, -14]", "[0, 0]", "points.2.location: found 'a list', allowed: a list of three numbers"),
        ("[0, 0, -14]", "[0, 0, deep]", "points.2.location: found 'deep', allowed: a number"),
        (
            "name: fairlead",
            "name: buoy",
            "points.2.name: found 'buoy', allowed: another name than that of line 5",
        ),
        (
            "endB: fairlead",
            "endB: bow",
            "lines.1.endB: found 'bow', allowed: one of Anchor 1, buoy, fairlead",
        ),
        ("endB: fairlead, ", "", "9:5: lines.1.endB: found nothing, allowed: a name of points"),
        ("endB: fairlead", "endB: buoy", "lines.1.endB: found 'buoy', allowed: another point"),
        (
            "endA: buoy, endB: fairlead, type: chain",
            "endA: buoy, endB: fairlead, type: rope",
            "lines.1.type: found 'rope', allowed: one of chain",
        ),
        ("stiffness: 3.27e9, ", "", "line_types.0.stiffness: found nothing, allowed: a number"),
        (
            "diameter: 0.333",
            "diameter: 0",
            "line_types.0.diameter: found '0', allowed: a number greater than 0",
        ),
        (
            "rho: 1020",
            "file: deck.dat",
            "found 'deck.dat', allowed: no file: convert the MoorDyn file itself",
        ),
        ("line_types:", "types:", "line_types: found nothing, allowed: a list of mappings"),
        ("rho: 1020", "rho: [", "allowed: a MoorPy file in YAML"),
    ],
)
def test_a_wrong_file_of_moorpy_is_refused_with_the_place(deck, old, new, said) -> None:
    path = deck((old, new), text=MOORPY, name="moorpy.yaml")
    with pytest.raises(ScenarioError) as raised:
        convert(path)
    assert said in str(raised.value)
    assert str(raised.value).startswith(path)


def test_nesting_without_limits_is_refused(deck) -> None:
    with pytest.raises(ScenarioError, match="more than 50 lists or mappings"):
        convert(deck(text="[" * 5000 + "]" * 5000, name="deep.yaml"))

"""`kingpost convert` of bodies and rods of MoorDyn."""

from __future__ import annotations

import math
from functools import partial

import pytest
from kingpost.convert import convert
from mooring_decks import BODIES, HEAD, resolved, where, write_deck


@pytest.fixture
def deck(tmp_path):
    """A function that writes a deck, with replacements, and returns its path."""
    return partial(write_deck, tmp_path)


@pytest.mark.parametrize(
    ("attachment", "mass", "moment", "joint"),
    [
        ("Coupled", "0", "0", "held"),
        ("Vessel", "1e6", "1e8", "held"),
        ("Free", "1e6", "1e8", "free"),
        ("Free", "1e6", "0", "free"),
        ("Free", "0", "0", "held"),
        ("Fixed", "0", "0", "fixed"),
        ("CoupledPinned", "1e6", "1e8", "spherical"),
        ("CoupledPinned", "0", "0", "held"),
    ],
)
def test_bodies_carry_points(deck, attachment, mass, moment, joint) -> None:
    """Source: MoorDyn's manual on the attachments of bodies; a yaw of 90 degrees turns x to y."""
    added = BODIES.format(attachment=attachment, mass=mass, moment=moment)
    path = deck((HEAD, added + HEAD), ("3   Coupled     0      0  -14.0", "3   Body1 0 0 -9"))
    body = resolved(path)["bodies"]["body_1"]
    kind = body["joint"]
    if joint in ("held", "free"):
        floating = kind["floating"]
        assert floating["hold_translation"] == (joint == "held")
        assert floating["hold_rotation"] == (joint == "held" or moment == "0")
        assert floating["initial"]["position_m"] == pytest.approx([1, 2, -7])
        assert floating["initial"]["orientation_rad"] == pytest.approx([0, 0, math.pi / 2])
    else:
        assert kind[joint]["position_m"] == [1, 2, -5]
    left_out = where(convert(path).notes.left_out)
    assert {key for key in left_out if "rods" in left_out[key]} == {(16, "1"), (17, "2"), (18, "3")}
    assert (12, "CdA") in left_out


def test_lines_at_ends_of_rods_are_kept_where_the_ends_have_a_place(deck) -> None:
    added = BODIES.format(attachment="Coupled", mass="1e6", moment="1e8")
    three = ("3   Coupled     0      0  -14.0", "3   Body1 0 0 -9")
    path = deck(
        (HEAD, added + HEAD),
        three,
        ("1   chain     1        2", "1   chain     1        R3A"),
        ("2   wire      2        3", "2   wire      R3B      R1A"),
    )
    line = resolved(path)["forces"]["line_1_2"]["line"]
    assert (line["second"]["body"], line["second"]["position_m"]) == ("body_1", [0, 0, 2])
    dropped = deck((HEAD, added + HEAD), three, ("2   wire      2        3", "2   wire      2       R2A"))
    assert list(convert(dropped).lines) == ["line_1"]
    assert "on a rod" in where(convert(dropped).notes.left_out)[29, "2"]

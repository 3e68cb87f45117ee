"""Parts: scenarios made of other files, on the command line, in results and in their errors."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

import kingpost
import pytest
from kingpost import gallery
from kingpost.cli import main

SHIP = """
version: 1
title: A ship with a crane of its own
simulation: {duration_s: 0.1, step_s: 0.01}
bodies:
  ship: {mass_t: 500, shape: {box: {length_m: 30, width_m: 10, height_m: 4}}, joint: {floating: {}}}
parts:
  crane: {part: cranes/post.yaml, on: ship, position_m: [3, 0, 2]}
  stores: {part: paper_crane, on: ship, position_m: [-8, 2, 2]}
"""
POST = """
version: 1
title: A post
parameters: [{name: mass_t, default: 2, range: [1, 9], writes: [bodies.post.mass_t]}]
bodies:
  post: {mass_t: 2, shape: {box: {length_m: 1, width_m: 1, height_m: 6}}, joint: {fixed: {}}}
"""


@pytest.fixture
def ship(tmp_path: Path) -> Path:
    (tmp_path / "cranes").mkdir()
    (tmp_path / "cranes" / "post.yaml").write_text(POST)
    (tmp_path / "ship.yaml").write_text(SHIP)
    return tmp_path / "ship.yaml"


def test_parts_are_found_beside_the_scenario_and_in_the_gallery(ship):
    """Source: the files' own numbers."""
    scenario = kingpost.load(ship, crane_mass_t=3)
    assert list(scenario.files) == ["cranes/post.yaml", "gallery:parts/paper_crane.yaml"]
    masses = {body["name"]: body["mass_kg"] for body in scenario.model["bodies"]}
    assert masses["crane_post"] == 3000
    assert masses["stores_tower"] == 500


def test_check_lists_the_parts_and_their_positions(ship, capsys):
    """Source: the mountings in the file."""
    assert main(["check", str(ship)]) == 0
    shown = [line.split() for line in capsys.readouterr().out.splitlines()]
    assert ["crane", "cranes/post.yaml", "ship", "3,", "0,", "2", "m"] in shown
    assert ["stores", "paper_crane", "ship", "-8,", "2,", "2", "m"] in shown


def test_results_contain_the_digests_of_their_files_and_load_without_the_files(ship, tmp_path):
    """Source: SHA-256 of the files as they lie there."""
    found = kingpost.run(ship)
    digests = json.loads(found.attrs["files"])
    assert digests["cranes/post.yaml"] == hashlib.sha256(POST.encode()).hexdigest()
    crane = (gallery.folder() / "parts" / "paper_crane.yaml").read_bytes()
    assert digests["gallery:parts/paper_crane.yaml"] == hashlib.sha256(crane).hexdigest()
    stored = tmp_path / "elsewhere" / "resolved.json"
    stored.parent.mkdir()
    stored.write_text(found.attrs["scenario"])
    again = kingpost.load(stored)
    assert again.files == {}
    assert kingpost.run(again).equals(found)


def test_a_resolved_scenario_of_the_gallery_finds_its_database_from_anywhere(tmp_path):
    """Source: the database is the gallery's, whatever folder the scenario lies in."""
    stored = tmp_path / "resolved.json"
    stored.write_text(kingpost.load("barge").json)
    assert list(kingpost.load(stored).files) == ["gallery:hydro/barge.hydro.json"]


WRONG_MOUNTINGS = [
    (
        "part: paper_crane",
        "part: papr_crane",
        "ship.yaml:9:18: parts.stores.part: found no file gallery:parts/papr_crane.yaml",
        "did you mean paper_crane?",
    ),
    (
        "cranes/post",
        "cranes/pots",
        "ship.yaml:8:17: parts.crane.part: found no file cranes/pots.yaml",
        "looked for ",
    ),
    (
        "on: ship, position_m: [3",
        "on: shp, position_m: [3",
        "ship.yaml:8:39: parts.crane.on: found shp",
        "did you mean ship?",
    ),
]


@pytest.mark.parametrize(("old", "new", "place", "hint"), WRONG_MOUNTINGS)
def test_a_wrong_mounting_is_refused_with_its_place(ship, capsys, old, new, place, hint):
    """Source: where the words stand in the file."""
    ship.write_text(SHIP.replace(old, new))
    assert main(["check", str(ship)]) == 2
    answer = capsys.readouterr().err
    assert place in answer
    assert hint in answer


def test_an_error_in_a_part_names_the_parts_file(ship, capsys):
    """Source: where the number stands in the part's file."""
    part = ship.parent / "cranes" / "post.yaml"
    part.write_text(POST.replace("post: {mass_t: 2", "post: {mass_t: -2"))
    assert main(["check", str(ship)]) == 2
    answer = capsys.readouterr().err
    assert f"{part}:6:18: bodies.post.mass_t: found -2, allowed: a number greater than 0" in answer
    assert main(["check", "vessel_knuckle_boom", "--set", "crane_load_t=-3"]) == 2
    assert "--set crane_load_t: found -3, allowed: a number from 0.5 to 15" in capsys.readouterr().err

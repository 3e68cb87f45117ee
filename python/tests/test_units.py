"""The unit of one column of a variable that has several."""

from __future__ import annotations

import json
from pathlib import Path

import kingpost
import pytest
import xarray
from kingpost import report, units
from kingpost.cli import main

BODY = {"mass_kg": 9, "inertia": {"tensor": {"moments_kg_m2": [1, 1, 1]}}}
JOINTS = {
    "trolley": {"prismatic": {"name": "rail", "axis": [1, 0, 0]}},
    "table": {"planar": {"normal": [0, 0, 1], "x_axis": [1, 0, 0]}},
    "screw": {"cylindrical": {"axis": [0, 0, 1]}},
    "ball": {"spherical": {}},
    "arm": {"revolute": {"axis": [0, 0, 1]}},
}
SCENARIO = {
    "version": 1,
    "title": "Joints of several kinds",
    "simulation": {"step_s": 0.01, "duration_s": 0.02, "record_every_s": 0.01},
    "bodies": {name: {**BODY, "joint": joint} for name, joint in JOINTS.items()},
}
LENGTHS = {"rail", "table.x", "table.y", "screw.translation"}


@pytest.fixture
def joints(tmp_path: Path) -> Path:
    """A scenario with joints that slide and joints that turn."""
    path = tmp_path / "joints.yaml"
    path.write_text(json.dumps(SCENARIO), encoding="utf-8")
    return path


@pytest.mark.parametrize(
    ("dimension", "label", "both", "unit"),
    [
        ("component", "force_z", "N, N m", "N"),
        ("component", "moment_x", "N, N m", "N m"),
        ("planar", "sway", "m, rad", "m"),
        ("planar", "yaw", "m, rad", "rad"),
        ("coordinate", "pendant.first", "rad or m", "rad"),
        ("coordinate", "winch", "N m or N", "N"),
    ],
)
def test_a_column_has_the_unit_of_its_own_component(dimension, label, both, unit) -> None:
    series = xarray.DataArray([0.0], {dimension: label}, ("time",), attrs={"units": both})
    assert units.of_column(series, {"winch"}) == unit


def test_lengths_are_told_from_angles_by_the_kind_of_the_joint_not_by_the_names_of_its_axes(joints) -> None:
    """Source: docs/conventions.md: the x of a planar joint is a length, that of a spherical one an angle."""
    found = kingpost.run(joints)
    assert units.sliding(found) == LENGTHS
    shown = report.summary(found, kingpost.load(joints)).splitlines()
    # The table of positions stands before that of reactions.
    rows = {line.split()[0]: line.split() for line in reversed(shown) if line.split()}
    for name in found["coordinate"].values:
        assert rows[str(name)][3] == ("m" if name in LENGTHS else "deg"), name
        assert rows[str(name)][6] == ("m/s" if name in LENGTHS else "rad/s"), name


def test_the_heave_of_a_ship_that_waves_move_is_a_length() -> None:
    """Source: its surge, sway and heave are along the axes of its heading, its angles about them."""
    names = [f"ship.{axis}" for axis in ("x", "y", "z", "roll", "pitch", "yaw")]
    scenario = json.dumps({"bodies": {"ship": {"joint": {"moved_by_waves": {}}}}})
    found = xarray.Dataset(coords={"coordinate": names}, attrs={"scenario": scenario})
    assert units.sliding(found) == {"ship.x", "ship.y", "ship.z"}


def test_statistics_of_a_file_have_the_units_of_the_run(joints, tmp_path, capsys) -> None:
    assert main(["run", str(joints), "-o", str(tmp_path / "run.nc")]) == 0
    capsys.readouterr()
    channels = ["table.x.joint_position", "ball.x.joint_position"]
    assert main(["statistics", str(tmp_path / "run.nc"), "--channels", *channels]) == 0
    text = capsys.readouterr().out
    rows = {line.split()[0]: line.split() for line in text.splitlines() if line.split()}
    assert [rows[channel][1] for channel in channels] == ["m", "deg"]

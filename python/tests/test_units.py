"""Every column of results has one valid unit."""

from __future__ import annotations

import json
from pathlib import Path

import kingpost
import pint
import pyarrow.parquet
import pytest
import xarray
from kingpost import gallery, results
from kingpost.analysis.displacement_raos import SENSES
from kingpost.analysis.statistics import spectrum, summary
from kingpost.cli import main
from kingpost.hydro import read, to_dataset
from kingpost.reports import run as report

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
UNITS = pint.UnitRegistry()


@pytest.fixture
def joints(tmp_path: Path) -> Path:
    """A scenario with joints that slide and joints that turn."""
    path = tmp_path / "joints.yaml"
    path.write_text(json.dumps(SCENARIO), encoding="utf-8")
    return path


@pytest.mark.parametrize("name", gallery.names())
def test_every_column_of_the_gallery_has_one_unit_that_pint_parses(name, shown) -> None:
    """Source: pint, a program of its own that knows units."""
    one = shown[name]
    names = [column for channel in one["channels"] for column in channel["columns"]]
    units = dict(one["units"])
    assert list(units) == names == one["columns"]
    assert list(units.values()) == [unit for channel in one["channels"] for unit in channel["units"]]
    for column, unit in units.items():
        dimension = UNITS.parse_units(unit).dimensionality
        if ".moment_" in column:
            assert dimension == UNITS.parse_units("N m").dimensionality, column
        elif ".force_" in column:
            assert dimension == UNITS.parse_units("N").dimensionality, column
    assert one["rows"] == 3
    assert one["not_finite"] == []


@pytest.mark.parametrize("name", gallery.names())
def test_fields_of_elements_have_units_that_pint_parses(name, shown) -> None:
    """Source: pint; the fields of the resolved scenario, whose names end in their units."""
    described = shown[name]["model"]["elements"]
    given = {}
    for section in ("forces", "drives", "sensors", "controllers"):
        given |= shown[name]["resolved"].get(section, {})
    assert {element["name"] for element in described} == set(given)
    for element in described:
        ((kind, fields),) = given[element["name"]].items()
        assert element["kind"] == kind.replace("_", " ")
        assert element["enabled"] == fields.get("enabled", True)
        for fact in element["facts"]:
            UNITS.parse_units(fact["unit"])
            # A unit that is still in the name was not known.
            assert not fact["label"].endswith((" m", " N", " s", " rad", " kg", " m2", " Pa")), fact


def test_other_data_sets_have_units_that_pint_parses_and_one_name_for_an_angular_frequency() -> None:
    """Source: pint; omega is in rad/s, a frequency in Hz, in every data set."""
    roll = kingpost.run("paper", {"simulation.duration_s": 0.5})["roll"].sel(body="ship")
    found = [
        kingpost.rao("barge", [0.0], [0.5, 1.0]),
        kingpost.modes("chain"),
        spectrum(roll, segment_s=0.25).to_dataset(),
        to_dataset(read(gallery.folder() / "hydro" / "barge.hydro.json")),
    ]
    for name, variable in ((name, variable) for one in found for name, variable in one.variables.items()):
        if "units" in variable.attrs:
            unit = UNITS.parse_units(variable.attrs["units"])
            assert name != "omega" or unit == UNITS.parse_units("rad/s")
            assert name != "frequency" or unit == UNITS.parse_units("Hz")
    assert ["omega" in one.variables for one in found] == [True, False, True, True]


def test_names_of_the_cf_conventions_have_their_signs_and_dimensions() -> None:
    """Source: the table of standard names, version 93, in degrees and metres; signs by turning a ship that is
    alone: port up, bow down and bow to port are positive."""
    scenario = kingpost.load("barge", {"simulation.duration_s": 0.1})
    found = kingpost.run(scenario)
    assert found.attrs["Conventions"] == "CF-1.11"
    signs = {"roll": "starboard_down", "pitch": "fore_down", "yaw": "fore_port"}
    for name, sign in signs.items():
        assert found[name].attrs["standard_name"] == f"platform_{name}_{sign}"
        UNITS.Quantity(1, found[name].attrs["units"]).to("degree")
    elevation = found["wave_elevation"].attrs
    assert elevation["standard_name"] == "sea_surface_height_above_mean_sea_level"
    assert UNITS.parse_units(elevation["units"]) == UNITS.metre
    said = {name: found[name].attrs["description"] for name in signs}
    assert said["roll"].endswith("positive port side up")
    assert said["pitch"].endswith("positive bow down")
    assert said["yaw"].endswith("positive bow to port")


def test_the_unit_of_an_axis_comes_from_the_engine_and_not_from_its_name(joints) -> None:
    """Source: docs/conventions.md: the x of a planar joint is a length, that of a spherical one an angle."""
    found = kingpost.run(joints)
    units = found["joint_position_unit"].to_series()
    assert set(units.index[units == "m"]) == LENGTHS
    shown = report.summary(found, kingpost.load(joints)).splitlines()
    # The table of positions stands before that of reactions.
    rows = {line.split()[0]: line.split() for line in reversed(shown) if line.split()}
    for name in found["coordinate"].values:
        assert rows[str(name)][3] == ("m" if name in LENGTHS else "deg"), name
        assert rows[str(name)][6] == ("m/s" if name in LENGTHS else "rad/s"), name


def test_the_heave_of_a_ship_that_waves_move_is_a_length(tmp_path) -> None:
    """Source: its surge, sway and heave are along the axes of its heading, its angles about them."""
    lags = [f"{sense.split('_')[0]}_lag_deg" for sense in SENSES]
    amplitudes = [
        f"{sense}_{unit}" for sense, unit in zip(SENSES, ["m_per_m"] * 3 + ["deg_per_m"] * 3, strict=True)
    ]
    rows = [",".join(["direction_to_deg", "frequency_rad_s", *amplitudes, *lags])]
    rows += [
        f"{direction},{frequency}" + 6 * ",0.5" + 6 * ",0"
        for direction in (0, 90, 180, 270)
        for frequency in (0.2, 2)
    ]
    (tmp_path / "ship.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")
    moved = {"moved_by_waves": {"raos": "ship.csv"}}
    ship = {"version": 1, "title": "A moved ship", "sea": {"waves": {}},
            "simulation": {"step_s": 0.05, "duration_s": 0.1},
            "bodies": {"ship": {**BODY, "joint": moved}}, "forces": {"weight": {"gravity": {}}}}  # fmt: skip
    (tmp_path / "moved.yaml").write_text(json.dumps(ship))
    found = kingpost.run(tmp_path / "moved.yaml")
    units = found["joint_position_unit"].to_series()
    assert units[["ship.x", "ship.y", "ship.z"]].tolist() == ["m"] * 3
    assert units[["ship.roll", "ship.pitch", "ship.yaw"]].tolist() == ["rad"] * 3
    assert results.unit_of(found["joint_force"].sel(coordinate="ship.z")) == "N"


def test_statistics_of_a_file_have_the_units_of_the_run(joints, tmp_path, capsys) -> None:
    assert main(["run", str(joints), "-o", str(tmp_path / "run.nc")]) == 0
    capsys.readouterr()
    channels = ["table.x.joint_position", "ball.x.joint_position"]
    assert main(["statistics", str(tmp_path / "run.nc"), "--channels", *channels]) == 0
    text = capsys.readouterr().out
    rows = {line.split()[0]: line.split() for line in text.splitlines() if line.split()}
    assert [rows[channel][1] for channel in channels] == ["m", "deg"]


def test_a_period_of_any_quantity_is_in_seconds(joints) -> None:
    """Source: the definition of a period."""
    found = summary(kingpost.run(joints))
    assert "units" not in found["roll"].attrs
    period, mean = ({"statistic": name} for name in ("zero_up_crossing_period", "mean"))
    assert results.unit_of(found["roll"].sel(body="arm", **period)) == "s"
    assert results.unit_of(found["roll"].sel(body="arm", **mean)) == "rad"
    positions = found["joint_position"]
    assert {results.unit_of(positions.sel(coordinate=at, **period)) for at in ("rail", "arm")} == {"s"}
    assert [results.unit_of(positions.sel(coordinate=at, **mean)) for at in ("rail", "arm")] == ["m", "rad"]


def test_files_keep_the_unit_of_each_column(joints, tmp_path) -> None:
    """Source: the round trip."""
    found = kingpost.run(joints)
    again = xarray.load_dataset(results.write(found, tmp_path / "run.nc"), engine="h5netcdf")
    xarray.testing.assert_identical(again, found)
    schema = pyarrow.parquet.read_schema(results.write(found, tmp_path / "run.parquet"))
    columns = ("rail.joint_position", "arm.joint_force", "rail.joint_force", "arm.joint_reaction.moment_z",
               "arm.joint_reaction.force_z")  # fmt: skip
    assert [schema.field(name).metadata[b"units"] for name in columns] == [b"m", b"N m", b"N", b"N m", b"N"]

"""Files of results: read back, they hold what was recorded."""

from __future__ import annotations

import sys

import kingpost
import numpy as np
import pandas
import pyarrow.parquet
import pytest
import xarray
from kingpost.cli import main
from kingpost.results import events, frame, write
from samples import read_csv

DRAG = "{name: drag, default: 1.0e+6, live: true, writes: [forces.damping.viscous_damping.angular_N_m_s.0]}"


@pytest.fixture(scope="module")
def results():
    """A short run of the paper's case."""
    return kingpost.run("paper", {"simulation.duration_s": 0.05})


def test_netcdf_reads_back_equal_with_its_attributes(results, tmp_path):
    """Source: the round trip."""
    again = xarray.load_dataset(write(results, tmp_path / "run.nc"), engine="h5netcdf")
    xarray.testing.assert_identical(again, results)


def test_csv_reads_back_to_the_same_bits(results, tmp_path):
    """Source: the round trip; column names of the public contract."""
    again = read_csv(write(results, tmp_path / "run.csv"))
    pandas.testing.assert_frame_equal(again, frame(results), check_exact=True)
    expected = {"time", "ship.angular_velocity.x", "slew.joint_position", "arm.roll", "kinetic_energy",
                "ship.orientation.w", "luff.joint_reaction.moment_y", "linear_momentum.z",
                "arm.tip.point_position.z"}  # fmt: skip
    assert expected <= set(again.columns)
    assert np.array_equal(again["tower.velocity.y"], results["velocity"].sel(body="tower", axis="y").values)


def test_parquet_reads_back_to_the_same_bits_with_units(results, tmp_path):
    """Source: the round trip."""
    path = write(results, tmp_path / "run.parquet")
    pandas.testing.assert_frame_equal(pandas.read_parquet(path), frame(results), check_exact=True)
    schema = pyarrow.parquet.read_schema(path)
    assert schema.field("ship.angular_velocity.x").metadata[b"units"] == b"rad/s"
    assert schema.field("time").metadata[b"units"] == b"s"
    assert schema.metadata[b"status"] == b"finished"


@pytest.mark.parametrize("ending", ["nc", "csv", "parquet"])
def test_the_file_of_the_command_equals_the_data_set_in_python(ending, tmp_path, capsys):
    """Source: one engine behind both."""
    output = tmp_path / f"run.{ending}"
    arguments = ["run", "paper", "--set", "simulation.duration_s=0.05", "-o", str(output)]
    assert main(arguments) == 0
    assert str(output) in capsys.readouterr().out
    expected = frame(kingpost.run("paper", {"simulation.duration_s": 0.05}))
    read = {
        "nc": lambda: frame(xarray.load_dataset(output, engine="h5netcdf")),
        "csv": lambda: read_csv(output),
        "parquet": lambda: pandas.read_parquet(output),
    }[ending]
    pandas.testing.assert_frame_equal(read(), expected, check_exact=True)


def test_a_model_without_joints_or_points_writes_every_format(tmp_path):
    """Source: empty dimensions are dimensions."""
    path = tmp_path / "box.yaml"
    path.write_text(
        "version: 1\ntitle: Box\nsimulation: {duration_s: 0.01}\nbodies:\n  box:\n    mass_kg: 1\n"
        "    shape: {box: {length_m: 1, width_m: 1, height_m: 1}}\n    joint: {floating: {}}\n"
    )
    results = kingpost.run(path)
    for ending in ("nc", "csv", "parquet"):
        assert write(results, tmp_path / f"box.{ending}").stat().st_size > 0


def test_every_file_contains_the_table_of_events(tmp_path):
    """Source: the round trip; the value that was set, when it was set."""
    text = kingpost.load("paper").text.replace("parameters:\n", f"parameters:\n  - {DRAG}\n", 1)
    (tmp_path / "live.yaml").write_text(text)
    simulation = kingpost.Simulation(kingpost.load(tmp_path / "live.yaml", {"simulation.duration_s": 0.05}))
    simulation.step(20)
    simulation.set_parameter("drag", 2e6)
    results = simulation.run()
    table = events(results)
    assert [str(what) for what in table["event_element"].values] == ["drag"]
    assert table["event_time"].values == pytest.approx([0.02], abs=1e-12)
    assert table["event_time"].attrs["units"] == "s"
    again = xarray.load_dataset(write(results, tmp_path / "run.nc"), engine="h5netcdf")
    xarray.testing.assert_identical(events(again), table)
    xarray.testing.assert_identical(
        xarray.load_dataset(write(table, tmp_path / "events.nc"), engine="h5netcdf"), table
    )
    write(results, tmp_path / "run.csv")
    beside = pandas.read_csv(tmp_path / "run.events.csv", float_precision="round_trip")
    assert list(beside.columns) == ["event_time", "event_code", "event_element", "event_what"]
    assert beside["event_time"].tolist() == table["event_time"].values.tolist()
    assert beside["event_what"].tolist() == ["was set"]
    assert beside["event_code"].tolist() == ["parameter_set"]


def test_a_run_without_events_has_an_empty_table_and_no_file_of_events(results, tmp_path):
    """Source: the contract; a file of an earlier run must not be taken for this one's."""
    assert events(results).sizes["event"] == 0
    write(results, tmp_path / "run.csv")
    assert not (tmp_path / "run.events.csv").exists()
    heading = "event_time,event_code,event_element,event_what"
    (tmp_path / "run.events.csv").write_text(f"{heading}\n1.0,hits,ball,hit\n")
    write(results, tmp_path / "run.csv")
    assert (tmp_path / "run.events.csv").read_text().splitlines() == [heading]


def test_an_unknown_ending_is_refused(results, tmp_path):
    """Source: the public contract of `write`."""
    with pytest.raises(kingpost.KingpostError, match=r"\.nc, \.csv, \.parquet"):
        write(results, tmp_path / "run.xlsx")


def test_parquet_without_pyarrow_is_refused_before_a_run_and_the_message_names_the_extra(
    tmp_path, capsys, monkeypatch
) -> None:
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    assert main(["run", "paper", "-o", str(tmp_path / "run.parquet")]) == 2
    shown = capsys.readouterr()
    assert 'Parquet needs pyarrow, which is not installed: pip install "kingpost[parquet]"' in shown.err
    assert shown.out == ""
    assert list(tmp_path.iterdir()) == []

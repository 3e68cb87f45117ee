"""A kind of element that only a test of the engine has: its columns reach data sets and files."""

from __future__ import annotations

import json
from pathlib import Path

import kingpost
import numpy as np
import pandas
import pyarrow.parquet
import pytest
import xarray
from kingpost import results
from kingpost.reports import run as report
from samples import read_csv

CHANNELS = Path(__file__).resolve().parents[2] / "crates/kingpost/tests/golden/new_element.channels.json"
"""The engine's table with it; `crates/kingpost/tests/mechanics/new_element.rs` holds the file to it."""
MOMENT = [f"governor.governor_moment.{axis}" for axis in "xyz"]


@pytest.fixture(scope="module")
def channels() -> list[dict]:
    return json.loads(CHANNELS.read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def rows(channels) -> np.ndarray:
    """Three rows in which every number is another."""
    width = sum(channel["len"] for channel in channels)
    return np.arange(3.0 * width).reshape(3, width)


@pytest.fixture(scope="module")
def found(channels, rows) -> xarray.Dataset:
    return results.dataset(kingpost.load("paper"), channels, rows, "finished")


def place(channels, column: str) -> int:
    return [name for channel in channels for name in channel["columns"]].index(column)


def test_variables_of_a_new_element_are_in_the_data_set_with_units_and_labels(channels, rows, found) -> None:
    """Source: the table of channels."""
    rate, moment = found["governor_rate"], found["governor_moment"]
    assert (rate.dims, moment.dims) == (("time", "governor"), ("time", "governor", "axis"))
    assert (rate.attrs["units"], moment.attrs["units"], moment.attrs["frame"]) == ("rad/s", "N m", "body")
    assert found["governor"].values.tolist() == ["governor"]
    assert np.array_equal(rate.sel(governor="governor"), rows[:, place(channels, "governor.governor_rate")])
    for axis, column in zip("xyz", MOMENT, strict=True):
        assert np.array_equal(moment.sel(governor="governor", axis=axis), rows[:, place(channels, column)])


def test_columns_of_a_new_element_are_in_every_file(channels, rows, found, tmp_path) -> None:
    """Source: the names of the table's columns, in its order."""
    names = [name for channel in channels for name in channel["columns"]]
    for ending, read in ((".csv", read_csv), (".parquet", pandas.read_parquet)):
        again = read(results.write(found, tmp_path / f"run{ending}"))
        assert list(again.columns) == names
        assert np.array_equal(again.to_numpy(), rows)
    again = xarray.load_dataset(results.write(found, tmp_path / "run.nc"), engine="h5netcdf")
    xarray.testing.assert_identical(again, found)
    fields = pyarrow.parquet.read_schema(tmp_path / "run.parquet")
    assert [fields.field(name).metadata[b"units"] for name in MOMENT] == [b"N m"] * 3


def test_a_summary_contains_the_numbers_of_a_new_element(found, channels, rows) -> None:
    """Source: the rows; of three numbers in a row none is a single number. A rate stands in degrees."""
    column = np.degrees(rows[:, place(channels, "governor.governor_rate")])
    (line,) = (line for line in report._elements(found) if line.startswith("governor"))
    assert line.split()[-4:-1] == [f"{value:.5g}" for value in (column[-1], column.min(), column.max())]
    assert line.endswith("deg/s")

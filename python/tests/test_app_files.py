"""Comparison of the app's files and numbers with those of the package; the app's tests compare
web/tests/golden with its output."""

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
from kingpost.analysis import statistics

GOLDEN = Path(__file__).resolve().parents[2] / "web" / "tests" / "golden"


@pytest.fixture(scope="module")
def run() -> xarray.Dataset:
    return kingpost.run("paper", {"simulation.duration_s": 0.05})


def test_a_table_of_the_app_equals_that_of_the_package_in_every_character(run, tmp_path):
    written = results.write(run, tmp_path / "paper.csv")
    assert written.read_text() == (GOLDEN / "paper.csv").read_text()


def test_a_parquet_file_of_the_app_has_the_columns_of_the_package_bit_for_bit_and_its_units(run):
    pandas.testing.assert_frame_equal(
        pandas.read_parquet(GOLDEN / "paper.parquet"), results.frame(run), check_exact=True
    )
    about = pyarrow.parquet.read_schema(GOLDEN / "paper.parquet").metadata
    units = {"time": "s", **{name: results.unit_of(series) for name, series in results.columns(run)}}
    assert json.loads(about[b"units"]) == units
    assert about[b"title"].decode() == run.attrs["title"]


def test_statistics_and_spectrum_of_the_app_equal_those_of_the_package():
    stored = json.loads((GOLDEN / "statistics.json").read_text())
    time = np.arange(stored["records"]) * stored["step_s"]
    parts = [a * np.sin(omega * time + phase) for a, omega, phase in stored["sines"]]
    heave = xarray.DataArray(stored["mean"] + sum(parts), {"time": time}, ("time",), "heave")
    found = statistics.summary(heave)
    for name, value in stored["statistics"].items():
        assert float(found.sel(statistic=name)) == pytest.approx(value, rel=1e-12), name
    density = statistics.spectrum(heave, segment_s=stored["segment"] * stored["step_s"])
    np.testing.assert_allclose(density["omega"], stored["omega"], rtol=1e-12)
    np.testing.assert_allclose(density, stored["density"], rtol=1e-9, atol=1e-12)

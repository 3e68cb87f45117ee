"""Attributes, events, warnings and limits of a file of results: those of a run are accepted, others are
refused."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import kingpost
import numpy as np
import pytest
import xarray
from kingpost.results import entries, read, write
from kingpost.results.kept import has_attributes, is_of_a_run

LIMIT = {"name": "heel", "column": "ship.roll", "unit": "deg", "at_least": -5.0, "at_most": None,
         "percentile": 100.0, "held": True, "worst": 1.0, "worst_time_s": 0.5}  # fmt: skip
UNKNOWN = LIMIT | {"name": "lift", "held": None, "worst": None, "worst_time_s": None}
EVENT = {"time_s": 1.5, "element": "winch", "code": "stops", "what": "stops"}
WARNING = {"time_s": 4.0, "code": "large_heel", "name": "ship", "value": 21.0, "bound": 20.0, "unit": "deg",
           "text": "it heeled"}  # fmt: skip
WITHOUT_NUMBER = WARNING | {"code": "parts", "value": None, "bound": None}
OF_A_RUN = {
    "scenario": {"sea": {"ramp_s": 30.0}, "simulation": {"seed": 1}, "parameters": [{"name": "crane_x_m"}]},
    "files": {"gallery:hydro/barge.hydro.json": "978f1a94"},
}
SHORT = {"simulation.duration_s": 0.02}


def stored(tree: dict[str, Any]) -> dict[str, Any]:
    return {name: json.dumps(value) for name, value in tree.items()}


def of_a_run() -> xarray.Dataset:
    """A data set with one row, and entries of each kind."""
    return entries.with_entries(
        xarray.Dataset(coords={"time": [0.0]}, attrs=stored(OF_A_RUN)),
        events=[EVENT],
        warnings=[WARNING, WITHOUT_NUMBER],
        limits=[LIMIT, UNKNOWN],
        model_warnings=["nothing carries the ship"],
    )


def of_two_runs() -> xarray.Dataset:
    return entries.with_entries_of_runs(
        xarray.Dataset(coords={"time": [0.0], "run": [0, 1]}),
        warnings=[[], [WARNING]],
        limits=[[LIMIT, UNKNOWN], [LIMIT | {"at_least": -4.0}]],
        model_warnings=["nothing carries the ship"],
    )


def test_entries_of_runs_and_batches_are_accepted():
    """Source: what the program itself writes."""
    assert is_of_a_run(kingpost.run("paper", SHORT))
    assert is_of_a_run(kingpost.run("container_to_quay", SHORT))
    assert is_of_a_run(kingpost.Batch("paper", {"crane_x_m": [0, 1]}, SHORT).run())
    assert is_of_a_run(of_a_run())
    assert is_of_a_run(of_two_runs())
    assert is_of_a_run(xarray.Dataset())


def test_entries_are_read_as_they_were_written(tmp_path):
    """Source: the round trip, in memory and through NetCDF, of entries and of none."""
    found = of_a_run()
    for again in (found, read(write(found, tmp_path / "run.nc"))):
        assert entries.events_of(again) == [EVENT]
        assert entries.warnings_of(again) == [WARNING, WITHOUT_NUMBER]
        assert entries.limits_of(again) == [LIMIT, UNKNOWN]
        assert entries.model_warnings_of(again) == ["nothing carries the ship"]
    empty = entries.with_entries(xarray.Dataset(coords={"time": [0.0]}))
    again = read(write(empty, tmp_path / "empty.nc"))
    xarray.testing.assert_identical(again, empty)
    assert {**again.sizes} == {"time": 1, "event": 0, "warning": 0, "limit": 0}


def test_entries_of_several_runs_are_those_of_each(tmp_path):
    """Source: the round trip; a limit whose bound differs, and one that only the first run has."""
    found = of_two_runs()
    assert found["limit_at_least"].dims == ("run", "limit")
    assert found["limit_at_most"].dims == ("limit",)
    for again in (found, read(write(found, tmp_path / "runs.nc"))):
        assert entries.warnings_of_runs(again) == [[], [WARNING]]
        assert entries.limits_of_runs(again) == [[LIMIT, UNKNOWN], [LIMIT | {"at_least": -4.0}, UNKNOWN]]
        assert again["warning_run"].values.tolist() == [-1, 1]
        for run, own in enumerate(([], [WARNING])):
            alone = entries.of_run(again, run)
            assert entries.warnings_of(alone) == own
            assert entries.model_warnings_of(alone) == ["nothing carries the ship"]


def test_zarr_keeps_entries_too(tmp_path):
    """Source: the round trip."""
    found = of_a_run()
    # Zarr warns that its format 3 has no final form for texts.
    found.to_zarr(tmp_path / "run.zarr", zarr_format=2, consolidated=False)
    again = xarray.open_zarr(tmp_path / "run.zarr", consolidated=False).load()
    assert entries.as_json(again) == entries.as_json(found)
    assert is_of_a_run(again)


@pytest.mark.parametrize(
    "damage",
    [
        lambda run: run.drop_vars("event_what"),
        lambda run: run.assign(event_time=("event", [np.nan])),
        lambda run: run.assign(event_time=("event", [1])),
        lambda run: run.rename(event="another"),
        lambda run: run.assign(event_what=("event", np.array([b"stops"]))),
        lambda run: run.drop_vars("warning_text"),
        lambda run: run.assign(warning_time=("warning", [np.nan] * 3)),
        lambda run: run.assign(warning_value=("warning", [np.nan, np.inf, np.nan])),
        lambda run: run.assign(limit_at_least=("limit", [np.nan, 1.0])),
        lambda run: run.assign(limit_held=("limit", [2, -1])),
        lambda run: run.assign(limit_held=("limit", [1, 0])),
        lambda run: run.assign(limit_held=("limit", [1.0, 0.0])),
        lambda run: run.assign_coords(run=[0, 1]),
    ],
)
def test_entries_that_no_run_has_are_refused(
    damage: Callable[[xarray.Dataset], xarray.Dataset], tmp_path
) -> None:
    """Source: damaged files; each may lead to a traceback of the command `statistics` or `plot`."""
    found = damage(of_a_run())
    assert not is_of_a_run(found)
    found.to_netcdf(tmp_path / "run.nc", engine="h5netcdf")
    with pytest.raises(kingpost.KingpostError, match="found a damaged file"):
        read(tmp_path / "run.nc")


@pytest.mark.parametrize("run", [-2, 2])
def test_warnings_of_a_run_that_is_not_there_are_refused(run: int) -> None:
    assert not is_of_a_run(of_two_runs().assign(warning_run=("warning", [-1, run])))


@pytest.mark.parametrize(
    "damage",
    [
        lambda tree: tree["scenario"].update(sea={}, operation=[1]),
        lambda tree: tree["scenario"].update(sea={"ramp_s": None}),
        lambda tree: tree["scenario"].update(parameters=[1]),
        lambda tree: tree.update(scenario=[]),
        lambda tree: tree.update(files={"a": 1}),
    ],
)
def test_attributes_that_no_run_has_are_refused(damage: Callable[[dict[str, Any]], object]):
    """Source: found by damaging files; each led to a traceback of the command `statistics` or `plot`."""
    tree = json.loads(json.dumps(OF_A_RUN))
    damage(tree)
    assert has_attributes(stored(OF_A_RUN))
    assert not has_attributes(stored(tree))


def test_attributes_that_are_not_json_are_refused():
    for text in ("{", "[" * 100_000, 7):
        assert not has_attributes({"scenario": text})
    assert not has_attributes({"floating_bodies": 1})


def test_data_sets_of_runs_with_other_events_are_subtracted_and_joined() -> None:
    """Source: what users do with two runs, one of which has an event and warnings more."""
    one = of_a_run().assign(roll=("time", [1.0]))
    other = entries.with_entries(xarray.Dataset({"roll": ("time", [3.0])}, {"time": [0.0]}))
    assert (other - one)["roll"].item() == 2.0
    assert xarray.concat([one, other], "seed", join="outer")["roll"].values.tolist() == [[1.0], [3.0]]

"""Events, warnings and limits of a run in its data set, with the scenario and the names that it also holds.

Events, warnings and limits are coordinates along the dimensions ``event``, ``warning`` and ``limit``, so that
data sets of runs can be subtracted and joined. Only this module writes and reads them; `kept` checks them in
files.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypedDict, cast

import numpy as np

from .entry_tables import BOUNDS, HELD, MODEL, NAMES, OF_RUNS, TABLES, Field

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray


class EventEntry(TypedDict):
    """An event: its time, s, its element, its code, and its name."""

    time_s: float
    element: str
    code: str
    what: str


class WarningEntry(TypedDict):
    """A warning: its time, s, its code, the name of its element, the value that exceeds its bound, in `unit`,
    and its text; value and bound are None if there are none."""

    time_s: float
    code: str
    name: str
    value: float | None
    bound: float | None
    unit: str
    text: str


class LimitEntry(TypedDict):
    """Result of a limit; its numbers are in `unit`, and None if missing."""

    name: str
    column: str
    unit: str
    at_least: float | None
    at_most: float | None
    percentile: float
    held: bool | None
    worst: float | None
    worst_time_s: float | None


def with_entries(
    results: xarray.Dataset,
    *,
    events: Sequence[EventEntry] = (),
    warnings: Sequence[WarningEntry] = (),
    limits: Sequence[LimitEntry] = (),
    model_warnings: Sequence[str] = (),
) -> xarray.Dataset:
    """The data set of a run with its events, warnings and limits as coordinates: arithmetic leaves them out.

    >>> import xarray
    >>> found = with_entries(xarray.Dataset(), model_warnings=["nothing carries the ship"])
    >>> found["warning_code"].values.tolist(), model_warnings_of(found)
    (['model'], ['nothing carries the ship'])
    >>> (found - with_entries(xarray.Dataset())).sizes["warning"]
    0
    """
    every = [*map(_of_model, model_warnings), *map(dict, warnings)]
    return results.assign_coords(
        _variables("event", list(map(dict, events)))
        | _variables("warning", every)
        | _variables("limit", list(map(dict, limits)))
    )


def with_entries_of_runs(
    results: xarray.Dataset,
    *,
    warnings: Sequence[Sequence[WarningEntry]],
    limits: Sequence[Sequence[LimitEntry]],
    model_warnings: Sequence[str] = (),
) -> xarray.Dataset:
    """The data set of a `Batch` with the warnings and limits of its runs as coordinates; the engine does not
    return the events of a batch."""
    every = [{**_of_model(text), "run": -1} for text in model_warnings]
    every += [{**warning, "run": run} for run, own in enumerate(warnings) for warning in own]
    return results.assign_coords(_variables("warning", every, several=True) | _limits_of_runs(limits))


def of_run(batch: xarray.Dataset, run: int) -> xarray.Dataset:
    """The data set of one run of a `Batch`, with its own warnings and limits."""
    alone = batch.isel(run=run)
    if "warning_run" not in alone:
        return alone
    own = np.isin(alone["warning_run"].values, (-1, run))
    return alone.isel(warning=np.flatnonzero(own)).drop_vars("warning_run")


def only(results: xarray.Dataset) -> xarray.Dataset:
    """The events, warnings and limits of a run alone, in memory, with its attributes."""
    others = [name for name in results.variables if name not in NAMES and name not in TABLES]
    return results.drop_vars(others).load()


def with_entries_of(results: xarray.Dataset, other: xarray.Dataset) -> xarray.Dataset:
    """A data set with the events, warnings and limits of another one."""
    held = [name for name in (*TABLES, *NAMES) if name in other.variables]
    return results.assign_coords({name: other.variables[name] for name in held})


def table(results: xarray.Dataset, dim: str) -> xarray.Dataset:
    """The variables along ``event``, ``warning`` or ``limit`` as a data set; of size 0 if there are none."""
    import xarray

    held = {name: results[name].variable for name in TABLES[dim] if name in results}
    empty = _variables(dim, [], several="run" in results.sizes)
    about = {"title": results.attrs.get("title", "")}
    return xarray.Dataset(held or {name: empty[name] for name in TABLES[dim] if name in empty}, attrs=about)


def events_of(results: xarray.Dataset) -> list[EventEntry]:
    """Events of a run, in order of time."""
    return _rows(results, "event")


def warnings_of(results: xarray.Dataset) -> list[WarningEntry]:
    """Warnings from the rows of a run, in order of time; also of a run that was selected from a `Batch`."""
    run = results["run"].item() if "run" in results.coords else -1
    rows = (row for row in _rows(results, "warning") if row["code"] != MODEL)
    return [row for row in rows if row.pop("run", run) == run]


def model_warnings_of(results: xarray.Dataset) -> list[str]:
    """Warnings about the model, from before the run."""
    return [row["text"] for row in _rows(results, "warning") if row["code"] == MODEL]


def limits_of(results: xarray.Dataset) -> list[LimitEntry]:
    """The limits of a run, in the order of its scenario. Those of earlier versions' files are of all rows."""
    rows: list[dict[str, Any]] = _rows(results, "limit")
    return [cast(LimitEntry, {"percentile": 100.0} | row) for row in rows]


def warnings_of_runs(results: xarray.Dataset) -> list[list[WarningEntry]]:
    """Warnings from the rows of each run of a `Batch`."""
    found: list[list[WarningEntry]] = [[] for _ in range(results.sizes["run"])]
    for row in _rows(results, "warning"):
        if row["code"] != MODEL:
            found[row.pop("run")].append(row)
    return found


def limits_of_runs(results: xarray.Dataset) -> list[list[LimitEntry]]:
    """The limits of each run of a `Batch`."""
    held = results[[name for name in TABLES["limit"] if name in results]]
    return [limits_of(held.isel(run=run, missing_dims="ignore")) for run in range(results.sizes["run"])]


def as_json(results: xarray.Dataset) -> str:
    """Events, warnings and limits as JSON text, for the metadata of a Parquet file. Those of a `Batch` have
    the number of the run, -1 for every run.

    >>> import xarray
    >>> as_json(with_entries(xarray.Dataset()))
    '{"events": [], "warnings": [], "limits": []}'
    """
    warnings = [{**row, "time_s": _known(row["time_s"])} for row in _rows(results, "warning")]
    limits: list[Any] = [*limits_of(results)] if "run" not in results.sizes else [
        {"run": run, **limit} for run, own in enumerate(limits_of_runs(results)) for limit in own
    ]  # fmt: skip
    every = {"events": events_of(results), "warnings": warnings, "limits": limits}
    return json.dumps(every, allow_nan=False)


def scenario_of(results: xarray.Dataset) -> dict[str, Any]:
    """The resolved scenario of a run."""
    return _tree(results, "scenario")


def digests_of(results: xarray.Dataset) -> dict[str, str]:
    """Digests of the files that a scenario names."""
    return _tree(results, "files")


def floating_bodies_of(results: xarray.Dataset) -> list[str]:
    """Names of the bodies that float."""
    return str(results.attrs.get("floating_bodies", "")).split()


def sea_attributes(sea: Mapping[str, str]) -> dict[str, str]:
    """Attributes with the axes of a study that set its sea, by quantity.

    >>> sea_attributes({"peak_period": "peak_period_s"})
    {'sea_peak_period': 'peak_period_s'}
    """
    return {f"{SEA}{quantity}": axis for quantity, axis in sea.items()}


def sea_of(results: xarray.Dataset) -> dict[str, str]:
    """Axes of a study that set its sea, by quantity: significant_height, peak_period, direction."""
    named = {str(name): axis for name, axis in results.attrs.items()}
    return {name.removeprefix(SEA): str(axis) for name, axis in named.items() if name.startswith(SEA)}


def axes_of(results: xarray.Dataset) -> list[str]:
    """Names of the axes of a study."""
    return str(results.attrs.get("axes", "")).split()


SEA = "sea_"
"""First letters of the attributes with the axes of a study's sea."""


def _tree(results: xarray.Dataset, name: str) -> dict[str, Any]:
    """Read an attribute of JSON text; an absent or empty one is empty."""
    text = results.attrs.get(name)
    return json.loads(text) if text else {}


def _of_model(text: str) -> dict[str, Any]:
    """A warning about the model as an entry."""
    return {"time_s": None, "code": MODEL, "name": "", "value": None, "bound": None, "unit": "", "text": text}


def _known(value: float) -> float | None:
    return None if np.isnan(value) else value


def _variables(dim: str, rows: Sequence[Mapping[str, Any]], several: bool = False) -> dict[str, Any]:
    """Variables of a table by name, each along `dim`, and the numbers of its entries."""
    fields = {name: field for name, field in TABLES[dim].items() if several or field.key != "run"}
    return {dim: np.arange(len(rows))} | {
        name: (dim, _array(field, [row[field.key] for row in rows]), field.about)
        for name, field in fields.items()
    }


def _array(field: Field, values: Sequence[Any]) -> NDArray[Any]:
    """Values of a field as an array; None is NaN, or -1 for `held`."""
    if field.key == HELD:
        return np.array([-1 if value is None else int(value) for value in values], np.int8)
    return np.array(values, field.kind)


def _limits_of_runs(limits: Sequence[Sequence[LimitEntry]]) -> dict[str, Any]:
    """Variables of the limits of several runs; bounds have the dimension ``run`` only if they differ."""
    first = {limit["name"]: limit for own in reversed(limits) for limit in own}
    names = list(dict.fromkeys(limit["name"] for own in limits for limit in own))
    unknown = {name: {**of, "held": None, "worst": None, "worst_time_s": None} for name, of in first.items()}
    found = _variables("limit", [unknown[name] for name in names])
    each: list[dict[str, Any]] = [unknown | {limit["name"]: limit for limit in own} for own in limits]
    for variable in (*OF_RUNS, *BOUNDS):
        field = TABLES["limit"][variable]
        rows = [_array(field, [own[name][field.key] for name in names]) for own in each]
        values = np.array(rows, found[variable][1].dtype).reshape(len(limits), len(names))
        same = variable in BOUNDS and all(np.array_equal(row, values[0], equal_nan=True) for row in values)
        if not same:
            found[variable] = (("run", "limit"), values, field.about)
    return found


def _rows(results: xarray.Dataset, dim: str) -> list[Any]:
    """Entries of a table as dictionaries; absent variables give no entries."""
    fields = {name: field for name, field in TABLES[dim].items() if name in results}
    columns = [_values(field, results[name].values) for name, field in fields.items()]
    keys = [field.key for field in fields.values()]
    return [dict(zip(keys, row, strict=True)) for row in zip(*columns, strict=True)]


def _values(field: Field, values: NDArray[Any]) -> list[Any]:
    """Values of a field of each entry; a missing one is None."""
    if field.key == HELD:
        return [None if value < 0 else bool(value) for value in values.tolist()]
    if field.optional:
        return [_known(value) for value in values.tolist()]
    return values.tolist()

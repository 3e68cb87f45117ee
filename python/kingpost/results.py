"""Results: recorded rows as a labelled dataset, and the files it is written to."""

from __future__ import annotations

import json
import platform
from collections.abc import Hashable, Iterable, Iterator, Sequence
from importlib.metadata import version
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import output
from .engine import engine

if TYPE_CHECKING:
    import pandas
    import xarray
    from numpy.typing import NDArray

    from .scenario import Scenario

ENDINGS = (".nc", ".csv", ".parquet")
AXES = "world: z up, x forward, y to port; body: at its centre of mass, ship x forward, y to port"


def dataset(
    scenario: Scenario, channels: Iterable[dict[str, Any]], rows: NDArray[np.float64], status: str
) -> xarray.Dataset:
    """Label recorded rows.

    Parameters
    ----------
    scenario
        What was run; stored resolved in the attributes.
    channels
        The channel table: variable, units, names, frame, dimensions and their labels, offset, length.
    rows
        One row per record, shape (records, values); or of many runs, shape (runs, records, values),
        where a run that ended early has NaN.
    status
        ``finished``, or why the run ended.

    Returns
    -------
    xarray.Dataset
        Dimension ``time`` (s), before it ``run`` where there are many, and those of the channels;
        every variable carries ``units``,
        ``long_name``, as short as an axis of a plot wants it, ``description``, ``frame``, ``column``, how its
        flat columns are named, and ``of_elements``, 1 where forces and drives show it. Where its numbers
        differ in their units, as forces and moments do, the coordinate ``<variable>_unit`` has them in the
        place of ``units`` (`unit_of`).
    """
    import xarray

    coordinates: dict[str, Any] = {}
    variables: dict[str, Any] = {}
    for channel in channels:
        start, length = channel["offset"], channel["len"]
        labels = dict(zip(channel["dims"], channel["labels"], strict=True))
        shape = (*rows.shape[:-1], *(len(names) for names in labels.values()))
        values = rows[..., start : start + length].reshape(shape)
        about = {key: channel[key] for key in ("long_name", "description", "frame", "column")}
        about["of_elements"] = int(channel["of_elements"])
        if channel["unit"] is None:
            units = np.array(channel["units"], str).reshape(shape[rows.ndim - 1 :])
            coordinates[unit_coordinate(channel["variable"])] = _where_they_differ(units, channel["dims"])
        else:
            about = {"units": channel["unit"], **about}
        if channel["variable"] == "time":
            longest = values if rows.ndim == 2 else np.nanmax(values, axis=0)
            coordinates["time"] = ("time", longest.ravel(), about)
        else:
            coordinates |= {dim: np.array(names, dtype=str) for dim, names in labels.items()}
            dims = ("time", *labels) if rows.ndim == 2 else ("run", "time", *labels)
            variables[channel["variable"]] = (dims, values, about)
    return xarray.Dataset(variables, coordinates, attributes(scenario, status))


def _where_they_differ(units: NDArray[np.str_], dims: Sequence[str]) -> tuple[list[str], NDArray[np.str_]]:
    """Units without the dimensions along which they are the same."""
    kept = list(dims)
    for axis in reversed(range(units.ndim)):
        if (units == units.take([0], axis)).all():
            units = units.take(0, axis)
            kept.pop(axis)
    return kept, units


def unit_coordinate(variable: Hashable | None) -> str:
    """Name of the coordinate that has the units of a variable's numbers, where they differ.

    >>> unit_coordinate("joint_position")
    'joint_position_unit'
    """
    return "unit" if variable is None else f"{variable}_unit"


def unit_of(column: xarray.DataArray) -> str:
    """The unit of a variable, or of one of its columns where they differ in their units.

    >>> from kingpost import run
    >>> found = run("paper", {"simulation.duration_s": 0.001})
    >>> unit_of(found["velocity"]), unit_of(found["joint_reaction"].sel(joint="slew", component="moment_x"))
    ('m/s', 'N m')
    """
    name = unit_coordinate(column.name)
    return str(column.coords[name].item()) if name in column.coords else str(column.attrs.get("units", ""))


def frame(results: xarray.Dataset) -> pandas.DataFrame:
    """Results as a flat table, one column per number.

    Columns are ``time`` and then such as ``ship.angular_velocity.x``, ``slew.joint_position``,
    ``arm.tip.point_position.z`` or ``kinetic_energy``.
    """
    import pandas

    flat = {name: series.values for name, series in columns(results)}
    return pandas.DataFrame({"time": results["time"].values, **flat})


def columns(
    results: xarray.Dataset, along: Sequence[str] = ("time",)
) -> Iterator[tuple[str, xarray.DataArray]]:
    """The flat columns with their names: each goes along time, and along what else is asked for."""
    for variable in results.data_vars.values():
        dims = [dim for dim in variable.dims if dim not in along]
        for labels in product(*(results[dim].values for dim in dims)):
            at = dict(zip(dims, labels, strict=True))
            yield column_name(variable, at), variable.sel(at)


def column_name(variable: xarray.DataArray, labels: dict[Any, Any]) -> str:
    """Name of a flat column, by the variable's attribute ``column``; labels that it leaves out are last.

    >>> import xarray
    >>> rate = xarray.DataArray(0.0, name="angular_velocity")
    >>> rate.attrs["column"] = "{body}.angular_velocity.{axis}"
    >>> column_name(rate, {"body": "ship", "axis": "x", "run": 3})
    'ship.angular_velocity.x.3'
    """
    pattern = str(variable.attrs.get("column", variable.name))
    left_out = [str(label) for dim, label in labels.items() if f"{{{dim}}}" not in pattern]
    return ".".join([pattern.format_map(labels), *left_out])


def events(results: xarray.Dataset) -> xarray.Dataset:
    """What happened in a run, in order of time: ``event_time`` (s), ``event_element`` and ``event_what``.

    It reads the attribute ``events``, so that a data set that comes back from a NetCDF file has the same.

    >>> from kingpost import run
    >>> events(run("paper", {"simulation.duration_s": 0.001})).sizes["event"]
    0
    """
    import xarray

    rows = json.loads(results.attrs.get("events", "[]"))
    texts = {name: np.array([row[name] for row in rows], dtype=str) for name in ("element", "what")}
    about = {
        "event_time": {"units": "s", "long_name": "time", "description": "when it happened"},
        "event_element": {"long_name": "element", "description": "what watched for it, or the parameter"},
        "event_what": {"long_name": "event", "description": "what happened"},
    }
    values = [np.array([row["time_s"] for row in rows], dtype=float), texts["element"], texts["what"]]
    columns = {name: ("event", value, about[name]) for name, value in zip(about, values, strict=True)}
    return xarray.Dataset(columns, attrs={"title": results.attrs.get("title", "")})


def check_output(path: str | Path) -> Path:
    """Make sure, before a run, that results can be written to `path`."""
    return output.check(path, ENDINGS)


def write(results: xarray.Dataset, path: str | Path) -> Path:
    """Write results by the file's ending: ``.nc`` (NetCDF), ``.csv`` or ``.parquet``.

    A CSV holds the numbers alone; units and attributes are in the other two: in Parquet the unit of a
    column is in the metadata of its field. Where anything happened, its table (`events`) stands beside a
    CSV, as ``<name>.events.csv``; one of an earlier run that is there is written anew in any case.
    """
    path = check_output(path)
    ending = path.suffix.lower()
    if ending == ".nc":
        return output.write_netcdf(results, path)
    if ending == ".csv":
        output.write_csv(frame(results), path)
        happened, beside = events(results), path.with_suffix(".events.csv")
        if happened.sizes["event"] or beside.exists():
            output.write_csv(happened.to_dataframe(), beside)
    else:
        with output.whole(path) as beside:
            _write_parquet(results, beside)
    return path


def _write_parquet(results: xarray.Dataset, path: Path) -> None:
    import pyarrow
    import pyarrow.parquet

    table = pyarrow.Table.from_pandas(frame(results), preserve_index=False)
    units = {"time": unit_of(results["time"]), **{name: unit_of(series) for name, series in columns(results)}}
    fields = [field.with_metadata({"units": units[field.name]}) for field in table.schema]
    attributes = {key: str(value) for key, value in results.attrs.items()}
    metadata = {**(table.schema.metadata or {}), **attributes}
    pyarrow.parquet.write_table(table.cast(pyarrow.schema(fields, metadata)), path)


def floating_bodies(results: xarray.Dataset) -> list[str]:
    """Names of the ships and of whatever floats as they do.

    >>> from kingpost import run
    >>> floating_bodies(run("paper", {"simulation.duration_s": 0.001}))
    ['ship']
    """
    return json.loads(results.attrs.get("floating_bodies", "[]"))


def attributes(scenario: Scenario, status: str) -> dict[str, Any]:
    """What every data set says of the run that it comes from."""
    described, sea = scenario.model, scenario.model["sea"]
    versions = {name: version(name) for name in ("numpy", "xarray")}
    versions |= {"kingpost": engine.__version__, "python": platform.python_version()}
    return {
        "title": scenario.title,
        "status": status,
        "source": scenario.file,
        "scenario": scenario.json,
        "files": json.dumps(scenario.digests),
        "versions": json.dumps(versions),
        "seed": scenario.resolved["simulation"]["seed"],
        "gravity_m_s2": described["gravity_m_s2"],
        "water_density_kg_m3": sea["density_kg_m3"] if sea else 0.0,
        "floating_bodies": json.dumps([body["name"] for body in described["bodies"] if body["floats"]]),
        "model_warnings": json.dumps(described["warnings"]),
        "axes": AXES,
    }

"""Results: recorded rows as a labelled dataset, and the files it is written to."""

from __future__ import annotations

import json
import platform
import re
from collections.abc import Iterable, Sequence
from importlib.metadata import version
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _engine
from .errors import KingpostError

if TYPE_CHECKING:
    import pandas
    import xarray
    from numpy.typing import NDArray

    from .scenario import Scenario

ENDINGS = (".nc", ".csv", ".parquet")
NAMED = ("body", "coordinate", "joint", "loop", "constraint", "cylinder", "hull", "line", "flow", "station",
         "thruster", "point", "drive")  # fmt: skip
"""Dimensions whose label stands before the variable in a flat column name."""
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
        The channel table: variable, unit, frame, dimensions and their labels, offset, length.
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
        ``long_name``, as short as an axis of a plot wants it, ``description`` and ``frame``.
    """
    import xarray

    coordinates: dict[str, Any] = {}
    variables: dict[str, Any] = {}
    for channel in channels:
        start, length = channel["offset"], channel["len"]
        labels = dict(zip(channel["dims"], channel["labels"], strict=True))
        shape = (*rows.shape[:-1], *(len(names) for names in labels.values()))
        values = rows[..., start : start + length].reshape(shape)
        about = {
            "units": channel["unit"],
            "long_name": short_name(channel["long_name"]),
            "description": channel["long_name"],
            "frame": channel["frame"],
        }
        if channel["variable"] == "time":
            longest = values if rows.ndim == 2 else np.nanmax(values, axis=0)
            coordinates["time"] = ("time", longest.ravel(), about)
        else:
            coordinates |= {dim: np.array(names, dtype=str) for dim, names in labels.items()}
            dims = ("time", *labels) if rows.ndim == 2 else ("run", "time", *labels)
            variables[channel["variable"]] = (dims, values, about)
    return xarray.Dataset(variables, coordinates, attributes(scenario, status))


def short_name(description: str) -> str:
    """The first words of a description, for the axes of plots.

    >>> short_name("tension of a line at its first end, or its fairlead")
    'tension of a line'
    >>> short_name("angular velocity: roll, pitch and yaw rate")
    'angular velocity'
    """
    return re.split("[,;:]| at its | where the hull ", description, maxsplit=1)[0]


def frame(results: xarray.Dataset) -> pandas.DataFrame:
    """Results as a flat table, one column per number.

    Columns are ``time`` and then such as ``ship.angular_velocity.x``, ``slew.joint_position``,
    ``arm.tip.point_position.z`` or ``kinetic_energy``.
    """
    import pandas

    columns = {"time": results["time"].values}
    for name, variable in results.data_vars.items():
        dims = [dim for dim in variable.dims if dim != "time"]
        for labels in product(*(results[dim].values for dim in dims)):
            at = dict(zip(dims, labels, strict=True))
            columns[column_name(str(name), at)] = variable.sel(at).values
    return pandas.DataFrame(columns)


def column_name(variable: str, labels: dict[Any, Any]) -> str:
    """Name of a flat column.

    >>> column_name("angular_velocity", {"body": "ship", "axis": "x"})
    'ship.angular_velocity.x'
    >>> column_name("joint_position", {"coordinate": "slew"})
    'slew.joint_position'
    >>> column_name("excitation_force", {"hull": "water", "component": "force_x"})
    'water.excitation_force.force_x'
    """
    before = [str(label) for dim, label in labels.items() if dim in NAMED]
    after = [str(label) for dim, label in labels.items() if dim not in NAMED]
    return ".".join([*before, variable, *after])


def check_output(path: str | Path, endings: Sequence[str] = ENDINGS) -> Path:
    """Make sure, before a run, that results can be written to `path`."""
    path = Path(path)
    if path.suffix.lower() not in endings:
        raise KingpostError(f"{path}: unknown ending, allowed: {', '.join(endings)}")
    existed = path.exists()
    try:
        with path.open("ab"):
            pass
        if not existed:
            path.unlink()
    except OSError as error:
        raise KingpostError(f"{path}: cannot be written: {error.strerror}") from None
    return path


def write(results: xarray.Dataset, path: str | Path) -> Path:
    """Write results by the file's ending: ``.nc`` (NetCDF), ``.csv`` or ``.parquet``.

    A CSV holds the numbers alone; units and attributes are in the other two.
    """
    path = check_output(path)
    ending = path.suffix.lower()
    if ending == ".nc":
        results.to_netcdf(path, engine="h5netcdf")
    elif ending == ".csv":
        frame(results).to_csv(path, index=False)
    else:
        _write_parquet(results, path)
    return path


def _write_parquet(results: xarray.Dataset, path: Path) -> None:
    import pyarrow
    import pyarrow.parquet

    table = pyarrow.Table.from_pandas(frame(results), preserve_index=False)
    fields = []
    for field in table.schema:
        name = next(part for part in field.name.split(".")[::-1] if part in results.variables)
        fields.append(field.with_metadata({"units": results[name].attrs["units"]}))
    attributes = {key: str(value) for key, value in results.attrs.items()}
    metadata = {**(table.schema.metadata or {}), **attributes}
    pyarrow.parquet.write_table(table.cast(pyarrow.schema(fields, metadata)), path)


def attributes(scenario: Scenario, status: str) -> dict[str, Any]:
    """What every data set says of the run that it comes from."""
    resolved = scenario.resolved
    versions = {name: version(name) for name in ("numpy", "xarray")}
    versions |= {"kingpost": _engine.__version__, "python": platform.python_version()}
    return {
        "title": scenario.title,
        "status": status,
        "source": scenario.file,
        "scenario": scenario.json,
        "files": json.dumps(scenario.digests),
        "versions": json.dumps(versions),
        "seed": resolved["simulation"]["seed"],
        "gravity_m_s2": gravity_m_s2(resolved),
        "water_density_kg_m3": water_density_kg_m3(resolved),
        "axes": AXES,
    }


def gravity_m_s2(resolved: dict[str, Any]) -> float:
    """Acceleration of gravity that acts in a resolved scenario, m/s2; 0 where it is off."""
    laws = (force.get("gravity") for force in resolved.get("forces", {}).values())
    return float(sum(law["acceleration_m_s2"] for law in laws if law and law["enabled"]))


def water_density_kg_m3(resolved: dict[str, Any]) -> float:
    """Density of the water in a resolved scenario, kg/m3; 0 where there is no sea."""
    sea = resolved.get("sea")
    return float(sea["density_kg_m3"]) if sea else 0.0

"""Flat columns of a data set: their names, their units, and a table of all."""

from __future__ import annotations

import difflib
from collections.abc import Hashable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase
from itertools import product
from typing import TYPE_CHECKING, Any

from ..errors import KingpostError
from .entries import floating_bodies_of
from .units import IN_ENGINEERING, NAMES, engineering

if TYPE_CHECKING:
    import pandas
    import xarray

OVER_RUNS = ("time", "run")
"""Dimensions that a column keeps, for one or many runs; labels of other dimensions are part of the column's
name."""


def unit_coordinate(variable: Hashable | None) -> str:
    """Name of the coordinate that holds the units of a variable's numbers, if the units differ.

    Parameters
    ----------
    variable
        Name of the variable.

    Returns
    -------
    str
        Name of the coordinate.

    >>> unit_coordinate("joint_position")
    'joint_position_unit'
    """
    return "unit" if variable is None else f"{variable}_unit"


def unit_of(column: xarray.DataArray) -> str:
    """The unit of a variable, or of one of its columns if the units differ.

    Parameters
    ----------
    column
        A variable of a run's data set, or one column of it.

    Returns
    -------
    str
        Unit, SI.

    >>> from kingpost import run
    >>> found = run("paper", {"simulation.duration_s": 0.001})
    >>> unit_of(found["velocity"]), unit_of(found["joint_reaction"].sel(joint="slew", component="moment_x"))
    ('m/s', 'N m')
    """
    name = unit_coordinate(column.name)
    return str(column.coords[name].item()) if name in column.coords else str(column.attrs.get("units", ""))


def frame(results: xarray.Dataset, patterns: Sequence[str] = (), units: str = NAMES) -> pandas.DataFrame:
    """Results as a flat table, one column per number.

    The columns are ``time`` and then, for example, ``ship.angular_velocity.x``, ``slew.joint_position``,
    ``arm.tip.point_position.z`` or ``kinetic_energy``.

    Parameters
    ----------
    results
        A data set of a run.
    patterns
        Columns to take: those whose names match a pattern such as ``ship.*``; default: all.
    units
        ``names``: SI units, not shown in the names; ``si``: each name ends with its SI unit, as in
        ``ship.roll [rad]``; ``engineering``: numbers and names have engineering units, as in ``ship.roll
        [deg]``.

    Returns
    -------
    pandas.DataFrame
        Shape (records, 1 + columns).

    >>> from kingpost import run
    >>> frame(run("paper", {"simulation.duration_s": 0.1})).shape[0]
    11
    """
    import pandas

    flat = {}
    for name, series in [("time", results["time"]), *columns(results)]:
        if name == "time" or not patterns or any(fnmatchcase(name, pattern) for pattern in patterns):
            unit = unit_of(series)
            shown, size = engineering(unit) if units == IN_ENGINEERING else (unit, 1.0)
            heading = name if units == NAMES else f"{name} [{shown}]"
            flat[heading] = series.values if size == 1.0 else series.values / size
    return pandas.DataFrame(flat)


def columns(
    results: xarray.Dataset, along: Sequence[str] = ("time",)
) -> Iterator[tuple[str, xarray.DataArray]]:
    """The flat columns with their names: each keeps ``time`` and the dimensions in `along`.

    Parameters
    ----------
    results
        A data set of a run.
    along
        Further dimensions that a column keeps.

    Yields
    ------
    tuple of str and xarray.DataArray
        Name and values of a column.

    >>> from kingpost import run
    >>> next(columns(run("paper", {"simulation.duration_s": 0.1})))[0]
    'ship.position.x'
    """
    for name, place in places(results, along).items():
        yield name, place.of(results)


@dataclass(frozen=True)
class Place:
    """Position of a flat column in a data set: its variable, and its index in each dimension except time."""

    variable: Hashable
    at: dict[Hashable, int]

    def of(self, results: xarray.Dataset) -> xarray.DataArray:
        """The column."""
        return results[self.variable].isel(self.at)


def places(results: xarray.Dataset, along: Sequence[str] = ("time",)) -> dict[str, Place]:
    """Position of each flat column by name; reads no values."""
    found: dict[str, Place] = {}
    for variable in results.data_vars.values():
        dims = [dim for dim in variable.dims if dim not in along]
        labels = [list(enumerate(results[dim].values)) for dim in dims]
        for entry in product(*labels):
            at = dict(zip(dims, entry, strict=True))
            name = column_name(variable, {dim: label for dim, (_, label) in at.items()})
            found[name] = Place(variable.name, {dim: index for dim, (index, _) in at.items()})
    return found


def nearest(name: str, every: Iterable[str]) -> str:
    """Up to three names similar to `name`, otherwise the first ones, for a message.

    >>> nearest("ship.rol", ["ship.roll", "ship.pitch", "tower.angle"])
    'ship.roll'
    """
    names = list(every)
    return ", ".join(difflib.get_close_matches(name, names, n=3) or names[:3])


def column(
    results: xarray.Dataset, name: str, period_s: tuple[float, float] | None = None
) -> xarray.DataArray:
    """Return a flat column by its name, over a period.

    Parameters
    ----------
    results
        A data set of a run.
    name
        Name of the column, such as ``ship.roll``.
    period_s
        First and last time, s, both included; default: the whole run.

    Returns
    -------
    xarray.DataArray
        Along ``time``, and along ``run`` for a `Batch`, with its ``units``.

    Raises
    ------
    KingpostError
        If there is no such column, or no record in the period.

    >>> from kingpost import run
    >>> found = run("paper", {"simulation.duration_s": 0.5})
    >>> column(found, "ship.roll", (0.2, 0.3)).sizes["time"]
    11
    """
    every = places(results, along=OVER_RUNS)
    if name not in every:
        raise KingpostError(f"column: found {name!r}, allowed: a column, such as {nearest(name, every)}")
    found = every[name].of(results)
    found.attrs["units"] = unit_of(found)
    if period_s is None:
        return found
    first, last = period_s
    kept = found.sel(time=(results["time"] >= first) & (results["time"] <= last))
    if not kept.sizes["time"]:
        times = results["time"].values
        raise KingpostError(
            f"period_s: found {first:g} to {last:g}, allowed: within {times[0]:g} to {times[-1]:g} s"
        )
    return kept


def column_name(variable: xarray.DataArray, labels: dict[Any, Any]) -> str:
    """Name of a flat column from the variable's attribute ``column``; labels that the attribute does not
    contain come last.

    Parameters
    ----------
    variable
        A variable with the attribute ``column``.
    labels
        The labels by dimension.

    Returns
    -------
    str
        The name, as in files and in the app.

    >>> import xarray
    >>> rate = xarray.DataArray(0.0, name="angular_velocity")
    >>> rate.attrs["column"] = "{body}.angular_velocity.{axis}"
    >>> column_name(rate, {"body": "ship", "axis": "x", "run": 3})
    'ship.angular_velocity.x.3'
    """
    pattern = str(variable.attrs.get("column", variable.name))
    left_out = [str(label) for dim, label in labels.items() if f"{{{dim}}}" not in pattern]
    return ".".join([pattern.format_map(labels), *left_out])


def floating_bodies(results: xarray.Dataset) -> list[str]:
    """Names of the bodies that float.

    Parameters
    ----------
    results
        A data set of a run.

    Returns
    -------
    list of str
        The names, in the order of the model.

    >>> from kingpost import run
    >>> floating_bodies(run("paper", {"simulation.duration_s": 0.001}))
    ['ship']
    """
    return floating_bodies_of(results)

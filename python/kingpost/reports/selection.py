"""Selection of columns to show: those that the user names, otherwise the main columns."""

from __future__ import annotations

from collections.abc import Sequence
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

from ..errors import KingpostError
from ..results.columns import OVER_RUNS, Place, floating_bodies, nearest, places, unit_of
from ..results.entries import limits_of
from ..results.line_points import points_dimension

if TYPE_CHECKING:
    import xarray

# Variables of the main columns: those of `OF_SHIPS` for floating bodies only, those of `ALL_OF` completely.
OF_SHIPS = ("position.z", "roll", "pitch", "yaw")
ALL_OF = ("wave_elevation", "joint_position", "line_tension")
HEIGHT = ".point_position.z"
FORCE = "N"


def of_time(results: xarray.Dataset) -> dict[str, Place]:
    """Flat columns with the names of `kingpost run -o FILE.csv`, over time and, for many runs, ``run``."""
    over_time = results[[name for name, values in results.data_vars.items() if "time" in values.dims]]
    return places(over_time, along=OVER_RUNS)


def chosen(results: xarray.Dataset, patterns: Sequence[str], option: str = "--channels") -> dict[str, str]:
    """Names of columns with their units: those that match the patterns, otherwise the main columns.

    Raises
    ------
    KingpostError
        If a pattern matches no column.
    """
    every = of_time(results)
    if patterns:
        names = [name for name in every if any(fnmatchcase(name, pattern) for pattern in patterns)]
    else:
        names = main_ones(results, every)
    for pattern in patterns:
        if not any(fnmatchcase(name, pattern) for name in every):
            allowed = f"columns such as {nearest(pattern, every)}, or a pattern such as 'load.*'"
            raise KingpostError(f"{option}: found {pattern!r}, allowed: {allowed}")
    return {name: unit_of(every[name].of(results)) for name in names}


def main_ones(results: xarray.Dataset, every: dict[str, Place]) -> list[str]:
    """The main columns: those with limits, position and angles of floating bodies, waves, joints, heights of
    named points such as a crane tip, and the forces of lines and other elements."""
    limits = [] if "run" in results.sizes else limits_of(results)
    limited = {limit["column"] for limit in limits}
    of_ships = {f"{body}.{quantity}" for body in floating_bodies(results) for quantity in OF_SHIPS}
    return [
        name
        for name, place in every.items()
        if name in limited
        or name in of_ships
        or name.endswith(HEIGHT)
        or any(variable in name.split(".") for variable in ALL_OF)
        or is_single_force(results[place.variable])
    ]


def is_single_number(variable: xarray.DataArray) -> bool:
    """Whether a variable is a scalar output of forces and drives, not at points along lines."""
    dims = [dim for dim in variable.dims if dim not in ("time", "run")]
    at_points = points_dimension(variable) is not None
    return bool(variable.attrs.get("of_elements")) and len(dims) == 1 and not at_points


def is_single_force(variable: xarray.DataArray) -> bool:
    """Whether a variable is a scalar force of an element, such as the tension of a line."""
    return is_single_number(variable) and variable.attrs.get("units") == FORCE

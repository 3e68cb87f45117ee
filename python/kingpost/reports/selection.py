"""Which columns of a run are shown: those that are asked for, else the main ones."""

from __future__ import annotations

import json
from collections.abc import Sequence
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

from ..errors import KingpostError
from ..results.columns import Place, floating_bodies, places, unit_of

if TYPE_CHECKING:
    import xarray

# Of these where no columns are named; a floating body's place and angles, and all of the others.
OF_SHIPS = ("position.z", "roll", "pitch", "yaw")
ALL_OF = ("wave_elevation", "joint_position", "line_tension")
HEIGHT = ".point_position.z"
FORCE = "N"


def of_time(results: xarray.Dataset) -> dict[str, Place]:
    """The flat columns as `kingpost run -o FILE.csv` names them, over time and, of many runs, ``run``."""
    over_time = results[[name for name, values in results.data_vars.items() if "time" in values.dims]]
    return places(over_time, along=("time", "run"))


def chosen(results: xarray.Dataset, patterns: Sequence[str], option: str = "--channels") -> dict[str, str]:
    """Names of columns with their units: those of the patterns, else those that people look at first.

    Raises
    ------
    KingpostError
        When no column has the name of a pattern.
    """
    every = of_time(results)
    if patterns:
        names = [name for name in every if any(fnmatchcase(name, pattern) for pattern in patterns)]
    else:
        names = main_ones(results, every)
    for pattern in patterns:
        if not any(fnmatchcase(name, pattern) for name in every):
            raise KingpostError(
                f"{option}: found {pattern!r}, allowed: columns as ship.roll, or patterns as ship.*"
            )
    return {name: unit_of(every[name].of(results)) for name in names}


def main_ones(results: xarray.Dataset, every: dict[str, Place]) -> list[str]:
    """Columns that people look at first: those with limits, place and angles of what floats, waves, joints,
    heights of named points such as a crane's tip, and the forces of lines and of whatever shows one."""
    limited = {limit["column"] for limit in json.loads(results.attrs.get("limits", "[]") or "[]")
               if isinstance(limit, dict)}  # fmt: skip
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
    """Whether forces and drives show it, by one number a thing."""
    dims = [dim for dim in variable.dims if dim not in ("time", "run")]
    return bool(variable.attrs.get("of_elements")) and len(dims) == 1


def is_single_force(variable: xarray.DataArray) -> bool:
    """Whether it is a force of a force or a drive by one number a thing, as a line's tension."""
    return is_single_number(variable) and variable.attrs.get("units") == FORCE

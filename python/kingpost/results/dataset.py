"""Recorded rows as a labelled data set."""

from __future__ import annotations

import json
import platform
from collections.abc import Iterable, Sequence
from importlib.metadata import version
from typing import TYPE_CHECKING, Any

import numpy as np

from ..engine import engine
from . import xarrays
from .columns import unit_coordinate
from .kept import DIGEST, digest_of
from .line_points import line_point_coordinates

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

    from ..scenario import Scenario
    from .channels import Channel

CONVENTIONS = "CF-1.11"
STANDARD_NAMES = {
    "roll": "platform_roll_starboard_down",
    "pitch": "platform_pitch_fore_down",
    "yaw": "platform_yaw_fore_port",
    "wave_elevation": "sea_surface_height_above_mean_sea_level",
}
"""Standard names from the table of the CF conventions, version 93; the still water level is their mean sea
level."""
AXES = "world: z up, x forward, y to port; body: at its centre of mass, ship x forward, y to port"


def dataset(
    scenario: Scenario, channels: Iterable[Channel], rows: NDArray[np.float64], status: str
) -> xarray.Dataset:
    """Label recorded rows.

    Parameters
    ----------
    scenario
        The scenario of the run; its resolved form is stored in the attributes.
    channels
        The channel table: variable, units, names, frame, dimensions and their labels, offset, length.
    rows
        One row per record, shape (records, values); for many runs, shape (runs, records, values), with NaN
        after the end of a run that ended early.
    status
        ``finished``, or why the run ended.

    Returns
    -------
    xarray.Dataset
        Dimensions ``run`` (for many runs), ``time`` (s) and those of the channels. Every variable has
        ``units``, ``standard_name`` if the CF conventions have one, ``long_name`` (short, for the axis of a
        plot), ``description``, ``frame``, ``column`` (the pattern of its column names) and ``of_elements`` (1
        for an output of forces and drives). If its numbers differ in their units, as forces and moments do,
        the coordinate ``<variable>_unit`` holds the units, and there is no ``units`` (`unit_of`).
        Points along lines have coordinates with the line and the arc length of each (`line_points`).

    >>> from kingpost import Simulation
    >>> simulation = Simulation("paper")
    >>> found = dataset(simulation.scenario, simulation.channels, simulation.row()[None, :], "finished")
    >>> found["roll"].dims, found["roll"].attrs["units"]
    (('time', 'body'), 'rad')
    """
    xarray = xarrays.load()
    channels = list(channels)
    coordinates: dict[str, Any] = line_point_coordinates(channels, rows)
    variables: dict[str, Any] = {}
    for channel in channels:
        start, length = channel["offset"], channel["len"]
        labels = dict(zip(channel["dims"], channel["labels"], strict=True))
        shape = (*rows.shape[:-1], *(len(names) for names in labels.values()))
        values = rows[..., start : start + length].reshape(shape)
        about: dict[str, object] = {
            key: channel[key] for key in ("long_name", "description", "frame", "column")
        }
        about["of_elements"] = int(channel["of_elements"])
        if standard := STANDARD_NAMES.get(channel["variable"]):
            about["standard_name"] = standard
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
    """Units without the dimensions along which they do not change."""
    kept = list(dims)
    for axis in reversed(range(units.ndim)):
        if (units == units.take([0], axis)).all():
            units = np.asarray(units.take(0, axis))
            kept.pop(axis)
    return kept, units


def attributes(scenario: Scenario, status: str) -> dict[str, Any]:
    """The attributes that describe the run, for every data set.

    Parameters
    ----------
    scenario
        The scenario of the run.
    status
        ``finished``, or why the run ended.

    Returns
    -------
    dict
        Texts and numbers; the scenario, its files and the versions as JSON, names separated by blanks.

    >>> from kingpost import load
    >>> attributes(load("paper"), "finished")["Conventions"]
    'CF-1.11'
    """
    described, sea = scenario.model, scenario.model["sea"]
    versions = {name: version(name) for name in ("numpy", "xarray")}
    versions |= {"kingpost": engine.__version__, "python": platform.python_version()}
    found = {
        "Conventions": CONVENTIONS,
        "title": scenario.title,
        "status": status,
        "source": scenario.file,
        "scenario": scenario.json,
        "files": json.dumps(scenario.digests),
        "versions": json.dumps(versions),
        "seed": scenario.resolved["simulation"]["seed"],
        "gravity_m_s2": described["gravity_m_s2"],
        "water_density_kg_m3": sea["density_kg_m3"] if sea else 0.0,
        "floating_bodies": " ".join(body["name"] for body in described["bodies"] if body["floats"]),
        "axes": AXES,
    }
    return {**found, DIGEST: digest_of(found)}

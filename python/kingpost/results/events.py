"""What happened in a run, as a table."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    import xarray


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

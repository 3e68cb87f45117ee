"""Events and warnings of a run, as tables."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .entries import events_of, model_warnings_of, warnings_of, warnings_of_runs

if TYPE_CHECKING:
    import xarray


def events(results: xarray.Dataset) -> xarray.Dataset:
    """Events of a run, in order of time: ``event_time`` (s), ``event_element`` and ``event_what``.

    The table is read from the attribute ``events``, so that a data set from a NetCDF file gives the same
    table.

    Parameters
    ----------
    results
        A data set of a run.

    Returns
    -------
    xarray.Dataset
        Along ``event``.

    >>> from kingpost import run
    >>> events(run("paper", {"simulation.duration_s": 0.001})).sizes["event"]
    0
    """
    import xarray

    rows = events_of(results.attrs)
    texts = {name: np.array([row[name] for row in rows], dtype=str) for name in ("element", "what")}
    about = {
        "event_time": {"units": "s", "long_name": "time", "description": "time of the event"},
        "event_element": {"long_name": "element", "description": "element that watches for it, or parameter"},
        "event_what": {"long_name": "event", "description": "name of the event"},
    }
    values = [np.array([row["time_s"] for row in rows], dtype=float), texts["element"], texts["what"]]
    columns = {name: ("event", value, about[name]) for name, value in zip(about, values, strict=True)}
    return xarray.Dataset(columns, attrs={"title": results.attrs.get("title", "")})


def warnings(results: xarray.Dataset) -> xarray.Dataset:
    """Warnings of a run: ``warning_time`` (s), ``warning_name`` and ``warning_text``.

    Warnings from before the run come first, without time and name. For a `Batch`, ``warning_run`` is the
    number of the run.

    Parameters
    ----------
    results
        A data set of a run.

    Returns
    -------
    xarray.Dataset
        Along ``warning``.

    >>> from kingpost import run
    >>> warnings(run("paper", {"simulation.duration_s": 0.001})).sizes["warning"]
    0
    """
    import xarray

    rows: list[dict[str, Any]] = [{"text": text} for text in model_warnings_of(results.attrs)]
    if "run" in results.sizes:
        each = enumerate(warnings_of_runs(results.attrs))
        rows += [{**one, "run": run} for run, of_run in each for one in of_run]
    else:
        rows += map(dict, warnings_of(results.attrs))
    columns = {
        "warning_time": ("warning", np.array([row.get("time_s", np.nan) for row in rows], float),
                         {"units": "s", "long_name": "time", "description": "time of the warning"}),
        "warning_name": ("warning", np.array([row.get("name", "") for row in rows], str),
                         {"long_name": "name", "description": "a joint, closed loop, body, force or drive"}),
        "warning_text": ("warning", np.array([row["text"] for row in rows], str),
                         {"long_name": "warning", "description": "text of the warning"}),
    }  # fmt: skip
    if "run" in results.sizes:
        of_runs = np.array([row.get("run", -1) for row in rows], int)
        columns["warning_run"] = ("warning", of_runs, {"long_name": "run", "description": "-1 for every run"})
    return xarray.Dataset(columns, attrs={"title": results.attrs.get("title", "")})

"""Pictures of a crane's load chart with the path of an operation on it: hook load over radius."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import KingpostError
from ..lettering import as_written
from ..results.entries import scenario_of
from ..results.operation_steps import COLUMN, rows_of_step, step_names
from ..results.units import engineering
from .plot import write_figure
from .selection import of_time

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

WIDTH_IN, HEIGHT_IN = 9.0, 4.5
MOST_CHARTS = 6
"""Largest number of cranes in a picture."""


def cranes_with_chart(run: xarray.Dataset) -> dict[str, Mapping[str, Any]]:
    """Load charts of a run's scenario, by the names of their hoists, which the results have too."""
    columns = of_time(run)
    found = {}
    for name, force in (scenario_of(run).get("forces") or {}).items():
        chart = next((fields["load_chart"] for fields in force.values() if fields.get("load_chart")), None)
        if chart and f"{name}.load_radius" in columns and f"{name}.hook_load" in columns:
            found[name] = chart
    return found


def write_load_chart(run: xarray.Dataset, path: str | Path, hoists: Sequence[str] = ()) -> Path:
    """Write a picture of `load_chart_figure`; the file's ending decides the format: ``.png``, ``.svg`` or
    ``.pdf``.

    Raises
    ------
    KingpostError
        If the ending is another, the file cannot be written, or there is no such chart.
    """
    return write_figure(path, lambda: load_chart_figure(run, hoists))


def load_chart_figure(run: xarray.Dataset, hoists: Sequence[str] = ()) -> Figure:
    """Draw the rated load of cranes over the radius, and the path of the hook load of a run on it, with a
    colour for each step of the operation. The largest utilisation is marked with its time.

    Parameters
    ----------
    run
        Data set of one `run`, or of a file that it wrote.
    hoists
        Names of hoists with a load chart; default: all, the first six.

    Raises
    ------
    KingpostError
        If there is no such chart, or the data set has several runs.
    """
    from matplotlib.figure import Figure

    if "run" in run.sizes:
        raise KingpostError(f"--load-chart: found {run.sizes['run']} runs, allowed: one run")
    charts = cranes_with_chart(run)
    for name in hoists or [""][len(charts) :]:
        if name not in charts:
            known = ", ".join(charts) or "a run whose scenario has a load_chart"
            raise KingpostError(f"--load-chart: found {name or 'no chart'}, allowed: {known}")
    names = (list(hoists) or list(charts))[:MOST_CHARTS]
    drawn = Figure(figsize=(WIDTH_IN, HEIGHT_IN * len(names)), layout="constrained")
    for axes, name in zip(drawn.subplots(len(names), 1, squeeze=False)[:, 0], names, strict=True):
        _chart(axes, charts[name])
        _path(axes, run, name)
        axes.set(xlabel="radius, m", ylabel=f"{name}: hook load, {engineering('kg')[0]}")
        axes.set_ylim(bottom=0)
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8, loc="center left", bbox_to_anchor=(1.0, 0.5))
    drawn.suptitle(str(run.attrs.get("title", "")), fontsize=11)
    as_written(drawn)
    return drawn


def _chart(axes: Axes, chart: Mapping[str, Any]) -> None:
    radii_m, rated_t = chart["radii_m"], np.array(chart["rated_loads_kg"]) / engineering("kg")[1]
    axes.plot(radii_m, rated_t, "k-", marker=".", lw=1.5, label="rated load")
    axes.fill_between(radii_m, rated_t, 1.1 * rated_t.max(), color="0.9", lw=0, zorder=0)


def _path(axes: Axes, run: xarray.Dataset, hoist: str) -> None:
    """Path of the hook load, a colour for each step with a circle at its beginning, and the largest
    utilisation."""
    time_s = run["time"].values
    radius_m, load_t = _values(run, hoist, "load_radius"), _tonnes(run, hoist, "hook_load")
    for name, rows in _steps(run):
        # A step's path leads to the first row of the next step.
        along = np.append(rows, min(rows[-1] + 1, len(time_s) - 1))
        (line,) = axes.plot(radius_m[along], load_t[along], lw=1, alpha=0.85, label=name)
        axes.plot(radius_m[rows[0]], load_t[rows[0]], "o", ms=5, color=line.get_color(), mec="black", mew=0.5)
    share = load_t / _tonnes(run, hoist, "rated_load")
    if np.isfinite(share).any():
        at = int(np.nanargmax(share))
        label = f"largest utilisation {share[at]:.2f}, at {time_s[at]:.1f} s"
        axes.plot(radius_m[at], load_t[at], "r*", ms=11, mec="black", mew=0.5, ls="", label=label)


def _tonnes(run: xarray.Dataset, hoist: str, variable: str) -> NDArray[np.float64]:
    return _values(run, hoist, variable) / engineering("kg")[1]


def _steps(run: xarray.Dataset) -> list[tuple[str, NDArray[np.intp]]]:
    """Rows of each step of the operation by its name; all rows without an operation."""
    names, columns = step_names(scenario_of(run)), of_time(run)
    if not names or COLUMN not in columns:
        return [("hook load", np.arange(run.sizes["time"]))]
    number = columns[COLUMN].of(run).values
    found = [(name, rows_of_step(number, k, len(names))) for k, name in enumerate(names)]
    return [(name, rows) for name, rows in found if len(rows)]


def _values(run: xarray.Dataset, hoist: str, variable: str) -> NDArray[np.float64]:
    values: NDArray[np.float64] = of_time(run)[f"{hoist}.{variable}"].of(run).values
    return values

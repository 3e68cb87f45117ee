"""Pictures of range graphs: the tension of lines over their arc length."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ..analysis.range_graphs import lines_with_points, range_graph
from ..errors import KingpostError
from ..lettering import as_written
from ..results.units import engineering
from .plot import PANEL_HEIGHT_IN, WIDTH_IN, write_figure
from .statistics import start_s

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

MOST_PANELS = 12
"""Largest number of lines in a picture."""


def write_range_graph(
    runs: Sequence[xarray.Dataset], path: str | Path, lines: Sequence[str] = (), after_s: float | None = None
) -> Path:
    """Write a picture of `range_graph_figure`; the file's ending decides the format: ``.png``, ``.svg`` or
    ``.pdf``.

    Raises
    ------
    KingpostError
        If the ending is another, the file cannot be written, or there is no such line.
    """
    return write_figure(path, lambda: range_graph_figure(runs, lines, after_s))


def range_graph_figure(
    runs: xarray.Dataset | Sequence[xarray.Dataset], lines: Sequence[str] = (), after_s: float | None = None
) -> Figure:
    """Draw the range graphs of lines, a panel for each: the tension in kN over the arc length in m.

    The band is from the least to the largest tension of all runs, the line in it the mean; the inner band is
    one standard deviation to both sides of it.

    Parameters
    ----------
    runs
        Data sets of `run`, or of files that it wrote.
    lines
        Names of the lines; default: all that have points along them, the first twelve.
    after_s
        Leave out the records before this time, s; default: the ramp of the waves is left out.

    Raises
    ------
    KingpostError
        If there is no such line, or more of them are named than fit.
    """
    from matplotlib.figure import Figure

    runs = [runs] if not isinstance(runs, Sequence) else runs
    every = lines_with_points(runs[0])
    if not every:
        raise KingpostError("--range-graph: found no line with points_along, allowed: a run with such lines")
    if len(lines) > MOST_PANELS:
        raise KingpostError(f"--range-graph: found {len(lines)} lines, allowed: at most {MOST_PANELS}")
    names = list(lines) or every[:MOST_PANELS]
    first_s = start_s(runs[0], after_s)
    drawn = Figure(figsize=(WIDTH_IN, PANEL_HEIGHT_IN * len(names) + 0.8), layout="constrained")
    panels = drawn.subplots(len(names), 1, squeeze=False)[:, 0]
    for axes, name in zip(panels, names, strict=True):
        _draw_range(axes, [range_graph(run, name, first_s) for run in runs], name)
    panels[0].legend(fontsize=8, loc="center left", bbox_to_anchor=(1.0, 0.5))
    panels[-1].set_xlabel("unstretched length from the first end, m")
    drawn.suptitle(str(runs[0].attrs.get("title", "")), fontsize=11)
    as_written(drawn)
    return drawn


def _draw_range(axes: Axes, graphs: Sequence[xarray.Dataset], name: str) -> None:
    """One line: least, mean and largest of all runs."""
    unit, size = engineering("N")
    alone = [one for graph in graphs for one in _each_run(graph)]
    x = np.mean([one["arc_length"].values for one in alone], axis=0)
    least = np.nanmin([one["least"].values for one in alone], axis=0) / size
    largest = np.nanmax([one["largest"].values for one in alone], axis=0) / size
    mean = np.nanmean([one["mean"].values for one in alone], axis=0) / size
    deviation = np.nanmean([one["standard_deviation"].values for one in alone], axis=0) / size
    axes.fill_between(x, least, largest, color="C0", alpha=0.2, lw=0, label="least to largest")
    axes.fill_between(
        x, mean - deviation, mean + deviation, color="C0", alpha=0.35, lw=0, label="standard deviation"
    )
    axes.plot(x, mean, "C0", lw=1.2, label="mean")
    axes.plot(x, least, "C0", lw=0.8, ls="--")
    axes.plot(x, largest, "C0", lw=0.8, ls="--")
    axes.set_ylabel(f"{name}, {unit}")
    axes.margins(x=0)
    axes.set_ylim(bottom=0)
    axes.grid(alpha=0.3)


def _each_run(graph: xarray.Dataset) -> list[xarray.Dataset]:
    several = "run" in graph.sizes
    return [graph.isel(run=k) for k in range(graph.sizes["run"])] if several else [graph]

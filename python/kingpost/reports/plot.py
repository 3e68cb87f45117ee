"""Pictures of recorded runs: columns over time, with the scenario's limits and the steps of its operation."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .. import output
from ..analysis import pooling
from ..errors import KingpostError
from ..lettering import as_written
from ..results.columns import unit_of
from ..results.entries import LimitEntry, events_of, limits_of, limits_of_runs
from ..results.units import engineering
from ..simulation.records import STEP_BEGINS
from .selection import chosen, of_time

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

ENDINGS = (".png", ".svg", ".pdf")
WIDTH_IN, PANEL_HEIGHT_IN = 11.0, 2.3
MOST_LINES = 8
"""Largest number of lines in one panel: more cannot be distinguished."""


def write(
    runs: xarray.Dataset | Sequence[xarray.Dataset], path: str | Path, patterns: Sequence[str] = ()
) -> Path:
    """Write a picture of runs; the file's ending decides the format: ``.png``, ``.svg`` or ``.pdf``.

    Raises
    ------
    KingpostError
        If the ending is another, the file cannot be written, or `figure` refuses the columns.

    >>> import tempfile, kingpost
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     write(kingpost.run("paper", {"simulation.duration_s": 0.1}), f"{folder}/paper.png").name
    'paper.png'
    """
    return write_figure(path, lambda: figure(runs, patterns))


def write_figure(path: str | Path, draw: Callable[[], Figure]) -> Path:
    """Write a figure as a picture, and return its path; an ending that is not allowed is refused before it is
    drawn."""
    path = output.check(path, ENDINGS)
    with output.whole(path) as beside:
        draw().savefig(beside, dpi=120)
    return path


def figure(runs: xarray.Dataset | Sequence[xarray.Dataset], patterns: Sequence[str] = ()) -> Figure:
    """Draw columns over time: a panel for each unit, angles in deg, forces in kN.

    Limits are dashed lines in the colour of their column, steps of the operation dotted lines with their
    names. Several runs share the colours; limits and steps are those of the first run.

    Parameters
    ----------
    runs
        Data sets of `run`, or of files that it wrote.
    patterns
        Columns, such as ``hull.roll`` or ``*.rope_tension``; default: the columns with a limit and the main
        columns, the first eight of each unit.

    Raises
    ------
    KingpostError
        If a pattern matches no column, there is nothing to show, or too many columns have one unit.

    >>> import kingpost
    >>> found = figure(kingpost.run("paper", {"simulation.duration_s": 0.1}), ["ship.roll"])
    >>> [axes.get_ylabel() for axes in found.axes]
    ['deg']
    """
    from matplotlib.figure import Figure

    runs = [runs] if not isinstance(runs, Sequence) else runs
    limits = _limits(runs[0])
    panels = _panels(runs[0], patterns, limits)
    drawn = Figure(figsize=(WIDTH_IN, PANEL_HEIGHT_IN * len(panels) + 0.8), layout="constrained")
    every = drawn.subplots(len(panels), 1, sharex=True, squeeze=False)[:, 0]
    for axes, (unit, names) in zip(every, panels.items(), strict=True):
        for k, name in enumerate(names):
            _draw(axes, runs, name, f"C{k}")
            _draw_limit(axes, limits.get(name), unit, f"C{k}")
        axes.set_ylabel("-" if unit == "1" else unit)
        axes.margins(x=0)
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8, loc="center left", bbox_to_anchor=(1.0, 0.5))
    _draw_steps(list(every), runs[0])
    every[-1].set_xlabel("time, s")
    drawn.suptitle(str(runs[0].attrs.get("title", "")), fontsize=11)
    as_written(drawn)
    return drawn


def check(run: xarray.Dataset, patterns: Sequence[str]) -> None:
    """Refuse columns that cannot be drawn together."""
    _panels(run, patterns, {})


def _limits(run: xarray.Dataset) -> dict[str, LimitEntry]:
    """The scenario's limits by their columns."""
    limits = next(iter(limits_of_runs(run)), []) if "run" in run.sizes else limits_of(run)
    return {limit["column"]: limit for limit in limits}


def _panels(
    run: xarray.Dataset, patterns: Sequence[str], limits: dict[str, LimitEntry]
) -> dict[str, list[str]]:
    """Columns grouped by the displayed unit."""
    # Without patterns the main columns are chosen.
    limited = chosen(run, [*limits]) if limits and not patterns else {}
    names = limited | chosen(run, patterns)
    panels: dict[str, list[str]] = {}
    for name, unit in names.items():
        panels.setdefault(engineering(unit)[0], []).append(name)
    if not panels:
        raise KingpostError(
            "--channels: found no column to show, allowed: columns such as ship.roll, or ship.*"
        )
    for unit, found in panels.items():
        if len(found) > MOST_LINES and patterns:
            of = f"{len(found)} columns in {unit or '1'}"
            raise KingpostError(f"--channels: found {of}, allowed: at most {MOST_LINES} of a unit")
    return {unit: found[:MOST_LINES] for unit, found in panels.items()}


def _draw(axes: Axes, runs: Sequence[xarray.Dataset], name: str, colour: str) -> None:
    for run in runs:
        for series in _series(run, name):
            factor = engineering(unit_of(series))[1]
            label = name if run is runs[0] else None
            # A damaged file can hold a value near the largest float, which overflows in the shown unit.
            with np.errstate(over="ignore"):
                values = series.values / factor
            axes.plot(run["time"], values, colour, lw=1, alpha=0.7, label=label)


def _series(run: xarray.Dataset, name: str) -> Iterator[xarray.DataArray]:
    """A column of each run of a data set; an empty list if the data set does not have the column."""
    place = of_time(run).get(name)
    if place is None:
        raise KingpostError(f"{pooling.file_of(run)}: found no column {name}, allowed: runs of one scenario")
    series = place.of(run)
    yield from [series] if "run" not in series.dims else (series.isel(run=k) for k in range(run.sizes["run"]))


def _draw_limit(axes: Axes, limit: LimitEntry | None, unit: str, colour: str) -> None:
    """The bounds of a column, if they are in the panel's unit or in its SI unit."""
    if limit is None:
        return
    shown, factor = (unit, 1.0) if limit["unit"] == unit else engineering(limit["unit"])
    for bound in (limit["at_least"], limit["at_most"]):
        if bound is not None and shown == unit:
            axes.axhline(bound / factor, color=colour, ls="--", lw=0.8)


def _draw_steps(every: Sequence[Axes], run: xarray.Dataset) -> None:
    for event in events_of(run):
        if event["element"] != "operation":
            continue
        for axes in every:
            axes.axvline(event["time_s"], color="0.5", ls=":", lw=0.8)
        if event["code"] != STEP_BEGINS:
            continue
        words = event["what"].removeprefix("begins ").strip('"')
        every[0].annotate(words, (event["time_s"], 1.0), (2, 2), xycoords=("data", "axes fraction"),
                          textcoords="offset points", fontsize=7, rotation=20)  # fmt: skip

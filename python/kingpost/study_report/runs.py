"""Report on the runs of a study: results of limits, and the worst run of each limit as a plot with a link."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING

import numpy as np

from .. import link
from ..analysis.range_graphs import lines_with_points
from ..errors import KingpostError
from ..reports import plot
from ..reports.load_chart import cranes_with_chart, load_chart_figure
from ..reports.range_graph import range_graph_figure
from ..reports.tables import of_the_time, unit_cell
from ..results.units import engineering
from ..simulation.outcomes import NUMBER
from ..simulation.simulate import run
from ..study.design.job import WarningCount
from ..study.limiting.largest import percentiles
from ..study.reduce import FINISHED, HELD, UNKNOWN
from ..study.summary import EndedRun, ResultSummary
from .blocks import Block, Command, Heading, Link, Paragraph, Picture, Section, Table
from .cases import STORE, bounds_text, case_text, run_text

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

    from ..scenario import Scenario

MOST_WORST = 6
"""Largest number of worst runs that are drawn: those of the limits with the least margin."""


@dataclass(frozen=True)
class Worst:
    """The run in which a limit has its least margin."""

    limit: str
    column: str
    run: int
    value: float
    unit: str
    time_s: float
    margin: float


def worst_runs(runs: xarray.Dataset) -> list[Worst]:
    """Find the worst run of each limit, the least margin first; a margin is a share of the bound."""
    found = []
    for name in runs["limit"].values if "limit" in runs.sizes else ():
        of = runs.sel(limit=name)
        values = of["limit_worst"].values
        least, most = (float(of[key]) for key in ("at_least", "at_most"))
        margins = _margins(values, least, most)
        if np.isfinite(margins).any():
            at = int(np.nanargmin(margins))
            scale = max(abs(bound) for bound in (least, most) if np.isfinite(bound)) or 1.0
            found.append(
                Worst(str(name), str(of["limit_column"].item()), at, float(values[at]),
                      str(of["limit_unit"].item()), float(of["limit_time"].values[at]),
                      float(margins[at]) / scale)
            )  # fmt: skip
    return sorted(found, key=lambda one: one.margin)


def _margins(values: NDArray[np.float64], least: float, most: float) -> NDArray[np.float64]:
    """Margins of values to their bounds; negative outside, NaN without a value."""
    lower = least if np.isfinite(least) else -inf
    upper = most if np.isfinite(most) else inf
    return np.minimum(values - lower, upper - values)


def limits_table(runs: xarray.Dataset, axes: Sequence[str]) -> Table:
    """Table of the limits: allowed range, number of runs in which the limit held, worst value and its run."""
    rows = []
    worst = {one.limit: one for one in worst_runs(runs)}
    for name in runs["limit"].values:
        of = runs.sel(limit=name)
        judged = of["limit_held"].values != UNKNOWN
        held = int((of["limit_held"].values == HELD).sum())
        one = worst.get(str(name))
        where = "-" if one is None else run_text(runs, one.run, axes, one.time_s)
        value = "-" if one is None else f"{one.value:.4g}"
        allowed = bounds_text(float(of["at_least"]), float(of["at_most"]), str(of["limit_unit"].item()))
        allowed += of_the_time(percentiles(of).item())
        column = str(of["limit_column"].item())
        rows.append((str(name), column, allowed, f"{held} of {int(judged.sum())}", value, where))
    head = ("limit", "column", "allowed", "held in runs", "worst", "in")
    origin = f"File: {STORE}, variables limit_held, limit_worst, limit_time. Values are in the limit's unit."
    return Table("Limits over all runs", head, rows, origin, (3, 4))


def status_blocks(runs: xarray.Dataset, ends: Sequence[EndedRun], axes: Sequence[str]) -> list[Block]:
    """Number of finished runs, and the reasons why others did not finish."""
    status = runs["status"].values
    blocks: list[Block] = [Paragraph(f"{int((status == FINISHED).sum())} of {status.size} runs finished.")]
    if len(ends):
        alike = np.array([NUMBER.sub("#", one["text"]) for one in ends])
        texts, first, counts = np.unique(alike, return_index=True, return_counts=True)
        where = (run_text(runs, ends[at]["run"], axes) for at in first)
        rows = [(text, str(count), run) for text, count, run in zip(texts, counts, where, strict=True)]
        origin = "Files: units/*.json, field ends. These runs have no statistics."
        blocks.append(Table("Runs that did not finish", ("why", "runs", "first"), rows, origin, (1,)))
    return blocks


def warnings_table(
    runs: xarray.Dataset, warnings: Sequence[WarningCount], axes: Sequence[str]
) -> list[Block]:
    """Table of the engine's warnings, each kind once."""
    rows = []
    for one in warnings:
        where = run_text(runs, one["first_run"], axes)
        rows.append((f"{one['name']}: {one['text']}", f"{one['runs']} of {runs.sizes['run']}", where))
    origin = "Files: units/*.json, field warnings. Texts that differ in their numbers alone count as one."
    head = ("first text", "runs", "first")
    return [Table("Warnings of the runs", head, rows, origin, (1,))] if rows else []


def section(
    runs: xarray.Dataset,
    axes: Sequence[str],
    came_of: ResultSummary,
    scenario_of: Callable[[int], Scenario],
    app: str,
) -> Section:
    """Section with the results of the limits and the worst runs.

    Parameters
    ----------
    runs
        The results of the study.
    axes
        Names of its axes.
    came_of
        The numbers of `kingpost.study.summary.of_results`.
    scenario_of
        The scenario of a run by its number.
    app
        The address of an app, for the links.
    """
    blocks = status_blocks(runs, came_of["ends"], axes)
    blocks += [limits_table(runs, axes)] if "limit" in runs.sizes else []
    blocks += warnings_table(runs, came_of["warnings"], axes)
    drawn: set[int] = set()
    worst = worst_runs(runs)[:MOST_WORST]
    charted = next((one for one in worst if one.column.endswith(".load_utilisation")), *worst[:1])
    for one in worst:
        scenario = scenario_of(one.run)
        recorded = run(scenario)
        blocks += _worst(one, case_text(runs, one.run, axes), recorded, scenario, app)
        if one.run not in drawn:
            blocks += range_graphs(one.run, recorded)
            blocks += load_charts(one.run, recorded) if one.run == charted.run else []
            drawn.add(one.run)
    return Section("runs", "Limits and the worst runs", blocks)


def range_graphs(number: int, recorded: xarray.Dataset) -> list[Block]:
    """Picture of the tension along the lines of a run; none if it has no lines with points along them."""
    if not lines_with_points(recorded):
        return []
    return [
        Picture.of(
            range_graph_figure(recorded),
            f"Tension over the arc length of lines in run {number}",
            f"Range graphs of the lines in run {number}: least, mean and largest tension.",
            f"Command: {_again(number)}, then kingpost plot run_{number}.nc --range-graph -o lines.svg.",
        )
    ]


def load_charts(number: int, recorded: xarray.Dataset) -> list[Block]:
    """Picture of the path of a run on the load charts of its cranes; none without a chart."""
    if not cranes_with_chart(recorded):
        return []
    return [
        Picture.of(
            load_chart_figure(recorded),
            f"Hook load over radius on the load chart in run {number}",
            f"Load chart, rated load over radius, with the hook load of run {number}; circles begin steps.",
            f"Command: {_again(number)}, then kingpost plot run_{number}.nc --load-chart -o chart.svg.",
        )
    ]


def _again(number: int) -> str:
    """The command that repeats a run."""
    return f"kingpost study study.yaml -o DIR --repeat {number}"


def _worst(one: Worst, case: str, recorded: xarray.Dataset, scenario: Scenario, app: str) -> Iterator[Block]:
    """Draw a worst run, with its command and its link to the app."""
    of_unit = f" {unit_cell(one.unit)}".rstrip()
    again = _again(one.run)
    yield Heading(f"Worst for {one.limit}: {one.value:.4g}{of_unit} at {one.time_s:.1f} s")
    yield Paragraph(f"Run {one.run}: {case}.")
    found = recorded.kingpost[one.column]
    unit, size = engineering(str(found.attrs.get("units", "")))
    extremes = f"from {float(found.min()) / size:.4g} to {float(found.max()) / size:.4g} {unit}"
    yield Picture.of(
        plot.figure(recorded, [one.column]),
        f"{one.column} over time in run {one.run}",
        f"{one.column}, {extremes}; dashed: the limit.",
        f"Command: {again}, which writes run_{one.run}.nc.",
    )
    try:
        yield Link("Open this run in the app", f"{app}{link.fragment(scenario)}")
    except KingpostError as error:
        yield Paragraph(f"No link to the app: {error}.")
    yield Command(again)

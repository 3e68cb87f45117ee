"""A run's rows, reduced to numbers of fixed size: statistics of columns, limits, peaks, cycles.

Plain NumPy over flat columns, many at a time; sums have one order, so that a run has the same bits on any
machine.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..analysis.extremes import peaks
from ..analysis.fatigue import rainflow
from ..analysis.statistics import up_crossing_period
from .steps import EXTREMES, Bounds, reduce_steps

STATISTICS = ("mean", "standard_deviation", "zero_up_crossing_period", "maximum", "minimum",
              "time_of_maximum", "time_of_minimum")  # fmt: skip
NOT_RUN, FINISHED, ENDED_EARLY, NOT_BUILT = -1, 0, 1, 2
STATUS = {NOT_RUN: "not_run", FINISHED: "finished", ENDED_EARLY: "ended_early", NOT_BUILT: "not_built"}
UNKNOWN, EXCEEDED, HELD = -1, 0, 1
HELD_MEANINGS = {UNKNOWN: "unknown", EXCEEDED: "exceeded", HELD: "held"}


@dataclass(frozen=True)
class Kept:
    """Quantities that are kept of each run.

    Attributes
    ----------
    columns
        Names of the columns that have statistics.
    limits
        Names of the limits.
    after_s
        Start of a run that statistics leave out, s.
    peaks, keep
        Which of `columns` have peaks, by their place in it, and how many.
    cycles, slopes
        Which of `columns` have cycles counted, and the powers of their ranges that are summed.
    steps
        Names of the steps of the operation, which have times and extremes each.
    bounds
        Bounds of the limits.
    """

    columns: tuple[str, ...]
    limits: tuple[str, ...]
    after_s: float = 0.0
    peaks: tuple[int, ...] = ()
    keep: int = 0
    cycles: tuple[int, ...] = ()
    slopes: tuple[float, ...] = ()
    steps: tuple[str, ...] = ()
    bounds: tuple[Bounds, ...] = ()


@dataclass(frozen=True)
class Variable:
    """A variable of the results: its dimensions behind ``run``, their sizes, its type and what stands where
    there is no number."""

    dims: tuple[str, ...]
    shape: tuple[int, ...]
    dtype: str
    fill: float
    long_name: str


def variables(kept: Kept) -> dict[str, Variable]:
    """The variables of a study's results, by name.

    >>> list(variables(Kept(("ship.roll",), ())))
    ['status', 'statistics']
    """
    columns, limits = len(kept.columns), len(kept.limits)
    nan, by_limit = float("nan"), (("limit",), (limits,))
    found = {
        "status": Variable((), (), "i1", NOT_RUN, "how the run ended"),
        "statistics": Variable(
            ("column", "statistic"), (columns, len(STATISTICS)), "f8", nan, "statistics of columns"
        ),
    }
    if limits:
        found["limit_held"] = Variable(*by_limit, "i1", UNKNOWN, "whether the limit held")
        found["limit_worst"] = Variable(
            *by_limit, "f8", nan, "value nearest to a bound or farthest beyond one"
        )
        found["limit_time"] = Variable(*by_limit, "f8", nan, "time of the worst value, s")
    if kept.peaks:
        shape = (columns, kept.keep)
        found["peaks"] = Variable(("column", "peak"), shape, "f8", nan, "largest independent peaks")
        found["peak_count"] = Variable(("column",), (columns,), "i4", -1, "independent peaks in the run")
    if kept.cycles:
        shape = (columns, len(kept.slopes))
        found["damage"] = Variable(("column", "slope"), shape, "f8", nan, "sum of ranges to the slope")
        found["cycles"] = Variable(("column",), (columns,), "f8", nan, "cycles counted by rainflow")
    return found | _of_steps(kept)


def _of_steps(kept: Kept) -> dict[str, Variable]:
    """The variables of the steps of an operation; none without one."""
    steps, nan = len(kept.steps), float("nan")
    if not steps:
        return {}
    shape, dims = (steps, len(kept.columns), len(EXTREMES)), ("step", "column", "extreme")
    found = {
        "step_begin": Variable(("step",), (steps,), "f8", nan, "time at which a step begins, s"),
        "step_end": Variable(("step",), (steps,), "f8", nan, "time at which a step ends, s"),
        "step_extremes": Variable(dims, shape, "f8", nan, "extremes of columns in a step"),
    }
    if kept.limits:
        by_limit = (("step", "limit"), (steps, len(kept.limits)))
        found["step_limit_worst"] = Variable(
            *by_limit, "f8", nan, "value in a step nearest to a bound or farthest beyond one"
        )
        found["step_limit_time"] = Variable(*by_limit, "f8", nan, "time of this value, s")
    return found


def empty(kept: Kept, runs: int) -> dict[str, NDArray[Any]]:
    """Arrays of so many runs, none of which has run."""
    return {name: np.full((runs, *one.shape), one.fill, one.dtype) for name, one in variables(kept).items()}


def reduce(
    into: Mapping[str, NDArray[Any]],
    run: int,
    rows: NDArray[np.float64],
    places: Sequence[int],
    limits: Sequence[Mapping[str, Any]],
    finished: bool,
    kept: Kept,
    step_place: int | None = None,
) -> None:
    """Write the numbers of a run at its place.

    A run that ended early has NaN for its numbers; of a limit that was exceeded before, that is kept.

    Parameters
    ----------
    into
        Arrays along runs, of `empty`.
    run
        The place along them.
    rows
        The recorded rows, shape (records, values), time first.
    places
        Where each of the columns is in a row.
    limits
        How the engine's limits held.
    finished
        Whether the run went to its end.
    kept
        What is kept of the run.
    step_place
        Where the number of the operation's step is in a row; None without an operation.
    """
    into["status"][run] = FINISHED if finished else ENDED_EARLY
    _limits(into, run, limits, finished, kept)
    if not finished:
        return
    time_s = rows[:, 0]
    if kept.steps and step_place is not None:
        every = (time_s, rows[:, step_place], rows[:, list(places)].T)
        reduce_steps(into, run, every, kept.after_s, kept.bounds)
    first = int(np.searchsorted(time_s, kept.after_s))
    if len(time_s) - first < 2:
        return
    time_s = np.ascontiguousarray(time_s[first:])
    x = np.ascontiguousarray(rows[first:, list(places)].T)
    into["statistics"][run] = statistics(x, time_s)
    for column in kept.peaks:
        found = peaks(x[column])
        into["peak_count"][run, column] = len(found)
        largest = np.sort(found)[::-1][: kept.keep]
        into["peaks"][run, column, : len(largest)] = largest
    for column in kept.cycles:
        if np.isfinite(x[column]).all():
            cycles = rainflow(x[column])
            into["cycles"][run, column] = cycles.count
            into["damage"][run, column] = [cycles.damage(slope) for slope in kept.slopes]


def _limits(
    into: Mapping[str, NDArray[Any]],
    run: int,
    limits: Sequence[Mapping[str, Any]],
    finished: bool,
    kept: Kept,
) -> None:
    by_name = {limit["name"]: limit for limit in limits}
    for k, name in enumerate(kept.limits):
        limit = by_name.get(name)
        if limit is None or limit["held"] is None:
            continue
        if not limit["held"]:
            into["limit_held"][run, k] = EXCEEDED
        elif finished:
            into["limit_held"][run, k] = HELD
        if finished:
            worst = limit["worst"]
            into["limit_worst"][run, k] = np.nan if worst is None else worst
            into["limit_time"][run, k] = limit["worst_time_s"]


def statistics(x: NDArray[np.float64], time_s: NDArray[np.float64]) -> NDArray[np.float64]:
    """Statistics of many columns, as `kingpost.statistics.summary` has them, with the times of the extremes.

    Parameters
    ----------
    x
        Shape (columns, records).
    time_s
        Times of the records, s.

    Returns
    -------
    numpy.ndarray
        Shape (columns, statistics), in the order of `STATISTICS`.

    >>> time_s = np.arange(0.0, 80.0, 0.1)
    >>> statistics(np.sin(2 * np.pi * time_s / 8)[None, :], time_s)[0, 1:4].round(3).tolist()
    [0.707, 8.0, 1.0]
    """
    mean = x.mean(axis=1)
    most, least = x.argmax(axis=1), x.argmin(axis=1)
    columns = np.arange(len(x))
    parts = (
        mean,
        x.std(axis=1),
        up_crossing_period(x - mean[:, None], time_s),
        x[columns, most],
        x[columns, least],
        time_s[most],
        time_s[least],
    )
    return np.stack(parts, axis=1)

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

STATISTICS = ("mean", "standard_deviation", "zero_up_crossing_period", "maximum", "minimum",
              "time_of_maximum", "time_of_minimum")  # fmt: skip
NOT_RUN, FINISHED, ENDED_EARLY, NOT_BUILT = -1, 0, 1, 2
STATUS = {NOT_RUN: "not_run", FINISHED: "finished", ENDED_EARLY: "ended_early", NOT_BUILT: "not_built"}
UNKNOWN, EXCEEDED, HELD = -1, 0, 1
HELD_MEANINGS = {UNKNOWN: "unknown", EXCEEDED: "exceeded", HELD: "held"}
# Up-crossings that a mean period needs.
FEWEST_CROSSINGS = 2
# Powers up to this are products, which have the same bits everywhere.
MOST_FACTORS = 32


@dataclass(frozen=True)
class Kept:
    """What is kept of each run.

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
    """

    columns: tuple[str, ...]
    limits: tuple[str, ...]
    after_s: float = 0.0
    peaks: tuple[int, ...] = ()
    keep: int = 0
    cycles: tuple[int, ...] = ()
    slopes: tuple[float, ...] = ()


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
    """
    into["status"][run] = FINISHED if finished else ENDED_EARLY
    _limits(into, run, limits, finished, kept)
    if not finished:
        return
    time_s = rows[:, 0]
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
        into["cycles"][run, column], into["damage"][run, column] = damage(x[column], kept.slopes)


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


def up_crossing_period(x: NDArray[np.float64], time_s: NDArray[np.float64]) -> NDArray[np.float64]:
    """Mean time between up-crossings of zero, each on the line between two records; NaN where there are less
    than two. `x` has the shape (columns, records)."""
    crossed = (x[:, :-1] < 0) & (x[:, 1:] >= 0)
    count = crossed.sum(axis=1)
    columns = np.arange(len(x))

    def time_at(at: NDArray[np.intp]) -> NDArray[np.float64]:
        step_s, before, behind = time_s[at + 1] - time_s[at], x[columns, at], x[columns, at + 1]
        return time_s[at] - before * step_s / (behind - before)

    first = crossed.argmax(axis=1)
    last = crossed.shape[1] - 1 - crossed[:, ::-1].argmax(axis=1)
    enough = count >= FEWEST_CROSSINGS
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(enough, (time_at(last) - time_at(first)) / np.maximum(count - 1, 1), np.nan)


def peaks(x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Independent peaks: the largest value between each two up-crossings of the mean that follow each other.

    >>> peaks(np.array([0.0, -1.0, 3.0, -1.0, 2.0, -1.0, 1.0]) - 3 / 7).round(2).tolist()
    [2.57, 1.57]
    """
    above = x - x.mean()
    (at,) = np.nonzero((above[:-1] < 0) & (above[1:] >= 0))
    return np.maximum.reduceat(x, at + 1)[:-1] if len(at) > 1 else np.empty(0)


def damage(x: NDArray[np.float64], slopes: Sequence[float]) -> tuple[float, list[float]]:
    """Cycles by rainflow (ASTM E1049-85, half cycles for what is left over), and for each slope m the sum of
    count times range to the m: the damage of an S-N curve N = a S^-m is that sum over a.

    >>> damage(np.array([0.0, 2.0, 0.0, 2.0, 0.0]), [3.0])
    (2.0, [16.0])
    """
    import rainflow

    found = [(size, count) for size, _, count, _, _ in rainflow.extract_cycles(x.tolist())]
    sizes, counts = np.array(found).T if found else (np.empty(0), np.empty(0))
    return float(counts.sum()), [float((counts * _power(sizes, slope)).sum()) for slope in slopes]


def _power(x: NDArray[np.float64], exponent: float) -> NDArray[np.float64]:
    """A power; of a whole number a product: powers of libraries differ in their last bit by processor."""
    if exponent.is_integer() and exponent <= MOST_FACTORS:
        return np.prod(np.repeat(x[None, :], int(exponent), axis=0), axis=0)
    return x**exponent

"""A run's rows, reduced by the steps of its operation: times, extremes of columns, worst values of limits."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..results.operation_steps import rows_of_step

ROUNDING = 1e-12
"""Share of an allowed number of rows by which it is rounded: 1 % of 100 rows is one row."""
EXTREMES = ("maximum", "minimum", "time_of_maximum", "time_of_minimum")


@dataclass(frozen=True)
class Bounds:
    """Bounds of a limit.

    Attributes
    ----------
    column
        Place of its column among those that are kept.
    at_least, at_most
        Bounds in the column's SI unit; infinite without one.
    unit_si
        Size of the limit's unit in the SI unit.
    from_s
        Time from which the limit counts, s.
    until_s
        Time until which it counts, s.
    steps
        Numbers of the steps in which it counts, from 1; all if there are none.
    percentile
        Percentage of the rows that must be within the bounds; 100 for all.
    """

    column: int
    at_least: float
    at_most: float
    unit_si: float
    from_s: float
    until_s: float = np.inf
    steps: tuple[int, ...] = ()
    percentile: float = 100.0


def reduce_steps(
    into: Mapping[str, NDArray[Any]],
    run: int,
    rows: tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]],
    after_s: float,
    limits: Sequence[Bounds],
) -> None:
    """Write the numbers of the steps of a run at its place.

    Times of steps are those of the rows: a step begins with its first row and ends with the first row of a
    later step, or with the last row.

    Parameters
    ----------
    into
        Arrays along runs with ``step_begin``, ``step_end``, ``step_extremes`` and, if there are limits,
        ``step_limit_worst`` and ``step_limit_time``.
    run
        The place along them.
    rows
        Times, s, the number of the step, and the columns, shape (columns, records).
    after_s
        Start of the run that is left out of all values, s.
    limits
        Bounds of the limits.
    """
    time_s, number, x = rows
    steps = into["step_begin"].shape[1]
    for k in range(steps):
        at = rows_of_step(number, k, steps)
        if not len(at):
            continue
        into["step_begin"][run, k] = time_s[at[0]]
        into["step_end"][run, k] = time_s[min(at[-1] + 1, len(time_s) - 1)]
        counted = at[time_s[at] >= after_s]
        if len(counted):
            into["step_extremes"][run, k] = extremes(x[:, counted], time_s[counted])
        for limit, bounds in enumerate(limits):
            if bounds.steps and k + 1 not in bounds.steps:
                continue
            counted = at[(time_s[at] >= bounds.from_s) & (time_s[at] <= bounds.until_s)]
            found = worst(x[bounds.column, counted], bounds)
            if found is not None:
                into["step_limit_worst"][run, k, limit] = x[bounds.column, counted[found]] / bounds.unit_si
                into["step_limit_time"][run, k, limit] = time_s[counted[found]]


def extremes(x: NDArray[np.float64], time_s: NDArray[np.float64]) -> NDArray[np.float64]:
    """Largest and smallest value of each column with their times, shape (columns, extremes).

    A row without a value, as that of a slack rope's angle, does not count.

    >>> extremes(np.array([[1.0, 3.0, np.nan]]), np.array([0.0, 0.5, 1.0])).tolist()
    [[3.0, 1.0, 0.5, 0.0]]
    """
    columns, missing = np.arange(len(x)), np.isnan(x)
    most = np.where(missing, -np.inf, x).argmax(axis=1)
    least = np.where(missing, np.inf, x).argmin(axis=1)
    found = np.stack([x[columns, most], x[columns, least], time_s[most], time_s[least]], axis=1)
    found[missing.all(axis=1)] = np.nan
    return found


def worst(values: NDArray[np.float64], bounds: Bounds) -> int | None:
    """Place of the value nearest to a bound or farthest beyond one; None without a value.

    With a percentile below 100, the allowed share of the worst rows is left out before, as the engine does.

    >>> worst(np.array([0.0, -4.0, 3.0]), Bounds(0, -5.0, 5.0, 1.0, 0.0))
    1
    >>> worst(np.array([0.0, -4.0, 3.0, 1.0]), Bounds(0, -5.0, 5.0, 1.0, 0.0, percentile=75.0))
    2
    """
    margin = np.minimum(values - bounds.at_least, bounds.at_most - values)
    if np.isnan(margin).all():
        return None
    allowed = (1 - bounds.percentile / 100) * np.count_nonzero(~np.isnan(margin))
    return int(np.argsort(margin, kind="stable")[int(allowed * (1 + ROUNDING))])

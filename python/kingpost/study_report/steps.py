"""Report on the steps of an operation: times, worst values of the limits in each, and utilisation."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from ..reports.tables import of_the_time
from ..study.limiting.largest import percentiles
from ..study.reduce import FINISHED
from .blocks import Block, Paragraph, Section, Table
from .cases import STORE, bounds_text, run_text, utilisation

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

MOST_CASES = 60
"""Largest number of cases with a row each; the store has all."""
WHAT_IT_IS = (
    "Utilisation is the worst value over the limit, or the least allowed value over the worst one; above 1 "
    "the limit is exceeded. Times are those of the recorded rows."
)
ORIGIN = f"File: {STORE}, variables"


def section(runs: xarray.Dataset, axes: Sequence[str]) -> Section | None:
    """Section with the steps of the operation and their limits; None without an operation.

    Parameters
    ----------
    runs
        The results of the study.
    axes
        Names of its axes.
    """
    if "step_begin" not in runs:
        return None
    blocks: list[Block] = [Paragraph(WHAT_IT_IS), _times(runs, axes)]
    if "step_limit_worst" in runs:
        shares = _shares(runs)
        blocks += [_limits(runs, axes, shares), *_by_case(runs, axes, shares)]
    return Section("steps", "Steps of the operation", blocks)


def _times(runs: xarray.Dataset, axes: Sequence[str]) -> Table:
    """Tabulate the steps: how many runs reach each, when it begins and how long it lasts."""
    finished = runs["status"].values == FINISHED
    begin, lasts = runs["step_begin"].values, (runs["step_end"] - runs["step_begin"]).values
    rows = []
    for k, name in enumerate(runs["step_name"].values):
        reached = finished & np.isfinite(begin[:, k])
        count = f"{int(reached.sum())} of {int(finished.sum())}"
        held_s = float(runs["stationary_s"].values[k])
        kind = _kind(runs, held_s, lasts[reached, k])
        if not reached.any():
            rows.append((str(k + 1), str(name), kind, count, "-", "-", "-", "-"))
            continue
        masked = np.where(reached, lasts[:, k], np.nan)
        least, most, last = np.nanmin(masked), np.nanmax(masked), int(np.nanargmax(masked))
        middle = f"{np.median(begin[reached, k]):.4g}"
        where = run_text(runs, last, axes, float(begin[last, k]))
        rows.append((str(k + 1), str(name), kind, count, middle, f"{least:.4g}", f"{most:.4g}", where))
    head = ("", "step", "kind", "reached in runs", "begins, s", "shortest, s", "longest, s", "longest in")
    origin = f"{ORIGIN} step_begin, step_end. The beginning is the median of the runs that reach the step."
    return Table("Steps over all runs", head, rows, origin, (0, 4, 5, 6))


def _kind(runs: xarray.Dataset, held_s: float, lasts_s: NDArray[np.float64]) -> str:
    """Describe whether a step happens once, or how far its largest value is extrapolated."""
    if not runs.attrs.get("one_off"):
        return "part of a stationary run"
    if np.isnan(held_s):
        return "once"
    times = f", {held_s / lasts_s.mean():.3g} times its length" if len(lasts_s) else ""
    return f"stationary, extrapolated to {held_s:g} s{times}"


def _shares(runs: xarray.Dataset) -> NDArray[np.float64]:
    """Utilisation along runs, steps and limits; NaN of a run that did not finish."""
    worst = runs["step_limit_worst"].transpose("run", "step", "limit").values
    bounds = list(zip(runs["at_least"].values, runs["at_most"].values, strict=True))
    found = np.full(worst.shape, np.nan)
    for limit, (least, most) in enumerate(bounds):
        of = worst[..., limit]
        shares = [utilisation(value, least, most) for value in of.ravel().tolist()]
        found[..., limit] = np.reshape(shares, of.shape)
    return found


def _limits(runs: xarray.Dataset, axes: Sequence[str], shares: NDArray[np.float64]) -> Table:
    worst, time_s = (runs[f"step_limit_{name}"].values for name in ("worst", "time"))
    rows = []
    for step, limit in _pairs(worst):
        values, least, most, unit = (
            worst[:, step, limit],
            *(float(runs[name].values[limit]) for name in ("at_least", "at_most")),
            str(runs["limit_unit"].values[limit]),
        )
        beyond = np.fmax(values - most, least - values)
        at = int(np.nanargmax(beyond))
        rows.append((str(runs["step_name"].values[step]), str(runs["limit"].values[limit]),
                     bounds_text(least, most, unit) + of_the_time(percentiles(runs)[limit]),
                     f"{values[at]:.4g}", _share(shares[at, step, limit]),
                     run_text(runs, at, axes, float(time_s[at, step, limit]))))  # fmt: skip
    head = ("step", "limit", "allowed", "worst", "utilisation", "in")
    origin = f"{ORIGIN} step_limit_worst, step_limit_time. Values are in the limit's unit."
    return Table("Limits by step, the worst of all runs", head, rows, origin, (3, 4))


def _pairs(worst: NDArray[np.float64]) -> Iterator[tuple[int, int]]:
    """Yield steps and limits with a value in one run or more."""
    known = np.isfinite(worst).any(axis=0)
    yield from ((int(step), int(limit)) for step, limit in np.argwhere(known))


def _by_case(runs: xarray.Dataset, axes: Sequence[str], shares: NDArray[np.float64]) -> list[Block]:
    """Tabulate the largest utilisation of each step in each case, with its limit."""
    cases, first = np.unique(runs["case"].values, return_index=True)
    if not axes or not len(cases):
        return []
    rows = []
    for case, run in list(zip(cases, first, strict=True))[:MOST_CASES]:
        of_case = shares[runs["case"].values == case]
        values = (runs[name].values[run].item() for name in axes)
        cells = (_largest(of_case[:, step], runs) for step in range(shares.shape[1]))
        rows.append(
            (*(f"{value:.6g}" if isinstance(value, float) else str(value) for value in values), *cells)
        )
    head = (*axes, *(str(name) for name in runs["step_name"].values))
    more = f" {len(cases) - MOST_CASES} more cases are in the store only." if len(cases) > MOST_CASES else ""
    origin = f"{ORIGIN} step_limit_worst, at_least, at_most; the largest of all seeds.{more}"
    title = "Largest utilisation by case and step, with its limit"
    return [Table(title, head, rows, origin, tuple(range(len(axes))))]


def _largest(shares: NDArray[np.float64], runs: xarray.Dataset) -> str:
    if np.isnan(shares).all():
        return "-"
    of_limits = np.fmax.reduce(shares, axis=0)
    limit = int(np.nanargmax(of_limits))
    return f"{_share(of_limits[limit])} {runs['limit'].values[limit]}"


def _share(value: float) -> str:
    return "-" if np.isnan(value) else "beyond any" if np.isinf(value) else f"{value:.2f}"

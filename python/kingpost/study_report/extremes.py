"""Statistics, extremes of an operation, and fatigue of a study's columns, each with its run."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ..errors import KingpostError
from ..results.units import engineering
from ..study.limiting.largest import Maxima
from ..study.reduce import FINISHED, STATISTICS
from .blocks import Block, Paragraph, Section, Table
from .cases import STORE, axes_text, run_text

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

CONFIDENCE = 0.9
FEWEST_SEEDS = 5


def section(runs: xarray.Dataset, axes: Sequence[str]) -> Section:
    """Section with statistics over all runs, and the extremes in the case with the largest values.

    Parameters
    ----------
    runs
        The results of the study.
    axes
        Names of its axes.
    """
    blocks: list[Block] = [_statistics(runs, axes)]
    blocks += _extremes(runs, axes)
    blocks += _fatigue(runs, axes)
    return Section("statistics", "Statistics, extremes and fatigue", blocks)


def _statistics(runs: xarray.Dataset, axes: Sequence[str]) -> Table:
    """Tabulate each column over all runs: mean, largest deviation, and the extremes with their runs."""
    finished = runs["status"].values == FINISHED
    values = runs["statistics"].values[finished]
    numbers = np.nonzero(finished)[0]
    mean, deviation, _, most, least, most_s, least_s = (values[:, :, k] for k in range(len(STATISTICS)))
    rows = []
    for k, name in enumerate(runs["column"].values):
        unit, size = engineering(str(runs["column_unit"].values[k]))
        if not np.isfinite(mean[:, k]).any():
            continue
        top, bottom = int(np.nanargmax(most[:, k])), int(np.nanargmin(least[:, k]))
        numbers_of = (np.nanmean(mean[:, k]), np.nanmax(deviation[:, k]), most[top, k], least[bottom, k])
        average, spread, largest, smallest = (f"{number / size:.4g}" for number in numbers_of)
        where = run_text(runs, numbers[top], axes, float(most_s[top, k]))
        ends = (largest, where, smallest, run_text(runs, numbers[bottom], axes, float(least_s[bottom, k])))
        rows.append((str(name), unit, average, spread, *ends))
    head = ("column", "unit", "mean", "largest deviation", "maximum", "in", "minimum", "in")
    origin = f"File: {STORE}, variable statistics; the mean is over all runs that finished."
    return Table("Columns over all runs", head, rows, origin, (2, 3, 4, 6))


def _extremes(runs: xarray.Dataset, axes: Sequence[str]) -> list[Block]:
    """Largest and smallest value in an operation, each in its most severe case."""
    case = runs["case"].values
    finished = runs["status"].values == FINISHED
    cases = [at for k in np.unique(case) if len(at := np.nonzero((case == k) & finished)[0]) >= FEWEST_SEEDS]
    if not cases:
        return [Paragraph(f"No extremes of an operation: they need {FEWEST_SEEDS} seeds of a case or more.")]
    rows = []
    for statistic, sign in (("maximum", 1.0), ("minimum", -1.0)):
        maxima = Maxima.of_columns(runs, sign)
        for k, name in enumerate(runs["column"].values):
            values = maxima.of_run[:, k]
            at = max(cases, key=lambda runs_of_case: float(values[runs_of_case].mean()))
            if np.isfinite(values[at]).all() and np.ptp(values[at]) > 0:
                unit = engineering(str(runs["column_unit"].values[k]))
                cells = _extreme(runs, maxima, (at, k), (sign, unit[1]))
                worst = at[int(np.argmax(values[at]))]
                time_s = runs["statistics"].sel(statistic=f"time_of_{statistic}").values[worst, k]
                rows.append((str(name), unit[0], statistic, *cells, axes_text(runs, at[0], axes),
                             str(len(at)), f"{sign * values[worst] / unit[1]:.4g}",
                             run_text(runs, int(worst), axes, float(time_s))))  # fmt: skip
    exceeded = f"exceeded with {100 * float(runs.attrs['acceptance']):g} %"
    interval = f"{100 * CONFIDENCE:g} % interval"
    head = ("column", "unit", "of", "median", exceeded, interval, "case", "seeds", "of all seeds", "in")
    origin = (
        f"File: {STORE}, variable statistics; of the case with the most severe mean over the seeds. "
        f"{_method(runs)} A minimum is exceeded downward. No value passes the column's physical bounds."
    )
    rows.sort(key=lambda row: row[0])
    return [Table(_title(runs), head, rows, origin, (3, 4, 5, 7, 8))]


def _title(runs: xarray.Dataset) -> str:
    if runs.attrs.get("one_off"):
        return "Extremes of an operation that happens once"
    return f"Extremes of an operation of {float(runs.attrs['operation_s']):g} s"


def _method(runs: xarray.Dataset) -> str:
    if runs.attrs.get("one_off"):
        return (
            "The largest values over the seeds are the sample, by their order, without an extrapolation in "
            "time; a stationary step has a Gumbel distribution, extrapolated to its duration."
        )
    record_s = float(runs.attrs["duration_s"]) - float(runs.attrs["after_s"])
    return (
        f"Gumbel by L-moments over the seeds, extrapolated from {record_s:g} s to the operation of "
        f"{float(runs.attrs['operation_s']):g} s."
    )


def _extreme(
    runs: xarray.Dataset, maxima: Maxima, of: tuple[NDArray[np.intp], int], scale: tuple[float, float]
) -> tuple[str, str, str]:
    """Median, the value that is exceeded with the accepted probability, and its interval, as text."""
    (at, k), (sign, size) = of, scale
    found = maxima.largest(at, k, float(runs.attrs["operation_s"]))
    if found is None:
        return "-", "-", "-"

    def shown(value: float) -> str:
        return f"{sign * min(value, maxima.most[k]) / size:.4g}" if np.isfinite(value) else "-"

    probability = 1 - float(runs.attrs["acceptance"])
    try:
        median, quantile = shown(found.quantile(0.5)), shown(found.quantile(probability))
    except KingpostError:
        # Too few seeds for the quantile of an operation that happens once.
        median, quantile = shown(found.quantile(0.5)), "-"
    low, high = found.interval(probability, CONFIDENCE)
    if not np.isfinite(high) and np.isfinite(low):
        return median, quantile, f"beyond {shown(low)}"
    return median, quantile, f"{shown(low)} to {shown(high)}"


def _fatigue(runs: xarray.Dataset, axes: Sequence[str]) -> list[Block]:
    if "damage" not in runs:
        return []
    rows = []
    for name in runs["column"].values:
        for slope in runs["slope"].values:
            damage = runs["damage"].sel(column=name, slope=slope).values
            cycles = runs["cycles"].sel(column=name).values
            if not np.isfinite(damage).any():
                continue
            at = int(np.nanargmax(damage))
            equivalent = (damage[at] / cycles[at]) ** (1 / slope) if cycles[at] else 0.0
            unit, size = engineering(str(runs["column_unit"].sel(column=name).item()))
            rows.append((str(name), f"{slope:g}", f"{damage[at]:.4g}", f"{cycles[at]:g}",
                         f"{equivalent / size:.4g} {unit}", run_text(runs, at, axes)))  # fmt: skip
    head = ("column", "slope m", "sum of n S^m, SI units", "cycles", "equivalent range", "in")
    origin = (
        f"File: {STORE}, variables damage and cycles: rainflow by ASTM E1049-85. The damage is the sum "
        "over a of the S-N curve N = a S^-m."
    )
    return (
        [Table("Fatigue: the run with the largest damage", head, rows, origin, (1, 2, 3, 4))] if rows else []
    )

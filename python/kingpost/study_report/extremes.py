"""Statistics, extremes of an operation, and fatigue of a study's columns."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..analysis.extremes import extreme
from ..errors import KingpostError
from ..results.units import engineering
from ..study.reduce import FINISHED, STATISTICS
from .blocks import Block, Paragraph, Section, Table

if TYPE_CHECKING:
    import xarray

CONFIDENCE = 0.9
FEWEST_SEEDS = 5
STORE = "results.zarr"


def section(runs: xarray.Dataset) -> Section:
    """Section with statistics over all runs, and the extremes in the case with the largest values."""
    blocks: list[Block] = [_statistics(runs)]
    blocks += _extremes(runs)
    blocks += _fatigue(runs)
    return Section("statistics", "Statistics, extremes and fatigue", blocks)


def _statistics(runs: xarray.Dataset) -> Table:
    """Tabulate each column over all runs: mean, largest deviation, and the extremes with their runs."""
    finished = runs["status"].values == FINISHED
    values = runs["statistics"].values[finished]
    numbers = np.nonzero(finished)[0]
    mean, deviation, _, most, least, *_ = (values[:, :, STATISTICS.index(name)] for name in STATISTICS)
    rows = []
    for k, name in enumerate(runs["column"].values):
        unit, size = engineering(str(runs["column_unit"].values[k]))
        if not np.isfinite(mean[:, k]).any():
            continue
        top, bottom = int(np.nanargmax(most[:, k])), int(np.nanargmin(least[:, k]))
        numbers_of = (np.nanmean(mean[:, k]), np.nanmax(deviation[:, k]), most[top, k], least[bottom, k])
        average, spread, largest, smallest = (f"{number / size:.4g}" for number in numbers_of)
        ends = (largest, str(numbers[top]), smallest, str(numbers[bottom]))
        rows.append((str(name), unit, average, spread, *ends))
    head = ("column", "unit", "mean", "largest deviation", "maximum", "in run", "minimum", "in run")
    origin = f"File: {STORE}, variable statistics; the mean is over all runs that finished."
    return Table("Columns over all runs", head, rows, origin, (2, 3, 4, 5, 6, 7))


def _extremes(runs: xarray.Dataset) -> list[Block]:
    """Largest and smallest value in an operation, each in its most severe case."""
    record_s = float(runs.attrs["duration_s"]) - float(runs.attrs["after_s"])
    operation_s = float(runs.attrs["operation_s"])
    case = runs["case"].values
    finished = runs["status"].values == FINISHED
    cases = [at for k in np.unique(case) if len(at := np.nonzero((case == k) & finished)[0]) >= FEWEST_SEEDS]
    if not cases:
        return [Paragraph(f"No extremes of an operation: they need {FEWEST_SEEDS} seeds of a case or more.")]
    rows = []
    for k, name in enumerate(runs["column"].values):
        unit, size = engineering(str(runs["column_unit"].values[k]))
        for statistic, sign in (("maximum", 1.0), ("minimum", -1.0)):
            values = sign * runs["statistics"].values[:, k, STATISTICS.index(statistic)]
            at = max(cases, key=lambda runs_of_case: float(values[runs_of_case].mean()))
            try:
                found = extreme(values[at], record_s, operation_s)
                low, high = found.expected_interval(CONFIDENCE)
            except KingpostError:
                # A constant column has the same value in every run.
                continue
            ends = sorted((sign * low / size, sign * high / size))
            rows.append((str(name), unit, statistic, f"{sign * found.expected / size:.4g}",
                         f"{ends[0]:.4g} to {ends[1]:.4g}", str(int(case[at[0]])), str(len(at))))  # fmt: skip
    head = ("column", "unit", "of", "expected", f"{100 * CONFIDENCE:g} % interval", "case", "seeds")
    origin = (
        f"File: {STORE}, variable statistics. Gumbel by L-moments over the seeds of the case with the most "
        f"severe mean, moved from {record_s:g} s to the operation of {operation_s:g} s."
    )
    return [
        Table(f"Expected extremes of an operation of {operation_s:g} s", head, rows, origin, (3, 4, 5, 6))
    ]


def _fatigue(runs: xarray.Dataset) -> list[Block]:
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
                         f"{equivalent / size:.4g} {unit}", str(at)))  # fmt: skip
    head = ("column", "slope m", "sum of n S^m, SI units", "cycles", "equivalent range", "in run")
    origin = (
        f"File: {STORE}, variables damage and cycles: rainflow by ASTM E1049-85. The damage is the sum "
        "over a of the S-N curve N = a S^-m."
    )
    return (
        [Table("Fatigue: the run with the largest damage", head, rows, origin, (1, 2, 3, 4, 5))]
        if rows
        else []
    )

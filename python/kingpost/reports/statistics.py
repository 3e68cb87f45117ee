"""Report of the statistics of recorded runs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from ..analysis import pooling, statistics
from ..errors import KingpostError
from ..results.bounds import bounds
from ..results.entries import scenario_of
from ..results.operation_steps import happens_once
from ..results.units import engineering
from ..simulation.batch import FINISHED
from . import outcomes
from .selection import chosen, of_time
from .tables import fixed, table, unit_cell

if TYPE_CHECKING:
    import pandas
    import xarray

FEWEST_RUNS, ENOUGH_RUNS = 5, 10
"""Smallest number of runs for the fit of an extreme, and the number for a useful standard error."""
SMALLEST_MOTION = 1e-12
"""Smallest variation of a column, as a share of its magnitude; smaller ones are rounding error."""
DEVIATIONS = ("standard_deviation", "significant_amplitude", "significant_double_amplitude")
HEADINGS = {
    "mean": "mean",
    "standard_deviation": "deviation",
    "significant_double_amplitude": "sig. double",
    "zero_up_crossing_period": "period, s",
    "maximum": "largest of all",
    "minimum": "smallest of all",
}


def start_s(results: xarray.Dataset, after_s: float | None) -> float:
    """Time from which records count: the given one, otherwise the end of the waves' ramp, if there is one."""
    if after_s is not None:
        return after_s
    sea = scenario_of(results).get("sea")
    ramp_s = float(sea["ramp_s"]) if sea else 0.0
    return ramp_s if ramp_s < float(results["time"].values[-1]) else 0.0


def exposure_s(results: xarray.Dataset, after_s: float | None) -> float:
    """Duration of the extremes: the length of the record for an operation, which is carried out once;
    otherwise three hours."""
    if happens_once(scenario_of(results)):
        return float(results["time"].values[-1]) - start_s(results, after_s)
    return statistics.THREE_HOURS_S


def frame(
    runs: Sequence[xarray.Dataset], after_s: float | None, patterns: Sequence[str] = ()
) -> pandas.DataFrame:
    """Tabulate the channels, a row for each: its unit (deg, kN, t), its statistics and, from five runs on,
    the expected largest and smallest value of three hours, or of one operation, with their standard errors.

    For several runs, mean, deviation, double amplitude and period are averaged over the runs, and the largest
    and smallest values are those of all runs. If no channels are named, constant ones are left out.

    Raises
    ------
    KingpostError
        If the runs are not realisations of one scenario with different seeds.
    """
    import pandas

    pooling.check(runs)
    first = start_s(runs[0], after_s)
    exposure = exposure_s(runs[0], after_s)
    names = chosen(runs[0], patterns)
    if not names:
        file = pooling.file_of(runs[0])
        raise KingpostError(f"{file}: found no main column, allowed: --channels with columns as ship.roll")
    pooled = _pooled(runs, list(names), first)
    lengths_s = (float(runs[0]["time"].values[-1]) - first, exposure)
    rows = []
    for name, unit in names.items():
        of_runs = pooled[name]
        if not patterns and of_runs["still"].all():
            continue
        shown, size = engineering(unit)
        rows.append({"channel": name, "unit": shown, **_row(of_runs, lengths_s, 1 / size, bounds(name))})
    return pandas.DataFrame(rows)


def _pooled(
    runs: Sequence[xarray.Dataset], names: Sequence[str], after_s: float
) -> dict[str, dict[str, np.ndarray]]:
    """Values of all runs by column and statistic, with one run in memory at a time."""
    found: dict[str, list[dict[str, float]]] = {name: [] for name in names}
    for run in runs:
        for side_by_side in _tables(run, names):
            for name, one in zip(names, _summaries(side_by_side, after_s), strict=True):
                found[name].append(one)
    return {
        name: {key: np.array([one[key] for one in of_runs]) for key in of_runs[0]}
        for name, of_runs in found.items()
    }


def _tables(run: xarray.Dataset, names: Sequence[str]) -> Iterator[xarray.DataArray]:
    """Yield one table of columns over time for each run of a data set."""
    import xarray

    every = of_time(run)
    for name in names:
        if name not in every:
            file = pooling.file_of(run)
            raise KingpostError(f"{file}: found no channel {name}, allowed: runs of one scenario")
    loaded = run[list({every[name].variable: None for name in names})].compute()
    series = [every[name].of(loaded) for name in names]
    for k in range(run.sizes.get("run", 1)):
        alone = [one.isel(run=k) if "run" in one.dims else one for one in series]
        values = np.stack([one.values for one in alone], axis=-1)
        yield xarray.DataArray(values, {"time": run["time"].values}, ("time", "column"))


def _summaries(table: xarray.DataArray, after_s: float) -> Iterator[dict[str, float]]:
    kept = statistics.after(table, after_s)
    found = statistics.summary(kept).transpose("column", "statistic").values
    for values, row in zip(kept.values.T, found, strict=True):
        one = dict(zip(statistics.STATISTICS, map(float, row), strict=True))
        still = _stands_still(values)
        if still:
            one |= dict.fromkeys(DEVIATIONS, 0.0)
        yield {**one, "still": still}


def text(runs: Sequence[xarray.Dataset], found: pandas.DataFrame, after_s: float | None) -> str:
    """The statistics as a table, with the runs and times that they cover."""
    first, time = start_s(runs[0], after_s), runs[0]["time"].values
    count = sum(run.sizes.get("run", 1) for run in runs)
    hours = f"{count * (time[-1] - first) / 3600:.2g} h in all"
    of = (
        f"{count} runs, {hours}: averages over the runs; largest and smallest of all runs"
        if count > 1
        else "one run"
    )
    came_of = outcomes.blocks(outcomes.of_runs(runs))
    lines = [
        str(runs[0].attrs.get("title", "")),
        f"{first:g} to {time[-1]:g} s of {of}",
        *_unfinished(runs),
        *(line for block in came_of for line in ["", *block]),
        "",
    ]
    rows = [("channel", "", *HEADINGS.values())]
    for row in found.to_dict("records"):
        most = max(abs(row["maximum"]), abs(row["minimum"]))
        rows.append(
            (row["channel"], unit_cell(row["unit"]), *(_number(row[name], most) for name in HEADINGS))
        )
    lines += table(rows, "<<" + ">" * len(HEADINGS))
    exposure = exposure_s(runs[0], after_s)
    of = "three hours" if exposure == statistics.THREE_HOURS_S else f"one operation of {exposure:g} s"
    return "\n".join([*lines, "", *_extremes(found, count, of)])


def _extremes(found: pandas.DataFrame, count: int, of: str) -> list[str]:
    """Expected extremes with their standard errors, if there are enough runs."""
    if count < FEWEST_RUNS:
        return [f"expected extremes of {of} need {ENOUGH_RUNS} runs or more with different seeds"]
    rows = [(f"expected of {of}", "", "largest", "", "smallest", "")]
    for row in found.to_dict("records"):
        cells = [(_number(row[side]), f"+- {_number(row[f'{side}_error'])}" if np.isfinite(row[side]) else "")
                 for side in ("extreme_largest", "extreme_smallest")]  # fmt: skip
        rows.append((row["channel"], unit_cell(row["unit"]), *cells[0], *cells[1]))
    lines = [*table(rows, "<<><><"), "+- one standard error, from the scatter of the runs"]
    if count < ENOUGH_RUNS:
        lines.append(f"warning: of {count} runs these are rough: {ENOUGH_RUNS} or more, each of another seed")
    return lines


def _unfinished(runs: Sequence[xarray.Dataset]) -> list[str]:
    """Warnings about runs that Ctrl-C or a divergence ended early."""
    ends = [(run, str(run.attrs.get("status", FINISHED))) for run in runs if "run" not in run.sizes]
    return [f"warning: a run ended early, at {run['time'].values[-1]:g} s: {status}"
            for run, status in ends if status != FINISHED]  # fmt: skip


def _stands_still(values: np.ndarray) -> bool:
    with np.errstate(over="ignore", invalid="ignore"):
        return bool(np.ptp(values) <= SMALLEST_MOTION * np.abs(values).max())


def _row(
    of_runs: dict[str, np.ndarray],
    lengths_s: tuple[float, float],
    scale: float,
    possible: tuple[float, float],
) -> dict[str, float]:
    """Row of a column. `lengths_s` has the length of a record and the exposure time, `possible` the column's
    physical bounds."""
    record_s, exposure = lengths_s
    row = {
        name: float(of_runs[name].mean()) * (1.0 if name == "zero_up_crossing_period" else scale)
        for name in statistics.STATISTICS
    }
    # The largest value is that of all runs.
    row["maximum"] = scale * float(of_runs["maximum"].max())
    row["minimum"] = scale * float(of_runs["minimum"].min())
    if len(of_runs["maximum"]) >= FEWEST_RUNS:
        for side, sign, values in (
            ("largest", 1, of_runs["maximum"]),
            ("smallest", -1, of_runs["minimum"]),
        ):
            expected, error = _extreme(sign * values, record_s, exposure)
            row[f"extreme_{side}"] = scale * float(np.clip(sign * expected, *possible))
            row[f"extreme_{side}_error"] = scale * error
    return row


def _extreme(values: np.ndarray, record_s: float, exposure: float) -> tuple[float, float]:
    """Expected largest value in the exposure time, s, and its standard error; NaN for a constant column."""
    if not np.isfinite(values).all() or _stands_still(values):
        return np.nan, np.nan
    found = statistics.extreme(values, record_s, exposure)
    return found.expected, found.expected_error


def _number(value: float, most: float = 0.0) -> str:
    """A number with at least four digits, without an exponent if possible; 0 if it is a rounding error of a
    channel whose largest magnitude is `most`."""
    if not np.isfinite(value):
        return "-"
    if abs(value) < SMALLEST_MOTION * most:
        value = 0.0
    size = abs(value)
    if 1e4 <= size < 1e7:
        return f"{value:.0f}"
    return f"{value:.4g}" if size >= 1e4 or 0 < size < 1e-3 else fixed(value, 4 if size < 10 else 2)

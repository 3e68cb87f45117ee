"""What the command line prints of the statistics of recorded runs."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

import numpy as np

from ..analysis import pooling, statistics
from ..errors import KingpostError
from ..results.columns import columns, floating_bodies, unit_of
from ..simulation.batch import FINISHED
from . import outcomes
from .tables import fixed, table

if TYPE_CHECKING:
    import pandas
    import xarray

# Of these where no channels are named; a floating body's place and angles, and all of the others.
OF_SHIPS = ("position.z", "roll", "pitch", "yaw")
ALL_OF = ("wave_elevation", "joint_position", "line_tension")
FEWEST_RUNS, ENOUGH_RUNS = 5, 10
"""Runs that an extreme is fitted to, and those that give an error worth having."""
SMALLEST_MOTION = 1e-12
"""What varies by less than this share of its size stands still but for rounding."""
HEADINGS = {
    "mean": "mean",
    "standard_deviation": "deviation",
    "significant_double_amplitude": "sig. double",
    "zero_up_crossing_period": "period, s",
    "maximum": "largest of all",
    "minimum": "smallest of all",
}


def start_s(results: xarray.Dataset, after_s: float | None) -> float:
    """From when on records count: as asked, else the end of the waves' ramp."""
    if after_s is not None:
        return after_s
    sea = json.loads(results.attrs.get("scenario", "{}")).get("sea")
    return float(sea["ramp_s"]) if sea else 0.0


def exposure_s(results: xarray.Dataset, after_s: float | None) -> float:
    """How long the extremes are of: as long as the record where an operation steers, which is done once; else
    three hours."""
    operation = json.loads(results.attrs.get("scenario", "{}")).get("operation")
    if operation and operation.get("enabled", True):
        return float(results["time"].values[-1]) - start_s(results, after_s)
    return statistics.THREE_HOURS_S


def frame(
    runs: Sequence[xarray.Dataset], after_s: float | None, patterns: Sequence[str] = ()
) -> pandas.DataFrame:
    """A row for each channel: its unit (angles in deg), its statistics and, from five runs on, the expected
    largest and smallest value of three hours, or of one operation, with their standard errors.

    Of several runs mean, deviation, double amplitude and period are the means over them, the largest and the
    smallest value those of all. Where no channels are asked for, those that stand still are left out.

    Raises
    ------
    KingpostError
        When the runs are not realisations of one scenario, each with a seed of its own.
    """
    import pandas

    pooling.check(runs)
    first = start_s(runs[0], after_s)
    exposure = exposure_s(runs[0], after_s)
    names = chosen(runs[0], patterns)
    rows = []
    for name, unit in names.items():
        series = [part for run in runs for part in series_of(run, name)]
        if not patterns and all(_stands_still(statistics.after(part, first).values) for part in series):
            continue
        scale = 180 / np.pi if unit == "rad" else 1.0
        row = _row(series, first, exposure, scale)
        rows.append({"channel": name, "unit": "deg" if unit == "rad" else unit, **row})
    return pandas.DataFrame(rows)


def text(runs: Sequence[xarray.Dataset], found: pandas.DataFrame, after_s: float | None) -> str:
    """The statistics as a table, with what they are of."""
    first, time = start_s(runs[0], after_s), runs[0]["time"].values
    count = sum(run.sizes.get("run", 1) for run in runs)
    hours = f"{count * (time[-1] - first) / 3600:.2g} h in all"
    of = (
        f"{count} runs, {hours}: means over them, but for the largest and the smallest"
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
        rows.append((row["channel"], row["unit"], *(_number(row[name]) for name in HEADINGS)))
    lines += table(rows, "<<" + ">" * len(HEADINGS))
    exposure = exposure_s(runs[0], after_s)
    of = "three hours" if exposure == statistics.THREE_HOURS_S else f"one operation of {exposure:g} s"
    return "\n".join([*lines, "", *_extremes(found, count, of)])


def _extremes(found: pandas.DataFrame, count: int, of: str) -> list[str]:
    """Expected extremes with their standard errors, where there are runs enough."""
    if count < FEWEST_RUNS:
        return [f"expected extremes of {of} need {ENOUGH_RUNS} runs or more, each of another seed"]
    rows = [(f"expected of {of}", "", "largest", "", "smallest", "")]
    for row in found.to_dict("records"):
        cells = [(_number(row[side]), f"+- {_number(row[f'{side}_error'])}" if np.isfinite(row[side]) else "")
                 for side in ("extreme_largest", "extreme_smallest")]  # fmt: skip
        rows.append((row["channel"], row["unit"], *cells[0], *cells[1]))
    lines = [*table(rows, "<<><><"), "+- one standard error, by the scatter of the runs"]
    if count < ENOUGH_RUNS:
        lines.append(f"warning: of {count} runs these are rough: {ENOUGH_RUNS} or more, each of another seed")
    return lines


def _unfinished(runs: Sequence[xarray.Dataset]) -> list[str]:
    """Of the runs that Ctrl-C or a divergence ended early."""
    ends = [(run, str(run.attrs.get("status", FINISHED))) for run in runs if "run" not in run.sizes]
    return [f"warning: a run ended early, at {run['time'].values[-1]:g} s: {status}"
            for run, status in ends if status != FINISHED]  # fmt: skip


def _stands_still(values: np.ndarray) -> bool:
    return bool(np.ptp(values) <= SMALLEST_MOTION * np.abs(values).max())


def chosen(results: xarray.Dataset, patterns: Sequence[str]) -> dict[str, str]:
    """Names of flat columns with their units."""
    found = {name: unit_of(series) for name, series in _columns(results)}
    if not patterns:
        return {name: unit for name, unit in found.items() if _is_default(results, name)}
    chosen = {name: unit for name, unit in found.items() if any(fnmatchcase(name, p) for p in patterns)}
    for pattern in patterns:
        if not any(fnmatchcase(name, pattern) for name in found):
            raise KingpostError(
                f"--channels: found {pattern!r}, allowed: columns as ship.roll, or patterns as ship.*"
            )
    return chosen


def _is_default(results: xarray.Dataset, name: str) -> bool:
    return name in [
        f"{body}.{quantity}" for body in floating_bodies(results) for quantity in OF_SHIPS
    ] or any(variable in name.split(".") for variable in ALL_OF)


def _columns(results: xarray.Dataset) -> Iterator[tuple[str, xarray.DataArray]]:
    """Flat columns as `kingpost run -o FILE.csv` names them, over time and, of many runs, ``run``."""
    over_time = results[[name for name, values in results.data_vars.items() if "time" in values.dims]]
    return columns(over_time, along=("time", "run"))


def series_of(results: xarray.Dataset, name: str) -> list[xarray.DataArray]:
    """One channel of each run of a data set."""
    for found, series in _columns(results):
        if found == name:
            return (
                [series]
                if "run" not in series.dims
                else [series.isel(run=i) for i in range(series.sizes["run"])]
            )
    raise KingpostError(
        f"{results.attrs.get('source', '')}: found no channel {name}, allowed: runs of one scenario"
    )


def _row(
    series: Sequence[xarray.DataArray], after_s: float, exposure: float, scale: float
) -> dict[str, float]:
    summaries = [statistics.summary(part, after_s) for part in series]
    by_name = {
        name: np.array([float(s.sel(statistic=name)) for s in summaries]) for name in statistics.STATISTICS
    }
    still = [_stands_still(statistics.after(part, after_s).values) for part in series]
    for name in ("standard_deviation", "significant_amplitude", "significant_double_amplitude"):
        by_name[name][still] = 0.0
    row = {
        name: float(values.mean()) * (1.0 if name == "zero_up_crossing_period" else scale)
        for name, values in by_name.items()
    }
    # The largest is that of all runs.
    row["maximum"], row["minimum"] = (
        scale * float(by_name["maximum"].max()),
        scale * float(by_name["minimum"].min()),
    )
    if len(series) >= FEWEST_RUNS:
        record_s = float(series[0]["time"].values[-1]) - after_s
        for side, sign, values in (("largest", 1, by_name["maximum"]), ("smallest", -1, by_name["minimum"])):
            row |= _extreme(side, scale, sign, values, record_s, exposure)
    return row


def _extreme(
    side: str, scale: float, sign: int, values: np.ndarray, record_s: float, exposure: float
) -> dict[str, float]:
    """Expected extreme of the exposure, s, and its standard error; not a number where nothing moves."""
    if not np.isfinite(values).all() or _stands_still(values):
        return {f"extreme_{side}": np.nan, f"extreme_{side}_error": np.nan}
    found = statistics.extreme(sign * values, record_s, exposure)
    return {
        f"extreme_{side}": sign * scale * found.expected,
        f"extreme_{side}_error": scale * found.expected_error,
    }


def _number(value: float) -> str:
    """Four digits or more, without an exponent where none is needed."""
    if not np.isfinite(value):
        return "-"
    size = abs(value)
    if 1e4 <= size < 1e7:
        return f"{value:.0f}"
    return f"{value:.4g}" if size >= 1e4 or 0 < size < 1e-3 else fixed(value, 4 if size < 10 else 2)

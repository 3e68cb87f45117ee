"""Distribution of the largest value of a quantity in a case, over the seeds: of a limit's excess over its
bound, or of a column."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ...analysis.extremes import Constant, Joined, Largest, extreme, one_off
from ...results.bounds import bounds

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

    Numbers = NDArray[np.float64]

SMALLEST_SPREAD = 1e-12
"""Smallest spread of values over the seeds, as a share of their size; below it they are constant."""


@dataclass(frozen=True)
class Maxima:
    """Largest values of quantities in runs and in the steps of their operation.

    Attributes
    ----------
    of_run
        In the whole run, along runs and quantities.
    of_steps
        In each step of the operation, along runs, steps and quantities; no steps without an operation.
    most
        Largest value that the physical bounds of the column allow, along quantities; infinite without bounds.
    record_s
        Time for which each quantity is evaluated in a run, s.
    steps_s
        Time for which each quantity is evaluated in a step, along runs, steps and quantities.
    stationary_s
        Duration to which each step is extrapolated; NaN for one that happens once.
    one_off
        Whether a run happens once.
    of_share
        Whether each quantity is a percentile of the rows, which does not grow with the duration.
    """

    of_run: Numbers
    of_steps: Numbers
    most: Numbers
    record_s: Numbers
    steps_s: Numbers
    stationary_s: Numbers
    one_off: bool
    of_share: NDArray[np.bool_]

    @classmethod
    def of_limits(cls, results: xarray.Dataset) -> Maxima:
        """Excess of the worst values of limits over their bounds, in the limits' units; negative inside."""
        least, most = results["at_least"].values, results["at_most"].values
        of_run = np.fmax(_worst(results, "limit_worst") - most, least - _worst(results, "limit_worst"))
        duration_s, after_s = (float(results.attrs[name]) for name in ("duration_s", "after_s"))
        from_s, until_s = np.full(len(least), after_s), np.full(len(least), duration_s)
        if "limit_from_s" in results.coords:
            from_s = np.maximum(results["limit_from_s"].values, after_s)
        if "limit_until_s" in results.coords:
            until_s = results["limit_until_s"].values
        of_steps = np.empty((len(of_run), 0, len(least)))
        if "step_limit_worst" in results:
            worst = _worst(results, "step_limit_worst")
            of_steps = np.fmax(worst - most, least - worst)
        possible = _largest_excess(results, least, most)
        steps_s, stationary_s, once = _of_steps(results, from_s, until_s)
        record_s = _positive(until_s - from_s)
        if of_steps.size:
            record_s = np.fmin(record_s, _in_its_steps(steps_s, of_steps))
        of_share = percentiles(results) < 100
        return cls(of_run, of_steps, possible, record_s, steps_s, stationary_s, once, of_share)

    @classmethod
    def of_columns(cls, results: xarray.Dataset, sign: float) -> Maxima:
        """Largest values of the columns, or the negative smallest ones for a sign of -1; SI units."""
        statistic = "maximum" if sign > 0 else "minimum"
        of_run = sign * results["statistics"].sel(statistic=statistic).transpose("run", "column").values
        columns = of_run.shape[1]
        from_s = np.full(columns, float(results.attrs["after_s"]))
        of_steps = np.empty((len(of_run), 0, columns))
        if "step_extremes" in results:
            chosen = results["step_extremes"].sel(extreme=statistic)
            of_steps = sign * chosen.transpose("run", "step", "column").values
        possible = np.array(
            [max(sign * end for end in bounds(str(name))) for name in results["column"].values]
        )
        duration_s = float(results.attrs["duration_s"])
        by_steps = _of_steps(results, from_s, np.full(columns, duration_s))
        no_share = np.zeros(columns, bool)
        return cls(of_run, of_steps, possible, duration_s - from_s, *by_steps, no_share)

    def largest(self, runs: NDArray[np.intp], k: int, operation_s: float) -> Largest | None:
        """Distribution of the largest value of a quantity over the runs of a case; None if it is not known.

        A run that is stationary as a whole is extrapolated to `operation_s`. Of a run that happens once, its
        steps that happen once give the sample, each stationary step is extrapolated to its duration, and the
        two are joined. A percentile of the rows is that of each run, which is the sample.
        """
        if self.of_share[k]:
            return _once(self.of_run[runs, k])
        if not self.one_off:
            return _stationary(self.of_run[runs, k], self.record_s[k], operation_s)
        held = np.flatnonzero(np.isfinite(self.stationary_s))
        if not len(held):
            return _once(self.of_run[runs, k])
        steps = self.of_steps[runs, :, k]
        # A limit has no values in the steps in which it does not count.
        held = held[np.isfinite(steps[:, held]).any(axis=0)]
        found = [_once(_fmax(np.delete(steps, held, axis=1)))] if len(held) < steps.shape[1] else []
        for step in held:
            lasts_s = float(np.mean(self.steps_s[runs, step, k]))
            found.append(_stationary(steps[:, step], lasts_s, float(self.stationary_s[step])))
        known = [part for part in found if part is not None]
        if len(known) < len(found):
            return None
        return Joined(known, (float(np.nanmin(steps)), float(np.nanmax(steps))))


def _once(values: Numbers) -> Largest | None:
    """Order statistics, or a constant; None if a run has no value."""
    return _constant(values) or (one_off(values) if np.isfinite(values).all() else None)


def _stationary(values: Numbers, record_s: float, duration_s: float) -> Largest | None:
    """Gumbel distribution, or a constant; None if a run has no value."""
    return _constant(values) or (extreme(values, record_s, duration_s) if np.isfinite(values).all() else None)


def _constant(values: Numbers) -> Constant | None:
    size = np.abs(values).max(initial=0.0)
    return Constant(float(values[0])) if np.ptp(values) <= SMALLEST_SPREAD * size else None


def _fmax(values: Numbers) -> Numbers:
    """Largest value along the last axis; NaN where there is none."""
    return np.fmax.reduce(values, axis=-1)


def _worst(results: xarray.Dataset, name: str) -> Numbers:
    dims = ("run", "step", "limit") if name.startswith("step") else ("run", "limit")
    worst: Numbers = results[name].transpose(*dims).values
    return worst


def _largest_excess(results: xarray.Dataset, least: Numbers, most: Numbers) -> Numbers:
    if "limit_unit_si" not in results.coords or "limit_column" not in results.coords:
        return np.full(len(least), np.inf)
    of_columns = np.array([bounds(str(name)) for name in results["limit_column"].values])
    low, high = of_columns.T / results["limit_unit_si"].values
    return np.fmax(high - most, least - low)


def _of_steps(results: xarray.Dataset, from_s: Numbers, until_s: Numbers) -> tuple[Numbers, Numbers, bool]:
    """Time for which each quantity is evaluated in each step, the duration to which each step is
    extrapolated, and whether a run happens once."""
    one_off = bool(results.attrs.get("one_off", 0))
    if "step_begin" not in results:
        return np.empty((results.sizes["run"], 0, len(from_s))), np.empty(0), one_off
    begin, end = (results[name].transpose("run", "step").values for name in ("step_begin", "step_end"))
    lengths_s = _positive(np.minimum(end[..., None], until_s) - np.maximum(begin[..., None], from_s))
    return lengths_s, results["stationary_s"].values, one_off


def percentiles(results: xarray.Dataset) -> Numbers:
    """Percentage of the rows that must be within the bounds of each limit; 100 in files without it."""
    if "limit_percentile" in results.coords:
        return np.asarray(results["limit_percentile"].values, float)
    return np.full(results["at_least"].shape, 100.0)


def _in_its_steps(steps_s: Numbers, worst: Numbers) -> Numbers:
    """Mean time for which a limit counts in a run, s: that of the steps in which it has a value."""
    counted = np.where(np.isfinite(worst), steps_s, 0.0)
    return _positive(np.nansum(counted, axis=1).mean(axis=0))


def _positive(durations_s: Numbers) -> Numbers:
    return np.where(durations_s > 0, durations_s, np.nan)

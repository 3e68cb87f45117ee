"""Distribution of the largest excess of a limit's column over its bound in a case, over the seeds."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ...analysis.extremes import Joined, Largest, extreme, one_off
from ...results.bounds import bounds

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

    Numbers = NDArray[np.float64]

SMALLEST_SPREAD = 1e-12
"""Smallest spread of values over the seeds, as a share of their size; with a smaller one they are constant."""


@dataclass(frozen=True)
class Excess:
    """Excess of the worst values of limits over their bounds, in the limits' units; negative inside them.

    Attributes
    ----------
    of_run
        In the whole run, along runs and limits.
    of_steps
        In each step of the operation, along runs, steps and limits; None without steps.
    most
        Largest excess that the column's physical bounds allow, along limits; infinite without bounds.
    lengths_s
        Time for which each limit is evaluated in a step, along runs, steps and limits.
    record_s
        Time for which each limit is evaluated in a run, s.
    stationary_s
        Duration to which each step is extrapolated; NaN for one that happens once.
    one_off
        Whether a run happens once.
    """

    of_run: Numbers
    of_steps: Numbers | None
    most: Numbers
    lengths_s: Numbers | None
    record_s: Numbers
    stationary_s: Numbers
    one_off: bool

    @classmethod
    def of(cls, results: xarray.Dataset) -> Excess:
        """Take the excess from the results of a study."""
        least, most = results["at_least"].values, results["at_most"].values
        steps = "step_limit_worst" in results
        return cls(
            _beyond(results["limit_worst"].transpose("run", "limit").values, least, most),
            _beyond(results["step_limit_worst"].transpose("run", "step", "limit").values, least, most)
            if steps
            else None,
            _largest_possible(results, least, most),
            _lengths_s(results) if steps else None,
            _records_s(results),
            results["stationary_s"].values if "stationary_s" in results.coords else np.empty(0),
            bool(results.attrs.get("one_off", 0)),
        )

    def largest(self, runs: NDArray[np.intp], limit: int, operation_s: float) -> Largest | None:
        """Distribution of the largest excess of a limit over the runs of a case; None if it is not known.

        A run that is stationary as a whole is extrapolated to `operation_s`. Of a run that happens once, its
        steps that happen once give the sample, each stationary step is extrapolated to its duration, and the
        two are joined.
        """
        if not self.one_off:
            return _stationary(self.of_run[runs, limit], self.record_s[limit], operation_s)
        held = np.flatnonzero(np.isfinite(self.stationary_s))
        if not len(held) or self.of_steps is None or self.lengths_s is None:
            return _once(self.of_run[runs, limit])
        steps = self.of_steps[runs, :, limit]
        found = [_once(_fmax(np.delete(steps, held, axis=1)))] if len(held) < steps.shape[1] else []
        for step in held:
            lasts_s = float(np.nanmean(self.lengths_s[runs, step, limit]))
            found.append(_stationary(steps[:, step], lasts_s, float(self.stationary_s[step])))
        known = [part for part in found if part is not None]
        if len(known) < len(found):
            return None
        return Joined(known, (float(np.nanmin(steps)), float(np.nanmax(steps))))


def _once(values: Numbers) -> Largest | None:
    return one_off(values) if np.isfinite(values).all() else None


def _stationary(values: Numbers, record_s: float, duration_s: float) -> Largest | None:
    """Gumbel distribution, or that of a constant; None if a run has no value."""
    if not np.isfinite(values).all():
        return None
    if np.ptp(values) <= SMALLEST_SPREAD * np.abs(values).max(initial=0.0):
        return one_off(np.full(len(values), values[0]))
    return extreme(values, record_s, duration_s)


def _fmax(values: Numbers) -> Numbers:
    """Largest value along the last axis; NaN where there is none."""
    return np.fmax.reduce(values, axis=-1)


def _beyond(worst: Numbers, least: Numbers, most: Numbers) -> Numbers:
    return np.fmax(worst - most, least - worst)


def _largest_possible(results: xarray.Dataset, least: Numbers, most: Numbers) -> Numbers:
    if "limit_unit_si" not in results.coords or "limit_column" not in results.coords:
        return np.full(len(least), np.inf)
    of_columns = np.array([bounds(str(name)) for name in results["limit_column"].values])
    low, high = of_columns.T / results["limit_unit_si"].values
    return np.fmax(high - most, least - low)


def _records_s(results: xarray.Dataset) -> Numbers:
    """Time for which each limit is evaluated in a run, s."""
    duration_s, after_s = (float(results.attrs[name]) for name in ("duration_s", "after_s"))
    if "limit_from_s" not in results.coords:
        return np.full(results.sizes["limit"], duration_s - after_s)
    left_s: Numbers = duration_s - np.maximum(results["limit_from_s"].values, after_s)
    return np.where(left_s > 0, left_s, np.nan)


def _lengths_s(results: xarray.Dataset) -> Numbers:
    begin, end = (results[name].transpose("run", "step").values for name in ("step_begin", "step_end"))
    left_s: Numbers = end[..., None] - np.maximum(begin[..., None], results["limit_from_s"].values)
    return np.where(left_s > 0, left_s, np.nan)

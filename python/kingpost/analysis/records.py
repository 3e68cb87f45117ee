"""Records over time: cut at the start, and checked for even steps."""

from __future__ import annotations

from typing import TYPE_CHECKING, overload

import numpy as np

from ..errors import KingpostError

if TYPE_CHECKING:
    import xarray

# Records whose steps differ by more than this share are not evenly spaced.
EVEN = 1e-6


@overload
def after(series: xarray.DataArray, after_s: float) -> xarray.DataArray: ...
@overload
def after(series: xarray.Dataset, after_s: float) -> xarray.Dataset: ...
def after(series: xarray.Dataset | xarray.DataArray, after_s: float) -> xarray.Dataset | xarray.DataArray:
    """Leave out the records before a time.

    Parameters
    ----------
    series
        With a dimension ``time``, s.
    after_s
        The first time that is kept, s.

    Returns
    -------
    xarray.Dataset or xarray.DataArray
        As given.

    Raises
    ------
    KingpostError
        When there is no time, or less than two records are left.

    >>> from kingpost import run
    >>> after(run("paper", {"simulation.duration_s": 0.1}), 0.05).sizes["time"]
    6
    """
    if "time" not in series.dims:
        raise KingpostError(
            f"found the dimensions {', '.join(map(str, series.dims))}, allowed: time among them"
        )
    kept = series.isel(time=series["time"].values >= after_s)
    if kept.sizes["time"] < 2:
        last = series["time"].values[-1]
        raise KingpostError(f"after_s: found {after_s:g} s, allowed: before the last records at {last:g} s")
    return kept


def even(series: xarray.DataArray) -> tuple[xarray.DataArray, float]:
    """Return a record and its step, s; a last row off the regular time grid is left out.

    Parameters
    ----------
    series
        With a dimension ``time``, s.

    Returns
    -------
    tuple of xarray.DataArray and float
        The record and its step, s.

    Raises
    ------
    KingpostError
        When its steps differ.

    >>> from kingpost import run
    >>> even(run("paper", {"simulation.duration_s": 0.1})["kinetic_energy"])[1].__round__(9)
    0.01
    """
    steps = np.diff(series["time"].values)
    step_s = float(steps[0])
    if len(steps) > 1 and abs(steps[-1] - step_s) > EVEN * step_s:
        series, steps = series.isel(time=slice(None, -1)), steps[:-1]
    if np.abs(steps - step_s).max() > EVEN * step_s:
        raise KingpostError(
            f"time: found steps from {steps.min():g} to {steps.max():g} s, allowed: even steps"
        )
    return series, step_s

"""Statistics of motions in a random sea: deviations, periods, extremes, and spectra (`spectra`).

A sea and its linear responses are taken as stationary and Gaussian: `after_s` leaves out the start, in which
waves grow and motions settle. Terms:

- **significant amplitude** is two standard deviations of a motion about its mean;
- **significant double amplitude** is four standard deviations, crest to trough: for the wave elevation it is
Hs;
- **zero up-crossing period** is the mean time between up-crossings of the mean;
- **spectrum** is one-sided, over the angular frequency: its integral is the variance.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, overload

import numpy as np

from ..results.columns import unit_coordinate
from .extremes import EULER, THREE_HOURS_S, Extreme, extreme
from .records import after, even
from .spectra import moments, spectrum

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

__all__ = ["EULER", "THREE_HOURS_S", "Extreme", "after", "even", "extreme", "moments", "spectrum", "summary"]

STATISTICS = ("mean", "standard_deviation", "significant_amplitude", "significant_double_amplitude",
              "zero_up_crossing_period", "maximum", "minimum")  # fmt: skip

# Number of up-crossings that a mean period needs.
FEWEST_CROSSINGS = 2


@overload
def summary(results: xarray.DataArray, after_s: float = 0.0) -> xarray.DataArray: ...
@overload
def summary(results: xarray.Dataset, after_s: float = 0.0) -> xarray.Dataset: ...
def summary(
    results: xarray.Dataset | xarray.DataArray, after_s: float = 0.0
) -> xarray.Dataset | xarray.DataArray:
    """Mean, standard deviation, significant amplitude and double amplitude, zero up-crossing period,
    maximum and minimum over time, along the dimension ``statistic``.

    Parameters
    ----------
    results
        A data set of `run` or `Batch`, or one of its variables. Variables without the dimension ``time`` stay
        as they are.
    after_s
        Leave out the records before this time, s.

    Notes
    -----
    The coordinate ``<variable>_unit`` holds the units: the variable's unit, and s for the period. The period
    is NaN if there are fewer than two up-crossings of the mean. A run that ended early, which `Batch` fills
    up with NaN, has NaN for its statistics.

    Returns
    -------
    xarray.DataArray or xarray.Dataset
        As given, along ``statistic`` instead of ``time``.

    Raises
    ------
    KingpostError
        If fewer than two records are left.

    >>> import xarray
    >>> time = np.arange(0.0, 100.0, 0.1)
    >>> heave = xarray.DataArray(np.sin(2 * np.pi * time / 8), {"time": time}, ("time",), "heave")
    >>> found = summary(heave, after_s=20.0)
    >>> round(float(found.sel(statistic="zero_up_crossing_period")), 3)
    8.0
    >>> round(float(found.sel(statistic="significant_amplitude")), 2)
    1.41
    """
    import xarray

    kept = after(results, after_s)
    if isinstance(kept, xarray.Dataset):
        own = {name: _with_own_unit(v) for name, v in kept.data_vars.items()}
        named = {name: summary(v) if "time" in v.dims else v for name, v in own.items()}
        return xarray.Dataset(named, attrs=kept.attrs)
    # Sums of values near the largest float overflow to infinity; the warning of NumPy is suppressed.
    with np.errstate(over="ignore", invalid="ignore"):
        mean, deviation = kept.mean("time"), kept.std("time")
        period = xarray.apply_ufunc(_period, kept, kept["time"], input_core_dims=[["time"], ["time"]])
    most, least = kept.max("time", skipna=False), kept.min("time", skipna=False)
    values = (mean, deviation, 2 * deviation, 4 * deviation, period, most, least)
    names = xarray.DataArray(np.array(STATISTICS), dims="statistic", name="statistic")
    about = {key: value for key, value in kept.attrs.items() if key != "units"}
    found = xarray.concat(values, names).rename(kept.name)
    found.attrs = about
    return found.assign_coords({unit_coordinate(kept.name): _units(kept, names)})


def _with_own_unit(variable: xarray.DataArray) -> xarray.DataArray:
    """Return one variable of a data set, without the unit coordinates of the other variables."""
    ending = unit_coordinate("")
    others = [c for c in variable.coords if str(c).endswith(ending) and c != unit_coordinate(variable.name)]
    return variable.drop_vars(others)


def _units(kept: xarray.DataArray, names: xarray.DataArray) -> xarray.DataArray:
    """The unit of each statistic, and of each component if the units differ."""
    import xarray

    name = unit_coordinate(kept.name)
    unit = kept.coords[name] if name in kept.coords else xarray.DataArray(str(kept.attrs.get("units", "")))
    period = names == "zero_up_crossing_period"
    return xarray.where(period, "s", unit.drop_vars(name, errors="ignore"))


def _period(values: NDArray[np.float64], time_s: NDArray[np.float64]) -> NDArray[np.float64]:
    values = np.ascontiguousarray(values)
    return up_crossing_period(values - values.mean(axis=-1, keepdims=True), time_s)


def up_crossing_period(x: NDArray[np.float64], time_s: NDArray[np.float64]) -> NDArray[np.float64]:
    """Mean time between up-crossings of zero, each on the line between two records; NaN where there are less
    than two.

    Parameters
    ----------
    x
        Shape (..., records), about its mean.
    time_s
        Times of the records, s.

    Returns
    -------
    numpy.ndarray
        Shape (...,), s.

    >>> time_s = np.arange(0.0, 80.0, 0.1)
    >>> round(float(up_crossing_period(np.sin(2 * np.pi * time_s / 8), time_s)), 6)
    8.0
    """
    flat = x.reshape(-1, x.shape[-1])
    crossed = (flat[:, :-1] < 0) & (flat[:, 1:] >= 0)
    count = crossed.sum(axis=1)
    columns = np.arange(len(flat))

    def time_at(at: NDArray[np.intp]) -> NDArray[np.float64]:
        step_s, before, behind = time_s[at + 1] - time_s[at], flat[columns, at], flat[columns, at + 1]
        return time_s[at] - before * step_s / (behind - before)

    first = crossed.argmax(axis=1)
    last = crossed.shape[1] - 1 - crossed[:, ::-1].argmax(axis=1)
    enough = count >= FEWEST_CROSSINGS
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        period_s = np.where(enough, (time_at(last) - time_at(first)) / np.maximum(count - 1, 1), np.nan)
    return period_s.reshape(x.shape[:-1])

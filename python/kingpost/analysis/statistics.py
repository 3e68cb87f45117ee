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

from ..errors import KingpostError
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
    deviation = kept.std("time")
    period = xarray.apply_ufunc(
        _up_crossing_period, kept, kept["time"], input_core_dims=[["time"], ["time"]], vectorize=True
    )
    most, least = kept.max("time", skipna=False), kept.min("time", skipna=False)
    values = (kept.mean("time"), deviation, 2 * deviation, 4 * deviation, period, most, least)
    names = xarray.DataArray(np.array(STATISTICS), dims="statistic", name="statistic")
    about = {key: value for key, value in kept.attrs.items() if key != "units"}
    found = xarray.concat(values, names).rename(kept.name)
    found.attrs = about
    return found.assign_coords({unit_coordinate(kept.name): _units(kept, names)})


def _with_own_unit(variable: xarray.DataArray) -> xarray.DataArray:
    """A variable of a data set without the unit coordinates of the other variables."""
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


def _up_crossing_period(values: NDArray[np.float64], time_s: NDArray[np.float64]) -> float:
    """Mean time between up-crossings of the mean, each interpolated linearly between two records."""
    x = values - values.mean()
    (at,) = np.nonzero((x[:-1] < 0) & (x[1:] >= 0))
    if len(at) < FEWEST_CROSSINGS:
        return np.nan
    crossings = time_s[at] - x[at] * (time_s[at + 1] - time_s[at]) / (x[at + 1] - x[at])
    return float((crossings[-1] - crossings[0]) / (len(at) - 1))


def _reduced(probability: float) -> float:
    if not 0 < probability < 1:
        raise KingpostError(f"probability: found {probability:g}, allowed: between 0 and 1")
    return float(-np.log(-np.log(probability)))


def _half_mean_difference(x: NDArray[np.float64]) -> float:
    """Half the mean of |x_i - x_j| over all pairs: the second L-moment."""
    weights = 2 * np.arange(len(x)) / (len(x) - 1) - 1
    return float((weights * np.sort(x)).mean())

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
        The same type as the input, along ``statistic`` instead of ``time``.

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


<<<<<<< HEAD
=======
def spectrum(
    series: xarray.DataArray, after_s: float = 0.0, segment_s: float | None = None
) -> xarray.DataArray:
    """Spectral density by Welch's method, over the angular frequency ``omega``, rad/s.

    The record, less its mean, is cut into segments that overlap by half; each is multiplied by a Hann
    window and transformed, and the squares are averaged (Welch, *IEEE Trans. Audio Electroacoust.*
    15(2), 1967). The density is one-sided and divided by the mean square of the window, so that its
    integral is the variance except for sampling error.

    Parameters
    ----------
    series
        Evenly spaced over ``time``; other dimensions stay.
    after_s
        Leave out the records before this time, s.
    segment_s
        Length of a segment, s; default: an eighth of the record. The frequencies are 2 pi / segment apart.

    Returns
    -------
    xarray.DataArray
        Along ``omega`` (rad/s), in the square of the unit times s/rad.

    Raises
    ------
    KingpostError
        If the record is uneven or too short for the segment.

    >>> from kingpost import run
    >>> roll = run("paper", {"simulation.duration_s": 0.5})["roll"].sel(body="ship")
    >>> spectrum(roll, segment_s=0.25).dims
    ('omega',)
    """
    import xarray

    kept, step_s = even(after(series, after_s))
    length = round((kept.sizes["time"] * step_s / 8 if segment_s is None else segment_s) / step_s)
    if not 8 <= length <= kept.sizes["time"]:
        allowed = f"from {8 * step_s:g} to {kept.sizes['time'] * step_s:g} s, the record's length"
        raise KingpostError(f"segment_s: found {length * step_s:g} s, allowed: {allowed}")
    axis = kept.get_axis_num("time")
    density = _welch(np.moveaxis(kept.values, axis, -1), step_s, length)
    omega = 2 * np.pi * np.fft.rfftfreq(length, step_s)
    dims = [dim for dim in kept.dims if dim != "time"]
    coordinates = {dim: kept[dim] for dim in dims if dim in kept.coords}
    about = {"units": "rad/s", "long_name": "angular frequency"}
    unit = kept.attrs.get("units", "")
    return xarray.DataArray(
        density,
        {**coordinates, "omega": ("omega", omega, about)},
        (*dims, "omega"),
        kept.name,
        {"units": f"({unit})^2 s/rad", "long_name": f"spectral density of {kept.name}"},
    )


def moments(density: xarray.DataArray, orders: tuple[int, ...] = (0, 1, 2, 4)) -> xarray.DataArray:
    """Spectral moments ``m_n = Int w^n S(w) dw`` by the trapezoidal rule, along the dimension ``order``.

    With them the standard deviation is sqrt(m0), the significant double amplitude 4 sqrt(m0) and the mean
    zero up-crossing period 2 pi sqrt(m0 / m2).

    Parameters
    ----------
    density
        Spectral density from `spectrum`, along ``omega`` (rad/s).
    orders
        The orders n.

    Returns
    -------
    xarray.DataArray
        Along ``order``.

    >>> import xarray
    >>> flat = xarray.DataArray([1.0, 1.0], {"omega": [0.0, 2.0]}, ("omega",))
    >>> moments(flat, (0, 1)).values
    array([2., 2.])
    """
    import xarray

    omega = density["omega"]
    parts = [(density * omega**n).integrate("omega") for n in orders]
    return xarray.concat(parts, xarray.DataArray(np.array(orders), dims="order", name="order"))


@dataclass(frozen=True)
class Extreme:
    """A Gumbel distribution of the largest value in a stated time, P(x) = exp(-exp(-(x - mu) / beta)).

    Attributes
    ----------
    location, scale
        mu, the most probable largest value, and beta.
    duration_s
        The duration to which the largest value belongs, s.
    records
        Number of maxima in the fit.
    covariance
        Covariance of (mu, beta), for this number of records.
    """

    location: float
    scale: float
    duration_s: float
    records: int
    covariance: NDArray[np.float64]

    @property
    def expected(self) -> float:
        """The mean of the largest value."""
        return self.location + EULER * self.scale

    @property
    def expected_error(self) -> float:
        """Its standard error."""
        return self._error(EULER)

    def quantile(self, probability: float) -> float:
        """The value that is exceeded with the probability 1 - `probability`."""
        return self.location + self.scale * _reduced(probability)

    def quantile_error(self, probability: float) -> float:
        """Its standard error."""
        return self._error(_reduced(probability))

    def _error(self, reduced: float) -> float:
        along = np.array([1.0, reduced])
        return float(np.sqrt(along @ self.covariance @ along))


def extreme(maxima: ArrayLike, record_s: float, duration_s: float = THREE_HOURS_S) -> Extreme:
    """Distribution of the largest value in three hours, from the largest values of several runs with
    different seeds.

    A Gumbel distribution is fitted by L-moments: beta is half the mean difference between two records,
    divided by ln 2; mu is the mean less Euler's constant times beta. Both are unbiased for any number of
    records
    (Landwehr, Matalas & Wallis, *Water Resour. Res.* 15(5), 1979; Hosking, *J. R. Stat. Soc. B* 52, 1990),
    while maximum likelihood underestimates beta from five records by a seventh. If a run's record is shorter
    or longer than `duration_s`, mu is moved by beta ln(duration / record): the largest of independent
    Gumbel values is a Gumbel value of the same scale. Use ten runs or more for a useful standard error.

    Parameters
    ----------
    maxima
        The largest value of each run, five or more.
    record_s
        Length of each run without its start, s.
    duration_s
        Duration for which to find the extreme, s.

    Returns
    -------
    Extreme
        The fitted distribution with its standard errors.

    Raises
    ------
    KingpostError
        If there are too few maxima, or a time is not greater than 0.

    Examples
    --------
    >>> rng = np.random.default_rng(1)
    >>> found = extreme(rng.gumbel(7.0, 0.5, 2000), record_s=10800.0)
    >>> bool(abs(found.location - 7.0) < 3 * found.covariance[0, 0] ** 0.5)
    True
    """
    x = np.asarray(maxima, float).ravel()
    if len(x) < 5 or not np.isfinite(x).all():
        raise KingpostError(f"maxima: found {len(x)} values, allowed: 5 or more, all finite")
    if np.ptp(x) == 0:
        raise KingpostError(f"maxima: found {len(x)} times {x[0]:g}, allowed: values that differ, by seed")
    for name, value in (("record_s", record_s), ("duration_s", duration_s)):
        if not (value > 0 and np.isfinite(value)):
            raise KingpostError(f"{name}: found {value:g}, allowed: finite and greater than 0")
    scale = _half_mean_difference(x) / np.log(2)
    location = x.mean() - EULER * scale
    shift = np.log(duration_s / record_s)
    # Covariance of (mean, beta), times n: the mean difference is a U-statistic (Hoeffding, Ann. Math. Stat.
    # 19, 1948).
    n = len(x)
    of_both = np.array([[np.pi**2 / 6, np.log(2)], [np.log(2), (0.804623 * n - 0.185532) / (n - 1)]])
    moved = np.array([[1.0, shift - EULER], [0.0, 1.0]])
    return Extreme(
        location=float(location + scale * shift),
        scale=float(scale),
        duration_s=float(duration_s),
        records=len(x),
        covariance=moved @ (of_both * scale**2 / n) @ moved.T,
    )


@overload
def after(series: xarray.DataArray, after_s: float) -> xarray.DataArray: ...
@overload
def after(series: xarray.Dataset, after_s: float) -> xarray.Dataset: ...
def after(series: xarray.Dataset | xarray.DataArray, after_s: float) -> xarray.Dataset | xarray.DataArray:
    """The records from this time on.

    Parameters
    ----------
    series
        With a dimension ``time``, s.
    after_s
        The first kept time, s.

    Returns
    -------
    xarray.Dataset or xarray.DataArray
        The same type as the input.

    Raises
    ------
    KingpostError
        If there is no time, or fewer than two records are left.

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
    """A record with its step, s; a last row that is not on the grid is left out.

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
        If its steps differ.

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


def _welch(values: NDArray[np.float64], step_s: float, length: int) -> NDArray[np.float64]:
    """One-sided density over the angular frequency, along the last axis."""
    window = np.hanning(length + 1)[:-1]
    values = values - values.mean(axis=-1, keepdims=True)
    starts = range(0, values.shape[-1] - length + 1, max(length // 2, 1))
    power = sum(np.abs(np.fft.rfft(values[..., at : at + length] * window)) ** 2 for at in starts) / len(
        starts
    )
    sides = np.full(length // 2 + 1, 2.0)
    sides[0] = 1.0
    if length % 2 == 0:
        sides[-1] = 1.0
    return power * sides * step_s / (window**2).sum() / (2 * np.pi)


>>>>>>> words-views
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

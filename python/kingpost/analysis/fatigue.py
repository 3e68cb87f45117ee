"""Fatigue from records of tension or stress: rainflow counts, damage sums, equivalent ranges.

A component fails when sum(n_i / N(S_i)) is 1, with n_i cycles of the range S_i and an S-N curve N(S) = a
S^-m (Palmgren 1924; Miner, *J. Appl. Mech.* 12, 1945). What is computed here is the damage sum D = sum(n_i
S_i^m), in the unit of the record to the power m: divided by a it is the share of the life that was used.
The library `rainflow` counts cycles as ASTM E1049-85 (5.4.4) does; a cycle that does not close counts a
half.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..errors import KingpostError
from .statistics import after

if TYPE_CHECKING:
    import xarray
    from numpy.typing import ArrayLike, NDArray

SLOPES = (3.0, 5.0)
"""Slopes m that sums are of unless given: those of the two branches of many S-N curves of steel."""
MOST_FACTORS = 32
"""Powers up to this are products, which have the same bits everywhere."""


@dataclass(frozen=True)
class Cycles:
    """Cycles of a record.

    Attributes
    ----------
    ranges, means
        From valley to peak, and half way between, in the unit of the record.
    counts
        1 of a cycle that closes, 0.5 of one that does not.
    """

    ranges: NDArray[np.float64]
    means: NDArray[np.float64]
    counts: NDArray[np.float64]

    @property
    def count(self) -> float:
        """How many cycles there are."""
        return float(self.counts.sum())

    def damage(self, slope: float) -> float:
        """sum(n_i S_i^m), in the unit of the record to the power m.

        >>> rainflow([0, 2, 0, 2, 0]).damage(3)
        16.0
        """
        if not (slope > 0 and math.isfinite(slope)):
            raise KingpostError(f"slope: found {slope:g}, allowed: finite and greater than 0")
        return float((self.counts * _power(self.ranges, float(slope))).sum())

    def equivalent_range(self, slope: float, cycles: float | None = None) -> float:
        """The range of which as many cycles, or `cycles` of them, have the same damage: (D / n)^(1 / m).

        >>> rainflow([0, 2, 0, 2, 0]).equivalent_range(3)
        2.0
        """
        count = self.count if cycles is None else cycles
        if not (count > 0 and math.isfinite(count)):
            raise KingpostError(f"cycles: found {count:g}, allowed: finite and greater than 0")
        # Of a share of the largest range, so that a high power does not overflow.
        largest = self.ranges.max(initial=0.0)
        if largest == 0:
            return 0.0
        return float(
            largest * (((self.ranges / largest) ** slope * self.counts).sum() / count) ** (1 / slope)
        )


def _power(x: NDArray[np.float64], exponent: float) -> NDArray[np.float64]:
    """A power; of a whole number a product: powers of libraries differ in their last bit by processor."""
    if exponent.is_integer() and exponent <= MOST_FACTORS:
        return np.prod(np.repeat(x[None, :], int(exponent), axis=0), axis=0)
    return x**exponent


def rainflow(values: ArrayLike) -> Cycles:
    """The cycles of a record by rainflow counting.

    Parameters
    ----------
    values
        A record in the order of time; the steps do not matter.

    Returns
    -------
    Cycles
        Ranges, means and counts; none where nothing changes.

    Raises
    ------
    KingpostError
        When the record has less than two values, or NaN.

    >>> found = rainflow([-2, 1, -3, 5, -1, 3, -4, 4, -2])
    >>> found.ranges.tolist(), found.count
    ([3.0, 4.0, 4.0, 8.0, 9.0, 8.0, 6.0], 4.0)
    """
    from rainflow import extract_cycles

    record = np.asarray(values, float).ravel()
    if len(record) < 2 or not np.isfinite(record).all():
        bad = np.count_nonzero(~np.isfinite(record))
        raise KingpostError(
            f"values: found {len(record)}, of them {bad} NaN, allowed: two or more, all finite"
        )
    # The library walks in Python: between reversals there is nothing for it.
    steps = np.diff(record)
    kept = record[np.concatenate([[True], steps != 0])]
    if len(kept) < 2:
        return Cycles(*np.empty((3, 0)))
    turns = np.sign(np.diff(kept))
    turning = kept[np.concatenate([[True], turns[1:] != turns[:-1], [True]])]
    if len(turning) == 2:
        # The library takes three values or more; what lies between is no reversal.
        turning = np.insert(turning, 1, turning.mean())
    found = np.array([cycle[:3] for cycle in extract_cycles(turning.tolist())]).reshape(-1, 3)
    return Cycles(*found.T)


def damage(
    series: xarray.DataArray, slopes: Sequence[float] = SLOPES, after_s: float = 0.0
) -> xarray.DataArray:
    """Damage sums of a column over time, of each run, along the dimension ``slope``.

    Parameters
    ----------
    series
        With a dimension ``time``, s; other dimensions stay.
    slopes
        m of each sum.
    after_s
        Records before this time, s, are left out.

    Returns
    -------
    xarray.DataArray
        Along ``slope``; NaN of a run that has NaN. The coordinate ``cycles`` says how many there are in
        each run, the attribute ``duration_s`` how long a record is.

    Raises
    ------
    KingpostError
        When a slope is not greater than 0, or less than two records are left.

    >>> import xarray
    >>> time = np.arange(0.0, 102.1, 0.5)
    >>> tension = xarray.DataArray(np.cos(np.pi * time / 2), {"time": time}, ("time",), "rope_tension")
    >>> round(damage(tension, (3,), after_s=2.0).item(), 9) # 25 cycles of the range 2
    200.0
    """
    import xarray

    for slope in slopes:
        Cycles(*np.empty((3, 0))).damage(slope)
    kept = after(series, after_s)

    def one(values: NDArray[np.float64]) -> NDArray[np.float64]:
        if not np.isfinite(values).all():
            return np.full(len(slopes) + 1, np.nan)
        cycles = rainflow(values)
        return np.array([cycles.count, *(cycles.damage(slope) for slope in slopes)])

    found = xarray.apply_ufunc(
        one, kept, input_core_dims=[["time"]], output_core_dims=[["slope"]], vectorize=True
    )
    sums = found.isel(slope=slice(1, None)).assign_coords(
        slope=np.asarray(slopes, float), cycles=found.isel(slope=0, drop=True)
    )
    time = kept["time"].values
    unit = series.attrs.get("units", "")
    sums.attrs = {
        "units": f"({unit})^m",
        "long_name": f"damage sum of {series.name}",
        "duration_s": float(time[-1] - time[0]),
    }
    return sums.rename(f"{series.name}_damage")


def expected(sums: ArrayLike, record_s: float, duration_s: float) -> tuple[float, float]:
    """The damage sum of a time, from those of several runs, and its standard error over their seeds.

    Damage grows with time as the sea stays: the mean over runs times duration / record.

    Parameters
    ----------
    sums
        Damage sum of each run, two or more.
    record_s, duration_s
        How long a run is without its start, and the time to find the damage of, s.

    Returns
    -------
    tuple of float and float
        The mean and its standard error.

    Raises
    ------
    KingpostError
        When there are too few runs, or a time is not greater than 0.

    >>> expected([1.0, 3.0], 600.0, 1200.0)
    (4.0, 2.0)
    """
    of_runs = np.asarray(sums, float).ravel()
    if len(of_runs) < 2 or not np.isfinite(of_runs).all():
        raise KingpostError(f"sums: found {len(of_runs)} values, allowed: 2 or more, all finite")
    for name, value in (("record_s", record_s), ("duration_s", duration_s)):
        if not (value > 0 and math.isfinite(value)):
            raise KingpostError(f"{name}: found {value:g}, allowed: finite and greater than 0")
    share = duration_s / record_s
    return float(share * of_runs.mean()), float(share * of_runs.std(ddof=1) / np.sqrt(len(of_runs)))


def narrow_band(
    standard_deviation: float, up_crossing_period_s: float, duration_s: float, slope: float
) -> float:
    """The damage sum of a Gaussian process with a narrow band: T / Tz (2 sqrt(2) sigma)^m Gamma(1 + m / 2).

    Its ranges are twice its peaks, which have a Rayleigh distribution (Miles, *J. Aeronaut. Sci.* 21, 1954;
    Wirsching & Light, *J. Struct. Div.* 106, 1980). Of a broad band it is too high.

    Parameters
    ----------
    standard_deviation
        sigma.
    up_crossing_period_s
        Tz, the mean zero up-crossing period, s.
    duration_s
        T, s.
    slope
        m.

    Returns
    -------
    float
        In the unit of sigma to the power m.

    >>> round(narrow_band(1.0, 10.0, 100.0, 2), 9) # 10 cycles, mean square range 8 sigma^2
    80.0
    """
    cycles = duration_s / up_crossing_period_s
    return float(cycles * (2 * math.sqrt(2) * standard_deviation) ** slope * math.gamma(1 + slope / 2))

"""A Gumbel distribution of the largest value of each run."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from statistics import NormalDist
from typing import TYPE_CHECKING

import numpy as np

from ...errors import KingpostError
from .moments import jackknife, l_moments, without_each

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

THREE_HOURS_S = 10800.0
EULER = 0.5772156649015329
"""Euler's constant: the mean of the standard Gumbel distribution."""

SEED = 20120
"""Seed of the samples that calibrate the intervals; their generator is counter-based (Philox)."""
DRAWN, FEWEST_SAMPLES, MOST_SAMPLES = 2_000_000, 1000, 20_000
"""Random numbers drawn for a calibration, and the least and the largest number of samples that they form."""
MOST_RECORDS = 500
"""Largest number of records with sampled percentiles; above it they are those of the normal distribution."""
REDUCED = np.arange(-3.0, 16.01, 0.25)
"""Reduced variates, -ln(-ln P), of the table of a calibration."""


@dataclass(frozen=True)
class Extreme:
    """Gumbel distribution of the largest value in a given duration, P(x) = exp(-exp(-(x - mu) / beta)).

    Attributes
    ----------
    location, scale
        mu, the most probable largest value, and beta.
    duration_s
        Duration in which the value is the largest, s.
    records
        Maxima to which the distribution was fitted.
    covariance
        Covariance of (mu, beta) for this number of maxima of a Gumbel distribution.
    record_s
        Length of the record of each maximum, s.
    scatter
        Covariance of (mu, beta) by the jackknife from the maxima.

    Notes ----- An interval is x + t s. Its s is the jackknife's standard error, from the fits that leave
    out one record. Its t are the percentiles of (true - x) / s, found for this number of records by sampling
    a Gumbel distribution; mu and beta cancel in the ratio (a studentised bootstrap: Hall, *Ann. Stat.* 16,
    1988, p. 927). For Gumbel samples the confidence holds for any number of records. For maxima of a Gaussian
    process, which scatter less, s adapts: 90 % are 89 to 90 % from 5 to 20 records, where Student's t with
    the same s covers 80 to 86 %, and the covariance of Gumbel samples with normal percentiles 84 to 91 %.
    An interval does not contain the error of the assumed distribution: for a Gaussian process, extrapolated
    to three times the length of the records, the quantile 0.9 is 1 % too high, which lowers the confidence
    from 40 records on (85 %).
    """

    location: float
    scale: float
    duration_s: float
    records: int
    covariance: NDArray[np.float64]
    record_s: float
    scatter: NDArray[np.float64]

    @property
    def expected(self) -> float:
        """Expected largest value."""
        return self.location + EULER * self.scale

    @property
    def expected_error(self) -> float:
        """Standard error of that."""
        return self._error(EULER)

    def expected_interval(self, confidence: float = 0.9) -> tuple[float, float]:
        """Confidence interval of the expected largest value."""
        low, high = self._limits(np.array([EULER]), confidence)
        return float(low[0]), float(high[0])

    def quantile(self, probability: float) -> float:
        """Return the level that is exceeded with the probability 1 - `probability`."""
        return self.location + self.scale * _reduced(probability)

    def quantile_error(self, probability: float) -> float:
        """Standard error of that."""
        return self._error(_reduced(probability))

    def interval(self, probability: float, confidence: float = 0.9) -> tuple[float, float]:
        """Two-sided confidence interval of a quantile, with equal probabilities below and above.

        >>> found = extreme(np.random.default_rng(1).gumbel(7.0, 0.5, 10), record_s=600.0, duration_s=600.0)
        >>> low, high = found.interval(0.9)
        >>> low < found.quantile(0.9) < high
        True
        """
        low, high = self._limits(np.array([_reduced(probability)]), confidence)
        return float(low[0]), float(high[0])

    def exceedance(self, level: float) -> float:
        """Probability that the largest value exceeds `level`."""
        with np.errstate(over="ignore"):
            return float(-np.expm1(-np.exp(-(level - self.location) / self.scale)))

    def exceedance_interval(self, level: float, confidence: float = 0.9) -> tuple[float, float]:
        """Confidence interval of this probability: the smallest and the largest P whose interval of the
        quantile 1 - P contains `level`.

        >>> found = extreme(np.random.default_rng(1).gumbel(7.0, 0.5, 10), record_s=600.0, duration_s=600.0)
        >>> low, high = found.exceedance_interval(found.quantile(0.9))
        >>> low < 0.1 < high
        True
        """
        shift = np.log(self.duration_s / self.record_s)
        reduced = REDUCED - shift
        low, high = self._limits(reduced, confidence)
        reached, passed = np.flatnonzero(high >= level), np.flatnonzero(low <= level)
        if not (len(reached) and len(passed)):
            return (0.0, 0.0) if len(passed) else (1.0, 1.0)
        first, last = reached[0], passed[-1]
        least = -np.inf if first == 0 else _crossing(reduced, high, first, level)
        most = np.inf if last == len(reduced) - 1 else _crossing(reduced, low, last + 1, level)
        with np.errstate(over="ignore"):
            return float(-np.expm1(-np.exp(-most))), float(-np.expm1(-np.exp(-least)))

    def _error(self, reduced: float) -> float:
        along = np.array([1.0, reduced])
        return float(np.sqrt(along @ self.covariance @ along))

    def _limits(
        self, reduced: NDArray[np.float64], confidence: float
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        if not 0 < confidence < 1:
            raise KingpostError(f"confidence: found {confidence:g}, allowed: between 0 and 1")
        along = np.stack([np.ones_like(reduced), reduced], axis=-1)
        error = np.sqrt(np.einsum("ia,ab,ib->i", along, self.scatter, along))
        of_record = reduced + np.log(self.duration_s / self.record_s)
        low, high = (np.interp(of_record, REDUCED, of) for of in _percentiles(self.records, confidence))
        value = self.location + self.scale * reduced
        return value + low * error, value + high * error


def extreme(maxima: ArrayLike, record_s: float, duration_s: float = THREE_HOURS_S) -> Extreme:
    """Estimate the largest value in three hours from the maxima of several runs with different seeds.

    A Gumbel distribution is fitted by L-moments: beta is half the mean difference between two records over
    ln 2, mu the mean less Euler's constant times beta. Both are unbiased for any number of records
    (Landwehr, Matalas & Wallis, *Water Resour. Res.* 15(5), 1979; Hosking, *J. R. Stat. Soc. B* 52, 1990),
    whereas maximum likelihood underestimates beta of five records by a seventh. Where a run's record is
    shorter or longer than `duration_s`, mu is moved by beta ln(duration / record): the largest of independent
    Gumbel values is a Gumbel value of the same scale. Use ten runs or more for a useful error estimate.

    Parameters
    ----------
    maxima
        The largest value of each run, five or more.
    record_s
        Length of each run without its start, s.
    duration_s
        Duration for which to find the extreme, s: three hours, or the duration of the operation.

    Returns
    -------
    Extreme
        The fitted distribution with its standard errors and intervals.

    Raises
    ------
    KingpostError
        When there are too few maxima, or a time is not greater than 0.

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
    shift = np.log(duration_s / record_s)
    location, scale = _fitted(l_moments(x), shift)
    # Covariance of (mean, beta) times n: the mean difference is a U-statistic (Hoeffding, Ann. Math. Stat.
    # 19, 1948).
    n = len(x)
    of_both = np.array([[np.pi**2 / 6, np.log(2)], [np.log(2), (0.804623 * n - 0.185532) / (n - 1)]])
    moved = np.array([[1.0, shift - EULER], [0.0, 1.0]])
    return Extreme(
        location=float(location),
        scale=float(scale),
        duration_s=float(duration_s),
        records=len(x),
        covariance=moved @ (of_both * scale**2 / n) @ moved.T,
        record_s=float(record_s),
        scatter=jackknife(_fitted(without_each(x), shift)),
    )


def _fitted(moments: NDArray[np.float64], shift: float = 0.0) -> NDArray[np.float64]:
    """mu and beta from both L-moments, along the last axis."""
    scale = moments[..., 1] / np.log(2)
    return np.stack([moments[..., 0] + (shift - EULER) * scale, scale], axis=-1)


@lru_cache(maxsize=64)
def _percentiles(records: int, confidence: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return percentiles of (true - estimate) / standard error, by `REDUCED`, below and above an interval."""
    sides = (0.5 - confidence / 2, 0.5 + confidence / 2)
    if records > MOST_RECORDS:
        above = np.full(len(REDUCED), NormalDist().inv_cdf(sides[1]))
        return -above, above
    samples = int(np.clip(DRAWN // records, FEWEST_SAMPLES, MOST_SAMPLES))
    drawn = np.random.Generator(np.random.Philox(SEED)).gumbel(size=(samples, records))
    location, scale = _fitted(l_moments(drawn)).T
    without = _fitted(without_each(drawn))
    off = without - without.mean(axis=1, keepdims=True)
    variances = (records - 1) / records * np.einsum("sia,sib->sab", off, off)
    found = []
    for reduced in REDUCED:
        along = np.array([1.0, reduced])
        error = np.sqrt(np.einsum("a,sab,b->s", along, variances, along))
        found.append(np.quantile((reduced - location - scale * reduced) / error, sides))
    low, high = np.array(found).T
    return low, high


def _crossing(
    at: NDArray[np.float64], values: NDArray[np.float64], second: np.intp, level: float
) -> np.float64:
    """Position at which the line between two points reaches `level`."""
    share = (level - values[second - 1]) / (values[second] - values[second - 1])
    return at[second - 1] + share * (at[second] - at[second - 1])


def _reduced(probability: float) -> float:
    if not 0 < probability < 1:
        raise KingpostError(f"probability: found {probability:g}, allowed: between 0 and 1")
    return float(-np.log(-np.log(probability)))

"""Largest value in a given duration from the tail of the peaks: peaks over a threshold and their excess."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from ...errors import KingpostError
from .moments import jackknife, without_groups

if TYPE_CHECKING:
    from numpy.typing import NDArray

DISTRIBUTIONS = ("generalised_pareto", "exponential", "weibull")
SEED, SAMPLES = 20121, 1000
"""Seed and number of the samples that calibrate the intervals; the generator is counter-based (Philox)."""


@dataclass(frozen=True)
class TailExtreme:
    """Distribution of the largest value in a given duration, from the peaks over a threshold.

    With `rate` peaks over the threshold u in a second, each above x with the probability S(x), the largest
    of the duration T is below x with the probability exp(-rate T S(x)): peaks that are rare form a Poisson
    process (Coles, *An Introduction to Statistical Modeling of Extreme Values*, 2001, ch. 7). S(x) is

    - generalised Pareto: (1 + shape (x - u) / scale)^(-1 / shape);
    - exponential: exp(-(x - u) / scale);
    - Weibull: exp((u - m)^shape / scale^shape - (x - m)^shape / scale^shape) about the mean m.

    Attributes
    ----------
    distribution
        One of `DISTRIBUTIONS`.
    threshold, mean
        u, and m; NaN if there is none.
    duration_s
        Duration in which the value is the largest, s.
    runs, count
        Number of runs, and of their peaks over the threshold.
    fits
        Rows of rate (1/s), scale and, unless exponential, shape: of all runs, then without each group of
        runs. The number of groups is the number of runs, at most `MOST_GROUPS`.
    """

    distribution: str
    threshold: float
    mean: float
    duration_s: float
    runs: int
    count: int
    fits: NDArray[np.float64]

    @property
    def parameters(self) -> dict[str, float]:
        """Rate (1/s), scale and shape, of all runs."""
        return dict(zip(("rate_per_s", "scale", "shape"), map(float, self.fits[0]), strict=False))

    @property
    def most_probable(self) -> float:
        """Level that one peak in the duration exceeds on average: nearly the mode of the largest value."""
        return self.quantile(float(np.exp(-1)))

    def quantile(self, probability: float) -> float:
        """Return the level that the largest value exceeds with the probability 1 - `probability`.

        Raises
        ------
        KingpostError
            When it would be below the threshold.
        """
        return float(self._quantiles(probability)[0])

    def exceedance(self, level: float) -> float:
        """Probability that the largest value exceeds `level`; `level` must not be below the threshold."""
        if level < self.threshold:
            raise KingpostError(f"level: found {level:g}, allowed: the threshold {self.threshold:g} or more")
        tail = _tail(self.distribution, self.fits[:1], self.threshold, self.mean)
        return float(-np.expm1(-self.fits[0, 0] * self.duration_s * tail.sf(level)[0]))

    def interval(self, probability: float, confidence: float = 0.9) -> tuple[float, float]:
        """Two-sided confidence interval of a quantile, with equal probabilities below and above.

        It is x + t s, with s the jackknife's over groups of runs. For tails that begin at the threshold t are
        the percentiles of (true - x) / s where the tail is exponential, found by sampling as many peaks in as
        many groups; for the Weibull distribution those of Student's t with one degree of freedom less than
        groups.

        >>> from kingpost.analysis.extremes import weibull
        >>> rng = np.random.default_rng(1)
        >>> runs = [rng.rayleigh(1.0, 75) for _ in range(10)]
        >>> found = weibull(runs, record_s=600.0, duration_s=1800.0)
        >>> low, high = found.interval(0.9)
        >>> bool(low < np.sqrt(2 * np.log(225 / -np.log(0.9))) < high)
        True
        """
        if not 0 < confidence < 1:
            raise KingpostError(f"confidence: found {confidence:g}, allowed: between 0 and 1")
        values = self._quantiles(probability)
        groups = len(values) - 1
        error = float(np.sqrt(jackknife(values[1:])))
        if self.distribution == "weibull":
            from scipy import stats

            high = float(stats.t.ppf(0.5 + confidence / 2, groups - 1))
            return values[0] - high * error, values[0] + high * error
        # Two digits of the count and of the probability are accurate enough for percentiles.
        count = float(f"{self.count:.2g}")
        peaks_below = float(f"{self.fits[0, 0] * self.duration_s / -np.log(probability):.2g}")
        low, high = _percentiles(self.distribution, groups, count, peaks_below, confidence)
        return values[0] + low * error, values[0] + high * error

    def _quantiles(self, probability: float) -> NDArray[np.float64]:
        """Return the quantile of all runs, then those without each group of runs."""
        if not 0 < probability < 1:
            raise KingpostError(f"probability: found {probability:g}, allowed: between 0 and 1")
        expected = self.fits[:, 0] * self.duration_s
        if -np.log(probability) >= expected[0]:
            allowed = f"more than {np.exp(-expected[0]):.3g}, at which the largest value is the threshold"
            raise KingpostError(f"probability: found {probability:g}, allowed: {allowed}")
        share = np.minimum(-np.log(probability) / expected, 1.0)
        return _tail(self.distribution, self.fits, self.threshold, self.mean).isf(share)


def of_excess(distribution: str, moments: NDArray[np.float64]) -> NDArray[np.float64]:
    """Scale and shape from both L-moments of the peaks' excess over the threshold, along the last axis."""
    first, second = moments[..., 0], moments[..., 1]
    if distribution == "exponential":
        return first[..., None]
    shape = 2 - first / second
    return np.stack([first * (1 - shape), shape], axis=-1)


def _tail(distribution: str, fits: NDArray[np.float64], threshold: float, mean: float) -> Any:
    """scipy's distribution of peaks over the threshold, one for each fit."""
    from scipy import stats

    scale = fits[..., 1]
    if distribution == "exponential":
        return stats.expon(threshold, scale)
    if distribution == "generalised_pareto":
        return stats.genpareto(fits[..., 2], threshold, scale)
    return _Truncated(fits[..., 2], scale, threshold, mean)


@dataclass(frozen=True)
class _Truncated:
    """A Weibull distribution above a threshold."""

    shape: NDArray[np.float64]
    scale: NDArray[np.float64]
    threshold: float
    mean: float

    def _whole(self) -> Any:
        from scipy import stats

        return stats.weibull_min(self.shape, self.mean, self.scale)

    def sf(self, level: float) -> NDArray[np.float64]:
        return np.exp(self._whole().logsf(level) - self._whole().logsf(self.threshold))

    def isf(self, share: NDArray[np.float64]) -> NDArray[np.float64]:
        return self._whole().isf(share * self._whole().sf(self.threshold))


@lru_cache(maxsize=256)
def _percentiles(
    distribution: str, groups: int, count: float, peaks_below: float, confidence: float
) -> tuple[float, float]:
    """Return two percentiles of (true - estimate) / standard error for exponential peaks above 0, of scale 1.

    `count` is the expected number of peaks in all groups; one peak in `peaks_below` exceeds the quantile.
    """
    rng = np.random.Generator(np.random.Philox(SEED))
    true = np.log(peaks_below)
    of_group = rng.poisson(count / groups, (SAMPLES, groups))
    found = np.array(
        [
            without_groups(rng.exponential(size=each.sum()), np.repeat(np.arange(groups), each), groups)
            for each in of_group
            if each.sum() - each.max() > 2
        ]
    )
    expected = found[..., 0] * peaks_below / count
    expected[:, 1:] *= groups / (groups - 1)
    fits = np.concatenate([found[..., :1], of_excess(distribution, found[..., 1:])], axis=-1)
    values = _tail(distribution, fits, 0.0, np.nan).isf(np.minimum(1 / expected, 1.0))
    error = np.sqrt(np.var(values[:, 1:], axis=1) * (groups - 1))
    low, high = np.nanquantile((true - values[:, 0]) / error, (0.5 - confidence / 2, 0.5 + confidence / 2))
    return float(low), float(high)

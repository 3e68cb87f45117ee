"""Largest value of an operation that happens once, from the order statistics of its realisations."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ...errors import KingpostError

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


@dataclass(frozen=True)
class OneOff:
    """Distribution of the largest value of an operation that happens once, without an assumed form.

    Each realisation (a seed) gives one value, and nothing is extrapolated to another duration. All
    estimates are order statistics, so they hold for any continuous distribution, bounded or not.

    Attributes
    ----------
    maxima
        The largest value of each realisation, rising.
    """

    maxima: NDArray[np.float64]

    @property
    def realisations(self) -> int:
        """Number of realisations."""
        return len(self.maxima)

    def quantile(self, probability: float) -> float:
        """Return the level that is exceeded with the probability 1 - `probability`.

        It is linear between the order statistics, at the place (n + 1/3) p + 1/3 (median-unbiased for any
        continuous distribution: Hyndman & Fan, *Am. Stat.* 50, 1996, p. 361, definition 8).

        Raises
        ------
        KingpostError
            When it lies outside of the realisations, of which there are too few.

        >>> one_off([1.0, 2.0, 3.0, 4.0]).quantile(0.5)
        2.5
        """
        _check(probability)
        n = self.realisations
        at = (n + 1 / 3) * probability + 1 / 3
        if not 1 <= at <= n:
            fewest = seeds_for_quantile(min(probability, 1 - probability))
            raise KingpostError(
                f"realisations: found {n}, allowed: {fewest} or more for the quantile {probability:g}"
            )
        return float(np.interp(at, np.arange(1, n + 1), self.maxima))

    def interval(self, probability: float, confidence: float = 0.9) -> tuple[float, float]:
        """Two-sided confidence interval of a quantile, with equal probabilities below and above.

        The number of values below the quantile is binomial, so an order statistic is a limit with a known
        confidence (David & Nagaraja, *Order Statistics*, 2003, ch. 7.1). Between two of them the limit is
        interpolated (Nyblom, *Stat. Probab. Lett.* 14, 1992, p. 129). With too few realisations an end is
        infinite: `seeds_for_interval`.

        >>> low, high = one_off(np.random.default_rng(1).gumbel(size=40)).interval(0.9)
        >>> bool(low < 2.25 < high)
        True
        >>> one_off([1.0, 2.0, 3.0]).interval(0.9)[1]
        inf
        """
        _check(probability)
        _check(confidence, "confidence")
        one_sided = 0.5 + confidence / 2
        high = _upper_limit(self.maxima, probability, one_sided)
        return -_upper_limit(-self.maxima[::-1], 1 - probability, one_sided), high

    def exceedance(self, level: float) -> float:
        """Probability that the largest value exceeds `level`, by the places of `quantile`: 0 from the largest
        realisation on, 1 below the least.

        >>> found = one_off([1.0, 2.0, 3.0, 4.0])
        >>> round(found.exceedance(found.quantile(0.6)), 12), found.exceedance(4.0)
        (0.4, 0.0)
        """
        if level >= self.maxima[-1] or level < self.maxima[0]:
            return float(level < self.maxima[0])
        n = self.realisations
        at = float(np.interp(level, self.maxima, np.arange(1, n + 1)))
        return 1 - (at - 1 / 3) / (n + 1 / 3)

    def exceedance_interval(self, level: float, confidence: float = 0.9) -> tuple[float, float]:
        """Two-sided confidence interval of this probability, from the number of realisations that exceed
        `level` (Clopper & Pearson, *Biometrika* 26, 1934, p. 404).

        >>> one_off([1.0, 2.0, 3.0]).exceedance_interval(5.0)[0]
        0.0
        """
        from scipy import stats

        _check(confidence, "confidence")
        n = self.realisations
        above = n - int(np.searchsorted(self.maxima, level, side="right"))
        outside = 0.5 - confidence / 2
        low = stats.beta.ppf(outside, above, n - above + 1) if above else 0.0
        high = stats.beta.ppf(1 - outside, above + 1, n - above) if above < n else 1.0
        return float(low), float(high)


def one_off(maxima: ArrayLike) -> OneOff:
    """Make the distribution of the largest value of an operation that happens once.

    Parameters
    ----------
    maxima
        The largest value of each realisation, two or more.

    Returns
    -------
    OneOff
        The distribution.

    Raises
    ------
    KingpostError
        When there are fewer, or one is not finite.

    >>> one_off([3.0, 1.0, 2.0]).maxima.tolist()
    [1.0, 2.0, 3.0]
    """
    x = np.sort(np.asarray(maxima, float).ravel())
    if len(x) < 2 or not np.isfinite(x).all():
        raise KingpostError(f"maxima: found {len(x)} values, allowed: 2 or more, all finite")
    return OneOff(x)


def seeds_without_exceedance(probability: float, confidence: float = 0.9) -> int:
    """Number of seeds that, if none exceeds a limit, show an exceedance probability of at most `probability`.

    It is the least n with (1 - p)^n <= 1 - c, ln(1 - c) / ln(1 - p) rounded up (Wilks, *Ann. Math. Stat.*
    12, 1941, p. 91).

    Parameters
    ----------
    probability
        p, of an exceedance in one operation.
    confidence
        c.

    Returns
    -------
    int
        The number of seeds.

    >>> seeds_without_exceedance(0.1), seeds_without_exceedance(0.05, 0.95)
    (22, 59)
    """
    _check(probability)
    _check(confidence, "confidence")
    return _at_least(math.log1p(-confidence) / math.log1p(-probability))


def seeds_for_interval(probability: float, confidence: float = 0.9) -> int:
    """Number of seeds from which the quantile 1 - `probability` has a two-sided interval with finite ends.

    Parameters
    ----------
    probability
        Probability of an exceedance in one operation.
    confidence
        Confidence of the interval.

    Returns
    -------
    int
        The number of seeds.

    >>> seeds_for_interval(0.1), seeds_for_interval(0.5)
    (29, 5)
    """
    return seeds_without_exceedance(probability, 0.5 + confidence / 2)


def seeds_for_quantile(probability: float) -> int:
    """Number of seeds from which the quantile 1 - `probability` lies inside of the realisations, by the
    place of `OneOff.quantile`.

    Parameters
    ----------
    probability
        Probability of an exceedance in one operation.

    Returns
    -------
    int
        The number of seeds.

    >>> seeds_for_quantile(0.1)
    7
    """
    _check(probability)
    return max(2, _at_least((2 - probability) / (3 * probability)))


def _upper_limit(rising: NDArray[np.float64], probability: float, confidence: float) -> float:
    """Upper limit of a quantile with a one-sided confidence, by interpolated order statistics."""
    from scipy import stats

    n = len(rising)
    # The confidence of the order statistic k + 1: at most k values lie below the quantile.
    covers = stats.binom.cdf(np.arange(n), n, probability)
    enough = np.flatnonzero(covers >= confidence)
    if not len(enough):
        return math.inf
    k = int(enough[0])
    if k == 0:
        return float(rising[0])
    over, under = covers[k] - confidence, confidence - covers[k - 1]
    share = 1 / (1 + k * (1 - probability) * over / ((n - k) * probability * under))
    return float(rising[k - 1] + share * (rising[k] - rising[k - 1]))


def _at_least(number: float) -> int:
    """The least whole number that is not below a number, except for its rounding."""
    return math.ceil(number * (1 - 1e-12))


def _check(value: float, name: str = "probability") -> None:
    if not 0 < value < 1:
        raise KingpostError(f"{name}: found {value:g}, allowed: between 0 and 1")

"""Largest value of several independent parts of an operation."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np

ITERATIONS = 100
"""Bisections of a level, each of which halves an interval of double precision."""


class Largest(Protocol):
    """Distribution of the largest value of a part."""

    def quantile(self, probability: float) -> float:
        """Return the level that is exceeded with the probability 1 - `probability`."""

    def interval(self, probability: float, confidence: float = 0.9) -> tuple[float, float]:
        """Two-sided confidence interval of a quantile."""

    def exceedance(self, level: float) -> float:
        """Probability that the largest value exceeds `level`."""

    def exceedance_interval(self, level: float, confidence: float = 0.9) -> tuple[float, float]:
        """Two-sided confidence interval of this probability."""


@dataclass(frozen=True)
class Constant:
    """Largest value that is the same in all realisations.

    Attributes
    ----------
    value
        The value.
    """

    value: float

    def quantile(self, probability: float) -> float:
        """Return the value."""
        return self.value

    def interval(self, probability: float, confidence: float = 0.9) -> tuple[float, float]:
        """Return the value twice."""
        return self.value, self.value

    def exceedance(self, level: float) -> float:
        """Probability that the value exceeds `level`, 1 or 0."""
        return float(self.value > level)

    def exceedance_interval(self, level: float, confidence: float = 0.9) -> tuple[float, float]:
        """Return this probability twice."""
        return self.exceedance(level), self.exceedance(level)


@dataclass(frozen=True)
class Joined:
    """Distribution of the largest value of an operation from those of its parts: the product of their
    distributions, P(x) = P_1(x) P_2(x) ....

    Parts are independent given the sea state. If one part governs, the interval is that of this part; if
    several contribute, it takes the same end of each and covers more often than its confidence says.

    Attributes
    ----------
    parts
        Distributions of the largest value of each part.
    scale
        Range of the realisations, in which levels are searched.
    """

    parts: Sequence[Largest]
    scale: tuple[float, float]

    def exceedance(self, level: float) -> float:
        """Probability that the largest value exceeds `level`."""
        return _either(part.exceedance(level) for part in self.parts)

    def exceedance_interval(self, level: float, confidence: float = 0.9) -> tuple[float, float]:
        """Confidence interval of this probability, from those of the parts."""
        ends = [part.exceedance_interval(level, confidence) for part in self.parts]
        return _either(low for low, _ in ends), _either(high for _, high in ends)

    def quantile(self, probability: float) -> float:
        """Return the level that is exceeded with the probability 1 - `probability`.

        >>> from kingpost.analysis.extremes import extreme, one_off
        >>> x = np.random.default_rng(1).gumbel(7.0, 0.5, 20)
        >>> hold = extreme(x, record_s=60.0, duration_s=600.0)
        >>> both = Joined((one_off(x - 9), hold), (0.0, 20.0))
        >>> round(both.quantile(0.9) - hold.quantile(0.9), 9)
        0.0
        """
        return self._level(self.exceedance, 1 - probability)

    def interval(self, probability: float, confidence: float = 0.9) -> tuple[float, float]:
        """Confidence interval of a quantile: the levels whose interval of the exceedance ends at it."""

        def least(level: float) -> float:
            return self.exceedance_interval(level, confidence)[0]

        def most(level: float) -> float:
            return self.exceedance_interval(level, confidence)[1]

        return self._level(least, 1 - probability), self._level(most, 1 - probability)

    def _level(self, exceedance: Callable[[float], float], wanted: float) -> float:
        """Least level at which a falling probability is at most `wanted`."""
        bottom, top = self.scale
        width = max(top - bottom, 1e-12 * max(abs(top), abs(bottom), 1e-300))
        low, high = bottom - 100 * width, top + 100 * width
        if exceedance(low) <= wanted:
            return -math.inf
        if exceedance(high) > wanted:
            return math.inf
        for _ in range(ITERATIONS):
            middle = 0.5 * (low + high)
            if exceedance(middle) > wanted:
                low = middle
            else:
                high = middle
        return high


def _either(probabilities: Iterable[float]) -> float:
    """Probability that one or more of independent events happen."""
    with np.errstate(divide="ignore"):
        return float(-np.expm1(np.log1p(-np.fromiter(probabilities, float)).sum()))

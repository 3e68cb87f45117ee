"""The tail of all peaks of several runs: peaks over a threshold, and a Weibull distribution."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from ...errors import KingpostError
from .gumbel import THREE_HOURS_S
from .moments import jackknife, without_groups

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

DISTRIBUTIONS = ("generalised_pareto", "exponential", "weibull")
FEWEST_RUNS, FEWEST_PEAKS = 5, 20
"""Runs, and peaks over the threshold in all of them, that a tail is fitted to."""
MOST_GROUPS = 20
"""Parts of the runs that the jackknife leaves out, one at a time."""
SEED, SAMPLES = 20121, 1000
"""Of the samples that intervals are calibrated with; their generator is counter-based (Philox)."""
SHAPES = (0.05, 60.0)
"""Where the shape of a Weibull distribution is sought."""


@dataclass(frozen=True)
class TailExtreme:
    """The largest value in a stated time from the peaks over a threshold.

    With `rate` peaks over the threshold u in a second, each above x with the probability S(x), the largest
    of the duration T is below x with the probability exp(-rate T S(x)): peaks that are far between are a
    Poisson process (Coles, *An Introduction to Statistical Modeling of Extreme Values*, 2001, ch. 7). S(x)
    is

    - generalised Pareto: (1 + shape (x - u) / scale)^(-1 / shape);
    - exponential: exp(-(x - u) / scale);
    - Weibull: exp((u - m)^shape / scale^shape - (x - m)^shape / scale^shape) about the mean m.

    Attributes
    ----------
    distribution
        One of `DISTRIBUTIONS`.
    threshold, mean
        u, and m; NaN where there is none.
    duration_s
        The time that the largest value is of, s.
    runs, count
        Runs, and their peaks over the threshold.
    fits
        Rows of rate (1/s), scale and, unless exponential, shape: of all runs, then without each group of
        runs, of which there are as many as runs, or `MOST_GROUPS`.
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
        """The level that one peak in the duration is above, on average: the largest value's mode, nearly."""
        return self.quantile(float(np.exp(-1)))

    def quantile(self, probability: float) -> float:
        """What the largest value is above with the probability 1 - `probability`.

        Raises
        ------
        KingpostError
            When it would be below the threshold.
        """
        return float(self._quantiles(probability)[0])

    def exceedance(self, level: float) -> float:
        """The probability that the largest value is above `level`, which is not below the threshold."""
        if level < self.threshold:
            raise KingpostError(f"level: found {level:g}, allowed: the threshold {self.threshold:g} or more")
        tail = _tail(self.distribution, self.fits[:1], self.threshold, self.mean)
        return float(-np.expm1(-self.fits[0, 0] * self.duration_s * tail.sf(level)[0]))

    def interval(self, probability: float, confidence: float = 0.9) -> tuple[float, float]:
        """Where the quantile lies with this confidence, as much left out below as above.

        It is x + t s, with s the jackknife's over groups of runs. For tails that begin at the threshold t are
        the percentiles of (true - x) / s where the tail is exponential, found by sampling as many peaks in as
        many groups; for the Weibull distribution those of Student's t with one degree of freedom less than
        groups.

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
        # Two digits of the count and of the probability do for percentiles.
        count = float(f"{self.count:.2g}")
        peaks_below = float(f"{self.fits[0, 0] * self.duration_s / -np.log(probability):.2g}")
        low, high = _percentiles(self.distribution, groups, count, peaks_below, confidence)
        return values[0] + low * error, values[0] + high * error

    def _quantiles(self, probability: float) -> NDArray[np.float64]:
        """Of all runs, then without each group of them."""
        if not 0 < probability < 1:
            raise KingpostError(f"probability: found {probability:g}, allowed: between 0 and 1")
        expected = self.fits[:, 0] * self.duration_s
        if -np.log(probability) >= expected[0]:
            allowed = f"more than {np.exp(-expected[0]):.3g}, at which the largest value is the threshold"
            raise KingpostError(f"probability: found {probability:g}, allowed: {allowed}")
        share = np.minimum(-np.log(probability) / expected, 1.0)
        return _tail(self.distribution, self.fits, self.threshold, self.mean).isf(share)


def peaks(values: ArrayLike, level: float | None = None) -> NDArray[np.float64]:
    """The largest value between each up-crossing of the mean and the next: peaks that are not of one cycle.

    What is before the first and after the last up-crossing is left out (Naess & Moan, *Stochastic Dynamics of
    Marine Structures*, 2013, ch. 10: the global maxima).

    Parameters
    ----------
    values
        A record; its rows are even or not.
    level
        What is crossed; the record's mean unless given.

    Returns
    -------
    numpy.ndarray
        Of each cycle, in the order of time; empty where there is none.

    >>> peaks([0, 1, 3, 1, -1, -2, 1, 2, -2, -1, 1.0]).tolist()
    [3.0, 2.0]
    """
    x = np.asarray(values, float).ravel()
    above = x >= (x.mean() if level is None else level)
    starts = np.flatnonzero(~above[:-1] & above[1:]) + 1
    if len(starts) < 2:
        return np.empty(0)
    return np.maximum.reduceat(x[: starts[-1]], starts[:-1])


def over_threshold(
    runs: Sequence[ArrayLike],
    record_s: float,
    duration_s: float = THREE_HOURS_S,
    distribution: str = "generalised_pareto",
    threshold: float | None = None,
    counts: ArrayLike | None = None,
) -> TailExtreme:
    """Peaks over a threshold: a generalised Pareto or an exponential distribution of their excess.

    Pickands (*Ann. Stat.* 3, 1975) and Davison & Smith (*J. R. Stat. Soc. B* 52, 1990); fitted by L-moments
    (Hosking & Wallis, *Technometrics* 29, 1987, p. 341: shape 2 - l1 / l2, scale l1 (1 - shape)), which err
    less than maximum likelihood below 500 peaks. Unless given, the threshold leaves a tenth of the peaks
    over it (DuMouchel, *Ann. Stat.* 11, 1983).

    Measured on a Gaussian process, ten runs of ten minutes, quantile 0.9: intervals of 90 % cover it in 88
    % of 400 trials, also where the operation lasts three runs; of thirty runs in 90 %. An exponential tail
    is heavier than that of a Gaussian process: its quantile is 6 % too high, and its intervals cover it in
    70 %.

    Parameters
    ----------
    runs
        Peaks of each run, as `peaks` finds them; five runs or more.
    record_s
        How long each run is without its start, s.
    duration_s
        Time to find the extreme of, s: three hours, or how long the operation lasts.
    distribution
        ``generalised_pareto`` or ``exponential``.
    threshold
        Peaks above it count.
    counts
        How many peaks each run had, where `runs` have the largest of them alone.

    Returns
    -------
    TailExtreme
        The fitted tail with its intervals.

    Raises
    ------
    KingpostError
        When there are too few runs or peaks, or when peaks over the threshold were not kept.

    >>> rng = np.random.default_rng(1)
    >>> runs = [rng.exponential(1.0, 75) for _ in range(10)]
    >>> found = over_threshold(runs, record_s=600.0, duration_s=600.0)
    >>> low, high = found.interval(0.9)
    >>> bool(low < np.log(75) - np.log(-np.log(0.9)) < high)
    True
    """
    if distribution not in DISTRIBUTIONS[:2]:
        raise KingpostError(f"distribution: found {distribution!r}, allowed: {', '.join(DISTRIBUTIONS[:2])}")
    tail = _Tail.of(runs, record_s, duration_s, 0.1, threshold, counts)
    found = without_groups(tail.above - tail.threshold, tail.group, tail.groups)
    fits = np.column_stack([found[:, 0] / tail.time_s, _excess(distribution, found[:, 1:])])
    return TailExtreme(
        distribution, tail.threshold, np.nan, float(duration_s), tail.runs, len(tail.above), fits
    )


def weibull(
    runs: Sequence[ArrayLike],
    record_s: float,
    duration_s: float = THREE_HOURS_S,
    mean: float = 0.0,
    threshold: float | None = None,
    counts: ArrayLike | None = None,
) -> TailExtreme:
    """A Weibull distribution, with two parameters, of the peaks about the mean, by those over a threshold.

    Peaks of a narrow-banded Gaussian process have a Rayleigh distribution: shape 2, scale the square root
    of 2 times the deviation. Those of a broad band have it in their tail alone, so that small peaks are
    left out: maximum likelihood of the distribution truncated at the threshold (Wingo, *Stat. Papers* 30,
    1989, p. 39). Unless given, the threshold leaves half of the peaks over it.

    Measured on a Gaussian process, ten runs of ten minutes, quantile 0.9: intervals of 90 % cover it in 89
    % of 400 trials, and in 90 % where the operation lasts three runs; they are half as wide as those of the
    largest values alone (`extreme`). That holds where the response is nearly Gaussian; a rope that goes
    slack is not.

    Parameters
    ----------
    runs
        Peaks of each run, as `peaks` finds them; five runs or more.
    record_s
        How long each run is without its start, s.
    duration_s
        Time to find the extreme of, s: three hours, or how long the operation lasts.
    mean
        What the process varies about.
    threshold
        Peaks above it count; above the mean.
    counts
        How many peaks each run had, where `runs` have the largest of them alone.

    Returns
    -------
    TailExtreme
        The fitted tail with its intervals.

    Raises
    ------
    KingpostError
        When there are too few runs or peaks, when peaks over the threshold were not kept, or when no Weibull
        distribution has such a tail.

    >>> rng = np.random.default_rng(1)
    >>> found = weibull([rng.rayleigh(1.0, 75) for _ in range(10)], record_s=600.0)
    >>> 1.7 < found.parameters["shape"] < 2.3
    True
    """
    tail = _Tail.of(runs, record_s, duration_s, 0.5, threshold, counts)
    if tail.threshold < mean:
        raise KingpostError(f"threshold: found {tail.threshold:g}, allowed: the mean {mean:g} or more")
    fits = []
    for group in range(-1, tail.groups):
        kept = tail.above[tail.group != group]
        shape, scale = _truncated_weibull(kept - mean, tail.threshold - mean)
        fits.append([len(kept) / tail.time_s[group + 1], scale, shape])
    return TailExtreme(
        "weibull", tail.threshold, float(mean), float(duration_s), tail.runs, len(tail.above), np.array(fits)
    )


@dataclass(frozen=True)
class _Tail:
    """Peaks over a threshold, the group of their run, and the time of all runs and without each group."""

    threshold: float
    above: NDArray[np.float64]
    group: NDArray[np.int64]
    groups: int
    time_s: NDArray[np.float64]
    runs: int

    @classmethod
    def of(
        cls,
        runs: Sequence[ArrayLike],
        record_s: float,
        duration_s: float,
        share: float,
        threshold: float | None,
        counts: ArrayLike | None,
    ) -> _Tail:
        every = [np.asarray(one, float).ravel() for one in runs]
        if len(every) < FEWEST_RUNS or not all(np.isfinite(one).all() for one in every):
            raise KingpostError(f"runs: found {len(every)}, allowed: {FEWEST_RUNS} or more, all peaks finite")
        for name, value in (("record_s", record_s), ("duration_s", duration_s)):
            if not (value > 0 and np.isfinite(value)):
                raise KingpostError(f"{name}: found {value:g}, allowed: finite and greater than 0")
        had = np.array([len(one) for one in every]) if counts is None else np.asarray(counts, int)
        pooled = np.concatenate(every)
        u = _threshold(pooled, int(share * had.sum())) if threshold is None else float(threshold)
        for one, count in zip(every, had, strict=True):
            if len(one) < count and (len(one) == 0 or one.min() > u):
                allowed = f"all peaks above the threshold {u:g}: keep more, or give a higher threshold"
                raise KingpostError(
                    f"runs: found the largest {len(one)} of {count} peaks, allowed: {allowed}"
                )
        groups = min(len(every), MOST_GROUPS)
        of_run = np.arange(len(every)) * groups // len(every)
        group = np.repeat(of_run, [len(one) for one in every])
        runs_of = np.bincount(of_run, minlength=groups)
        time_s = record_s * np.concatenate([[len(every)], len(every) - runs_of])
        found = cls(u, pooled[pooled > u], group[pooled > u], groups, time_s, len(every))
        left = len(found.above) - np.bincount(found.group, minlength=groups).max(initial=0)
        if len(found.above) < FEWEST_PEAKS or left < FEWEST_PEAKS // 2 or np.ptp(found.above) == 0:
            allowed = f"{FEWEST_PEAKS} or more that differ, of several runs"
            raise KingpostError(f"peaks over {u:g}: found {len(found.above)}, allowed: {allowed}")
        return found


def _threshold(pooled: NDArray[np.float64], over: int) -> float:
    """What `over` peaks are above."""
    if not FEWEST_PEAKS <= over < len(pooled):
        allowed = f"from {FEWEST_PEAKS} to fewer than the {len(pooled)} kept"
        raise KingpostError(f"peaks over the threshold: found {over}, allowed: {allowed}")
    return float(np.partition(pooled, len(pooled) - over - 1)[len(pooled) - over - 1])


def _excess(distribution: str, moments: NDArray[np.float64]) -> NDArray[np.float64]:
    """Scale, and shape, from both L-moments of what peaks are above the threshold by, along the last axis."""
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


def _truncated_weibull(above: NDArray[np.float64], threshold: float) -> tuple[float, float]:
    """Shape and scale by maximum likelihood, of values above a threshold that is not negative."""
    from scipy.optimize import brentq

    unit = above.mean()
    x, u = above / unit, threshold / unit
    log = np.log(x)
    log_u = np.log(u) if u > 0 else 0.0

    def slope(shape: float) -> float:
        power, power_u = x**shape, u**shape
        return float(
            1 / shape + log.mean() - ((power * log).mean() - power_u * log_u) / (power.mean() - power_u)
        )

    if slope(SHAPES[0]) < 0 or slope(SHAPES[1]) > 0:
        allowed = f"a tail of a Weibull distribution with a shape from {SHAPES[0]:g} to {SHAPES[1]:g}"
        raise KingpostError(f"peaks: found {len(x)} above {threshold:g}, allowed: {allowed}")
    shape = float(brentq(slope, *SHAPES, xtol=1e-6))
    return shape, float(unit * ((x**shape).mean() - u**shape) ** (1 / shape))


@lru_cache(maxsize=256)
def _percentiles(
    distribution: str, groups: int, count: float, peaks_below: float, confidence: float
) -> tuple[float, float]:
    """Of (true - estimate) / standard error where peaks above 0 are exponential, of scale 1.

    `count` of them are expected in all groups; the quantile is what one in `peaks_below` is above.
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
    fits = np.concatenate([found[..., :1], _excess(distribution, found[..., 1:])], axis=-1)
    values = _tail(distribution, fits, 0.0, np.nan).isf(np.minimum(1 / expected, 1.0))
    error = np.sqrt(np.var(values[:, 1:], axis=1) * (groups - 1))
    low, high = np.nanquantile((true - values[:, 0]) / error, (0.5 - confidence / 2, 0.5 + confidence / 2))
    return float(low), float(high)

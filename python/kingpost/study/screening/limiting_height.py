"""Limiting sea by variances: the significant height at which a limit is exceeded with the accepted
probability."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...analysis import spectral

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Numbers = NDArray[np.float64]

STRAIGHT = 1e-9
"""Largest relative deviation of a moment from the form a Hs^2 + b."""
HEIGHTS_M = (1e-6, 1e6)
"""Range in which the limiting height is sought, m."""
HALVINGS = 60
"""Number of bisections of `HEIGHTS_M`, whose ratio is 1e12: enough to reach rounding error."""


def limiting_height(
    heights_m: Numbers,
    bounds: tuple[float | None, float | None],
    mean: Numbers,
    m0: Numbers,
    m2: Numbers,
    operation_s: float,
    acceptance: float,
    percentile: float = 100.0,
) -> Numbers:
    """Find the significant height at which a limit is exceeded with the accepted probability.

    Parameters
    ----------
    heights_m
        Significant heights of the cases, m.
    bounds
        Smallest and largest allowed value of the limit.
    mean, m0, m2
        Mean and spectral moments of the limit's column; the first dimension is the height, others may follow.
    operation_s
        Duration of the operation, s.
    acceptance
        Accepted probability.
    percentile
        Percentage of the time in which the column must be within its bounds.

    Returns
    -------
    numpy.ndarray
        Limiting heights, m: infinite if no height reaches the probability, 0 if it is reached without waves,
        and NaN if the height is outside the range of the cases or the column has no linear response.

    >>> m0 = (0.25 * np.array([1.0, 2.0])) ** 2
    >>> found = limiting_height(np.array([1.0, 2.0]), (None, 3.0), 0 * m0, m0, m0, 1800.0, 0.1)
    >>> sigma = 0.25 * found
    >>> round(float(spectral.exceedance((None, 3.0), 0.0, sigma, 2 * np.pi, 1800.0)), 6)
    0.1
    >>> found = limiting_height(np.array([1.0, 2.0]), (None, 3.0), 0 * m0, m0, m0, 1800.0, 0.1, 95.0)
    >>> round(float(spectral.share_outside((None, 3.0), 0.0, 0.25 * found)), 6)
    0.05
    """
    accepted = acceptance if percentile >= 100 else 1 - percentile / 100

    def outside(mean: Numbers, sigma: Numbers, period: Numbers) -> Numbers:
        if percentile < 100:
            return spectral.share_outside(bounds, mean, sigma)
        return spectral.exceedance(bounds, mean, sigma, period, operation_s)

    sums = [_by_height(heights_m, moment) for moment in (m0, m2)]
    if any(one is None for one in sums):
        sigma, period = spectral.deviation_and_period(m0, m2)
        reached = outside(mean, sigma, period)
        return _between(heights_m, np.where(np.isnan(sigma), np.nan, reached), accepted)
    of_m0, of_m2 = (one for one in sums if one is not None)

    def exceeded(height: Numbers) -> NDArray[np.bool_]:
        sigma, period = spectral.deviation_and_period(
            of_m0[0] * height**2 + of_m0[1], of_m2[0] * height**2 + of_m2[1]
        )
        return outside(mean[0], sigma, period) > accepted

    low, high = (np.full(m0.shape[1:], end) for end in HEIGHTS_M)
    always, never = exceeded(low), ~exceeded(high)
    for _ in range(HALVINGS):
        middle = np.sqrt(low * high)
        above = exceeded(middle)
        low, high = np.where(above, low, middle), np.where(above, middle, high)
    found = np.where(always, 0.0, np.where(never, np.inf, np.sqrt(low * high)))
    return np.where(np.isnan(m0).any(axis=0), np.nan, found)


def _by_height(heights: Numbers, moment: Numbers) -> tuple[Numbers, Numbers] | None:
    """Split a moment into a part proportional to the height squared and a constant part; None if it does not
    have this form."""
    squares = heights**2
    if len(heights) == 1:
        return moment[0] / squares[0], np.zeros(moment.shape[1:])
    least, most = int(np.argmin(squares)), int(np.argmax(squares))
    goes = (moment[most] - moment[least]) / (squares[most] - squares[least])
    stays = moment[least] - goes * squares[least]
    by = goes * squares.reshape(-1, *[1] * (moment.ndim - 1)) + stays
    with np.errstate(invalid="ignore"):
        off = np.abs(by - moment) > STRAIGHT * np.abs(moment).max(axis=0)
    return None if np.any(off) or np.any(goes < 0) else (goes, np.maximum(stays, 0.0))


def _between(heights: Numbers, probability: Numbers, acceptance: float) -> Numbers:
    """Height at which the probability passes the accepted one, interpolated linearly in its logarithm."""
    order = np.argsort(heights)
    heights, p = heights[order], np.log(np.clip(probability[order], 1e-300, 1.0))
    wanted = np.log(acceptance)
    found = np.full(p.shape[1:], np.nan)
    for k in range(len(heights) - 2, -1, -1):
        passes = (p[k] <= wanted) & (p[k + 1] > wanted)
        with np.errstate(invalid="ignore", divide="ignore"):
            share = (wanted - p[k]) / (p[k + 1] - p[k])
        found = np.where(passes, heights[k] + share * (heights[k + 1] - heights[k]), found)
    return found

"""Workable records of a series: Hs is at most alpha times the limiting height at the record's period and
direction. A record with a NaN, or with a period or direction that was not studied, is not workable.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypedDict

import numpy as np

from ...errors import KingpostError
from ..limiting.sea import LimitingHeight
from ..sea_states.series import Series

if TYPE_CHECKING:
    from numpy.typing import NDArray

EQUAL = 1e-9
"""Relative tolerance for a height equal to the limit: rounding error of alpha times the limit."""
STEPS_OF_A_GAP = 1.5
"""Default length of a gap in median time steps."""
NO_DATA, NOT_STUDIED = "no data", "not studied"


@dataclass(frozen=True)
class Workable:
    """A series with its allowed heights.

    Attributes
    ----------
    series
        Sea states with peak periods.
    allowed_m
        Allowed height, alpha times the limiting height, by record.
    governs
        Governing limit by record, or the reason why there is no height.
    alpha
        The factor.
    longest_step_h
        Longest time step; a longer one is a gap.
    """

    series: Series
    allowed_m: NDArray[np.float64]
    governs: tuple[str, ...]
    alpha: float
    longest_step_h: float

    @property
    def holds(self) -> NDArray[np.bool_]:
        """Mask of the workable records."""
        with np.errstate(invalid="ignore"):
            return self.series.height_m <= self.allowed_m * (1 + EQUAL)

    def runs(self) -> Iterator[tuple[int, int]]:
        """First and last record of each sequence of workable records without a gap."""
        holds, hours = self.holds, self.series.hours
        first = None
        for k, good in enumerate(holds):
            if first is not None and (not good or hours[k] - hours[k - 1] > self.longest_step_h):
                yield first, k - 1
                first = None
            if good and first is None:
                first = k
        if first is not None:
            yield first, len(holds) - 1

    def why_not(self, record: int) -> str:
        """Name the reason why a record is not workable."""
        if np.isnan(self.series.height_m[record]) or np.isnan(self.series.period_s[record]):
            return NO_DATA
        return NOT_STUDIED if np.isnan(self.allowed_m[record]) else self.governs[record]


class How(TypedDict, total=False):
    """Optional parameters of `workable`."""

    x_axis_deg: float | None
    direction_rad: float | None
    peak_enhancement: float
    longest_step_h: float | None


def workable(
    series: Series,
    limiting_height: LimitingHeight,
    alpha: float,
    x_axis_deg: float | None = None,
    direction_rad: float | None = None,
    peak_enhancement: float = 3.3,
    longest_step_h: float | None = None,
) -> Workable:
    """Find the workable records of a series: Hs <= alpha * limiting height.

    Parameters
    ----------
    series
        Sea states.
    limiting_height
        Function of peak period (s) and direction (rad, in the scenario's axes) that returns the limiting
        height and the governing limit.
    alpha
        The factor, more than 0, at most 1.
    x_axis_deg
        Direction of the scenario's x axis, clockwise from north: the heading of a ship with heading 0 in the
        scenario.
    direction_rad
        Direction that all waves travel towards, instead of the series' directions.
    peak_enhancement
        gamma of JONSWAP, by which mean periods become peak periods.
    longest_step_h
        Longest time step, h; a longer one is a gap. Default: one and a half median steps.

    Returns
    -------
    Workable
        The series with the allowed heights.

    Raises
    ------
    KingpostError
        If alpha is out of its range, or directions are neither in the series nor given.

    >>> time = np.arange("2026-05-01T00", "2026-05-01T06", dtype="datetime64[h]").astype("datetime64[s]")
    >>> series = Series(time, np.array([3.0, 1, 1, 1, 3, 3]), np.full(6, 8.0))
    >>> found = workable(series, lambda period_s, direction: (2.0, "heel"), 0.8, direction_rad=np.pi)
    >>> list(found.runs())
    [(1, 3)]
    """
    if not 0 < alpha <= 1:
        raise KingpostError(f"alpha: found {alpha:g}, allowed: more than 0, at most 1")
    if direction_rad is None and x_axis_deg is None:
        allowed = "where the scenario's x axis points, or one direction of all waves"
        raise KingpostError(f"direction: found neither, allowed: {allowed}")
    series = series.with_peak_periods(peak_enhancement)
    directions = (
        np.full(len(series.time), direction_rad)
        if direction_rad is not None
        else series.directions_rad(x_axis_deg or 0.0)
    )
    limits = [
        limiting_height(*sea) if np.isfinite(sea).all() else (np.nan, NO_DATA)
        for sea in zip(series.period_s.tolist(), directions.tolist(), strict=True)
    ]
    return Workable(
        series,
        alpha * np.array([height for height, _ in limits]),
        tuple(name for _, name in limits),
        alpha,
        STEPS_OF_A_GAP * series.step_hours if longest_step_h is None else longest_step_h,
    )

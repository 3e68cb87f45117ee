"""Weather windows: periods in which work may go on, and whether it may begin now.

Words, as in DNV-OS-H101 (2011), sec. 4, and before it DNV's Rules for Planning and Execution of Marine
Operations (1996), pt. 1 ch. 2:

- **reference period** T_R = T_POP + T_C: the planned operation period and the estimated time for
  contingencies. Where nothing is known of the latter it is as long as the former;
- **alpha**: the forecast may show at most alpha times the limiting height, as forecasts err. It depends
  on the reference period, the height, the forecast and the site; the tables are in those standards and in
  DNV-ST-N001, and a number from them is the user's to give;
- **weather-restricted**: an operation with a reference period of at most 96 h and a planned one of at
  most 72 h.

A record may be worked in when Hs <= alpha * limiting height at its own period and direction. A window goes
from the first to the last of records in a row that may be worked in: between two such records the sea is
taken as lying between them. A gap, a NaN, a period or a direction that was not studied ends it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..errors import KingpostError
from .limiting_sea import LimitingHeight
from .sea_states import Series

if TYPE_CHECKING:
    from numpy.typing import NDArray

EQUAL = 1e-9
"""Share of the limit up to which a height is equal to it: rounding of alpha times the limit."""
STEPS_OF_A_GAP = 1.5
"""A step longer than this many usual ones is a gap, unless it is said how long one is."""
PLANNED_H, REFERENCE_H = 72.0, 96.0
"""The longest periods of a weather-restricted operation, h (DNV-OS-H101, sec. 4 B)."""
SERIES_ENDS, GAP, NO_DATA, NOT_STUDIED = "end of the series", "gap in the series", "no data", "not studied"


@dataclass(frozen=True)
class Workable:
    """A series with what may be worked in.

    Attributes
    ----------
    series
        Over the peak period.
    allowed_m
        alpha times the limiting height, by record.
    governs
        The limit that has it, or why there is none.
    alpha
        The factor.
    longest_step_h
        A longer step is a gap.
    """

    series: Series
    allowed_m: NDArray[np.float64]
    governs: tuple[str, ...]
    alpha: float
    longest_step_h: float

    @property
    def holds(self) -> NDArray[np.bool_]:
        """Mask of the records that may be worked in."""
        with np.errstate(invalid="ignore"):
            return self.series.height_m <= self.allowed_m * (1 + EQUAL)

    def runs(self) -> Iterator[tuple[int, int]]:
        """First and last record of each row of records that may be worked in, without a gap."""
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
        """Name the reason why a record may not be worked in."""
        if np.isnan(self.series.height_m[record]) or np.isnan(self.series.period_s[record]):
            return NO_DATA
        return NOT_STUDIED if np.isnan(self.allowed_m[record]) else self.governs[record]


@dataclass(frozen=True)
class Window:
    """A period that may be worked in.

    Attributes
    ----------
    start, end
        UTC.
    duration_h
        Between them.
    governs, utilisation
        The limit that comes nearest, and the largest Hs over what alpha times the limit allows.
    ended_by
        The limit of the record after it, or what else ends it.
    """

    start: np.datetime64
    end: np.datetime64
    duration_h: float
    governs: str
    utilisation: float
    ended_by: str

    def last_start(self, reference_h: float) -> np.datetime64:
        """The last moment at which the reference period still fits in."""
        return self.end - np.timedelta64(round(reference_h * 3600), "s")


def reference_period_h(planned_h: float, contingency_h: float | None = None) -> float:
    """T_R = T_POP + T_C, h; without T_C twice T_POP.

    Raises
    ------
    KingpostError
        When they are not times of a weather-restricted operation.

    >>> reference_period_h(6.0), reference_period_h(6.0, 4.0)
    (12.0, 10.0)
    """
    if not 0 < planned_h <= PLANNED_H:
        allowed = f"more than 0, at most {PLANNED_H:g}: a longer operation is not weather-restricted"
        raise KingpostError(f"operation_hours: found {planned_h:g}, allowed: {allowed}")
    contingency_h = planned_h if contingency_h is None else contingency_h
    if not 0 <= contingency_h <= REFERENCE_H - planned_h:
        allowed = f"from 0 to {REFERENCE_H - planned_h:g}, so that both are {REFERENCE_H:g} h at most"
        raise KingpostError(f"contingency_hours: found {contingency_h:g}, allowed: {allowed}")
    return planned_h + contingency_h


def workable(
    series: Series,
    limiting_height: LimitingHeight,
    alpha: float,
    x_axis_deg: float | None = None,
    direction_rad: float | None = None,
    peak_enhancement: float = 3.3,
    longest_step_h: float | None = None,
) -> Workable:
    """Find the records of a series that may be worked in: Hs <= alpha * limiting height.

    Parameters
    ----------
    series
        Sea states.
    limiting_height
        By peak period (s) and direction (rad, in the scenario's axes): the height and the limit that governs.
    alpha
        The factor, more than 0, at most 1.
    x_axis_deg
        Where the scenario's x axis points, clockwise from north: the heading of a ship that lies at 0 in it.
    direction_rad
        That all waves go to, instead of the series' directions.
    peak_enhancement
        gamma of JONSWAP, by which mean periods become peak periods.
    longest_step_h
        A longer step is a gap, h; one and a half usual steps unless given.

    Returns
    -------
    Workable
        The series with the allowed heights.

    Raises
    ------
    KingpostError
        When alpha is out of its range, or directions are neither in the series nor given.

    >>> time = np.arange("2026-05-01T00", "2026-05-01T06", dtype="datetime64[h]").astype("datetime64[s]")
    >>> series = Series(time, np.array([3.0, 1, 1, 1, 3, 3]), np.full(6, 8.0))
    >>> found = workable(series, lambda period_s, direction: (2.0, "heel"), 0.8, direction_rad=np.pi)
    >>> [window.duration_h for window in windows(found, 1.0)]
    [2.0]
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


def windows(found: Workable, reference_h: float) -> list[Window]:
    """The weather windows: periods that may be worked in, as long as the reference period or longer.

    Parameters
    ----------
    found
        Of `workable`.
    reference_h
        T_R, h; 0 for all periods.

    Returns
    -------
    list of Window
        In the order of time.
    """
    series, hours = found.series, found.series.hours
    kept = []
    for first, last in found.runs():
        if hours[last] - hours[first] < reference_h * (1 - EQUAL):
            continue
        with np.errstate(divide="ignore", invalid="ignore"):
            used = np.nan_to_num(series.height_m[first : last + 1] / found.allowed_m[first : last + 1])
        nearest = int(used.argmax())
        kept.append(
            Window(
                start=series.time[first],
                end=series.time[last],
                duration_h=float(hours[last] - hours[first]),
                governs=found.governs[first + nearest],
                utilisation=float(used[nearest]),
                ended_by=_ended_by(found, last),
            )
        )
    return kept


def _ended_by(found: Workable, last: int) -> str:
    hours = found.series.hours
    if last == len(hours) - 1:
        return SERIES_ENDS
    return GAP if hours[last + 1] - hours[last] > found.longest_step_h else found.why_not(last + 1)

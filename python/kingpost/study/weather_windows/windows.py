"""Weather windows: periods in which an operation may proceed. Terms, from DNV-OS-H101 (2011), sec. 4, and
before it DNV's Rules for Planning and Execution of Marine Operations (1996), pt. 1 ch. 2:

- **reference period** T_R = T_POP + T_C: the planned operation period and the estimated time for
  contingencies. If the latter is unknown, it is as long as the former;
- **alpha**: the forecast height may be at most alpha times the limiting height, because forecasts are
uncertain. Alpha depends on the reference period, the height, the forecast and the site; the tables are in
those standards and in
  DNV-ST-N001, and the user must take alpha from them;
- **weather-restricted**: an operation with a reference period of at most 96 h and a planned one of at
  most 72 h.

A record is workable if Hs <= alpha * limiting height at the record's period and direction. A window extends
from the first to the last of consecutive workable records: between two records the sea is assumed to be
between theirs. A gap, a NaN, or a period or direction that was not studied ends it.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...errors import KingpostError
from .workable import EQUAL, Workable

SERIES_ENDS, GAP = "end of the series", "gap in the series"
PLANNED_H, REFERENCE_H = 72.0, 96.0
"""The longest periods of a weather-restricted operation, h (DNV-OS-H101, sec. 4 B)."""


@dataclass(frozen=True)
class Window:
    """A workable period.

    Attributes
    ----------
    start, end
        UTC.
    duration_h
        Duration, h.
    governs, utilisation
        Limit with the highest utilisation, and the utilisation: the largest Hs over alpha times the limiting
        height.
    ended_by
        Limit that ends the window at the next record, or another reason for its end.
    """

    start: np.datetime64
    end: np.datetime64
    duration_h: float
    governs: str
    utilisation: float
    ended_by: str

    def last_start(self, reference_h: float) -> np.datetime64:
        """Last time at which the reference period still fits into the window."""
        return self.end - np.timedelta64(round(reference_h * 3600), "s")


def reference_period_h(planned_h: float, contingency_h: float | None = None) -> float:
    """Compute T_R = T_POP + T_C, h; without T_C twice T_POP.

    Raises
    ------
    KingpostError
        If the times are not those of a weather-restricted operation.

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


def windows(found: Workable, reference_h: float) -> list[Window]:
    """Find the weather windows: workable periods at least as long as the reference period.

    Parameters
    ----------
    found
        Of `workable`.
    reference_h
        T_R, h; 0 for all periods.

    Returns
    -------
    list of Window
        Windows in the order of time.
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

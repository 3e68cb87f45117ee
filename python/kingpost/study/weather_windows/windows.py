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

from dataclasses import dataclass

import numpy as np

from ...errors import KingpostError
from .workable import EQUAL, Workable

SERIES_ENDS, GAP = "end of the series", "gap in the series"
PLANNED_H, REFERENCE_H = 72.0, 96.0
"""The longest periods of a weather-restricted operation, h (DNV-OS-H101, sec. 4 B)."""


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

"""Statistics of a hindcast's weather windows: waiting time, calendar months, persistence."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .windows import windows
from .workable import EQUAL, Workable

if TYPE_CHECKING:
    import pandas
    from numpy.typing import NDArray


def waiting_h(found: Workable, reference_h: float) -> NDArray[np.float64]:
    """Compute the time from each record until an operation may begin, h; NaN if none may begin later.

    Parameters
    ----------
    found
        Of `workable`.
    reference_h
        T_R, h.

    Returns
    -------
    numpy.ndarray
        Waiting time by record; 0 if an operation may begin there.
    """
    hours = found.series.hours
    starts = [(hours[first], hours[last] - reference_h) for first, last in found.runs()
              if hours[last] - hours[first] >= reference_h * (1 - EQUAL)]  # fmt: skip
    waits = np.full(len(hours), np.nan)
    for first, last in reversed(starts):
        before = hours <= last + EQUAL * max(reference_h, 1.0)
        waits[before] = np.maximum(first - hours[before], 0.0)
    return waits


def by_month(found: Workable, reference_h: float) -> pandas.DataFrame:
    """Tabulate workability in each calendar month over all years, a row for each month.

    Parameters
    ----------
    found
        Of `workable`.
    reference_h
        T_R, h.

    Returns
    -------
    pandas.DataFrame
        ``month``; ``records``, those with data; ``workable_per_cent`` of them; ``start_per_cent``, in which
        an operation may begin; ``windows`` that begin in the month; ``mean_waiting_h`` and
        ``waiting_90_h``, which 90 % of waits do not exceed; ``not_studied_per_cent``, outside of what was
        studied.
    """
    import pandas

    series = found.series
    month = series.time.astype("datetime64[M]").astype(int) % 12 + 1
    waits = waiting_h(found, reference_h)
    begins = [
        int(window.start.astype("datetime64[M]").astype(int)) % 12 + 1
        for window in windows(found, reference_h)
    ]
    has_data = ~(np.isnan(series.height_m) | np.isnan(series.period_s))
    rows = []
    for number in np.unique(month).tolist():
        of_month = (month == number) & has_data
        count = int(of_month.sum())
        if not count:
            continue
        of_waits = waits[of_month & ~np.isnan(waits)]
        rows.append(
            {
                "month": number,
                "records": count,
                "workable_per_cent": 100 * float(found.holds[of_month].mean()),
                "start_per_cent": 100 * float((waits[of_month] == 0).mean()),
                "windows": begins.count(number),
                "mean_waiting_h": float(of_waits.mean()) if len(of_waits) else np.nan,
                "waiting_90_h": float(np.quantile(of_waits, 0.9)) if len(of_waits) else np.nan,
                "not_studied_per_cent": 100 * float(np.isnan(found.allowed_m[of_month]).mean()),
            }
        )
    return pandas.DataFrame(rows)


@dataclass(frozen=True)
class Persistence:
    """Statistics of the time for which the sea stays below the allowed height.

    Attributes
    ----------
    periods
        Number of periods.
    mean_h, longest_h
        Mean and longest duration, h.
    lasting
        Share of the periods that last at least a number of hours, by hours.
    """

    periods: int
    mean_h: float
    longest_h: float
    lasting: dict[float, float]


def persistence(found: Workable, hours: tuple[float, ...] = (6.0, 12.0, 24.0, 48.0, 72.0)) -> Persistence:
    """Compute statistics of all workable periods of any length.

    Parameters
    ----------
    found
        Of `workable`.
    hours
        Durations to count, h.

    Returns
    -------
    Persistence
        The statistics; durations are NaN if there is no period.
    """
    lasts = np.array([window.duration_h for window in windows(found, 0.0)])
    if not len(lasts):
        return Persistence(0, np.nan, np.nan, dict.fromkeys(hours, np.nan))
    share = {limit: float((lasts >= limit * (1 - EQUAL)).mean()) for limit in hours}
    return Persistence(len(lasts), float(lasts.mean()), float(lasts.max()), share)

"""Sea states one after the other: a hindcast or a forecast at a place."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from ...errors import KingpostError
from .errors import SeaFileError
from .periods import PEAK, ratio

if TYPE_CHECKING:
    from numpy.typing import NDArray


class SeriesError(SeaFileError):
    """A series that is wrong."""


@dataclass(frozen=True)
class Series:
    """Sea states one after the other.

    Attributes
    ----------
    time
        UTC, ``datetime64[s]``, rising; steps may be uneven.
    height_m
        Hs; NaN in a gap.
    period_s
        NaN in a gap.
    period
        ``peak``, or which mean period: see `kingpost.study.sea_states.periods`.
    direction_from_deg
        Waves come from, clockwise from north; `None` where there are none.
    place
        What is known of where it is.
    """

    time: NDArray[np.datetime64]
    height_m: NDArray[np.float64]
    period_s: NDArray[np.float64]
    period: str = PEAK
    direction_from_deg: NDArray[np.float64] | None = None
    place: str = ""

    @property
    def hours(self) -> NDArray[np.float64]:
        """Time since the first state, h.

        >>> time = np.array(["2026-05-01T00", "2026-05-01T03"], "datetime64[s]")
        >>> Series(time, np.ones(2), np.ones(2)).hours.tolist()
        [0.0, 3.0]
        """
        return (self.time - self.time[0]).astype("timedelta64[s]").astype(float) / 3600

    @property
    def step_hours(self) -> float:
        """The usual step, h: the median."""
        return float(np.median(np.diff(self.hours))) if len(self.time) > 1 else 0.0

    def with_peak_periods(self, peak_enhancement: float = 3.3) -> Series:
        """Return the series over the peak period, by the ratio of a JONSWAP spectrum."""
        return replace(self, period_s=self.period_s / ratio(self.period, peak_enhancement), period=PEAK)

    def directions_rad(self, x_axis_deg: float) -> NDArray[np.float64]:
        """That waves go to, from the x axis of a scenario towards port; it points to `x_axis_deg`, clockwise
        from north. Waves from ahead go to pi, from starboard to pi / 2.

        Raises
        ------
        KingpostError
            When the series has no directions.

        >>> time = np.array(["2026-05-01T00", "2026-05-01T03"], "datetime64[s]")
        >>> series = Series(time, np.ones(2), np.ones(2), direction_from_deg=np.array([45.0, 135.0]))
        >>> np.degrees(series.directions_rad(45.0)).round(9).tolist()
        [180.0, 90.0]
        """
        if self.direction_from_deg is None:
            raise KingpostError(
                "direction: found none in the series, allowed: a column of it (by another name with "
                "--columns direction=NAME), or one direction of all waves (--direction-deg, direction_rad)"
            )
        return np.radians((x_axis_deg - self.direction_from_deg + 180) % 360)


def moment(cell: str, field: str, file: str | None = None, line: int | None = None) -> np.datetime64:
    """A time in UTC from its text.

    >>> str(moment("2026-05-01T08:00+02:00", "time"))
    '2026-05-01T06:00:00'
    """
    from datetime import UTC, datetime

    try:
        found = datetime.fromisoformat(cell)
    except ValueError:
        allowed = "a time in ISO 8601, as 2026-05-01T06:00 or 2026-05-01T08:00+02:00"
        raise SeriesError(field, repr(cell), allowed, file, line) from None
    aware = found.replace(tzinfo=UTC) if found.tzinfo is None else found.astimezone(UTC)
    return np.datetime64(aware.replace(tzinfo=None), "s")

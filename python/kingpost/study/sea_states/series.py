"""Time series of sea states: a hindcast or a forecast at a site."""

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
    """An error in a series of sea states."""


@dataclass(frozen=True)
class Series:
    """Time series of sea states.

    Attributes
    ----------
    time
        Times in UTC, ``datetime64[s]``, increasing; steps may be uneven.
    height_m
        Hs; NaN in a gap.
    period_s
        NaN in a gap.
    period
        ``peak`` or the kind of a mean period: see `kingpost.study.sea_states.periods`.
    direction_from_deg
        Direction that the waves come from, clockwise from north; `None` if unknown.
    place
        Description of the site.
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
        """Median time step, h."""
        return float(np.median(np.diff(self.hours))) if len(self.time) > 1 else 0.0

    def with_peak_periods(self, peak_enhancement: float = 3.3) -> Series:
        """Convert the series to peak periods, by the ratio of a JONSWAP spectrum."""
        return replace(self, period_s=self.period_s / ratio(self.period, peak_enhancement), period=PEAK)

    def directions_rad(self, x_axis_deg: float) -> NDArray[np.float64]:
        """Directions that the waves travel towards, counted from the x axis of a scenario towards port.
        `x_axis_deg` is the direction of this axis, clockwise from north. Waves from ahead travel towards pi,
        from starboard towards pi / 2.

        Raises
        ------
        KingpostError
            If the series has no directions.

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
    """Parse a time in UTC.

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

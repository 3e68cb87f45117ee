"""Go or no-go decision from a forecast."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Unpack

import numpy as np

from ...errors import KingpostError
from ..limiting.sea import LimitingHeight
from ..sea_states.series import Series
from .windows import GAP, SERIES_ENDS, Window, windows
from .workable import How, Workable, workable

AHEAD_H = 72.0


@dataclass(frozen=True)
class Decision:
    """Whether an operation may begin, and when.

    Attributes
    ----------
    is_go
        Whether the reference period from now on is within a window.
    now
        Time of the decision, UTC.
    windows
        Sufficiently long windows from now on.
    lead_h
        Time until the first window begins, h; 0 inside it, NaN without a window.
    governs
        Reason against beginning now: a limit or another one. If there is none, the limit with the highest
        utilisation in the reference period.
    reference_h, alpha
        Reference period, h, and alpha of the decision.
    found
        The records from now on, with the allowed heights.
    """

    is_go: bool
    now: np.datetime64
    windows: tuple[Window, ...]
    lead_h: float
    governs: str
    reference_h: float
    alpha: float
    found: Workable

    def to_dict(self) -> dict[str, Any]:
        """Return the decision as a dictionary of texts and numbers."""
        series = self.found.series
        return {
            "go": self.is_go,
            "now": str(self.now),
            "lead_h": self.lead_h,
            "governs": self.governs,
            "reference_h": self.reference_h,
            "alpha": self.alpha,
            "windows": [
                {
                    "start": str(one.start),
                    "last_start": str(one.last_start(self.reference_h)),
                    "end": str(one.end),
                    "duration_h": one.duration_h,
                    "lead_h": _hours(self.now, one.start),
                    "governs": one.governs,
                    "utilisation": one.utilisation,
                    "ended_by": one.ended_by,
                }
                for one in self.windows
            ],
            "records": {
                "time": [str(time) for time in series.time],
                "significant_height_m": series.height_m.tolist(),
                "peak_period_s": series.period_s.tolist(),
                "allowed_height_m": self.found.allowed_m.tolist(),
                "governs": list(self.found.governs),
                "workable": self.found.holds.tolist(),
            },
        }


def decide(
    series: Series,
    limiting_height: LimitingHeight,
    alpha: float,
    reference_h: float,
    now: np.datetime64 | None = None,
    ahead_h: float = AHEAD_H,
    **how: Unpack[How],
) -> Decision:
    """Decide whether an operation of a reference period may begin now, and find its windows in the forecast.

    Parameters
    ----------
    series
        A forecast.
    limiting_height
        Function of peak period (s) and direction (rad) that returns the limiting height and the governing
        limit.
    alpha
        The factor, more than 0, at most 1.
    reference_h
        T_R, h.
    now
        Time of the decision, UTC; default: the forecast's first record. The first record not before this time
        counts.
    ahead_h
        Time ahead in which windows are sought, h.
    how
        Options of `workable`: ``x_axis_deg`` or ``direction_rad``, ``peak_enhancement``, ``longest_step_h``.

    Returns
    -------
    Decision
        Decision with the windows.

    Raises
    ------
    KingpostError
        If the forecast has no record from now on, or the reference period is longer than `ahead_h`.

    >>> time = np.arange("2026-05-01T00", "2026-05-02T00", dtype="datetime64[h]").astype("datetime64[s]")
    >>> series = Series(time, np.where(np.arange(24) < 6, 3.0, 1.0), np.full(24, 8.0))
    >>> found = decide(series, lambda *_: (2.0, "heel"), alpha=0.8, reference_h=12.0, direction_rad=np.pi)
    >>> found.is_go, found.lead_h, found.governs
    (False, 6.0, 'heel')
    """
    if not 0 < reference_h <= ahead_h:
        raise KingpostError(
            f"reference period: found {reference_h:g} h, allowed: more than 0, at most {ahead_h:g} h"
        )
    now = series.time[0] if now is None else now.astype("datetime64[s]")
    kept = (series.time >= now) & (series.time <= now + np.timedelta64(round(ahead_h * 3600), "s"))
    if not kept.any():
        raise KingpostError(f"now: found {now}, allowed: up to {series.time[-1]}, the forecast's end")
    found = workable(_part(series, kept), limiting_height, alpha, **how)
    fitting = tuple(windows(found, reference_h))
    lead_h = _hours(now, fitting[0].start) if fitting else np.nan
    # The first record after now represents now, unless there is a gap before it.
    begins = found.series.time[0]
    is_go = bool(fitting and fitting[0].start == begins and _hours(now, begins) <= found.longest_step_h)
    return Decision(
        is_go,
        now,
        fitting,
        0.0 if is_go else lead_h,
        _governs(found, reference_h, is_go),
        reference_h,
        alpha,
        found,
    )


def _part(series: Series, kept: np.ndarray) -> Series:
    direction = series.direction_from_deg
    return Series(
        series.time[kept],
        series.height_m[kept],
        series.period_s[kept],
        series.period,
        None if direction is None else direction[kept],
        series.place,
    )


def _governs(found: Workable, reference_h: float, is_go: bool) -> str:
    """First reason against the reference period from now on; otherwise the limit with the highest
    utilisation."""
    hours = found.series.hours
    inside = np.flatnonzero(hours <= reference_h * (1 + 1e-9))
    if is_go:
        with np.errstate(divide="ignore", invalid="ignore"):
            used = np.nan_to_num(found.series.height_m[inside] / found.allowed_m[inside])
        return found.governs[int(used.argmax())]
    stops = [k for k in inside if not found.holds[k]]
    if stops:
        return found.why_not(int(stops[0]))
    gaps = np.diff(hours[: inside[-1] + 2]) > found.longest_step_h
    return GAP if gaps.any() else SERIES_ENDS


def _hours(first: np.datetime64, second: np.datetime64) -> float:
    return float((second - first) / np.timedelta64(1, "s")) / 3600

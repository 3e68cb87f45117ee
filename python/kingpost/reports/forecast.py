"""Text on a forecast for the command line: go or no-go, windows, forecast sea."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..study.weather_windows.decision import Decision
from .tables import table

MOST_RECORDS = 30


def text(decision: Decision, of: Sequence[str]) -> str:
    """The decision, a table of windows and one of the sea.

    Parameters
    ----------
    decision
        Result of `decide`.
    of
        Lines of text on the subject of the decision.
    """
    series = decision.found.series
    lines = [
        *of,
        f"alpha {decision.alpha:g}, reference period {decision.reference_h:g} h",
        f"{_time(series.time[0])} to {_time(series.time[-1])} UTC, {len(series.time)} records"
        + (f", {series.place}" if series.place else ""),
        "",
        _answer(decision),
    ]
    if decision.windows:
        lines += ["", *_windows(decision)]
    lines += ["", *_sea(decision)]
    outside = int(np.isnan(decision.found.allowed_m).sum())
    if outside:
        of_all = f"{outside} of {len(series.time)} records"
        lines.append(f"warning: {of_all} have no limiting height: no data, or not studied")
    return "\n".join(lines)


def _answer(decision: Decision) -> str:
    if decision.is_go:
        return f"GO at {_time(decision.now)} UTC: {decision.governs} comes nearest in the reference period"
    first = f"NO-GO at {_time(decision.now)} UTC: {decision.governs}"
    if not decision.windows:
        return f"{first}; no window of {decision.reference_h:g} h"
    return f"{first}; the next window begins in {decision.lead_h:.4g} h"


def _windows(decision: Decision) -> list[str]:
    rows: list[tuple[str, ...]] = [
        ("window, UTC", "until", "h", "begin by", "lead, h", "nearest limit", "used", "ended by")
    ]
    for one in decision.windows:
        lead_h = (one.start - decision.now) / np.timedelta64(3600, "s")
        rows.append(
            (
                _time(one.start),
                _time(one.end),
                f"{one.duration_h:.4g}",
                _time(one.last_start(decision.reference_h)),
                f"{max(lead_h, 0.0):.4g}",
                one.governs,
                f"{100 * one.utilisation:.0f} %",
                one.ended_by,
            )
        )
    return table(rows, "<<><><><")


def _sea(decision: Decision) -> list[str]:
    found, series = decision.found, decision.found.series
    rows: list[tuple[str, ...]] = [("UTC", "Hs, m", "Tp, s", "from, deg", "allowed, m", "", "limit")]
    every = -(-len(series.time) // MOST_RECORDS)
    came_from = series.direction_from_deg
    for k in range(0, len(series.time), every):
        rows.append(
            (
                _time(series.time[k]),
                _number(series.height_m[k], 2),
                _number(series.period_s[k], 1),
                "-" if came_from is None else _number(came_from[k], 0),
                _number(found.allowed_m[k], 2),
                "ok" if found.holds[k] else "no",
                found.governs[k],
            )
        )
    lines = table(rows, "<>>>><<")
    return [*lines, f"one record in {every}; --json has all"] if every > 1 else lines


def _time(moment: np.datetime64) -> str:
    return str(moment.astype("datetime64[m]")).replace("T", " ")


def _number(value: float, places: int) -> str:
    return f"{value:.{places}f}" if np.isfinite(value) else ("any" if value > 0 else "-")

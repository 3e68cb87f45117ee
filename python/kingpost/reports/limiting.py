"""Text for the command line on limiting significant heights, by linear response and by runs, and on the
operable share of a scatter table."""

from __future__ import annotations

from collections.abc import Hashable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from .tables import table

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

    from ..study.limiting.operability import Operability

MOST_LISTED = 8
MOST_ROWS = 60
"""Largest number of printed rows; `--json` and Python give all."""


def screen(found: xarray.Dataset) -> str:
    """Table of a screened study: the limiting significant height, a row for each combination of the other
    axes."""
    lines = [f"{found.attrs['title']}: linear response about rest in still water, without runs"]
    if "limiting_height_of_all" in found:
        lines += ["", *heights(found)]
    elif "probability" in found:
        lines += ["", "no axis of the significant height", *_largest(found)]
    columns = zip(found["column"].values, found["reason"].values, strict=True)
    lines += [f"warning: {name} is not screened: {reason}" for name, reason in columns if reason]
    if "warning" in found.attrs:
        lines += [f"warning: {found.attrs['warning']}"]
    return "\n".join(lines)


def heights(found: xarray.Dataset) -> list[str]:
    """Table of the limiting significant height over all limits, and the governing limit."""
    of_all, names = found["limiting_height_of_all"], axes_of_heights(found)
    governs = found["governs"].transpose(*names)
    has_interval = "limiting_height_low" in found
    rows = [(*names, "limiting Hs, m", *["interval, m"] * has_interval, "governs")]
    for at in list(np.ndindex(of_all.shape))[:MOST_ROWS]:
        values = (_value(of_all[at][name].item()) for name in names)
        ends = [interval_text(found, at)] * has_interval
        rows.append((*values, height_text(found, at), *ends, str(governs[at].item()) or "-"))
    accepted = accepted_text(found.attrs)
    more = of_all.size - MOST_ROWS
    tail = [f"and {more} rows more: --json prints all"] if more > 0 else []
    aligned = table(rows, ">" * (len(rows[0]) - 1) + "<")
    return [f"limiting significant height, accepted probability {accepted}", *aligned, *tail]


def accepted_text(about: Mapping[Hashable, Any]) -> str:
    """Format the accepted probability and the exposure of limiting heights, from their attributes.

    >>> accepted_text({"acceptance": 0.1, "operation_s": 1800.0})
    '10 % in 1800 s'
    >>> accepted_text({"acceptance": 0.1, "one_off": 1})
    '10 % in an operation'
    """
    exposure = "an operation" if about.get("one_off") else f"{about['operation_s']:g} s"
    return f"{100 * about['acceptance']:g} % in {exposure}"


def height_text(found: xarray.Dataset, at: tuple[int, ...]) -> str:
    """Format a limiting height over all limits, as text if the heights of the study do not reach it."""
    return _height_text(float(found["limiting_height_of_all"].values[at]), studied_heights(found))


def interval_text(found: xarray.Dataset, at: tuple[int, ...]) -> str:
    """Format the interval of a limiting height over all limits; empty without one."""
    if "limiting_height_low" not in found:
        return ""
    ends = [_height_text(float(end), studied_heights(found)) for end in interval_of_all(found, at)]
    return "-" if "-" in ends else " to ".join(ends)


def interval_of_all(found: xarray.Dataset, at: tuple[int, ...] = ()) -> NDArray[np.float64]:
    """Lower and upper end of the interval of the limiting height over all limits, the smallest of the limits'
    ends, at given indices of the axes.

    >>> import xarray
    >>> ends = {"low": [0.0, 1.0], "high": [3.0, 2.0]}
    >>> given = {f"limiting_height_{end}": ("limit", values) for end, values in ends.items()}
    >>> interval_of_all(xarray.Dataset({"limiting_height_of_all": 1.0, **given})).tolist()
    [0.0, 2.0]
    """
    names = axes_of_heights(found)
    ends = [found[f"limiting_height_{end}"].transpose("limit", *names).values for end in ("low", "high")]
    return np.array([np.fmin.reduce(end, axis=0)[at] for end in ends])


def axes_of_heights(found: xarray.Dataset) -> list[str]:
    """Names of the axes of limiting heights, in the order of the array."""
    return [str(dim) for dim in found["limiting_height_of_all"].dims]


def studied_heights(found: xarray.Dataset) -> tuple[float, float] | None:
    """Smallest and largest significant height of the runs; None for limiting heights by linear response."""
    if "limiting_height_state" not in found:
        return None
    axis = next(iter(set(found["probability"].dims) - set(found["limiting_height"].dims)))
    return float(found[axis].min()), float(found[axis].max())


def _height_text(height: float, studied: tuple[float, float] | None) -> str:
    if not np.isfinite(height):
        return "no limit" if np.isinf(height) else "-"
    if studied is not None and height == 0:
        return f"below {studied[0]:g}"
    if studied is not None and height >= studied[1]:
        return f"above {height:g}"
    return f"{height:.2f}"


def operable(share: Operability) -> list[str]:
    """Text on the operable share of a scatter table."""
    lines = [f"operable        {100 * share.share:.1f} % of {share.total:g} occurrences"]
    if share.outside:
        at = _listed(share.outside_periods_s)
        lines.append(
            f"                {100 * share.outside:.1f} % are outside of the study (Tp {at} s), "
            "and count as not operable"
        )
    lines += [f"                {100 * part:.1f} % taken by {name}" for name, part in share.by_limit.items()]
    return lines


def _listed(values: Sequence[float]) -> str:
    """Format numbers; of many only the first and the last."""
    shown = [f"{value:.3g}" for value in values]
    return ", ".join(shown) if len(shown) <= MOST_LISTED else f"{shown[0]} to {shown[-1]}"


def _largest(found: xarray.Dataset) -> list[str]:
    rows = [("limit", "largest probability of all cases")]
    for name in found["limit"].values:
        rows.append((str(name), f"{float(found['probability'].sel(limit=name).max()):.4g}"))
    return table(rows)


def _value(value: Any) -> str:
    return f"{value:g}" if isinstance(value, float) else str(value)

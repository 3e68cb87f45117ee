"""Text for the command line on limiting significant heights, by linear response and by runs, and on the
operable share of a scatter table."""

from __future__ import annotations

from collections.abc import Hashable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from .tables import table

if TYPE_CHECKING:
    import xarray

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
    of_all = found["limiting_height_of_all"]
    names = [str(dim) for dim in of_all.dims]
    governs = found["governs"].transpose(*names)
    rows = [(*names, "limiting Hs, m", "governs")]
    for at in list(np.ndindex(of_all.shape))[:MOST_ROWS]:
        values = (_value(of_all[at][name].item()) for name in names)
        rows.append((*values, height_text(found, at), str(governs[at].item()) or "-"))
    accepted = accepted_text(found.attrs)
    more = of_all.size - MOST_ROWS
    tail = [f"and {more} rows more: --json prints all"] if more > 0 else []
    aligned = table(rows, ">" * (len(names) + 1) + "<")
    return [f"limiting significant height, accepted probability {accepted}", *aligned, *tail]


def accepted_text(about: Mapping[Hashable, Any]) -> str:
    """Format the accepted probability and the exposure of limiting heights, from their attributes.

    >>> accepted_text({"acceptance": 0.1, "operation_s": 1800.0}), accepted_text({"acceptance": 0.1, "one_off": 1})
    ('10 % in 1800 s', '10 % in an operation')
    """
    exposure = "an operation" if about.get("one_off") else f"{about['operation_s']:g} s"
    return f"{100 * about['acceptance']:g} % in {exposure}"


def height_text(found: xarray.Dataset, at: tuple[int, ...]) -> str:
    """Format a limiting height over all limits, as text if the heights of the study do not reach it."""
    height = float(found["limiting_height_of_all"].values[at])
    if not np.isfinite(height):
        return "no limit" if np.isinf(height) else "-"
    if "limiting_height_state" in found:
        axis = next(iter(set(found["probability"].dims) - set(found["limiting_height"].dims)))
        if height == 0:
            return f"below {float(found[axis].min()):g}"
        if height >= float(found[axis].max()):
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

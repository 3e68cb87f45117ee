"""What the command line prints of a screened study."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .tables import table

if TYPE_CHECKING:
    import xarray

MOST_ROWS = 60
"""Rows that are printed; --json and Python have all."""


def text(found: xarray.Dataset) -> str:
    """The limiting significant height by linear response, a row for each combination of the other axes."""
    lines = [f"{found.attrs['title']}: linear response about rest in still water, without runs"]
    if "limiting_height_of_all" in found:
        lines += _heights(found)
    elif "probability" in found:
        lines += ["", "no axis of the significant height", *_largest(found)]
    columns = zip(found["column"].values, found["reason"].values, strict=True)
    lines += [f"warning: {name} is not screened: {reason}" for name, reason in columns if reason]
    if "warning" in found.attrs:
        lines += [f"warning: {found.attrs['warning']}"]
    return "\n".join(lines)


def _heights(found: xarray.Dataset) -> list[str]:
    heights = found["limiting_height_of_all"]
    names = [str(dim) for dim in heights.dims]
    governs = found["governs"].transpose(*names)
    rows = [(*names, "limiting Hs, m", "governs")]
    for at in list(np.ndindex(heights.shape))[:MOST_ROWS]:
        one = heights[at]
        height = float(one)
        shown = "no limit" if np.isinf(height) else f"{height:.2f}" if np.isfinite(height) else "-"
        values = (_value(one[name].item()) for name in names)
        rows.append((*values, shown, str(governs[at].item()) or "-"))
    accepted = f"accepted probability {found.attrs['acceptance']:g} in {found.attrs['operation_s']:g} s"
    more = heights.size - MOST_ROWS
    tail = [f"and {more} rows more: --json prints all"] if more > 0 else []
    return [accepted, "", *table(rows, ">" * (len(names) + 1) + "<"), *tail]


def _largest(found: xarray.Dataset) -> list[str]:
    rows = [("limit", "largest probability of all cases")]
    for name in found["limit"].values:
        rows.append((str(name), f"{float(found['probability'].sel(limit=name).max()):.4g}"))
    return table(rows)


def _value(value: Any) -> str:
    return f"{value:g}" if isinstance(value, float) else str(value)

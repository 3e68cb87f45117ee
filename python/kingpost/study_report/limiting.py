"""Report on the limiting sea, by time-domain runs and by linear response, and on the operable share of a
scatter table."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import KingpostError
from ..reports.limiting import accepted_text, axes_of_heights, height_text, interval_text
from ..results.entries import sea_of
from ..study.design.plan import Plan
from ..study.limiting.operability import Operability
from ..study.limiting.operable_share import of_plan
from . import limiting_figure
from .blocks import Block, Paragraph, Section, Table

if TYPE_CHECKING:
    import xarray


WHAT_IT_IS = (
    "The limiting significant height is the largest at which each limit is exceeded in the operation with at "
    "most the accepted probability. By runs: the worst values over the seeds. Those of an operation that "
    "happens once are its sample, by their order; those of stationary runs and steps have a Gumbel "
    "distribution, extrapolated to their duration. An interval from below the smallest height means that the "
    "seeds do not show that any height is acceptable. By linear response: Rice's rate of crossings about "
    "rest in still water, without the steps of the operation, slack lines, bodies that touch and quadratic "
    "forces."
)
FEW = 12
"""Largest number of cases in a plain list; for more, a table of two axes precedes it."""
BY_RUNS = "Command: kingpost study study.yaml -o DIR --resume; in Python kingpost.study.limiting.runs."
BY_SCREEN = "Command: kingpost study study.yaml --screen."
MONTHS = ("January", "February", "March", "April", "May", "June", "July", "August", "September", "October",
          "November", "December")  # fmt: skip


def section(by_runs: xarray.Dataset | str, by_screen: xarray.Dataset | str) -> Section:
    """Section with limiting heights over the axes, by both methods, and the governing limits.

    Parameters
    ----------
    by_runs, by_screen
        Data sets with ``limiting_height_of_all`` and ``governs``, or the reason why there is none.
    """
    blocks: list[Block] = [
        Paragraph(WHAT_IT_IS),
    ]
    for found, what in ((by_runs, "by runs"), (by_screen, "by linear response")):
        if isinstance(found, str):
            blocks.append(Paragraph(f"None {what}: {found}."))
    known = {what: found for found, what in ((by_runs, "by runs"), (by_screen, "by linear response"))
             if not isinstance(found, str)}  # fmt: skip
    if known:
        picture = limiting_figure.picture(known, BY_RUNS if "by runs" in known else BY_SCREEN)
        blocks += [picture] if picture else []
        for what, found in known.items():
            blocks += [*_matrix(found, what), _table(found, what)]
    if len(known) == 2:
        blocks.append(Paragraph(_difference(known["by runs"], known["by linear response"])))
    return Section("limiting", "The limiting sea", blocks)


def _table(found: xarray.Dataset, what: str) -> Table:
    names = axes_of_heights(found)
    heights, governs = found["limiting_height_of_all"], found["governs"].transpose(*names)
    rows = []
    for at in np.ndindex(heights.shape):
        height = heights[at]
        values = [_value(height[name].item()) for name in names]
        ends = interval_text(found, at) or "-"
        rows.append((*values, height_text(found, at), ends, str(governs[at].item()) or "-"))
    head = (*names, "limiting Hs, m", "interval, m", "governs")
    origin = BY_RUNS if what == "by runs" else BY_SCREEN
    if "confidence" in found.attrs:
        origin += f" Confidence of the intervals over the seeds: {100 * found.attrs['confidence']:g} %."
    accepted = f"accepted probability {accepted_text(found.attrs)}"
    numbers = range(len(names) + 2)
    return Table(f"Limiting significant height {what}, {accepted}", head, rows, origin, tuple(numbers))


def _matrix(found: xarray.Dataset, what: str) -> list[Table]:
    """Tabulate the heights over two axes; nothing for few cases or another number of axes."""
    names, heights = axes_of_heights(found), found["limiting_height_of_all"]
    if len(names) != 2 or heights.size <= FEW:
        return []
    down, across = names
    head = (down, *map(_value, heights[across].values.tolist()))
    rows = [
        (_value(value), *(height_text(found, (i, k)) for k in range(heights.shape[1])))
        for i, value in enumerate(heights[down].values.tolist())
    ]
    origin = BY_RUNS if what == "by runs" else BY_SCREEN
    title = f"Heights {what}, m, one column for each {across}"
    return [Table(title, head, rows, origin, tuple(range(len(head))))]


def _value(value: Any) -> str:
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def _difference(by_runs: xarray.Dataset, by_screen: xarray.Dataset) -> str:
    """Compare both methods in the cases in which both give a height."""
    runs, linear = by_runs["limiting_height_of_all"], by_screen["limiting_height_of_all"]
    runs, linear = runs.broadcast_like(linear), linear.broadcast_like(runs)
    state = by_runs["limiting_height_state"].values
    if not (state == "found").any() or runs.dims != linear.transpose(*runs.dims).dims:
        return "The two cannot be compared: no height by runs lies between those of the study."
    ratio = (linear.transpose(*runs.dims) / runs).values
    top = float(by_runs[sea_of(by_runs)["significant_height"]].max())
    ratio = ratio[np.isfinite(ratio) & (runs.values > 0) & (runs.values < top)]
    if not ratio.size:
        return "The two cannot be compared: no height by runs lies between those of the study."
    return (
        f"Where the runs bracket it, linear response gives {ratio.min():.2f} to {ratio.max():.2f} times the "
        f"height by runs (median {np.median(ratio):.2f}, {ratio.size} cases)."
    )


def operability_section(
    plan: Plan, by_runs: xarray.Dataset | str, by_screen: xarray.Dataset | str
) -> Section:
    """Section with the share of the site's sea states in which work is possible."""
    blocks: list[Block] = []
    for found, what in ((by_runs, "by runs"), (by_screen, "by linear response")):
        if isinstance(found, str):
            continue
        try:
            shares = list(of_plan(plan, found))
        except KingpostError as error:
            blocks.append(Paragraph(f"None {what}: {error}."))
            continue
        if len(shares) == 1 and not shares[0][0]:
            blocks.append(_shares(shares[0][1], what))
        elif shares:
            blocks.append(_by_direction(shares, what))
    none = Paragraph("No scatter table (field scatter of the study) or no limiting heights: no operability.")
    return Section("operability", "Operability", blocks or [none])


def _by_direction(shares: Sequence[tuple[str, Operability]], what: str) -> Table:
    rows = []
    for direction, share in shares:
        worst = max(share.by_limit, key=lambda name: share.by_limit[name], default="-")
        rows.append((direction, f"{100 * share.share:.1f} %", f"{100 * share.outside:.1f} %", worst))
    head = ("all waves with", "operable", "outside of the study", "limit that takes most")
    title = f"Share of the scatter table's {shares[0][1].total:g} occurrences, {what}"
    return Table(title, head, rows, _origin(what), (1, 2))


def _shares(share: Operability, what: str) -> Table:
    rows = [
        ("operable", f"{100 * share.share:.1f} %"),
        (
            "outside of the studied periods and directions, counted as not operable",
            f"{100 * share.outside:.1f} %",
        ),
        *((f"taken by {name}", f"{100 * part:.1f} %") for name, part in share.by_limit.items()),
        *((MONTHS[month - 1], f"{100 * part:.1f} %") for month, part in share.by_month.items()),
    ]
    title = f"Share of the scatter table's {share.total:g} occurrences, {what}"
    return Table(title, ("what", "share"), rows, _origin(what), (1,))


def _origin(what: str) -> str:
    return f"Files: study.yaml (field scatter), results.zarr. {BY_RUNS if what == 'by runs' else BY_SCREEN}"

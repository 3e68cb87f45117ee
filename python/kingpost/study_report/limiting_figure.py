"""Picture of limiting significant heights over the peak period, with their intervals."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ..reports.limiting import axes_of_heights, interval_of_all, studied_heights
from ..results.entries import sea_of
from .blocks import Picture

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

STYLES = {"by runs": ("o-", "C0"), "by linear response": ("s--", "C1")}
COLUMNS = 3
MOST_PANELS = 24


def picture(known: dict[str, xarray.Dataset], origin: str) -> Picture | None:
    """Draw limiting heights over the peak period, a panel for each combination of the other axes; None
    without an axis of the period.

    Parameters
    ----------
    known
        Data sets of limiting heights by the method, one of `STYLES`.
    origin
        Origin of the numbers.
    """
    first = next(iter(known.values()))
    period = sea_of(first).get("peak_period")
    if period is None or period not in axes_of_heights(first):
        return None
    others = [name for name in axes_of_heights(first) if name != period]
    panels = list(np.ndindex(first["limiting_height_of_all"].transpose(*others, period).shape[:-1]))
    figure = draw(known, period, others, panels[:MOST_PANELS])
    left_out = len(panels) - MOST_PANELS
    more = f" {left_out} more are in the tables only." if left_out > 0 else ""
    return Picture.of(
        figure,
        f"Limiting significant height over the peak period, {len(panels[:MOST_PANELS])} panels",
        "Limiting significant height over the peak period. Bars: intervals over the seeds. Arrows point "
        "beyond the studied heights; a thick one down: a limit fails at the smallest height of the study."
        f"{more}",
        origin,
    )


def draw(
    known: dict[str, xarray.Dataset], period: str, others: Sequence[str], panels: Sequence[tuple[int, ...]]
) -> Figure:
    """Draw the panels at the given indices of the axes other than the period."""
    from matplotlib.figure import Figure

    columns = min(len(panels), COLUMNS)
    lines = -(-len(panels) // columns)
    size = (9, 4.2 if lines == 1 else 2.3 * lines + 0.4)
    figure = Figure(figsize=size, layout="constrained")
    grid = figure.subplots(lines, columns, sharex=True, sharey=True, squeeze=False)
    top = max(_top(found) for found in known.values())
    first = next(iter(known.values()))["limiting_height_of_all"].transpose(*others, period)
    for axes, at in zip(grid.flat, panels, strict=False):
        if others:
            axes.set_title(_case(first[at], others), fontsize=8)
        for what, found in known.items():
            _curve(axes, found.transpose(..., *others, period), at, period, (what, top))
        axes.grid(alpha=0.3)
        axes.tick_params(labelsize=8)
    for axes in grid.flat[len(panels) :]:
        axes.set_visible(False)
    grid.flat[0].set_ylim(0, 1.12 * top)
    grid.flat[0].legend(fontsize=7)
    figure.supxlabel(period, fontsize=9)
    figure.supylabel("limiting significant height, m", fontsize=9)
    return figure


def _top(found: xarray.Dataset) -> float:
    """Largest height that is drawn: the largest studied or found one."""
    heights = found["limiting_height_of_all"].values
    studied = studied_heights(found)
    largest = [] if studied is None else [studied[1]]
    return max([*heights[np.isfinite(heights)], *largest], default=1.0) or 1.0


def _curve(
    axes: Axes, found: xarray.Dataset, at: tuple[int, ...], period: str, of: tuple[str, float]
) -> None:
    what, top = of
    style, colour = STYLES[what]
    x = np.asarray(found[period].values, float)
    heights = found["limiting_height_of_all"].values[at]
    studied = studied_heights(found)
    least, most = studied or (0.0, top)
    below, above = heights == 0, np.isinf(heights) | ((heights >= most) & (studied is not None))
    # Beyond the studied heights the curve goes on at their end, where an arrow points outward.
    y = np.where(below, least, np.where(above, most, heights))
    inside = np.isfinite(y) & ~below & ~above
    axes.plot(x, y, style[1:], color=colour, lw=1.2)
    axes.plot(x[inside], y[inside], style[0], color=colour, ms=3.5)
    axes.plot([], [], style, color=colour, ms=3.5, lw=1.2, label=what)
    for chosen, end in ((below, max(0.0, least - 0.15 * top)), (above, 1.1 * most)):
        axes.plot(x[chosen], y[chosen], style[0], color=colour, mfc="white", ms=5, zorder=3)
        for at_s, height in zip(x[chosen], y[chosen], strict=True):
            _arrow(axes, at_s, (height, end), colour, width=2.0)
    if studied is not None and "limiting_height_low" in found:
        _intervals(axes, x, interval_of_all(found, at), (most, colour))


def _intervals(axes: Any, x: NDArray[np.float64], ends: NDArray[np.float64], of: tuple[float, str]) -> None:
    """Bars from the lower to the upper end, along the period; an end beyond the studied heights is an arrow
    to the edge of the panel."""
    most, colour = of
    for period, low, high in np.column_stack([x, *ends]).tolist():
        if np.isnan(low) or np.isnan(high):
            continue
        axes.vlines(period, low, high, color=colour, lw=1.0, alpha=0.7)
        if low == 0:
            _arrow(axes, period, (0.08 * most, 0.0), colour)
        if high >= most:
            _arrow(axes, period, (most, 1.1 * most), colour)


def _arrow(axes: Any, period: float, heights: tuple[float, float], colour: str, width: float = 1.0) -> None:
    """Arrow at a period, from one height to another."""
    style = {"arrowstyle": "-|>" if width > 1 else "->", "color": colour, "lw": width}
    begin, end = heights
    axes.annotate("", (period, end), (period, begin), arrowprops=style | {"shrinkA": 0, "shrinkB": 0})


def _case(of: xarray.DataArray, names: Sequence[str]) -> str:
    return ", ".join(f"{name} {of[name].item():.4g}" if isinstance(of[name].item(), float)
                     else f"{name} {of[name].item()}" for name in names)  # fmt: skip

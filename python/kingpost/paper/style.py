"""Style of the paper's plots: each quantity has the same colour in all of them."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from .. import output

UNDAMPED: dict[str, Any] = {"color": "#0072B2", "linewidth": 1.8}
DAMPED: dict[str, Any] = {"color": "#D55E00", "linewidth": 1.8, "linestyle": (0, (5, 2))}
INTEGRATORS: dict[str, dict[str, Any]] = {
    "forward_euler": {"color": "#CC79A7", "marker": "o", "linewidth": 4.0, "markersize": 9},
    "midpoint_euler": {"color": "#E69F00", "marker": "s"},
    "semi_implicit_euler": {"color": "#999999", "marker": "v"},
    "rk4": {"color": "#009E73", "marker": "D"},
    "dormand_prince": {"color": "#000000", "marker": "*", "markersize": 9},
    "newmark": {"color": "#0072B2", "marker": "P", "linewidth": 4.0, "markersize": 9},
    "generalized_alpha": {"color": "#D55E00", "marker": "^"},
    "implicit_midpoint": {"color": "#56B4E9", "marker": "X"},
}
_SETTINGS: Any = {
    "figure.constrained_layout.use": True,
    "figure.dpi": 100,
    "savefig.dpi": 160,
    "axes.axisbelow": True,
    "savefig.facecolor": "white",
    "svg.hashsalt": "kingpost",
    "font.size": 11,
    "axes.titlesize": 12,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#d9d9d9",
    "grid.linewidth": 0.6,
    "legend.frameon": False,
}


@contextmanager
def plotting() -> Iterator[Any]:
    """Matplotlib's pyplot in the project's style, without a screen."""
    import matplotlib

    matplotlib.use("agg")
    from matplotlib import pyplot

    with matplotlib.rc_context(_SETTINGS):
        yield pyplot


def save(figure: Any, path: Path) -> None:
    """Write a figure as PNG and SVG and close it."""
    from matplotlib import pyplot

    for ending, metadata in ((".png", {}), (".svg", {"Date": None})):
        with output.whole(path.with_suffix(ending)) as beside:
            figure.savefig(beside, metadata=metadata)
    pyplot.close(figure)

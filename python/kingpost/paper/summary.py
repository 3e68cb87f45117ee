"""The paper's largest rates in a small table, for the terminal and for the page."""

from __future__ import annotations

import numpy as np

from .figures import NOTHING, Figure

Table = list[tuple[str, ...]]


def largest_rates(drawn: list[Figure]) -> Table:
    """Largest pitch, yaw and roll rate of each run, rad/s: a header, then a row for each run."""
    rows: Table = [("", *(f"{name} rate, rad/s" for name in drawn[0].undamped))]
    for figure in drawn:
        for label, rates in (("without damping", figure.undamped), ("with damping", figure.damped)):
            peaks = (_peak(values) for values in rates.values())
            rows.append((f"Fig. {figure.case.number}, {figure.case.title}, {label}", *peaks))
    return rows


def _peak(values: np.ndarray) -> str:
    largest = np.abs(values).max()
    return f"{largest:.4f}" if largest > NOTHING else "0"

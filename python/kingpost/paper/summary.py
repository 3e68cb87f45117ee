"""The paper's results in two small tables, for the terminal and for the page."""

from __future__ import annotations

import numpy as np

from . import integrators
from .figures import NOTHING, Figure
from .integrators import Errors

Table = list[tuple[str, ...]]


def largest_rates(drawn: list[Figure]) -> Table:
    """Largest pitch, yaw and roll rate of each run, rad/s; a head, then a row a run."""
    rows: Table = [("", *(f"{name} rate, rad/s" for name in drawn[0].undamped))]
    for figure in drawn:
        for label, rates in (("without damping", figure.undamped), ("with damping", figure.damped)):
            peaks = (_peak(values) for values in rates.values())
            rows.append((f"Fig. {figure.case.number}, {figure.case.title}, {label}", *peaks))
    return rows


def orders(compared: list[Errors]) -> Table:
    """Order of each integrator, and the slopes of its errors against step size."""
    rows: Table = [("Integrator", "Order", "Slope, energy", "Slope, momentum", "Slope, rotation")]
    for errors in compared:
        slopes = (f"{slope:.2f}" for slope in errors.slopes())
        rows.append(
            (integrators.LABELS[errors.integrator], str(integrators.ORDERS[errors.integrator]), *slopes)
        )
    return rows


def _peak(values: np.ndarray) -> str:
    largest = np.abs(values).max()
    return f"{largest:.4f}" if largest > NOTHING else "0"

"""Energy, momentum and rotation error of each integrator against the step size."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..scenario import load
from ..simulate import Simulation
from .figures import AT_CENTRE
from .style import INTEGRATORS, plotting, save

if TYPE_CHECKING:
    import xarray

DURATION_S = 0.5
REFERENCE_STEP_S = 0.0001
STEPS_S = (0.0005, 0.001, 0.002, 0.005, 0.01, 0.02)
ORDERS = {"forward_euler": 1, "midpoint_euler": 1, "rk4": 4}
LABELS = {
    "forward_euler": "Forward Euler",
    "midpoint_euler": "Euler, mean rate in the rotation",
    "rk4": "RK4 (Munthe-Kaas)",
}
NAME = "integrators"
ENERGY_ROUNDING = 1e-11
MOMENTUM_ROUNDING = 1e-6
ROTATION_ROUNDING = 1e-12
"""Errors below these (relative; N m s; rad) are rounding, and no part of a slope."""


@dataclass(frozen=True)
class Errors:
    """Errors of one integrator at the end of the run, one value per step size.

    Attributes
    ----------
    energy
        Energy error over the work done by the motors, dimensionless.
    momentum
        Angular momentum about the held centre that should be zero, N m s.
    rotation
        Angle between the ship's orientation and that of RK4 at `REFERENCE_STEP_S`, rad.
    """

    integrator: str
    energy: np.ndarray
    momentum: np.ndarray
    rotation: np.ndarray

    def slopes(self) -> tuple[float, float, float]:
        """Orders of the three errors, fitted where they exceed rounding."""
        return (
            slope(self.energy, ENERGY_ROUNDING),
            slope(self.momentum, MOMENTUM_ROUNDING),
            slope(self.rotation, ROTATION_ROUNDING),
        )


def slope(errors: np.ndarray, rounding: float) -> float:
    """Slope of errors against `STEPS_S` on logarithmic axes, where they exceed rounding."""
    seen = np.abs(errors) > rounding
    return float(np.polyfit(np.log(np.array(STEPS_S)[seen]), np.log(np.abs(errors)[seen]), 1)[0])


def run(progress: Callable[[], None]) -> list[Errors]:
    """Run every integrator at every step size: both motors, no load, crane at the centre."""
    reference = _orientation(_end("rk4", REFERENCE_STEP_S))
    found = []
    for integrator in ORDERS:
        ends = []
        for step_s in STEPS_S:
            ends.append(_end(integrator, step_s))
            progress()
        energy = np.array([float(end["energy_error"] / end["work_done"]) for end in ends])
        momentum = np.array([float(end["momentum_error"]) for end in ends])
        rotation = np.array([angle(_orientation(end), reference) for end in ends])
        found.append(Errors(integrator, energy, momentum, rotation))
    return found


def _end(integrator: str, step_s: float) -> xarray.Dataset:
    settings = {"integrator": integrator, "step_s": step_s, "duration_s": DURATION_S}
    overrides = {f"simulation.{name}": value for name, value in settings.items()}
    overrides |= {**AT_CENTRE, "simulation.record_every_s": DURATION_S}
    return Simulation(load("paper", overrides, motor_1=True, motor_2=True)).run().isel(time=-1)


def _orientation(end: xarray.Dataset) -> np.ndarray:
    return end["orientation"].sel(body="ship").values


def angle(one: np.ndarray, other: np.ndarray) -> float:
    """Angle between two unit quaternions (w, x, y, z), rad.

    >>> angle(np.array([1.0, 0.0, 0.0, 0.0]), np.array([1.0, 5e-10, 0.0, 0.0]))
    1e-09
    """
    w, v = one[0] * other[1:] - other[0] * one[1:], np.cross(one[1:], other[1:])
    return float(2 * np.arcsin(min(1.0, float(np.linalg.norm(w - v)))))


def write(folder: Path, found: list[Errors]) -> None:
    """Write the errors as CSV and draw them."""
    import pandas

    columns = {"step_s": np.array(STEPS_S)}
    for errors in found:
        columns[f"{errors.integrator}_energy_error_relative"] = errors.energy
        columns[f"{errors.integrator}_momentum_error_N_m_s"] = errors.momentum
        columns[f"{errors.integrator}_rotation_error_rad"] = errors.rotation
    pandas.DataFrame(columns).to_csv(folder / f"{NAME}.csv", index=False)
    draw(folder, found)


PANELS = {
    "energy": ("Energy", "|energy error| / work of the motors"),
    "momentum": ("Angular momentum", "|momentum error|, N m s"),
    "rotation": ("Ship's rotation", "angle from the true orientation, rad"),
}


def draw(folder: Path, found: list[Errors]) -> None:
    """Draw the errors on logarithmic axes with the slope of each order."""
    with plotting() as pyplot:
        drawn, panels = pyplot.subplots(1, 3, figsize=(12, 4.8), sharex=True)
        for panel, (name, (title, unit)) in zip(panels, PANELS.items(), strict=True):
            for errors in found:
                label, style = LABELS[errors.integrator], INTEGRATORS[errors.integrator]
                panel.loglog(STEPS_S, np.abs(getattr(errors, name)), label=label, **style)
            for errors in found[1:]:
                _reference_slope(panel, np.abs(getattr(errors, name)), ORDERS[errors.integrator])
            panel.set(title=title, ylabel=unit, xlabel="Step size, s")
        drawn.legend(*panels[0].get_legend_handles_labels(), loc="outside lower center", ncols=3)
        save(drawn, folder / NAME)


def _reference_slope(panel: Any, errors: np.ndarray, order: int) -> None:
    """A dotted line of an order, a little below the curve that it measures."""
    steps = np.array(STEPS_S)
    line = 0.3 * errors[-1] * (steps / steps[-1]) ** order
    shown = steps >= steps[-1] / 10
    panel.plot(steps[shown], line[shown], color="#666666", linestyle=":", linewidth=1.2)
    panel.annotate(f"order {order}", (steps[-3], line[-3]), xytext=(6, -12), color="#444444",
                   textcoords="offset points", fontsize=10)  # fmt: skip

"""Energy and momentum error of each integrator against the step size."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ..simulate import Simulation, load
from .figures import AT_CENTRE
from .style import INTEGRATORS, plotting, save

DURATION_S = 0.5
STEPS_S = (0.0005, 0.001, 0.002, 0.005, 0.01, 0.02)
ORDERS = {"forward_euler": 1, "midpoint_euler": 1, "rk4": 4}
LABELS = {
    "forward_euler": "Forward Euler",
    "midpoint_euler": "Euler, midpoint rate",
    "rk4": "RK4 (Munthe-Kaas)",
}
NAME = "integrators"
ENERGY_ROUNDING = 1e-11
MOMENTUM_ROUNDING = 1e-6
"""Errors below these (relative; N m s) are rounding, and no part of a slope."""


@dataclass(frozen=True)
class Errors:
    """Errors of one integrator at the end of the run, one value per step size.

    Attributes
    ----------
    energy
        Energy error over the work done by the motors, dimensionless.
    momentum
        Angular momentum about the held centre that should be zero, N m s.
    """

    integrator: str
    energy: np.ndarray
    momentum: np.ndarray

    def slopes(self) -> tuple[float, float]:
        """Orders of the energy and the momentum error, fitted where they exceed rounding."""
        return slope(self.energy, ENERGY_ROUNDING), slope(self.momentum, MOMENTUM_ROUNDING)


def slope(errors: np.ndarray, rounding: float) -> float:
    """Slope of errors against `STEPS_S` on logarithmic axes, where they exceed rounding."""
    seen = np.abs(errors) > rounding
    return float(np.polyfit(np.log(np.array(STEPS_S)[seen]), np.log(np.abs(errors)[seen]), 1)[0])


def run(progress: Callable[[], None]) -> list[Errors]:
    """Run every integrator at every step size: both motors, no load, crane at the centre."""
    found = []
    for integrator in ORDERS:
        ends = []
        for step_s in STEPS_S:
            ends.append(_end(integrator, step_s))
            progress()
        energy, momentum = np.array(ends).T
        found.append(Errors(integrator, energy, momentum))
    return found


def _end(integrator: str, step_s: float) -> tuple[float, float]:
    settings = {"integrator": integrator, "step_s": step_s, "duration_s": DURATION_S}
    overrides = {f"simulation.{name}": value for name, value in settings.items()}
    overrides |= {**AT_CENTRE, "simulation.record_every_s": DURATION_S}
    results = Simulation(load("paper", overrides, motor_1=True, motor_2=True)).run()
    last = results.isel(time=-1)
    return float(last["energy_error"] / last["work_done"]), float(last["momentum_error"])


def write(folder: Path, found: list[Errors]) -> None:
    """Write the errors as CSV and draw them."""
    import pandas

    columns = {"step_s": np.array(STEPS_S)}
    for errors in found:
        columns[f"{errors.integrator}_energy_error_relative"] = errors.energy
        columns[f"{errors.integrator}_momentum_error_N_m_s"] = errors.momentum
    pandas.DataFrame(columns).to_csv(folder / f"{NAME}.csv", index=False)
    draw(folder, found)


def draw(folder: Path, found: list[Errors]) -> None:
    """Draw both errors on logarithmic axes with the slope of each order."""
    steps = np.array(STEPS_S)
    with plotting() as pyplot:
        drawn, panels = pyplot.subplots(1, 2, figsize=(11, 4.6), sharex=True)
        for errors in found:
            style = INTEGRATORS[errors.integrator]
            label = LABELS[errors.integrator]
            panels[0].loglog(steps, np.abs(errors.energy), label=label, **style)
            panels[1].loglog(steps, np.abs(errors.momentum), **style)
        for panel, index in zip(panels, (0, 1), strict=True):
            _reference_slopes(panel, found, index)
            panel.set_xlabel("Step size, s")
        panels[0].set(title="Energy", ylabel="|energy error| / work of the motors")
        panels[1].set(title="Angular momentum about the held centre", ylabel="|momentum error|, N m s")
        drawn.legend(*panels[0].get_legend_handles_labels(), loc="outside lower center", ncols=3)
        save(drawn, folder / NAME)


def _reference_slopes(panel: object, found: list[Errors], index: int) -> None:
    """Dashed lines of order 1 and 4, a little below the curves that they measure."""
    steps = np.array(STEPS_S)
    for errors in found[1:]:
        values = np.abs((errors.energy, errors.momentum)[index])
        order = ORDERS[errors.integrator]
        line = 0.4 * values[-1] * (steps / steps[-1]) ** order
        shown = steps >= steps[-1] / 10
        panel.plot(steps[shown], line[shown], color="#666666", linestyle=":", linewidth=1.2)
        panel.annotate(f"order {order}", (steps[-3], line[-3]), xytext=(4, -12), color="#444444",
                       textcoords="offset points", fontsize=10)  # fmt: skip

"""Every integrator on the paper's case and on a stiff one: errors, orders, cost, largest step."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from time import perf_counter

import numpy as np

from ..errors import RunError
from ..scenario import load
from ..simulation.simulate import Simulation
from .figures import AT_CENTRE

DURATION_S = 0.5
REFERENCE_STEP_S = 0.0001
STEPS_S = (0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 0.05)
SHOWN_STEP_S = 0.01
TIMED_STEP_S = 0.001
TOLERANCES = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8)
ORDERS = {
    "forward_euler": 1,
    "midpoint_euler": 1,
    "semi_implicit_euler": 1,
    "rk4": 4,
    "dormand_prince": 5,
    "newmark": 2,
    "generalized_alpha": 2,
    "implicit_midpoint": 2,
}
LABELS = {
    "forward_euler": "Forward Euler",
    "midpoint_euler": "Euler, mean rate in the rotation",
    "semi_implicit_euler": "Semi-implicit Euler",
    "rk4": "RK4 (Munthe-Kaas)",
    "dormand_prince": "Dormand-Prince 5(4)",
    "newmark": "Newmark",
    "generalized_alpha": "Generalized-alpha, 0.8",
    "implicit_midpoint": "Implicit midpoint",
}
ADAPTIVE = "dormand_prince"
CASES: dict[str, dict[str, object]] = {
    "paper": {},
    "stiff": {"bodies.arm.joint.revolute.spring": {"stiffness_N_m_per_rad": 1e9}},
}
"""Both motors, no load, crane at the centre; then the arm on a spring that swings at about 56 Hz."""
USABLE = 0.1
"""Criteria of a usable step: largest energy error as a fraction of the work, and largest error of the tower's
angle, rad."""
ENERGY_ROUNDING = 1e-11
MOMENTUM_ROUNDING = 1e-6
ROTATION_ROUNDING = 1e-12
"""Errors below these (relative; N m s; rad) are rounding and are left out of slopes."""


@dataclass(frozen=True)
class Point:
    """Errors and cost at the end of one run.

    Attributes
    ----------
    setting
        Step, s; for Dormand-Prince the tolerance, absolute and relative.
    energy
        Magnitude of the energy error over the work done by the motors, dimensionless.
    momentum
        Magnitude of the error of the angular momentum about the held centre, N m s.
    rotation, slew
        Difference of the ship's orientation, and of the tower's angle, from RK4 at `REFERENCE_STEP_S`, rad.
    evaluations
        Evaluations of the right-hand side per simulated second.
    """

    setting: float
    energy: float
    momentum: float
    rotation: float
    slew: float
    evaluations: float


@dataclass(frozen=True)
class Compared:
    """One integrator: its runs by case, computing time per simulated second at `TIMED_STEP_S`, largest steps
    by case."""

    integrator: str
    points: dict[str, list[Point]]
    time_ms: float
    evaluations: float
    largest_step_s: dict[str, float]

    def slopes(self) -> tuple[float, float, float] | None:
        """Orders of energy, momentum and rotation error on the paper's case; `None` with error control."""
        if self.integrator == ADAPTIVE:
            return None
        points = [point for point in self.points["paper"] if point.setting <= SHOWN_STEP_S]
        steps = [point.setting for point in points]
        return (
            slope(steps, [point.energy for point in points], ENERGY_ROUNDING),
            slope(steps, [point.momentum for point in points], MOMENTUM_ROUNDING),
            slope(steps, [point.rotation for point in points], ROTATION_ROUNDING),
        )

    def shown(self) -> Point:
        """The run at `SHOWN_STEP_S` on the paper's case, or at the default relative tolerance."""
        setting = 1e-6 if self.integrator == ADAPTIVE else SHOWN_STEP_S
        return next(point for point in self.points["paper"] if point.setting == setting)


def slope(steps: list[float], errors: list[float], rounding: float) -> float:
    """Slope of errors against steps on logarithmic axes, for errors above rounding.

    >>> slope([1.0, 2.0, 4.0], [1e-3, 4e-3, 16e-3], 1e-9)
    2.0
    """
    seen = np.array(errors) > rounding
    if seen.sum() < 2:
        return float("nan")
    fit = np.polyfit(np.log(np.array(steps)[seen]), np.log(np.array(errors)[seen]), 1)
    return float(round(fit[0], 6))


def run(progress: Callable[[], None]) -> list[Compared]:
    """Run every integrator on both cases; `progress` is called once for each of them."""
    references = {case: _Run(case, "rk4", REFERENCE_STEP_S) for case in CASES}
    for reference in references.values():
        reference.finish()
    found = []
    for integrator in ORDERS:
        points, largest = {}, {}
        for case, reference in references.items():
            settings = TOLERANCES if integrator == ADAPTIVE else STEPS_S
            ends = (_Run(case, integrator, setting) for setting in settings)
            points[case] = [end.point(reference) for end in ends if end.finish()]
            largest[case] = largest_step_s(case, integrator, reference)
        found.append(Compared(integrator, points, *_cost(integrator), largest))
        progress()
    return found


def largest_step_s(case: str, integrator: str, reference: _Run) -> float:
    """The largest step, in a series of steps each a fifth longer, up to which all are usable; NaN for an
    integrator that chooses its own steps, 0 if none is usable."""
    if integrator == ADAPTIVE:
        return float("nan")
    largest, most = 0.0, round(DURATION_S / TIMED_STEP_S)
    for count in dict.fromkeys(int(most / 1.2**k) for k in range(40)):
        end = _Run(case, integrator, DURATION_S / max(count, 1))
        if not end.finish():
            break
        point = end.point(reference)
        if max(point.energy, point.slew) > USABLE:
            break
        largest = end.setting
    return largest


def _cost(integrator: str) -> tuple[float, float]:
    """Computing time, ms, and evaluations per simulated second of the paper's case, the best of three."""
    runs = [_Run("paper", integrator, 1e-6 if integrator == ADAPTIVE else TIMED_STEP_S) for _ in range(3)]
    times = []
    for one in runs:
        start = perf_counter()
        one.finish()
        times.append(perf_counter() - start)
    return 1000 * min(times) / DURATION_S, runs[0].simulation.evaluations / DURATION_S


class _Run:
    """A run of half a second, of which only the end is used."""

    def __init__(self, case: str, integrator: str, setting: float) -> None:
        step_s = TIMED_STEP_S if integrator == ADAPTIVE else setting
        overrides = {
            **AT_CENTRE,
            **CASES[case],
            "simulation.integrator": integrator,
            "simulation.step_s": step_s,
        }
        if integrator == ADAPTIVE:
            path = f"simulation.{ADAPTIVE}"
            overrides |= {f"{path}.absolute_tolerance": setting, f"{path}.relative_tolerance": setting}
        self.setting = setting
        self.simulation = Simulation(load("paper", overrides, motor_1=True, motor_2=True))
        self.steps = round(DURATION_S / step_s)

    def finish(self) -> bool:
        """Step to the end; return whether it was reached."""
        try:
            self.simulation.step(self.steps)
        except RunError:
            return False
        self.row = self.simulation.row()
        return bool(np.isfinite(self.row).all())

    def value(self, variable: str) -> float:
        """A scalar channel at the end."""
        return float(
            self.row[next(c["offset"] for c in self.simulation.channels if c["variable"] == variable)]
        )

    def point(self, reference: _Run) -> Point:
        """The quantities that are compared at the end."""
        q, true = self.simulation.state.q, reference.simulation.state.q
        return Point(
            setting=self.setting,
            energy=abs(self.value("energy_error") / self.value("work_done")),
            momentum=abs(self.value("momentum_error")),
            rotation=angle(q[3:7], true[3:7]),
            slew=abs(float(q[7] - true[7])),
            evaluations=self.simulation.evaluations / DURATION_S,
        )


def angle(one: np.ndarray, other: np.ndarray) -> float:
    """Angle between two unit quaternions (w, x, y, z), rad.

    >>> angle(np.array([1.0, 0.0, 0.0, 0.0]), np.array([1.0, 5e-10, 0.0, 0.0]))
    1e-09
    """
    w, v = one[0] * other[1:] - other[0] * one[1:], np.cross(one[1:], other[1:])
    return float(2 * np.arcsin(min(1.0, float(np.linalg.norm(w - v)))))

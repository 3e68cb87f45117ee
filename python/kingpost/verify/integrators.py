"""Checks of every scheme on problems with a known solution: its order, and its effect on an oscillation."""

from __future__ import annotations

import numpy as np

from ..simulation.simulate import Simulation
from .closed_forms import complete_elliptic, jacobi
from .models import GRAVITY, G, rod, scenario, slider
from .rows import Compared, check

AREA = "integrators"
SECONDS = 2.0
START = 2.0
OMEGA = np.sqrt(3 * G / 4.0)


def _exact() -> float:
    """The angle of a rod of 2 m, released at 2 rad, after 2 s."""
    m = np.sin(START / 2) ** 2
    return 2 * np.arcsin(np.sqrt(m) * jacobi(complete_elliptic(m) - OMEGA * SECONDS, m)[0])


def _error(integrator: str, steps: int) -> float:
    settings = {"integrator": integrator, "step_s": SECONDS / steps, "duration_s": SECONDS}
    one = {"rod": rod(2.0, 3.0, initial_angle_rad=START)}
    simulation = Simulation(scenario(one, GRAVITY, simulation=settings))
    simulation.step(steps)
    return abs(float(simulation.state.q[0]) - _exact())


def _order(integrator: str, steps: int) -> float:
    """log2 of the ratio of the errors when the step is halved."""
    return float(np.log2(_error(integrator, steps) / _error(integrator, 2 * steps)))


FIRST = "an error C h + D h^2: the slope is off by D h / C, a part in hundreds of steps"
SECOND = "an error C h^2 + D h^4 (D h^3): the slope is off by the next term"


def _add_order(name: str, order: int, steps: int, tolerance: float, why: str, source: str) -> None:
    check(
        f"order-{name.replace('_', '-')}",
        f"order of {name}, on a pendulum's known angle",
        area=AREA,
        source=source,
        tolerance=tolerance,
        why=why,
    )(lambda: Compared(_order(name, steps), float(order)))


_add_order("forward_euler", 1, 4000, 0.05, FIRST, "1; Euler 1768")
_add_order("midpoint_euler", 1, 4000, 0.05, FIRST, "1: the paper's scheme for rotations, Jardim et al. 2019")
_add_order("semi_implicit_euler", 1, 4000, 0.05, FIRST, "1; Hairer, Lubich & Wanner 2006, VI.3")
_add_order("rk4", 4, 200, 0.05, "the next term of the error, h^5", "4; Kutta 1901; Munthe-Kaas 1998")
_add_order("newmark", 2, 1000, 0.02, SECOND, "2 for gamma = 1/2; Newmark 1959")
_add_order("generalized_alpha", 2, 1000, 0.02, SECOND, "2; Chung & Hulbert 1993")
_add_order("implicit_midpoint", 2, 1000, 0.02, SECOND, "2; Hairer, Lubich & Wanner 2006, II.1")


SMALL_M = 1e-6
"""Initial elongation of a mass: small, because a step far beyond the stable one makes large rates."""


def _oscillator(integrator: str, h_omega: float, steps: int, **more: object) -> np.ndarray:
    """Position and rate over the initial position, for a mass on a spring of 1 rad/s, step by step from (1,
    0)."""
    mass = slider(1.0, initial_extension_m=SMALL_M, spring={"stiffness_N_per_m": 1.0})
    settings = {"integrator": integrator, "step_s": h_omega, "duration_s": steps * h_omega, **more}
    simulation = Simulation(scenario({"mass": mass}, simulation=settings))
    found = [np.array([1.0, 0.0])]
    for _ in range(steps):
        simulation.step()
        found.append(np.concatenate([simulation.state.q, simulation.state.v]) / SMALL_M)
    return np.array(found)


@check(
    "midpoint-phase",
    "phase angle per step of an oscillation under the midpoint rule, step of 1 radian",
    area=AREA,
    unit="rad",
    source="2 atan(omega h / 2); Hairer, Lubich & Wanner 2006, II",
    tolerance=1e-9,
    why="Newton's iteration to 1e-9 of the rates",
)
def midpoint_phase() -> Compared:
    place, rate = _oscillator("implicit_midpoint", 1.0, 1)[-1]
    return Compared(np.arctan2(-rate, place), 2 * np.arctan(0.5))


@check(
    "newmark-phase",
    "phase angle per step under Newmark's average acceleration, step of 1 radian",
    area=AREA,
    unit="rad",
    source="arccos((1 - w^2 h^2 / 4) / (1 + w^2 h^2 / 4)); Newmark 1959",
    tolerance=1e-9,
    why="Newton's iteration to 1e-9 of the rates",
)
def newmark_phase() -> Compared:
    place, _ = _oscillator("newmark", 1.0, 1)[-1]
    return Compared(np.arccos(place), np.arccos(0.75 / 1.25))


@check(
    "alpha-radius",
    "amplitude ratio per step under generalized-alpha, step of 10 radians",
    area=AREA,
    source="spectral radius of the amplification matrix; Chung & Hulbert, J. Appl. Mech. 60(2), 1993",
    tolerance=1e-6,
    why="Newton's iteration to 1e-9 of the rates, in roots that differ by tenths",
)
def alpha_radius() -> Compared:
    x = _oscillator("generalized_alpha", 10.0, 12)[4:, 0]
    # Three roots: x[n+3] is a combination of the three before it.
    rows = np.array([x[i : i + 3] for i in range(len(x) - 3)])
    combination = np.linalg.lstsq(rows, x[3:], rcond=None)[0]
    ours = float(np.abs(np.roots([1.0, *-combination[::-1]])).max())
    return Compared(ours, _amplification(10.0, 0.8))


def _amplification(h: float, rho: float) -> float:
    """Spectral radius of Chung and Hulbert's step on x'' = -x."""
    alpha_m, alpha_f = (2 * rho - 1) / (rho + 1), rho / (rho + 1)
    gamma = 0.5 + alpha_f - alpha_m
    beta = (gamma + 0.5) ** 2 / 4
    after = np.array([[1, 0, -beta * h * h], [0, 1, -gamma * h], [1 - alpha_f, 0, 1 - alpha_m]])
    before = np.array([[1, h, (0.5 - beta) * h * h], [0, 1, (1 - gamma) * h], [-alpha_f, 0, -alpha_m]])
    return float(np.abs(np.linalg.eigvals(np.linalg.solve(after, before))).max())


def _stable(integrator: str, h_omega: float) -> bool:
    found = _oscillator(integrator, h_omega, 400)
    return bool(np.abs(found[-100:]).max() <= 1.5 * np.abs(found[:20]).max())


def _limit(integrator: str, low: float, high: float) -> float:
    """The largest stable step times the frequency, by bisection."""
    while high - low > 2e-3:
        middle = (low + high) / 2
        low, high = (middle, high) if _stable(integrator, middle) else (low, middle)
    return (low + high) / 2


@check(
    "stability-semi-implicit",
    "largest stable step of semi-implicit Euler, times the frequency",
    area=AREA,
    source="2; Hairer, Lubich & Wanner 2006, I.1",
    tolerance=5e-3,
    why="found by bisection to 0.002 over 400 steps",
)
def stability_semi_implicit() -> Compared:
    return Compared(_limit("semi_implicit_euler", 1.5, 2.5), 2.0)


@check(
    "stability-rk4",
    "largest stable step of RK4, times the frequency",
    area=AREA,
    source="2 sqrt 2; Hairer & Wanner, Solving ODEs II, IV.2",
    tolerance=5e-3,
    why="found by bisection to 0.002 over 400 steps",
)
def stability_rk4() -> Compared:
    return Compared(_limit("rk4", 2.5, 3.2), 2 * np.sqrt(2.0))

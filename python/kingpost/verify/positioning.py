"""Checks of dynamic positioning against the characteristic polynomial of the control loop."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ..analysis.vibration import equilibrium, modes
from ..simulation.simulate import run
from .models import scenario, settings
from .rows import Compared, check, worst

AREA = "positioning"
MASS, INERTIA = 1e6, 4e8
FOSSEN = "Fossen, Handbook of Marine Craft Hydrodynamics and Motion Control, 2011, sec. 12.2"


def _thrusters(time_s: float) -> dict[str, Any]:
    """Two tunnels and two propellers in the plane of the centre of mass, 10 MN each."""
    propeller = {"max_thrust_N": 1e7, "max_astern_thrust_N": 1e7, "time_constant_s": time_s}
    tunnel = {"max_thrust_N": 1e7, "time_constant_s": time_s}
    return {
        "bow": {"tunnel": {"position_m": [30, 0, 0], **tunnel}},
        "stern": {"tunnel": {"position_m": [-25, 0, 0], **tunnel}},
        "port": {"main_propeller": {"position_m": [-35, 4, 0], **propeller}},
        "starboard": {"main_propeller": {"position_m": [-35, -4, 0], **propeller}},
    }


def _ship(time_s: float, gains: dict[str, Any], more: dict[str, Any] | None = None, **options: Any):
    """A ship of 1000 t on dynamic positioning, without hydrodynamic forces."""
    body = {
        "mass_kg": MASS,
        "inertia": {"tensor": {"moments_kg_m2": [2e7, INERTIA, INERTIA]}},
        "joint": {"floating": {"initial": options.pop("initial", {})}},
    }
    station = {"body": "ship", "gains": gains, "thrusters": _thrusters(time_s)}
    return scenario({"ship": body}, {"dp": {"dynamic_positioning": station}, **(more or {})}, **options)


def _stated(integral: float = 0.0) -> dict[str, Any]:
    """A controller with a natural period of 100 s and a damping ratio of 0.7 in surge and sway, 80 s and 0.9
    in yaw."""
    stiffness, damping = _gains(MASS, 100.0, 0.7)
    yaw = _gains(INERTIA, 80.0, 0.9)
    return {
        "stated": {
            "stiffness_N_per_m": [stiffness] * 2,
            "damping_N_s_per_m": [damping] * 2,
            "integral_N_per_m_s": [integral] * 2,
            "yaw_stiffness_N_m_per_rad": yaw[0],
            "yaw_damping_N_m_s_per_rad": yaw[1],
        }
    }


def _gains(mass: float, period: float, ratio: float) -> tuple[float, float]:
    omega = 2 * math.pi / period
    return mass * omega**2, 2 * ratio * omega * mass


def _oscillation(found: Any, coordinate: str) -> complex:
    """The slowest eigenvalue of an oscillation that is named after a coordinate."""
    kinds = zip(found.named_after.values, found.kind.values, strict=True)
    at = [name == coordinate and kind == "oscillation" for name, kind in kinds].index(True)
    return complex(found.eigenvalue_real.values[at], abs(found.eigenvalue_imaginary.values[at]))


def _roots(*coefficients: float) -> complex:
    """The slowest complex root."""
    roots = np.roots(coefficients)
    return complex(min(roots[roots.imag > 1e-9], key=abs))


@check(
    "dp-period",
    "frequency of a ship on positioning of 100 s with fast thrusters",
    area=AREA,
    unit="rad/s",
    source=f"2 pi / T; {FOSSEN}",
    tolerance=1e-3,
    why="thrusters of 0.01 s: 2 zeta omega tau = 9e-4",
)
def dp_period() -> Compared:
    return Compared(abs(_oscillation(modes(_ship(0.01, _stated())), "ship.x")), 2 * math.pi / 100.0)


@check(
    "dp-damping",
    "damping ratio of a ship on positioning of 100 s with fast thrusters",
    area=AREA,
    source=f"0.7; {FOSSEN}",
    tolerance=1e-3,
    why="thrusters of 0.01 s: omega tau = 6e-4",
)
def dp_damping() -> Compared:
    root = _oscillation(modes(_ship(0.01, _stated())), "ship.x")
    return Compared(-root.real / abs(root), 0.7)


@check(
    "dp-thrusters",
    "frequency of a ship on positioning of 100 s with thrusters of 4 s",
    area=AREA,
    unit="rad/s",
    source="m tau s^3 + m s^2 + K_d s + K_p = 0 by numpy.roots",
    tolerance=1e-10,
    why="exact A; eigenvalues to rounding",
)
def dp_thrusters() -> Compared:
    stiffness, damping = _gains(MASS, 100.0, 0.7)
    ours = _oscillation(modes(_ship(4.0, _stated())), "ship.x")
    return Compared(ours.imag, _roots(MASS * 4.0, MASS, damping, stiffness).imag)


@check(
    "dp-yaw",
    "frequency of the yaw loop with thrusters of 4 s",
    area=AREA,
    unit="rad/s",
    source="I tau s^3 + I s^2 + K_d s + K_p = 0 by numpy.roots",
    tolerance=1e-10,
    why="exact A; eigenvalues to rounding",
)
def dp_yaw() -> Compared:
    stiffness, damping = _gains(INERTIA, 80.0, 0.9)
    ours = _oscillation(modes(_ship(4.0, _stated())), "ship.yaw")
    return Compared(ours.imag, _roots(INERTIA * 4.0, INERTIA, damping, stiffness).imag)


@check(
    "dp-return",
    "return of a ship released 5 m off, over 200 s",
    area=AREA,
    unit="m",
    source="sum of exponentials of the roots of m tau s^3 + m s^2 + K_d s + K_p",
    tolerance=1e-6,
    why="RK4 at 0.05 s: (h / tau)^4 / 120",
)
def dp_return() -> Compared:
    stiffness, damping = _gains(MASS, 100.0, 0.7)
    one = _ship(4.0, _stated(), initial={"position_m": [5.0, 0, 0]}, simulation=settings(0.05, 200.0))
    found = run(one)
    # From rest with the commanded thrust: position 5, rate 0, acceleration -K_p 5 / m.
    roots = np.roots([MASS * 4.0, MASS, damping, stiffness])
    shares = np.linalg.solve(np.vander(roots, 3, increasing=True).T, [5.0, 0.0, -5.0 * stiffness / MASS])
    exact = (shares * np.exp(np.outer(found.time.values, roots))).sum(axis=1).real
    return worst(found.position.sel(body="ship", axis="x").values, exact)


def _in_current(integral: float) -> float:
    """Station error in surge of a ship with linear drag at rest in a current of 1 m/s, m."""
    drag = {"viscous_damping": {"body": "ship", "linear_N_s_m": [2e4, 2e4, 0]}}
    found = equilibrium(_ship(4.0, _stated(integral), {"drag": drag}, sea={"current_m_s": [1.0, 0.0]}))
    return float(found.position.sel(body="ship", axis="x"))


@check(
    "dp-offset",
    "station error in a current without integral action",
    area=AREA,
    unit="m",
    source=f"F / K_p; {FOSSEN}",
    tolerance=1e-8,
    why="Newton's method ends at 1e-9 of the loads",
)
def dp_offset() -> Compared:
    return Compared(_in_current(0.0), 2e4 / _gains(MASS, 100.0, 0.7)[0])


@check(
    "dp-integral",
    "station error in a current with integral action, relative to the error without",
    area=AREA,
    unit="m",
    source=f"0; {FOSSEN}",
    tolerance=1e-6,
    why="the equilibrium is sought to 1e-8 m",
)
def dp_integral() -> Compared:
    stiffness, _ = _gains(MASS, 100.0, 0.7)
    return Compared(_in_current(stiffness / 200.0), 0.0, scale=2e4 / stiffness)

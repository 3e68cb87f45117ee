"""Checks of drag, wind and current."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ..simulation.simulate import Simulation, run
from .models import GRAVITY, G, scenario, settings, value
from .rows import Compared, check, worst

AREA = "flow"
RK4 = "RK4 errs by (h / T)^4, T the time of the decay"
EVALUATION = "one evaluation: rounding, and the table's point is on the curve"


def _body(**initial: Any) -> dict[str, Any]:
    return {
        "mass_kg": 500.0,
        "inertia": {"tensor": {"moments_kg_m2": [1e3, 1e3, 1e3]}},
        "joint": {"floating": {"initial": initial}},
    }


@check(
    "stokes-decay",
    "speed of a body under linear drag over 20 s",
    area=AREA,
    unit="m/s",
    source="v e^(-c t / m)",
    tolerance=1e-10,
    why=RK4,
)
def stokes_decay() -> Compared:
    drag = {"viscous_damping": {"body": "body", "linear_N_s_m": [80.0, 80.0, 80.0]}}
    one = scenario({"body": _body(velocity_m_s=[3.0, 0, 0])}, {"drag": drag}, simulation=settings(0.02, 20.0))
    found = run(one)
    ours = found.velocity.sel(body="body", axis="x").values
    return worst(ours, 3.0 * np.exp(-80.0 / 500.0 * found.time.values))


@check(
    "quadratic-decay",
    "speed of a body under quadratic drag over 20 s",
    area=AREA,
    unit="m/s",
    source="v / (1 + c v t / m); Newton, Principia, book II",
    tolerance=1e-9,
    why=RK4,
)
def quadratic_decay() -> Compared:
    drag = {"quadratic_damping": {"body": "body", "linear_N_s2_m2": [80.0, 80.0, 80.0]}}
    one = scenario({"body": _body(velocity_m_s=[3.0, 0, 0])}, {"drag": drag}, simulation=settings(0.02, 20.0))
    found = run(one)
    ours = found.velocity.sel(body="body", axis="x").values
    return worst(ours, 3.0 / (1 + 80.0 * 3.0 / 500.0 * found.time.values))


@check(
    "terminal-speed",
    "speed of a body that falls under quadratic drag, over 20 s",
    area=AREA,
    unit="m/s",
    source="-sqrt(m g / c) tanh(t sqrt(g c / m)); Newton, Principia, book II",
    tolerance=1e-9,
    why=RK4,
)
def terminal_speed() -> Compared:
    drag = {"quadratic_damping": {"body": "body", "linear_N_s2_m2": [80.0, 80.0, 80.0]}}
    found = run(scenario({"body": _body()}, {**GRAVITY, "drag": drag}, simulation=settings(0.01, 20.0)))
    ours = found.velocity.sel(body="body", axis="z").values
    final = math.sqrt(500.0 * G / 80.0)
    return worst(ours, -final * np.tanh(found.time.values * G / final))


COEFFICIENTS = {
    "directions_deg": [0, 45, 90, 135, 180],
    "symmetric": True,
    "surge": [0.7, 0.5, 0, -0.5, -0.7],
    "sway": [0, 0.6, 0.9, 0.6, 0],
    "yaw": [0, 0.05, 0, -0.05, 0],
    "frontal_area_m2": 40.0,
    "lateral_area_m2": 110.0,
    "length_m": 40.0,
}
OCIMF = "rho/2 V^2 A C; OCIMF, Mooring Equipment Guidelines, 4th ed., app. A"


def _held() -> dict[str, Any]:
    one = _body()
    one["joint"]["floating"] |= {"hold_translation": True, "hold_rotation": True}
    return one


def _wind(height: float) -> Simulation:
    load = {"wind_load": {"body": "body", "height_m": height, "coefficients": COEFFICIENTS}}
    return Simulation(
        scenario({"body": _held()}, {"wind": load}, wind={"speed_m_s": 12.0, "direction_deg": 135})
    )


@check(
    "wind-sway",
    "sway force of a wind from 45 degrees off the bow",
    area=AREA,
    unit="N",
    source=OCIMF,
    tolerance=1e-12,
    why=EVALUATION,
)
def wind_sway() -> Compared:
    ours = value(_wind(10.0), "flow_force", "wind", "force_y")
    return Compared(ours, 0.5 * 1.225 * 12.0**2 * 110.0 * 0.6)


@check(
    "wind-yaw",
    "yaw moment of a wind from 45 degrees off the bow",
    area=AREA,
    unit="N m",
    source=OCIMF,
    tolerance=1e-12,
    why=EVALUATION,
)
def wind_yaw() -> Compared:
    ours = value(_wind(10.0), "flow_force", "wind", "moment_z")
    return Compared(ours, -0.5 * 1.225 * 12.0**2 * 110.0 * 40.0 * 0.05)


@check(
    "wind-profile",
    "sway force of a wind from 45 degrees off the bow on a load 30 m up",
    area=AREA,
    unit="N",
    source="the seventh root of height, squared: DNV-RP-C205, sec. 2.3.2",
    tolerance=1e-12,
    why=EVALUATION,
)
def wind_profile() -> Compared:
    ours = value(_wind(30.0), "flow_force", "wind", "force_y")
    return Compared(ours, 0.5 * 1.225 * 12.0**2 * 3.0 ** (2 / 7) * 110.0 * 0.6)


@check(
    "current-drift",
    "speed of a ship that drifts with a current from astern, over 20 s",
    area=AREA,
    unit="m/s",
    source="u - u / (1 + c u t / m); Newton, Principia, book II",
    tolerance=1e-9,
    why=RK4,
)
def current_drift() -> Compared:
    load = {"current_load": {"body": "body", "coefficients": COEFFICIENTS}}
    ship = _body() | {"mass_kg": 5e4}
    found = run(
        scenario(
            {"body": ship},
            {"current": load},
            sea={"current_m_s": [0.8, 0.0]},
            simulation=settings(0.01, 20.0),
        )
    )
    drag = 0.5 * 1025.0 * 40.0 * 0.7
    exact = 0.8 - 0.8 / (1 + drag * 0.8 / 5e4 * found.time.values)
    return worst(found.velocity.sel(body="body", axis="x").values, exact)

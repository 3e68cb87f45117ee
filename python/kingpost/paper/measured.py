"""Numbers, measured with the engine, for the page's remarks on the paper's text."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..scenario import load
from ..simulation.simulate import Simulation
from . import figures
from .equations import arm_velocity

TABLE_2_ARM_TORQUE_N_M = 70_000.0
PRINTED_AT_S = 0.25
"""The time at which printed and corrected kinematics are compared, s."""


@dataclass(frozen=True)
class Measured:
    """The numbers in the remarks.

    Attributes
    ----------
    eq_43_m_s, eq_46b_m_s
        Error of the arm's velocity by eq. 43 and by eq. 46b as printed, m/s.
    corrected_m_s, arm_m_s
        Error of the corrected form, and the arm's speed, m/s.
    held, free
        Number of coordinates with the ship's centre held and free.
    slew_inertia, slew_inertia_loaded
        Inertia about the tower's axis without and with the load, kg m2.
    level, upright
        Largest pitch, yaw and roll rate with the tower motor, the arm at first level or held
        upright, rad/s.
    level_damped, both, both_damped
        Largest rates of Fig. 9 with damping, and of Fig. 11 without and with damping, rad/s.
    lowering, lifting
        Largest pitch rate of Fig. 10 without and with damping, for the torque of Table 2 by the signs of
        eqs. 40 and 59, and for the opposite torque, rad/s.
    without_d_energy, without_d_momentum
        Energy error over work, and momentum error (N m s), with D left out of eq. 60b.
    """

    eq_43_m_s: float
    eq_46b_m_s: float
    corrected_m_s: float
    arm_m_s: float
    held: list[str]
    free: list[str]
    slew_inertia: float
    slew_inertia_loaded: float
    level: dict[str, float]
    upright: dict[str, float]
    level_damped: dict[str, float]
    both: dict[str, float]
    both_damped: dict[str, float]
    lowering: tuple[float, float]
    lifting: tuple[float, float]
    without_d_energy: float
    without_d_momentum: float


def measure(drawn: list[figures.Figure]) -> Measured:
    """Measure the numbers; `drawn` holds the results of Figs. 9 to 11."""
    level, arm_alone, both = drawn
    arm = "bodies.arm.joint.revolute"
    held_upright = {f"{arm}.initial_angle_rad": -np.pi / 2, f"{arm}.mode": "held"}
    upright = figures.simulate(level.case, **held_upright)
    without_d = _without_d(both.case)
    return Measured(
        *_printed_kinematics(),
        held=_coordinates(hold_centre=True),
        free=_coordinates(hold_centre=False),
        slew_inertia=_slew_inertia(load_on=False),
        slew_inertia_loaded=_slew_inertia(load_on=True),
        level=_peaks(level.undamped),
        upright=_peaks(figures.rates(upright)),
        level_damped=_peaks(level.damped),
        both=_peaks(both.undamped),
        both_damped=_peaks(both.damped),
        lowering=(_peaks(arm_alone.undamped)["pitch"], _peaks(arm_alone.damped)["pitch"]),
        lifting=(_lifting(arm_alone.case, damping=False), _lifting(arm_alone.case, damping=True)),
        without_d_energy=without_d[0],
        without_d_momentum=without_d[1],
    )


def _lifting(case: figures.Case, damping: bool) -> float:
    """Largest pitch rate with the opposite torque of the arm's motor, rad/s."""
    torque = "drives.motor_2.motor.torque_N_m"
    opposite = {torque: -TABLE_2_ARM_TORQUE_N_M}
    return _peaks(figures.rates(figures.simulate(case, damping=damping, **opposite)))["pitch"]


def _without_d(case: figures.Case) -> tuple[float, float]:
    settings = {"simulation.form": "moving_frame_without_d", "simulation.duration_s": 1.0}
    last = figures.simulate(case, **settings).isel(time=-1)
    return float(abs(last["energy_error"] / last["work_done"])), float(last["momentum_error"])


def _coordinates(hold_centre: bool) -> list[str]:
    return Simulation(load("paper", load=False, hold_centre=hold_centre)).coordinates


def _slew_inertia(load_on: bool) -> float:
    simulation = Simulation(load("paper", load=load_on))
    slew = simulation.coordinates.index("slew")
    return float(simulation.mass_matrix()[slew, slew])


def _peaks(rates: dict[str, np.ndarray]) -> dict[str, float]:
    return {name: float(np.abs(values).max()) for name, values in rates.items()}


def _printed_kinematics() -> tuple[float, float, float, float]:
    """Errors of eqs. 43 and 46b as printed and of 43 corrected, and the arm's speed; the crane is in the
    stern corner."""
    simulation = Simulation(load("paper", motor_1=True, motor_2=True, load=False))
    simulation.step(round(PRINTED_AT_S / simulation.step_s))
    rows = [f"arm.{axis}_dot" for axis in "xyz"]
    true = simulation.moving_frame()["X_dot"].sel(row=rows).values.ravel()
    cases = (("43", "printed"), ("46b", "printed"), ("43", "corrected"))
    errors = [arm_velocity(simulation, *case) - true for case in cases]
    printed_43, printed_46b, corrected, speed = (float(np.linalg.norm(v)) for v in (*errors, true))
    return printed_43, printed_46b, corrected, speed

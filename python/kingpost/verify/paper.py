"""Checks of the paper's crane ship: against results of three other multibody codes, and against hand
calculations from Table 2 of the paper."""

from __future__ import annotations

import numpy as np

from ..scenario import load
from ..simulation.simulate import Simulation
from .models import value
from .rows import Compared, check

AREA = "paper"
CODES = "three independent multibody codes agree on the digits (docs/verification.md)"
DIGITS = "the printed digits"


def _after_half_a_second(variable: str, *labels: str) -> float:
    """A channel of the run of Fig. 9 without damping, at 0.5 s."""
    simulation = Simulation(load("paper", crane_x_m=0, crane_y_m=0))
    simulation.step(500)
    return value(simulation, variable, *labels)


@check(
    "paper-pitch-rate",
    "ship's pitch rate after 0.5 s of the tower's motor",
    area=AREA,
    unit="rad/s",
    source=CODES,
    tolerance=5e-5,
    why=DIGITS,
)
def pitch_rate() -> Compared:
    return Compared(_after_half_a_second("angular_velocity", "ship", "y"), 0.19709)


@check(
    "paper-yaw-rate",
    "ship's yaw rate after 0.5 s",
    area=AREA,
    unit="rad/s",
    source=CODES,
    tolerance=8e-5,
    why=DIGITS,
)
def yaw_rate() -> Compared:
    return Compared(_after_half_a_second("angular_velocity", "ship", "z"), -0.12348)


@check(
    "paper-roll-rate",
    "ship's roll rate after 0.5 s",
    area=AREA,
    unit="rad/s",
    source=CODES,
    tolerance=1.3e-4,
    why=DIGITS,
)
def roll_rate() -> Compared:
    return Compared(_after_half_a_second("angular_velocity", "ship", "x"), -0.07719)


@check(
    "paper-slew-rate",
    "tower's rate after 0.5 s",
    area=AREA,
    unit="rad/s",
    source=CODES,
    tolerance=9e-6,
    why=DIGITS,
)
def slew_rate() -> Compared:
    return Compared(_after_half_a_second("joint_velocity", "slew"), 6.6699)


@check(
    "paper-slew",
    "tower's angle after 0.5 s",
    area=AREA,
    unit="rad",
    source=CODES,
    tolerance=3.5e-5,
    why=DIGITS,
)
def slew() -> Compared:
    return Compared(_after_half_a_second("joint_position", "slew"), 1.7159)


@check(
    "paper-luff", "arm's angle after 0.5 s", area=AREA, unit="rad", source=CODES, tolerance=9e-4, why=DIGITS
)
def luff() -> Compared:
    return Compared(_after_half_a_second("joint_position", "luff"), 0.0632)


SHIP_M, ARM_M, LENGTH_M, RADIUS_M, LOAD_M = 10000.0, 500.0, 7.0, 0.5, 1000.0
TABLE_2 = "Jardim et al. 2019, Table 2 (doi 10.1115/1.4042536): solid cylinders, parallel axes"


def _slew_inertia(loaded: bool) -> float:
    """Tower, level arm and load about the tower's axis, kg m2."""
    tower = ARM_M * RADIUS_M**2 / 2
    arm = ARM_M * (3 * RADIUS_M**2 + LENGTH_M**2) / 12 + ARM_M * (LENGTH_M / 2) ** 2
    return tower + arm + loaded * LOAD_M * LENGTH_M**2


def _entry(name: str, **parameters: object) -> float:
    simulation = Simulation(load("paper", **parameters))
    at = simulation.coordinates.index(name)
    return float(simulation.mass_matrix()[at, at])


@check(
    "paper-slew-inertia",
    "M* of the tower with the level arm",
    area=AREA,
    unit="kg m^2",
    source=TABLE_2,
    tolerance=1e-13,
    why="rounding",
)
def slew_inertia() -> Compared:
    return Compared(_entry("slew", load=False), _slew_inertia(False))


@check(
    "paper-slew-inertia-loaded",
    "M* of the tower with the level arm and the load at its tip",
    area=AREA,
    unit="kg m^2",
    source=TABLE_2,
    tolerance=1e-13,
    why="rounding",
)
def slew_inertia_loaded() -> Compared:
    return Compared(_entry("slew", load=True), _slew_inertia(True))


@check(
    "paper-first-acceleration",
    "tower's acceleration when its motor starts",
    area=AREA,
    unit="rad/s^2",
    source="3x3 mass matrix of roll, yaw and slew from Table 2 by hand, under 100 kN m",
    tolerance=1e-12,
    why="one evaluation: rounding",
)
def first_acceleration() -> Compared:
    simulation = Simulation(load("paper", crane_x_m=0, crane_y_m=0))
    ours = simulation.acceleration()[simulation.coordinates.index("slew")]
    return Compared(ours, _first_acceleration())


def _first_acceleration() -> float:
    """M* of roll, yaw and slew, crane in the middle: the arm, level at 7 m, moves by its centre at 3.5 m."""
    ship_roll, ship_yaw = SHIP_M * (10**2 + 5**2) / 12, SHIP_M * (20**2 + 10**2) / 12
    thin, along = ARM_M * (3 * RADIUS_M**2 + LENGTH_M**2) / 12, ARM_M * RADIUS_M**2 / 2
    # Speeds across the ship of the tower's centre (z 3.5) and of the arm's (x 3.5, z 7), per unit rate.
    tower, arm = np.array([-3.5, 0.0, 0.0]), np.array([-7.0, 3.5, 3.5])
    mass = ARM_M * (np.outer(tower, tower) + np.outer(arm, arm))
    mass += np.diag([ship_roll + thin + along, ship_yaw, 0.0])
    turning = np.array([0.0, 1.0, 1.0])
    mass += (along + thin) * np.outer(turning, turning)
    return float(np.linalg.solve(mass, [0.0, 0.0, 1e5])[2])

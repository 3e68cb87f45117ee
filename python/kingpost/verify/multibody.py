"""Checks of rigid bodies and joints against closed forms."""

from __future__ import annotations

import numpy as np

from ..analysis.vibration import modes
from ..simulation.simulate import Simulation, run
from .closed_forms import complete_elliptic, jacobi
from .models import GRAVITY, G, crossings, free_body, rod, scenario, settings, slider, value
from .rows import Compared, check

AREA = "multibody"
RK4 = "RK4 errs by (omega h)^4 / 120 a radian: 1e-12 at these steps; the rest is rounding over the run"
EIGEN = "exact A by dual numbers; eigenvalues to rounding"
ROUNDING = "exact for this scheme except for rounding"


def _swing(angle: float, seconds: float, step: float = 0.002):
    """A uniform rod of 2 m released at an angle; its angle and rate over time."""
    simulation = settings(step, seconds, integrator="rk4")
    found = run(scenario({"rod": rod(2.0, 3.0, initial_angle_rad=angle)}, GRAVITY, simulation=simulation))
    return found.time.values, found.joint_position.values[:, 0], found.joint_velocity.values[:, 0]


ROD_OMEGA = np.sqrt(3 * G / (2 * 2.0))
"""Frequency of small swings of a uniform rod of 2 m on its end: sqrt(3 g / 2 l), rad/s."""


@check(
    "pendulum-period",
    "period of a rod released at 2 rad",
    area=AREA,
    unit="s",
    tolerance=1e-9,
    why=RK4,
    source="4 K(sin^2(a/2)) / omega; Landau & Lifshitz, Mechanics, sec. 11",
)
def pendulum_period() -> Compared:
    zeros = crossings(*_swing(2.0, 8.0))
    return Compared(zeros[2] - zeros[0], 4 * complete_elliptic(np.sin(1.0) ** 2) / ROD_OMEGA)


@check(
    "pendulum-angle",
    "angle of a rod released at 3 rad, after 5 s",
    area=AREA,
    unit="rad",
    tolerance=1e-8,
    why=RK4 + ", times the stretch near the top",
    source="2 asin(k sn(K - omega t, k)); Whittaker, Analytical Dynamics, sec. 44",
)
def pendulum_angle() -> Compared:
    _, angle, _ = _swing(3.0, 5.0)
    m = np.sin(1.5) ** 2
    sn, _, _ = jacobi(complete_elliptic(m) - ROD_OMEGA * 5.0, m)
    return Compared(angle[-1], 2 * np.arcsin(np.sqrt(m) * sn), scale=1.0)


@check(
    "rod-mode",
    "frequency of small swings of a rod",
    area=AREA,
    unit="rad/s",
    tolerance=1e-11,
    why=EIGEN,
    source="sqrt(3 g / 2 l)",
)
def rod_mode() -> Compared:
    found = modes(scenario({"rod": rod(2.0, 3.0)}, GRAVITY))
    return Compared(found.angular_frequency.values[0], ROD_OMEGA)


def _double_rod_mode(which: int) -> float:
    lower = rod(2.0, 3.0, position_m=[0, 0, -1.0])
    found = modes(scenario({"upper": rod(2.0, 3.0), "lower": {"parent": "upper", **lower}}, GRAVITY))
    return float(found.angular_frequency.values[which])


@check(
    "double-rod-slow",
    "first mode of two equal rods in line",
    area=AREA,
    unit="rad/s",
    tolerance=1e-11,
    why=EIGEN,
    source="sqrt((3 - 6/sqrt 7) g / l), from its own 2x2 matrices",
)
def double_rod_slow() -> Compared:
    return Compared(_double_rod_mode(0), np.sqrt((3 - 6 / np.sqrt(7)) * G / 2.0))


@check(
    "double-rod-fast",
    "second mode of two equal rods in line",
    area=AREA,
    unit="rad/s",
    tolerance=1e-11,
    why=EIGEN,
    source="sqrt((3 + 6/sqrt 7) g / l), from its own 2x2 matrices",
)
def double_rod_fast() -> Compared:
    return Compared(_double_rod_mode(1), np.sqrt((3 + 6 / np.sqrt(7)) * G / 2.0))


@check(
    "cart-pendulum",
    "mode of a load under a free trolley",
    area=AREA,
    unit="rad/s",
    tolerance=1e-11,
    why=EIGEN,
    source="sqrt((1 + m/M) g / l); Goldstein, Classical Mechanics, ch. 1 and 6",
)
def cart_pendulum() -> Compared:
    load = {
        "parent": "trolley",
        "mass_kg": 2.0,
        "shape": {"point": {}},
        "joint": {"revolute": {"axis": [0, 1, 0], "child_position_m": [0, 0, 5.0]}},
    }
    found = modes(scenario({"trolley": slider(3.0), "load": load}, GRAVITY))
    return Compared(found.angular_frequency.values.max(), np.sqrt((1 + 2 / 3) * G / 5.0))


@check(
    "falling-rod-reaction",
    "force in the hinge of a rod that falls from level, at the bottom",
    area=AREA,
    unit="N",
    tolerance=1e-8,
    why=RK4 + "; twice the error of the angle",
    source="5/2 m g: weight and m omega^2 l/2 with omega^2 = 3 g / l",
)
def falling_rod_reaction() -> Compared:
    t, angle, rate = _swing(np.pi / 2, 1.5)
    bottom = crossings(t, angle, rate)[0]
    # A run that ends at that instant, in whole steps.
    steps = settings(bottom / 1000, bottom, integrator="rk4")
    start = rod(2.0, 3.0, initial_angle_rad=np.pi / 2)
    simulation = Simulation(scenario({"rod": start}, GRAVITY, simulation=steps))
    simulation.step(1000)
    return Compared(value(simulation, "joint_reaction", "rod", "force_z"), 2.5 * 3.0 * G)


@check(
    "spring-damped",
    "position of a damped mass on a spring after 10 s",
    area=AREA,
    unit="m",
    tolerance=1e-10,
    why=RK4,
    source="e^(-z w t) (cos w_d t + z w / w_d sin w_d t); Den Hartog, ch. 2",
)
def spring_damped() -> Compared:
    mass = slider(
        2.0, initial_extension_m=0.5, damping_N_s_m=0.8, spring={"stiffness_N_per_m": 18.0, "rest_m": 0.0}
    )
    found = run(scenario({"mass": mass}, simulation=settings(0.002, 10.0, integrator="rk4")))
    omega, ratio = 3.0, 0.8 / (2 * 2.0 * 3.0)
    damped = omega * np.sqrt(1 - ratio**2)
    phase = damped * 10.0
    exact = 0.5 * np.exp(-ratio * omega * 10.0) * (np.cos(phase) + ratio * omega / damped * np.sin(phase))
    return Compared(found.joint_position.values[-1, 0], exact, scale=0.5)


@check(
    "bead-on-rod",
    "distance of a bead on a rod that turns evenly, after 3 s",
    area=AREA,
    unit="m",
    tolerance=1e-10,
    why=RK4,
    source="r0 cosh(omega t); Goldstein, ch. 1",
)
def bead_on_rod() -> Compared:
    arm = {
        "mass_kg": 1.0,
        "shape": {"box": {"length_m": 1, "width_m": 0.1, "height_m": 0.1}},
        "joint": {"revolute": {"axis": [0, 0, 1], "mode": {"prescribed": {"rate_rad_s": 1.5}}}},
    }
    bead = {"parent": "arm", **slider(0.5, initial_extension_m=0.2)}
    found = run(scenario({"arm": arm, "bead": bead}, simulation=settings(0.002, 3.0, integrator="rk4")))
    return Compared(found.joint_position.sel(coordinate="bead").values[-1], 0.2 * np.cosh(4.5))


@check(
    "turntable",
    "angle of a platform while the man on it makes a quarter turn",
    area=AREA,
    unit="rad",
    tolerance=1e-12,
    why=ROUNDING,
    source="-I_man / (I_man + I_platform) pi / 2, momentum staying zero",
)
def turntable() -> Compared:
    travel = {"travel": {"angle_rad": np.pi / 2, "duration_s": 2.0, "ramp_s": 0.5}}
    bodies = {
        "platform": free_body([3.0, 3.0, 5.0], 10.0),
        "man": {
            "parent": "platform",
            "mass_kg": 4.0,
            "inertia": {"tensor": {"moments_kg_m2": [2.0, 2.0, 1.5]}},
            "joint": {"revolute": {"axis": [0, 0, 1], "mode": travel}},
        },
    }
    found = run(scenario(bodies, simulation=settings(0.005, 3.0, integrator="rk4")))
    return Compared(found.yaw.sel(body="platform").values[-1], -1.5 / 6.5 * np.pi / 2)


@check(
    "geared-motor",
    "acceleration of a slide with a geared rotor",
    area=AREA,
    unit="m/s^2",
    tolerance=1e-14,
    why="one evaluation: rounding",
    source="F / (m + J n^2)",
)
def geared_motor() -> Compared:
    slide = slider(50.0, rotor_inertia_kg_m2=0.02, gear_ratio_rad_per_m=40.0)
    drives = {"push": {"linear_motor": {"joint": "slide", "force_N": 700.0}}}
    simulation = Simulation(scenario({"slide": slide}, drives=drives))
    return Compared(simulation.acceleration()[0], 700.0 / (50.0 + 0.02 * 40.0**2))


@check(
    "parabola",
    "height of a thrown body after 2 s",
    area=AREA,
    unit="m",
    tolerance=1e-13,
    why=ROUNDING,
    source="v t - g t^2 / 2; Galilei",
)
def parabola() -> Compared:
    body = free_body([1.0, 2.0, 3.0], velocity_m_s=[3.0, 0.0, 15.0], angular_velocity_rad_s=[1.0, 2.0, 3.0])
    found = run(scenario({"body": body}, GRAVITY, simulation=settings(0.01, 2.0, integrator="rk4")))
    return Compared(found.position.sel(body="body", axis="z").values[-1], 30.0 - 2 * G)


@check(
    "conical-pendulum",
    "height of a conical pendulum after 10 s",
    area=AREA,
    unit="m",
    tolerance=1e-10,
    why=RK4,
    source="level at omega^2 = g / (l cos a); Huygens 1673",
)
def conical_pendulum() -> Compared:
    tilt, length = 0.8, 3.0
    omega = np.sqrt(G / (length * np.cos(tilt)))
    # Rate about the vertical, in the axes of a load that is tilted about y.
    turn = [-omega * np.sin(tilt), 0.0, omega * np.cos(tilt)]
    ball = {
        "child_position_m": [0, 0, length],
        "initial_orientation_rad": [0, tilt, 0],
        "initial_angular_velocity_rad_s": turn,
    }
    load = {
        "mass_kg": 2.0,
        "inertia": {"tensor": {"moments_kg_m2": [1e-9] * 3}},
        "joint": {"spherical": ball},
    }
    found = run(scenario({"load": load}, GRAVITY, simulation=settings(0.002, 10.0, integrator="rk4")))
    height = found.position.sel(body="load", axis="z").values
    return Compared(height[-1], -length * np.cos(tilt))

"""Checks of Ikeda's method against measured roll: the decay of a tanker's model, and the eddies of ten
cylinders."""

from __future__ import annotations

import math
from functools import cache

import numpy as np

from ..roll_damping import Coefficients, Sections, from_sections
from ..roll_damping.eddies import eddy_coefficient
from ..simulation.simulate import run
from .models import GRAVITY, crossings, scenario
from .rows import Compared, check, worst

AREA = "measured"

SCALE = 68.0
KVLCC2 = {"kg": 18.6, "gm": 5.73, "gyration": 23.2, "volume": 312653.0, "viscosity": 1.14e-6}
"""Full-scale dimensions of the ship, m and m3, in fresh water; the viscosity, m2/s, is that of the model
test."""
SECTIONS = (
    (-5.495, 11.6386, 2.0, 13.827),
    (10.160, 27.8935, 18.25, 123.851),
    (28.051, 41.8243, 20.8, 428.211),
    (43.706, 50.2825, 20.8, 683.709),
    (61.598, 56.1592, 20.8, 917.895),
    (77.252, 57.8705, 20.8, 1056.861),
    (92.907, 58.0, 20.8, 1139.504),
    (110.799, 58.0, 20.8, 1186.853),
    (126.454, 58.0, 20.8, 1203.217),
    (144.345, 58.0, 20.8, 1203.930),
    (160.0, 58.0, 20.8, 1203.929),
    (175.891, 58.0, 20.8, 1203.929),
    (194.053, 58.0, 20.8, 1203.929),
    (209.944, 58.0, 20.8, 1203.929),
    (225.836, 58.0, 20.8, 1203.906),
    (243.998, 57.9874, 20.8, 1195.570),
    (259.889, 57.4878, 20.8, 1159.988),
    (275.780, 55.3613, 20.8, 1077.577),
    (291.672, 48.1309, 20.8, 899.155),
    (309.833, 28.2037, 20.8, 502.527),
    (325.725, 5.7095, 16.18, 43.489),
)
"""x, beam, draught, m, and area, m2, of KVLCC2's sections: M. Alexandersson, Prediction-of-roll-motion-using-
fully-nonlinear-potential-flow-and-Ikedas-method (MIT licence)."""
SWINGS = (10.439, 10.030, 9.780, 9.462, 9.243, 8.977, 8.789, 8.550, 8.380, 8.156, 7.997, 7.787, 7.654, 7.465,
          7.348, 7.171, 7.055, 6.872, 6.744, 6.598, 6.546, 6.384, 6.271, 6.127, 6.051, 5.917, 5.884, 5.735,
          5.685, 5.563)  # fmt: skip
"""Extrema of the roll, degrees, one after another, of run 21338 at 0 knots, model 1:68 without bilge keels:
Alexandersson & Kjellberg, doi:10.17632/2stvkyngj9.1, CC BY 4.0; parabolas through five samples of 0.1 s."""
PERIOD_S = 2.5533
"""Natural frequency from `kingpost roll-damping decay --model cubic` on that run; the authors give 2.5530."""
FITTED = {
    21337: (2.461405663797153, 2.960431148229692, -6.520487128705247, 43.7753590783464),
    21338: (2.461149414341689, 2.879736279200558, -5.874151219904037, 41.50366418695269),
}
"""omega0 and B1, B2, B3 of the model that Alexandersson, Kjellberg et al., 2021, fitted to the two runs."""
RADIATED = (15.3129, 0.517501)
"""Added inertia, kg m2, and damping, N m s, of the model free to sway and yaw at its natural frequency, by
the panel method about 25 Lewis forms: the fixture `predicted` of python/tests/test_roll_kvlcc2.py."""
TESTS = "Alexandersson & Kjellberg, doi:10.17632/2stvkyngj9.1 (CC BY 4.0): KVLCC2 at 1:68, 0 knots, run 21338"


def _inertia() -> tuple[float, float]:
    """Mass and roll inertia of the model with added inertia, kg and kg m2."""
    mass = 1000.0 * KVLCC2["volume"] / SCALE**3
    return mass, mass * (KVLCC2["gyration"] / SCALE) ** 2 + RADIATED[0]


def natural_period() -> float:
    """Roll period of the model from its loading and the panel method, s."""
    mass, inertia = _inertia()
    return 2 * math.pi * math.sqrt(inertia / (mass * 9.81 * KVLCC2["gm"] / SCALE))


def tanker(amplitudes_rad: np.ndarray):
    """Ikeda's components of the model, without radiation damping."""
    x, beam, draught, area = np.array(SECTIONS).T
    sections = Sections.of_table({"x_m": x, "beam_m": beam, "draught_m": draught, "area_m2": area})
    return from_sections(
        sections.scaled(1 / SCALE),
        KVLCC2["kg"] / SCALE,
        natural_period(),
        amplitudes_rad,
        density_kg_m3=1000.0,
        viscosity_m2_s=KVLCC2["viscosity"],
    )


@cache
def decay() -> tuple[np.ndarray, np.ndarray]:
    """Times, s, and magnitudes, degrees, of the extrema of the model released from the first of `SWINGS`.

    The engine computes a pendulum with the model's inertia, GM and damping, radiation damping included.
    """
    mass, inertia = _inertia()
    height = KVLCC2["gm"] / SCALE
    found = tanker(np.radians([3.0, 5.0, 7.0, 9.0]))
    about = inertia - mass * height**2
    hinge = {"name": "roll", "axis": [1, 0, 0], "child_position_m": [0, 0, height],
             "initial_angle_rad": math.radians(SWINGS[0])}  # fmt: skip
    body = {
        "mass_kg": mass,
        "inertia": {"tensor": {"moments_kg_m2": [about] * 3}},
        "joint": {"revolute": hinge},
    }
    linear, quadratic = float(found.linear) + RADIATED[1], float(found.quadratic)
    forces = GRAVITY | {
        "damping": {"viscous_damping": {"body": "ship", "angular_N_m_s": [linear, 0, 0]}},
        "drag": {"quadratic_damping": {"body": "ship", "angular_N_m_s2": [quadratic, 0, 0]}},
    }
    settings = {"integrator": "rk4", "step_s": 0.01, "duration_s": 40.0, "record_every_s": 0.02}
    ran = run(scenario({"ship": body}, forces, simulation=settings))
    t, roll, rate = ran.time.values, ran.joint_position.values[:, 0], ran.joint_velocity.values[:, 0]
    times = np.concatenate([[0.0], crossings(t[1:], rate[1:], np.gradient(rate, t)[1:])])
    return times, np.degrees(np.abs(np.interp(times, t, roll)))


@check(
    "kvlcc2-period",
    "natural roll period of a tanker's model, by its sections and loading",
    area=AREA,
    unit="s",
    source=TESTS,
    tolerance=0.02,
    why="sections as Lewis forms; GM and radius of gyration in three digits 0.1 and 0.2 %",
)
def kvlcc2_period() -> Compared:
    times = decay()[0]
    return Compared(2 * float(times[10] - times[0]) / 10, PERIOD_S)


QUARTER = 0.25 / math.e


@check(
    "kvlcc2-decay",
    "largest error of 29 amplitudes of a tanker model's decay, damping from its sections, over the first",
    area=AREA,
    unit="deg",
    source=TESTS,
    tolerance=round(QUARTER, 3),
    why="the accuracy of Ikeda's method, a quarter of the damping: for a = a0 exp(-s) that is s exp(-s) / 4,"
    " 1 / 4e at most",
)
def kvlcc2_decay() -> Compared:
    return worst(decay()[1][: len(SWINGS)], SWINGS)


CYLINDERS = (
    ("A", 0.28, 0.112, 1.0, 0.0, (6.7911, 7.2975)),
    ("B", 0.28, 0.112, 0.997, 0.01, (2.8623, 2.5821)),
    ("C", 0.28, 0.112, 0.995, 0.02, (0.9427, 0.9440)),
    ("D", 0.28, 0.112, 0.988, 0.03, (0.7907, 0.8137)),
    ("G", 0.185, 0.192, 0.799, None, (0.0861,)),
    ("H", 0.398, 0.193, 0.893, None, (0.0597, 0.0661)),
    ("I", 0.237, 0.096, 0.977, None, (0.3580, 0.2659)),
    ("J", 0.343, 0.192, 0.593, None, (0.1357,)),
    ("K", 0.193, 0.125, 0.541, None, (0.2925,)),
    ("L", 0.151, 0.144, 0.430, None, (0.9276,)),
)
"""Y. Ikeda et al., J. Soc. Naval Architects of Japan 142, 1977, digitised by M. Alexandersson,
doi:10.17632/p3r9nmtvyj.1, CC BY 4.0: section, beam and draught, m, area coefficient, bilge radius, m, and C_R
of each curve over the frequency."""
IKEDA = "Ikeda et al., J. Soc. Naval Architects of Japan 142, 1977, by doi:10.17632/p3r9nmtvyj.1 (CC BY 4.0)"


def eddies(number: int) -> float:
    """C_R of one of `CYLINDERS`."""
    _, beam, draught, area, bilge, _ = CYLINDERS[number]
    table = {"x_m": [0.0, 0.4, 0.8], "beam_m": [beam] * 3, "draught_m": [draught] * 3,
             "area_coefficient": [area] * 3}  # fmt: skip
    if bilge is not None:
        table["bilge_radius_m"] = [bilge] * 3
    return float(eddy_coefficient(Sections.of_table(table), 0.0)[0])


def tanker_measured(amplitudes_rad: np.ndarray) -> np.ndarray:
    """Equivalent damping of the two runs of `FITTED`, N m s."""
    return np.array([Coefficients(*b).equivalent(omega, amplitudes_rad) for omega, *b in FITTED.values()])


MET = {
    "A": (0.036, "half of the 7.2 % that its two measured curves differ by"),
    "B": (0.051, "half of the 10.3 % that its two measured curves differ by"),
    "J": (0.103, "one measured curve: the distance of the two curves of B"),
    "K": (0.103, "one measured curve: the distance of the two curves of B"),
}
"""For the cylinders on which the formulas are as accurate as the measurement: tolerance, of their C_R, and
why. The errors on C, D, G, H, I and L are larger; docs/validation.md gives them."""


def _add(number: int) -> None:
    name, *_, theirs = CYLINDERS[number]
    tolerance, why = MET[name]
    check(
        f"ikeda-eddies-{name}",
        f"coefficient C_R of the eddies of Ikeda's rolling cylinder {name}, by his formulas",
        area=AREA,
        source=IKEDA,
        tolerance=tolerance,
        why=why,
    )(lambda: Compared(eddies(number), float(np.mean(theirs))))


for _number, _row in enumerate(CYLINDERS):
    if _row[0] in MET:
        _add(_number)

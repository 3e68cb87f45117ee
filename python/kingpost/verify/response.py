"""Checks of the response to regular waves: limits, and a hemisphere by Hulme's coefficients only."""

from __future__ import annotations

import math

import numpy as np

from ..analysis import response
from ..analysis.spectral import spectral_response
from ..analysis.wave_response import wave_response
from ..hydro.memory import smooth
from .hydrodynamics import HULME
from .measured import decay
from .models import G
from .rows import Compared, check

AREA = "response"
RADIUS, RHO = 5.0, 1000.0


def hulme_heave(ka: float) -> complex:
    """Heave of a floating hemisphere for each metre of wave, from A and B of Hulme's table alone.

    -w^2 (M + A) - i w B + rho g S; the force's size is Haskind's, |X|^2 = 8 pi rho g v_g B / (2 pi k).
    """
    displaced = RHO * 2 / 3 * math.pi * RADIUS**3
    k = ka / RADIUS
    omega = math.sqrt(G * k)
    added, damping = HULME[ka][0] * displaced, HULME[ka][1] * displaced * omega
    force = math.sqrt(4 * RHO * G * (omega / k / 2) * damping / k)
    return force / (-(omega**2) * (displaced + added) - 1j * omega * damping + RHO * G * math.pi * RADIUS**2)


def _heave(ka: float) -> float:
    """Compute the heave of the gallery's hemisphere for each metre of wave, from its database."""
    omega = math.sqrt(G * ka / RADIUS)
    found = response.rao("floating_hemisphere", [0.0], [omega], ["hemisphere"])
    return float(found.displacement.sel(point="hemisphere", axis="z").values[0, 0])


def _add(ka: float) -> None:
    check(
        f"hemisphere-rao-{ka:g}",
        f"heave of a hemisphere in waves of k a = {ka:g}, per metre of amplitude",
        area=AREA,
        unit="m/m",
        source="A and B of Hulme 1982, force by Haskind: -w^2 (M + A) - i w B + C",
        tolerance=0.02 if ka < 2 else 0.03,
        why="panels and the fit of the memory, each 1 % to 2 % of A and B (docs/hydro.md)",
    )(lambda: Compared(_heave(ka), abs(hulme_heave(ka))))


for _ka in (0.2, 0.5, 1.0, 2.0):
    _add(_ka)


OMEGA = 0.15
SLOPE = OMEGA**2 / G
DYNAMICS = "dynamics of (w / w_n)^2, w_n at least 1.2 rad/s: 1.6 %"


def _barge(direction: float, quantity: str):
    """The gallery's barge in waves of 2.7 km, its crane held."""
    still = {"bodies.tower.joint.revolute.mode": "held"}
    found = response.rao("barge", [direction], [OMEGA], ["ship"], still)
    return response.complex_amplitude(found, quantity)


@check(
    "long-heave",
    "heave of a barge in waves of 2.7 km",
    area=AREA,
    unit="m/m",
    source="1: it lies on the surface",
    tolerance=0.016,
    why=DYNAMICS,
)
def long_heave() -> Compared:
    return Compared(abs(complex(_barge(0.0, "displacement").sel(point="ship", axis="z").values[0, 0])), 1.0)


@check(
    "long-pitch",
    "pitch of a barge in waves of 2.7 km from astern",
    area=AREA,
    unit="rad/m",
    source="k: it lies on the slope",
    tolerance=0.016,
    why=DYNAMICS,
)
def long_pitch() -> Compared:
    return Compared(abs(complex(_barge(0.0, "rotation").sel(body="ship", angle="pitch").values[0, 0])), SLOPE)


@check(
    "long-roll",
    "roll of a barge in waves of 2.7 km on the beam",
    area=AREA,
    unit="rad/m",
    source="k: it lies on the slope",
    tolerance=0.016,
    why=DYNAMICS,
)
def long_roll() -> Compared:
    found = _barge(np.pi / 2, "rotation").sel(body="ship", angle="roll")
    return Compared(abs(complex(found.values[0, 0])), SLOPE)


@check(
    "long-phase",
    "lag of the barge's pitch behind the crest in waves of 2.7 km from astern",
    area=AREA,
    unit="rad",
    source="a quarter of a period: slope leads height",
    tolerance=0.016,
    why="2 zeta w / w_n, with a damping ratio of at most a tenth",
)
def long_phase() -> Compared:
    found = _barge(0.0, "rotation").sel(body="ship", angle="pitch")
    return Compared(abs(float(np.angle(found.values[0, 0]))), math.pi / 2)


ROPE_M, LOAD_KG = 20.0, 20e3
LOAD_ABOUT_X_KG_M2 = LOAD_KG / 12 * (3.0**2 + 2.5**2)
FREE_TO_SWING = {
    "bodies.pedestal.joint.revolute.mode": "held",
    "bodies.load.joint.universal.first.damping_N_m_s": 0,
    "bodies.load.joint.universal.second.damping_N_m_s": 0,
}


def _add_swing(omega: float) -> None:
    def swing() -> Compared:
        columns = ["load.roll", "boom.tip.point_position.y"]
        found = wave_response("offshore_vessel", columns, [2.0], [omega], FREE_TO_SWING)
        roll, tip = found.response.values[:, 0, 0]
        inertia = LOAD_ABOUT_X_KG_M2 + LOAD_KG * ROPE_M**2
        moment = LOAD_KG * ROPE_M * omega**2
        return Compared(roll / tip, abs(moment / (LOAD_KG * G * ROPE_M - inertia * omega**2)))

    check(
        f"swing-below-a-tip-{omega:g}",
        f"swing of a load for each metre of the boom's tip, at {omega:g} rad/s",
        area=AREA,
        unit="rad/m",
        source="a pendulum on a base that moves: m L w^2 / (m g L - (I + m L^2) w^2)",
        tolerance=1e-6,
        why="the ship trims by 4.9e-4 rad, whose square tilts the joint out of the pendulum's plane: 2.4e-7",
    )(swing)


for _omega in (0.4, 0.9):
    _add_swing(_omega)


@check(
    "deviation-of-a-sea",
    "standard deviation of the waves at a vessel, by the spectrum",
    area=AREA,
    unit="m",
    source="a quarter of the significant height, which is 2.5 m",
    tolerance=0.005,
    why="1 % of the energy at most lies beyond the frequencies of the database",
)
def deviation_of_a_sea() -> Compared:
    found = spectral_response("offshore_vessel", ["water.wave_elevation"], waves=True)
    return Compared(float(found.standard_deviation[0]), 2.5 / 4)


def convolved(drop: int) -> float:
    """An extremum of a released sphere, over its drop, from Hulme's table and Cummins' integral alone.

    (M + A_inf) z'' + Int k(t - s) z'(s) ds + C z = 0 from rest at 1, by trapezoids, with
    k(t) = 2/pi Int B(w) cos(w t) dw: in units of the radius, gravity and the displaced mass.
    """
    k = np.linspace(0.0, 12.0, 6001)
    table = np.array([(0.0, 0.0), *((ka, damping) for ka, (_, damping) in HULME.items()), (12.0, 0.0005)])
    step, steps = 0.02, 700
    omega = np.sqrt(k)
    damping = omega * smooth(table[:, 0], table[:, 1], k)
    t = step * np.arange(steps)
    kernel = 2 / np.pi * np.trapezoid(damping * np.cos(np.outer(t, omega)), omega, axis=1)
    mass, spring = 1.5, 1.5
    z, v, a = np.zeros((3, steps))
    z[0], a[0] = 1.0, -spring / mass
    for i in range(steps - 1):
        past = step * (kernel[1 : i + 2][::-1] @ v[: i + 1] - 0.5 * kernel[i + 1] * v[0])
        speed, place = v[i] + 0.5 * step * a[i], z[i] + step * v[i] + 0.25 * step**2 * a[i]
        whole = mass + 0.25 * step**2 * (kernel[0] + spring)
        a[i + 1] = -(spring * place + past + 0.5 * step * kernel[0] * speed) / whole
        v[i + 1], z[i + 1] = speed + 0.5 * step * a[i + 1], place + 0.25 * step**2 * a[i + 1]
    return float(z[1 + np.flatnonzero(np.diff(np.sign(np.diff(z))))[drop]])


def _add_decay(extremum: int) -> None:
    check(
        f"sphere-decay-{extremum + 1}",
        f"extremum {extremum + 1} of a dropped sphere's heave, over the drop, by direct convolution",
        area=AREA,
        source="Cummins' integral over the damping of Hulme 1982, table 1, without panels, states or a fit",
        tolerance=0.005,
        why="of the drop: A and B by panels to 0.4 %, their memory fitted to 0.9 %",
    )(lambda: Compared(decay()[1][extremum], convolved(extremum), scale=1.0))


for _extremum in (0, 1, 2):
    _add_decay(_extremum)

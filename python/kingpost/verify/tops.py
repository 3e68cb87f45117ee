"""Checks of free bodies and tops, for the area `multibody`."""

from __future__ import annotations

import numpy as np

from ..simulation.simulate import run
from .closed_forms import complete_elliptic, jacobi
from .models import GRAVITY, G, crossings, free_body, scenario, settings
from .rows import Compared, check, worst

AREA = "multibody"
RK4 = "RK4 errs by (omega h)^4 / 120 a radian turned: 1e-10 at these steps"


@check(
    "free-precession",
    "rate about x of a free symmetric body over 20 s",
    area=AREA,
    unit="rad/s",
    tolerance=1e-9,
    why=RK4,
    source="w_x cos((I3 - I1) / I1 w3 t); Euler; Goldstein, sec. 5.6",
)
def free_precession() -> Compared:
    body = free_body([2.0, 2.0, 3.0], angular_velocity_rad_s=[0.4, 0.0, 5.0])
    found = run(scenario({"body": body}, simulation=settings(0.002, 20.0, integrator="rk4")))
    rate = found.angular_velocity.sel(body="body", axis="x").values
    return worst(rate, 0.4 * np.cos((3 - 2) / 2 * 5.0 * found.time.values))


@check(
    "wobbling-plate",
    "wobbles per turn of a spinning thrown plate",
    area=AREA,
    tolerance=2e-4,
    why="wobble of 0.01 rad: its square, 1e-4; and the count's interpolation",
    source="2 for a thin disc; Feynman, Surely You're Joking, 1985; Tuleja et al., Am. J. Phys. 75, 2007",
)
def wobbling_plate() -> Compared:
    body = free_body([1.0, 1.0, 2.0], angular_velocity_rad_s=[0.05, 0.0, 5.0])
    found = run(scenario({"plate": body}, simulation=settings(0.002, 20.0, integrator="rk4")))
    w, x, y, z = found.orientation.sel(body="plate").values.T
    # The plate's normal precesses about the angular momentum: its direction in the world's x-y plane.
    across = np.array([2 * (x * z + w * y), 2 * (y * z - w * x)]).T
    momentum = np.array([1.0 * 0.05, 0.0, 2.0 * 5.0])
    across = across - momentum[:2] / np.linalg.norm(momentum)
    wobble = np.unwrap(np.arctan2(across[:, 1], across[:, 0]))
    # The spin in world axes is the precession rate minus the drift in body axes.
    spin = np.unwrap(2 * np.arctan2(z, w))
    return Compared((wobble[-1] - wobble[0]) / (spin[-1] - spin[0]), 2.0)


DZHANIBEKOV = ([1.0, 2.0, 3.0], [0.01, 4.0, 0.01])
"""Principal moments, kg m2, and rates at the throw, rad/s."""


def _intermediate() -> tuple[float, float, float, float]:
    """Modulus m, rate p, largest rate about y, and phase at the throw, for the rotation about the middle
    axis.

    Landau & Lifshitz, *Mechanics*, sec. 37, for H^2 > 2 E I2: w1 = a dn, w2 = b sn, w3 = c cn with the roles
    of 1 and 3 exchanged if H^2 < 2 E I2.
    """
    (i1, i2, i3), rates = DZHANIBEKOV
    energy = 0.5 * sum(i * w * w for i, w in zip((i1, i2, i3), rates, strict=True))
    squared = sum((i * w) ** 2 for i, w in zip((i1, i2, i3), rates, strict=True))
    if squared < 2 * energy * i2:
        i1, i3 = i3, i1
    p = np.sqrt((i3 - i2) * (squared - 2 * energy * i1) / (i1 * i2 * i3))
    m = (i2 - i1) * (2 * energy * i3 - squared) / ((i3 - i2) * (squared - 2 * energy * i1))
    largest = np.sqrt((2 * energy * i3 - squared) / (i2 * (i3 - i2)))
    return float(m), float(p), float(largest), float(rates[1] / largest)


def _thrown():
    body = free_body(DZHANIBEKOV[0], angular_velocity_rad_s=DZHANIBEKOV[1])
    return run(scenario({"body": body}, simulation=settings(0.002, 30.0, integrator="rk4")))


@check(
    "dzhanibekov-flip",
    "time between two flips of a body thrown about its middle axis",
    area=AREA,
    unit="s",
    tolerance=1e-7,
    why=RK4 + ", stretched by the flip's instability",
    source="2 K(m) / p; Landau & Lifshitz, Mechanics, sec. 37",
)
def dzhanibekov_flip() -> Compared:
    found = _thrown()
    rates = found.angular_velocity.sel(body="body").values
    (i1, i2, i3), _ = DZHANIBEKOV
    slope = (i3 - i1) / i2 * rates[:, 2] * rates[:, 0]
    zeros = crossings(found.time.values, rates[:, 1], slope)
    m, p, _, _ = _intermediate()
    return Compared(zeros[1] - zeros[0], 2 * complete_elliptic(m) / p)


@check(
    "dzhanibekov-rate",
    "rate about the middle axis over two flips",
    area=AREA,
    unit="rad/s",
    tolerance=1e-6,
    why=RK4 + ", stretched by the flip's instability",
    source="sn(p t, m) of Jacobi; Landau & Lifshitz, Mechanics, sec. 37",
)
def dzhanibekov_rate() -> Compared:
    found = _thrown()
    t = found.time.values
    ours = found.angular_velocity.sel(body="body", axis="y").values
    m, p, largest, _ = _intermediate()
    (i1, i2, i3), _ = DZHANIBEKOV
    rates = found.angular_velocity.sel(body="body").values
    first = crossings(t, rates[:, 1], (i3 - i1) / i2 * rates[:, 2] * rates[:, 0])[0]
    theirs = [-largest * jacobi(p * (one - first), m)[0] for one in t]
    return worst(ours, theirs)


def _top(rate: float, tilt: float) -> float:
    """Azimuth of a top's axis after 4 s in regular precession, rad.

    The top spins so that w_z' = 60 rad/s about its own axis, 0.1 m from its tip, at a tilt.
    """
    spin = 60.0
    turn = [-rate * np.sin(tilt), 0.0, spin]
    ball = {
        "child_position_m": [0, 0, -0.1],
        "initial_orientation_rad": [0, tilt, 0],
        "initial_angular_velocity_rad_s": turn,
    }
    top = {
        "mass_kg": 0.5,
        "inertia": {"tensor": {"moments_kg_m2": [1e-3, 1e-3, 2e-3]}},
        "joint": {"spherical": ball},
    }
    found = run(scenario({"top": top}, GRAVITY, simulation=settings(0.0002, 4.0, integrator="rk4")))
    x, y = found.position.sel(body="top", axis=["x", "y"]).values.T
    return float(np.unwrap(np.arctan2(y, x))[-1])


def _regular(which: int, tilt: float = 0.5) -> float:
    """I1 cos(a) W^2 - I3 w3 W + m g l = 0: both rates of regular precession, the slow one first."""
    i1, i3, moment = 1e-3 + 0.5 * 0.1**2, 2e-3, 0.5 * G * 0.1
    return float(np.sort(np.roots([i1 * np.cos(tilt), -i3 * 60.0, moment]))[which])


@check(
    "top-slow",
    "azimuth of a heavy top in its slow regular precession, after 4 s",
    area=AREA,
    unit="rad",
    tolerance=1e-8,
    why=RK4,
    source="I1 cos a W^2 - I3 w3 W + m g l = 0; Goldstein, sec. 5.7",
)
def top_slow() -> Compared:
    rate = _regular(0)
    return Compared(_top(rate, 0.5), 4.0 * rate)


@check(
    "top-fast",
    "azimuth of a heavy top in its fast regular precession, after 4 s",
    area=AREA,
    unit="rad",
    tolerance=1e-8,
    why=RK4,
    source="I1 cos a W^2 - I3 w3 W + m g l = 0; Goldstein, sec. 5.7",
)
def top_fast() -> Compared:
    rate = _regular(1)
    return Compared(_top(rate, 0.5), 4.0 * rate)

"""Radiation damping of a freely rolling hull, from its hydrodynamic database."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..errors import RollDampingError

if TYPE_CHECKING:
    from ..hydro.database import Database

# Radius of gyration in yaw over the length: of little influence, because yaw hardly couples with roll.
YAW_GYRATION = 0.25
SWAY, ROLL, YAW = 1, 3, 5


def radiated(database: Database, keel_to_gravity_m: float, frequency_rad_s: float) -> tuple[float, float]:
    """Added inertia, kg m2, and damping, N m s, of free roll about the centre of gravity by radiated waves.

    A hull in a decay test is free to sway and yaw. With Z = -omega^2 (M + A) + i omega B about the centre of
    gravity, M without the inertia in roll, sway and yaw are eliminated: Z_r = Z_44 - Z_4s Z_ss^-1 Z_s4; the
    added inertia is
    -Re Z_r / omega^2 and the damping Im Z_r / omega.

    Parameters
    ----------
    database
        Database of the hull; its mass is that of the displaced water.
    keel_to_gravity_m
        KG; the centre of gravity is vertically above the centre of buoyancy.
    frequency_rad_s
        Roll frequency, within the range of the database.

    Raises
    ------
    RollDampingError
        If the database does not cover the frequency.

    >>> from kingpost.gallery import folder
    >>> from kingpost.hydro import read
    >>> ship = read(folder() / "hydro" / "offshore_vessel.hydro.json")
    >>> inertia, damping = radiated(ship, keel_to_gravity_m=7.0, frequency_rad_s=0.5)
    >>> inertia > 0 and damping > 0
    True
    """
    known = database.frequencies_rad_s
    if not known[0] <= frequency_rad_s <= known[-1]:
        allowed = f"from {known[0]:.4g} to {known[-1]:.4g}, which the database covers"
        raise RollDampingError("frequency_rad_s", f"{frequency_rad_s:.4g}", allowed)
    hull = database.hull
    centre = np.array([hull.centre_of_buoyancy_m[0], 0.0, keel_to_gravity_m - hull.draught_m])
    impedance = np.zeros((6, 6), complex)
    for values, factor in (
        (database.added_mass, -(frequency_rad_s**2)),
        (database.radiation_damping, 1j * frequency_rad_s),
    ):
        at = [np.interp(frequency_rad_s, known, values[:, i, j]) for i in range(6) for j in range(6)]
        impedance += factor * np.reshape(at, (6, 6))
    impedance = _about(centre).T @ impedance @ _about(centre)
    mass = database.water.density_kg_m3 * hull.volume_m3
    impedance[SWAY, SWAY] -= frequency_rad_s**2 * mass
    impedance[YAW, YAW] -= frequency_rad_s**2 * mass * (YAW_GYRATION * hull.length_m) ** 2
    free = np.ix_([SWAY, YAW], [SWAY, YAW])
    moved = np.linalg.solve(impedance[free], impedance[[SWAY, YAW], ROLL])
    roll = impedance[ROLL, ROLL] - impedance[ROLL, [SWAY, YAW]] @ moved
    return float(-roll.real / frequency_rad_s**2), float(roll.imag / frequency_rad_s)


def natural_period(database: Database, keel_to_gravity_m: float, roll_gyration_m: float,
                   metacentric_height_m: float | None = None) -> float:  # fmt: skip
    """Natural period of roll, s, of a hull free to sway and yaw: omega^2 (m k^2 + A(omega)) = m g GM.

    GM can be given, for example from an inclining test; default: KB + BM - KG with the database's waterplane.
    Solved by fixed-point iteration, which converges because the added inertia changes slowly.

    Raises
    ------
    RollDampingError
        If GM is not greater than 0, or the database does not cover the frequency.

    >>> from kingpost.gallery import folder
    >>> from kingpost.hydro import read
    >>> ship = read(folder() / "hydro" / "offshore_vessel.hydro.json")
    >>> 5 < natural_period(ship, keel_to_gravity_m=6.5, roll_gyration_m=6.5) < 30
    True
    """
    hull, water = database.hull, database.water
    mass = water.density_kg_m3 * hull.volume_m3
    metacentric = metacentric_height_m
    if metacentric is None:
        height = hull.waterplane.second_moments_m4[2] / hull.volume_m3 + hull.centre_of_buoyancy_m[2]
        metacentric = height + hull.draught_m - keel_to_gravity_m
    if not metacentric > 0:
        raise RollDampingError("metacentric_height_m", f"{metacentric:.4g}", "a number greater than 0")
    stiffness = mass * water.gravity_m_s2 * metacentric
    frequency = math.sqrt(stiffness / mass) / (1.15 * roll_gyration_m)
    for _ in range(30):
        inertia = mass * roll_gyration_m**2 + radiated(database, keel_to_gravity_m, frequency)[0]
        frequency = math.sqrt(stiffness / inertia)
    return 2 * math.pi / frequency


def _about(centre: np.ndarray) -> np.ndarray:
    """Motion of the origin from that of a point: v_O = v + r x w."""
    x, y, z = centre
    found = np.eye(6)
    found[:3, 3:] = [[0, -z, y], [z, 0, -x], [-y, x, 0]]
    return found

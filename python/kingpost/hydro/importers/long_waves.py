"""What a file's excitation must be in its longest wave, where the water's motion about the hull is known.

A hull that is small against the wave feels the water's level as C_33, its slope as C_44 and C_55 (of
buoyancy alone, for the water has no weight of the hull in it), and its acceleration as inertia of the
displaced water and added mass. With k the wave number and b the direction, in deep water,

    X_1 = -i w^2 (rho V + A_11) cos b,     X_3 = C_33 - w^2 (rho V + A_33),
    Im X_4 = k (C_44 - g A_42) sin b,      Im X_5 = -k (C_55 + g A_51) cos b.

So a wrong unit, a wrong sign of time and weight left in the restoring matrix show. Each error is of first
order in k times the hull's size.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...errors import HydrodynamicsError
from ..airy import wave_number

if TYPE_CHECKING:
    from ..database import Database

# Waves are long against a hull where omega^2 L / g is at most this.
LONGEST_COUNT = 0.4
# Of C_33, and of the waterplane's part of C_44 and C_55: there, a centre of gravity wrong by a tenth of BM.
HEAVE_ERROR, SLOPE_ERROR = 0.2, 0.1
# Of buoyancy's and inertia's parts of a slope's moment, which are far more than the waterplane's in a spar:
# by panels, and by the water's motion that falls off with depth, k times the draught.
PARTS_ERROR = 0.01


def check_long_waves(database: Database, file: str, *, alone: bool = True) -> None:
    """Refuse what cannot be; waves that are not long against the hull say nothing, and are not looked at.
    Roll and pitch are those of a hull alone.

    Raises
    ------
    HydrodynamicsError
        When heave, surge, roll or pitch is not that of a hull in a long wave.
    """
    water, hull, omega = database.water, database.hull, float(database.frequencies_rad_s[0])
    shallow = water.depth_m is not None and water.depth_m < hull.length_m
    if shallow or omega**2 * max(hull.length_m, hull.draught_m) / water.gravity_m_s2 > LONGEST_COUNT:
        return
    _check_heave(database, omega, file)
    surge = (database.excitation[0, :, 0] * np.cos(database.wave_directions_rad)).sum()
    if surge.imag > 0.1 * abs(surge):
        raise HydrodynamicsError(
            "excitation", f"a surge force that leads by {np.degrees(np.angle(surge)):.3g} deg in long waves",
            "-90 deg for exp(-i w t): the sign of time or of the wave directions is the other one", file,
        )  # fmt: skip
    if alone:
        _check_slope(database, omega, file)


def _check_heave(database: Database, omega: float, file: str) -> None:
    water, hull = database.water, database.hull
    restoring = water.density_kg_m3 * water.gravity_m_s2 * hull.waterplane.area_m2
    mass = water.density_kg_m3 * hull.volume_m3
    wanted = restoring - omega**2 * (mass + database.added_mass[0, 2, 2])
    heave = database.excitation[0, :, 2].mean()
    if abs(heave - wanted) > HEAVE_ERROR * restoring:
        raise HydrodynamicsError(
            "excitation", f"{heave.real:.4g} {heave.imag:+.4g}i N/m in heave in waves of {omega:.3g} rad/s",
            f"about {wanted:.4g} N/m, by restoring and inertia; check density, gravity, length_scale_m", file,
        )  # fmt: skip


def _check_slope(database: Database, omega: float, file: str) -> None:
    water, hull, excitation = database.water, database.hull, database.excitation[0].imag
    weight, k = water.density_kg_m3 * water.gravity_m_s2, wave_number(omega, water)
    added_mass, plane = water.gravity_m_s2 * database.added_mass[0], hull.waterplane.second_moments_m4
    buoyancy = hull.volume_m3 * hull.centre_of_buoyancy_m[2]
    parts_error = max(PARTS_ERROR, k * hull.draught_m)
    for name, force, share, moment, inertia in (
        ("roll", excitation[:, 3], np.sin(database.wave_directions_rad), plane[2], -added_mass[3, 1]),
        ("pitch", -excitation[:, 4], np.cos(database.wave_directions_rad), plane[0], added_mass[4, 0]),
    ):
        found = force @ share / (share @ share) / k
        wanted = weight * (moment + buoyancy) + inertia
        parts = weight * abs(buoyancy) + abs(inertia)
        if abs(found - wanted) > max(SLOPE_ERROR * weight * moment, parts_error * parts):
            raise HydrodynamicsError(
                "restoring", f"{found:.4g} N m in {name} by a long wave's slope of 1",
                f"about {wanted:.4g} N m, by buoyancy and inertia; check restoring_includes_weight, "
                "centre_of_gravity_m, centre_of_buoyancy_m, volume_m3, reference_m and water_depth_m", file,
            )  # fmt: skip

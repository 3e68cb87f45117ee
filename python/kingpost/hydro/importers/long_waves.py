"""Check of a file's excitation in its longest wave, for which the long-wave limit is known.

For a hull that is small compared with the wave, the elevation acts through C_33, its slope through C_44 and
C_55 (buoyancy alone, without weight), and its acceleration through the inertia of the displaced water and the
added mass. With k the wave number and b the direction, in deep water,

    X_1 = -i w^2 (rho V + A_11) cos b,     X_3 = C_33 - w^2 (rho V + A_33),
    Im X_4 = k (C_44 - g A_42) sin b,      Im X_5 = -k (C_55 + g A_51) cos b.

This reveals a wrong unit, a wrong sign of time, and weight left in the restoring matrix. The relations hold
to first order in k times the hull's size.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...errors import HydrodynamicsError
from ..airy import wave_number

if TYPE_CHECKING:
    from ..database import Database

# A wave is long compared with a hull if omega^2 L / g is at most this.
LONGEST_COUNT = 0.4
# Tolerance for C_33, and for the waterplane's part of C_44 and C_55: a centre of gravity wrong by a tenth of
# BM.
HEAVE_ERROR, SLOPE_ERROR = 0.2, 0.1
# Tolerance for the parts of buoyancy and inertia in the moment of a slope, which exceed the waterplane's for
# a spar: # errors of panels, and the decay of the water's motion with depth, k times the draught.
PARTS_ERROR = 0.01
# Share of the waterplane's second moment that a mesh of 6 to 2 panels across loses, with a margin.
LEAST_MISSING, MOST_MISSING = 0.025, 0.3


def check_long_waves(database: Database, file: str, *, alone: bool = True) -> None:
    """Refuse impossible excitation; only waves that are long compared with the hull are checked.
    Roll and pitch are checked only for a single hull.

    Raises
    ------
    HydrodynamicsError
        If heave, surge, roll or pitch does not agree with that of a hull in a long wave.
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
                "restoring", f"{found:.4g} N m/rad in {name}, from the excitation by long waves",
                f"about {wanted:.4g} N m/rad, from buoyancy and inertia; "
                f"{_of_few_panels((wanted - found) / (weight * moment))}check restoring_includes_weight, "
                "centre_of_gravity_m, centre_of_buoyancy_m, volume_m3, reference_m and water_depth_m", file,
            )  # fmt: skip


def _of_few_panels(missing: float) -> str:
    """Text of an error for a loss of the waterplane's second moment that is typical of few panels.

    A sum over n equal panels takes y^2 at their centres, and misses 1 / n^2 of the integral.

    >>> _of_few_panels(0.23)[:40]
    "it misses 23 % of the waterplane's momen"
    >>> _of_few_panels(0.6)
    ''
    """
    if not LEAST_MISSING < missing < MOST_MISSING:
        return ""
    panels = round(missing**-0.5)
    return (
        f"it misses {100 * missing:.0f} % of the waterplane's moment, as about {panels} panels across do "
        "(1 / n^2), which no option mends: compute with more panels; else "
    )

"""Checks of added mass, damping and wave loads, computed anew by the panel method of `kingpost hydro`."""

from __future__ import annotations

import importlib.util
import math
from functools import cache

import numpy as np

from ..hydro.airy import group_ratio, wave_number
from ..hydro.database import Water
from .rows import Compared, NotInstalledError, check

AREA = "hydrodynamics"
RADIUS, PANELS = 5.0, 900
WATER = Water(density_kg_m3=1000.0)
DISPLACED = WATER.density_kg_m3 * 2 / 3 * math.pi * RADIUS**3
HULME = {
    0.1: (0.8627, 0.1816),
    0.2: (0.7938, 0.2793),
    0.3: (0.7157, 0.3254),
    0.4: (0.6452, 0.3410),
    0.5: (0.5861, 0.3391),
    0.6: (0.5381, 0.3271),
    0.8: (0.4698, 0.2899),
    1.0: (0.4284, 0.2484),
    1.2: (0.4047, 0.2096),
    1.6: (0.3871, 0.1469),
    2.0: (0.3884, 0.1031),
    3.0: (0.4111, 0.0452),
    4.0: (0.4322, 0.0219),
    6.0: (0.4574, 0.0066),
    10.0: (0.4771, 0.0012),
}
"""A. Hulme, J. Fluid Mech. 121, 1982, 443, heave of a hemisphere: by k a, A / M and B / M w, with M the
displaced mass; four printed digits."""
SOLVED = (0.1, 0.2, 0.5, 1.0, 2.0, 3.0)
"""The values of k a of the rows."""
TABLE = "Hulme, J. Fluid Mech. 121, 1982, table 1 (doi 10.1017/S0022112082001980)"
FLAT = "900 flat panels: first order in their area, 1 / 50 of the radius squared"
LONG, FIRST = 1e-4, 0


@cache
def solved():
    """Coefficients of a floating hemisphere at the table's k a, preceded by a much smaller k a."""
    if importlib.util.find_spec("capytaine") is None:
        raise NotInstalledError("capytaine")
    from ..hydro.meshes import parametric
    from ..hydro.shapes import Sphere
    from ..hydro.solve import solve

    lengths = np.array([LONG, *SOLVED])
    frequencies = np.sqrt(lengths * WATER.gravity_m_s2 / RADIUS)
    return solve(parametric(Sphere(RADIUS), "sphere", PANELS), WATER, frequencies, 4, True), frequencies


def heave(ka: float) -> tuple[float, float]:
    """Added mass over the displaced mass, and damping over the displaced mass and the frequency."""
    found, frequencies = solved()
    at = 1 + SOLVED.index(ka)
    damping = found.radiation_damping[at, 2, 2] / (DISPLACED * frequencies[at])
    return float(found.added_mass[at, 2, 2] / DISPLACED), float(damping)


def _add(ka: float) -> None:
    """Add the rows of added mass and damping at one k a of the table. The error of damping is relative to the
    largest of the table, 0.341."""
    check(
        f"hulme-added-mass-{ka:g}",
        f"heave added mass of a hemisphere at k a = {ka:g}, over the displaced mass",
        area=AREA,
        source=TABLE,
        tolerance=0.01,
        why=FLAT,
    )(lambda: Compared(heave(ka)[0], HULME[ka][0]))
    check(
        f"hulme-damping-{ka:g}",
        f"heave damping of a hemisphere at k a = {ka:g}, over displaced mass and frequency",
        area=AREA,
        source=TABLE,
        tolerance=0.01,
        why=FLAT + "; of the table's largest, 0.341",
    )(lambda: Compared(heave(ka)[1], HULME[ka][1], scale=0.341))


for _ka in SOLVED:
    _add(_ka)


@check(
    "heave-infinite",
    "heave added mass of a hemisphere at infinite frequency",
    area=AREA,
    source="1/2, a sphere's in unbounded water; Hulme 1982; Lamb, Hydrodynamics, sec. 92",
    tolerance=0.01,
    why=FLAT,
)
def heave_infinite() -> Compared:
    return Compared(solved()[0].added_mass_infinite[2, 2] / DISPLACED, 0.5)


@check(
    "surge-infinite",
    "surge added mass of a hemisphere at infinite frequency",
    area=AREA,
    source="4/pi - 1 = 0.2732; Hulme 1982, sec. 4",
    tolerance=0.015,
    why=FLAT + ", and the corner at the water line",
)
def surge_infinite() -> Compared:
    return Compared(solved()[0].added_mass_infinite[0, 0] / DISPLACED, 4 / math.pi - 1)


@check(
    "surge-long",
    "surge added mass of a hemisphere in infinitely long waves",
    area=AREA,
    source="1/2: with its image a sphere in unbounded water; Hulme 1982",
    tolerance=0.01,
    why=FLAT,
)
def surge_long() -> Compared:
    return Compared(solved()[0].added_mass[FIRST, 0, 0] / DISPLACED, 0.5)


@check(
    "heave-long",
    "heave added mass of a hemisphere in infinitely long waves",
    area=AREA,
    source="0.8310; Hulme 1982, sec. 4",
    tolerance=0.01,
    why=FLAT,
)
def heave_long() -> Compared:
    return Compared(solved()[0].added_mass[FIRST, 2, 2] / DISPLACED, 0.8310)


def _haskind(at: int, motion: int) -> Compared:
    """Damping B from the wave forces of all directions: k / (8 pi rho g v_g) Int |X|^2 db."""
    found, frequencies = solved()
    omega = float(frequencies[at])
    force = np.abs((found.froude_krylov + found.diffraction)[at, :, motion]) ** 2
    group = group_ratio(omega, WATER) * omega / wave_number(omega, WATER)
    carried = 8 * math.pi * WATER.density_kg_m3 * WATER.gravity_m_s2 * group
    theirs = wave_number(omega, WATER) / carried * 2 * math.pi * force.mean()
    return Compared(found.radiation_damping[at, motion, motion], theirs)


HASKIND = "Haskind's relation; Newman, J. Ship Research 6(3), 1962"


@check(
    "haskind-heave",
    "heave damping at k a = 1 from the wave forces",
    area=AREA,
    unit="kg/s",
    source=HASKIND,
    tolerance=0.01,
    why="radiation and diffraction on the same panels; " + FLAT,
)
def haskind_heave() -> Compared:
    return _haskind(1 + SOLVED.index(1.0), 2)


@check(
    "haskind-surge",
    "surge damping at k a = 1 from the wave forces",
    area=AREA,
    unit="kg/s",
    source=HASKIND,
    tolerance=0.01,
    why="radiation and diffraction on the same panels; " + FLAT,
)
def haskind_surge() -> Compared:
    return _haskind(1 + SOLVED.index(1.0), 0)


@cache
def _box():
    """Froude-Krylov forces on a box of 20 x 10 x 2 m in head waves of 30 m length, and the frequency."""
    from ..hydro.meshes import parametric
    from ..hydro.shapes import Box
    from ..hydro.solve import froude_krylov

    omega = math.sqrt(WATER.gravity_m_s2 * 2 * math.pi / 30.0)
    hull = parametric(Box(20.0, 10.0, 2.0, 5.0), "box", PANELS)
    return froude_krylov(hull, WATER, omega, np.array([0.0]))[0], 2 * math.pi / 30.0


MIDPOINTS = "three points of each triangle: fourth order in k dx = 0.14"


@check(
    "froude-krylov-heave",
    "heave force of the undisturbed wave on a box",
    area=AREA,
    unit="N/m",
    source="rho g B e^(-kT) 2/k sin(kL/2); Faltinsen, Sea Loads, 1990, ch. 3",
    tolerance=1e-4,
    why=MIDPOINTS,
)
def froude_krylov_heave() -> Compared:
    force, k = _box()
    exact = WATER.density_kg_m3 * WATER.gravity_m_s2 * 10.0 * math.exp(-2 * k) * 2 / k * math.sin(10 * k)
    return Compared(force[2].real, exact)


@check(
    "froude-krylov-surge",
    "surge force of the undisturbed wave on a box",
    area=AREA,
    unit="N/m",
    source="2 rho g B (1 - e^(-kT)) / k sin(kL/2), a quarter of a period off",
    tolerance=1e-4,
    why=MIDPOINTS,
)
def froude_krylov_surge() -> Compared:
    force, k = _box()
    carried = WATER.density_kg_m3 * WATER.gravity_m_s2
    return Compared(abs(force[0]), 2 * carried * 10.0 * (1 - math.exp(-2 * k)) / k * math.sin(10 * k))

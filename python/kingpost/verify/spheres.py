"""Checks against published computations of spheres: the decay of IEA OES Task 10 by six codes, the mean drift
by WAMIT."""

from __future__ import annotations

from functools import cache

import numpy as np

from ..hydro.drift import mean_drift
from ..hydro.meshes import parametric
from ..hydro.shapes import Sphere
from ..hydro.solve import solve
from .hydrodynamics import AREA, DISPLACED, FLAT, PANELS, RADIUS, WATER
from .measured import decay, needs_capytaine
from .rows import Compared, check

LINEAR = {
    "ProteusDS": ((2.21, 4.37, 6.52, 8.66, 10.81), (-0.8744, 0.6508, -0.4956, 0.3704, -0.2777)),
    "InWave": ((2.23, 4.44, 6.63, 8.81, 10.99), (-0.8756, 0.6313, -0.4748, 0.3422, -0.2669)),
    "WavEC": ((2.215, 4.405, 6.57, 8.72, 10.875), (-0.8705, 0.6415, -0.4754, 0.3595, -0.2708)),
    "InWave-HOTINT": ((2.22, 4.42, 6.59, 8.76, 10.93), (-0.8680, 0.6362, -0.4661, 0.3480, -0.2597)),
}
NAVIER_STOKES = ((2.23, 4.45, 6.63, 8.81, 11.00), (-0.8686, 0.6368, -0.4694, 0.3490, -0.2602))
TRUE_HULL = ((2.22, 4.43, 6.61, 8.78, 10.96), (-0.8921, 0.6317, -0.4867, 0.3410, -0.2773))
"""Times, s, of the first extrema of heave and their heights over the drop of 1 m, of four linear codes, of
NREL's Navier-Stokes code and of MARIN's with the hull's true form: Wendt et al., J. Mar. Sci. Eng. 7(11),
2019, 379 (CC BY 4.0), the curves as they are kept with HydroChrono, every 0.01 s."""
SOURCE = "Wendt et al., J. Mar. Sci. Eng. 7(11), 2019, 379 (doi 10.3390/jmse7110379): Navier-Stokes, NREL"
SPREAD = 0.0088


def _add(number: int) -> None:
    check(
        f"oes-extremum-{number + 1}",
        f"extremum {number + 1} of a sphere of 5 m released from 1 m, over the drop",
        area=AREA,
        source=SOURCE,
        tolerance=SPREAD,
        why="of the drop: the mean by which four linear codes miss it",
    )(lambda: Compared(decay()[1][number], NAVIER_STOKES[1][number], scale=1.0))


for _number in (1, 2, 3, 4):
    _add(_number)


WAMIT = {
    2.4: (0.00420, 0.00469),
    2.8: (0.06031, 0.05921),
    3.0: (0.22402, 0.20396),
    3.2: (0.64148, 0.53787),
    3.3: (0.82544, 0.66243),
    3.4: (0.87656, 0.67214),
    3.6: (0.77557, 0.54084),
    4.0: (0.64664, 0.37157),
    4.4: (0.63931, 0.29674),
}
"""By omega, rad/s, of a free hemisphere of 1 m: mean surge force over rho g R a^2 by momentum and by pressure
on 200 panels, WAMIT 7.3 by NREL: WEC-Sim_Applications, Mean_Drift (Apache-2.0)."""
DRIFT_SOURCE = "WAMIT 7.3, momentum, 200 panels: NREL, WEC-Sim_Applications, Mean_Drift (Apache-2.0)"
GRAVITY_M_S2 = 9.80665


@cache
def drift() -> np.ndarray:
    """Compute the mean surge force over rho g R a^2 by the far field at `WAMIT`'s frequencies, 900 panels."""
    needs_capytaine()
    k = np.array(list(WAMIT)) ** 2 / GRAVITY_M_S2
    frequencies = np.sqrt(k * WATER.gravity_m_s2 / RADIUS)
    one = solve(parametric(Sphere(RADIUS), "sphere", PANELS), WATER, frequencies, 4, True)
    weight = WATER.density_kg_m3 * WATER.gravity_m_s2
    force = (one.froude_krylov + one.diffraction)[:, 0]
    ahead, found = one.far_field.directions.index(0), []
    # Rotation of a sphere about its centre moves no water: only surge and heave count.
    stiffness = {0: 0.0, 2: weight * np.pi * RADIUS**2}
    for at, omega in enumerate(frequencies):
        sent = one.far_field.scattered[at, ahead].copy()
        for motion, spring in stiffness.items():
            inertia = DISPLACED + one.added_mass[at, motion, motion]
            damping = one.radiation_damping[at, motion, motion]
            moved = force[at, motion] / (spring - omega**2 * inertia - 1j * omega * damping)
            sent += moved * one.far_field.radiated[at, motion]
        found.append(mean_drift(sent, 0, omega**2 / WATER.gravity_m_s2, 0.5, WATER)[0])
    return np.array(found) / (weight * RADIUS)


def _add_drift(omega: float) -> None:
    check(
        f"wamit-drift-{omega:.1f}",
        f"mean drift force on a free hemisphere at k R = {omega**2 / GRAVITY_M_S2:.2f}, over rho g R a^2",
        area=AREA,
        source=DRIFT_SOURCE,
        tolerance=0.05,
        why=f"of the largest, 0.877: its 200 panels displace 1.0 % less than a hemisphere; {FLAT}; squared, "
        "at a resonance that is 0.3 wide in k R",
    )(lambda: Compared(drift()[list(WAMIT).index(omega)], WAMIT[omega][0], scale=0.877))


for _omega in (3.0, 3.4, 4.0):
    _add_drift(_omega)

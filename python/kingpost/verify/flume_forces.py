"""Measured wave forces on a ship's section that is held in a flume, and its mean drift force."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache

import numpy as np

from ..hydro.airy import group_ratio, wave_number
from ..hydro.drift import mean_drift
from ..hydro.meshes import parametric
from ..hydro.solve import solve
from .measured import AREA, FLUME, FLUME_WATER, flume_motions, needs_capytaine
from .rows import Compared, check, worst
from .section import RoundBilge

HELD = {
    4.143: (0.732, 0.604, 0.362),
    4.952: (0.800, 0.498, 0.897),
    5.194: (0.785, 0.453, 0.949),
    5.425: (0.788, 0.434, 0.961),
    5.860: (0.758, 0.380, 1.037),
    6.065: (0.738, 0.357, 1.014),
    7.004: (0.650, 0.264, 1.060),
    7.830: (0.584, 0.203, 0.975),
    8.578: (0.528, 0.150, 0.966),
    9.265: (0.468, 0.092, 1.112),
}
"""Sundsdal, Greco, Hanssen & Lugni, NTNU 2025 (CC0), series 2PPH over the waves of 1PPH, by rad/s:
amplitudes of the sway and heave force over rho g L B a and mean sway force over rho g L a^2 / 2, with L of
0.586 m and a that of probes 4 and 6 without the model. Mean of the runs in waves 24 mm high, or of the one
40 mm high; sines with two harmonics and a mean are fitted over whole periods from where the ramp has passed
the model to where the first reflected wave is back."""
FREE = {5.075: 0.510, 5.194: 0.628, 5.425: 0.795, 7.004: 0.737, 7.830: 0.747}
"""Mean sway force on the free section, series 3PPH, by rad/s and scaled as in `HELD`: mean of minus the force
on the vertical rail."""
SPREAD = {6.065: (0.974, 1.040), 7.004: (1.036, 1.083), 7.830: (0.947, 1.035), 8.578: (0.894, 1.054)}
"""Smallest and largest mean force on the held section among equal runs."""
FREQUENCIES = np.array(sorted({*HELD, *FREE}))
SOURCE = "Sundsdal et al., NTNU 2025 (CC0), records 2PPH over 1PPH"
LENGTHS, PANEL_M, TO_PORT = (12, 20), 0.05, 1
"""Lengths of two long hulls, in beams, and their panels; beam waves run to port."""


@dataclass(frozen=True)
class Long:
    """Beam waves on a long hull: their forces, and the ring waves that it radiates, by angle."""

    length_m: float
    excitation: np.ndarray
    scattered: np.ndarray
    radiated: np.ndarray

    def drift(self, at: int, motions: np.ndarray) -> float:
        """Mean sway force per amplitude squared of the hull with this motion, N/m2."""
        frequency = float(FREQUENCIES[at])
        sent = self.scattered[at] + motions @ self.radiated[at]
        k, ratio = wave_number(frequency, FLUME_WATER), group_ratio(frequency, FLUME_WATER)
        return float(mean_drift(sent, len(sent) // 4, k, ratio, FLUME_WATER)[1])


@cache
def _hulls() -> tuple[Long, Long]:
    needs_capytaine()
    beam = FLUME["beam"]
    shape = RoundBilge(beam, beam, FLUME["draught"], FLUME["bilge"], slender=4.0)
    found = []
    for length in LENGTHS:
        hull = replace(shape, length_m=length * beam)
        panels = round(hull.wetted_area_m2 / PANEL_M**2)
        one = solve(parametric(hull, "section", panels), FLUME_WATER, FREQUENCIES, 4, with_lid=True)
        beam_waves = one.far_field.directions.index(TO_PORT)
        force = (one.froude_krylov + one.diffraction)[:, TO_PORT]
        far = one.far_field
        found.append(Long(hull.length_m, force, far.scattered[:, beam_waves], far.radiated))
    return found[0], found[1]


def _of_a_metre(short: np.ndarray | float, long: np.ndarray | float) -> np.ndarray | float:
    one, other = _hulls()
    return (long - short) / (other.length_m - one.length_m)


def held(omega: float) -> tuple[float, float, float]:
    """Sway force, heave force and mean sway force of the held section, as in `HELD`."""
    at, weight = list(FREQUENCIES).index(omega), FLUME_WATER.density_kg_m3 * FLUME_WATER.gravity_m_s2
    short, long = _hulls()
    force = np.abs(_of_a_metre(short.excitation[at], long.excitation[at])) / (weight * FLUME["beam"])
    still = np.zeros(6)
    mean = _of_a_metre(short.drift(at, still), long.drift(at, still)) / (weight / 2)
    return float(force[1]), float(force[2]), float(mean)


def free(omega: float) -> float:
    """Mean sway force of the free section, as in `FREE`, with the motions of `flume_motions`."""
    at, weight = list(FREQUENCIES).index(omega), FLUME_WATER.density_kg_m3 * FLUME_WATER.gravity_m_s2
    moved = np.zeros(6, complex)
    moved[1:4] = flume_motions(omega)
    short, long = _hulls()
    return float(_of_a_metre(short.drift(at, moved), long.drift(at, moved)) / (weight / 2))


def _curve(which: int, frequencies: Sequence[float]) -> Compared:
    """The point with the largest difference from the measurement, relative to the largest measured value."""
    return worst([held(one)[which] for one in frequencies], [HELD[one][which] for one in frequencies])


WAVE = "the wave's height along the flume 3 %, the force's length, with or without gaps, 2.4 %"


@check(
    "flume-sway-force",
    "largest error of the sway force of beam waves on a held section, over rho g L B a, ten periods",
    area=AREA,
    source=SOURCE,
    tolerance=0.055,
    why=f"of the largest, 0.800: {WAVE}",
)
def sway_force() -> Compared:
    return _curve(0, sorted(HELD))


@check(
    "flume-heave-force",
    "largest error of the heave force of beam waves on a held section, ten periods",
    area=AREA,
    source=SOURCE,
    tolerance=0.08,
    why=f"of the largest, 0.604, in the longest wave: depth of 0.28 wave lengths 4.4 %; {WAVE}",
)
def heave_force() -> Compared:
    return _curve(1, sorted(HELD))


@check(
    "flume-drift-held",
    "largest error of the mean sway force on a held section, over rho g L a^2 / 2, repeated runs",
    area=AREA,
    source=SOURCE,
    tolerance=0.11,
    why="of the largest, 1.06: equal runs differ by 0.16, half of that 7.5 %, and 1.7 % of the wave's "
    "height, squared",
)
def drift_held() -> Compared:
    return _curve(2, sorted(SPREAD))

"""Measurements: decay tests of a sphere, of a ship's section in a flume, of a model of a research vessel."""

from __future__ import annotations

import importlib.util
from functools import cache

import numpy as np

from ..hydro.database import Water
from ..simulate import run
from ..vibration import modes
from .hydrostatics import BM, DRAUGHT, barge
from .models import crossings
from .rows import Compared, NotInstalledError, check

AREA = "measured"

KRAMER = (-0.852, 0.630, -0.455, 0.333)
"""M. B. Kramer et al., Energies 14(2), 2021, 269 (CC BY 4.0): the first extrema of the heave of a sphere of
300 mm dropped from 30 mm, over the drop; read from its figure, of which a dot is 0.0067."""
KRAMER_SOURCE = "Kramer et al., Energies 14(2), 2021, 269 (doi 10.3390/en14020269): sphere of 300 mm, 30 mm"
OES = (-0.8744, -0.8756, -0.8705, -0.8680)
"""Of four linear codes on the same sphere at 5 m (ProteusDS, InWave, WavEC, InWave with HOTINT), as kept with
HydroChrono (Apache-2.0): first minimum over the drop."""


@cache
def decay() -> tuple[np.ndarray, np.ndarray]:
    """Times of the extrema and heights over the drop of the gallery's sphere, from 1 m, a tenth of it."""
    found = run("sphere_decay", {"simulation.duration_s": 20.0, "simulation.record_every_s": 0.01})
    t = found.time.values
    height = found.position.sel(body="sphere", axis="z").values + 2.0
    rate = found.velocity.sel(body="sphere", axis="z").values
    force = found.acceleration.sel(body="sphere", axis="z").values
    times = crossings(t, rate, force)
    return times, np.interp(times, t, height)


def _add_extremum(i: int) -> None:
    check(
        f"sphere-extremum-{i + 1}",
        f"extremum {i + 1} of a dropped sphere's heave, over the drop",
        area=AREA,
        source=KRAMER_SOURCE,
        tolerance=0.03,
        why="of the drop: a dot of the figure 0.007, the test 0.003; linear and without drag, "
        "by which codes on this sphere differ 0.02",
    )(lambda: Compared(decay()[1][i], KRAMER[i], scale=1.0))


for _i in range(len(KRAMER)):
    _add_extremum(_i)


FLUME = {
    "beam": 0.40,
    "draught": 0.20,
    "bilge": 0.0512,
    "length": 0.586,
    "mass": 46.8,
    "kg": 0.106,
    "roll_radius": 0.144,
    "gm": 0.0629,
    "heave_s": 1.17,
    "roll_s": 1.26,
    "sway_N_per_m": 59.4,
}
"""Sundsdal, Greco, Hanssen & Lugni, NTNU 2025, data set 2D-ship-cross-section-in-regular-waves (CC0): model
and natural periods by decay tests."""
NTNU = "Sundsdal et al., NTNU 2025: data set 2D-ship-cross-section-in-regular-waves (CC0), decay tests"
FLUME_WATER = Water(density_kg_m3=1000.0, gravity_m_s2=9.81)
FLUME_FREQUENCIES = np.array([4.4, 4.8, 5.2, 5.6])


@cache
def section() -> tuple[np.ndarray, np.ndarray]:
    """Added mass and damping of the model in the flume, about the water plane, at `FLUME_FREQUENCIES`."""
    if importlib.util.find_spec("capytaine") is None:
        raise NotInstalledError("capytaine")
    from .section import of_unit_length

    added, damping = of_unit_length(
        FLUME["beam"], FLUME["draught"], FLUME["bilge"], FLUME_WATER, FLUME_FREQUENCIES, 0.06
    )
    return FLUME["length"] * added, FLUME["length"] * damping


def _at(omega: float, values: np.ndarray) -> np.ndarray:
    """Coefficients (frequency, ...) at a frequency, by a parabola through the three nearest."""
    nearest = np.sort(np.abs(FLUME_FREQUENCIES - omega).argsort()[:3])
    x = FLUME_FREQUENCIES[nearest]
    weights = [np.prod([(omega - x[j]) / (x[i] - x[j]) for j in range(3) if j != i]) for i in range(3)]
    return sum(weight * values[at] for weight, at in zip(weights, nearest, strict=True))


def _damped(mass: np.ndarray, added: np.ndarray, damping: np.ndarray, spring: np.ndarray) -> float:
    """Period of the free oscillation about 5 rad/s, with the coefficients of its own frequency, s."""
    omega, n = 5.0, len(mass)
    for _ in range(30):
        inverse = np.linalg.inv(mass + _at(omega, added))
        top = np.hstack([np.zeros((n, n)), np.eye(n)])
        rates = np.vstack([top, -inverse @ np.hstack([spring, _at(omega, damping)])])
        found = np.linalg.eigvals(rates).imag
        omega = float(found[np.abs(found - 5.0).argmin()])
    return 2 * np.pi / omega


def _heave_period() -> float:
    added, damping = (one[:, 2:3, 2:3] for one in section())
    carried = FLUME_WATER.density_kg_m3 * FLUME_WATER.gravity_m_s2
    spring = carried * FLUME["beam"] * FLUME["length"]
    return _damped(np.array([[FLUME["mass"]]]), added, damping, np.array([[spring]]))


def _roll_period() -> float:
    """Roll with sway about the axle at the centre of gravity, its springs in sway."""
    up = FLUME["kg"] - FLUME["draught"]
    # Sway and roll of the water plane's origin by those of the axle: a roll moves it by -up.
    shift = np.array([[1.0, up], [0.0, 1.0]])
    added, damping = (shift.T @ one[:, [1, 3]][:, :, [1, 3]] @ shift for one in section())
    mass = np.diag([FLUME["mass"] + 0.303, FLUME["mass"] * FLUME["roll_radius"] ** 2])
    righting = FLUME["mass"] * FLUME_WATER.gravity_m_s2 * FLUME["gm"]
    return _damped(mass, added, damping, np.diag([FLUME["sway_N_per_m"], righting]))


@check(
    "flume-heave",
    "heave period of a ship's section in a flume",
    area=AREA,
    unit="s",
    source=NTNU,
    tolerance=0.02,
    why="1.17 as printed 0.4 %, gaps at the walls 0.5 %, depth 0.3 %, panels 0.8 %",
)
def flume_heave() -> Compared:
    return Compared(_heave_period(), FLUME["heave_s"])


@check(
    "flume-roll",
    "roll period of a ship's section in a flume",
    area=AREA,
    unit="s",
    source=NTNU,
    tolerance=0.03,
    why="1.26 as printed 0.4 %, GM by KG of 0.106 or 0.108 m 1.6 %, gaps and panels 0.7 %",
)
def flume_roll() -> Compared:
    return Compared(_roll_period(), FLUME["roll_s"])


@check(
    "flume-gm",
    "metacentric height of that section by a static heel test",
    area=AREA,
    unit="m",
    source=NTNU.replace("decay tests", "static tests"),
    tolerance=0.012,
    why="KG of 0.106 m to half a millimetre: 0.8 %; GM to its last digit 0.1 %",
)
def flume_gm() -> Compared:
    from ..hydro.meshes import parametric
    from .section import RoundBilge

    shape = RoundBilge(FLUME["length"], FLUME["beam"], FLUME["draught"], FLUME["bilge"])
    found = parametric(shape, "section", 2000).particulars
    bm = found.waterplane.second_moments_m4[2] / found.volume_m3
    kb = FLUME["draught"] + found.centre_of_buoyancy_m[2]
    return Compared(float(kb + bm - FLUME["kg"]), FLUME["gm"])


@check(
    "melville-roll",
    "natural roll period of a hull with the Melville model's GM and radius of gyration",
    area=AREA,
    unit="s",
    tolerance=0.019,
    why="the uncertainty stated with it",
    source="Am. Towing Tank Conf. 2017, DTMB model 5720: GM 47.76 mm, k 0.2329 m; 2.139 +- 0.041 s",
)
def melville_roll() -> Compared:
    hull = barge(DRAUGHT / 2 + BM - 0.04776, added_mass=False, radiation=False)
    one = hull.with_overrides({"bodies.hull.inertia.radii_of_gyration.radii_m": [0.2329, 6.0, 6.0]})
    found = modes(one)
    named = [str(name) for name in found.named_after.values]
    return Compared(float(2 * np.pi / found.angular_frequency.values[named.index("hull.roll")]), 2.139)

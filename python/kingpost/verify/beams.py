"""Checks of flexible bodies against the Euler-Bernoulli beam."""

from __future__ import annotations

import numpy as np

from ..analysis.vibration import equilibrium, modes
from ..simulation.simulate import Simulation
from .models import scenario
from .rows import Compared, check

AREA = "beams"
LENGTH_M, MASS_KG, E_PA, SECOND_M4, TORSION_M4 = 20.0, 500.0, 2.0e11, 1e-5, 1.5e-5
SECTION = {"area_m2": 0.01, "second_moments_m4": [SECOND_M4, 2e-5], "torsion_constant_m4": TORSION_M4}
ROOTS = (1.8751040687, 4.6940911330, 7.8547574382)
"""Roots of cos x cosh x = -1: Blevins, *Formulas for Natural Frequency and Mode Shape*, 1979, table 8-1."""


def _cantilever(segments: int, tip_kg: float = 0.0, gravity: float = 0.0):
    """A slender bar clamped at its start, with a weight at its tip."""
    bodies = {
        "beam": {
            "mass_kg": MASS_KG,
            "flexible": {
                "segments": segments,
                "youngs_modulus_Pa": E_PA,
                "length_m": LENGTH_M,
                "section": {"general": SECTION},
            },
            "joint": {"fixed": {"child_position_m": [-LENGTH_M / 2, 0, 0]}},
            "points": {"tip": {"position_m": [LENGTH_M / 2, 0, 0]}},
        }
    }
    if tip_kg:
        at_tip = {"fixed": {"position_m": [LENGTH_M / 2, 0, 0]}}
        bodies["load"] = {"parent": "beam", "mass_kg": tip_kg, "shape": {"point": {}}, "joint": at_tip}
    return scenario(bodies, {"gravity": {"gravity": {"acceleration_m_s2": gravity}}} if gravity else {})


def _bending(which: int) -> Compared:
    """Frequency of bending in the plane of the smaller second moment, rad/s."""
    found = Simulation(_cantilever(16)).linearize()
    names, n = found.coordinates, len(found.coordinates)
    block = found.A.values[n : 2 * n, :n]
    planar = [i for i, name in enumerate(names) if name.endswith(("shear_z", "bending_y"))]
    squares = np.sort(-np.linalg.eigvals(block[np.ix_(planar, planar)]).real)
    exact = ROOTS[which] ** 2 * np.sqrt(E_PA * SECOND_M4 / (MASS_KG / LENGTH_M)) / LENGTH_M**2
    return Compared(float(np.sqrt(squares[which])), exact)


@check(
    "cantilever-1",
    "first bending frequency of a cantilever, 16 segments",
    area=AREA,
    unit="rad/s",
    source="1.8751^2 sqrt(EI / m l^4); Blevins 1979, table 8-1",
    tolerance=2e-3,
    why="second order in the segment: (beta l / n)^2 / 8 = 0.0017",
)
def cantilever_1() -> Compared:
    return _bending(0)


@check(
    "cantilever-2",
    "second bending frequency of a cantilever, 16 segments",
    area=AREA,
    unit="rad/s",
    source="4.6941^2 sqrt(EI / m l^4); Blevins 1979, table 8-1",
    tolerance=1.1e-2,
    why="second order in the segment: (beta l / n)^2 / 8 = 0.0108",
)
def cantilever_2() -> Compared:
    return _bending(1)


@check(
    "cantilever-3",
    "third bending frequency of a cantilever, 16 segments",
    area=AREA,
    unit="rad/s",
    source="7.8548^2 sqrt(EI / m l^4); Blevins 1979, table 8-1",
    tolerance=3.1e-2,
    why="second order in the segment: (beta l / n)^2 / 8 = 0.030",
)
def cantilever_3() -> Compared:
    return _bending(2)


@check(
    "cantilever-tip-weight",
    "deflection of a cantilever's tip by a weight there",
    area=AREA,
    unit="m",
    source="W l^3 / 3 E I; Gere & Timoshenko, Mechanics of Materials, app. G",
    tolerance=1e-6,
    why="exact for a chain of such joints except for the square of the slope, 1e-7; the equilibrium to 1e-8",
)
def cantilever_tip_weight() -> Compared:
    gravity = 1e-2
    tips = [
        equilibrium(_cantilever(8, tip, gravity)).point_position.sel(axis="z").values[-1]
        for tip in (0.0, 300.0)
    ]
    exact = 300.0 * gravity * LENGTH_M**3 / (3 * E_PA * SECOND_M4)
    return Compared(float(tips[0] - tips[1]), exact)


@check(
    "cantilever-own-weight",
    "deflection of a cantilever's tip by its own weight, 16 segments",
    area=AREA,
    unit="m",
    source="w l^4 / 8 E I; Gere & Timoshenko, Mechanics of Materials, app. G",
    tolerance=2e-3,
    why="weight at the segments' middles: second order, 1 / (2 n^2) = 0.002",
)
def cantilever_own_weight() -> Compared:
    gravity = 1e-2
    tip = equilibrium(_cantilever(16, 0.0, gravity)).point_position.sel(axis="z").values[-1]
    return Compared(-float(tip), MASS_KG * gravity * LENGTH_M**3 / (8 * E_PA * SECOND_M4))


@check(
    "torsion-1",
    "first torsional frequency of a clamped bar with a disc at its end",
    area=AREA,
    unit="rad/s",
    source="sqrt(G J / l I): a heavy disc on a light bar; Den Hartog, ch. 2",
    tolerance=1e-4,
    why="the bar's own inertia, a third of 0.0001 of the disc's",
)
def torsion_1() -> Compared:
    disc = {
        "parent": "beam",
        "mass_kg": 10.0,
        "inertia": {"tensor": {"moments_kg_m2": [1e5, 5e4, 5e4]}},
        "joint": {"fixed": {"position_m": [LENGTH_M / 2, 0, 0]}},
    }
    base = _cantilever(8).resolved
    found = modes(scenario({**base["bodies"], "disc": disc}))
    named = [str(name) for name in found.named_after.values]
    torsion = [i for i, name in enumerate(named) if "torsion" in name]
    shear_modulus = E_PA / (2 * 1.3)
    exact = np.sqrt(shear_modulus * TORSION_M4 / (LENGTH_M * 1e5))
    return Compared(float(found.angular_frequency.values[torsion[0]]), exact)

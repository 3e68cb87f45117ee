"""Checks of the three chains of MoorDyn's test case `quasi_static_chain`: published tensions at rest, and the
elastic catenary."""

from __future__ import annotations

import math
from typing import Any

from ..simulation.simulate import Simulation
from .lines import SOLID, catenary
from .models import GRAVITY, G, scenario, value
from .mooring import AREA as MOORING
from .mooring import NEWTON, resting_line
from .rows import Compared, check

AREA = "lines"
SECTION = {"mass_kg_per_m": 390.0, "diameter_m": 0.252, "axial_stiffness_N": 1.674e9}
CASES = {
    50: {"across_m": 400.0, "length_m": 410.0, "published_N": 991.6e3, "elements": 80},
    200: {"across_m": 700.0, "length_m": 760.0, "published_N": 2065.4e3, "elements": 80},
    600: {"across_m": 1500.0, "length_m": 1700.0, "published_N": 5232.6e3, "elements": 170},
}
"""By the depth of the water, m: distance and length of the chain, its published tension, and our elements."""
TOUCHDOWN = "the touchdown is between nodes, which are 2.6 to 5 m apart"
PUBLISHED = "MoorDyn, tests/quasi_static_chain.cpp: tensions by quasi-static codes"


def weight() -> float:
    """Weight of the chain in water, N/m."""
    return (SECTION["mass_kg_per_m"] - 1025.0 * math.pi / 4 * SECTION["diameter_m"] ** 2) * G


def closed_form(depth_m: int) -> float:
    """Tension at the fairlead of the elastic catenary, N.

    >>> [round(closed_form(depth) / 1e3, 1) for depth in CASES]
    [1001.7, 2070.1, 5236.2]
    """
    case = CASES[depth_m]
    line = SECTION | {
        "unstretched_length_m": case["length_m"],
        "fairlead_m": [0.0, 0.0, 0.0],
        "anchor_m": [case["across_m"], 0.0, -float(depth_m)],
    }
    return math.hypot(*catenary(line, True))


def massless(depth_m: int) -> float:
    """Tension at the fairlead of a `catenary_line`, N."""
    case = CASES[depth_m]
    stiffness = SECTION["axial_stiffness_N"]
    simulation = resting_line(
        case["across_m"], float(depth_m), case["length_m"], weight(), stiffness, seabed=True
    )
    return value(simulation, "line_tension", "line")


def with_mass(depth_m: int, elements: int | None = None) -> float:
    """Tension at the fairlead of a `line`, N."""
    case = CASES[depth_m]
    count = elements or case["elements"]
    section = SECTION | {"unstretched_length_m": case["length_m"], "elements": count}
    line = {
        "first": {"body": "buoy"},
        "second": {"body": "world", "position_m": [case["across_m"], 0.0, -float(depth_m)]},
        "sections": [section],
        "seabed": {"friction": 0.5},
    }
    held: dict[str, Any] = {"prismatic": {"axis": [0, 0, 1], "mode": "held"}}
    buoy = {"mass_kg": 1.0, "shape": {"point": {}}, "joint": held}
    sea = {"density_kg_m3": 1025.0, "depth_m": float(depth_m)}
    chain = scenario({"buoy": buoy}, GRAVITY | {"line": {"line": line}}, sea=sea)
    return value(Simulation(chain), "line_tension", "line")


def _add(depth_m: int) -> None:
    chain = f"tension at the fairlead of a chain at rest in {depth_m} m of water"
    check(
        f"chain-{depth_m}-catenary",
        chain,
        area=MOORING,
        unit="N",
        source=SOLID,
        tolerance=1e-9,
        why=NEWTON,
    )(lambda: Compared(massless(depth_m), closed_form(depth_m)))
    check(
        f"line-chain-{depth_m}",
        f"{chain}, with mass",
        area=AREA,
        unit="N",
        source=SOLID,
        tolerance=2e-4,
        why=TOUCHDOWN,
    )(lambda: Compared(with_mass(depth_m), closed_form(depth_m)))
    check(
        f"line-chain-{depth_m}-published",
        f"{chain}, with mass, as published",
        area=AREA,
        unit="N",
        source=PUBLISHED,
        tolerance=1.1e-2,
        why="the closed form is 1.0 %, 0.2 % and 0.07 % above the published tensions",
    )(lambda: Compared(with_mass(depth_m), CASES[depth_m]["published_N"]))


for _depth in CASES:
    _add(_depth)

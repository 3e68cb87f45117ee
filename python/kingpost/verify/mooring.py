"""Checks of mooring lines: the catenary equations, and a published mooring."""

from __future__ import annotations

import importlib.util
import math

import numpy as np

from ..analysis.vibration import modes
from ..simulation.simulate import Simulation
from .models import scenario, slider, value
from .rows import Compared, NotInstalledError, check

AREA = "mooring"
IRVINE = "Irvine, Cable Structures, 1981, ch. 1"
NEWTON = "Newton's method ends at rounding of the line's weight"
HELD = {
    "mass_kg": 1e6,
    "shape": {"sphere": {"radius_m": 1.0}},
    "joint": {"floating": {"hold_translation": True, "hold_rotation": True}},
}


def resting_line(
    across: float, up: float, length: float, weight: float, stiffness: float, seabed: bool
) -> Simulation:
    """A line from a buoy at the origin to an anchor at a given distance and depth."""
    line = {
        "fairlead": {"body": "buoy"},
        "anchor_m": [across, 0, -up],
        "unstretched_length_m": length,
        "weight_in_water_N_per_m": weight,
        "axial_stiffness_N": stiffness,
        "seabed": seabed,
    }
    return Simulation(scenario({"buoy": HELD}, {"line": {"catenary_line": line}}))


def _touching(stiffness: float) -> Simulation:
    """A chain of 1 kN/m with 300 kN horizontal tension; the bottom is 100 m below."""
    pull, weight, height = 3e5, 1e3, 100.0
    hanging = math.sqrt(height**2 + 2 * height * pull / weight)
    across = 500.0 - hanging + pull / weight * math.asinh(weight * hanging / pull)
    return resting_line(across, height, 500.0, weight, stiffness, True)


INEXTENSIBLE = "no stretch: T / EA = 4e-10 of the length, 25 times that in the tension of a line so taut"


@check(
    "catenary-tension",
    "fairlead tension of a chain that lies on the bottom",
    area=AREA,
    unit="N",
    source=f"H + w h; {IRVINE}",
    tolerance=1e-6,
    why=INEXTENSIBLE,
)
def catenary_tension() -> Compared:
    return Compared(value(_touching(1e15), "line_tension", "line"), 3e5 + 1e3 * 100.0)


@check(
    "catenary-anchor",
    "tension at the anchor of a chain that lies on the bottom",
    area=AREA,
    unit="N",
    source=f"H; {IRVINE}",
    tolerance=1e-6,
    why=INEXTENSIBLE,
)
def catenary_anchor() -> Compared:
    return Compared(value(_touching(1e15), "line_end_tension", "line"), 3e5)


@check(
    "catenary-grounded",
    "length on the bottom of a chain that lies on the bottom",
    area=AREA,
    unit="m",
    source=f"L - sqrt(h^2 + 2 h H / w); {IRVINE}",
    tolerance=1e-6,
    why=INEXTENSIBLE,
)
def catenary_grounded() -> Compared:
    ours = value(_touching(1e15), "line_grounded_length", "line")
    return Compared(ours, 500.0 - math.sqrt(100.0**2 + 2 * 100.0 * 300.0))


def elastic_span(
    force: tuple[float, float], weight: float, length: float, stiffness: float, grounded: bool = False
) -> tuple[float, float]:
    """Horizontal and vertical distance of the ends of an elastic catenary, m, under the horizontal and the
    vertical force at its upper end, N (Irvine, *Cable Structures*, 1981, ch. 1).

    Grounded, its lower part may lie on a level bottom without friction.
    """
    pull, lift = force
    below = lift - weight * length
    lying = max(-below, 0.0) / weight if grounded else 0.0
    below += weight * lying
    turns = math.asinh(lift / pull) - math.asinh(below / pull)
    ends = math.hypot(pull, lift), math.hypot(pull, below)
    across = lying + pull / weight * turns + pull * length / stiffness
    return across, (ends[0] - ends[1]) / weight + (lift**2 - below**2) / (2 * weight * stiffness)


@check(
    "catenary-elastic",
    "tension of a rope of 20 MN that hangs free",
    area=AREA,
    unit="N",
    source=f"elastic catenary of H = 200 kN, V = 150 kN; {IRVINE}",
    tolerance=1e-9,
    why=NEWTON,
)
def catenary_elastic() -> Compared:
    pull, lift, weight, length, stiffness = 2e5, 1.5e5, 250.0, 400.0, 2e7
    across, up = elastic_span((pull, lift), weight, length, stiffness)
    simulation = resting_line(across, up, length, weight, stiffness, False)
    return Compared(value(simulation, "line_tension", "line"), math.hypot(pull, lift))


@check(
    "catenary-level",
    "tension of a rope between two points at one height",
    area=AREA,
    unit="N",
    source=f"H cosh(w l / 2 H), H from L = 2 H / w sinh(w l / 2 H); {IRVINE}",
    tolerance=1e-6,
    why="no stretch: T / EA = 1e-8, tenfold in a taut line",
)
def catenary_level() -> Compared:
    weight, across, pull = 500.0, 200.0, 1e5
    half = weight * across / (2 * pull)
    length = 2 * pull / weight * math.sinh(half)
    simulation = resting_line(across, 0.0, length, weight, 1e13, False)
    return Compared(value(simulation, "line_tension", "line"), pull * math.cosh(half))


OC3 = {"length": 902.2, "weight": 698.094, "stiffness": 384.243e6}
JONKMAN = "Jonkman, NREL/TP-500-47535, 2010, sec. 5.3: the spar of OC3"
PRINTED = "four printed figures, found there by differences of steps of 1 m or 0.1 rad"


def _oc3() -> Simulation:
    """The spar's three lines on a free body of 1000 t about the platform's reference point."""
    lines = {}
    for i, angle in enumerate(np.deg2rad([0.0, 120.0, 240.0])):
        way = np.array([math.cos(angle), math.sin(angle)])
        lines[f"line_{i}"] = {
            "catenary_line": {
                "fairlead": {"body": "spar", "position_m": [*(5.2 * way), -70.0]},
                "anchor_m": [*(853.87 * way), -320.0],
                "unstretched_length_m": OC3["length"],
                "weight_in_water_N_per_m": OC3["weight"],
                "axial_stiffness_N": OC3["stiffness"],
            }
        }
    spar = {
        "mass_kg": 1e6,
        "inertia": {"tensor": {"moments_kg_m2": [1e6, 1e6, 1e6]}},
        "joint": {"floating": {}},
    }
    return Simulation(scenario({"spar": spar}, lines))


def _load(motion: int = 0, step: float = 0.0) -> np.ndarray:
    """The mooring's force and moment (6) on the spar moved along or turned about an axis."""
    simulation = _oc3()
    q = np.array([0.0, 0, 0, 1, 0, 0, 0])
    if motion < 3:
        q[motion] += step
    else:
        q[3], q[1 + motion] = math.cos(step / 2), math.sin(step / 2)
    simulation.set_state(q, np.zeros(6))
    return 1e6 * simulation.acceleration()


def _stiffness(force: int, motion: int) -> float:
    step = 0.05 if motion < 3 else 5e-4
    return float((_load(motion, -step) - _load(motion, step))[force] / (2 * step))


def _add(name: str, what: str, unit: str, entry: tuple[int, int], published: float, tolerance: float) -> None:
    check(
        f"oc3-{name}",
        f"{what} of the mooring of the OC3 spar",
        area=AREA,
        unit=unit,
        source=JONKMAN,
        tolerance=tolerance,
        why=PRINTED,
    )(lambda: Compared(_stiffness(*entry), published))


@check(
    "oc3-load",
    "downward load of the mooring of the OC3 spar",
    area=AREA,
    unit="N",
    source=JONKMAN,
    tolerance=5e-4,
    why="four printed figures",
)
def oc3_load() -> Compared:
    return Compared(_load()[2], -1607e3)


_add("surge", "surge stiffness", "N/m", (0, 0), 41.18e3, 5e-3)
_add("heave", "heave stiffness", "N/m", (2, 2), 11.94e3, 5e-3)
_add("surge-pitch", "surge force by pitch", "N/rad", (0, 4), -2.821e6, 5e-3)
_add("pitch", "pitch stiffness", "N m/rad", (4, 4), 311.1e6, 5e-3)
_add("yaw", "yaw stiffness", "N m/rad", (5, 5), 11.56e6, 5e-3)


@check(
    "hawser-mode",
    "frequency of a mass on a taut hawser",
    area=AREA,
    unit="rad/s",
    source="sqrt(EA / L m)",
    tolerance=1e-9,
    why="exact A",
)
def hawser_mode() -> Compared:
    hawser = {
        "first": {"body": "mass"},
        "second": {"body": "world", "position_m": [60.0, 0, 0]},
        "unstretched_length_m": 40.0,
        "axial_stiffness_N": 4e6,
    }
    # An undamped servo holds the body where the hawser is taut: its stiffness adds to that of the hawser.
    mass = slider(1e5, spring={"stiffness_N_per_m": 1e5, "rest_m": 0.0})
    found = modes(scenario({"mass": mass}, {"hawser": {"spring_line": hawser}}))
    return Compared(float(found.angular_frequency.values[0]), math.sqrt((4e6 / 40.0 + 1e5) / 1e5))


@check(
    "moorpy-line",
    "tension of a chain that lies on the bottom, by MoorPy",
    area=AREA,
    unit="N",
    source="MoorPy's catenary (Hall et al., NREL)",
    tolerance=1e-5,
    why="its solver's tolerance on the position of the line's end",
)
def moorpy_line() -> Compared:
    if importlib.util.find_spec("moorpy") is None:
        raise NotInstalledError("moorpy")
    from moorpy.Catenary import catenary

    across, up, length, weight, stiffness = 820.0, 250.0, 902.2, 698.094, 384.243e6
    found = catenary(across, up, length, stiffness, weight, CB=0.0, Tol=1e-9)
    theirs = math.hypot(found[2], found[3])
    simulation = resting_line(across, up, length, weight, stiffness, True)
    return Compared(value(simulation, "line_tension", "line"), theirs)

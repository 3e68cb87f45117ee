"""Checks of lines with mass: the catenary and bar equations, and runs of MoorDyn, stored with their origin in
`lines.json`."""

from __future__ import annotations

import cmath
import json
import math
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from ..scenario import Scenario
from ..simulation.simulate import Simulation, run
from .models import GRAVITY, G, scenario, settings, value
from .mooring import elastic_span
from .rows import Compared, check, worst

AREA = "lines"
STEP_S = 0.05
AT_REST = {"chain": 80, "hanging": 20}
"""Elements of the lines at rest."""
MOVING = {"chain": 40, "wire": 20}
"""Elements of the lines that move."""
FINEST = {"chain": "160", "wire": "80"}
"""Segments of the stored runs that are compared."""


@cache
def kept() -> dict[str, Any]:
    """The cases, and the results of MoorDyn.

    >>> kept()["chain"]["unstretched_length_m"]
    850.0
    """
    return json.loads((Path(__file__).parent / "lines.json").read_text(encoding="utf-8"))


def _weight(line: dict[str, Any]) -> float:
    """Weight of a line in water, N/m."""
    water = kept()["sea"]["density_kg_m3"] * math.pi / 4 * line["diameter_m"] ** 2
    return (line["mass_kg_per_m"] - water) * G


def _section(line: dict[str, Any], elements: int) -> dict[str, Any]:
    names = (
        "unstretched_length_m",
        "mass_kg_per_m",
        "diameter_m",
        "axial_stiffness_N",
        "damping_time_s",
        "added_mass_across",
        "added_mass_along",
        "drag_across",
        "drag_along",
    )
    return {name: line[name] for name in names} | {"elements": elements}


def _support(motion: dict[str, Any], way: str, axis: list[int], **more: Any) -> dict[str, Any]:
    """A body of 1 g on a slide, which moves as given or stays."""
    one = motion.get(way, {"amplitude_m": 0.0, "period_s": 10.0, "phase_rad": 0.0})
    moves = {
        "amplitude_m": one["amplitude_m"],
        "period_s": one["period_s"],
        "phase_deg": math.degrees(one["phase_rad"]),
        "ramp_s": motion.get("ramp_s", 1.0),
    }
    joint = {"axis": axis, "mode": {"oscillation": moves}}
    return {
        "mass_kg": 1e-3,
        "inertia": {"tensor": {"moments_kg_m2": [1e-3, 1e-3, 1e-3]}},
        "joint": {"prismatic": joint | more.pop("joint", {})},
        **more,
    }


def _scenario(
    line: dict[str, Any], motion: dict[str, Any], force: dict[str, Any], bodies: Any = None, **forces: Any
) -> Scenario:
    """A line from a fairlead that moves in surge and heave."""
    supports = {
        "surge": _support(motion, "surge", [1, 0, 0], joint={"position_m": line["fairlead_m"]}),
        "fairlead": _support(motion, "heave", [0, 0, 1], parent="surge"),
    }
    return scenario(
        supports | (bodies or {}),
        GRAVITY | {"line": {"line": {"first": {"body": "fairlead"}} | force}} | forces,
        simulation=settings(STEP_S, motion.get("duration_s", STEP_S), integrator="rk4"),
        sea={"density_kg_m3": kept()["sea"]["density_kg_m3"], "depth_m": line["depth_m"]},
    )


def chain(motion: str, elements: int) -> Scenario:
    """The chain on the bottom, with a fairlead that moves as in a stored run."""
    line, sea = kept()["chain"], kept()["sea"]
    ground = {
        "friction": 0.0,
        "stiffness_N_per_m3": sea["ground_stiffness_N_per_m3"],
        "damping_time_s": sea["ground_damping_N_s_per_m3"] / sea["ground_stiffness_N_per_m3"],
    }
    force = {
        "second": {"body": "world", "position_m": line["anchor_m"]},
        "sections": [_section(line, elements)],
        "seabed": ground,
    }
    return _scenario(line, line[motion], force)


def wire(motion: str, elements: int) -> Scenario:
    """The wire with a load in the water, with an upper end that moves as in a stored run."""
    line, density = kept()["wire"], kept()["sea"]["density_kg_m3"]
    volume, length, stiffness = (
        line["load_volume_m3"],
        line["unstretched_length_m"],
        line["axial_stiffness_N"],
    )
    pull = (line["load_kg"] - density * volume) * G
    stretch = (pull + _weight(line) * length / 2) * length / stiffness
    height = line["fairlead_m"][2] - length - stretch
    # A little more than the volume, which is given.
    solid = {"sphere": {"radius_m": 1.5}}
    load = {
        "mass_kg": line["load_kg"],
        "shape": solid,
        "joint": {"prismatic": {"axis": [0, 0, 1], "position_m": [0, 0, height]}},
    }
    added = line["load_added_mass_kg"] / (density * volume)
    water = {
        "body": "load",
        "shape": solid,
        "displaced_volume_m3": volume,
        "added_mass": {"coefficients": [added, added, added], "reference_volume_m3": volume},
    }
    force = {"second": {"body": "load"}, "sections": [_section(line, elements)]}
    return _scenario(line, line[motion], force, {"load": load}, water={"submerged": water})


@cache
def _ours(name: str, motion: str) -> xr.Dataset:
    build = {"chain": chain, "wire": wire}[name]
    return run(build(motion, MOVING[name]))


def tension(name: str, motion: str) -> tuple[np.ndarray, np.ndarray]:
    """Times and tensions at the fairlead of Kingpost's run, s and N."""
    found = _ours(name, motion)
    return found["time"].values, found["line_tension"].sel(line="line").values


def _late(name: str, motion: str) -> np.ndarray:
    """The part of the tension from which statistics are."""
    t, tensions = tension(name, motion)
    return tensions[t > kept()[name][motion]["from_s"] - STEP_S / 2]


def compared(name: str, motion: str, figure: str) -> Compared:
    """Mean, standard deviation (`std`), maximum or minimum of the tension at the fairlead."""
    theirs = kept()[name][motion]["segments"][FINEST[name]]
    return Compared(float(getattr(_late(name, motion), figure)()), theirs[f"{figure}_N"])


def history(name: str, motion: str) -> Compared:
    """The tension at the fairlead at the times of the stored run, where the difference is largest."""
    case = kept()[name][motion]
    theirs = case["segments"][FINEST[name]]["tension_N"]
    return worst(tension(name, motion)[1][:: round(case["every_s"] / STEP_S)], theirs)


def catenary(line: dict[str, Any], grounded: bool) -> tuple[float, float]:
    """Horizontal and vertical force at the fairlead of an elastic line (Irvine), N, by Newton's method."""
    weight, stiffness, length = _weight(line), line["axial_stiffness_N"], line["unstretched_length_m"]
    across, up = (abs(line["anchor_m"][i] - line["fairlead_m"][i]) for i in (0, 2))

    def misses(force: np.ndarray) -> np.ndarray:
        return np.subtract(
            elastic_span((force[0], force[1]), weight, length, stiffness, grounded), (across, up)
        )

    force = weight * np.array([across / 3, 0.7 * length])
    for _ in range(40):
        slopes = np.column_stack([misses(force + one) - misses(force - one) for one in np.eye(2)]) / 2
        force = force - np.linalg.solve(slopes, misses(force))
    return float(force[0]), float(force[1])


SOLID = "Irvine, Cable Structures, 1981, ch. 1: elastic catenary"
TOUCHDOWN = (
    "the touchdown is between nodes, which are 5 m apart: up to 2.6e-4 with 64 to 100 elements; "
    "the ground gives by 6 mm: 4e-5"
)


def resting() -> float:
    """Tension at the fairlead of the chain at rest, N."""
    return value(Simulation(chain("rest", AT_REST["chain"])), "line_tension", "line")


@check(
    "line-rest",
    "fairlead tension of a chain with mass at rest, partly on the bottom",
    area=AREA,
    unit="N",
    source=SOLID,
    tolerance=3e-4,
    why=TOUCHDOWN,
)
def line_rest() -> Compared:
    return Compared(resting(), math.hypot(*catenary(kept()["chain"], True)))


MOORDYN = f"MoorDyn {kept()['moordyn']} (Hall & Goupee, Ocean Eng. 104, 2015, 590)"


@check(
    "line-rest-moordyn",
    "fairlead tension of a chain with mass at rest, partly on the bottom, by MoorDyn",
    area=AREA,
    unit="N",
    source=f"{MOORDYN}, 160 segments",
    tolerance=3e-4,
    why=TOUCHDOWN,
)
def line_rest_moordyn() -> Compared:
    return Compared(resting(), kept()["chain"]["rest"]["segments"]["160"]["tension_N"])


@check(
    "line-hanging",
    "force of a chain with mass that hangs free on its support",
    area=AREA,
    unit="N",
    source=SOLID,
    tolerance=1e-7,
    why="fourth order in the length of its elements: 6e-7 with 10, 4e-8 with 20",
)
def line_hanging() -> Compared:
    line = kept()["chain"] | {"anchor_m": [600.0, 0.0, -200.0], "depth_m": 1000.0}
    force = {
        "second": {"body": "world", "position_m": line["anchor_m"]},
        "sections": [_section(line, AT_REST["hanging"])],
    }
    simulation = Simulation(_scenario(line, {}, force))
    across, _, up = (value(simulation, "joint_reaction", "fairlead", f"force_{axis}") for axis in "xyz")
    return Compared(math.hypot(across, up - 1e-3 * G), math.hypot(*catenary(line, False)))


def bar() -> tuple[float, float]:
    """Closed forms of the wire as a bar with the load at its end (Rao): amplitude of the tension at the end
    that moves, N, and the first natural frequency, rad/s."""
    line = kept()["wire"]
    motion = line["half"]["heave"]
    length, mass = line["unstretched_length_m"], line["load_kg"] + line["load_added_mass_kg"]

    def forces(omega: float, damping_s: float) -> tuple[complex, complex]:
        """Force at the top, and motion there, for a motion of 1 m of the load."""
        stiffness = line["axial_stiffness_N"] * (1 + 1j * omega * damping_s)
        number = omega * cmath.sqrt(line["mass_kg_per_m"] / stiffness)
        cosine, sine = cmath.cos(number * length), cmath.sin(number * length)
        inertia = mass * omega**2 / (stiffness * number)
        return stiffness * number * (sine + inertia * cosine), cosine - inertia * sine

    force, moved = forces(2 * math.pi / motion["period_s"], line["damping_time_s"])
    # At the first natural frequency the top is at rest: below it, it moves with the load.
    low, high = 0.01, math.pi / 2 / length * math.sqrt(line["axial_stiffness_N"] / line["mass_kg_per_m"])
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if forces(middle, 0.0)[1].real > 0 else (low, middle)
    return motion["amplitude_m"] * abs(force / moved), low


def harmonic(t: np.ndarray, tensions: np.ndarray) -> float:
    """Amplitude of the tension with the period of the motion, N, by least squares beside the free oscillation
    that the start leaves, which decays."""
    line = kept()["wire"]
    case, natural = line["half"], bar()[1]
    late = (t > case["from_s"] - 1e-9) & (t < case["duration_s"] - 1e-9)
    t, forced = t[late], 2 * math.pi / case["heave"]["period_s"]
    decay = np.exp(-line["damping_time_s"] * natural**2 / 2 * (t - case["from_s"]))
    terms = [
        np.ones_like(t),
        np.cos(forced * t),
        np.sin(forced * t),
        decay * np.cos(natural * t),
        decay * np.sin(natural * t),
    ]
    found = np.linalg.lstsq(np.column_stack(terms), tensions[late], rcond=None)[0]
    return float(np.hypot(found[1], found[2]))


def sampled() -> np.ndarray:
    """Times of the stored run of the wire, s."""
    case = kept()["wire"]["half"]
    return case["every_s"] * np.arange(len(case["segments"][FINEST["wire"]]["tension_N"]))


def our_harmonic() -> float:
    """Amplitude of Kingpost's tension, at the times of the stored run, N."""
    _, tensions = tension("wire", "half")
    return harmonic(sampled(), tensions[:: round(kept()["wire"]["half"]["every_s"] / STEP_S)])


FIT = "what the fit of the free oscillation of 290 kN leaves, 0.2 kN"
WIRE = "of the tension of 3000 m of wire with a load at its end, whose top moves by 0.5 m in 8 s"


@check(
    "line-wire",
    f"amplitude {WIRE}",
    area=AREA,
    unit="N",
    source="bar of EA (1 + i w tau), 280 t at its end; Rao, Vibration of Continuous Systems, 2007, sec. 9.3",
    tolerance=1e-4,
    why=FIT,
)
def line_wire() -> Compared:
    return Compared(our_harmonic(), bar()[0])


@check(
    "line-wire-moordyn",
    f"amplitude {WIRE}, by MoorDyn",
    area=AREA,
    unit="N",
    source=f"{MOORDYN}, 80 segments",
    tolerance=2e-4,
    why=f"{FIT}; theirs is 5e-5 below the closed form",
)
def line_wire_moordyn() -> Compared:
    theirs = np.array(kept()["wire"]["half"]["segments"][FINEST["wire"]]["tension_N"])
    return Compared(our_harmonic(), harmonic(sampled(), theirs))


FIGURES = {
    "mean": "mean of the",
    "std": "standard deviation of the",
    "max": "maximum of the",
    "min": "minimum of the",
    "history": "worst difference of the",
}


def _add(motion: str, figure: str, tolerance: float, why: str) -> None:
    case = kept()["chain"][motion]
    heave, surge = (case[way]["amplitude_m"] for way in ("heave", "surge"))
    check(
        f"line-{motion}-{figure}",
        f"{FIGURES[figure]} fairlead tension of a chain under heave of {heave:g} m and surge of {surge:g} m",
        area=AREA,
        unit="N",
        source=f"{MOORDYN}, {FINEST['chain']} segments",
        tolerance=tolerance,
        why=why,
    )(lambda: history("chain", motion) if figure == "history" else compared("chain", motion, figure))


TOUCHING = "nodes that meet the bottom; theirs changes by {} from {} segments"
_add("small", "mean", 3e-4, "nodes at the touchdown, as at rest")
_add("small", "std", 4e-3, "ours changes by 1.5e-3 with half the step, theirs by 1.1e-3")
_add("small", "max", 4e-3, TOUCHING.format("1.6e-2", "40 to 80"))
_add("small", "min", 1e-2, TOUCHING.format("7.6e-3", "80 to 160"))
_add("small", "history", 2.3e-2, TOUCHING.format("2.3e-2", "40 to 160"))
_add("large", "mean", 5e-4, "nodes at the touchdown, as at rest")
_add("large", "std", 1e-2, TOUCHING.format("9.0e-3", "80 to 160"))
_add("large", "max", 5e-3, TOUCHING.format("3.0e-3", "40 to 160"))

"""Checks of ropes over sheaves against runs of Exudyn and MuJoCo, stored with their origin in
`rope_lifts.json`."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from ..scenario import Scenario
from ..simulation.simulate import Simulation
from .models import scenario, settings, slider, value
from .peers import AREA
from .rows import Compared, check, worst

STEP_S = 1e-3
SIDEWAYS = 1.0
"""Velocity across the sheave in the second run of the other engines, m/s."""


@cache
def kept() -> dict[str, Any]:
    """The cases, and the results of the other engines.

    >>> kept()["reeving"]["radius_m"]
    2.0
    """
    return json.loads((Path(__file__).parent / "rope_lifts.json").read_text(encoding="utf-8"))


def _gravity(case: dict[str, Any]) -> dict[str, Any]:
    return {"gravity": {"gravity": {"acceleration_m_s2": case["gravity_m_s2"]}}}


def _upright(place: list[float], *, plane: bool) -> list[float]:
    """Convert a point of the reeving, whose y axis points up, to Kingpost's axes."""
    x, y, z = place
    return [x, 0.0 if plane else -z, y]


def _disc(case: dict[str, Any]) -> dict[str, Any]:
    """Mass and inertia of the reeving's disc, which hangs by its radius below its sheave."""
    radius, thick = case["radius_m"], case["thickness_m"]
    mass = case["density_kg_m3"] * np.pi * radius**2 * thick
    across = mass * (3 * radius**2 + thick**2) / 12
    return {
        "mass_kg": mass,
        "centre_of_mass_m": [0, 0, -radius],
        "inertia": {"tensor": {"moments_kg_m2": [across, mass * radius**2 / 2, across]}},
    }


def reeving(name: str) -> Scenario:
    """The disc in the bight of a rope: in one plane (`plane`), with the sheaves as in Exudyn's test (`skew`),
    or with that test's length of rope, which begins slack (`slack`)."""
    case = kept()["reeving"]
    plane = name not in ("skew", "as_published")
    x, y, z = _upright(case["sheave_m"], plane=plane)
    disc = _disc(case)
    disc["joint"] = {"floating": {"initial": {"position_m": [x, y, z - case["radius_m"]]}}}
    first, last = (
        {"point": {"body": "world", "position_m": _upright(p, plane=plane)}} for p in case["ends_m"]
    )
    rope = {
        "path": [first, {"sheave": {"body": "disc", "radius_m": case["radius_m"], "axis": [0, -1, 0]}}, last],
        "unstretched_length_m": case[name].get("unstretched_length_m", _length(case)),
        "axial_stiffness_N": case["axial_stiffness_N"],
        "damping_time_s": case["damping_time_s"],
    }
    forces = _gravity(case) | {"rope": {"rope": rope}}
    return _scenario({"disc": disc}, forces, case)


def _length(case: dict[str, Any]) -> float:
    """Length of the test's own rope: from centre to centre, and half a turn."""
    middle = np.array(case["sheave_m"])
    legs = sum(float(np.linalg.norm(middle - end)) for end in case["ends_m"])
    return legs + np.pi * case["radius_m"]


def published_norm() -> Compared:
    """The number of Exudyn's test: norm of the move of the disc's sheave and its quaternion's change."""
    case = kept()["reeving"]
    simulation = Simulation(reeving("as_published"))
    simulation.step(round(case["duration_s"] / STEP_S))
    q = simulation.state.q
    w, x, y, z = q[3:7]
    up = np.array([2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)])
    move = q[:3] + case["radius_m"] * up - _upright(case["sheave_m"], plane=False)
    return Compared(float(np.linalg.norm([*move, w - 1, x, y, z])), case["published_norm"])


def lift(sideways: float = 0.0, *, drum: bool = False) -> Scenario:
    """A load on a rope over a fixed sheave; a carriage on a level slide, or a drum, hauls the rope in."""
    case = kept()["lift"]
    velocity = [case["load_velocity_m_s"][0], sideways, 0]
    start = {"position_m": case["load_m"], "velocity_m_s": velocity}
    load = {
        "mass_kg": case["load_kg"],
        "shape": {"sphere": {"radius_m": 0.5}},
        "joint": {"floating": {"hold_rotation": True, "initial": start}},
    }
    if drum:
        hauls, first, pull = _drum(case)
    else:
        hauls = slider(case["carriage_kg"], "x", position_m=case["carriage_m"])
        first, pull = {"point": {"body": "winch"}}, {"linear_motor": {"force_N": -case["pull_N"]}}
    rope = {
        "path": [
            first,
            {"sheave": {"body": "world", "radius_m": case["radius_m"], "axis": [0, 1, 0]}},
            {"point": {"body": "load"}},
        ],
        "unstretched_length_m": case["unstretched_length_m"],
        "axial_stiffness_N": case["axial_stiffness_N"],
        "damping_time_s": case["damping_time_s"],
    }
    forces = _gravity(case) | {"rope": {"rope": rope}}
    drives = {"pull": {kind: {"joint": "winch", **how} for kind, how in pull.items()}}
    return _scenario({"load": load, "winch": hauls}, forces, case, drives=drives)


def _drum(case: dict[str, Any]) -> tuple[dict[str, Any], dict[str, Any], dict[str, Any]]:
    """A drum instead of the carriage: the same inertia and the same pull on the rope."""
    radius = case["drum_radius_m"]
    moment = case["carriage_kg"] * radius**2
    x, y, z = case["carriage_m"]
    body = {
        "mass_kg": 1.0,
        "inertia": {"tensor": {"moments_kg_m2": [moment, moment, moment]}},
        "joint": {"revolute": {"axis": [0, 1, 0], "position_m": [x, y, z - radius]}},
    }
    station = {"drum": {"joint": "winch", "radius_m": radius}}
    return body, station, {"motor": {"torque_N_m": -case["pull_N"] * radius}}


def _scenario(bodies: Any, forces: Any, case: dict[str, Any], **more: Any) -> Scenario:
    simulation = settings(STEP_S, case["duration_s"], integrator="rk4")
    return scenario(bodies, forces, simulation=simulation, **more)


def track(one: Scenario, case: dict[str, Any], moving: str) -> dict[str, np.ndarray]:
    """Tension of the rope, position of a body's centre of mass (3), and turn or travel of the winch, at the
    times of the stored runs."""
    simulation, every, rows = Simulation(one), round(case["every_s"] / STEP_S), []
    winch = "winch" in simulation.coordinates
    for sample in range(round(case["duration_s"] / case["every_s"]) + 1):
        if sample:
            simulation.step(every)
        place = [value(simulation, "position", moving, axis) for axis in "xyz"]
        turned = value(simulation, "joint_position", "winch") if winch else 0.0
        rows.append([value(simulation, "rope_tension", "rope"), *place, turned])
    found = np.array(rows)
    return {"tension": found[:, 0], "place": found[:, 1:4], "winch": found[:, 4]}


@cache
def _ours(name: str) -> dict[str, np.ndarray]:
    """Kingpost's run of a reeving or a lift, by the name of the stored run."""
    if name in kept()["reeving"]:
        return track(reeving(name), kept()["reeving"], "disc")
    sideways = SIDEWAYS if name.endswith("sideways") else 0.0
    return track(lift(sideways, drum=name == "drum"), kept()["lift"], "load")


def _theirs(name: str) -> dict[str, np.ndarray]:
    """Read the other engine's run of a reeving or a lift, by the name of the stored run, in our axes."""
    if name in kept()["reeving"]:
        found = kept()["reeving"][name]
        place = [_upright(one, plane=name != "skew") for one in found["centre_of_mass_m"]]
    else:
        found = kept()["lift"][name]
        place = found["load_m"]
    winch = found.get("drum_rad", found.get("carriage_m", []))
    return {"tension": np.array(found["tension_N"]), "place": np.array(place), "winch": np.array(winch)}


def compared(name: str, quantity: str) -> Compared:
    """Largest difference between Kingpost's run and that of the other engine, over the largest value of the
    other."""
    return worst(_ours(name)[quantity], _theirs(name)[quantity])


def _add(name: str, case: str, quantity: str, what: str, tolerance: float, why: str) -> None:
    engine = "mujoco" if case == "mujoco" else "exudyn"
    check(
        name,
        what,
        area=AREA,
        unit={"tension": "N", "place": "m", "winch": "rad"}[quantity],
        source=f"{SOURCES[engine]}, {kept()[engine]}",
        tolerance=tolerance,
        why=why,
    )(lambda: compared(case, quantity))


SOURCES = {
    "exudyn": "Exudyn's ReevingSystemSprings (Gerstmayr, Multibody Syst. Dyn. 60, 2024, 533)",
    "mujoco": "MuJoCo's spatial tendon over a cylinder (Todorov et al., IROS 2012)",
}
SAME = "one law and RK4 of 1 ms or less in both; ten figures are kept"
FLEET = "our arcs are those of legs in the sheave's plane, up to R phi^2 a leg off where they are not: {}"
LIFT = "of a load of 2 t on a rope over a sheave to a carriage that hauls"

_add("exudyn-reeving", "plane", "tension", "tension of the rope in whose bight a disc falls", 1e-8, SAME)
_add(
    "exudyn-reeving-place", "plane", "place", "position of a disc falling in the bight of a rope", 1e-8, SAME
)
_add(
    "exudyn-reeving-skew",
    "skew",
    "tension",
    "tension of the rope of a falling disc, sheaves 1 m apart out of plane, as in Exudyn's test",
    2.8e-3,
    FLEET.format("10 mm at phi = 0.05, 21 N of 7.6 kN"),
)
_add(
    "exudyn-reeving-slack",
    "slack",
    "tension",
    "tension of the rope of a falling disc, with 0.98 m of slack at first",
    4e-5,
    "theirs comes taut up to two steps late: 20 us of 0.6 s",
)
check(
    "exudyn-reeving-published",
    "norm of the disc's coordinates in Exudyn's own test, after 2 s",
    area=AREA,
    source="runTestSuiteRefSol.py of Exudyn (J. Gerstmayr), 2023-07-17",
    tolerance=1.3e-2,
    why="dampers across and about the legs, which our rope does not have, change theirs by 1.25 %",
)(published_norm)
_add("exudyn-lift", "exudyn", "tension", f"tension {LIFT}", 1e-8, SAME)
_add("exudyn-lift-place", "exudyn", "place", f"place {LIFT}", 1e-8, SAME)
_add("mujoco-lift", "mujoco", "tension", f"tension {LIFT}", 1e-8, SAME)
_add("mujoco-lift-place", "mujoco", "place", f"place {LIFT}", 1e-8, SAME)
_add(
    "exudyn-lift-sideways",
    "exudyn_sideways",
    "place",
    f"position {LIFT}, and that also swings across the sheave",
    1.8e-4,
    FLEET.format("2.7 mm of 15 m at phi = 0.073"),
)
_add(
    "exudyn-lift-drum",
    "drum",
    "winch",
    "turn of a drum that hauls a load of 2 t on a rope over a sheave",
    2.1e-2,
    "theirs winds up strain energy without work: R T^2 / 2 EA = 10 N m turn 2000 kg m^2 by 0.063 rad of 3.1",
)

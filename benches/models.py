"""Measured models, each at one fixed state, written for every engine from the resolved scenario.

All numbers go through Kingpost's reader and the translators of the peer tests, so the engines run the same
model: the paper's free one with load, from ``scenarios/paper.yaml``, chains of several lengths, and the lift
of ``kingpost verify --only peers``: a load on a rope over a sheave, which a carriage hauls in. No peer has a
ship in a sea: ``scenarios/offshore_vessel.yaml`` is measured against its own clock.
"""

from __future__ import annotations

import importlib
import json
import sys
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

REPOSITORY = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(REPOSITORY / "python" / "tests"))

from peers import loads, states, tree  # noqa: E402

PAPER = "paper_free_load"
LIFT = "lift_over_sheave"
OVERRIDES: dict[str, Any] = {"hold_centre": False, "load": True, "motor_1": True, "motor_2": True}
CHAIN_LINKS = (2, 4, 8, 16, 32, 64)
# a ship in a sea of 200 waves, by its kind of hydrostatics
AFLOAT: dict[str, dict[str, Any]] = {
    "linear": {"hydrostatics": "linear"},
    "mesh": {"hydrostatics": "mesh"},
    "pressure": {"hydrostatics": "mesh", "forces.water.hydrodynamics.wave_pressure": True},
}
# repetitions are fewer by this factor
HEAVY = {"pressure": 80}
AFLOAT_STEP_S = 0.05
SEED = 141
STEP_S = 0.001


@dataclass(frozen=True)
class Case:
    """One model at one state: the resolved scenario, its tree, and q and v in Kingpost's layout.

    ``files`` are the files that the scenario reads, ``snapshot`` is Kingpost's own form of the state, for
    the WASM module; ``links`` is the number of links of a chain. A ship in the water has no tree, nor has the
    lift, whose numbers are in ``lift``. ``weight`` reduces the repetitions of a case beyond the effect of its
    number of velocities.
    """

    name: str
    scenario: str
    snapshot: bytes
    q: tree.Array
    v: tree.Array
    tree: tree.Tree | None = None
    links: int = 0
    weight: int = 1
    files: Mapping[str, str] = field(default_factory=dict)
    lift: Mapping[str, Any] | None = None


def paper() -> Case:
    """The paper's model with the ship free and the load on, both motors on, at a seeded random state."""
    import kingpost

    return _case(PAPER, kingpost.load("paper", OVERRIDES | {"simulation.step_s": STEP_S}))


def chain(links: int) -> Case:
    """A free base and rods of 1 m hinged end to end, about y and z in turn, under gravity."""
    from kingpost.scenario import Scenario

    name = chain_name(links)
    return _case(name, Scenario(json.dumps(_chain_scenario(links)), f"{name}.json"), links)


def afloat(kind: str) -> Case:
    """The offshore vessel with its crane at the start of a run in its JONSWAP sea, at equilibrium."""
    import kingpost

    scenario = kingpost.load(
        "offshore_vessel", AFLOAT[kind] | {"waves": True, "simulation.step_s": AFLOAT_STEP_S}
    )
    simulation = kingpost.Simulation(scenario)
    start = {"snapshot": simulation.snapshot(), "q": simulation.state.q, "v": simulation.state.v}
    return Case(afloat_name(kind), scenario.json, **start, weight=HEAVY.get(kind, 1), files=scenario.files)


def lift() -> Case:
    """A load that swings on a rope over a fixed sheave, which a carriage on a level slide hauls in."""
    import kingpost
    from kingpost.verify import ropes

    scenario = ropes.lift()
    simulation = kingpost.Simulation(scenario)
    start = {"snapshot": simulation.snapshot(), "q": simulation.state.q, "v": simulation.state.v}
    return Case(LIFT, scenario.json, **start, lift=ropes.kept()["lift"])


def afloat_name(kind: str) -> str:
    """The model's name in the printed lines."""
    return f"offshore_vessel_{kind}"


def chain_name(links: int) -> str:
    """The model's name in the printed lines."""
    return f"chain_{links}"


def _chain_scenario(links: int) -> dict[str, Any]:
    """The chain as a scenario; the base is no link."""
    base = {"mass_kg": 50.0, "shape": {"box": {"length_m": 1.0, "width_m": 1.0, "height_m": 1.0}}}
    bodies: dict[str, Any] = {"base": {**base, "joint": {"floating": {}}}}
    parent = "base"
    for index in range(links):
        hinge = {
            "axis": [0, 1, 0] if index % 2 == 0 else [0, 0, 1],
            "position_m": [0.5, 0.0, 0.0],
            "child_position_m": [-0.5, 0.0, 0.0],
        }
        rod = {"cylinder": {"radius_m": 0.05, "length_m": 1.0, "axis": "x"}}
        name = f"link_{index + 1}"
        bodies[name] = {"parent": parent, "mass_kg": 10.0, "shape": rod, "joint": {"revolute": hinge}}
        parent = name
    return {
        "version": 1,
        "title": f"Chain of {links} links",
        "simulation": {"integrator": "rk4", "step_s": STEP_S, "duration_s": 1.0, "record_every_s": 0.01},
        "bodies": bodies,
        "forces": {"gravity": {"gravity": {"acceleration_m_s2": 9.80665}}},
    }


def _case(name: str, scenario: Any, links: int = 0) -> Case:
    """A scenario at a random state from the fixed seed."""
    import kingpost

    found = tree.read(scenario.resolved)
    q, v = states.random_state(found, np.random.default_rng(SEED))
    simulation = kingpost.Simulation(scenario)
    simulation.set_state(q, v)
    return Case(name, scenario.json, simulation.snapshot(), q, v, found, links)


def write_kingpost(case: Case, folder: Path) -> Path:
    """Writes scenario (.json, .files.json) and state (.txt, .snapshot); returns the path without ending."""
    path = folder / f"{case.name}_kingpost"
    path.with_suffix(".json").write_text(case.scenario)
    path.with_suffix(".files.json").write_text(json.dumps(dict(case.files)))
    path.with_suffix(".snapshot").write_bytes(case.snapshot)
    force = np.zeros_like(case.v) if case.tree is None else loads.drive_forces(case.tree, case.q, case.v)
    path.with_suffix(".txt").write_text(_lines([("q", case.q), ("v", case.v), ("force", force)]))
    return path


def write_mujoco(case: Case, folder: Path) -> Path:
    """Writes MJCF (.xml) and the state (.txt) and returns the path without ending."""
    if case.lift is not None:
        return _write_mujoco_lift(case, folder)
    peer_module = importlib.import_module("peers.mujoco_peer")
    peer = peer_module.MujocoPeer(case.tree)
    free = case.tree.free()
    force = loads.drive_forces(case.tree, case.q, case.v)[free]
    path = folder / f"{case.name}_mujoco"
    path.with_suffix(".xml").write_text(peer_module.mjcf(case.tree, step_s=STEP_S))
    path.with_suffix(".txt").write_text(
        _lines([("qpos", peer.qpos(case.q)), ("qvel", case.v[free]), ("qfrc", force)])
    )
    return path


def _write_mujoco_lift(case: Case, folder: Path) -> Path:
    """Writes MJCF of the lift: carriage and load on slides from their initial positions."""
    text = importlib.import_module("peers.mujoco_lift").mjcf(case.lift, STEP_S)
    path = folder / f"{case.name}_mujoco"
    path.with_suffix(".xml").write_text(text)
    velocity = [0.0, *case.lift["load_velocity_m_s"]]
    pull = [-case.lift["pull_N"], 0.0, 0.0, 0.0]
    path.with_suffix(".txt").write_text(_lines([("qpos", np.zeros(4)), ("qvel", velocity), ("qfrc", pull)]))
    return path


def mujoco_lift_as_ours(case: Case, values: tree.Array) -> tree.Array:
    """Converts MuJoCo's q and v of the lift to Kingpost's: the load, its held orientation, the carriage."""
    travel, speed = values[0], values[4]
    place = np.array(case.lift["load_m"]) + values[1:4]
    return np.concatenate([place, [1, 0, 0, 0, travel], values[5:8], [0, 0, 0, speed]])


def write_exudyn(case: Case, folder: Path) -> Path:
    """Writes the numbers of the lift as JSON and returns the path."""
    path = folder / f"{case.name}_exudyn.json"
    path.write_text(json.dumps(case.lift))
    return path


def write_pinocchio(case: Case, folder: Path) -> Path:
    """Writes joints, bodies and the state as text lines and returns the path."""
    peer = importlib.import_module("peers.pinocchio_peer").PinocchioPeer(case.tree)
    model = peer.model
    rows: list[tuple[str, Any]] = [("gravity", model.gravity.linear)]
    for index in range(1, model.njoints):
        place, inertia = model.jointPlacements[index], model.inertias[index]
        kind = _KINDS[model.joints[index].shortname()]
        pose = [*place.rotation.ravel(), *place.translation]
        rows.append((f"joint {model.parents[index]} {kind}", pose))
        i = inertia.inertia
        six = [i[0, 0], i[1, 1], i[2, 2], i[0, 1], i[0, 2], i[1, 2]]
        rows.append((f"body {index}", [inertia.mass, *inertia.lever, *six]))
    rows += [("q", peer.configuration(case.q)), ("v", peer.velocity(case.q, case.v))]
    rows.append(("tau", peer.force(case.q, case.v)))
    path = folder / f"{case.name}_pinocchio.txt"
    path.write_text(_lines(rows))
    return path


# by name
CASES: dict[str, Callable[[], Case]] = {
    PAPER: paper,
    **{chain_name(links): partial(chain, links) for links in CHAIN_LINKS},
    LIFT: lift,
    **{afloat_name(kind): partial(afloat, kind) for kind in AFLOAT},
}


_KINDS = {
    "JointModelFreeFlyer": "free_flyer",
    "JointModelRX": "revolute_x",
    "JointModelRY": "revolute_y",
    "JointModelRZ": "revolute_z",
}


def _lines(rows: Iterable[tuple[str, Any]]) -> str:
    """Formats a line of a name and numbers with all digits."""
    return "".join(f"{name} {' '.join(repr(float(x)) for x in numbers)}\n" for name, numbers in rows)


def pinocchio_as_ours(case: Case, values: tree.Array) -> tree.Array:
    """Converts Pinocchio's q and v to Kingpost's: quaternion order, and the base's velocity rotated to world
    axes."""
    q, v = values[: case.tree.q_size].copy(), values[case.tree.q_size :].copy()
    q[3:7] = q[[6, 3, 4, 5]]
    v[:3] = states.rotation_of_quaternion(q[3:7]) @ v[:3]
    return np.concatenate([q, v])


def pinocchio_acceleration_as_ours(case: Case, values: tree.Array) -> tree.Array:
    """Converts Pinocchio's spatial acceleration to Kingpost's."""
    peer = importlib.import_module("peers.pinocchio_peer").PinocchioPeer(case.tree)
    return np.asarray(peer.classical(case.q, case.v, values))

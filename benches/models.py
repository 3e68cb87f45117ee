"""The paper's free model with load at one fixed state, written for every engine from the resolved scenario.

All numbers come from ``scenarios/paper.yaml`` through Kingpost's reader and the translators of the peer
tests, so the engines run the same model.
"""

from __future__ import annotations

import importlib
import sys
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

REPOSITORY = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(REPOSITORY / "python" / "tests"))

from peers import loads, states, tree  # noqa: E402

MODEL = "paper_free_load"
OVERRIDES: dict[str, Any] = {"hold_centre": False, "load": True, "motor_1": True, "motor_2": True}
SEED = 141
STEP_S = 0.001


@dataclass(frozen=True)
class Case:
    """One model at one state: the resolved scenario, its tree, and q and v in Kingpost's layout.

    ``snapshot`` is Kingpost's own form of the state, for the WASM module.
    """

    scenario: str
    snapshot: bytes
    tree: tree.Tree
    q: tree.Array
    v: tree.Array


def make_case() -> Case:
    """The paper's model with the ship free and the load on, both motors on, at a seeded random state."""
    import kingpost

    scenario = kingpost.load("paper", OVERRIDES | {"simulation.step_s": STEP_S})
    found = tree.read(scenario.resolved)
    q, v = states.random_state(found, np.random.default_rng(SEED))
    simulation = kingpost.Simulation(scenario)
    simulation.set_state(q, v)
    return Case(scenario.json, simulation.snapshot(), found, q, v)


def write_kingpost(case: Case, folder: Path) -> Path:
    """Writes the scenario (.json) and the state (.txt, .snapshot); returns the path without ending."""
    path = folder / "kingpost"
    path.with_suffix(".json").write_text(case.scenario)
    path.with_suffix(".snapshot").write_bytes(case.snapshot)
    path.with_suffix(".txt").write_text(_lines([("q", case.q), ("v", case.v)]))
    return path


def write_mujoco(case: Case, folder: Path) -> Path:
    """Writes MJCF (.xml) and the state (.txt) and returns the path without ending."""
    peer_module = importlib.import_module("peers.mujoco_peer")
    peer = peer_module.MujocoPeer(case.tree)
    free = case.tree.free()
    force = loads.drive_forces(case.tree, case.q, case.v)[free]
    path = folder / "mujoco"
    path.with_suffix(".xml").write_text(peer_module.mjcf(case.tree, step_s=STEP_S))
    path.with_suffix(".txt").write_text(
        _lines([("qpos", peer.qpos(case.q)), ("qvel", case.v[free]), ("qfrc", force)])
    )
    return path


def write_pinocchio(case: Case, folder: Path) -> Path:
    """Writes joints, bodies and the state as text lines and returns the path."""
    peer = importlib.import_module("peers.pinocchio_peer").PinocchioPeer(case.tree)
    model = peer.model
    rows: list[tuple[str, Any]] = []
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
    path = folder / "pinocchio.txt"
    path.write_text(_lines(rows))
    return path


_KINDS = {
    "JointModelFreeFlyer": "free_flyer",
    "JointModelRX": "revolute_x",
    "JointModelRY": "revolute_y",
    "JointModelRZ": "revolute_z",
}


def _lines(rows: Iterable[tuple[str, Any]]) -> str:
    """Lines of a name and numbers with every digit."""
    return "".join(f"{name} {' '.join(repr(float(x)) for x in numbers)}\n" for name, numbers in rows)


def pinocchio_as_ours(case: Case, values: tree.Array) -> tree.Array:
    """Kingpost's q and v of Pinocchio's: quaternion order, and the base's velocity turned to the world."""
    q, v = values[: case.tree.q_size].copy(), values[case.tree.q_size :].copy()
    q[3:7] = q[[6, 3, 4, 5]]
    v[:3] = states.rotation_of_quaternion(q[3:7]) @ v[:3]
    return np.concatenate([q, v])


def pinocchio_acceleration_as_ours(case: Case, values: tree.Array) -> tree.Array:
    """Kingpost's acceleration of Pinocchio's spatial one."""
    peer = importlib.import_module("peers.pinocchio_peer").PinocchioPeer(case.tree)
    return np.asarray(peer.classical(case.q, case.v, values))

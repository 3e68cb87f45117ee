"""The paper's model in all its variants, and an artificial tree that uses every feature of the
translators."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import product
from typing import Any

import numpy as np

from peers.states import random_state
from peers.tree import Array, Tree

# relative to the largest entry of the peer's acceleration, m/s^2 and rad/s^2 alike
TOLERANCE = 1e-9
STATES_PER_CASE = 4
# extra generalized force per free coordinate, N or N m, of the order of the paper's motors
EXTRA_FORCE = 1e5

SWITCHES = ("load", "motors", "gravity", "damping", "corner", "hold_centre")
CASES = [dict(zip(SWITCHES, values, strict=True)) for values in product((False, True), repeat=len(SWITCHES))]

# of the floating body's translation and rotation
HOLDS = [(False, False), (True, False), (False, True)]


def name(case: Mapping[str, bool]) -> str:
    """A case by the switches that are on."""
    return "+".join(switch for switch, on in case.items() if on) or "nothing"


def overrides(case: Mapping[str, bool]) -> dict[str, Any]:
    """Overrides of the paper's scenario for a case; damping acts on every coordinate."""
    values: dict[str, Any] = {key: case[key] for key in ("load", "gravity", "damping", "hold_centre")}
    values |= {"motor_1": case["motors"], "motor_2": case["motors"]}
    x, y = (-10.0, -5.0) if case["corner"] else (0.0, 0.0)
    values |= {"crane_x_m": x, "crane_y_m": y}
    if case["damping"]:
        values["forces.damping.viscous_damping.linear_N_s_m"] = [1e4, 2e4, 3e4]
        values["bodies.tower.joint.revolute.damping_N_m_s"] = 5e3
        values["bodies.arm.joint.revolute.damping_N_m_s"] = 7e3
    return values


def states(tree: Tree, case: Mapping[str, bool]) -> Iterator[tuple[Array, Array, Array]]:
    """Seeded random q, v and extra generalized force on the free coordinates."""
    random = np.random.default_rng([2019, *case.values()])
    for _ in range(STATES_PER_CASE):
        q, v = random_state(tree, random)
        extra = random.uniform(-EXTRA_FORCE, EXTRA_FORCE, int(tree.free().sum()))
        yield q, v, extra if case["motors"] else np.zeros_like(extra)


def difference(found: Array, expected: Array) -> float:
    """Largest difference, relative to the largest expected entry."""
    return float(np.abs(found - expected).max() / np.abs(expected).max())


def every_feature(*, hold_translation: bool, hold_rotation: bool) -> dict[str, Any]:
    """A scenario with every joint, shape, inertia, load and drive that the peers take."""
    turned = [0.3, -0.2, 0.5]
    return {
        "version": 1,
        "title": "Every feature that the peers take",
        "simulation": {"integrator": "rk4", "step_s": 0.001, "duration_s": 1.0, "record_every_s": 0.01},
        "bodies": {
            "winch": _body(
                "deck", {"sphere": {"radius_m": 0.8}}, 300.0, "fixed", position=[4, 2, 1.5], turn=turned
            ),
            "deck": {
                "mass_kg": 9000.0,
                "centre_of_mass_m": [0.4, -0.1, 0.2],
                "inertia": {
                    "tensor": {"moments_kg_m2": [8e4, 3e5, 3.2e5], "products_kg_m2": [2e3, -9e3, 4e3]}
                },
                "joint": {
                    "floating": {
                        "hold_translation": hold_translation,
                        "hold_rotation": hold_rotation,
                        "initial": {"position_m": [3, -2, 1], "orientation_rad": turned},
                    }
                },
            },
            "mast": _body(
                "deck",
                {"cylinder": {"radius_m": 0.4, "length_m": 6.0, "axis": "y"}},
                700.0,
                "revolute",
                position=[-4, 1, 1],
                child=[0, -3, 0.1],
                turn=turned,
                axis=[1, 2, -2],
                damping_N_m_s=2e3,
            ),
            "lamp": _body("mast", {"point": {}}, 20.0, "fixed", position=[0, 3, 0.4]),
            "slide": _body(
                "mast",
                {"box": {"length_m": 2.0, "width_m": 1.0, "height_m": 0.5}},
                250.0,
                "prismatic",
                position=[0, 2, 0],
                child=[-1, 0, 0],
                turn=[0, 0.4, 0],
                axis=[3, 0, 4],
                initial_extension_m=0.2,
                damping_N_s_m=800.0,
            ),
            "hook": {
                **_body(
                    "slide", None, 90.0, "revolute", position=[1, 0, 0], child=[0, 0, 0.5], axis=[0, 2, 0]
                ),
                "inertia": {"radii_of_gyration": {"radii_m": [0.3, 0.2, 0.25]}},
            },
        },
        "forces": {
            "gravity": {"gravity": {"enabled": True, "acceleration_m_s2": 9.80665}},
            "deck": _damping("deck"),
            "lamp": _damping("lamp"),
            "winch": _damping("winch"),
        },
        "drives": {
            "turn": {"motor": {"joint": "mast", "torque_N_m": 4e4, "history": "constant"}},
            "push": {"linear_motor": {"joint": "slide", "force_N": -3e3}},
            "steady": {
                "servo": {
                    "joint": "hook",
                    "target_rad": 0.3,
                    "stiffness_N_m_per_rad": 400.0,
                    "damping_N_m_s_per_rad": 60.0,
                    "torque_limit_N_m": 500.0,
                }
            },
        },
    }


def every_joint() -> dict[str, Any]:
    """A scenario with a joint of every kind that moves, springs, rotors and drives on their axes."""
    box = {"box": {"length_m": 2.0, "width_m": 1.0, "height_m": 0.5}}
    spring = {"stiffness_N_m_per_rad": 700.0, "rest_rad": 0.3}
    geared = {"damping_N_m_s": 40.0, "rotor_inertia_kg_m2": 0.05, "gear_ratio": 30.0}
    bodies = {
        "deck": {
            "mass_kg": 5e3,
            "shape": {"box": {"length_m": 20.0, "width_m": 8.0, "height_m": 3.0}},
            "joint": {"floating": {}},
        },
        "post": _body(
            "deck",
            box,
            300.0,
            "revolute",
            position=[1, 2, 1],
            child=[0, 0, -1],
            axis=[0, 0, 1],
            spring=spring,
            **geared,
        ),
        "rod": _body(
            "post",
            box,
            80.0,
            "cylindrical",
            position=[0, 0.5, 1],
            child=[-1, 0.2, 0],
            turn=[0.2, 0.4, -0.1],
            axis=[1, 1, 0],
            rotation={"damping_N_m_s": 30.0},
            translation={
                "spring": {"stiffness_N_per_m": 2e3, "rest_m": 0.5},
                "rotor_inertia_kg_m2": 0.02,
                "gear_ratio_rad_per_m": 40.0,
            },
        ),
        "block": _body(
            "rod",
            box,
            60.0,
            "universal",
            position=[1, 0, 0],
            child=[0.1, 0, 0.6],
            first_axis=[1, 0, 0],
            second_axis=[0, 1, 2],
            first={"spring": spring},
            second=geared,
        ),
        "load": _body(
            "block", box, 200.0, "spherical", position=[0, 0, -0.6], child=[0, 0.1, 1.5], damping_N_m_s=15.0
        ),
        "sledge": _body(
            "deck",
            box,
            90.0,
            "planar",
            position=[-5, 1, 1.5],
            child=[0.3, 0, -0.25],
            turn=[0.1, 0, 0.7],
            normal=[0, 0, 1],
            x_axis=[1, -1, 0],
            x={"damping_N_s_m": 20.0},
            rotation=geared,
        ),
        "flap": _body("sledge", box, 40.0, "prismatic", position=[1, 0, 0], child=[-1, 0, 0], axis=[0, 1, 1]),
    }
    return {
        "version": 1,
        "title": "Every joint",
        "bodies": bodies,
        "forces": {"gravity": {"gravity": {"acceleration_m_s2": 9.80665}}, "load": _damping("load")},
        "drives": {
            "luff": {"motor": {"joint": "block.first", "torque_N_m": 900.0}},
            "push": {"linear_motor": {"joint": "rod.translation", "force_N": -700.0}},
            "slide": {"linear_motor": {"joint": "sledge.y", "force_N": 300.0}},
        },
    }


def _body(
    parent: str,
    shape: dict[str, Any] | None,
    mass: float,
    joint: str,
    *,
    position: list[float],
    child: list[float] | None = None,
    turn: list[float] | None = None,
    **more: Any,
) -> dict[str, Any]:
    """One body's entry, its joint named as the body."""
    where = {
        "position_m": position,
        "child_position_m": child or [0.0, 0.0, 0.0],
        "orientation_rad": turn or [0.0, 0.0, 0.0],
    }
    entry: dict[str, Any] = {"parent": parent, "mass_kg": mass, "joint": {joint: where | more}}
    return entry if shape is None else entry | {"shape": shape}


def _damping(body: str) -> dict[str, Any]:
    """Viscous damping on every axis of a body."""
    value = {"body": body, "linear_N_s_m": [300.0, 200.0, 100.0], "angular_N_m_s": [40.0, 50.0, 60.0]}
    return {"viscous_damping": {"enabled": True, **value}}

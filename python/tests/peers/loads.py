"""Forces and drives of a scenario at time zero, in the terms that every engine takes.

Gravity and joint damping are left to each engine where it has them of its own.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from peers.tree import Array, Tree, UnsupportedByPeersError


def gravity(tree: Tree) -> float:
    """Acceleration of gravity in m/s^2, downwards; zero where it is off."""
    total = 0.0
    for entry in tree.forces.values():
        value = entry.get("gravity")
        if value is not None and value.get("enabled", True):
            total += float(value["acceleration_m_s2"])
    return total


def drive_forces(tree: Tree, q: Array, v: Array) -> Array:
    """Force of the drives per entry of v, in N m or N, at time zero."""
    force = np.zeros(tree.v_size)
    places = {
        body.joint.axis_name(axis): (at_q.start + k, at_v.start + k)
        for body, at_q, at_v in tree.slots()
        for k, axis in enumerate(body.joint.axes)
    }
    for name, entry in tree.drives.items():
        kind, value = next(iter(entry.items()))
        if not value.get("enabled", True):
            continue
        at_q, at_v = places[value["joint"]]
        force[at_v] += _drive_force(name, kind, value, float(q[at_q]), float(v[at_v]))
    return force


def _drive_force(name: str, kind: str, value: dict[str, Any], position: float, rate: float) -> float:
    """Force of one drive at time zero: a pulse and an unmoved lever give none there."""
    if kind in ("motor", "linear_motor"):
        level = float(value["torque_N_m"] if kind == "motor" else value["force_N"])
        return level if (value.get("history") or "constant") == "constant" else 0.0
    if kind == "servo":
        keys = ("target_rad", "stiffness_N_m_per_rad", "damping_N_m_s_per_rad", "torque_limit_N_m")
    elif kind == "linear_servo":
        keys = ("target_m", "stiffness_N_per_m", "damping_N_s_per_m", "force_limit_N")
    else:
        raise UnsupportedByPeersError(f"drive {name}: kind {kind!r}")
    target, stiffness, damping, limit = (float(value[key]) for key in keys)
    return float(np.clip(stiffness * (target - position) - damping * rate, -limit, limit))


def axis_forces(tree: Tree, q: Array, v: Array) -> Array:
    """Force of damping and springs per entry of v, in N m or N."""
    force = np.zeros(tree.v_size)
    for body, at_q, at_v in tree.slots():
        joint = body.joint
        if joint.kind == "spherical":
            force[at_v] = -joint.damping * v[at_v]
        for k, axis in enumerate(joint.axes):
            stretch = q[at_q.start + k] - axis.rest
            force[at_v.start + k] = -axis.damping * v[at_v.start + k] - axis.stiffness * stretch
    return force


def viscous_damping(tree: Tree) -> list[tuple[str, Array, Array]]:
    """Per damped body: its name and its coefficients on body-axes velocity (N s/m) and rate (N m s)."""
    found = []
    for name, entry in tree.forces.items():
        kind, value = next(iter(entry.items()))
        if kind == "gravity" or not value.get("enabled", True):
            continue
        if kind != "viscous_damping":
            raise UnsupportedByPeersError(f"force {name}: kind {kind!r}")
        linear, angular = value.get("linear_N_s_m"), value.get("angular_N_m_s")
        found.append((value["body"], _three(linear), _three(angular)))
    return found


def _three(value: Any) -> Array:
    """Three numbers, or zeros where none are given."""
    return np.zeros(3) if value is None else np.array(value, dtype=np.float64)

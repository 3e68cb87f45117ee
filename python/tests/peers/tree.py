"""A resolved scenario as plain numbers: bodies in a tree, each with its mass, inertia and joint.

Frames: every body's frame sits at its centre of mass with the axes of its drawing frame. Positions are in
metres, inertia in kg m^2 about the centre of mass in body axes. The state has Kingpost's layout: for a
floating joint the world position of the centre of mass (3) and a unit quaternion w x y z in q, the world
velocity (3) and the angular velocity in body axes (3) in v; for a spherical joint a unit quaternion in q and
the angular velocity against the parent in body axes (3) in v; for other joints one entry an axis.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


class UnsupportedByPeersError(ValueError):
    """Error of a scenario with a feature that the peer models do not represent."""


@dataclass(frozen=True)
class Axis:
    """One axis of a joint: turning or sliding, in the frame after the axes before it, and what acts in it.

    Torques in N m and angles in rad, or forces in N and lengths in m; ``rotor_inertia`` has the gear ratio
    squared in it.
    """

    label: str
    turns: bool
    direction: Array
    initial: float = 0.0
    damping: float = 0.0
    stiffness: float = 0.0
    rest: float = 0.0
    rotor_inertia: float = 0.0


@dataclass(frozen=True)
class Joint:
    """Connection of a body to its parent.

    ``rotation`` (child's axes in the parent's at zero) and ``position`` (from the parent's centre of mass)
    place the joint in the parent; ``child_position`` places it in the child, from its centre of mass.
    ``initial_rotation`` and ``damping`` are those of a spherical joint; other joints have axes.
    """

    name: str
    kind: str
    rotation: Array = field(default_factory=lambda: np.eye(3))
    position: Array = field(default_factory=lambda: np.zeros(3))
    child_position: Array = field(default_factory=lambda: np.zeros(3))
    axes: tuple[Axis, ...] = ()
    initial_rotation: Array = field(default_factory=lambda: np.eye(3))
    damping: float = 0.0
    free_translation: bool = True
    free_rotation: bool = True

    @property
    def q_size(self) -> int:
        """Entries of this joint in q."""
        return {"floating": 7, "spherical": 4}.get(self.kind, len(self.axes))

    @property
    def v_size(self) -> int:
        """Entries of this joint in v."""
        return {"floating": 6, "spherical": 3}.get(self.kind, len(self.axes))

    def axis_name(self, axis: Axis) -> str:
        """The name of an axis' coordinate: the joint's where it is the only one."""
        return f"{self.name}.{axis.label}" if axis.label else self.name

    def free(self) -> list[bool]:
        """Which of the joint's entries of v are free."""
        if self.kind == "floating":
            return [self.free_translation] * 3 + [self.free_rotation] * 3
        return [True] * self.v_size


@dataclass(frozen=True)
class Body:
    """A rigid body: mass in kg, inertia in kg m^2 about its centre of mass in body axes."""

    name: str
    parent: str | None
    mass: float
    inertia: Array
    joint: Joint


@dataclass(frozen=True)
class Mount:
    """Where a body sits: pose of its frame in the frame of the moving body that carries it."""

    carrier: str | None
    rotation: Array
    position: Array


@dataclass(frozen=True)
class Tree:
    """Bodies with parents before children, and the scenario's forces and drives as read."""

    bodies: tuple[Body, ...]
    forces: Mapping[str, Any]
    drives: Mapping[str, Any]

    def body(self, name: str) -> Body:
        """The body of that name."""
        return next(body for body in self.bodies if body.name == name)

    def slots(self) -> Iterator[tuple[Body, slice, slice]]:
        """Every body that has coordinates, with its part of q and of v."""
        q, v = 0, 0
        for body in self.bodies:
            joint = body.joint
            if joint.q_size:
                yield body, slice(q, q + joint.q_size), slice(v, v + joint.v_size)
            q, v = q + joint.q_size, v + joint.v_size

    @property
    def q_size(self) -> int:
        """Length of q."""
        return sum(body.joint.q_size for body in self.bodies)

    @property
    def v_size(self) -> int:
        """Length of v, held coordinates included."""
        return sum(body.joint.v_size for body in self.bodies)

    def free(self) -> Array:
        """Mask over v of the free coordinates."""
        return np.array([free for body in self.bodies for free in body.joint.free()], dtype=bool)

    def mount(self, name: str) -> Mount:
        """The pose of a body in the moving body that carries it (itself, unless its joint is fixed)."""
        rotation, position = np.eye(3), np.zeros(3)
        current: str | None = name
        while current is not None:
            body = self.body(current)
            if body.joint.kind != "fixed":
                break
            joint = body.joint
            position = joint.position + joint.rotation @ (position - joint.child_position)
            rotation = joint.rotation @ rotation
            current = body.parent
        return Mount(current, rotation, position)

    def aboard(self, carrier: str) -> list[Body]:
        """The moving body and all bodies that are fixed to it."""
        return [body for body in self.bodies if self.mount(body.name).carrier == carrier]


def read(resolved: str | Mapping[str, Any]) -> Tree:
    """Reads a resolved scenario (JSON text or its object) and leaves out what is disabled."""
    scenario: Mapping[str, Any] = json.loads(resolved) if isinstance(resolved, str) else resolved
    entries = _enabled(scenario["bodies"])
    centres = {name: _vector(entry.get("centre_of_mass_m")) for name, entry in entries.items()}
    bodies = []
    for name, entry in entries.items():
        parent = entry.get("parent")
        parent = None if parent in (None, "world") else parent
        offset = centres[parent] if parent else np.zeros(3)
        joint = _joint(name, entry["joint"], offset, centres[name])
        bodies.append(Body(name, parent, float(entry["mass_kg"]), _inertia(name, entry), joint))
    return Tree(tuple(bodies), scenario.get("forces") or {}, scenario.get("drives") or {})


def _enabled(entries: Mapping[str, Any]) -> dict[str, Any]:
    """Enabled bodies that hang, through enabled bodies, on the world; parents first."""
    kept: dict[str, Any] = {}
    waiting = {name: entry for name, entry in entries.items() if entry.get("enabled", True) is not False}
    while True:
        ready = [n for n, entry in waiting.items() if entry.get("parent") in (None, "world", *kept)]
        if not ready:
            return kept
        kept[ready[0]] = waiting.pop(ready[0])


def _vector(value: Any) -> Array:
    """Three numbers, or zeros where none are given."""
    return np.zeros(3) if value is None else np.array(value, dtype=np.float64)


def rotation_of_angles(angles: Any) -> Array:
    """Rotation matrix of roll, pitch, yaw in radians, intrinsic z-y-x."""
    roll, pitch, yaw = _vector(angles)
    sin, cos = np.sin, np.cos
    about_x = np.array([[1, 0, 0], [0, cos(roll), -sin(roll)], [0, sin(roll), cos(roll)]])
    about_y = np.array([[cos(pitch), 0, sin(pitch)], [0, 1, 0], [-sin(pitch), 0, cos(pitch)]])
    about_z = np.array([[cos(yaw), -sin(yaw), 0], [sin(yaw), cos(yaw), 0], [0, 0, 1]])
    return np.asarray(about_z @ about_y @ about_x)


def _joint(name: str, entry: Mapping[str, Any], parent_centre: Array, child_centre: Array) -> Joint:
    """The joint of one body from its externally tagged entry."""
    kind, value = next(iter(entry.items()))
    value = value or {}
    label = value.get("name") or name
    if kind == "floating":
        initial = value.get("initial") or {}
        return Joint(
            label,
            kind,
            rotation=rotation_of_angles(initial.get("orientation_rad")),
            position=_vector(initial.get("position_m")),
            free_translation=not value.get("hold_translation", False),
            free_rotation=not value.get("hold_rotation", False),
        )
    if value.get("held"):
        raise UnsupportedByPeersError(f"joint {label}: the peer models have free joints, found held")
    return Joint(
        label,
        kind,
        rotation=rotation_of_angles(value.get("orientation_rad")),
        position=_vector(value.get("position_m")) - parent_centre,
        child_position=_vector(value.get("child_position_m")) - child_centre,
        axes=tuple(_axes(label, kind, value)),
        initial_rotation=rotation_of_angles(value.get("initial_orientation_rad")),
        damping=float(value.get("damping_N_m_s") or 0.0) if kind == "spherical" else 0.0,
    )


def _axes(joint: str, kind: str, value: Mapping[str, Any]) -> Iterator[Axis]:
    """The axes of a joint, from the parent to the child."""
    if kind in ("revolute", "prismatic"):
        yield _axis(joint, "", kind == "revolute", value["axis"], value)
    elif kind == "cylindrical":
        yield _axis(joint, "rotation", True, value["axis"], value.get("rotation") or {})
        yield _axis(joint, "translation", False, value["axis"], value.get("translation") or {})
    elif kind == "universal":
        for label in ("first", "second"):
            yield _axis(joint, label, True, value[f"{label}_axis"], value.get(label) or {})
    elif kind == "planar":
        x, normal = _vector(value["x_axis"]), _vector(value["normal"])
        for label, direction in (("x", x), ("y", np.cross(normal, x)), ("rotation", normal)):
            yield _axis(joint, label, label == "rotation", direction, value.get(label) or {})


def _axis(joint: str, label: str, turns: bool, direction: Any, value: Mapping[str, Any]) -> Axis:
    """One axis of a joint from its entry, or from that of a joint of one axis."""
    found = [key for key in ("friction", "limits") if value.get(key)]
    if (value.get("mode") or "free") != "free" or found:
        what = found[0] if found else value["mode"]
        raise UnsupportedByPeersError(f"joint {joint}: the peer models have free joints, found {what!r}")
    spring = value.get("spring") or {}
    gear = float(value.get("gear_ratio" if turns else "gear_ratio_rad_per_m") or 1.0)
    return Axis(
        label,
        turns,
        _vector(direction) / float(np.linalg.norm(_vector(direction))),
        initial=float(value.get("initial_angle_rad" if turns else "initial_extension_m") or 0.0),
        damping=float(value.get("damping_N_m_s" if turns else "damping_N_s_m") or 0.0),
        stiffness=float(spring.get("stiffness_N_m_per_rad" if turns else "stiffness_N_per_m") or 0.0),
        rest=float(spring.get("rest_rad" if turns else "rest_m") or 0.0),
        rotor_inertia=float(value.get("rotor_inertia_kg_m2") or 0.0) * gear**2,
    )


def _inertia(name: str, entry: Mapping[str, Any]) -> Array:
    """Inertia about the centre of mass in body axes: given, or that of the solid shape."""
    mass = float(entry["mass_kg"])
    given = entry.get("inertia")
    if given:
        kind, value = next(iter(given.items()))
        if kind == "tensor":
            tensor = np.diag(_vector(value["moments_kg_m2"]))
            xy, xz, yz = _vector(value.get("products_kg_m2"))
            return np.asarray(tensor + np.array([[0, xy, xz], [xy, 0, yz], [xz, yz, 0]]))
        if kind == "radii_of_gyration":
            return np.diag(mass * _vector(value["radii_m"]) ** 2)
        raise UnsupportedByPeersError(f"body {name}: inertia {kind!r}")
    shape, size = next(iter(entry["shape"].items()))
    if shape == "point":
        return np.zeros((3, 3))
    if shape == "sphere":
        return np.eye(3) * (0.4 * mass * size["radius_m"] ** 2)
    if shape == "box":
        squares = np.array([size["length_m"], size["width_m"], size["height_m"]]) ** 2
        return np.diag(mass / 12.0 * (squares.sum() - squares))
    if shape == "cylinder":
        along = "xyz".index(size.get("axis") or "z")
        radius, length = size["radius_m"], size["length_m"]
        moments = np.full(3, mass * (3.0 * radius**2 + length**2) / 12.0)
        moments[along] = mass * radius**2 / 2.0
        return np.diag(moments)
    raise UnsupportedByPeersError(f"body {name}: shape {shape!r}")

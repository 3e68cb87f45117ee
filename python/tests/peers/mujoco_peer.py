"""The tree as a MuJoCo model, and its accelerations in Kingpost's coordinates.

A body's frame sits at its joint (a floating body's at its own centre of mass), so MuJoCo's free joint has
Kingpost's coordinates as they are: world velocity of the centre of mass and angular velocity in body axes.
Bodies that are fixed together become one inertia, since MuJoCo wants a positive one for every moving body.
A held translation is a ball joint, a held rotation three slides, both a body welded to the world.
"""

from __future__ import annotations

from typing import Any
from xml.etree import ElementTree

import mujoco
import numpy as np

from peers import loads
from peers.states import quaternion_of_rotation
from peers.tree import Array, Body, Tree, UnsupportedByPeersError


def mjcf(tree: Tree, *, step_s: float = 0.001) -> str:
    """The model as MJCF text: no contacts, no constraints, RK4, every number in full."""
    root = ElementTree.Element("mujoco", model="kingpost peer")
    ElementTree.SubElement(
        root, "compiler", angle="radian", inertiafromgeom="false", boundmass="0", boundinertia="0"
    )
    option = ElementTree.SubElement(
        root,
        "option",
        integrator="RK4",
        timestep=repr(step_s),
        gravity=_numbers([0.0, 0.0, -loads.gravity(tree)]),
    )
    off = ("constraint", "contact", "equality", "frictionloss", "limit", "warmstart", "actuation", "sensor")
    ElementTree.SubElement(option, "flag", dict.fromkeys(off, "disable"))
    world = ElementTree.SubElement(root, "worldbody")
    elements: dict[str | None, Any] = {None: world}
    origins: dict[str, Array] = {}
    for body in tree.bodies:
        if body.joint.kind != "fixed":
            _add_body(tree, body, elements, origins)
    return ElementTree.tostring(root, encoding="unicode")


def _add_body(tree: Tree, body: Body, elements: dict[str | None, Any], origins: dict[str, Array]) -> None:
    """Adds one moving body; ``origins`` is the MuJoCo frame's place from the body's centre of mass."""
    joint = body.joint
    origins[body.name] = np.zeros(3) if joint.kind == "floating" else joint.child_position
    parent, rotation, position = None, joint.rotation, joint.position
    if body.parent is not None:
        mount = tree.mount(body.parent)
        parent = mount.carrier
        rotation = mount.rotation @ rotation
        position = mount.position + mount.rotation @ position
        if parent is not None:
            position = position - origins[parent]
    if joint.kind == "floating" and joint.free_rotation:
        rotation = np.eye(3)
    pose = {"pos": _numbers(position), "quat": _numbers(quaternion_of_rotation(rotation))}
    element = ElementTree.SubElement(elements[parent], "body", {"name": body.name, **pose})
    elements[body.name] = element
    _add_joints(element, body)
    mass, centre, inertia = fused_inertia(tree, body)
    moments, axes = np.linalg.eigh(inertia)
    if np.count_nonzero(inertia - np.diag(np.diag(inertia))) == 0:
        moments, axes = np.diag(inertia), np.eye(3)
    if mass <= 0.0 or moments.min() <= 0.0:
        raise UnsupportedByPeersError(f"body {body.name}: MuJoCo needs a positive mass and inertia")
    if np.linalg.det(axes) < 0.0:
        axes = axes * np.array([1.0, 1.0, -1.0])
    ElementTree.SubElement(
        element,
        "inertial",
        mass=repr(mass),
        pos=_numbers(centre - origins[body.name]),
        quat=_numbers(quaternion_of_rotation(axes)),
        diaginertia=_numbers(moments),
    )


def _add_joints(element: Any, body: Body) -> None:
    """The MuJoCo joints of one body."""
    joint = body.joint
    if joint.kind == "spherical":
        ElementTree.SubElement(element, "joint", name=joint.name, type="ball", damping=repr(joint.damping))
    elif joint.kind != "floating":
        # a body's joints act one after another, each axis in the frame that those before it have turned
        for axis in joint.axes:
            attributes = {
                "name": joint.axis_name(axis),
                "type": "hinge" if axis.turns else "slide",
                "axis": _numbers(axis.direction),
                "damping": repr(axis.damping),
                "stiffness": repr(axis.stiffness),
                "springref": repr(axis.rest),
                "armature": repr(axis.rotor_inertia),
            }
            ElementTree.SubElement(element, "joint", attributes)
    elif joint.free_translation and joint.free_rotation:
        ElementTree.SubElement(element, "freejoint", name=joint.name)
    elif joint.free_rotation:
        ElementTree.SubElement(element, "joint", name=joint.name, type="ball")
    elif joint.free_translation:
        for index, axis in enumerate("xyz"):
            # slides turn with the body in MJCF, so their axes are the world's seen from the body
            direction = _numbers(joint.rotation.T[:, index])
            attributes = {"name": f"{joint.name}_{axis}", "type": "slide", "axis": direction}
            ElementTree.SubElement(element, "joint", attributes)


def fused_inertia(tree: Tree, body: Body) -> tuple[float, Array, Array]:
    """Mass, centre of mass (from the body's own) and inertia about it of all that is fixed together."""
    parts = [(part, tree.mount(part.name)) for part in tree.aboard(body.name)]
    mass = sum(part.mass for part, _ in parts)
    centre = sum((part.mass * mount.position for part, mount in parts), np.zeros(3)) / mass
    inertia = np.zeros((3, 3))
    for part, mount in parts:
        r = mount.position - centre
        turned = mount.rotation @ part.inertia @ mount.rotation.T
        inertia += turned + part.mass * (float(r @ r) * np.eye(3) - np.outer(r, r))
    return mass, centre, (inertia + inertia.T) / 2.0


def _numbers(values: Any) -> str:
    """Numbers for MJCF with every digit."""
    return " ".join(repr(float(value)) for value in values)


class MujocoPeer:
    """Accelerations by MuJoCo's forward dynamics (``mj_forward``)."""

    def __init__(self, tree: Tree) -> None:
        """Builds the model. Raises ``UnsupportedByPeersError`` for what MuJoCo cannot represent."""
        self.tree = tree
        self.model = mujoco.MjModel.from_xml_string(mjcf(tree))
        self.data = mujoco.MjData(self.model)

    def qpos(self, q: Array) -> Array:
        """MuJoCo's qpos of Kingpost's q."""
        parts = []
        for body, at, _ in self.tree.slots():
            joint, own = body.joint, q[at]
            if joint.kind != "floating":
                parts.append(own)
                continue
            if joint.free_translation:
                parts.append(own[:3] if joint.free_rotation else own[:3] - joint.position)
            if joint.free_rotation:
                parts.append(own[3:])
        return np.concatenate(parts)

    def acceleration(self, q: Array, v: Array, extra: Array | None = None) -> Array:
        """Derivative of the free entries of v under the scenario's loads, in m/s^2 and rad/s^2.

        ``extra`` adds a generalized force per free entry of v, in N or N m.
        """
        model, data, free = self.model, self.data, self.tree.free()
        mujoco.mj_resetData(model, data)
        data.qpos[:] = self.qpos(q)
        data.qvel[:] = v[free]
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        data.qfrc_applied[:] = loads.drive_forces(self.tree, q, v)[free]
        if extra is not None:
            data.qfrc_applied[:] += extra
        for name, linear, angular in loads.viscous_damping(self.tree):
            data.qfrc_applied[:] += self._damping_force(name, linear, angular)
        mujoco.mj_forward(model, data)
        return np.array(data.qacc)

    def _damping_force(self, name: str, linear: Array, angular: Array) -> Array:
        """Generalized force of viscous damping on one body, through its Jacobian."""
        model, data, mount = self.model, self.data, self.tree.mount(name)
        carrier = self.tree.body(mount.carrier) if mount.carrier else None
        if carrier is None:
            return np.zeros(model.nv)
        index = model.body(carrier.name).id
        turn = data.xmat[index].reshape(3, 3)
        origin = np.zeros(3) if carrier.joint.kind == "floating" else carrier.joint.child_position
        point = data.xpos[index] + turn @ (mount.position - origin)
        translation, rotation = np.zeros((3, model.nv)), np.zeros((3, model.nv))
        mujoco.mj_jac(model, data, translation, rotation, point, index)
        axes = turn @ mount.rotation
        force = -axes @ (linear * (axes.T @ (translation @ data.qvel)))
        moment = -axes @ (angular * (axes.T @ (rotation @ data.qvel)))
        return np.asarray(translation.T @ force + rotation.T @ moment)

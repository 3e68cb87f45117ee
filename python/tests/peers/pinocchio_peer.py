"""The tree as a Pinocchio model, and its accelerations in Kingpost's coordinates.

A joint's frame has the child's axes and sits at the joint (a floating body's at its centre of mass). Fixed
bodies are appended one by one and summed by Pinocchio itself. Its free-flyer has the linear velocity in
body axes, the quaternion as x y z w, and a spatial acceleration: with R the rotation, u the body-axes
velocity and w the angular velocity, the derivative of the world velocity is R (u' + w x u).
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pinocchio

from peers import loads
from peers.states import rotation_of_quaternion
from peers.tree import Array, Axis, Joint, Tree, UnsupportedByPeersError


def build(tree: Tree) -> tuple[Any, dict[str, int]]:
    """The Pinocchio model and the joint index of every moving body."""
    model = pinocchio.Model()
    model.gravity.linear = np.array([0.0, 0.0, -loads.gravity(tree)])
    joints: dict[str | None, int] = {None: 0}
    for body in tree.bodies:
        joint = body.joint
        if joint.kind != "fixed":
            joints[body.name] = _add_joint(model, tree, body.parent, joint, joints)
        mount = tree.mount(body.name)
        placement = pinocchio.SE3(mount.rotation, mount.position - origin(tree, mount.carrier))
        inertia = pinocchio.Inertia(body.mass, np.zeros(3), body.inertia)
        model.appendBodyToJoint(joints[mount.carrier], inertia, placement)
    return model, {name: index for name, index in joints.items() if name is not None}


def origin(tree: Tree, carrier: str | None) -> Array:
    """Place of a moving body's joint frame from its centre of mass, in body axes."""
    if carrier is None or tree.body(carrier).joint.kind == "floating":
        return np.zeros(3)
    return tree.body(carrier).joint.child_position


def _add_joint(
    model: Any, tree: Tree, parent: str | None, joint: Joint, joints: dict[str | None, int]
) -> int:
    """Adds one joint to its parent and returns its index."""
    rotation, position, carrier = joint.rotation, joint.position, None
    if parent is not None:
        mount = tree.mount(parent)
        carrier = mount.carrier
        rotation = mount.rotation @ rotation
        position = mount.position + mount.rotation @ position - origin(tree, carrier)
    if joint.kind == "floating":
        if joint.free_translation:
            position = np.zeros(3)
        if joint.free_rotation:
            rotation = np.eye(3)
    placement = pinocchio.SE3(rotation, position)
    index = int(model.addJoint(joints[carrier], joint_model(joint), placement, joint.name))
    start = model.joints[index].idx_v
    for k, axis in enumerate(joint.axes):
        model.armature[start + k] = axis.rotor_inertia
    return index


def joint_model(joint: Joint) -> Any:
    """The Pinocchio joint of one of ours; aligned forms where the axis is a coordinate axis."""
    if joint.kind == "floating":
        if joint.free_rotation:
            kind = "FreeFlyer" if joint.free_translation else "Spherical"
            return getattr(pinocchio, f"JointModel{kind}")()
        if joint.free_translation:
            return pinocchio.JointModelTranslation()
        raise UnsupportedByPeersError(f"joint {joint.name}: a floating joint with nothing free")
    if joint.kind == "spherical":
        return pinocchio.JointModelSpherical()
    if len(joint.axes) == 1:
        return _axis_model(joint.axes[0])
    composite = pinocchio.JointModelComposite()
    for axis in joint.axes:
        composite.addJoint(_axis_model(axis))
    return composite


def _axis_model(axis: Axis) -> Any:
    """The Pinocchio joint of one axis; aligned forms where it is a coordinate axis."""
    aligned = np.flatnonzero(axis.direction == 1.0)
    if aligned.size:
        return getattr(pinocchio, f"JointModel{'R' if axis.turns else 'P'}{'XYZ'[aligned[0]]}")()
    name = "Revolute" if axis.turns else "Prismatic"
    return getattr(pinocchio, f"JointModel{name}Unaligned")(axis.direction)


class PinocchioPeer:
    """Accelerations by Pinocchio's articulated body algorithm (``aba``)."""

    def __init__(self, tree: Tree) -> None:
        """Builds the model."""
        self.tree = tree
        self.model, self.joints = build(tree)
        self.data = self.model.createData()

    def configuration(self, q: Array) -> Array:
        """Pinocchio's q of Kingpost's."""
        result = np.zeros(self.model.nq)
        for body, at, _ in self.tree.slots():
            joint, own = body.joint, q[at]
            if joint.kind == "floating":
                place = joint.rotation.T @ own[:3] if not joint.free_rotation else own[:3]
                turn = own[[4, 5, 6, 3]]
                own = np.concatenate(
                    [place if joint.free_translation else [], turn if joint.free_rotation else []]
                )
            elif joint.kind == "spherical":
                own = own[[1, 2, 3, 0]]
            start = self.model.joints[self.joints[body.name]].idx_q
            result[start : start + own.size] = own
        return result

    def velocity(self, q: Array, v: Array) -> Array:
        """Pinocchio's v of Kingpost's: the linear velocity of a floating body turned to body axes."""
        result = v.copy()
        for body, at_q, at_v in self.tree.slots():
            if body.joint.kind == "floating":
                turn = rotation_of_quaternion(q[at_q][3:])
                result[at_v.start : at_v.start + 3] = turn.T @ v[at_v][:3]
        return np.asarray(result[self.tree.free()])

    def force(self, q: Array, v: Array, extra: Array | None = None) -> Array:
        """Drives, damping and ``extra`` as a generalized force in Pinocchio's coordinates.

        ``extra`` is per free entry of Kingpost's v, in N or N m.
        """
        own_q, own_v = self.configuration(q), self.velocity(q, v)
        force = loads.drive_forces(self.tree, q, v)
        if extra is not None:
            force[self.tree.free()] += extra
        force += loads.axis_forces(self.tree, q, v)
        # power is the same in both coordinates, so forces turn as velocities do
        total = self.velocity(q, force)
        pinocchio.computeJointJacobians(self.model, self.data, own_q)
        for name, linear, angular in loads.viscous_damping(self.tree):
            mount = self.tree.mount(name)
            if mount.carrier is None:
                continue
            place = pinocchio.SE3(mount.rotation, mount.position - origin(self.tree, mount.carrier))
            joint = self.joints[mount.carrier]
            local = pinocchio.getJointJacobian(self.model, self.data, joint, pinocchio.LOCAL)
            jacobian = place.actInv(pinocchio.SE3.Identity()).action @ local
            total -= jacobian.T @ (np.concatenate([linear, angular]) * (jacobian @ own_v))
        return np.asarray(total)

    def acceleration(self, q: Array, v: Array, extra: Array | None = None) -> Array:
        """Derivative of the free entries of v under the scenario's loads, in m/s^2 and rad/s^2.

        ``extra`` adds a generalized force per free entry of v, in N or N m.
        """
        own_q, own_v, force = self.configuration(q), self.velocity(q, v), self.force(q, v, extra)
        spatial = pinocchio.aba(self.model, self.data, own_q, own_v, force)
        return self.classical(q, v, spatial)

    def classical(self, q: Array, v: Array, spatial: Array) -> Array:
        """Derivative of Kingpost's v of Pinocchio's acceleration."""
        result = np.zeros(self.tree.v_size)
        result[self.tree.free()] = spatial
        for body, at_q, at_v in self.tree.slots():
            if body.joint.kind == "floating" and body.joint.free_translation:
                turn = rotation_of_quaternion(q[at_q][3:])
                own, linear = v[at_v], result[at_v][:3]
                carried = np.cross(own[3:], turn.T @ own[:3])
                result[at_v.start : at_v.start + 3] = turn @ (linear + carried)
        return np.asarray(result[self.tree.free()])

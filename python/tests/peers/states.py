"""Seeded random states of a tree, in Kingpost's layout of q and v."""

from __future__ import annotations

import numpy as np
from numpy.random import Generator

from peers.tree import Array, Tree

POSITION_M = 10.0
VELOCITY_M_S = 2.0
ANGULAR_VELOCITY_RAD_S = 1.0
JOINT_RATE_RAD_S = 2.0


def quaternion_of_rotation(rotation: Array) -> Array:
    """Unit quaternion w x y z of a rotation matrix (its eigenvector form, safe at every angle)."""
    r = rotation
    table = np.array(
        [
            [r[0, 0] + r[1, 1] + r[2, 2], r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]],
            [0.0, r[0, 0] - r[1, 1] - r[2, 2], r[0, 1] + r[1, 0], r[0, 2] + r[2, 0]],
            [0.0, 0.0, r[1, 1] - r[0, 0] - r[2, 2], r[1, 2] + r[2, 1]],
            [0.0, 0.0, 0.0, r[2, 2] - r[0, 0] - r[1, 1]],
        ]
    )
    values, vectors = np.linalg.eigh(table, UPLO="U")
    quaternion = vectors[:, int(np.argmax(values))]
    return np.asarray(quaternion if quaternion[0] >= 0.0 else -quaternion)


def rotation_of_quaternion(quaternion: Array) -> Array:
    """Rotation matrix of a unit quaternion w x y z."""
    w, x, y, z = quaternion
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def at_rest(tree: Tree) -> tuple[Array, Array]:
    """q and v of the scenario's first instant, with every rate zero."""
    q, v = np.zeros(tree.q_size), np.zeros(tree.v_size)
    for body, at_q, _ in tree.slots():
        joint = body.joint
        if joint.kind == "floating":
            q[at_q] = np.concatenate([joint.position, quaternion_of_rotation(joint.rotation)])
        elif joint.kind == "spherical":
            q[at_q] = quaternion_of_rotation(joint.initial_rotation)
        else:
            q[at_q] = [axis.initial for axis in joint.axes]
    return q, v


def random_state(tree: Tree, random: Generator) -> tuple[Array, Array]:
    """Uniform random q and v; held coordinates stay where the scenario has them, at rest.

    The orientation is uniform over all rotations; a joint's angle (or extension, in m) is within +-pi.
    """
    q, v = at_rest(tree)
    for body, at_q, at_v in tree.slots():
        joint = body.joint
        if joint.kind == "spherical":
            quaternion = random.standard_normal(4)
            q[at_q] = quaternion / np.linalg.norm(quaternion)
            v[at_v] = random.uniform(-JOINT_RATE_RAD_S, JOINT_RATE_RAD_S, 3)
            continue
        if joint.kind != "floating":
            q[at_q] = random.uniform(-np.pi, np.pi, joint.q_size)
            v[at_v] = random.uniform(-JOINT_RATE_RAD_S, JOINT_RATE_RAD_S, joint.v_size)
            continue
        if joint.free_translation:
            q[at_q.start : at_q.start + 3] = random.uniform(-POSITION_M, POSITION_M, 3)
            v[at_v.start : at_v.start + 3] = random.uniform(-VELOCITY_M_S, VELOCITY_M_S, 3)
        if joint.free_rotation:
            quaternion = random.standard_normal(4)
            q[at_q.start + 3 : at_q.stop] = quaternion / np.linalg.norm(quaternion)
            rates = random.uniform(-ANGULAR_VELOCITY_RAD_S, ANGULAR_VELOCITY_RAD_S, 3)
            v[at_v.start + 3 : at_v.stop] = rates
    return q, v

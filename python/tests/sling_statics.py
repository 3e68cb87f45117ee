"""Statics of a load on sling legs by an independent stiffness matrix."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

G = 9.80665
DOWN = np.array([0.0, 0.0, -1.0])


def cross(a: np.ndarray) -> np.ndarray:
    """The matrix of the product a x b."""
    x, y, z = a
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def turned(by: np.ndarray) -> np.ndarray:
    """Rotation by a vector: its axis, its length the angle (Rodrigues)."""
    angle = np.linalg.norm(by)
    if angle == 0:
        return np.eye(3)
    axis = cross(by / angle)
    return np.eye(3) + np.sin(angle) * axis + (1 - np.cos(angle)) * axis @ axis


def leg_tensions(
    padeyes: Sequence[Sequence[float]],
    lengths: Sequence[float],
    axial_stiffness: float,
    mass_kg: float,
    centre: Sequence[float] = (0, 0, 0),
    *,
    below_m: float,
) -> np.ndarray:
    """Tensions, N, of elastic legs without mass from one point to the padeyes of a rigid load at rest.

    The load has six unknowns: small shifts of its centre of gravity and a small turn. Each leg is a
    tension-only spring k = EA / L: its stiffness is k along it, and tension over length across it. Newton's
    iteration over the stiffness matrix of all legs begins with the load level, its middle `below_m` under the
    point. Turning about the vertical has no stiffness; least squares leave it where it is.
    """
    arms = np.array(padeyes, float) - centre
    k = axial_stiffness / np.array(lengths, float)
    place, turn = np.array(centre, float) + below_m * DOWN, np.eye(3)
    weight = mass_kg * G
    for _ in range(200):
        rest, stiffness = np.zeros(6), np.zeros((6, 6))
        rest[:3] = weight * DOWN
        tensions = []
        for arm, leg_k, length in zip(arms @ turn.T, k, lengths, strict=True):
            way = -place - arm
            path = np.linalg.norm(way)
            along = way / path
            tension = leg_k * max(path - length, 0)
            tensions.append(tension)
            if tension == 0:
                continue
            outer = np.outer(along, along)
            spring = leg_k * outer + tension / path * (np.eye(3) - outer)
            moves = np.hstack([np.eye(3), -cross(arm)])
            force = tension * along
            rest += np.concatenate([force, cross(arm) @ force])
            stiffness += moves.T @ spring @ moves
            # The lever arm rotates with the load, the force keeps its direction.
            stiffness[3:, 3:] -= cross(force) @ cross(arm)
        if np.abs(rest).max() < 1e-9 * weight:
            return np.array(tensions)
        step = np.linalg.lstsq(stiffness, rest, rcond=1e-12)[0]
        step *= min(1, 0.02 / np.abs(step).max())
        place = place + step[:3]
        turn = turned(step[3:]) @ turn
    raise AssertionError("no equilibrium")

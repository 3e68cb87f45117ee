"""Second-order changes of the submerged part of a moving hull."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .surface import particulars
from .waterline import waterline

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .database import Waterplane
    from .flow import WettedHull

    Motions = NDArray[np.complex128]


def mean(a: NDArray, b: NDArray) -> NDArray[np.float64]:
    """Mean of a product of two oscillations with exp(-i w t), from their complex amplitudes.

    >>> mean(np.array(2j), np.array(3j)).item()
    3.0
    """
    return (a * np.conj(b)).real / 2


def displacement(motions: Motions, arms: NDArray[np.float64]) -> NDArray[np.complex128]:
    """First-order displacement of points of a hull, shape (directions, points, 3)."""
    return motions[:, None, :3] + np.cross(motions[:, None, 3:], arms)


def moment_arms(points: NDArray[np.float64], reference: NDArray[np.float64]) -> NDArray[np.float64]:
    """f = 1, y, -x at points, from the reference point, shape (points, 3): heave force, roll and pitch moment
    of a vertical force."""
    x, y, _ = (points - reference).T
    return np.stack([np.ones_like(x), y, -x], axis=1)


def submerged_moments(hull: WettedHull, motions: Motions) -> NDArray[np.float64]:
    """Second-order means of Int f dV over the part of the moving hull below z = 0, shape (directions, 3).

    f = 1, y, -x are fixed in space and start from the hull's reference point at rest. The hull turns by yaw,
    then pitch, then roll about its own axes, R = R_z R_y R_x. Besides the turned volume, the terms are: the
    slice of the thickness h = -X_z between the plane z = 0 and the hull's water plane, shifted by the
    displacement X; a slice of (roll^2 + pitch^2) / 2 times the height of the water plane over the reference
    point; and (1/2) Int f s h^2 dl along the water line, where s is the flare.
    """
    found = particulars(hull.panels.surface)
    reference = hull.reference_m
    _, _, heave, roll, pitch, yaw = motions.T
    x, y, z = found.centre_of_buoyancy_m - reference
    turned_x = -(mean(yaw, yaw) + mean(pitch, pitch)) / 2 * x + mean(pitch, roll) * y + mean(yaw, roll) * z
    turned_y = -(mean(yaw, yaw) + mean(roll, roll)) / 2 * y + mean(pitch, yaw) * z
    moments = _plane_moments(found.waterplane, reference[:2])
    up = -reference[2]
    h = np.stack([-heave, pitch, -roll])
    zero = np.zeros_like(yaw)
    along = np.stack([motions[:, 0] + pitch * up, zero, -yaw])
    across = np.stack([motions[:, 1] - roll * up, yaw, zero])
    slices = [np.einsum("ij,ijd->d", moments, mean(h[:, None], aside[None])) for aside in (across, along)]
    total = np.stack(
        [0 * turned_x, found.volume_m3 * turned_y + slices[0], -found.volume_m3 * turned_x - slices[1]],
        axis=1,
    )
    tilted = (mean(roll, roll) + mean(pitch, pitch)) / 2 * up
    total += tilted[:, None] * np.array([moments[0, 0], moments[0, 2], -moments[0, 1]])
    # Two points on each piece: the integrand is cubic along it.
    points, flare = waterline(hull.panels).points(2)
    rise = displacement(motions, points.at_m - reference)[..., 2]
    return total + mean(rise, rise) * (flare * points.weights / 2) @ moment_arms(points.at_m, reference)


def _plane_moments(plane: Waterplane, origin: NDArray[np.float64]) -> NDArray[np.float64]:
    """Int u u^T dA over the water plane with u = (1, x, y), from an origin."""
    (sx, sy), (xx, xy, yy) = plane.first_moments_m3, plane.second_moments_m4
    about = np.array([[plane.area_m2, sx, sy], [sx, xx, xy], [sy, xy, yy]])
    shift = np.eye(3)
    shift[1:, 0] = -origin
    return shift @ about @ shift.T

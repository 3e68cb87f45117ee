"""Attitude of an inclined hull: heel, trim, and the height of its origin.

The axes of its coefficients are level: x forward along its heading, y to port, z up. Their origin is on the
water plane, vertically above or below the origin of the upright hull. In these axes a point r of the upright
hull is at R r + (0, 0, h) with R = Ry(pitch) Rx(roll): heel to starboard and trim by the bow are positive.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..errors import HydrodynamicsError
from .database import Attitude
from .surface import Surface

if TYPE_CHECKING:
    from numpy.typing import NDArray

BEYOND_DEG = 90.0
"""Bound of heel and trim in either direction: below it the deck is above the keel and the heading is
defined."""
ROUNDS = 100


@dataclass(frozen=True)
class Inclination:
    """The requested attitude of a hull.

    Attributes
    ----------
    roll_rad, pitch_rad
        Heel to starboard and trim by the bow, rad.
    height_m
        Height of the hull's origin above the water, m; `None`: the height at which it has the displacement of
        the upright hull.
    source
        Source of the attitude, for the provenance.
    displaced_m3
        Displaced volume according to that source, m3; `None` if it gives none.
    remarks
        Further notes for the user.
    """

    roll_rad: float
    pitch_rad: float
    height_m: float | None = None
    source: str = "at the upright hull's displacement"
    displaced_m3: float | None = None
    remarks: tuple[str, ...] = ()


def from_degrees(heel_deg: float | None, trim_deg: float | None) -> Inclination | None:
    """An attitude from its angles, deg; `None` for an upright hull.

    Raises
    ------
    HydrodynamicsError
        If an angle is not a number between -90 and 90.

    >>> from_degrees(-90 / np.pi, None).roll_rad, from_degrees(0, None)
    (-0.5, None)
    """
    angles = {"--heel-deg": heel_deg or 0.0, "--trim-deg": trim_deg or 0.0}
    for name, angle in angles.items():
        # NaN compares as false.
        if not abs(angle) < BEYOND_DEG:
            allowed = f"an angle between {-BEYOND_DEG:g} and {BEYOND_DEG:g} deg"
            raise HydrodynamicsError(name, f"{angle:g}", allowed)
    roll, pitch = (math.radians(angle) for angle in angles.values())
    return Inclination(roll, pitch) if roll or pitch else None


def rotation(roll_rad: float, pitch_rad: float) -> NDArray[np.float64]:
    """R = Ry(pitch) Rx(roll), from the axes of the upright hull to the level ones.

    >>> (rotation(np.radians(90), 0) @ [0, 1, 0]).round(9).tolist()   # the port side is up
    [0.0, 0.0, 1.0]
    >>> (rotation(0, np.radians(30)) @ [1, 0, 0]).round(3).tolist()   # the bow is down
    [0.866, 0.0, -0.5]
    """
    cos, sin = np.cos([roll_rad, pitch_rad]), np.sin([roll_rad, pitch_rad])
    about_x = np.array([[1, 0, 0], [0, cos[0], -sin[0]], [0, sin[0], cos[0]]])
    about_y = np.array([[cos[1], 0, sin[1]], [0, 1, 0], [-sin[1], 0, cos[1]]])
    return about_y @ about_x


def placed(points: NDArray[np.float64], attitude: Attitude) -> NDArray[np.float64]:
    """Points of the upright hull, of shape (..., 3), in the level axes.

    >>> placed(np.array([[0.0, 2.0, 0.0]]), Attitude(np.radians(30), 0.0, 0.5)).round(3).tolist()
    [[0.0, 1.732, 1.5]]
    """
    turned = points @ rotation(attitude.roll_rad, attitude.pitch_rad).T
    turned[..., 2] += attitude.height_m
    return turned


def settled(hull: Surface, asked: Inclination, volume_m3: float) -> Attitude:
    """The attitude of a closed hull; if no height is given, the height follows from the displaced volume.

    A box whose deck stays dry and whose bottom stays wet turns about the middle of its waterplane:

    >>> from .meshes import closed
    >>> from .shapes import Box
    >>> barge = closed(Box(length_m=20, beam_m=10, draught_m=2, depth_m=5), 2.0)
    >>> round(settled(barge, Inclination(0.1, 0.0), 400.0).height_m, 9) + 0.0
    0.0
    """
    if asked.height_m is not None:
        return Attitude(asked.roll_rad, asked.pitch_rad, asked.height_m)
    turned = placed(hull.corners, Attitude(asked.roll_rad, asked.pitch_rad, 0.0))
    return Attitude(asked.roll_rad, asked.pitch_rad, _height(turned, volume_m3))


def _height(corners: NDArray[np.float64], volume_m3: float) -> float:
    """Lift of a closed hull at which it displaces a volume, m.

    Newton's method with dV/dh = -S, S the waterplane's area, within the bounds that every step narrows.
    """
    lowest, highest = corners[..., 2].min(), corners[..., 2].max()
    low, high, height = -highest, -lowest, 0.0
    for _ in range(ROUNDS):
        found, area = _wetted(corners, height)
        low, high = (height, high) if found > volume_m3 else (low, height)
        before = height
        height += (found - volume_m3) / area if area > 0 else np.inf
        if not low < height < high:
            height = (low + high) / 2
        if abs(height - before) < 1e-13 * (highest - lowest):
            break
    return float(height)


def _wetted(corners: NDArray[np.float64], height: float) -> tuple[float, float]:
    """Volume, m3, and waterplane area, m2, of a lifted closed hull: Int z n_z dS and -Int n_z dS over the
    submerged parts of its triangles.

    If one corner of a triangle is on the other side of the water plane than the other two, the plane cuts off
    a tip with the share s t of the area; its mean height is a third of the height of that corner.
    """
    vertical = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])[:, 2] / 2
    z = corners[..., 2] + height
    wet = (z < 0).sum(axis=1)
    mean, share = np.where(wet == 3, z.mean(axis=1), 0.0), np.where(wet == 3, 1.0, 0.0)
    for count in (1, 2):
        some = wet == count
        # Corners are sorted by height: a submerged tip is at the lowest corner, a dry tip at the highest.
        apart, b, c = np.sort(z[some], axis=1)[:, :: 1 if count == 1 else -1].T
        tip = apart**2 / ((apart - b) * (apart - c))
        full = z[some].mean(axis=1)
        share[some] = tip if count == 1 else 1 - tip
        mean[some] = tip * apart / 3 if count == 1 else full - tip * apart / 3
    return float(vertical @ mean), float(-vertical @ share)


def described(attitude: Attitude) -> str:
    """Describe an attitude as text.

    >>> described(Attitude(np.radians(-4.7), 0.0, -0.125))
    'heel 4.7 deg to port, no trim, its origin 0.125 m under the water'
    """
    heel = _angle("heel", attitude.roll_rad, ("to starboard", "to port"))
    trim = _angle("trim", attitude.pitch_rad, ("by the bow", "by the stern"))
    # A height that is only a rounding error is left out.
    height = round(attitude.height_m, 6)
    where = f"{abs(height):.4g} m {'under' if height < 0 else 'above'}" if height else "on"
    return f"{heel}, {trim}, its origin {where} the water"


def _angle(name: str, angle_rad: float, sides: tuple[str, str]) -> str:
    if angle_rad == 0:
        return f"no {name}"
    side = sides[0] if angle_rad > 0 else sides[1]
    return f"{name} {abs(math.degrees(angle_rad)):.4g} deg {side}"

"""Eddies that a naked hull sheds in roll (Ikeda, Himeno & Tanaka 1978)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .lewis import LewisForms, lewis_forms

if TYPE_CHECKING:
    from .sections import Array, Sections


CORNER = 1.65e5 * (1 - 0.997) ** 2 / (10 / 112) ** 4
"""c, by Ikeda's section B: bilges of 10 mm at a draught of 112 mm."""
SHARPNESS = ("radius", "area")
"""The two measures of the sharpness of a bilge, see `sharpness`."""


def eddy_coefficient(sections: Sections, axis_depth_m: float, by: str = "radius") -> Array:
    """C_R of each section: the moment is rho d^4 C_R |omega| omega / 2 for each metre of ship.

        C_R = (r_max / d)^2 C_P {(1 - f1 R/d) (1 - OG/d - f1 R/d) + f2 (H0 - f1 R/d)^2}
        C_P = (0.87 exp(-gamma) - 4 exp(-0.187 gamma) + 3) / 2
        f1 = [1 + tanh 20 (sigma - 0.7)] / 2
        f2 = (1 - cos pi sigma) / 2 - 1.5 [1 - exp(-5 (1 - sigma))] sin^2 pi sigma

    with gamma the largest over the mean speed of the water at the hull, `speed_ratio`, r_max the greatest
    distance of the Lewis form from its centre, R the bilge radius, H0 = B / 2d and OG the depth of the roll
    axis under the water plane (Ikeda, J. Soc. Naval Architects of Japan 142, 1977, eqs. 10-15; Himeno, Univ.
    of Michigan report 239, 1981). Sections with a negative moment, or above the roll axis, are outside the
    measured range and get zero.

    Parameters
    ----------
    sections
        The hull.
    axis_depth_m
        OG, m: the roll axis, through the centre of gravity, under the water plane; negative above.
    by
        Whether f3 in gamma follows the bilge ``radius`` or, as it is printed, the ``area``: see `sharpness`.

    Notes
    -----
    The tests compare this with Ikeda's own two-dimensional cylinders, digitised by Alexandersson
    (doi:10.17632/p3r9nmtvyj.1).
    """
    d, sigma = sections.draught_m, sections.area_coefficient
    ratio, depth = sections.beam_m / (2 * d), axis_depth_m / d
    rounding = _f1(sigma) * sections.bilge_radius_m / d
    lewis = lewis_forms(sections.beam_m, d, sigma)
    psi = _farthest(lewis)
    farthest = _distance(lewis, psi)
    levers = (1 - rounding) * (1 - depth - rounding) + _f2(sigma) * (ratio - rounding) ** 2
    # The mean speed needs an area below the axis.
    below = np.minimum(1.0, sigma) > depth
    gamma = sharpness(sections, by) * speed_ratio(lewis, psi, d, ratio, sigma, np.where(below, depth, 0.0))
    found = (farthest / d) ** 2 * _pressure(gamma) * levers
    return np.where(below, np.maximum(found, 0.0), 0.0)


def speed_ratio(lewis: LewisForms, psi: Array, draught_m: Array, ratio: Array, sigma: Array,
                depth: Array) -> Array:  # fmt: skip
    """gamma / f3: the water's largest speed along a rolling Lewis form over its mean.

        gamma = sqrt(pi) f3 (r_max + (2 M / H) sqrt(A^2 + B^2)) / (2 d sqrt(H0 (sigma - OG/d)))

    The root is a term of the sum: a half circle, for which A = B = 0, turns without moving the water.
    """
    a1, a3 = lewis.a1, lewis.a3
    h = 1 + a1**2 + 9 * a3**2 + 2 * a1 * (1 - 3 * a3) * np.cos(2 * psi) - 6 * a3 * np.cos(4 * psi)
    even, odd = 6 * a3**2 + a1**2 * (1 + a3), 3 * a1 * a3 * (1 + a3)
    along = [
        -2 * a3 * turn(5 * psi) + a1 * (1 - a3) * turn(3 * psi) + (even + sign * odd) * turn(psi)
        for turn, sign in ((np.cos, -1), (np.sin, 1))
    ]
    swirl = 2 * lewis.scale_m / h * np.hypot(*along)
    mean = 2 * draught_m * np.sqrt(ratio * (sigma - depth))
    return np.sqrt(np.pi) * (_distance(lewis, psi) + swirl) / mean


def sharpness(sections: Sections, by: str = "radius") -> Array:
    """f3: ratio of the water's speed at a bilge to that at the Lewis form, 5 for a sharp corner.

    The printed formula is f3 = 1 + 4 exp(-1.65e5 (1 - sigma)^2), fitted to Ikeda's cylinders A to D of H0 =
    1.25. With a round bilge 1 - sigma = (4 - pi) (R/d)^2 / 4 H0, so the same law by the radius is f3 = 1 + 4
    exp(-c (R/d)^4). The two differ, because the quoted area coefficient of B, 0.997, does not agree with its
    radius of 10 mm, which gives 0.9986, and B is the only section between the sharp and the round ones. A
    corner is sharp because its radius is small, so c is fitted to B: 1.65e5 (1 - 0.997)^2 / (10 / 112)^4 =
    2.34e4. Both laws agree on A to D. For sections of 0.99 to 1 with a bilge, the law by the radius gives
    eddies up to four times smaller. The measurement of KVLCC2 is nearer to that law; it was known when the
    law was chosen, but c is not fitted to it.

    >>> from kingpost.roll_damping.sections import Sections
    >>> tanker = Sections.of_table({"x_m": [0, 1, 2], "beam_m": [58] * 3, "draught_m": [20.8] * 3,
    ...     "area_coefficient": [0.998] * 3})
    >>> [round(float(sharpness(tanker, by)[0]), 2) for by in SHARPNESS]
    [1.08, 3.07]
    """
    if by == "area":
        return 1 + 4 * np.exp(-1.65e5 * (1 - sections.area_coefficient) ** 2)
    return 1 + 4 * np.exp(-CORNER * (sections.bilge_radius_m / sections.draught_m) ** 4)


def _pressure(gamma: Array) -> Array:
    return (0.87 * np.exp(-gamma) - 4 * np.exp(-0.187 * gamma) + 3) / 2


def _f1(sigma: Array) -> Array:
    return (1 + np.tanh(20 * (sigma - 0.7))) / 2


def _f2(sigma: Array) -> Array:
    wave = np.sin(np.pi * sigma) ** 2
    return (1 - np.cos(np.pi * sigma)) / 2 - 1.5 * (1 - np.exp(-5 * (1 - sigma))) * wave


def _farthest(lewis: LewisForms) -> Array:
    """Angle of the point farthest from the centre: the keel, or where cos 2 psi = a1 (1 + a3) / 4 a3, which
    beyond its range is the keel or the water line."""
    a3 = np.where(lewis.a3 == 0, np.finfo(float).tiny, lewis.a3)
    with np.errstate(over="ignore"):
        corner = np.arccos(np.clip(lewis.a1 * (1 + lewis.a3) / (4 * a3), -1, 1)) / 2
    keel = np.zeros_like(corner)
    return np.where(_distance(lewis, keel) >= _distance(lewis, corner), keel, corner)


def _distance(lewis: LewisForms, psi: Array) -> Array:
    return np.hypot(*lewis.points(psi))

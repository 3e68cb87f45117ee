"""Bilge keels: the force on them and the pressure that they put on the hull (Ikeda, Himeno & Tanaka 1978)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..errors import RollDampingError

if TYPE_CHECKING:
    from .sections import Array, Sections

CUTS = 24
"""Number of places along a keel at which the damping is computed."""
FORWARD_PRESSURE = 1.2
"""C_p+, on the front side of a keel."""
# Half of a bilge's arc length, in radii: from the bottom or the side to the keel in the middle.
HALF_ARC = math.pi / 4


@dataclass(frozen=True)
class BilgeKeels:
    """A pair of bilge keels, normal to the bilge at the middle of its arc.

    Attributes
    ----------
    breadth_m, length_m
        Breadth of each keel, outwards from the hull, and its length along the ship.
    centre_m
        Their middle along the ship, in the frame of the sections; default: the ship's middle.

    >>> BilgeKeels(breadth_m=0.4, length_m=30).breadth_m
    0.4
    >>> BilgeKeels(breadth_m=-0.4, length_m=30)
    Traceback (most recent call last):
    kingpost.errors.RollDampingError: bilge_keels.breadth_m: found -0.4, allowed: a number greater than 0
    """

    breadth_m: float
    length_m: float
    centre_m: float | None = None

    def __post_init__(self) -> None:
        for name in ("breadth_m", "length_m"):
            value = getattr(self, name)
            if not (math.isfinite(value) and value > 0):
                raise RollDampingError(f"bilge_keels.{name}", f"{value:g}", "a number greater than 0")
        if self.centre_m is not None and not math.isfinite(self.centre_m):
            raise RollDampingError("bilge_keels.centre_m", f"{self.centre_m:g}", "a finite number")

    def places(self, sections: Sections) -> Array:
        """Middles of equal parts of the keels along the ship.

        Raises
        ------
        RollDampingError
            If they are too broad for the draught, or reach beyond the ends of the hull.
        """
        first, last = sections.ends_m
        centre = (first + last) / 2 if self.centre_m is None else self.centre_m
        ends = centre - self.length_m / 2, centre + self.length_m / 2
        slack = 1e-9 * (last - first)
        if ends[0] < first - slack or ends[1] > last + slack:
            found = f"keels from {ends[0]:.6g} to {ends[1]:.6g} m"
            raise RollDampingError("bilge_keels", found, f"within the hull, {first:.6g} to {last:.6g} m")
        if self.breadth_m > sections.draught_m.max() / 2:
            allowed = f"at most half the draught, {sections.draught_m.max() / 2:.4g}"
            raise RollDampingError("bilge_keels.breadth_m", f"{self.breadth_m:g}", allowed)
        return ends[0] + self.length_m * (np.arange(CUTS) + 0.5) / CUTS


def bilge_keel_damping(sections: Sections, keels: BilgeKeels, axis_depth_m: float, frequency_rad_s: float,
                       amplitude_rad: float, density_kg_m3: float) -> tuple[float, float]:  # fmt: skip
    """Equivalent linear damping, N m s, of a pair of keels: by the force on them, and by the pressure on the
    hull.

    For each metre, with l the distance from the roll axis to the keel's root, b its breadth and
    f = 1 + 0.3 exp(-160 (1 - sigma)) for the faster water at a full bilge:

        C_D = 22.5 b / (pi l phi f) + 2.4
        B_N' = 8 / (3 pi) rho l^3 omega phi b f^2 C_D
        B_H' = 4 / (3 pi) rho l^2 d^2 omega phi f^2 (-A0 C_p- + B0 C_p+),  C_p+ = 1.2, C_p- = 1.2 - C_D

    (Ikeda, Himeno & Tanaka, J. Soc. Naval Architects of Japan 143, 1978; ITTC 7.5-02-07-04.5, 2021,
    eqs. 48-57. `pressure_levers` has A0 and B0. The factor f^2 on B_H' follows from the reference speed f l
    omega of the pressure coefficients.)

    Parameters
    ----------
    sections, keels
        The hull and its keels.
    axis_depth_m
        OG, m: the roll axis under the water plane.
    frequency_rad_s, amplitude_rad
        omega and phi of the roll.
    density_kg_m3
        Density of the water.
    """
    x = keels.places(sections)
    at = sections.at(x)
    d, b = at.draught_m, keels.breadth_m
    arm = keel_arm(at, axis_depth_m)
    faster = 1 + 0.3 * np.exp(-160 * (1 - np.minimum(at.area_coefficient, 1)))
    travel = np.pi * arm * amplitude_rad * faster
    drag = 22.5 * b / travel + 2.4
    negative_length = 0.3 * travel + 1.95 * b
    behind, before = pressure_levers(at, axis_depth_m, negative_length)
    speed = density_kg_m3 * frequency_rad_s * amplitude_rad * (faster * arm) ** 2 / (3 * np.pi)
    force = 8 * speed * arm * b * drag
    pressure = 4 * speed * d**2 * (behind * (drag - FORWARD_PRESSURE) + before * FORWARD_PRESSURE)
    return float(force.mean() * keels.length_m), float(pressure.mean() * keels.length_m)


def keel_arm(sections: Sections, axis_depth_m: float) -> Array:
    """Distance l, m, from the roll axis to the middle of the bilge's arc."""
    inset = (1 - math.sqrt(0.5)) * sections.bilge_radius_m
    out, down = sections.beam_m / 2 - inset, sections.draught_m - axis_depth_m - inset
    return np.hypot(out, down)


def pressure_levers(sections: Sections, axis_depth_m: float, negative_length_m: Array) -> tuple[Array, Array]:
    """A0 and B0: moments about the roll axis of unit pressures behind and before the keels, over d^2.

    The section has a flat bottom, vertical sides and a quarter circle of radius R between them. Behind a keel
    the pressure is constant over the length S0 of the girth; before it, it falls linearly from the keel to
    zero at the centre line or the water line. With m1 = R/d, m2 = OG/d, m3 = 1 - m1 - m2, m4 = H0 - m1:

        A0 = (m3 + m4) m8 - m7^2
        B0 = m4^3 / 3 (H0 - 0.215 m1) + (1 - m1)^2 (2 m3 - m2) / 6 (1 - 0.215 m1) + m1 (m3 m5 + m4 m6)

    where m7 is the part of S0/d beyond the arc and m8 = m7 + (sqrt 2 - 1) m1, or within the arc
    sqrt 2 m1 (1 - cos S0/R). (Here the numbers 0.215, 0.414, 0.0651, 0.382 and 0.0106 of the published
    formulas are 1 - pi/4 and integrals over the arc, exactly. Printed versions of the procedure have m2^2
    instead of the first m4^3, which contradicts the integral for a square bilge; the test integrates
    numerically.)
    """
    d = sections.draught_m
    m1, m2 = sections.bilge_radius_m / d, axis_depth_m / d
    ratio = sections.beam_m / (2 * d)
    m3, m4 = 1 - m1 - m2, ratio - m1
    length = negative_length_m / d
    m7 = np.maximum(length - HALF_ARC * m1, 0.0)
    turn = np.divide(length, m1, out=np.full_like(length, np.inf), where=m1 > 0)
    m8 = m7 + math.sqrt(2) * m1 * (1 - np.cos(np.minimum(turn, HALF_ARC)))
    behind = (m3 + m4) * m8 - m7**2
    bottom, side = ratio - (1 - HALF_ARC) * m1, 1 - (1 - HALF_ARC) * m1
    flat = m4**3 / (3 * bottom) + (1 - m1) ** 2 * (2 * m3 - m2) / (6 * side)
    return behind, flat + m1 * _over_the_arc(m1, m3, m4, bottom, side)


def _over_the_arc(m1: Array, m3: Array, m4: Array, bottom: Array, side: Array) -> Array:
    """m3 m5 + m4 m6: the falling pressure over both halves of the arc.

    At the angle t from the flat part the pressure is (m4 + m1 t) / bottom or (1 - m1 + m1 t) / side, and its
    lever m4 cos t - m3 sin t or m3 cos t - m4 sin t.
    """
    half = math.sqrt(0.5)
    cos, sin = half, 1 - half
    t_cos, t_sin = HALF_ARC * half + half - 1, half - HALF_ARC * half
    under = m4 * (m4 * cos + m1 * t_cos) - m3 * (m4 * sin + m1 * t_sin)
    beside = m3 * ((1 - m1) * cos + m1 * t_cos) - m4 * ((1 - m1) * sin + m1 * t_sin)
    return under / bottom + beside / side

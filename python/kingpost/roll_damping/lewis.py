"""Lewis forms: sections with two coefficients, the conformal map of a circle by three terms.

With the angle psi from the keel the half section is
y = M [(1 + a1) sin psi - a3 sin 3 psi], z = -M [(1 - a1) cos psi + a3 cos 3 psi], M = B / 2 (1 + a1 + a3)
(F. M. Lewis, Trans. SNAME 37, 1929; C. von Kerczek & E. O. Tuck, J. Ship Research 13(4), 1969).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from .sections import Array


@dataclass(frozen=True)
class LewisForms:
    """Coefficients a1 and a3 and the scale M, m, of sections."""

    a1: Array
    a3: Array
    scale_m: Array

    def points(self, psi: Array) -> tuple[Array, Array]:
        """y and z of the half sections at angles from the keel (0) to the water line (pi / 2)."""
        y = (1 + self.a1) * np.sin(psi) - self.a3 * np.sin(3 * psi)
        z = (1 - self.a1) * np.cos(psi) + self.a3 * np.cos(3 * psi)
        return self.scale_m * y, -self.scale_m * z


def lewis_forms(beam_m: Array, draught_m: Array, area_coefficient: Array) -> LewisForms:
    """Lewis forms of given beam, draught and area.

    With H = B / 2d and D = 3 + 4 sigma / pi + (1 - 4 sigma / pi) ((H - 1) / (H + 1))^2:
    a3 = (3 - D + sqrt(9 - 2 D)) / D, a1 = (1 + a3) (H - 1) / (H + 1). Sections too full for a Lewis form (D >
    4.5) get the fullest one.

    >>> half_circle = lewis_forms(np.array([2.0]), np.array([1.0]), np.array([np.pi / 4]))
    >>> abs(half_circle.a1.item()) < 1e-12, abs(half_circle.a3.item()) < 1e-12
    (True, True)
    """
    ratio = beam_m / (2 * draught_m)
    slender = (ratio - 1) / (ratio + 1)
    fullness = 4 * area_coefficient / np.pi
    d = np.minimum(3 + fullness + (1 - fullness) * slender**2, 4.5)
    a3 = (3 - d + np.sqrt(9 - 2 * d)) / d
    a1 = (1 + a3) * slender
    return LewisForms(a1, a3, beam_m / (2 * (1 + a1 + a3)))

"""The regression of Kawahara, Maekawa & Ikeda (2009), to compare eddies and bilge keels.

They fitted Ikeda's method for a series of hulls by polynomials of the main dimensions (STAB 2009, pp.
387-398, eqs. 31 and 38; ITTC 7.5-02-07-04.5, 2021, section 4.3). Damping is B / (rho V B^2) sqrt(B / 2g), the
frequency omega sqrt(B / 2g).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

RANGES = {
    "block_coefficient": (0.5, 0.85),
    "beam_over_draught": (2.5, 4.5),
    "midship_coefficient": (0.9, 0.99),
    "axis_depth_over_draught": (-1.5, 0.2),
}
KEEL_RANGES = {"breadth_over_beam": (0.01, 0.06), "length_over_length": (0.05, 0.40)}


@dataclass(frozen=True)
class HullForm:
    """The inputs of the regression: C_B, C_M, B/d and OG/d, OG being the depth of the roll axis."""

    block_coefficient: float
    midship_coefficient: float
    beam_over_draught: float
    axis_depth_over_draught: float

    def outside(self) -> list[str]:
        """List the inputs outside the range of the fitted series; no input is clamped."""
        found = []
        for name, (least, most) in RANGES.items():
            value = getattr(self, name)
            if not least <= value <= most:
                found.append(f"{name} {value:.3g} is not within {least:g} to {most:g}")
        return found


def eddy(form: HullForm, frequency: float, amplitude_rad: float) -> float:
    """Eddies of the naked hull, non-dimensional.

    >>> form = HullForm(0.65, 0.98, 4.0, -0.2)
    >>> round(eddy(form, 0.5547, np.radians(10)), 5)
    0.00092
    """
    cb, cm, ratio, depth = (form.block_coefficient, form.midship_coefficient, form.beam_over_draught,
                            form.axis_depth_over_draught)  # fmt: skip
    size = (-0.0182 * cb + 0.0155) * (ratio - 1.8) ** 3
    size += float(np.polyval([-79.414, 215.695, -215.883, 93.894, -14.848], cb))
    first = (3.98 * cb - 5.1525) * (-0.2 * ratio + 1.6) * depth
    first *= float(np.polyval([0.9717, -1.55, 0.723], cb)) * depth + 0.04567 * cb + 0.9408
    second = (0.25 * depth + 0.95) * depth + np.polyval([-219.2, 443.7, -283.3, 59.6], cb)
    power = -15 * cb * ratio + 46.5 * cb + 11.2 * ratio - 28.6
    coefficient = size * np.exp(first + second * cm**power)
    return float(4 * frequency * amplitude_rad / (3 * np.pi * cb * ratio**3) * coefficient)


def bilge_keels(form: HullForm, frequency: float, amplitude_rad: float, breadth_over_beam: float,
                length_over_length: float) -> float:  # fmt: skip
    """Bilge keels, force and pressure together, non-dimensional.

    >>> form = HullForm(0.65, 0.98, 4.0, -0.2)
    >>> round(bilge_keels(form, 0.5547, np.radians(10), 0.025, 0.2), 4)
    0.0052
    """
    cb, cm, ratio, depth = (form.block_coefficient, form.midship_coefficient, form.beam_over_draught,
                            form.axis_depth_over_draught)  # fmt: skip
    b, long, degrees = breadth_over_beam, length_over_length, np.degrees(amplitude_rad)
    shape = (-0.3651 * cb + 0.3907) * (ratio - 2.83) ** 2 - 2.21 * cb + 2.632
    swing = 0.00255 * degrees**2 + 0.122 * degrees + 0.4794
    keel = (-0.8913 * b**2 - 0.0733 * b) * long**2 + (5.2857 * b**2 - 0.01185 * b + 0.00189) * long
    first = (5 * b + 0.3 * ratio - 0.2 * long + 0.00125 * degrees**2 - 0.0425 * degrees - 1.86) * depth
    second = -15 * b + 1.2 * cb - 0.1 * ratio - 0.0657 * depth**2 + 0.0586 * depth + 1.6164
    return float(shape * swing * keel * np.exp(first + second * cm ** (2.5 * depth + 15.75)) * frequency)

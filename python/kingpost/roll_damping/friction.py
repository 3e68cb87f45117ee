"""Skin friction and, with forward speed, lift of a rolling hull."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from .sections import Sections


def friction_damping(sections: Sections, axis_depth_m: float, frequency_rad_s: float, density_kg_m3: float,
                     viscosity_m2_s: float, speed_m_s: float = 0.0) -> float:  # fmt: skip
    """Damping by skin friction, N m s; it does not depend on the amplitude.

        B_F = 4 / (3 pi) rho S r^3 phi omega C_f (1 + 4.1 U / omega L)
        C_f = 1.328 (3.22 r^2 phi^2 / T nu)^(-1/2), T = 2 pi / omega
        S = L (1.7 d + C_B B), r = [(0.887 + 0.145 C_B) S / L - 2 OG] / pi

    (H. Kato, J. Soc. Naval Architects of Japan 102, 1957; the speed by Tamiya & Komura, ibid. 132, 1972; ITTC
    7.5-02-07-04.5, 2021, eqs. 38-41). C_f is that of a laminar layer, so C_f phi is a constant. It grows less
    with scale than the other components: it is a tenth of the damping of a model of 2 m, and 1 to 3 % of a
    ship's.
    """
    length, block = sections.total_length_m, sections.block_coefficient
    girth = 1.7 * sections.draught_m.max() + block * sections.beam_m.max()
    radius = ((0.887 + 0.145 * block) * girth - 2 * axis_depth_m) / np.pi
    layer = 1.328 * np.sqrt(2 * np.pi * viscosity_m2_s / (3.22 * frequency_rad_s))
    still = 4 / (3 * np.pi) * density_kg_m3 * length * girth * radius**2 * frequency_rad_s * layer
    return float(still * (1 + 4.1 * speed_m_s / (frequency_rad_s * length)))


def lift_damping(sections: Sections, axis_depth_m: float, density_kg_m3: float, speed_m_s: float) -> float:
    """Damping by the lift of a hull that rolls at forward speed, N m s; zero at rest.

        B_L = rho / 2 U L d k_N l0 lR (1 - 1.4 OG / lR + 0.7 OG^2 / (l0 lR)), l0 = 0.3 d, lR = 0.5 d
        k_N = 2 pi d / L + kappa (4.1 B / L - 0.045), kappa = 0, 0.1 or 0.3 as C_M <= 0.92, <= 0.97 or more

    (Ikeda, Himeno & Tanaka 1978; ITTC 7.5-02-07-04.5, 2021, eqs. 33-36.)
    """
    length, beam, draught = sections.total_length_m, sections.beam_m.max(), sections.draught_m.max()
    full = sections.midship_coefficient
    kappa = 0.0 if full <= 0.92 else 0.1 if full <= 0.97 else 0.3
    slope = 2 * np.pi * draught / length + kappa * (4.1 * beam / length - 0.045)
    arm, centre = 0.3 * draught, 0.5 * draught
    about = 1 - 1.4 * axis_depth_m / centre + 0.7 * axis_depth_m**2 / (arm * centre)
    return float(density_kg_m3 / 2 * speed_m_s * length * draught * slope * arm * centre * about)

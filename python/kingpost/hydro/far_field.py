"""The ring waves that a hull radiates and scatters, from the potential on its panels."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .airy import decay, group_ratio, wave_number

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .database import Water
    from .meshes import HullMeshes

ANGLES_AT_ONCE = 24
"""Number of angles that are summed over the panels at a time."""


@dataclass(frozen=True)
class FarField:
    """Amplitudes f of the ring waves a f(t) exp(i k R) / sqrt(R) at equally spaced angles t, m^(1/2).

    Attributes
    ----------
    radiated
        (frequency, motion, angle): for a motion of 1 m or 1 rad, with a = 1 m.
    scattered
        (frequency, direction, angle): for the held hull in waves of 1 m towards `directions`.
    directions
        Indices of those directions on the circle of the database; the others are mirror images.
    """

    radiated: NDArray[np.complex128]
    scattered: NDArray[np.complex128]
    directions: list[int]


def ring_angles(
    hull: HullMeshes, water: Water, frequencies_rad_s: NDArray[np.float64], directions: int
) -> int:
    """Number of angles that resolves f, with orders up to k R, and its products; a multiple of the
    directions."""
    radius = np.hypot(hull.particulars.length_m, hull.particulars.beam_m) / 2
    least = max(240.0, 6 * radius * wave_number(frequencies_rad_s[-1], water))
    return directions * int(np.ceil(least / directions))


def ring_waves(
    mesh: Any,
    potential: NDArray[np.complex128],
    normal_velocity: NDArray[np.complex128],
    frequency: float,
    water: Water,
    angles: int,
) -> NDArray[np.complex128]:
    """Amplitudes f for potentials on the panels, shape (potentials, angles).

    Green's identity with the far form of Green's function (J. V. Wehausen & E. V. Laitone, Surface Waves,
    1960, eqs. 13.17 and 13.18): f = (w c / 2 g) sqrt(2 / pi k) exp(-i pi / 4) H with
    H(t) = Int (phi_n - phi d/dn) Z(z) exp(-i k (x cos t + y sin t)) dS, Z = cosh k(z + h) / cosh kh and
    c = k^2 / (2 n w^2 / g), n = c_g / c_phase; infinitely deep c = k.

    Parameters
    ----------
    mesh
        Capytaine's mesh: centres, normals and areas of the panels.
    potential, normal_velocity
        phi and phi_n along the outward normal, shape (potentials, panels).
    """
    k = wave_number(frequency, water)
    height, slope = decay(k, mesh.faces_centers[:, 2], water)
    phi = potential * mesh.faces_areas
    flux = normal_velocity * mesh.faces_areas * height - phi * mesh.faces_normals[:, 2] * slope
    along = phi * height
    sums = np.empty((len(potential), angles), complex)
    # A few angles at a time: all angles together need more memory than the matrices of a small hull.
    for some in np.array_split(np.arange(angles), -(-angles // ANGLES_AT_ONCE)):
        turn = 2 * np.pi * some / angles
        ahead = np.stack([np.cos(turn), np.sin(turn), 0 * turn])
        sideways = np.exp(-1j * k * (mesh.faces_centers @ ahead))
        # d/dn of the exponential: -i k (n_x cos t + n_y sin t).
        sums[:, some] = flux @ sideways
        for axis in (0, 1):
            sums[:, some] += 1j * k * ahead[axis] * ((along * mesh.faces_normals[:, axis]) @ sideways)
    strength = k**2 / (2 * group_ratio(frequency, water) * frequency**2 / water.gravity_m_s2)
    factor = frequency * strength / (2 * water.gravity_m_s2) * np.sqrt(2 / (np.pi * k))
    return factor * np.exp(-0.25j * np.pi) * sums

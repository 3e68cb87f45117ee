"""Motions of several hulls that float freely in waves, and what an error of the memory changes in them.

The hulls are blocks of their displaced mass, with the centre of gravity on the water plane, radii of gyration
of 0.35 of the beam and 0.25 of the length, and damping other than radiation of 5 % of the critical
(`fit_data.OTHER_DAMPING`). Their motions q about their origins follow from

    (-w^2 (M + A) - i w (B + D) + C) q = X

for exp(-i w t) (J. N. Newman, Marine Hydrodynamics, 1977, sec. 6.17, with the rows of all hulls). An error dK
of the memory, in the sense of exp(+i w t), changes the impedance Z in brackets by -i w conj(dK). At a
resonance of the water between hulls Z is small for motions that no hull has alone, so that the error of each
entry of K says little about the motions.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .checks import displaced_mass

if TYPE_CHECKING:
    from .database import Hull, Water
    from .several import SeveralHulls
    from .vector_fitting import Array, ComplexArray

GYRATION = (0.35, 0.25)
"""Radius of gyration in roll over the beam, in pitch and yaw over the length: of ordinary ships."""


@dataclass(frozen=True)
class FreeResponse:
    """Impedance and motions of freely floating hulls.

    Attributes
    ----------
    impedance
        (frequency, motion, motion).
    excitation, motions
        (frequency, direction, motion), per metre of wave amplitude.
    peaks
        (motion): the largest amplitude at any frequency in any direction.
    """

    omega: Array
    impedance: ComplexArray
    excitation: ComplexArray
    motions: ComplexArray
    peaks: Array

    @classmethod
    def of(cls, database: SeveralHulls, damping_ratio: float) -> FreeResponse:
        """The response by the data themselves; damping is a share of the critical."""
        omega, added, radiated = (
            database.frequencies_rad_s, database.added_mass, database.radiation_damping
        )  # fmt: skip
        mass = np.concatenate([_mass(hull, database.water) for hull in database.every_hull])
        stiffness = np.concatenate([_stiffness(hull, database.water) for hull in database.every_hull])
        inertia = np.maximum(np.diagonal(added, axis1=1, axis2=2) + mass, displaced_mass(database))
        other = 2.0 * damping_ratio * omega[:, None] * inertia
        w = omega[:, None, None]
        matrices = -(w**2) * (added + np.diag(mass)) - 1j * w * radiated + np.diag(stiffness)
        index = np.arange(len(mass))
        matrices[:, index, index] -= 1j * omega[:, None] * other
        excitation = database.excitation[: len(omega)]
        motions = _solved(matrices, excitation)
        return cls(omega, matrices, excitation, motions, np.abs(motions).max(axis=(0, 1)))

    def gains(self, group: list[int], scale: Array) -> Array:
        """Upper bound of the change of a motion over its peak, for an error of the memory of each frequency:
        ``scale_i scale_j`` times a matrix E over the motions of a group with the norm 1, (frequency)."""
        by_force = np.linalg.inv(self.impedance)[:, :, group] * scale[group] / self.peaks[:, None]
        moved = np.abs(self.motions[:, :, group] * scale[group])
        largest = np.linalg.norm(moved, axis=2).max(axis=1)
        return self.omega * np.linalg.norm(by_force, axis=2).max(axis=1) * largest

    def error(self, memory_error: ComplexArray) -> float:
        """Largest change of a motion over its peak by an error of the memory, (frequency, motion, motion)."""
        changed = self.impedance - 1j * self.omega[:, None, None] * np.conj(memory_error)
        return float((np.abs(_solved(changed, self.excitation) - self.motions) / self.peaks).max())


def _solved(matrices: ComplexArray, excitation: ComplexArray) -> ComplexArray:
    return np.linalg.solve(matrices[:, None], excitation[..., None])[..., 0]


def _mass(hull: Hull, water: Water) -> Array:
    mass = water.density_kg_m3 * hull.volume_m3
    across, along = GYRATION[0] * hull.beam_m, GYRATION[1] * hull.length_m
    return mass * np.array([1.0, 1.0, 1.0, across**2, along**2, along**2])


def _stiffness(hull: Hull, water: Water) -> Array:
    """Restoring in heave, roll and pitch, at least zero."""
    lengthwise, _, athwart = hull.waterplane.second_moments_m4
    height = hull.volume_m3 * hull.centre_of_buoyancy_m[2]
    restoring = [0.0, 0.0, hull.waterplane.area_m2, athwart + height, lengthwise + height, 0.0]
    return water.density_kg_m3 * water.gravity_m_s2 * np.maximum(restoring, 0.0)

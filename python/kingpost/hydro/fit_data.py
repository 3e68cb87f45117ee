"""The data for the fit of the memory, and the measure of its error.

Two errors of K = B + j w (A - A_inf) count: relative to its peak, for the memory force of a motion; and
relative to the impedance of the motion at each frequency, for the response. A hull of mass M that is free in
i has the impedance j w (M_ii + A_ii) + B_ii + C_ii / (j w). At resonance only B_ii and the other damping
remain. With other damping of 5 % of the critical, 2 zeta w (M_ii + A_ii), an error dK changes the response
there by dK / (B_ii + 2 zeta w (M_ii + A_ii)), and by less elsewhere. Platforms resonate where their radiation
damping is a thousandth of its peak: a fit relative to the peak alone is useless at such a resonance.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, TypeVar

import numpy as np

from ..errors import HydrodynamicsError
from .checks import displaced_mass
from .free_response import FreeResponse
from .memory import frequency_response
from .several import SeveralHulls

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .database import Database, Hull, Water
    from .vector_fitting import Array, ComplexArray

    Hulls = Database | SeveralHulls
    One = TypeVar("One", bound=Hulls)

FEWEST_FREQUENCIES = 8
# The scale of a motion is its peak of K, at least this share of rho V l^2 sqrt(g / l): the yaw of a body of
# revolution is noise and must not be scaled up.
LEAST_PEAK = 1e-3
# Damping other than radiation, over the critical: viscosity, moorings, rigging.
OTHER_DAMPING = 0.05


@dataclass(frozen=True)
class FitData:
    """K of the data, made symmetric: panel methods satisfy K_ij = K_ji only approximately (`checks`).

    Attributes
    ----------
    motions
        Their names.
    peaks
        (motion): the largest min(1, w_i / w) |K_ii|, w_i the frequency of the motion's largest damping; at
        least the value from `LEAST_PEAK`.
    scaled
        K_ij / sqrt(peak_i peak_j).
    coupled
        (force, motion): entries larger than a tenth of the limit.
    importance
        (frequency): min(1, w_c / w), w_c the highest w_i of the motions that are damped. Beyond it K is
        nearly j w (A - A_inf), and this weight turns an error of K into one of A.
    sensitivity
        (frequency, motion): peak_i / (B_ii + 2 zeta w (M_ii + A_ii)).
    free
        The motions of several hulls in waves, whose change is the error of the response; `None` for one
        hull.
    """

    motions: tuple[str, ...]
    omega: Array
    peaks: Array
    scaled: ComplexArray
    coupled: NDArray[np.bool_]
    importance: Array
    sensitivity: Array
    free: FreeResponse | None = None

    @classmethod
    def of(cls, database: Hulls, limit: float) -> FitData:
        """Make the data of a fit with this limit on the error."""
        omega, response = database.frequencies_rad_s, frequency_response(database)
        response = 0.5 * (response + response.transpose(0, 2, 1))
        diagonal = np.einsum("nii->ni", response)
        centres = omega[diagonal.real.argmax(axis=0)]
        weighted = np.minimum(1.0, centres / omega[:, None]) * np.abs(diagonal)
        peaks = np.maximum(weighted.max(axis=0), LEAST_PEAK * _natural_damping(database))
        scaled = response / np.sqrt(np.outer(peaks, peaks))
        # Motions whose damping is noise are not used to find the frequency of the largest damping.
        damped = diagonal.real.max(axis=0) > 0.1 * peaks
        centre = centres[damped].max(initial=omega[0])
        coupled = np.abs(scaled).max(axis=0) > 0.1 * limit
        sensitivity = peaks / _least_impedance(database, diagonal.real)
        free = FreeResponse.of(database, OTHER_DAMPING) if isinstance(database, SeveralHulls) else None
        importance = np.minimum(1.0, centre / omega)
        return cls(database.motions, omega, peaks, scaled, coupled, importance, sensitivity, free)

    @property
    def scale(self) -> Array:
        """sqrt(peak_i peak_j)."""
        return np.sqrt(np.outer(self.peaks, self.peaks))

    def counts(self, group: list[int]) -> Array:
        """Weight of an error at each frequency, for motions that are fitted together."""
        if self.free is not None:
            return np.maximum(self.importance, self.free.gains(group, np.sqrt(self.peaks)))
        return np.maximum(self.importance, np.exp(np.log(self.sensitivity[:, group]).mean(axis=1)))

    def by_frequency(self, error: ComplexArray) -> Array:
        """The largest weighted error of any entry, (frequency)."""
        return self.importance * np.abs(error).max(axis=(1, 2))

    def largest(self, error: ComplexArray) -> float:
        """The largest weighted error of any entry at any frequency."""
        return float(self.by_frequency(error).max())

    def response_error(self, error: ComplexArray, group: list[int]) -> float:
        """Largest error of a response up to the frequency of the largest damping; above it only the mass
        resists a motion. Of several hulls, at any frequency, over the peak of each motion. The motions of
        `error` are those of the group."""
        if self.free is not None:
            every = np.zeros_like(self.scaled)
            every[np.ix_(range(len(every)), group, group)] = error
            return self.free.error(every * self.scale)
        root = np.sqrt(self.sensitivity[:, group])
        relative = np.abs(error) * root[:, :, None] * root[:, None, :]
        return float(relative[self.importance >= 1.0].max(initial=0.0))


def _least_impedance(database: Database, damping: Array) -> Array:
    """B_ii + 2 zeta w (M_ii + A_ii), (frequency, motion), M that of a block of the hull's size."""
    mass = np.diagonal(database.added_mass, axis1=1, axis2=2) + displaced_mass(database)
    light = 2.0 * OTHER_DAMPING * database.frequencies_rad_s[:, None]
    return np.maximum(damping, 0.0) + light * np.maximum(mass, displaced_mass(database))


def _natural_damping(database: Hulls) -> Array:
    """rho V l^2 sqrt(g / V^(1/3)) of each motion, with l half the beam or the length for rotations, otherwise
    1."""
    return np.concatenate([_natural(hull, database.water) for hull in database.every_hull])


def _natural(hull: Hull, water: Water) -> Array:
    lever = np.array([1.0, 1.0, 1.0, 0.5 * hull.beam_m, 0.5 * hull.length_m, 0.5 * hull.length_m])
    rate = np.sqrt(water.gravity_m_s2 / hull.volume_m3 ** (1.0 / 3.0))
    return water.density_kg_m3 * hull.volume_m3 * lever**2 * rate


def up_to(database: One, highest_rad_s: float) -> One:
    """Return the data up to a highest frequency.

    Raises
    ------
    HydrodynamicsError
        If fewer than eight are left.
    """
    kept = database.frequencies_rad_s <= highest_rad_s
    if kept.sum() < FEWEST_FREQUENCIES:
        found = f"{kept.sum()} frequencies up to {highest_rad_s:g} rad/s"
        raise HydrodynamicsError("frequencies_rad_s", found, f"at least {FEWEST_FREQUENCIES} for a fit")
    return replace(
        database,
        frequencies_rad_s=database.frequencies_rad_s[kept],
        added_mass=database.added_mass[kept],
        radiation_damping=database.radiation_damping[kept],
    )

"""Checks that refuse unphysical coefficients; each error gives the limit and the values found."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..errors import HydrodynamicsError, flag
from .airy import group_ratio, wave_number

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .database import Database, Hull, Water
    from .several import SeveralHulls

    Hulls = Database | SeveralHulls

ASYMMETRY = 0.05
"""Largest |A_ij - A_ji| as a fraction of sqrt(A_ii A_jj), with the largest value of each diagonal."""
NEGATIVE_DAMPING = 0.05
"""Largest negative eigenvalue of the symmetric part of B, as a fraction of the diagonal's largest entry."""
HASKIND = 0.10
"""Largest difference of B_ii from Haskind's relation as a fraction of the largest B_ii."""
PLAUSIBLE = {"density_kg_m3": (900.0, 1300.0, "kg/m3"), "gravity_m_s2": (9.7, 9.9, "m/s2")}
"""Plausible ranges of density (hot fresh water to the Dead Sea) and gravity (equator to poles)."""
REMEDY = "use more panels, a lid, or frequencies that the panels resolve"
_SMALL = 0.01
"""Smallest scale of a diagonal, as a fraction of the displaced water's: the roll of a sphere is zero."""


def check(database: Hulls, remedy: str = REMEDY, share: float = 1.0) -> None:
    """Refuse a database with unphysical coefficients.

    Parameters
    ----------
    remedy
        Advice for the error message.
    share
        The limits of asymmetry and of Haskind's relation over those stated here.

    Raises
    ------
    HydrodynamicsError
        If added mass or damping is not symmetric, the diagonal of the added mass at infinite frequency is not
        positive, damping generates energy, or excitation and damping disagree.
    """
    check_symmetry(database, remedy, share)
    check_damping(database, remedy)
    check_haskind(database, remedy, share)


def check_water(water: Water, file: str | None = None) -> None:
    """Refuse a density or a gravity in another unit, before anything is computed with it.

    Raises
    ------
    HydrodynamicsError
        If density or gravity is outside its range.
    """
    for name, (least, most, unit) in PLAUSIBLE.items():
        value = getattr(water, name)
        if not least <= value <= most:
            allowed = f"{least:g} to {most:g} {unit}: give {flag(name)} in {unit}"
            raise HydrodynamicsError(name, f"{value:g}", allowed, file)


def check_symmetry(database: Hulls, remedy: str = REMEDY, share: float = 1.0) -> None:
    """A_ij = A_ji and B_ij = B_ji at zero speed; A_ii at infinite frequency is not negative."""
    scale = mass_scale(database)
    diagonal = np.diagonal(database.added_mass_infinite)
    if (diagonal < -ASYMMETRY * scale).any():
        worst = int(np.argmin(diagonal / scale))
        found = f"{diagonal[worst]:.3g} in {database.motions[worst]}"
        raise HydrodynamicsError("added_mass_infinite", found, f"no negative diagonal: {remedy}")
    every = np.concatenate([database.added_mass, database.added_mass_infinite[None]])
    _check_symmetric("added_mass", every, database, scale, remedy, share * ASYMMETRY)
    damping = database.radiation_damping
    scale = damping_scale(database)
    _check_symmetric("radiation_damping", damping, database, scale, remedy, share * ASYMMETRY)


def _check_symmetric(
    field: str, matrices: NDArray, database: Hulls, scale: NDArray, remedy: str, limit: float
) -> None:
    difference = np.abs(matrices - matrices.transpose(0, 2, 1)) / np.sqrt(np.outer(scale, scale))
    n, i, j = np.unravel_index(np.argmax(difference), difference.shape)
    if difference[n, i, j] > limit:
        at = "infinite frequency"
        if n < len(database.frequencies_rad_s):
            at = f"{database.frequencies_rad_s[n]:g} rad/s"
        back = f"{matrices[n, j, i]:.4g} back at {at}"
        raise HydrodynamicsError(
            field,
            f"{matrices[n, i, j]:.4g} from {database.motions[j]} to {database.motions[i]} but {back}",
            f"symmetric matrices, to {limit:g} of the diagonal's largest: {remedy}",
        )


def check_damping(database: Hulls, remedy: str = REMEDY) -> None:
    """The symmetric part of B is not negative: waves carry energy away."""
    scale = np.sqrt(damping_scale(database))
    damping = database.radiation_damping
    symmetric = (damping + damping.transpose(0, 2, 1)) / 2 / np.outer(scale, scale)
    lowest = np.linalg.eigvalsh(symmetric)[:, 0]
    n = int(np.argmin(lowest))
    if lowest[n] < -NEGATIVE_DAMPING:
        raise HydrodynamicsError(
            "radiation_damping",
            f"an eigenvalue of {lowest[n]:.3g} of its symmetric part, over the diagonal's largest, at "
            f"{database.frequencies_rad_s[n]:g} rad/s",
            f"{-NEGATIVE_DAMPING:g} or more: {remedy}",
        )


def check_haskind(database: Hulls, remedy: str = REMEDY, share: float = 1.0) -> None:
    """Damping agrees with the radiated waves that follow from the excitation; see `haskind_damping`.

    Only frequencies for which the grid of directions resolves the integral are compared.
    """
    found = haskind_difference(database)
    if found is not None and found.largest > share * HASKIND:
        raise HydrodynamicsError(
            "radiation_damping",
            f"a difference of {found.largest:.1%} of its largest from Haskind's relation in {found.motion} "
            f"at {found.frequency_rad_s:g} rad/s",
            f"at most {share * HASKIND:.0%}: {remedy}",
        )


@dataclass(frozen=True)
class Difference:
    """Largest difference of the damping from Haskind's relation over the largest damping, with its motion and
    frequency."""

    largest: float
    motion: str
    frequency_rad_s: float


def haskind_difference(database: Hulls) -> Difference | None:
    """`None` if the directions do not resolve the integral at any frequency."""
    resolved = database.frequencies_rad_s <= highest_resolved(database)
    if not resolved.any():
        return None
    frequencies = database.frequencies_rad_s[resolved]
    damping = np.diagonal(database.radiation_damping, axis1=1, axis2=2)
    difference = np.abs(damping[resolved] - haskind_damping(database)[resolved]) / damping_scale(database)
    n, i = np.unravel_index(np.argmax(difference), difference.shape)
    return Difference(float(difference[n, i]), database.motions[i], float(frequencies[n]))


def haskind_damping(database: Hulls) -> NDArray[np.float64]:
    """Diagonal of B from the excitation, shape (frequencies, 6).

    B_ii = k / (8 pi rho g v_g) Int |X_i|^2 db over the circle, v_g the group velocity
    (J. N. Newman, The exciting forces on fixed bodies in waves, J. Ship Research 6(3), 1962).
    """
    water = database.water
    mean_square = (np.abs(database.excitation) ** 2).mean(axis=1) * 2 * np.pi
    factors = [_haskind_factor(frequency, water) for frequency in database.frequencies_rad_s]
    return mean_square * np.array(factors)[:, None]


def _haskind_factor(frequency: float, water: Water) -> float:
    k = wave_number(frequency, water)
    velocity = group_ratio(frequency, water) * frequency / k
    return float(k / (8 * np.pi * water.density_kg_m3 * water.gravity_m_s2 * velocity))


def highest_resolved(database: Hulls) -> float:
    """Highest frequency at which m directions resolve |X|^2, which has angular orders up to 2 k R; rad/s.

    R is the radius of the hull's plan; a margin of four orders is kept.
    """
    most = (len(database.wave_directions_rad) - 4) / (2 * database.reach_m)
    resolved = [w for w in database.frequencies_rad_s if wave_number(w, database.water) <= most]
    return max(resolved, default=0.0)


def mass_scale(database: Hulls) -> NDArray[np.float64]:
    """The largest diagonal of A, at least a small part of the displaced water's."""
    largest = np.diagonal(database.added_mass, axis1=1, axis2=2).max(axis=0)
    return np.maximum(largest, _SMALL * displaced_mass(database))


def damping_scale(database: Hulls) -> NDArray[np.float64]:
    """The largest diagonal of B, at least a small part of the displaced water's mass times
    sqrt(g / V^(1/3))."""
    gravity = database.water.gravity_m_s2
    middle = [np.sqrt(gravity / hull.volume_m3 ** (1 / 3)) for hull in database.every_hull]
    largest = np.diagonal(database.radiation_damping, axis1=1, axis2=2).max(axis=0)
    return np.maximum(largest, _SMALL * np.repeat(middle, 6) * displaced_mass(database))


def displaced_mass(database: Hulls) -> NDArray[np.float64]:
    """Mass and inertia of the displaced water, as of a block of the hull's length and beam."""
    return np.concatenate([_displaced_mass(hull, database.water) for hull in database.every_hull])


def _displaced_mass(hull: Hull, water: Water) -> NDArray[np.float64]:
    mass = water.density_kg_m3 * hull.volume_m3
    inertia = mass * np.array([hull.beam_m, hull.length_m, hull.length_m]) ** 2 / 12
    return np.array([mass, mass, mass, *inertia])

"""Repairs of errors in another program's coefficients, each with a note of the change.

Panel methods satisfy A = A^T and B = B^T only approximately, worst at the highest frequencies; damping of
motions that hardly radiate can be slightly negative; at irregular frequencies both jump. A and B are
replaced by their symmetric parts, B by the nearest matrix without negative eigenvalues, and single
frequencies at which the coefficients jump are left out. A change of more than `USELESS` of the largest
diagonal means that the file was misread: it is refused.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from ...errors import HydrodynamicsError
from ..database import MOTIONS

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .foreign import Foreign

USELESS = 0.5
"""Largest asymmetry or negative damping as a share of the largest diagonal; beyond it a matrix is
unphysical."""
WORTH_SAYING = 1e-4
JUMP = 0.15
"""A coefficient jumps if it is off the line between its neighbours by more than this share of its range..."""
LONE = 2.0
"""...and by more than this multiple of the differences between its neighbours, and to the next points..."""
LONE_AT_AN_END = 4.0
"""...or, at the first and the last frequency, of the differences between the next three points."""
MOST_LEFT_OUT, MOST_USELESS = 0.1, 0.25


def up_to(foreign: Foreign, highest_rad_s: float | None, notes: list[str]) -> Foreign:
    """Leave out the frequencies above a limit, before any check."""
    if highest_rad_s is None:
        return foreign
    kept = foreign.frequencies_rad_s <= highest_rad_s
    if not kept.any():
        lowest = foreign.frequencies_rad_s[0]
        found = f"{highest_rad_s:g}, below all {len(kept)} frequencies of the file"
        raise HydrodynamicsError("--highest-rad-s", found, f"more than {lowest:.4g}", foreign.file)
    if not kept.all():
        notes.append(f"{(~kept).sum()} frequencies above {highest_rad_s:g} rad/s left out, as asked")
    return at_frequencies(foreign, kept)


def at_frequencies(foreign: Foreign, kept: NDArray[np.bool_]) -> Foreign:
    """The file's contents at some of its frequencies."""
    apart, drift = foreign.froude_krylov, foreign.mean_drift
    return replace(
        foreign,
        frequencies_rad_s=foreign.frequencies_rad_s[kept],
        added_mass=foreign.added_mass[kept],
        radiation_damping=foreign.radiation_damping[kept],
        excitation=foreign.excitation[kept],
        froude_krylov=None if apart is None else apart[kept],
        mean_drift=None if drift is None else drift[kept],
    )


def repaired(foreign: Foreign, notes: list[str]) -> Foreign:
    """Make the matrices symmetric, without jumps, and damping positive; each change is noted.

    Raises
    ------
    HydrodynamicsError
        If a matrix would change by more than half of its diagonal.
    """
    foreign = _without_jumps(_without_useless(foreign, notes), notes)
    added_mass = _symmetric(foreign.added_mass, "added_mass", foreign, notes)
    damping = _symmetric(foreign.radiation_damping, "radiation_damping", foreign, notes)
    infinite = foreign.added_mass_infinite
    if infinite is not None:
        infinite = _symmetric(infinite[None], "added_mass_infinite", foreign, notes, added_mass)[0]
        infinite = positive(infinite, "added mass at infinite frequency", notes)
    damping = _taking_energy(damping, foreign, notes)
    return replace(foreign, added_mass=added_mass, radiation_damping=damping, added_mass_infinite=infinite)


def _without_useless(foreign: Foreign, notes: list[str]) -> Foreign:
    """Leave out frequencies of strongly negative damping, if they are few."""
    lowest = _lowest_eigenvalues(foreign.radiation_damping)
    useless = lowest < -USELESS
    if not useless.any() or useless.sum() > MOST_USELESS * len(useless):
        return foreign
    at = foreign.frequencies_rad_s[useless]
    notes.append(
        f"repaired: {len(at)} frequencies left out, from {at[0]:.4g} to {at[-1]:.4g} rad/s, whose damping is "
        f"negative by up to {-lowest.min():.0%} of its largest"
    )
    return at_frequencies(foreign, ~useless)


def _lowest_eigenvalues(damping: NDArray[np.float64]) -> NDArray[np.float64]:
    root = np.sqrt(scale_of(damping))
    return np.linalg.eigvalsh(0.5 * (damping + damping.transpose(0, 2, 1)) / np.outer(root, root))[:, 0]


def scale_of(matrices: NDArray[np.float64]) -> NDArray[np.float64]:
    """The largest diagonal of each motion; for a very small diagonal, the value that its couplings need."""
    diagonal = np.abs(np.diagonal(matrices, axis1=1, axis2=2)).max(axis=0)
    coupling = np.abs(matrices).max(axis=(0, 2))
    least = np.where(diagonal > 0.0, 0.0, coupling)
    return np.maximum(np.maximum(diagonal, least), 1e-12 * max(float(diagonal.max()), 1e-300))


def _symmetric(
    matrices: NDArray[np.float64], field: str, foreign: Foreign, notes: list[str],
    like: NDArray[np.float64] | None = None,
) -> NDArray[np.float64]:  # fmt: skip
    scale = scale_of(matrices if like is None else np.concatenate([matrices, like]))
    root = np.sqrt(np.outer(scale, scale))
    change = 0.5 * np.abs(matrices - matrices.transpose(0, 2, 1)) / root
    # Ignore motions of negligible size: the yaw of a body of revolution is noise.
    counted = np.outer(_counts(scale, foreign), _counts(scale, foreign))
    change = np.where(counted, change, 0.0)
    k, i, j = np.unravel_index(np.argmax(change), change.shape)
    at = f"{foreign.frequencies_rad_s[k]:.4g} rad/s" if len(matrices) > 1 else "infinite frequency"
    where = f"{MOTIONS[i]} and {MOTIONS[j]} at {at}"
    if change[k, i, j] > USELESS:
        found = f"{matrices[k, i, j]:.4g} and {matrices[k, j, i]:.4g} between {where}"
        allowed = (
            f"the same both ways, to {USELESS:g} of the diagonal's largest; check units and the hull's parts"
        )
        raise HydrodynamicsError(
            field, found, f"{allowed}, or leave it out with --highest-rad-s", foreign.file
        )
    if change[k, i, j] > WORTH_SAYING:
        name = field.replace("_", " ")
        notes.append(
            f"repaired: {name} made symmetric, by up to {change[k, i, j]:.2%} of the diagonal: {where}"
        )
    return 0.5 * (matrices + matrices.transpose(0, 2, 1))


def _counts(scale: NDArray[np.float64], foreign: Foreign) -> NDArray[np.bool_]:
    """Select motions with more than a millionth of the largest of their kind."""
    kinds = np.repeat([scale[:3].max(), scale[3:].max()], 3)
    return scale > 1e-6 * kinds


def _taking_energy(damping: NDArray[np.float64], foreign: Foreign, notes: list[str]) -> NDArray[np.float64]:
    root = np.sqrt(scale_of(damping))
    values, vectors = np.linalg.eigh(damping / np.outer(root, root))
    k = int(np.argmin(values[:, 0]))
    lowest, at = float(values[k, 0]), foreign.frequencies_rad_s[k]
    if lowest < -USELESS:
        found = (
            f"an eigenvalue of {lowest:.3g} of its symmetric part, over the diagonal's largest, "
            f"at {at:.4g} rad/s"
        )
        allowed = f"{-USELESS:g} or more; check units, or leave such frequencies out with --highest-rad-s"
        raise HydrodynamicsError("radiation_damping", found, allowed, foreign.file)
    if lowest < -WORTH_SAYING:
        count = int((values[:, 0] < -WORTH_SAYING).sum())
        notes.append(
            f"repaired: negative damping at {count} frequencies made 0, by up to {-lowest:.2%} of "
            f"the diagonal's "
            f"largest, at {at:.4g} rad/s"
        )
        notes.extend(_advice(values[:, 0], foreign.frequencies_rad_s))
    if lowest >= 0.0:
        return damping
    kept = np.einsum("nij,nj,nkj->nik", vectors, np.maximum(values, 0.0), vectors)
    clipped = np.where((values[:, 0] < 0.0)[:, None, None], kept * np.outer(root, root), damping)
    # Entries that are zero by symmetry stay zero.
    return np.where((damping == 0.0).all(axis=0), 0.0, clipped)


def _advice(lowest: NDArray[np.float64], omega: NDArray[np.float64]) -> list[str]:
    """Advice on the highest frequency to keep, if all large errors are at the upper end."""
    wrong = np.flatnonzero(lowest < -0.05)
    if not len(wrong) or wrong[0] < len(omega) // 3:
        return []
    last = omega[wrong[0] - 1]
    return [
        f"above {last:.4g} rad/s the panels seem too large for the waves: --highest-rad-s "
        f"{last:.4g} cuts there"
    ]


def positive(matrix: NDArray[np.float64], name: str, notes: list[str]) -> NDArray[np.float64]:
    """Nearest symmetric matrix without a negative eigenvalue, in the norm scaled by its diagonal."""
    root = np.sqrt(scale_of(matrix[None]))
    values, vectors = np.linalg.eigh(matrix / np.outer(root, root))
    if values[0] >= 0.0:
        return matrix
    if values[0] < -WORTH_SAYING:
        notes.append(f"repaired: {name} made positive, by {-values[0]:.2%} of its diagonal")
    found = (vectors * np.maximum(values, 0.0)) @ vectors.T * np.outer(root, root)
    return np.where(matrix == 0.0, 0.0, found)


def _without_jumps(foreign: Foreign, notes: list[str]) -> Foreign:
    """Leave out single frequencies at which A_ii or B_ii jumps."""
    omega = foreign.frequencies_rad_s
    if len(omega) < 12:
        return foreign
    irregular = np.zeros(len(omega), bool)
    for matrices in (foreign.added_mass, foreign.radiation_damping):
        scale = scale_of(matrices)
        for motion in np.flatnonzero(_counts(scale, foreign)):
            irregular |= _jumps(omega, matrices[:, motion, motion])
    if not irregular.any():
        return foreign
    at = ", ".join(f"{value:.4g}" for value in omega[irregular][:8])
    if irregular.sum() > max(1.0, MOST_LEFT_OUT * len(omega)):
        notes.append(
            f"coefficients jump at {irregular.sum()} frequencies ({at} ... rad/s): too many to leave out"
        )
        return foreign
    notes.append(
        f"repaired: {irregular.sum()} irregular frequencies left out, at which coefficients jump: {at} rad/s"
    )
    return at_frequencies(foreign, ~irregular)


def _jumps(omega: NDArray[np.float64], values: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Whether a single value jumps: its neighbours agree with each other and with theirs far better than with
    it. A resonance has flanks; an irregular frequency between regular ones has none."""
    near = values[:-4], values[1:-3], values[3:-1], values[4:]
    part = (omega[2:-2] - omega[1:-3]) / (omega[3:-1] - omega[1:-3])
    off = np.abs(values[2:-2] - ((1.0 - part) * near[1] + part * near[2]))
    apart = np.abs(near[2] - near[1])
    flanks = np.maximum(np.abs(near[1] - near[0]), np.abs(near[3] - near[2]))
    found = np.zeros(len(omega), bool)
    found[2:-2] = (off > JUMP * np.ptp(values)) & (off > LONE * apart) & (off > LONE * flanks)
    found[0] = _jumps_at_the_start(omega, values)
    found[-1] = _jumps_at_the_start(-omega[::-1], values[::-1])
    return found


def _jumps_at_the_start(omega: NDArray[np.float64], values: NDArray[np.float64]) -> bool:
    """Whether the first value is off the straight line through the next two, which themselves are regular:
    strip programs that sum to a given depth have this error at their longest wave."""
    slopes = np.diff(values[1:4]) / np.diff(omega[1:4])
    reach = omega[1] - omega[0]
    off = abs(values[0] - (values[1] - reach * slopes[0]))
    apart = max(np.abs(slopes).max() * reach, np.abs(np.diff(values[1:4])).max())
    return bool(off > JUMP * np.ptp(values) and off > LONE_AT_AN_END * apart)

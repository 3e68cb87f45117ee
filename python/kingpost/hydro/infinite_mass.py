"""Added mass at infinite frequency, fitted together with the memory if a file lacks it.

Ogilvie's relation (`memory.added_mass_infinite`) integrates the damping to infinity; if the data end before
the damping has decayed, a guessed tail decides the result. T. Perez and T. I. Fossen, "Joint identification
of infinite-
frequency added mass and fluid-memory models of marine structures", Modeling, Identification and Control
29(3), 2008, fit B + j w A = K(j w) + j w A_inf with both unknown: the limit of A then follows from the data.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .memory import added_mass_infinite
from .passive_residues import zero_at_zero
from .vector_fitting import common_poles, partial_fractions

if TYPE_CHECKING:
    from .vector_fitting import Array

STATES = (4, 6, 8, 10, 12)
ROUNDS = 8
GONE = 0.15
"""Ogilvie's relation is used if the last damping is below this fraction of its peak: the tail is then
small."""


def joint_added_mass_infinite(omega: Array, added_mass: Array, damping: Array) -> Array:
    """A_inf (6, 6) of symmetric A and B (frequency, 6, 6): by Ogilvie's relation, or by the fit if damping
    has not decayed at the last frequency."""
    found = added_mass_infinite(omega, added_mass, damping)
    found = 0.5 * (found + found.T)
    scale = np.sqrt(np.abs(np.diagonal(added_mass, axis1=1, axis2=2)).max(axis=0))
    for i in range(6):
        for j in range(i, 6):
            size = max(np.abs(added_mass[:, i, j]).max(), np.abs(damping[:, i, j]).max() / omega[-1])
            if size > 1e-6 * scale[i] * scale[j]:
                one = damping[:, i, j]
                if np.abs(one[-1]) > GONE * np.abs(one).max():
                    found[i, j] = found[j, i] = _joint(omega, added_mass[:, i, j], one, found[i, j])
    return found


def _joint(omega: Array, added_mass: Array, damping: Array, start: float) -> float:
    """A_inf of the fit with the smallest error, among fits with different numbers of states."""
    centre = omega[np.abs(damping).argmax()]
    width = np.gradient(omega)
    weights = np.minimum(1.0, centre / omega) * np.sqrt(np.maximum(width / width.mean(), 1.0 / 3.0))
    best, least = start, np.inf
    for states in STATES:
        if 2 * states > len(omega):
            break
        value, error = _alternating(omega, added_mass, damping, weights, start, states)
        if error < 0.9 * least:
            best, least = value, error
    return best


def _alternating(
    omega: Array, added_mass: Array, damping: Array, weights: Array, start: float, states: int
) -> tuple[float, float]:
    """Poles by vector fitting with A_inf known, then residues and A_inf by least squares, alternately."""
    value, error = start, np.inf
    right = damping + 1j * omega * added_mass
    for _ in range(ROUNDS):
        memory = right - 1j * omega * value
        peak = max(np.abs(memory).max(), 1e-300)
        poles = common_poles(memory[:, None] / peak, omega, weights, states)
        matrix = np.column_stack([partial_fractions(poles, 1j * omega) @ zero_at_zero(poles), 1j * omega])
        weighted, target = weights[:, None] * matrix, weights * right
        lengths = np.linalg.norm(weighted, axis=0)
        stacked = np.vstack([weighted.real, weighted.imag]) / lengths
        unknowns = (
            np.linalg.lstsq(stacked, np.concatenate([target.real, target.imag]), rcond=None)[0] / lengths
        )
        error = float(np.abs(weighted @ unknowns - target).max() / peak)
        if abs(unknowns[-1] - value) < 1e-9 * np.abs(added_mass).max():
            break
        value = float(unknowns[-1])
    return value, error

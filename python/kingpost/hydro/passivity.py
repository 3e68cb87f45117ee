"""Passivity of a fitted memory at every frequency, by the eigenvalues of a Hamiltonian matrix.

With K(s) = C (s - A)^-1 B the matrix K(j w) + K(j w)^H + 2 e is singular at the frequencies w for which j w
is an eigenvalue of

    [A - B C / (2 e)     -B B^T / (2 e)        ]
    [C^T C / (2 e)       -A^T + C^T B^T / (2 e)]

(S. Boyd, V. Balakrishnan and P. Kabamba, "A bisection method for computing the H-infinity norm of a transfer
matrix", Mathematics of Control, Signals and Systems 2, 1989; S. Grivet-Talocia, "Passivity enforcement via
perturbation of Hamiltonian matrices", IEEE Transactions on Circuits and Systems I 51(9), 2004). Between such
frequencies no eigenvalue of K + K^H passes -2 e, so that one look in each interval decides for all of it. The
memory has no direct term, K falls to zero at both ends, and the margin e > 0 is needed: it is relative to a
peak of K of 1.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from .vector_fitting import Array, ComplexArray, real_state_space

EPSILON = 1e-6
"""The margin: an energy of a millionth of what the memory absorbs at its peak. The eigenvalues are exact to
about 1e-10 of the largest, which 1 / (2 e) scales."""
NEARLY_IMAGINARY = 1e-3
"""Real part over modulus of an eigenvalue that counts as imaginary: one too many costs one more look."""
LOOKS = 9
"""Frequencies that are looked at within an interval, for its lowest."""


def violations(poles: ComplexArray, residues: ComplexArray, epsilon: float = EPSILON) -> Array:
    """Frequencies, one in each interval where an eigenvalue of (K + K^H) / 2 is below -epsilon, rad/s: those
    near the lowest. Empty for a passive memory.

    Parameters
    ----------
    poles, residues
        Common poles, one of each pair, and symmetric residues (pole, size, size).

    >>> pole, residue = np.array([-0.5 + 1j]), np.array([[[1.0 + 0.5j]]])
    >>> violations(pole, residue), violations(pole, -residue).size
    (array([], dtype=float64), 1)
    """
    crossings = _crossings(poles, residues, epsilon)
    ends = np.concatenate([[0.0], crossings, [2.0 * max(crossings.max(initial=0.0), np.abs(poles).max())]])
    found = []
    for low, high in pairwise(ends):
        inside = np.linspace(low, high, LOOKS + 2)[1:-1]
        lowest = lowest_eigenvalues(poles, residues, inside)
        if lowest.min() < -epsilon:
            found.append(inside[lowest.argmin()])
    return np.array(found)


def lowest_eigenvalues(poles: ComplexArray, residues: ComplexArray, omega: Array) -> Array:
    """The lowest eigenvalue of (K + K^H) / 2 at each frequency."""
    upper = 1.0 / (1j * omega[:, None] - poles)
    lower = np.where(poles.imag == 0.0, 0.0, 1.0 / (1j * omega[:, None] - poles.conj()))
    response = np.tensordot(upper, residues, 1) + np.tensordot(lower, residues.conj(), 1)
    return np.linalg.eigvalsh(0.5 * (response + response.conj().transpose(0, 2, 1)))[:, 0]


def _crossings(poles: ComplexArray, residues: ComplexArray, epsilon: float) -> Array:
    """Frequencies at which K + K^H + 2 epsilon may be singular, in order."""
    state, inputs, outputs = state_space(poles, residues)
    gain = 0.5 / epsilon
    across = gain * inputs @ outputs
    hamiltonian = np.block([
        [state - across, -gain * inputs @ inputs.T],
        [gain * outputs.T @ outputs, across.T - state.T],
    ])  # fmt: skip
    found = np.linalg.eigvals(hamiltonian)
    imaginary = np.abs(found.real) <= NEARLY_IMAGINARY * np.abs(found)
    return np.unique(np.abs(found[imaginary].imag))


def state_space(poles: ComplexArray, residues: ComplexArray) -> tuple[Array, Array, Array]:
    """A, B and C of a memory, real: each input has states of its own."""
    size = residues.shape[1]
    state, inputs = real_state_space(poles)
    rows = [
        np.stack([one.real] if pole.imag == 0.0 else [one.real, one.imag])
        for pole, one in zip(poles, residues, strict=True)
    ]
    # (state of an input, force, input) to (force, input and its states).
    outputs = np.concatenate(rows).transpose(1, 2, 0).reshape(size, -1)
    identity = np.eye(size)
    return np.kron(identity, state), np.kron(identity, inputs[:, None]), outputs

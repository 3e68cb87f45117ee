"""Vector fitting: common stable poles of several frequency responses.

B. Gustavsen and A. Semlyen, "Rational approximation of frequency domain responses by vector fitting",
IEEE Transactions on Power Delivery 14(3), 1999; with the relaxed normalisation of B. Gustavsen, IEEE
Transactions on Power Delivery 21(3), 2006, and each response eliminated by itself as D. Deschrijver
et al. do, IEEE Microwave and Wireless Components Letters 18(6), 2008.

A response is H(s) = sum over poles p of r / (s - p), each complex pole with its conjugate, without a direct
term.
Poles are a complex array that holds one pole of each conjugate pair, the one with positive imaginary part.
Unknowns are real: Re r and Im r of a pair, r of a real pole, in the order of the poles.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

ITERATIONS = 30
# A pole that decays more slowly than this share of its own frequency is noise: no hull rings that long.
LEAST_DAMPING = 0.01

Array = NDArray[np.float64]
ComplexArray = NDArray[np.complex128]


def columns(poles: ComplexArray, function) -> ComplexArray:
    """Real unknowns' columns of sum over poles, conjugates included, of r f(p): f(p) + f(p*) of Re r,
    j (f(p) - f(p*)) of Im r, and f(p) of a real pole's r. f gives one row of values."""
    found = []
    for pole in poles:
        if pole.imag == 0.0:
            found.append(function(pole))
        else:
            upper, lower = function(pole), function(np.conj(pole))
            found += [upper + lower, 1j * (upper - lower)]
    return np.stack(found, axis=-1)


def partial_fractions(poles: ComplexArray, s: ComplexArray) -> ComplexArray:
    """Columns of sum r / (s - p), a row for each s."""
    return columns(poles, lambda pole: 1.0 / (s - pole))


def residues(poles: ComplexArray, unknowns: Array) -> ComplexArray:
    """Complex residues from the real unknowns (first axis)."""
    found, row = [], 0
    for pole in poles:
        if pole.imag == 0.0:
            found.append(unknowns[row] + 0j)
            row += 1
        else:
            found.append(unknowns[row] + 1j * unknowns[row + 1])
            row += 2
    return np.array(found)


def order(poles: ComplexArray) -> int:
    """Number of states: two for a pair, one for a real pole."""
    return int(np.where(poles.imag == 0.0, 1, 2).sum())


def starting_poles(states: int, lowest: float, highest: float) -> ComplexArray:
    """Well-damped pairs, and one real pole if the number is odd, evenly over a range of frequencies."""
    imaginary = np.linspace(lowest, highest, states // 2 + 2)[1:-1]
    poles = -0.2 * imaginary + 1j * imaginary
    return np.append(poles, -0.5 * (lowest + highest) + 0j) if states % 2 else poles


def common_poles(responses: ComplexArray, omega: Array, weights: Array, states: int) -> ComplexArray:
    """Stable poles of responses (frequency, response) at s = j omega, by vector fitting.

    Parameters
    ----------
    weights
        (frequency), of the residuals.
    states
        Number of states, conjugates included.

    Returns
    -------
    ComplexArray
        Poles with negative real parts, within [lowest / 10, 2 highest] of the frequencies in modulus:
        the data determine no poles beyond.
    """
    poles = starting_poles(states, omega[0], omega[-1])
    for _ in range(ITERATIONS):
        moved = _within(_relocated(poles, responses, 1j * omega, weights), omega)
        settled = len(moved) == len(poles) and np.allclose(moved, poles, rtol=1e-10, atol=0.0)
        poles = moved
        if settled:
            break
    return poles


def _relocated(poles: ComplexArray, responses: ComplexArray, s: ComplexArray, weights: Array) -> ComplexArray:
    """The zeros of sigma(s) = d + sum c / (s - p), where sigma H has the poles p."""
    fractions = partial_fractions(poles, s)
    n = fractions.shape[1]
    of_sigma = np.column_stack([fractions, np.ones(len(s))])
    rows, weight = [], np.concatenate([weights, weights])[:, None]
    for response in responses.T:
        block = np.column_stack([fractions, -response[:, None] * of_sigma])
        triangle = np.linalg.qr(weight * np.vstack([block.real, block.imag]), mode="r")
        rows.append(triangle[n:, n:])
    # Relaxed: the mean of sigma over the frequencies is 1, with the weights of the responses.
    scale = np.sqrt((weights[:, None] ** 2 * np.abs(responses) ** 2).sum()) / len(s)
    rows.append(scale * of_sigma.real.sum(axis=0)[None, :])
    matrix = np.vstack(rows)
    right = np.zeros(len(matrix))
    right[-1] = scale * len(s)
    lengths = np.linalg.norm(matrix, axis=0)
    unknowns = np.linalg.lstsq(matrix / lengths, right, rcond=None)[0] / lengths
    direct = unknowns[-1] if abs(unknowns[-1]) > 1e-8 else np.copysign(1e-8, unknowns[-1])
    state, inputs = real_state_space(poles)
    return np.linalg.eigvals(state - np.outer(inputs, unknowns[:-1] / direct))


def real_state_space(poles: ComplexArray) -> tuple[Array, Array]:
    """A and b of the partial fractions in real form."""
    n = order(poles)
    state, inputs, row = np.zeros((n, n)), np.zeros(n), 0
    for pole in poles:
        if pole.imag == 0.0:
            state[row, row], inputs[row] = pole.real, 1.0
            row += 1
        else:
            state[row : row + 2, row : row + 2] = [[pole.real, pole.imag], [-pole.imag, pole.real]]
            inputs[row] = 2.0
            row += 2
    return state, inputs


def _within(poles: ComplexArray, omega: Array) -> ComplexArray:
    """Poles reflected into the left half plane and moved into the range that the data determine, one of each
    pair."""
    upper = poles[poles.imag >= 0.0]
    size = np.clip(np.abs(upper), 0.1 * omega[0], 2.0 * omega[-1])
    damping = np.maximum(np.abs(upper.real) / np.maximum(np.abs(upper), 1e-300), LEAST_DAMPING)
    imaginary = np.where(upper.imag == 0.0, 0.0, size * np.sqrt(np.maximum(1.0 - damping**2, 0.0)))
    imaginary = np.minimum(imaginary, omega[-1])
    real = np.where(upper.imag == 0.0, size, size * damping)
    found = -real + 1j * imaginary
    return found[np.lexsort((found.real, np.abs(found)))]

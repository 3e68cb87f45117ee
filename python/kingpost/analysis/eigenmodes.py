"""Eigenvalues of a linearised system as modes: free, oscillating, decaying, unstable.

Before the eigenvalues are computed, the states are scaled by the mass matrix, so that metres and radians
compare by kinetic energy, and the exactly free motions are separated. Without this step the zero eigenvalues
of a drifting body, which come in pairs with one eigenvector, would scatter by the square root of the rounding
error.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..simulation.linear import Linearization

FREE, OSCILLATION, DECAY, UNSTABLE = "zero", "oscillation", "decay", "unstable"
"""Kinds of modes; modes of equal eigenvalues are listed in this order."""

SMALLEST_SHARE = 1e-13
"""Squared frequencies below this share of the largest count as zero: rounding hides them."""
SMALLEST_SQUARE = 1e-10
"""Squared frequencies below this count as zero, (rad/s)^2: a period of a week."""
FIRST = 1e3
"""Weight of a drive's states in the naming of zero modes, relative to the largest weight of a coordinate."""
LAST = 1e-6
"""Weight of memory states in the naming of zero modes: they only follow the position of a hull."""
BALANCINGS = 20
"""Number of sweeps in the balancing of further states."""
SMALLEST_PRODUCT = 1e-6
"""Smallest product of a left and a right vector of one mode; below it they belong to different modes of equal
eigenvalue."""
ALIKE = 1e-9
"""Shares that differ by less count as equal; the first of them is taken."""


@dataclass(frozen=True)
class Mode:
    """Free motion of the linearised system, ``shape exp(eigenvalue t)``.

    Attributes
    ----------
    kind
        ``zero``, ``oscillation``, ``decay`` or ``unstable``.
    eigenvalue
        1/s; of a complex pair the one with the positive imaginary part.
    multiplicity
        Number of eigenvalues of A that the mode represents: 2 for a complex pair, and for an undamped zero
        mode.
    coordinate
        The mode is named after it: for a zero mode the free coordinate, otherwise the coordinate with the
        largest share of the kinetic energy.
    shape
        Amplitudes of the coordinates, then of the further states, each in its unit; the largest is 1.
    memory_share
        Share of the states that remember radiated waves, by participation factors
        (Perez-Arriaga, Verghese & Schweppe, *IEEE Trans. PAS* 101(9), 1982). The factors of all states add up
        to 1 in any units.
    """

    kind: str
    eigenvalue: complex
    multiplicity: int
    coordinate: str
    shape: NDArray[np.complex128]
    memory_share: float = 0.0


def eigenmodes(
    linear: Linearization, mass: NDArray[np.float64], constraints: NDArray[np.float64]
) -> list[Mode]:
    """Modes of a linearised system, zero modes first, then by modulus of the eigenvalue.

    Parameters
    ----------
    linear
        The system; modes have their usual meaning only where its rates are zero.
    mass
        Reduced mass matrix M* of its free coordinates.
    constraints
        J of the closed loops over its free coordinates, a row for each constraint. Modes satisfy J xi = 0; at
        rest A maps such motions to such motions.
    """
    system = Scaled.of(linear, mass, constraints)
    if not system.a.size:
        return []
    levels, rest = zero_levels(system.a, system.smallest)
    modes = zero_modes(system, levels)
    modes += other_modes(system, np.hstack([*levels, rest[:, :0]]))
    return sorted(modes, key=lambda mode: (mode.kind != FREE, abs(mode.eigenvalue), mode.eigenvalue.real))


@dataclass(frozen=True)
class Scaled:
    """A system in states whose squares are energies: ``w y``, ``y'`` and the further states.

    `memory` lists the names of memory states. With M* = L L^T and an orthonormal basis N of the null space of
    J L^-T, the coordinates are xi = L^-T N y: they are independent, and y'^2 / 2 is the kinetic energy. With
    w the largest frequency, the blocks of A that store energy have entries near w.
    """

    names: list[str]
    memory: NDArray[np.bool_]
    mass: NDArray[np.float64]
    from_scaled: NDArray[np.float64]
    further: NDArray[np.float64]
    a: NDArray[np.float64]
    smallest: float

    @classmethod
    def of(cls, linear: Linearization, mass: NDArray[np.float64], constraints: NDArray[np.float64]) -> Scaled:
        from scipy.linalg import block_diag

        a, n = linear.A.values, len(mass)
        root = np.linalg.cholesky(mass).T
        inverse = np.linalg.solve(root, np.eye(n))
        independent = null_space(constraints @ inverse)
        inward, outward = independent.T @ root, inverse @ independent
        stiffness = inward @ a[n : 2 * n, :n] @ outward
        # Without stiffness the frequency is arbitrary: take 1 rad/s.
        square = max(np.linalg.norm(stiffness, 2) if stiffness.size else 0.0, 1.0)
        frequency = np.sqrt(square)
        names = linear.coordinates + linear.states[2 * n :]
        memory = np.concatenate([linear.remembers[:n], linear.remembers[2 * n :]])
        plain = np.eye(len(a) - 2 * n)
        energies = (
            block_diag(inward * frequency, inward, plain)
            @ a
            @ block_diag(outward / frequency, outward, plain)
        )
        further = balanced(energies, ~memory[n:])
        to_scaled = block_diag(inward * frequency, inward, np.diag(1 / further))
        from_scaled = block_diag(outward / frequency, outward, np.diag(further))
        smallest = max(SMALLEST_SHARE * square, SMALLEST_SQUARE) / frequency
        return cls(names, memory, mass, from_scaled, further, to_scaled @ a @ from_scaled, smallest)

    def shapes(self, scaled: NDArray, rates: bool = False) -> NDArray:
        """Amplitudes of coordinates and further states from scaled states in columns; or their rates."""
        states, n = self.from_scaled @ scaled, len(self.mass)
        start = n if rates else 0
        return np.concatenate([states[start : start + n], states[2 * n :]])

    def share(self, shape: NDArray) -> NDArray[np.float64]:
        """Weights by name: for a coordinate its energy at that amplitude, for a state its scaled square."""
        weights = np.concatenate([np.diag(self.mass), self.further**-2.0])
        return weights[:, None] * np.abs(shape) ** 2 if shape.ndim > 1 else weights * np.abs(shape) ** 2


def balanced(a: NDArray, counts: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Units of the last states of A that balance the rows and columns of the states that count.

    Otherwise thrusts in N would hide values in m (Osborne, *J. ACM* 7(4), 1960); powers of 2, as in LAPACK's
    gebal.
    """
    units, first = np.ones(len(counts)), len(a) - len(counts)
    a = np.abs(a)
    np.fill_diagonal(a, 0.0)
    for _ in range(BALANCINGS):
        for k in np.flatnonzero(counts):
            row, column = a[first + k].sum(), a[:, first + k].sum()
            if row and column:
                factor = 2.0 ** np.round(0.5 * np.log2(row / column))
                units[k] *= factor
                a[first + k] /= factor
                a[:, first + k] *= factor
    return units


def null_space(matrix: NDArray) -> NDArray[np.float64]:
    """Orthonormal basis of the null space of a matrix with independent rows."""
    return np.linalg.qr(matrix.T, mode="complete")[0][:, len(matrix) :]


def zero_levels(a: NDArray, smallest: float) -> tuple[list[NDArray], NDArray]:
    """Bases of the generalised null spaces of A, level by level, and a basis of the rest.

    Singular values below `smallest` count as zero. The bases are orthonormal together.
    """
    levels, rest = [], np.eye(len(a))
    while rest.shape[1]:
        _, sizes, rows = np.linalg.svd(rest.T @ a @ rest)
        rank = int(np.sum(sizes > smallest))
        if rank == len(sizes):
            break
        levels.append(rest @ rows[rank:].T)
        rest = rest @ rows[:rank].T
    return levels, rest


def zero_modes(system: Scaled, levels: Sequence[NDArray]) -> list[Mode]:
    """One mode for each motion without a restoring force, named after its coordinate.

    A mode that keeps its rate, because nothing damps it, represents two eigenvalues.
    """
    if not levels:
        return []
    free = system.shapes(levels[0])
    # A maps these states to a free motion: they are the rate of that motion.
    drifting = system.shapes(levels[1], rates=True) if len(levels) > 1 else free[:, :0]
    modes: list[Mode] = []
    taken: list[int] = []
    for basis in (drifting, free):
        directions, pivots = named_directions(system, basis, taken)
        for direction, pivot in zip(directions.T, pivots, strict=True):
            multiplicity = sum(level.shape[1] > len(taken) for level in levels)
            modes.append(Mode(FREE, 0j, multiplicity, system.names[pivot], normalised(direction)))
            taken.append(pivot)
    return sorted(modes, key=lambda mode: system.names.index(mode.coordinate))


def named_directions(system: Scaled, basis: NDArray, without: Sequence[int]) -> tuple[NDArray, list[int]]:
    """Directions in the span of `basis` that are zero at `without`, each 1 at its own coordinate.

    The coordinate with the largest share in the span is taken, and the first of equal shares. States of a
    drive come before all coordinates: if one is free, the coordinates follow it.
    """
    weights = np.sqrt(system.share(np.ones(len(basis))))
    largest = weights.max(initial=1.0)
    weights[len(system.mass) :] = FIRST * largest
    weights[system.memory] = LAST * largest
    span = np.linalg.qr(weights[:, None] * basis)[0]
    pivots: list[int] = []
    kept = cleared(span, without)
    left = kept
    while left.shape[1]:
        shares = np.sum(left**2, axis=1)
        pivot = int(np.argmax(shares > shares.max() - ALIKE))
        pivots.append(pivot)
        left = cleared(left, [pivot])
    if not pivots:
        return basis[:, :0], []
    directions = np.linalg.solve(kept[pivots].T, kept.T).T / weights[:, None]
    return directions * weights[pivots], pivots


def cleared(span: NDArray, rows: Sequence[int]) -> NDArray:
    """Basis of the vectors in the span of an orthonormal basis that are zero at `rows`."""
    if not rows or not span.shape[1]:
        return span
    _, sizes, turned = np.linalg.svd(span[list(rows)])
    return span @ turned[int(np.sum(sizes > ALIKE)) :].T


def other_modes(system: Scaled, zero: NDArray) -> list[Mode]:
    """Modes outside the span of `zero`; eigenvalues below the rounding error count as zero.

    Memory states have units in which their entries of A are large, and rounding would hide slow motions: here
    they are balanced with the other states.
    """
    n = len(system.a) - len(system.further)
    units = np.concatenate([np.ones(n), balanced(system.a, np.ones(len(system.further), bool))])
    a = system.a * units / units[:, None]
    basis = np.linalg.qr(zero / units[:, None], mode="complete")[0]
    zero, rest = basis[:, : zero.shape[1]], basis[:, zero.shape[1] :]
    inside = rest.T @ a @ rest
    values, vectors = np.linalg.eig(inside)
    lefts = left_vectors(inside, values)
    # The effect of rounding in A on an eigenvalue, times the product of its vectors (Golub & Van Loan, Matrix
    # Computations, 7.2.2).
    rounding = 10 * len(a) * np.finfo(float).eps * np.linalg.norm(a, 2)
    inner, coupling = zero.T @ a @ zero, zero.T @ a @ rest
    further = system.memory[len(system.mass) :]
    named = np.concatenate([np.ones(len(system.mass)), np.any(a[:, n:] != 0.0, axis=0)])
    modes = []
    for value, vector, left in zip(values, vectors.T, lefts, strict=True):
        if value.imag < 0:
            continue
        error = rounding / max(across(left, vector), SMALLEST_PRODUCT)
        if not value.imag and abs(value) < error:
            value = 0.0
        along_zero = np.linalg.pinv(value * np.eye(len(inner)) - inner) @ (coupling @ vector)
        state = rest @ vector + zero @ along_zero
        shape = normalised(system.shapes(units * state), len(system.mass))
        real = value.real if abs(value.real) > error else 0.0
        eigenvalue = complex(real, value.imag)
        name = system.names[int(np.argmax(named * system.share(shape)))]
        share = memory_share(rest @ left, state, further)
        modes.append(Mode(kind(eigenvalue), eigenvalue, 1 + (value.imag > 0), name, shape, share))
    return modes


def across(left: NDArray, right: NDArray) -> float:
    """Product of a left and a right vector after both are normalised."""
    return abs(left @ right) / (np.linalg.norm(left) * np.linalg.norm(right))


def left_vectors(a: NDArray, values: NDArray) -> NDArray:
    """Left eigenvectors: rows l with l A = lambda l, for eigenvalues in this order.

    The inverse of the matrix of right vectors would give them too. But filters in series have one vector for
    several equal eigenvalues, and the inverse is then wrong for all other modes.
    """
    found, lefts = np.linalg.eig(a.T)
    return np.array([lefts[:, np.abs(found - value).argmin()] for value in values])


def memory_share(left: NDArray, state: NDArray, further: NDArray[np.bool_]) -> float:
    """Participation of the memory states in a mode (Perez-Arriaga, Verghese & Schweppe, 1982); if the mode
    has no left vector, as with filters in series, their share of the motion."""
    if across(left, state) > SMALLEST_PRODUCT:
        parts = (left * state / (left @ state)).real
    else:
        parts = np.abs(state) ** 2 / np.sum(np.abs(state) ** 2)
    return float(np.clip(parts[len(state) - len(further) :][further].sum(), 0.0, 1.0))


def kind(eigenvalue: complex) -> str:
    """Kind of the motion of an eigenvalue."""
    if not eigenvalue:
        return FREE
    if eigenvalue.real > 0:
        return UNSTABLE
    return OSCILLATION if eigenvalue.imag else DECAY


def normalised(shape: NDArray, coordinates: int | None = None) -> NDArray[np.complex128]:
    """A shape scaled so that its largest entry is 1; the entry is one of the first `coordinates` if any of
    them moves."""
    among = shape[:coordinates]
    if not among.size or np.abs(among).max() <= ALIKE * np.abs(shape).max():
        among = shape
    shape = shape / among[np.argmax(np.abs(among))]
    # Set rounding errors to zero.
    return np.where(np.abs(shape) < 1e-14, 0.0, shape).astype(complex)

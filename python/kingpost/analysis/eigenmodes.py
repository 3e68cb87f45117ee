"""Eigenvalues of a linearised system as modes: free, oscillating, decaying, unstable.

Before any eigenvalue is computed the states are scaled by the mass matrix, so that metres and
radians compare by the kinetic energy of their motion, and what is exactly free is split off.
Without that the zero eigenvalues of a body that drifts, which come in pairs with one eigenvector,
would scatter by the square root of rounding.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..simulation.linear import Linearization

FREE, OSCILLATION, DECAY, UNSTABLE = "zero", "oscillation", "decay", "unstable"
"""Kinds of modes, in the order in which they are listed where eigenvalues are equal."""

SMALLEST_SHARE = 1e-13
"""Squared frequencies below this share of the largest count as zero: rounding hides them."""
SMALLEST_SQUARE = 1e-10
"""Squared frequencies below this count as zero, (rad/s)^2: a period of a week."""
FIRST = 1e3
"""Weight of what a drive keeps, beside the largest of a coordinate, in naming zero modes."""
LAST = 1e-6
"""Weight of states that only remember, in naming zero modes: they follow where a hull is."""
BALANCINGS = 20
"""Sweeps over the units of further states."""
SMALLEST_PRODUCT = 1e-6
"""Left and right vectors that are across each other by less are of different modes of equal eigenvalue."""
ALIKE = 1e-9
"""Shares that differ by less are equal, and the first is taken."""


@dataclass(frozen=True)
class Mode:
    """One motion that the linearised system makes by itself, ``shape exp(eigenvalue t)``.

    Attributes
    ----------
    kind
        ``zero``, ``oscillation``, ``decay`` or ``unstable``.
    eigenvalue
        1/s; of a complex pair the one with the positive imaginary part.
    multiplicity
        How many eigenvalues of A it stands for: 2 for a pair, and for a zero mode that keeps any
        rate that it is given.
    coordinate
        Its name: for a zero mode the coordinate that is free, otherwise the one with the largest
        share in the kinetic energy.
    shape
        Amplitudes by coordinate and then by further state, each in its unit; the largest is 1.
    memory_share
        What the states that remember radiated waves take part in it, by their participation factors
        (Perez-Arriaga, Verghese & Schweppe, *IEEE Trans. PAS* 101(9), 1982): those of all states add
        up to 1, whatever their units.
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
        The system; its modes mean what one expects where its rates are zero.
    mass
        Reduced mass matrix M* of its free coordinates.
    constraints
        J of the closed loops over its free coordinates, a row for each constraint. Modes move so
        that J xi = 0; at rest A takes such motions to such again.
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
    """A system in states whose squares are energies: ``w y``, ``y'``, the rest.

    `memory` says which of the names only remember. With M* = L L^T and columns N, orthonormal, of what
    J L^-T takes to nothing, the coordinates are xi = L^-T N y: independent, and y'^2 / 2 is the kinetic
    energy. With w the largest frequency, A then has entries near w in the blocks that store energy.
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
        # Where nothing is stiff, 1 rad/s is as good as any other.
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
        """Amplitudes by coordinate and further state of scaled states in columns; or their rates."""
        states, n = self.from_scaled @ scaled, len(self.mass)
        start = n if rates else 0
        return np.concatenate([states[start : start + n], states[2 * n :]])

    def share(self, shape: NDArray) -> NDArray[np.float64]:
        """Weights by name: of a coordinate its energy at that amplitude, of a state its scaled square."""
        weights = np.concatenate([np.diag(self.mass), self.further**-2.0])
        return weights[:, None] * np.abs(shape) ** 2 if shape.ndim > 1 else weights * np.abs(shape) ** 2


def balanced(a: NDArray, counts: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Units of the last states of A in which those that count have rows as large as their columns.

    Thrusts in N would drown what is in m (Osborne, *J. ACM* 7(4), 1960), powers of 2 as in LAPACK's gebal.
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
    """Orthonormal columns that a matrix of independent rows takes to nothing."""
    return np.linalg.qr(matrix.T, mode="complete")[0][:, len(matrix) :]


def zero_levels(a: NDArray, smallest: float) -> tuple[list[NDArray], NDArray]:
    """Bases of what A takes to nothing, then of what it takes there, and so on; and of the rest.

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
    """One mode for each way to move that nothing answers, named after its coordinate.

    Those that keep a rate, since nothing damps it, stand for two eigenvalues.
    """
    if not levels:
        return []
    free = system.shapes(levels[0])
    # What A takes to a free motion is that motion's rate.
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

    A coordinate is taken for its share in the span, the first where shares are alike. What a drive
    keeps comes before all coordinates: where it is free, they follow it.
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
    """The part of an orthonormal basis' span that is zero at `rows`."""
    if not rows or not span.shape[1]:
        return span
    _, sizes, turned = np.linalg.svd(span[list(rows)])
    return span @ turned[int(np.sum(sizes > ALIKE)) :].T


def other_modes(system: Scaled, zero: NDArray) -> list[Mode]:
    """Modes beside those of the span of `zero`: what rounding hides among them is zero too.

    What remembers waves has units in which its entries of A are large, and rounding would hide slow motions:
    here it is balanced with the rest.
    """
    n = len(system.a) - len(system.further)
    units = np.concatenate([np.ones(n), balanced(system.a, np.ones(len(system.further), bool))])
    a = system.a * units / units[:, None]
    basis = np.linalg.qr(zero / units[:, None], mode="complete")[0]
    zero, rest = basis[:, : zero.shape[1]], basis[:, zero.shape[1] :]
    inside = rest.T @ a @ rest
    values, vectors = np.linalg.eig(inside)
    lefts = left_vectors(inside, values)
    # What rounding in A does to an eigenvalue, times the product of its vectors (Golub & Van Loan, Matrix
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
    """The product of a left and a right vector, as if both were of length 1."""
    return abs(left @ right) / (np.linalg.norm(left) * np.linalg.norm(right))


def left_vectors(a: NDArray, values: NDArray) -> NDArray:
    """Rows l with l A = lambda l, for eigenvalues in this order.

    The inverse of all right vectors would give them too, but filters in a row have one vector for several
    equal eigenvalues, and then it is wrong for all others.
    """
    found, lefts = np.linalg.eig(a.T)
    return np.array([lefts[:, np.abs(found - value).argmin()] for value in values])


def memory_share(left: NDArray, state: NDArray, further: NDArray[np.bool_]) -> float:
    """What states that only remember take part in a mode (Perez-Arriaga, Verghese & Schweppe, 1982); of what
    has no left vector of its own, as filters in a row, their share of the motion."""
    if across(left, state) > SMALLEST_PRODUCT:
        parts = (left * state / (left @ state)).real
    else:
        parts = np.abs(state) ** 2 / np.sum(np.abs(state) ** 2)
    return float(np.clip(parts[len(state) - len(further) :][further].sum(), 0.0, 1.0))


def kind(eigenvalue: complex) -> str:
    """What a motion of an eigenvalue does."""
    if not eigenvalue:
        return FREE
    if eigenvalue.real > 0:
        return UNSTABLE
    return OSCILLATION if eigenvalue.imag else DECAY


def normalised(shape: NDArray, coordinates: int | None = None) -> NDArray[np.complex128]:
    """A shape whose largest entry is 1: among its first `coordinates`, if any of them moves."""
    among = shape[:coordinates]
    if not among.size or np.abs(among).max() <= ALIKE * np.abs(shape).max():
        among = shape
    shape = shape / among[np.argmax(np.abs(among))]
    # What rounding left of zero.
    return np.where(np.abs(shape) < 1e-14, 0.0, shape).astype(complex)

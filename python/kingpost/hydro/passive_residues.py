"""Residues of a symmetric, positive real matrix of transfer functions with given poles.

K(s) = sum over poles of R / (s - p), a complex pole with its conjugate, is the memory of the water:
strictly proper, K(0) = 0, K = K^T, and passive: Re K(j omega) has no negative eigenvalue at any
omega, so that the water only absorbs energy (Z. Yu and J. Falnes, "State-space modelling
of a vertical cylinder in heave", Applied Ocean Research 17, 1995; T. Perez and T. I. Fossen,
"Time- vs. frequency-domain identification of parametric radiation force models", Modeling,
Identification and Control 29(1), 2008, list these properties).

With fixed poles all these conditions are convex in the residues: K(0) = 0 is a linear equation, and every
frequency and direction v gives the linear inequality v^T Re K(j omega) v >= 0. B. Gustavsen and
A. Semlyen, "Enforcing passivity for admittance matrices approximated by rational functions", IEEE
Transactions on Power Systems 16(1), 2001, perturb the residues under such inequalities; here the fit
itself is solved under them, and inequalities are added where the last fit violates one, until none
is violated (cutting planes, J. E. Kelley, SIAM Journal 8, 1960).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .least_squares import least_distance
from .passivity import violations
from .vector_fitting import Array, ComplexArray, columns, partial_fractions, residues

ROUNDS, ROUNDS_OF_SEVERAL = 60, 150
# Lower bound of the eigenvalues of the scaled Re K, relative to a peak of K of 1. Half of it is enough: the
# wider the bound, the fewer rounds twelve motions need. It changes Re K by a quarter of itself at most.
MARGIN, MARGIN_OF_SEVERAL = 1e-5, 2e-4
REFINEMENTS = 4
POINTS, NEAR_A_POLE = 1500, 41
# Number of the lowest points that are refined, or made constraints, at a time.
AT_ONCE = 60


@dataclass(frozen=True)
class Grid:
    """Frequencies at which passivity is checked: from 0 to infinity, the ends by their limits."""

    centre: float
    omega: Array

    @classmethod
    def of(
        cls, poles: ComplexArray, omega: Array, points: int = POINTS, near_a_pole: int = NEAR_A_POLE
    ) -> Grid:
        """omega = centre tan(theta), even in theta, with more points around every pole."""
        centre = float(np.sqrt(omega[0] * omega[-1]))
        even = centre * np.tan(np.linspace(0.0, 0.5 * np.pi, points + 1)[:-1])
        near = [
            pole.imag + abs(pole.real) * np.linspace(-3.0, 3.0, near_a_pole)
            for pole in poles
            if pole.imag > 0.0
        ]
        return cls(centre, np.unique(np.abs(np.concatenate([even, *near]))))

    def about(self, lowest: NDArray[np.intp]) -> Grid:
        """Add twenty points on either side of each given frequency."""
        last = len(self.omega) - 1
        low, high = self.omega[np.maximum(lowest - 1, 0)], self.omega[np.minimum(lowest + 1, last)]
        return Grid(self.centre, np.unique(np.append(self.omega, np.linspace(low, high, 41))))

    def joined(self, omega: Array) -> Grid:
        """Add frequencies."""
        return Grid(self.centre, np.unique(np.append(self.omega, omega)))

    def scaled_real_part(self, poles: ComplexArray) -> Array:
        """Columns of Re K(j omega) (centre/omega + omega/centre)^2 for K(0) = 0; the last row is the limit at
        infinity.

        Re K falls with omega^2 towards 0 and with omega^-2 towards infinity. With K(0) = 0 no differences of
        nearly equal numbers are needed: below the centre 1/(s-p) may be replaced by s^2/(p^2 (s-p)),
        above it by p/(s (s-p)), the rest being imaginary or zero in the sum.
        """
        square, omega = self.centre**2, self.omega
        low, high = omega[omega <= self.centre], omega[omega > self.centre]
        slow = columns(poles, lambda p: -((square + low**2) ** 2) / (square * p**2 * (1j * low - p)))
        growth = (square + high**2) ** 2 / (square * high**2)
        fast = columns(poles, lambda p: growth * p / (1j * high * (1j * high - p)))
        last = columns(poles, lambda p: np.array([-p / square]))
        return np.vstack([slow.real, fast.real, last.real])


@dataclass(frozen=True)
class Problem:
    """Data of the fit: entries (i, j), i <= j, of a symmetric matrix of `size` rows.

    Attributes
    ----------
    omega, responses, weights
        (frequency), (frequency, entry) complex, (frequency).
    tail_omega, tail_real, tail_weights
        Beyond the data only the real part is fitted: (frequency), (frequency, entry), (frequency).
    verified
        Passivity is imposed on a coarse grid of frequencies and verified between them by the eigenvalues of a
        Hamiltonian matrix (`passivity`); else it is imposed on a fine grid.
    """

    size: int
    entries: tuple[tuple[int, int], ...]
    omega: Array
    responses: ComplexArray
    weights: Array
    tail_omega: Array
    tail_real: Array
    tail_weights: Array
    verified: bool = False

    @property
    def margin(self) -> float:
        """Lower bound of the eigenvalues; half of it is enough."""
        return MARGIN_OF_SEVERAL if self.verified else MARGIN

    def grid(self, poles: ComplexArray) -> Grid:
        """The first grid of frequencies at which passivity is imposed."""
        if self.verified:
            return Grid.of(poles, self.omega, POINTS // 5, NEAR_A_POLE // 3)
        return Grid.of(poles, self.omega)


def zero_at_zero(poles: ComplexArray) -> Array:
    """Orthonormal columns that span the unknowns with K(0) = sum r / (-p) = 0."""
    row = columns(poles, lambda p: np.array([-1.0 / p])).real
    return np.linalg.svd(row)[2][1:].T


def best_residues(poles: ComplexArray, problem: Problem) -> ComplexArray:
    """Residues (pole, size, size) of the best fit with K(0) = 0, passive or not."""
    span = zero_at_zero(poles)
    return _matrices(poles, span @ _unconstrained(poles, problem, span)[1], problem)


def passive_residues(poles: ComplexArray, problem: Problem) -> ComplexArray | None:
    """Residues (pole, size, size) of the best passive fit; `None` if no fit with these poles is passive."""
    span = zero_at_zero(poles)
    triangle, best = _unconstrained(poles, problem, span)
    doubled = np.array([1.0 if i == j else np.sqrt(2.0) for i, j in problem.entries])
    cuts, bounds = np.zeros((0, best.size)), np.zeros(0)
    unknowns, grid, refinements = best, problem.grid(poles), 0
    real_part = grid.scaled_real_part(poles) @ span
    margin = problem.margin
    for _ in range(ROUNDS_OF_SEVERAL if problem.verified else ROUNDS):
        values, vectors = np.linalg.eigh(_symmetric(real_part @ unknowns, problem))
        lowest = _lowest_points(values)
        if not (values < 0.5 * margin).any():
            if not problem.verified and refinements < REFINEMENTS:
                refinements, grid = refinements + 1, grid.about(np.unique(lowest[:, 0]))
            else:
                found = _matrices(poles, span @ unknowns, problem)
                missed = violations(poles, found) if problem.verified else np.zeros(0)
                if not missed.size:
                    return found
                grid = grid.joined(missed)
            real_part = grid.scaled_real_part(poles) @ span
            continue
        at = [(k, vectors[k, :, mode]) for k, mode in lowest if values[k, mode] < 0.5 * margin]
        # z = doubled triangle (y - best) of each entry turns the sum of squares into |z|^2.
        whitened = np.linalg.solve(triangle.T, real_part[[k for k, _ in at]].T).T
        for (k, v), row in zip(at, whitened, strict=True):
            factors = np.array([v[i] * v[j] * (1.0 if i == j else 2.0) for i, j in problem.entries])
            cut = ((factors / doubled)[:, None] * row).ravel()
            length = np.linalg.norm(cut)
            cuts = np.vstack([cuts, cut / length])
            bounds = np.append(bounds, (margin - real_part[k] @ best @ factors) / length)
        shortest = least_distance(cuts, bounds)
        if shortest is None:
            return None
        # Inactive constraints are dropped; they are added again if needed.
        touching = cuts @ shortest - bounds < 1e-9
        cuts, bounds = cuts[touching], bounds[touching]
        unknowns = best + np.linalg.solve(triangle, shortest.reshape(len(doubled), -1).T / doubled)
    return None


def _lowest_points(values: Array) -> NDArray[np.intp]:
    """(point, eigenvalue) of the lowest local minima along the grid."""
    fence = np.full((1, values.shape[1]), np.inf)
    padded = np.vstack([fence, values, fence])
    minima = np.argwhere((values <= padded[:-2]) & (values < padded[2:]))
    return minima[np.argsort(values[minima[:, 0], minima[:, 1]], kind="stable")[:AT_ONCE]]


def _unconstrained(poles: ComplexArray, problem: Problem, span: Array) -> tuple[Array, Array]:
    """The triangular factor of the weighted least squares and its solution, a column for each entry."""
    inside = problem.weights[:, None] * partial_fractions(poles, 1j * problem.omega)
    beyond = problem.tail_weights[:, None] * partial_fractions(poles, 1j * problem.tail_omega)
    right = problem.weights[:, None] * problem.responses
    tail = problem.tail_weights[:, None] * problem.tail_real
    matrix = np.vstack([inside.real, inside.imag, beyond.real]) @ span
    orthogonal, triangle = np.linalg.qr(matrix)
    return triangle, np.linalg.solve(triangle, orthogonal.T @ np.vstack([right.real, right.imag, tail]))


def _symmetric(values: Array, problem: Problem) -> Array:
    """(.., size, size) from (.., entry)."""
    found = np.zeros((*values.shape[:-1], problem.size, problem.size), values.dtype)
    for entry, (i, j) in enumerate(problem.entries):
        found[..., i, j] = found[..., j, i] = values[..., entry]
    return found


def _matrices(poles: ComplexArray, unknowns: Array, problem: Problem) -> ComplexArray:
    return _symmetric(residues(poles, unknowns), problem)

"""The eigenvalues of the Hamiltonian matrix decide passivity as sampled eigenvalues do; fits under it."""

from __future__ import annotations

import numpy as np
import pytest
from kingpost.hydro.passive_residues import Problem, best_residues, passive_residues
from kingpost.hydro.passivity import EPSILON, lowest_eigenvalues, violations
from kingpost.hydro.vector_fitting import common_poles

CASES = range(30)
OMEGA = np.concatenate([np.linspace(0.0, 10.0, 4001), np.geomspace(10.0, 1e3, 400)])


def bandpasses(seed: int, size: int = 4, count: int = 4):
    """Poles and residues of a sum of band passes w s / (s^2 + 2 z w s + w^2) times random positive matrices
    of rank 2: passive, with eigenvalues near zero."""
    random = np.random.default_rng(seed)
    natural, damping = random.uniform(0.4, 3.0, count), random.uniform(0.03, 0.5, count)
    poles = natural * (-damping + 1j * np.sqrt(1 - damping**2))
    # The residue of w s / ((s - p)(s - p*)) at p.
    gains = natural * poles / (2j * poles.imag)
    roots = random.normal(size=(count, size, 2))
    return poles, gains[:, None, None] * (roots @ roots.transpose(0, 2, 1))


@pytest.mark.parametrize("seed", CASES)
def test_violations_are_found_where_sampled_eigenvalues_are_negative(seed) -> None:
    poles, residues = bandpasses(seed)
    peak = np.abs(residues).max() / np.abs(poles.real).min()
    random = np.random.default_rng(seed + 1000)
    noise = random.normal(size=residues.shape) * random.choice([0.0, 1e-3, 1e-2]) * peak
    residues = (residues + noise + noise.transpose(0, 2, 1)) / peak
    sampled = lowest_eigenvalues(poles, residues, OMEGA)
    found = violations(poles, residues)
    assert bool(found.size) == bool(sampled.min() < -EPSILON)
    assert (lowest_eigenvalues(poles, residues, found) < -EPSILON).all()


@pytest.mark.parametrize("seed", CASES)
def test_fits_to_noisy_samples_of_passive_systems_are_passive_everywhere(seed) -> None:
    poles, residues = bandpasses(seed)
    omega = np.linspace(0.2, 5.0, 40)
    at = 1j * omega[:, None]
    response = np.tensordot(1 / (at - poles), residues, 1) + np.tensordot(
        1 / (at - poles.conj()), residues.conj(), 1
    )
    random = np.random.default_rng(seed)
    noise = 0.03 * np.abs(response).max() * random.normal(size=response.shape)
    response = (response + noise + noise.transpose(0, 2, 1)) / np.abs(response).max()
    entries = tuple((i, j) for i in range(4) for j in range(i, 4))
    none = np.zeros(0)
    problem = Problem(4, entries, omega, np.stack([response[:, i, j] for i, j in entries], axis=1),
                      np.ones(40), none, np.zeros((0, 10)), none, verified=True)  # fmt: skip
    fitted = common_poles(problem.responses, omega, problem.weights, 8)
    found = passive_residues(fitted, problem)
    assert found is not None
    assert not violations(fitted, found).size
    assert lowest_eigenvalues(fitted, found, OMEGA).min() > -EPSILON
    # Mended, not spoilt: within the noise of the best fit.
    best, at = best_residues(fitted, problem), 1j * omega[:, None]
    change = np.tensordot(1 / (at - fitted), found - best, 1)
    assert np.abs(change).max() < 0.2

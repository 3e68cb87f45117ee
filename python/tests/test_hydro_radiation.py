"""The fitted memory of the water: exact recovery, its physical properties, the decay of a sphere."""

from __future__ import annotations

from dataclasses import replace

import hydro_samples as samples
import numpy as np
import pytest
from kingpost.errors import HydrodynamicsError
from kingpost.hydro import memory, radiation_fit
from kingpost.hydro.least_squares import least_distance


def beyond_the_data() -> np.ndarray:
    """0 to 10^4 rad/s, finely."""
    return np.concatenate([np.linspace(0.0, 20.0, 8001), np.geomspace(20.0, 1e4, 2000)])


def lowest_eigenvalue(radiation, omega) -> float:
    """Of (K + K^H) / 2, K scaled to the largest of its diagonal; motions without memory left out."""
    response = radiation_fit.evaluate(radiation, omega)
    peaks = np.abs(np.einsum("nii->ni", response)).max(axis=0)
    kept = np.flatnonzero(peaks)
    scaled = response[:, kept][:, :, kept] / np.sqrt(np.outer(peaks, peaks))[kept][:, kept]
    return float(np.linalg.eigvalsh(0.5 * (scaled + scaled.conj().transpose(0, 2, 1))).min())


def bandpasses():
    """The rational sample as a database: its infinite added mass is at will."""
    omega = np.geomspace(0.05, 60.0, 160)
    response = samples.memory_of_bandpasses(omega)
    infinite = np.diag([3e5, 3e5, 3e5, 0.0, 7e6, 0.0])
    added_mass = infinite + response.imag / omega[:, None, None]
    return samples.database(omega, added_mass, response.real, infinite)


def test_a_rational_memory_is_recovered() -> None:
    # Vector fitting is exact for what is rational of that order; rounding times its condition is left.
    radiation = radiation_fit.fit(bandpasses(), limit=1e-6)
    omega = np.geomspace(1e-3, 1e3, 500)
    exact = samples.memory_of_bandpasses(omega)
    peaks = np.abs(exact).max(axis=0) + 1.0
    assert (np.abs(radiation_fit.evaluate(radiation, omega) - exact) / peaks).max() < 1e-6
    assert [len(mode.poles_rad_s) for mode in radiation.modes] == [4, 2, 4, 0, 4, 0]


def test_progress_of_a_fit_grows_from_nothing_to_all() -> None:
    shares: list[float] = []
    radiation_fit.fit(bandpasses(), limit=1e-6, progress=shares.append)
    assert shares[0] == 0.0
    assert shares[-1] == 1.0
    assert shares == sorted(shares)
    assert len(shares) > 3


def test_couplings_that_are_zero_stay_zero() -> None:
    radiation = radiation_fit.fit(bandpasses())
    response = radiation_fit.evaluate(radiation, np.linspace(0, 10, 50))
    group, rest = [0, 2, 4], [1, 3, 5]
    assert (response[:, group][:, :, rest] == 0).all()
    assert (response[:, rest][:, :, group] == 0).all()
    assert (response[:, 3] == 0).all()
    assert (response[:, 5] == 0).all()


def test_the_matrix_is_symmetric() -> None:
    response = radiation_fit.evaluate(radiation_fit.fit(bandpasses()), np.linspace(0, 10, 50))
    np.testing.assert_allclose(response, response.transpose(0, 2, 1), rtol=1e-12)


def noisy():
    """The rational sample with five per cent of noise, symmetric: the best fit is not passive by itself."""
    database = bandpasses()
    kept = (database.frequencies_rad_s > 0.2) & (database.frequencies_rad_s < 5.0)
    random = np.random.default_rng(5)
    noise = 1 + 0.05 * random.standard_normal(database.radiation_damping.shape)
    damping = database.radiation_damping * (noise + noise.transpose(0, 2, 1)) / 2
    return replace(
        database,
        frequencies_rad_s=database.frequencies_rad_s[kept],
        added_mass=database.added_mass[kept],
        radiation_damping=damping[kept],
    )


@pytest.mark.parametrize("make", [samples.floating_hemisphere, bandpasses, noisy])
def test_the_model_is_stable_and_passive_and_does_not_resist_a_steady_drift(make) -> None:
    limit = 0.12 if make is noisy else 0.02
    radiation = radiation_fit.fit(make(), limit=limit)
    assert radiation.fit_error <= limit
    poles = np.concatenate([mode.poles_rad_s for mode in radiation.modes])
    assert (poles.real < 0).all()
    assert (poles.imag >= 0).all()
    assert lowest_eigenvalue(radiation, beyond_the_data()) > -1e-12  # rounding
    still = np.abs(radiation_fit.evaluate(radiation, np.zeros(1))).max()
    assert still < 1e-13 * np.abs(radiation_fit.evaluate(radiation, np.linspace(0, 5, 100))).max() * 10


def test_the_memory_never_generates_energy() -> None:
    # W(t) = integral of nu^T K*nu from rest; exact for velocities constant over a step.
    radiation = radiation_fit.fit(noisy(), limit=0.12)
    random, step, steps = np.random.default_rng(11), 0.05, 4000
    scale = np.array([1.0, 1.0, 1.0, 0.2, 0.2, 0.2])
    for _ in range(5):
        colour = random.uniform(0.0, 0.95)
        velocity, work, least, most = np.zeros(6), 0.0, 0.0, 0.0
        states = [np.zeros(len(mode.poles_rad_s), complex) for mode in radiation.modes]
        for _ in range(steps):
            velocity = colour * velocity + random.standard_normal(6) * scale
            impulse = np.zeros(6)
            for motion, mode in enumerate(radiation.modes):
                p = mode.poles_rad_s
                twice = np.where(p.imag == 0.0, 1.0, 2.0)
                grown = np.exp(p * step)
                held = (grown - 1.0) / p
                # x' = p x + nu: its integral over the step gives the mean force.
                integral = held * states[motion] + (held - step) / p * velocity[motion]
                impulse += (twice * integral @ mode.residues).real
                states[motion] = grown * states[motion] + held * velocity[motion]
            work += velocity @ impulse
            least, most = min(least, work), max(most, work)
        assert most > 0.0
        assert least >= -1e-12 * most


def test_the_impulse_response_is_the_cosine_transform_of_the_damping() -> None:
    # Fifteen frequencies: piecewise cubics of the damping are off by about half a per cent between them.
    database = samples.floating_hemisphere()
    t = np.linspace(0.0, 15.0, 151)
    direct = memory.retardation(database, t)[:, 2, 2]
    fitted = radiation_fit.impulse_response(radiation_fit.fit(database), t)[:, 2, 2]
    assert np.abs(fitted - direct).max() < 0.01 * direct[0]


def test_the_cosine_transform_of_a_band_pass_is_its_impulse_response() -> None:
    # k(t) = w exp(-a t) (cos(b t) - a/b sin(b t)), a = z w, b = w sqrt(1 - z^2), from tables of Laplace.
    natural, share = 1.2, 0.35
    a, b = share * natural, natural * np.sqrt(1 - share**2)
    t, omega = np.linspace(0.3, 12.0, 40), np.linspace(0.0, 400.0, 200001)
    s = 1j * omega
    damping = (natural * s / (s**2 + 2 * a * s + natural**2)).real
    exact = natural * np.exp(-a * t) * (np.cos(b * t) - a / b * np.sin(b * t))
    # What is cut off falls as w^-2; by parts its integral is at most damping(400) / t.
    limit = (2 / np.pi) * damping[-1] / t[0] + 1e-6
    assert np.abs(memory.cosine_transform(omega, damping, t) - exact).max() < limit


def decay_by_states(mode, mass, stiffness, step, steps):
    """The same with the fitted states: the matrix exponential's eighth-order series, a step at a time."""
    p, n = mode.poles_rad_s, len(mode.poles_rad_s)
    twice = np.where(p.imag == 0.0, 1.0, 2.0)
    matrix = np.zeros((2 + 2 * n, 2 + 2 * n))
    matrix[0, 1], matrix[1, 0] = 1.0, -stiffness / mass
    force = twice * mode.residues[:, 2]
    matrix[1, 2 : 2 + n], matrix[1, 2 + n :] = -force.real / mass, force.imag / mass
    matrix[2 : 2 + n, 1] = 1.0
    matrix[2 : 2 + n, 2 : 2 + n] = matrix[2 + n :, 2 + n :] = np.diag(p.real)
    matrix[2 : 2 + n, 2 + n :], matrix[2 + n :, 2 : 2 + n] = -np.diag(p.imag), np.diag(p.imag)
    term = propagator = np.eye(len(matrix))
    for power in range(1, 9):
        term = term @ matrix * (step / power)
        propagator = propagator + term
    state, found = np.eye(len(matrix))[0], [1.0]
    for _ in range(steps):
        state = propagator @ state
        found.append(state[0])
    return np.array(found)


def test_the_decay_of_a_sphere_agrees_with_direct_convolution() -> None:
    # A heaving sphere, radius 5 m, 261.8 t, dropped from 1 m: within half a per cent of the drop at every
    # extremum of ten seconds.
    database, step = samples.floating_hemisphere(), 0.01
    mass = 261.8e3 + database.added_mass_infinite[2, 2]
    stiffness = 1000.0 * 9.81 * np.pi * 5.0**2
    kernel = memory.retardation(database, step * np.arange(1001))[:, 2, 2]
    direct = samples.decay_by_convolution(kernel, mass, stiffness, step)
    fitted = decay_by_states(radiation_fit.fit(database).modes[2], mass, stiffness, step, 1000)
    extrema = 1 + np.flatnonzero(np.diff(np.sign(np.diff(direct))))
    assert len(extrema) == 4
    assert np.abs(fitted - direct)[extrema].max() < 0.005


def test_a_fit_that_misses_its_limit_gives_advice() -> None:
    with pytest.raises(HydrodynamicsError, match=r"an error of .* more frequencies or a wider range"):
        radiation_fit.fit(noisy(), limit=1e-4, most_states=8)
    with pytest.raises(HydrodynamicsError, match="at least 8 for a fit"):
        radiation_fit.fit(samples.floating_hemisphere(), highest_rad_s=1.0)


def test_frequencies_above_a_limit_can_be_left_out() -> None:
    database = samples.floating_hemisphere()
    spoiled = replace(database, added_mass=database.added_mass.copy())
    spoiled.added_mass[-1, 2, 2] *= 2.0
    with pytest.raises(HydrodynamicsError):
        radiation_fit.fit(spoiled, most_states=6)
    assert radiation_fit.fit(spoiled, highest_rad_s=4.0).fit_error < 0.02


def test_least_distance_meets_the_conditions_of_kuhn_and_tucker() -> None:
    """The shortest x is a sum of the rows that touch it, none taken negatively (Lawson & Hanson, 23.27)."""
    random = np.random.default_rng(2)
    for _ in range(20):
        rows, bounds = random.standard_normal((6, 9)), random.standard_normal(6)
        x = least_distance(rows, bounds)
        room = rows @ x - bounds
        assert (room > -1e-10).all()
        touching = rows[room < 1e-9]
        weights, *_ = np.linalg.lstsq(touching.T, x, rcond=None)
        assert (weights > 0).all()
        assert np.allclose(touching.T @ weights, x, atol=1e-10)


def test_least_distance_returns_none_without_a_solution() -> None:
    assert least_distance(np.array([[1.0], [-1.0]]), np.array([1.0, 1.0])) is None

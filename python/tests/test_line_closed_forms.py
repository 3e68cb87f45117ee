"""Lines with mass that move: closed forms of their waves, modes and forced motion."""

from __future__ import annotations

import itertools
from functools import cache
from typing import Any

import kingpost
import numpy as np
import pytest
from kingpost.verify.models import G, value
from line_cases import hanging, of_two_ends, section, set_velocity
from scipy.optimize import brentq
from scipy.special import erf, jv, yv

# A load of 20 t on 1000 m of wire, both on their way down at 0.5 m/s when the upper end is stopped.
LOAD_KG, LENGTH_M, SPEED_M_S = 20e3, 1000.0, 0.5
WIRE = section(LENGTH_M, 1)
MASS_KG_M, EA_N = WIRE["mass_kg_per_m"], WIRE["axial_stiffness_N"]
CELERITY_M_S = float(np.sqrt(EA_N / MASS_KG_M))
THERE_AND_BACK_S = 2 * LENGTH_M / CELERITY_M_S
JUMP_N = EA_N * SPEED_M_S / CELERITY_M_S


@cache
def stopped(elements: int, step_s: float, tau_s: float = 0.0) -> tuple[np.ndarray, np.ndarray]:
    """Times, and the tension at the stopped end beyond that at rest, over EA V / c."""
    part = section(LENGTH_M, elements, damping_time_s=tau_s)
    run = kingpost.Simulation(hanging(LOAD_KG, part, speed_m_s=-SPEED_M_S, step_s=step_s))
    set_velocity(run, elements, [0.0, 0.0, -SPEED_M_S])
    at_rest = (LOAD_KG + MASS_KG_M * LENGTH_M) * G
    found = []
    for _ in range(round(1.9 * THERE_AND_BACK_S / step_s)):
        run.step(1)
        found.append((run.time_s, (value(run, "line_tension", "line") - at_rest) / JUMP_N))
    return tuple(np.array(found).T)  # type: ignore[return-value]


def by_dalembert(t: np.ndarray) -> np.ndarray:
    """The tension of `stopped` without damping: u = g(ct + x) - g(ct - x), with
    M c^2 (g''(y) - g''(y - 2L)) = -EA (g'(y) + g'(y - 2L)) at the load, over the first two ways there and
    back."""
    way = CELERITY_M_S * t / LENGTH_M - 2
    return np.where(way < 0, 1.0, 4 * np.exp(-MASS_KG_M * LENGTH_M / LOAD_KG * way) - 1)


def with_damping(t: np.ndarray, tau_s: float) -> np.ndarray:
    """The tension of `stopped` with EA (e + tau e'), by its Laplace transform.

    That of an endless bar is in closed form. The rest, what returns from the load, is smooth and is
    integrated along Re s = a; the sum has the period 2 P and the error exp(-2 a P)."""
    period_s, a = 2 * t[-1], 12 / t[-1]
    s = a + 1j * np.pi / period_s * np.arange(60_000)
    stiffness = EA_N * (1 + s * tau_s)
    q = s / (CELERITY_M_S * np.sqrt(1 + s * tau_s))
    back = np.exp(-2 * q * LENGTH_M)
    load = LOAD_KG * s**2
    ratio = (load * (1 + back) + stiffness * q * (1 - back)) / (
        load * (1 - back) + stiffness * q * (1 + back)
    )
    transform = stiffness * q * SPEED_M_S / s**2 * (ratio - 1) / JUMP_N
    transform[0] /= 2
    last = np.flatnonzero(np.abs(transform) > 1e-16 * np.abs(transform).max())[-1] + 1
    turned = np.exp(1j * np.outer(t, s[:last].imag)) @ transform[:last]
    endless = erf(np.sqrt(t / tau_s)) + np.exp(-t / tau_s) * np.sqrt(tau_s / (np.pi * t))
    return endless + turned.real * np.exp(a * t) / period_s


def test_a_moving_bar_whose_end_is_stopped_gets_the_tension_of_dalembert_to_first_order():
    """Source: d'Alembert's solution; Timoshenko & Goodier, Theory of Elasticity, 1970, art. on longitudinal
    impact of bars, here with a bar that moves too.

    Without damping the elements ring behind the front, so the impulse until a time is compared."""
    lost = []
    for elements, step_s in ((10, 4e-3), (20, 2e-3), (40, 1e-3), (80, 5e-4)):
        t, tension = stopped(elements, step_s)
        impulse = np.cumsum(tension - by_dalembert(t)) * step_s / THERE_AND_BACK_S
        lost.append(float(np.abs(impulse).max()))
    # Half an element and half a step at each front, one of 1 and one of 2: 0.05 L and 2e-3 s with the first
    # mesh, of 0.39 s. First order: each mesh has half the error of the last, with 30 % for the ringing.
    assert lost[0] < 0.5 * (2 * LENGTH_M / 10 / CELERITY_M_S + 4e-3) / THERE_AND_BACK_S
    assert all(fine < 0.65 * coarse for coarse, fine in itertools.pairwise(lost)), lost


def test_the_jump_at_the_stop_is_ea_v_over_c_in_the_mean_until_the_wave_returns():
    """Source: d'Alembert, T = EA V / c for 2 L / c."""
    t, tension = stopped(40, 1e-3)
    away = (t > 0.1 * THERE_AND_BACK_S) & (t < 0.9 * THERE_AND_BACK_S)
    # Ringing of 12 % with the time that a wave takes through an element, 5 ms, over 310 ms: 2e-3 at most.
    assert tension[away].mean() == pytest.approx(1.0, abs=2e-3)


def test_a_damped_bar_that_is_stopped_has_the_smooth_fronts_of_kelvin_and_voigt_to_second_order():
    """Source: Laplace transform of the bar of EA (1 + tau d/dt) with a load."""
    tau_s = 5e-3
    away, whole = [], []
    for elements, every in ((10, 1), (20, 2), (40, 4), (80, 8)):
        t, tension = (column[every - 1 :: every] for column in stopped(elements, 4e-3 / every, tau_s))
        errors = np.abs(tension - with_damping(t, tau_s))
        away.append(float(errors[(t > 0.1 * THERE_AND_BACK_S) & (t < 0.8 * THERE_AND_BACK_S)].max()))
        whole.append(float(errors[t > 0.1 * THERE_AND_BACK_S].max()))
    # The fronts are sqrt(tau t) = 40 ms wide: ten of the coarsest steps. Second order is a factor of 4.
    assert all(fine < coarse / 3.5 for coarse, fine in itertools.pairwise(whole)), whole
    assert whole[-1] < 2e-4
    assert away[-1] < 1e-4


def test_the_fronts_with_little_damping_are_those_of_dalembert():
    """Source: both closed forms above; away from fronts of a width of sqrt(tau t), 6 ms."""
    t = np.linspace(0.05, 0.72, 400)
    far = np.abs(t - THERE_AND_BACK_S) > 0.05
    # First order in tau: what the front carries lags by about tau, at a slope of 4 m L / M / (L / c).
    np.testing.assert_allclose(with_damping(t, 1e-4)[far], by_dalembert(t)[far], atol=4e-3)


CHAIN_M, CHAIN_KG_M, BOB_KG = 50.0, 20.0, 300.0


def bessel_modes(count: int) -> list[float]:
    """Frequencies of a chain with a bob, rad/s.

    With x the length below plus M / m, x y'' + y' + w^2 / g y = 0, so y is a sum of J0 and Y0 of
    2 w sqrt(x / g). At the bob -M w^2 y = M g y', which is J2 and Y2 by their recurrence."""
    at_bob = BOB_KG / CHAIN_KG_M

    def characteristic(w: float) -> float:
        top, bob = (2 * w * np.sqrt(x / G) for x in (at_bob + CHAIN_M, at_bob))
        return float(jv(0, top) * yv(2, bob) - yv(0, top) * jv(2, bob))

    grid = np.linspace(0.05, 12, 2000)
    signs = np.sign([characteristic(w) for w in grid])
    changes = np.flatnonzero(signs[:-1] * signs[1:] < 0)[:count]
    return [brentq(characteristic, grid[k], grid[k + 1], xtol=1e-14) for k in changes]


def test_a_chain_with_a_bob_has_bessels_frequencies_to_fourth_order():
    """Source: D. Bernoulli's chain; Rao, Vibration of Continuous Systems, 2007, ch. 8, with a bob."""
    part = {"mass_kg_per_m": CHAIN_KG_M, "axial_stiffness_N": 1e11}
    errors = []
    for elements in (8, 16, 32):
        found = kingpost.Simulation(hanging(BOB_KG, section(CHAIN_M, elements, **part), floats=True))
        frequencies = np.linalg.eigvals(found.linearize().A.values).imag
        errors.append([float(np.abs(frequencies / w - 1).min()) for w in bessel_modes(5)])
    # The chain stretches by 1.3e-7, which changes frequencies by half of it: below that the order is lost.
    stretch = (BOB_KG + CHAIN_KG_M * CHAIN_M) * G / 1e11
    for coarse, fine in itertools.pairwise(errors):
        for k, (before, after) in enumerate(zip(coarse, fine, strict=True)):
            # 16 times; modes of one wave in four elements are not yet there.
            assert after < max(before / 11, stretch), (k, coarse, fine)
    assert errors[-1][0] < stretch
    assert max(errors[-1]) < 2e-5


def test_modes_name_the_pendulum_that_a_chain_with_a_bob_is():
    """Source: the same characteristic equation; the lowest mode, in two planes."""
    part = section(CHAIN_M, 16, mass_kg_per_m=CHAIN_KG_M, axial_stiffness_N=1e8)
    found = kingpost.modes(hanging(BOB_KG, part, floats=True))
    lowest = found.angular_frequency.values[found.kind.values == "oscillation"][:2]
    np.testing.assert_allclose(lowest, bessel_modes(1)[0], rtol=1.3e-4)  # its stretch


SPAN_M = 100.0


def irvine(squared: float) -> tuple[list[float], list[float]]:
    """Dimensionless frequencies w L sqrt(m / H) in the plane, symmetric and antisymmetric, for Irvine's
    lambda^2."""

    def characteristic(w: float) -> float:
        return float(np.sin(w / 2) - np.cos(w / 2) * (w / 2 - 4 / squared * (w / 2) ** 3))

    grid = np.linspace(0.5, 20, 2000)
    signs = np.sign([characteristic(w) for w in grid])
    changes = np.flatnonzero(signs[:-1] * signs[1:] < 0)[:3]
    symmetric = [brentq(characteristic, grid[k], grid[k + 1], xtol=1e-14) for k in changes]
    return symmetric, [2 * np.pi, 4 * np.pi]


def sagging(squared: float, sag: float, elements: int) -> np.ndarray:
    """Frequencies in its plane of a cable with this lambda^2 and sag over span, over sqrt(H / m) / L.

    Its unstretched length is that of the elastic catenary with the horizontal force H = m g L / (8 sag)."""
    mass, steepness = 100.0, 8 * sag
    weight = mass * G
    pull = weight * SPAN_M / steepness
    stiffness = squared * pull * (1 + steepness**2 / 8) / steepness**2

    def across(length: float) -> float:
        arc = 2 * pull / weight * np.arcsinh(weight * length / 2 / pull)
        return float(pull * length / stiffness + arc - SPAN_M)

    length = brentq(across, 0.9 * SPAN_M, 1.1 * SPAN_M, xtol=1e-13)
    part = section(length, elements, mass_kg_per_m=mass, axial_stiffness_N=stiffness)
    linear = kingpost.Simulation(of_two_ends([0.0] * 3, [SPAN_M, 0.0, 0.0], part)).linearize()
    kept = [k for k, name in enumerate(linear.states) if "node" in name and not name.endswith(".y")]
    found = np.linalg.eigvals(linear.A.values[np.ix_(kept, kept)]).imag
    return np.sort(found[found > 1e-3]) * SPAN_M / np.sqrt(pull / mass)


@pytest.mark.parametrize("squared", [10.0, 100.0], ids=["below_crossover", "above_crossover"])
def test_a_cable_of_small_sag_has_irvines_modes_with_an_error_of_the_square_of_its_sag(squared):
    """Source: Irvine & Caughey, Proc. R. Soc. A 341, 1974, 299; Irvine, Cable Structures, 1981, ch. 3. The
    crossover, where the first symmetric mode is as high as the antisymmetric one, is at 4 pi^2."""
    symmetric, antisymmetric = irvine(squared)
    assert (symmetric[0] < antisymmetric[0]) == (squared < 4 * np.pi**2)
    errors = []
    for sag in (0.02, 0.01):
        found = sagging(squared, sag, 32)
        # They neglect the squares of slopes, whose mean is 16/3 of the squared sag. Elements: 2e-5.
        errors.append([float(np.abs(found / w - 1).min()) for w in symmetric + antisymmetric])
        assert max(errors[-1]) < 16 / 3 * sag**2 + 2e-5
    # Half the sag, a quarter of the largest error.
    assert max(errors[0]) / max(errors[1]) == pytest.approx(4.0, rel=0.1)


BAR_KG, DAMPING_S = 280e3, 0.05


def bar(length_m: float, elements: int, **more: Any) -> kingpost.Scenario:
    return hanging(BAR_KG, section(length_m, elements, damping_time_s=DAMPING_S), **more)


def wave_number(omega: float) -> tuple[complex, complex]:
    stiffness = EA_N * (1 + 1j * omega * DAMPING_S)
    return stiffness, omega * np.sqrt(MASS_KG_M / stiffness)


@pytest.mark.parametrize("length_m", [200.0, 1000.0, 3000.0])
def test_a_load_on_a_bar_answers_a_force_with_the_receptance_of_the_closed_form(length_m):
    """Source: EA k cot(k L) - M w^2 (Rao, Vibration of Continuous Systems, 2007, sec. 9.3)."""
    elements = 3
    linear = kingpost.Simulation(bar(length_m, elements)).linearize()
    kept = [k for k, name in enumerate(linear.states) if "line." not in name or name.endswith(".z")]
    matrix = linear.A.values[np.ix_(kept, kept)]
    # The load, and a sixth of the last element.
    force = np.zeros(len(kept))
    force[1] = 1 / (BAR_KG + MASS_KG_M * length_m / elements / 6)
    for period_s in (5.0, 8.0, 12.0, 16.0):
        omega = 2 * np.pi / period_s
        stiffness, number = wave_number(omega)
        found = np.linalg.solve(1j * omega * np.eye(len(kept)) - matrix, force)[0]
        ratio = found * (stiffness * number / np.tan(number * length_m) - BAR_KG * omega**2)
        # (k h)^4 / 720 of the bar's part, 5e-6 at 3000 m and 5 s, ten times as much near a resonance.
        bound = max(10 * abs(number * length_m / elements) ** 4 / 720, 1e-10)
        assert abs(ratio - 1) < bound, period_s
        assert abs(np.angle(ratio)) < bound, period_s


@cache
def forced(length_m: float, period_s: float, elements: int = 6, step_s: float = 0.05) -> list[complex]:
    """Harmonics over the closed form, of the load's motion and of the tension there, as the top moves."""
    periods = 24
    moves = {"amplitude_m": 0.05, "period_s": period_s, "ramp_s": periods * period_s / 2}
    duration = {"step_s": step_s, "record_every_s": step_s, "duration_s": periods * period_s}
    ds = kingpost.run(bar(length_m, elements, top={"oscillation": moves}, **duration))
    rows = round(period_s / step_s)
    turning = np.exp(-2j * np.pi * ds.time.values[-rows:] / period_s)
    columns = ds.joint_position.sel(coordinate="load"), ds.line_end_tension.sel(line="line")
    found = [2j / rows * (turning * column.values[-rows:]).sum() for column in columns]
    omega = 2 * np.pi / period_s
    stiffness, number = wave_number(omega)
    inertia = BAR_KG * omega**2 / (stiffness * number)
    load = 0.05 / (np.cos(number * length_m) - inertia * np.sin(number * length_m))
    return [found[0] / load, found[1] / (-BAR_KG * omega**2 * load)]


@pytest.mark.parametrize("length_m", [200.0, 1000.0, 3000.0])
@pytest.mark.parametrize("period_s", [5.0, pytest.param(8.0, marks=pytest.mark.thorough), 16.0])
def test_a_load_under_a_moving_top_follows_in_amplitude_and_phase(length_m, period_s):
    """Source: the bar with a mass (Rao, sec. 9.3). The engine's tests have the tension at the top."""
    motion, tension = forced(length_m, period_s)
    # The step gives (w h)^2 / 12 = 3e-4 at 5 s, what is left of the start some thousandths near resonance.
    for ratio in (motion, tension):
        assert abs(abs(ratio) - 1) < 0.01
        assert abs(np.angle(ratio)) < 0.01


def test_a_hanging_bar_of_any_number_of_elements_can_be_linearised():
    """Source: the same line is at rest without derivatives."""
    for elements in range(1, 25):
        kingpost.Simulation(bar(1000.0, elements)).linearize()


def test_the_tension_at_a_load_on_many_damped_elements_has_second_order_in_the_step():
    """Source: the bar with a mass (Rao, sec. 9.3): 200 m, 5 s, as above. At 50 ms damping of short elements
    between the scheme of the load and that of the nodes makes an error that grows with their number."""
    coarse, fine = (abs(forced(200.0, 5.0, 24, step_s=step_s)[1] - 1) for step_s in (0.05, 0.025))
    assert coarse < 0.015
    assert fine < coarse / 3.4

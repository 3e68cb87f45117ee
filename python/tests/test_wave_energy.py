"""The gyroscopic wave energy converter: its closed form in a flume, and the scenario of the gallery."""

from __future__ import annotations

import kingpost
import numpy as np
import pytest
from kingpost.verify import wave_energy
from kingpost.verify.wave_energy import generated_w

GALLERY = {"simulation.duration_s": 110.0}
PERIOD_S = 4.6
TEN_PERIODS = round(10 * PERIOD_S / 0.1)
"""In samples of the gallery's file."""


def test_no_tuning_absorbs_more_than_half_of_the_wave_power_in_a_flume() -> None:
    """Source: Evans 1976; the closed form itself, over four decades of damping and stiffness."""
    factors = np.logspace(-2, 2, 41)
    for omega in wave_energy.OMEGAS:
        best = wave_energy.best(omega)
        shares = [best.times(c, k).capture(omega) for c in factors for k in factors]
        assert best.capture(omega) == pytest.approx(0.5, abs=1e-12)
        assert min(shares) > 0.0
        assert max(shares) <= 0.5 + 1e-12


def test_the_absorbed_wave_power_equals_the_power_of_the_generators() -> None:
    """Source: conservation of energy over a period at steady state. The mean of 100 samples of a sinusoid is
    exact; RK4's error of a period is below 1e-6."""
    omega = 1.2
    gimbal = wave_energy.best(omega)
    run = wave_energy.in_a_wave(omega, gimbal)
    assert float(abs(run.energy_error).max()) < 1e-10 * float(run.kinetic_energy.max())
    period_s, steps = 2 * np.pi / omega, wave_energy.STEPS_OF_A_PERIOD
    generated = generated_w(run, 0.5 * gimbal.damping_n_m_s, steps)
    for of in ("work_done", "energy_dissipated"):
        mean_w = float(run[of][-1] - run[of][-1 - steps]) / period_s
        assert mean_w == pytest.approx(generated, rel=2e-6), of


def test_the_barge_of_the_gallery_takes_nearly_the_power_of_a_front_of_its_width() -> None:
    """Source: the front of lambda / pi that a small body in pitch takes at most (Newman 1976)."""
    run = kingpost.run("gyro_wave_energy", GALLERY)
    amplitude_m, g = 0.25, 9.80665
    flux_w_m = 0.5 * 1025.0 * g * amplitude_m**2 * g * PERIOD_S / (4 * np.pi)
    front_m = generated_w(run, 1e5, TEN_PERIODS) / flux_w_m
    most_m = g * PERIOD_S**2 / (2 * np.pi) / np.pi
    assert 0.9 * most_m < front_m < most_m


def test_wheels_at_rest_generate_nothing() -> None:
    """Source: H = 0."""
    run = kingpost.run("gyro_wave_energy", GALLERY, spin_rad_s=0)
    assert generated_w(run, 1e5, TEN_PERIODS) < 1e-6

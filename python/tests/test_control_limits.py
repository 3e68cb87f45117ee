"""Residual of compensation over the wave frequency, and in seas beyond the limits of its drives."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from kingpost.verify import control, rows
from kingpost.verify.control import frequency, sweep
from kingpost.verify.control.sweep_cases import SWEEPS
from lanes import sampled


def test_the_residual_of_a_pure_delay_is_twice_the_sine_of_half_its_phase():
    omega = np.linspace(0.1, 3.0, 30)
    found = frequency.left_by_delay(omega, 0.3, period_s=0.0, lag_s=0.0, gain_per_s=0.0)
    assert found == pytest.approx(2 * np.sin(0.15 * omega), rel=1e-12)


def test_the_residual_of_feedback_without_delay_is_zero():
    assert np.all(frequency.left_by_delay(np.array([0.3, 1.0]), 0.0, 0.0, 0.0, 0.5) == 0.0)


def test_a_gain_removes_slow_motion_but_not_fast_motion():
    slow, fast = (
        frequency.left_by_delay(np.array([omega]), 0.0, 0.02, 0.1, 0.1)
        / frequency.left_by_delay(np.array([omega]), 0.0, 0.02, 0.1, 0.0)
        for omega in (0.001, 10.0)
    )
    # w / |i w + g P|, with P near 1 for slow motions; above the gain P turns by the lag, of the order g / w.
    assert slow == pytest.approx(0.01, rel=1e-3)
    assert fast == pytest.approx(1.0, abs=0.01)


@pytest.mark.parametrize(
    "name", sampled(frequency.IN_CLOSED_FORM, keep=[next(iter(frequency.IN_CLOSED_FORM))])
)
def test_the_residual_without_prediction_is_the_closed_form_at_every_wave_period(name: str):
    row = frequency.measure(name)
    assert row.verdict == rows.PASSED, row.distance
    assert name in frequency.text([row])


def test_prediction_reduces_the_residual_within_its_band_and_the_real_sensor_increases_it_beyond():
    with_it, without = (frequency.measure(name).ratio for name in ("sensor", "sensor, no prediction"))
    within = 2 * np.pi / frequency.OMEGA < 14.0
    assert np.all(with_it[within] < 0.1 * without[within])
    assert with_it[0] > 1.0, "waves of 20 s, beyond the band: docs/control.md says so"


@pytest.mark.thorough
def test_a_slow_winch_is_longer_at_its_limit_in_higher_seas_and_never_increases_the_motion():
    name = next(iter(SWEEPS))
    row = sweep.measure(name, length_s=80.0, heights_m=[1.0, 4.0, 6.0])
    assert row.verdict == rows.PASSED, row.shortfalls
    assert row.at_a_limit[0] == 0.0
    assert row.at_a_limit[1] < row.at_a_limit[2]
    assert name in sweep.text([row])


@pytest.mark.parametrize(
    "name",
    sampled(
        ["U-tank, Tp 11.5 s", "open tanks, pumped, Tp 11.5 s", "gyros, driven, Tp 11.5 s"],
        keep=["U-tank, Tp 11.5 s"],
    ),
)
def test_a_short_sweep_of_an_anti_roll_device_finishes_without_reaching_a_limit(name: str):
    row = sweep.measure(name, length_s=4.0, heights_m=[1.0, 2.0])
    assert row.finished
    assert row.unit == "deg"
    assert np.all(row.at_a_limit == 0.0)


CALM = sweep.Degraded(
    "calm",
    heights_m=np.array([1.0, 2.0, 3.0]),
    without=np.array([1.0, 2.0, 3.0]),
    left=np.array([0.1, 0.3, 1.2]),
    largest=np.array([0.2, 0.3, 0.5]),
    at_a_limit=np.array([0.0, 0.1, 0.3]),
    finished=True,
)


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"left": np.array([0.1, 0.3, 1.4])}, "grows 1.10 times as fast"),
        ({"left": np.array([0.1, 1.0, 0.9])}, "the residual falls with Hs"),
        ({"largest": np.array([0.2, 1.3, 0.5])}, "the largest motion is 1.30 times the uncontrolled one"),
        ({"at_a_limit": np.array([0.0, 0.3, 0.1])}, "the time at a limit falls with Hs"),
        ({"finished": False}, "a run ended early"),
    ],
)
def test_a_jump_a_larger_motion_and_a_run_that_ends_early_are_reported_and_fail(change, told: str):
    assert CALM.verdict == rows.PASSED
    spoilt = replace(CALM, **change)
    assert spoilt.shortfalls == [told]
    assert f"{rows.FAILED}; {told}" in sweep.text([spoilt])


def test_a_nan_motion_does_not_pass():
    assert replace(CALM, left=np.array([0.1, np.nan, 0.3])).verdict == rows.FAILED


def test_the_command_fails_if_a_sweep_does(monkeypatch):
    monkeypatch.setattr(control, "CONTROLLERS", (sweep,))
    monkeypatch.setattr(sweep, "measured", lambda _update: [replace(CALM, finished=False)])
    assert [failed for _, failed in control.tables(lambda _done: None)] == [True]

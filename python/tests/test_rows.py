"""Rows of a run: each column has the value at the time of the row, also while inputs move.

Source: in a run of a method of the fourth order, position, velocity and acceleration are a function and its
derivatives, and the ledger's work is the integral of the powers. Over two steps of length h, Simpson's rule
joins them: f(t + h) - f(t - h) = h / 3 (f'(t - h) + 4 f'(t) + f'(t + h)) - h^5 / 90 f^(5).
"""

from __future__ import annotations

from pathlib import Path

import kingpost
import numpy as np
import pytest
from lanes import sampled

LENGTH_S = {"slew_without_swing": 12.0, "slew_without_swing_at_sea": 12.0, "underwater_vehicle": 10.0}
"""Where the first ramp of the operation begins later than elsewhere."""
DEFAULT_LENGTH_S = 4.0
PAIRS = (("position", "velocity"), ("velocity", "acceleration"), ("joint_position", "joint_velocity"),
         ("point_position", "point_velocity"))  # fmt: skip
STEADY = 0.9
"""Share of the rows that have no event and no sample of a controller within two steps, at least."""
ALLOWED = 0.03
"""Allowed share of a rate's largest value. A step holds an input that moves at its middle value, so
the motion has a ripple of the step's length: (omega h)^2 / 8 of the rate, 0.008 for the fastest
drive of the gallery. Rows that lagged by half a step were off by 3 times the largest acceleration."""
NEGLIGIBLE = 1e-6
"""Columns whose rates are below this share of the largest of their variable have rounding only."""
RAMP = """version: 1
title: A wheel
simulation: {step_s: 0.05, duration_s: 6, record_every_s: 0.05}
bodies:
  wheel:
    mass_t: 1
    inertia: {radii_of_gyration: {radii_m: [0.3, 0.3, 0.3]}}
    joint: {revolute: {name: axle, axis: [0, 0, 1]}}
drives: DRIVES
operation:
  steps:
    - {name: wait, until: {after_s: 1}}
    - {name: go, set: [{input: INPUT, to: TO, in_s: 4}]}
"""


def off(f: np.ndarray, rate: np.ndarray, h: float) -> float:
    """Difference of a function and its rate in steady rows, as a share of the rate's largest value; the error
    of Simpson's rule, by fourth differences of the rate, is subtracted."""
    count = len(f)
    f, rate = f.reshape(count, -1), rate.reshape(count, -1)
    largest = np.abs(rate).max(axis=0)
    counts = largest > NEGLIGIBLE * largest.max(initial=0.0)
    if not counts.any():
        return 0.0
    f, rate, largest = f[:, counts], rate[:, counts], largest[counts]
    apart = np.abs(f[2:] - f[:-2] - h / 3 * (rate[:-2] + 4 * rate[1:-1] + rate[2:]))
    left_out = np.zeros_like(rate)
    left_out[2:-2] = h * np.abs(np.diff(rate, 4, axis=0))
    for _ in range(3):
        left_out[1:-1] = np.maximum(left_out[1:-1], np.maximum(left_out[:-2], left_out[2:]))
    rounding = 1e-14 * np.abs(f).max(axis=0)
    over = np.maximum(apart - left_out[1:-1] - rounding, 0.0) / (h * largest)
    return float(np.quantile(over, STEADY, axis=0).max())


def recorded(name: str) -> tuple[kingpost.Scenario, object, float]:
    scenario = kingpost.load(name)
    step_s = scenario.model["step_s"]
    length_s = LENGTH_S.get(name, DEFAULT_LENGTH_S)
    every = {"simulation.duration_s": length_s, "simulation.record_every_s": step_s}
    return scenario, kingpost.run(name, every), step_s


def has_powers(scenario: kingpost.Scenario) -> bool:
    """Whether every drive has a column of its power, and none prescribes a motion."""
    drives = scenario.resolved.get("drives", {}).values()
    kinds = {
        kind
        for drive in drives
        for kind in drive
        if kind in ("servo", "linear_servo", "motor", "linear_motor")
    }
    return (
        bool(drives)
        and not kinds
        and not any(words in scenario.text for words in ("prescribed", "moved_by_waves"))
    )


@pytest.mark.parametrize("name", sampled(kingpost.gallery.names(), ["slew_without_swing", "quayside_lift"]))
def test_each_rate_of_the_gallery_is_the_derivative_of_its_column(name: str) -> None:
    scenario, found, h = recorded(name)
    apart = {rate: off(found[f].values, found[rate].values, h) for f, rate in PAIRS if f in found}
    assert max(apart.values()) < ALLOWED, apart
    if "drive_power" in found and has_powers(scenario):
        power = found.drive_power.values.sum(axis=1)
        if "pump_power" in found:
            power = power + found.pump_power.values.sum(axis=1)
        if "cylinder_force" in found:
            power = power + (found.cylinder_force.values * found.cylinder_rate.values).sum(axis=1)
        assert off(found.work_by_drives.values, power, h) < ALLOWED


def wheel(tmp_path: Path, drives: str, to: float, of: str = "drive") -> kingpost.Scenario:
    path = tmp_path / "wheel.yaml"
    text = RAMP.replace("DRIVES", drives).replace("INPUT", of).replace("TO", str(to))
    path.write_text(text, encoding="utf-8")
    return kingpost.load(path)


def test_a_motor_has_the_torque_of_a_ramp_at_the_time_of_each_row(tmp_path: Path) -> None:
    """Source: the ramp, and M = J alpha with J = 90 kg m2."""
    drives = "{drive: {motor: {joint: axle, torque_N_m: 1000, history: lever}}}"
    found = kingpost.run(wheel(tmp_path, drives, 1))
    expected = 1000 * np.clip((found.time.values - 1) / 4, 0, 1)
    assert found.joint_force.values[:, 0] == pytest.approx(expected, abs=1e-9)
    rate = found.joint_velocity.values[:, 0]
    # Over the ramp M t / 2 of each step, exactly: the held middle has the same integral.
    momentum = np.where(expected < 1000, expected**2 / 1000 * 2, 2000 + 1000 * (found.time.values - 5))
    assert 90 * rate == pytest.approx(momentum, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("step_s", [0.02, 0.01])
def test_a_servo_whose_set_point_moves_evenly_needs_no_torque(tmp_path: Path, step_s: float) -> None:
    """Source: a wheel without friction that has come to the rate of its set-point; the ripple of the held
    set-point is (omega h)^2 / 8 of that rate, omega = 10/s, times the damping."""
    drives = (
        "{drive: {servo: {joint: axle, target_deg: 0, stiffness_N_m_per_rad: 9000, "
        "damping_N_m_s_per_rad: 1800, torque_limit_kN_m: 100}}}"
    )
    shaper = (
        "{command: {input_shaper: {to: drive.target_offset, shaper: none, period_s: 9, damping_ratio: 0}}}"
    )
    scenario = wheel(tmp_path, f"{drives}\ncontrollers: {shaper}", np.pi / 2, "command")
    every = {"simulation.step_s": step_s, "simulation.record_every_s": step_s, "simulation.duration_s": 4.8}
    found = kingpost.run(scenario, every)
    late = found.time.values > 3.5
    ripple = 1800 * np.pi / 8 * (10 * step_s) ** 2 / 8
    assert np.abs(found.joint_force.values[late, 0]).max() < 4 * ripple

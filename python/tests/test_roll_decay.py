"""Damping from records of decaying roll: known coefficients are recovered, and invalid records are
refused."""

import math

import kingpost
import numpy as np
import pytest
from kingpost.errors import RollDampingError
from kingpost.roll_damping import DecayRecord, fragment, from_decay
from kingpost.roll_damping.amplitudes import swings
from kingpost.roll_damping.oscillator import simulated

OMEGA, OFFSET, STIFFENING = 0.6, 0.01, -0.3
TIME = np.arange(0.0, 200.0, 0.25)
# p1, p2, p3 of about 2 % of the critical damping each at 0.2 rad.
KNOWN = {"linear": (0.02, 0.0, 0.0), "quadratic": (0.012, 0.12, 0.0), "cubic": (0.012, 0.06, 0.5)}
PENDULUM = """\
version: 1
title: A pendulum with drag
simulation: {{integrator: rk4, step_s: 0.005, duration_s: 60, record_every_s: 0.05}}
bodies:
  ship:
    mass_kg: 1000
    inertia: {{tensor: {{moments_kg_m2: [500, 500, 500]}}}}
    joint: {{revolute: {{name: roll, axis: [1, 0, 0], child_position_m: [0, 0, 2], initial_angle_rad: 0.25}}}}
forces:
  gravity: {{gravity: {{}}}}
  {forces}
"""


def known_record(damping, noise=0.0, time=TIME) -> DecayRecord:
    state = np.array([OMEGA, OFFSET, STIFFENING, 0.22, 0.0, *damping])
    roll = simulated(state[:, None], time)[:, 0]
    return DecayRecord(time, roll + noise * 0.22 * np.random.default_rng(7).standard_normal(len(time)))


def test_the_oscillator_agrees_with_the_closed_form():
    p1, omega = 0.03, 0.6
    damped = math.sqrt(omega**2 - p1**2 / 4)
    state = np.array([omega, 0.0, 0.0, 0.2, 0.0, p1, 0.0, 0.0])
    exact = 0.2 * np.exp(-p1 / 2 * TIME) * (np.cos(damped * TIME) + p1 / 2 / damped * np.sin(damped * TIME))
    # Runge-Kutta at 64 steps a period: 8e-8 in phase a step of 1e-1 rad, over 1200 steps.
    np.testing.assert_allclose(simulated(state[:, None], TIME)[:, 0], exact, atol=1e-5)


def test_quadratic_damping_lets_amplitudes_fall_as_one_over_time():
    """The averaged equation, 1/a(t) - 1/a(0) = 4 / (3 pi) omega p2 t, holds to the order of p2 a."""
    p2, a0 = 0.2, 0.1
    state = np.array([OMEGA, 0.0, 0.0, a0, 0.0, 0.0, p2, 0.0])
    found = swings(DecayRecord(TIME, simulated(state[:, None], TIME)[:, 0]))
    expected = 1 / (1 / a0 + 4 / (3 * math.pi) * OMEGA * p2 * found.time_s)
    np.testing.assert_allclose(found.amplitude_rad, expected, rtol=p2 * a0)


@pytest.mark.parametrize("model", list(KNOWN))
def test_known_coefficients_are_recovered_from_a_record_without_noise(model):
    found = from_decay(known_record(KNOWN[model]), model)
    assert found.damping == pytest.approx(KNOWN[model], rel=1e-3)
    assert found.frequency_rad_s == pytest.approx(OMEGA, rel=1e-5)
    assert (found.stiffening, found.offset_rad) == pytest.approx((STIFFENING, OFFSET), rel=1e-2)
    # The first estimate, by the energy of each swing, is that of averaging: of the order of the damping
    # ratio.
    whole = [sum(p * 0.1**k for k, p in enumerate(values)) for values in (found.averaged, KNOWN[model])]
    assert whole[0] == pytest.approx(whole[1], rel=0.1)


@pytest.mark.parametrize("model", ["linear", "quadratic"])
def test_noise_of_five_per_cent_is_averaged_out(model):
    """White noise of 5 % of the first amplitude on 800 samples, some 38 periods: the equivalent damping at
    half the first amplitude within four of its standard errors, and those no more than 5 % of it."""
    known = KNOWN[model]
    found = from_decay(known_record(known, noise=0.05), model)
    exact = from_decay(known_record(known), model)
    amplitude = 0.11
    assert found.equivalent(amplitude) == pytest.approx(exact.equivalent(amplitude), rel=0.05)
    assert found.frequency_rad_s == pytest.approx(OMEGA, rel=2e-3)
    assert abs(found.damping[0] - known[0]) < 4 * found.deviations["linear"]
    assert found.rms_rad == pytest.approx(0.05 * 0.22, rel=0.1)


def test_the_stated_uncertainty_is_that_of_many_records():
    """Of 12 records with other noise the deviations from the truth over the stated one have a mean square of
    1 within that of chi square with 12 degrees of freedom (0.26 to 2.7 with 99.8 %)."""
    truth = np.array(KNOWN["linear"][0])
    clean = known_record(KNOWN["linear"], time=TIME[:400])
    scores = []
    for seed in range(12):
        noise = 0.03 * 0.22 * np.random.default_rng(seed).standard_normal(400)
        found = from_decay(DecayRecord(clean.time_s, clean.roll_rad + noise), "linear", after_s=0.0)
        scores.append((found.damping[0] - truth) / found.deviations["linear"])
    assert 0.2 < float(np.mean(np.square(scores))) < 2.8


def pendulum(tmp_path, forces: str) -> DecayRecord:
    path = tmp_path / "pendulum.yaml"
    path.write_text(PENDULUM.format(forces=forces), encoding="utf-8")
    results = kingpost.run(path)
    return DecayRecord(results.time.values, results["roll"].sel(body="ship").values)


def test_a_decay_by_the_engine_gives_back_the_forces_of_its_scenario(tmp_path):
    """A pendulum of 1000 kg at 2 m with 500 kg m2: inertia 4500 kg m2, omega0^2 = m g l / I, and sin x bends
    as x - x^3 / 6."""
    record = pendulum(tmp_path, (
        "film: {viscous_damping: {body: ship, angular_N_m_s: [90, 0, 0]}}\n"
        "  drag: {quadratic_damping: {body: ship, angular_N_m_s2: [1800, 0, 0]}}"))  # fmt: skip
    found = from_decay(record, "quadratic")
    inertia = 1000 * 2.0**2 + 500
    assert found.frequency_rad_s == pytest.approx(math.sqrt(1000 * 9.80665 * 2 / inertia), rel=1e-4)
    # sin x = x - x^3/6 + x^5/120: at 0.25 rad the last is 5e-3 of the second.
    assert found.stiffening == pytest.approx(-1 / 6, rel=2e-2)
    again = found.for_scenario(found.inertia_kg_m2(1000, 2.0))
    assert (again.linear, again.quadratic) == pytest.approx((90, 1800), rel=5e-3)


def test_a_scenario_with_the_fitted_forces_reproduces_the_decay(tmp_path):
    found = from_decay(
        pendulum(tmp_path, "film: {viscous_damping: {body: ship, angular_N_m_s: [300, 0, 0]}}")
    )
    text = fragment(found.for_scenario(4500.0), "ship", "again").splitlines()[2:]
    again = from_decay(pendulum(tmp_path, "\n".join(text).strip()))
    np.testing.assert_allclose(again.swings.amplitude_rad, found.swings.amplitude_rad, rtol=1e-3)


def test_an_offset_and_a_sign_change_nothing():
    record = known_record(KNOWN["quadratic"])
    one = from_decay(record)
    other = from_decay(DecayRecord(record.time_s + 100, -record.roll_rad + 0.05))
    assert other.damping == pytest.approx(one.damping, rel=1e-4)
    assert other.offset_rad == pytest.approx(0.05 - OFFSET, rel=1e-3)


def test_a_slower_record_scales_all_quantities_with_time():
    record = known_record(KNOWN["cubic"])
    one, slow = (
        from_decay(record, "cubic"),
        from_decay(DecayRecord(2 * record.time_s, record.roll_rad), "cubic"),
    )
    scaled = (one.damping[0] / 2, one.damping[1], one.damping[2] * 2)
    assert slow.damping == pytest.approx(scaled, rel=1e-4)


def test_radiated_waves_are_not_counted_twice():
    found = from_decay(known_record(KNOWN["quadratic"]))
    whole, rest = found.for_scenario(1e6), found.for_scenario(1e6, 4e3)
    assert whole.linear - rest.linear == pytest.approx(4e3, rel=0.05)
    with pytest.raises(RollDampingError, match="radiated_damping: found 1e"):
        found.for_scenario(1e6, 1e6)


def test_a_run_of_kingpost_is_read_by_its_column(tmp_path):
    path = tmp_path / "run.csv"
    record = known_record(KNOWN["linear"])
    lines = [f"{t},{x},0" for t, x in zip(record.time_s, record.roll_rad, strict=True)]
    path.write_text("\n".join(["time,ship.roll,ship.pitch", *lines]))
    np.testing.assert_array_equal(DecayRecord.read(path).roll_rad, record.roll_rad)
    np.testing.assert_array_equal(DecayRecord.read(path, "ship.pitch").roll_rad, 0)


def test_degrees_are_read_as_degrees(tmp_path):
    path = tmp_path / "decay.csv"
    path.write_text("time_s, roll_deg\n" + "\n".join(f"{k}, {90 * (-1) ** k}" for k in range(20)))
    np.testing.assert_allclose(np.abs(DecayRecord.read(path).roll_rad), math.pi / 2)


SWING = 0.1 * np.exp(-0.01 * TIME) * np.cos(OMEGA * TIME)


@pytest.mark.parametrize(
    ("time", "roll", "words"),
    [
        (TIME[:3], SWING[:3], "samples: found 3, allowed: 16 or more"),
        (
            TIME,
            np.where(TIME == 50, np.nan, SWING),
            "roll_rad: found nan in row 201, allowed: finite numbers",
        ),
        (TIME[::-1], SWING, "time_s: found 199.5 in row 2, allowed: times that increase"),
        (TIME, SWING[:-1], "roll_rad: found the shape (799,), allowed: one number for each time"),
        (TIME, 0.1 * np.exp(-0.05 * TIME), "roll_rad: found"),
        (TIME, np.zeros_like(TIME), "roll_rad: found 0 swings"),
        (TIME[:40], SWING[:40], "allowed: a roll that swings 4 times or more"),
        (TIME[::20], SWING[::20], "samples in a period"),
    ],
)
def test_a_record_without_decaying_roll_is_refused_by_name(time, roll, words):
    with pytest.raises(RollDampingError) as refused:
        from_decay(DecayRecord(time, roll))
    assert words in str(refused.value)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (
            "time_s,heave_m\n0,1\n",
            "columns: found time_s, heave_m, allowed: time_s or time, and one of roll_rad",
        ),
        ("roll_rad\n0\n", "columns: found roll_rad"),
        ("time,a.roll,b.roll\n0,1,2\n", "columns: found time, a.roll, b.roll"),
        ("time_s,roll_rad\n0,0.1\n1,0.1\n", "samples: found 2"),
        ("", "an empty file"),
    ],
)
def test_a_file_that_is_not_a_record_is_refused_with_its_name(text, words, tmp_path):
    path = tmp_path / "decay.csv"
    path.write_text(text)
    with pytest.raises(RollDampingError) as refused:
        DecayRecord.read(path)
    assert words in str(refused.value)
    assert refused.value.file == str(path)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda found: found.inertia_kg_m2(-1.0, 1.0), "mass_kg: found -1"),
        (lambda found: found.inertia_kg_m2(1.0, math.nan), "metacentric_height_m: found nan"),
        (lambda found: found.coefficients(0.0), "inertia_kg_m2: found 0"),
    ],
)
def test_a_nan_inertia_is_refused(call, words):
    found = from_decay(known_record(KNOWN["linear"]), "linear")
    with pytest.raises(RollDampingError, match=words):
        call(found)


def test_an_unknown_model_and_an_empty_part_are_refused():
    record = known_record(KNOWN["linear"])
    with pytest.raises(RollDampingError, match="model: found 'quintic', allowed: linear, quadratic, cubic"):
        from_decay(record, "quintic")
    with pytest.raises(RollDampingError, match="after_s: found 300, allowed: less than the end"):
        from_decay(record, after_s=300)

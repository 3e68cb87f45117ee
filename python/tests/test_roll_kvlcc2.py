"""KVLCC2 at 1:68 without bilge keels: its measured decay, published coefficients, and predictions."""

import math

import numpy as np
import pytest
import roll_samples as samples
from kingpost.hydro.build import build
from kingpost.roll_damping import DecayRecord, from_decay, from_sections
from kingpost.roll_damping.coefficients import Coefficients
from kingpost.roll_damping.radiated import natural_period, radiated

AMPLITUDES = np.radians([3.0, 5.0, 7.0, 9.0])
MASS_KG = samples.DENSITY_KG_M3 * samples.VOLUME_M3 / samples.SCALE**3


@pytest.fixture(scope="module", params=list(samples.PUBLISHED))
def run(request) -> int:
    return request.param


@pytest.fixture(scope="module")
def measured(run):
    return from_decay(samples.kvlcc2_decay(run), "cubic")


def test_a_measured_decay_gives_the_published_period_and_damping(run, measured):
    """Alexandersson et al. fitted the same record with cubic damping and a bent righting arm. Compared is the
    equivalent damping over the amplitudes of the record, for the three terms make up for each other."""
    omega, *published = samples.PUBLISHED[run]
    assert measured.frequency_rad_s == pytest.approx(omega, rel=5e-3)
    inertia = measured.inertia_kg_m2(MASS_KG, samples.GM_M / samples.SCALE, samples.GRAVITY_M_S2)
    theirs = Coefficients(*published).equivalent(omega, AMPLITUDES)
    ours = measured.coefficients(inertia).equivalent(omega, AMPLITUDES)
    np.testing.assert_allclose(ours, theirs, rtol=0.05)


def test_a_record_simulated_with_fitted_coefficients_gives_the_same_damping_and_amplitudes(run, measured):
    """The record that the coefficients make, from the first angle on, is read again."""
    record = samples.kvlcc2_decay(run)
    first = float(record.time_s[np.abs(record.roll_rad).argmax()])
    used = record.between(first, float(record.time_s[-1]))
    angle = float(used.roll_rad[0]) - measured.offset_rad
    again = from_decay(DecayRecord(used.time_s, measured.simulated(used, angle, 0.0)), "cubic")
    np.testing.assert_allclose(again.equivalent(AMPLITUDES), measured.equivalent(AMPLITUDES), rtol=0.05)
    count = min(len(again.swings.amplitude_rad), len(measured.swings.amplitude_rad))
    both = (found.swings.amplitude_rad[:count] for found in (again, measured))
    np.testing.assert_allclose(*both, rtol=0.05)


@pytest.fixture(scope="module")
def predicted():
    """Predictions from the sections and the loading only: natural period and radiation damping, by the panel
    method on Lewis forms, and Ikeda's components."""
    pytest.importorskip("capytaine")
    sections, kg = samples.kvlcc2_sections(), samples.KG_M / samples.SCALE
    hull = samples.lewis_hull(sections, 25, 9)
    database = build(hull, samples.fresh_water(), "kvlcc2", np.array([2.3, 2.5, 2.7]), 4, False)
    gyration, height = samples.GYRATION_M / samples.SCALE, samples.GM_M / samples.SCALE
    period = natural_period(database, kg, gyration, height)
    _, waves = radiated(database, kg, 2 * math.pi / period)
    return period, waves, predicted_damping(period)


def predicted_damping(period, **options):
    water = {"density_kg_m3": samples.DENSITY_KG_M3, "viscosity_m2_s": samples.VISCOSITY_M2_S}
    sections, kg = samples.kvlcc2_sections(), samples.KG_M / samples.SCALE
    return from_sections(sections, kg, period, AMPLITUDES, **water, **options)


def test_the_period_is_predicted_from_sections_and_loading(predicted, measured):
    assert predicted[0] == pytest.approx(measured.period_s, rel=0.02)


def whole_damping(measured) -> np.ndarray:
    inertia = measured.inertia_kg_m2(MASS_KG, samples.GM_M / samples.SCALE, samples.GRAVITY_M_S2)
    return measured.coefficients(inertia).equivalent(measured.frequency_rad_s, AMPLITUDES)


def test_the_damping_is_predicted_from_sections_and_loading(predicted, measured):
    """No constant was made from this ship, but to read sharpness by the radius was decided in sight of it.
    Within 25 % at 3 and at 9 degrees; between them, where the measured damping is nearly flat, it misses that
    aim: a third too large."""
    _, waves, damping = predicted
    ratio = (waves + damping["total"].values) / whole_damping(measured)
    np.testing.assert_allclose(ratio[[0, -1]], 1, rtol=0.25)
    np.testing.assert_allclose(ratio[1:-1], 1, rtol=0.35)


def test_the_printed_formula_overestimates_the_eddies_as_published(predicted, measured):
    """A known miss: with sharpness by the area Ikeda's eddies are three to five times those measured, which
    are what friction and waves leave; by the radius 1.2 to 1.7 times. Alexandersson et al. found the
    printed formula too large for this ship, too."""
    period, waves, damping = predicted
    friction, by_radius = (damping["damping"].sel(component=name).values for name in ("friction", "eddies"))
    printed = predicted_damping(period, sharpness="area")["damping"].sel(component="eddies").values
    left = whole_damping(measured) - waves - friction
    assert ((printed / left > 3) & (printed / left < 5)).all()
    assert ((by_radius / left > 1) & (by_radius / left < 1.7)).all()
    assert "printed" in damping.attrs["warning"]


def test_at_speed_lift_is_most_of_the_damping_as_measured(predicted):
    """At 15.5 knots, of which the hydrodynamics of waves here know nothing: what waves take more at speed is
    missing, and the sum is a fifth to a quarter too small."""
    omega, *published = samples.PUBLISHED_AT_SPEED
    damping = predicted_damping(2 * math.pi / omega, speed_m_s=samples.SPEED_M_S)
    found = predicted[1] + damping["total"].values
    exact = Coefficients(*published).equivalent(omega, AMPLITUDES)
    assert (damping["damping"].sel(component="lift").values > 0.5 * found).all()
    np.testing.assert_allclose(found[:3], exact[:3], rtol=0.25)
    assert (found < exact).all()

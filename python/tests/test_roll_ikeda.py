"""Ikeda's components: against measurements, integrals by quadrature, published figures, and laws of scale."""

import math

import numpy as np
import pytest
from kingpost.errors import RollDampingError
from kingpost.roll_damping import BilgeKeels, Coefficients, Sections, fragment, from_sections
from kingpost.roll_damping.bilge_keels import bilge_keel_damping, keel_arm, pressure_levers
from kingpost.roll_damping.coefficients import fitted
from kingpost.roll_damping.eddies import SHARPNESS, eddy_coefficient
from kingpost.roll_damping.friction import friction_damping, lift_damping
from kingpost.roll_damping.simplified import HullForm, bilge_keels, eddy
from roll_samples import box_sections, ikeda_cylinders

KEELS = BilgeKeels(0.4, 40)


def cylinder(row) -> Sections:
    """Three equal sections of one of Ikeda's cylinders."""
    ones = np.ones(3)
    columns = {
        "x_m": [0, 0.4, 0.8],
        "beam_m": row["beam_m"] * ones,
        "draught_m": row["draught_m"] * ones,
        "area_coefficient": row["area_coefficient"] * ones,
    }
    if row["bilge_radius_m"] >= 0:
        columns["bilge_radius_m"] = row["bilge_radius_m"] * ones
    return Sections.of_table(columns)


def levers_by_quadrature(beam, draught, radius, axis_depth, length) -> tuple[float, float]:
    """A0 and B0 from their definition: pressures on points along the girth times their levers."""
    count = 200_001
    centre = np.array([beam / 2 - radius, -(draught - axis_depth - radius)])
    found = []
    for branch in ("bottom", "side"):
        flat = centre[0] if branch == "bottom" else draught - radius
        arc = math.pi / 4 * radius
        s = (np.arange(count) + 0.5) / count * (flat + arc)
        # s runs from the keel; t is the angle from where the flat part begins.
        t = np.clip((arc - s) / radius if radius else np.zeros_like(s), 0, None)
        along = np.maximum(s - arc, 0)
        if branch == "bottom":
            y, z = centre[0] + radius * np.sin(t) - along, centre[1] - radius * np.cos(t)
            inward = -np.sin(t), np.cos(t)
        else:
            y, z = centre[0] + radius * np.cos(t), centre[1] - radius * np.sin(t) + along
            inward = -np.cos(t), np.sin(t)
        lever = y * inward[1] - z * inward[0]
        lever = lever if branch == "bottom" else -lever
        step = (flat + arc) / count
        falling = 1 - s / (flat + arc)
        found.append((float((lever * (s < length)).sum() * step), float((lever * falling).sum() * step)))
    behind, before = np.sum(found, axis=0) / draught**2
    return behind, before


@pytest.mark.parametrize("radius", [0.0, 1.0, 3.0])
@pytest.mark.parametrize("axis_depth", [-2.0, 0.0, 1.5])
@pytest.mark.parametrize("length", [0.5, 2.8])
def test_the_levers_of_the_keels_pressure_equal_their_defining_integrals(radius, axis_depth, length):
    beam, draught = 20.0, 8.0
    sections = Sections.of_table({"x_m": [0, 1, 2], "beam_m": [beam] * 3, "draught_m": [draught] * 3,
                                  "area_coefficient": [0.9] * 3, "bilge_radius_m": [radius] * 3})  # fmt: skip
    behind, before = pressure_levers(sections, axis_depth, np.full(3, length))
    # 2e5 midpoints; the edge of the constant pressure falls between two of them.
    assert (behind[0], before[0]) == pytest.approx(
        levers_by_quadrature(beam, draught, radius, axis_depth, length), rel=1e-4
    )


# Of section H the measured eddies are 1/100 of those of the box A; of section I (a bilge of 0.36 d) the two
# measured curves differ by 35 %.
WITHIN = {"H": (0.2, 0.4), "I": (1.0, 1.7)}


@pytest.mark.parametrize("by", SHARPNESS)
def test_eddies_of_ikedas_cylinders_agree_with_his_measurements(by):
    """Boxes with sharp and round bilges (A to D), sections of Series 60 (G to L): within 25 % but for two,
    whether sharpness is read from the radius of the bilge or from the area."""
    for row in ikeda_cylinders():
        ratio = eddy_coefficient(cylinder(row), 0.0, by)[0] / row["eddy_coefficient"]
        least, most = WITHIN.get(row["section"], (0.75, 1.25))
        assert least < ratio < most, (row["section"], ratio)


def test_eddies_are_quadratic_and_a_half_circle_that_rolls_about_its_centre_sheds_next_to_none():
    flat = box_sections(area_coefficient=math.pi / 4, beam_m=16, draught_m=8)
    full = box_sections(area_coefficient=0.99, beam_m=16, draught_m=8)
    assert eddy_coefficient(flat, 0.0)[0] < 0.1 * eddy_coefficient(full, 0.0)[0]
    found = from_sections(full, 8, 10, np.radians([5.0, 10.0]))
    small, large = found["damping"].sel(component="eddies").values
    assert large == pytest.approx(2 * small, rel=1e-12)


def test_all_components_except_friction_follow_froudes_scaling():
    """Froude's law: omega as the root of 1 / L, B44 as L^4.5; friction falls behind by L^-3/4, B_F as
    L^3.75."""
    ship, scale = box_sections(), 64.0
    model = ship.scaled(1 / scale)
    amplitudes = np.radians([5.0, 12.0])
    large = from_sections(ship, 9.0, 12.0, amplitudes, KEELS)
    small_keels = BilgeKeels(KEELS.breadth_m / scale, KEELS.length_m / scale)
    small = from_sections(model, 9.0 / scale, 12.0 / scale**0.5, amplitudes, small_keels)
    for name in ("eddies", "bilge_keel_force", "bilge_keel_pressure"):
        np.testing.assert_allclose(
            large.damping.sel(component=name), scale**4.5 * small.damping.sel(component=name), rtol=1e-10
        )
    np.testing.assert_allclose(
        large.damping.sel(component="friction"),
        scale**3.75 * small.damping.sel(component="friction"),
        rtol=1e-10,
    )


def test_forward_speed_adds_lift_and_reduces_eddies():
    still, fast, faster = (
        from_sections(box_sections(), 9.0, 12.0, speed_m_s=speed) for speed in (0.0, 5.0, 10.0)
    )
    lift = [float(found.damping.sel(component="lift")[0]) for found in (still, fast, faster)]
    assert lift[0] == 0
    assert lift[2] == pytest.approx(2 * lift[1], rel=1e-12)
    eddies = [float(found.damping.sel(component="eddies")[0]) for found in (still, fast, faster)]
    assert eddies[0] > eddies[1] > eddies[2] > 0
    assert float(fast.damping.sel(component="friction")[0]) > float(
        still.damping.sel(component="friction")[0]
    )


def test_friction_is_proportional_to_the_roots_of_frequency_and_viscosity():
    hull = box_sections()
    one = friction_damping(hull, -1.0, 0.5, 1025.0, 1e-6)
    assert friction_damping(hull, -1.0, 2.0, 1025.0, 1e-6) == pytest.approx(2 * one, rel=1e-12)
    assert friction_damping(hull, -1.0, 0.5, 1025.0, 4e-6) == pytest.approx(2 * one, rel=1e-12)
    assert lift_damping(hull, -1.0, 1025.0, 0.0) == 0


def test_the_constant_of_friction_is_himenos():
    """0.787 rho S r^2 sqrt(omega nu) (Himeno 1981), S and r of a box at OG = 0."""
    hull = box_sections(area_coefficient=1.0)
    girth = 1.7 * 8 + 20
    radius = (0.887 + 0.145) * girth / math.pi
    expected = 0.787 * 1025 * 100 * girth * radius**2 * math.sqrt(0.5 * 1e-6)
    assert friction_damping(hull, 0.0, 0.5, 1025.0, 1e-6) == pytest.approx(expected, rel=5e-4)


def test_eddies_that_depend_on_the_sharpness_of_the_bilges_give_a_warning():
    assert "printed" in from_sections(box_sections(area_coefficient=0.998), 8, 10).attrs["warning"]
    assert "warning" not in from_sections(box_sections(area_coefficient=0.98), 8, 10).attrs
    # A sharp corner is one by both readings.
    assert "warning" not in from_sections(box_sections(area_coefficient=1.0), 8, 10).attrs


def test_the_force_on_keels_is_that_of_their_drag_coefficient():
    """With square bilges, the axis on the water plane: l^2 = (B/2)^2 + d^2, f = 1.3, C_D = 22.5 b / (pi l phi
    f) + 2.4, two keels of area b L with moment rho C_D b L l (f l omega)^2 / 2 each."""
    hull, b, phi, omega = box_sections(area_coefficient=1.0), 0.5, 0.15, 0.6
    arm = math.hypot(10.0, 8.0)
    assert keel_arm(hull, 0.0)[0] == pytest.approx(arm, rel=1e-12)
    drag = 22.5 * b / (math.pi * arm * phi * 1.3) + 2.4
    moment = 2 * 1025 / 2 * drag * b * 40 * arm * (1.3 * arm) ** 2
    force, pressure = bilge_keel_damping(hull, BilgeKeels(b, 40), 0.0, omega, phi, 1025.0)
    assert force == pytest.approx(8 / (3 * math.pi) * omega * phi * moment, rel=1e-12)
    assert pressure > 0


# Kawahara, Maekawa & Ikeda, STAB 2009, Fig. 1: symbols of Ikeda's own method, at omega sqrt(B/2g) = 0.5547,
# of L/B 6, B/d 4, C_B 0.65, C_M 0.98, 10 degrees, keels of 0.025 B and 0.2 L; read from the figure's vector
# paths to 1e-5. By OG/d: eddies, keels.
FIGURE = {-0.2: (0.000854, 0.005284), -1.5: (0.003934, 0.015503)}


@pytest.mark.parametrize("depth", list(FIGURE))
def test_the_regression_of_kawahara_reproduces_his_figure(depth):
    form, amplitude = HullForm(0.65, 0.98, 4.0, depth), math.radians(10)
    eddies, keels = FIGURE[depth]
    # The regression misses the symbols that it was made from by 8 % for the eddies and 4 % for the keels.
    assert eddy(form, 0.5547, amplitude) == pytest.approx(eddies, rel=0.1)
    assert bilge_keels(form, 0.5547, amplitude, 0.025, 0.2) == pytest.approx(keels, rel=0.05)


@pytest.mark.parametrize("depth", list(FIGURE))
def test_bilge_keel_damping_agrees_with_ikedas_program(depth):
    """The same ship: keels amidships, where its sections are those of the midship."""
    beam = 20.0
    length, draught = 6 * beam, beam / 4
    hull = box_sections(length, beam, draught, 0.98)
    frequency = 0.5547 / math.sqrt(beam / (2 * 9.80665))
    found = bilge_keel_damping(
        hull, BilgeKeels(0.025 * beam, 0.2 * length), depth * draught, frequency, math.radians(10), 1025.0
    )
    unit = 1025.0 * 0.65 * length * beam * draught * beam**2 / math.sqrt(beam / (2 * 9.80665))
    # Of the keels' place along his ship and of its sections there nothing is published.
    assert sum(found) / unit == pytest.approx(FIGURE[depth][1], rel=0.1)


def test_coefficients_give_back_the_damping_that_they_were_fitted_to():
    amplitudes = np.radians([3.0, 6.0, 9.0, 15.0])
    given = Coefficients(1.5e6, 4.0e7)
    found = fitted(amplitudes, given.equivalent(0.7, amplitudes), 0.7)
    assert (found.linear, found.quadratic) == pytest.approx((given.linear, given.quadratic), rel=1e-9)
    # Damping that falls with the amplitude has no quadratic part that would give energy.
    assert fitted(amplitudes, 1e6 * (1 - amplitudes), 0.7).quadratic == 0


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"keel_to_gravity_m": math.nan}, "keel_to_gravity_m: found nan, allowed: a number greater than 0"),
        (
            {"keel_to_gravity_m": 1e100},
            "keel_to_gravity_m: found 1e+100, allowed: a number greater than 0, up to 100",
        ),
        ({"period_s": 0.0}, "period_s: found 0, allowed: 0.1 to 10000"),
        ({"amplitudes_rad": [0.1, -0.1]}, "amplitudes_rad: found -0.1"),
        ({"amplitudes_rad": []}, "amplitudes_rad: found none"),
        ({"speed_m_s": -1.0}, "speed_m_s: found -1, allowed: 0 to 100"),
        ({"sharpness": "angle"}, "sharpness: found 'angle', allowed: radius or area"),
        ({"density_kg_m3": math.inf}, "density_kg_m3: found inf"),
        ({"bilge_keels": BilgeKeels(0.4, 120)}, "within the hull"),
        (
            {"bilge_keels": BilgeKeels(0.4, 40, 45)},
            "keels from 25 to 65 m, allowed: within the hull, -50 to 50 m",
        ),
        (
            {"bilge_keels": BilgeKeels(5, 40)},
            "bilge_keels.breadth_m: found 5, allowed: at most half the draught",
        ),
    ],
)
def test_an_impossible_ship_is_refused_by_name(changes, words):
    with pytest.raises(RollDampingError) as refused:
        from_sections(**{"sections": box_sections(), "keel_to_gravity_m": 9.0, "period_s": 12.0} | changes)
    assert words in str(refused.value)


@pytest.mark.parametrize("breadth", [-0.4, 0.0, math.nan])
def test_keels_without_breadth_are_refused(breadth):
    with pytest.raises(RollDampingError, match=r"bilge_keels\.breadth_m: found"):
        BilgeKeels(breadth, 40)


def test_cubic_and_negative_damping_are_refused_for_a_scenario():
    with pytest.raises(RollDampingError, match="cubic: found 3"):
        fragment(Coefficients(1.0, 2.0, 3.0), "ship", "x")
    with pytest.raises(RollDampingError, match="quadratic: found -2, allowed: 0 or more"):
        fragment(Coefficients(1.0, -2.0), "ship", "x")

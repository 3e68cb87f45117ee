"""Green's function of finite depth: against John's series, its exponentials, and a hull in deep water."""

import numpy as np
import pytest
from kingpost.errors import HydrodynamicsError
from kingpost.hydro import finite_depth, solve
from kingpost.hydro.database import Water
from kingpost.hydro.hull_options import parse_shape
from kingpost.hydro.meshes import parametric

capytaine = pytest.importorskip("capytaine")

PRISM = "box:length_m=8,beam_m=0.4,draught_m=0.2,depth_m=0.4"


def john(kh: float, distance: float, z: float, source: float) -> complex:
    """Green's function in water of depth 1: J. V. Wehausen & E. V. Laitone, Surface Waves, 1960, eq. 13.19
    (F. John, Comm. Pure Appl. Math. 3, 1950), for exp(-i w t).
    """
    from scipy.optimize import brentq
    from scipy.special import hankel1, k0

    k, nu = kh, kh * np.tanh(kh)

    def profile(z: float) -> float:
        """cosh k(z + h) / cosh kh."""
        return (np.exp(k * z) + np.exp(-k * (z + 2))) / (1 + np.exp(-2 * k))

    # (k^2 - nu^2) cosh^2 kh = k^2.
    found = 2j * np.pi * k**2 / (k**2 - nu**2 + nu) * profile(z) * profile(source) * hankel1(0, k * distance)
    for m in range(1, int(40 / distance) + 5):
        kn = brentq(lambda y: nu * np.cos(y) + y * np.sin(y), (m - 0.5) * np.pi, m * np.pi)
        weight = 4 * (kn**2 + nu**2) / (kn**2 + nu**2 - nu)
        found += weight * np.cos(kn * (z + 1)) * np.cos(kn * (source + 1)) * k0(kn * distance)
    return found


@pytest.mark.parametrize("kh", [0.01, 0.06, 0.3, 1.0, 2.0, 5.0, 10.2, 20.0])
def test_greens_function_equals_johns_series(kh) -> None:
    side, source = 1e-3, -0.03
    x, y = side / 2 * np.array([-1, 1, 1, -1]), side / 2 * np.array([-1, -1, 1, 1])
    corners = np.stack([x, y, np.full(4, source)], axis=1)
    panel = capytaine.Mesh(corners, [[0, 1, 2, 3]], auto_clean=False, auto_check=False)
    green_function = finite_depth.green_function(capytaine)
    for distance in (0.1, 0.3, 1.0, 3.0, 8.0):
        for z in (-0.02, -0.1):
            single, _ = green_function.evaluate(
                np.array([[distance, 0.0, z]]), panel, wavenumber=kh, water_depth=1.0,
                adjoint_double_layer=False, diagonal_term_in_double_layer=False,
            )  # fmt: skip
            found, expected = -4 * np.pi * single[0, 0] / side**2, john(kh, distance, z, source)
            # The tables of Capytaine's deep water are good to some 1e-3 of the wave; with its own
            # exponentials the error is up to a hundred times as large.
            assert abs(found - expected) < 1e-3 * abs(expected) + 1e-3


@pytest.mark.parametrize("kh", [0.005, 0.03, 0.1, 0.4, 1.0, 3.7, 10.0, 19.9999, 20.0, 35.0, 2e5, np.inf])
def test_the_sum_of_exponentials_matches_the_function_to_1e_5(kh) -> None:
    x = np.append(np.geomspace(1e-4, 1.0, 1001), np.linspace(1.0, 20.0, 1900)) * 0.99997
    x = x[np.abs(x - kh) > 1e-3 * min(kh, 1.0)]
    rates, amplitudes = finite_depth.decomposition(kh)
    assert (rates < 0).all()
    found = np.exp(np.outer(x, rates)) @ amplitudes
    np.testing.assert_allclose(found, finite_depth.rest(kh, x), rtol=0, atol=1e-5)


def test_a_wave_far_longer_than_the_depth_is_refused_with_its_number() -> None:
    with pytest.raises(HydrodynamicsError, match=r"0\.004"):
        finite_depth.decomposition(0.004)


@pytest.mark.thorough
def test_a_long_prism_over_a_far_bottom_has_the_damping_of_deep_water() -> None:
    # Short waves, k h = 19.6. The bottom is felt by the flow near the hull, not by the waves: by the
    # square of half the beam over the depth, 0.4 %.
    hull, omega = parametric(parse_shape(PRISM), PRISM, 600), np.array([8.0])
    deep = solve.solve(hull, Water(), omega, 4, with_lid=False)
    bottom = solve.solve(hull, Water(depth_m=3.0), omega, 4, with_lid=False)
    for name in ("added_mass", "radiation_damping"):
        found, expected = getattr(bottom, name)[:, [1, 2], [1, 2]], getattr(deep, name)[:, [1, 2], [1, 2]]
        np.testing.assert_allclose(found, expected, rtol=0.005)


def test_finite_depth_gives_the_same_bits_again() -> None:
    hull, omega = parametric(parse_shape(PRISM), PRISM, 200), np.array([2.0, 4.0])
    one, two = (solve.solve(hull, Water(depth_m=1.0), omega, 4, with_lid=False) for _ in range(2))
    for name in ("added_mass", "radiation_damping", "added_mass_infinite", "diffraction"):
        np.testing.assert_array_equal(getattr(one, name), getattr(two, name))

"""Response in a random sea by its spectrum: closed forms, sums, runs over seeds."""

from __future__ import annotations

import kingpost
import numpy as np
import pytest
from kingpost.analysis import response, spectral
from kingpost.results.columns import column
from scipy.integrate import quad

HELD = {"bodies.pedestal.joint.revolute.mode": "held", "waves": True}
ELEVATION = "water.wave_elevation"
# What the database of the vessel covers.
COVERED_RAD_S = (0.05984, 2.618)


def deviation(overrides: dict, name: str = ELEVATION) -> float:
    found = spectral.spectral_response("offshore_vessel", [name], overrides=HELD | overrides)
    return float(found.standard_deviation.sel(column=name))


def test_the_elevation_has_the_moments_of_pierson_and_moskowitz() -> None:
    """Source: S(w) = 5/16 Hs^2 wp^4 w^-5 exp(-5/4 (wp/w)^4) (DNV-RP-C205, sec. 3.5.5), with all of its energy
    from half to five times the peak's frequency, and what the database covers of that; by quadrature."""
    height, peak = 2.0, 2 * np.pi / 9.0

    def density(omega: float) -> float:
        return 5 / 16 * height**2 * peak**4 * omega**-5 * np.exp(-1.25 * (peak / omega) ** 4)

    kept = quad(density, 0.5 * peak, 5 * peak, limit=200)[0]
    factor = height**2 / 16 / kept
    end = min(5 * peak, COVERED_RAD_S[1])
    m0, m2 = (factor * quad(lambda w, n=n: w**n * density(w), 0.5 * peak, end, limit=200)[0] for n in (0, 2))
    overrides = {"significant_height_m": height, "peak_period_s": 9.0}
    found = spectral.spectral_response("offshore_vessel", [ELEVATION], overrides=HELD | overrides)
    # The trapezoidal rule over 1500 frequencies.
    assert float(found.standard_deviation[0]) == pytest.approx(np.sqrt(m0), rel=2e-4)
    assert float(found.zero_up_crossing_period[0]) == pytest.approx(2 * np.pi * np.sqrt(m0 / m2), rel=2e-4)


def test_waves_of_one_frequency_have_the_deviation_of_a_sine() -> None:
    """Source: a |H| / sqrt(2)."""
    swell = {"regular": {"height_m": 1.0, "period_s": 8.0, "direction_deg": 150}}
    found = spectral.spectral_response(
        "offshore_vessel", ["hull.pitch"], overrides={"sea.waves": {"swell": swell}}
    )
    exact = kingpost.rao("offshore_vessel", [np.deg2rad(150)], [2 * np.pi / 8], ["hull"])
    pitch = float(exact.rotation.sel(body="hull", angle="pitch").squeeze())
    assert float(found.standard_deviation[0]) == pytest.approx(0.5 * pitch / np.sqrt(2), rel=1e-4)


def test_variances_of_wave_systems_add() -> None:
    """Source: independent seas."""
    swell = {"jonswap": {"significant_height_m": 1.0, "peak_period_s": 14, "direction_deg": 120}}
    none = {"sea.waves.wind_sea.jonswap.enabled": False}
    for name in (ELEVATION, "hull.roll"):
        both, wind = deviation({"sea.waves.swell": swell}, name), deviation({}, name)
        alone = deviation({"sea.waves.swell": swell} | none, name)
        assert both == pytest.approx(np.hypot(wind, alone), rel=1e-4), name


def test_a_spread_sea_is_the_mean_over_its_directions() -> None:
    """Source: Int D(b) |H(w, b)|^2 db with D of cos^2s (DNV-RP-C205, sec. 3.5.8), s = 6, by 73 directions."""
    s, mean_deg = 6.0, 150.0
    spread = {
        "sea.waves.wind_sea.jonswap.realisation": {"spreading_exponent": s},
        "wave_direction_deg": mean_deg,
    }
    found = deviation(spread, "hull.roll")
    beside = np.deg2rad(np.arange(-180, 180, 5))
    weights = np.cos(beside / 2) ** (2 * s)
    simulation = kingpost.Simulation(
        kingpost.load("offshore_vessel", HELD | {"wave_direction_deg": mean_deg})
    )
    directions = np.deg2rad(mean_deg) + beside
    exact = spectral.transfer(simulation, ["hull.roll"], directions, [])
    ((sea,),) = simulation.sea_spectra(exact.omega_rad_s)
    m0 = spectral.moments_of(exact, np.asarray(sea["density_m2_s"]) * exact.weights)[0, :, 0]
    # 24 directions of equal energy: a step of the distribution each, of second order.
    assert found == pytest.approx(np.sqrt((weights * m0).sum() / weights.sum()), rel=0.01)


@pytest.mark.thorough
def test_runs_over_seeds_in_a_small_sea_have_the_deviations() -> None:
    """Source: the engine in time. Of a Gaussian process the variance in a record of T has the variance
    2 pi / T Int S^2 dw (Bendat & Piersol, *Random Data*, 2010, sec. 8.2.2), over all runs an n-th of it:
    nine columns,
    most of them correlated, stay within three of these errors."""
    seeds, start_s, duration_s = 4, 60.0, 660.0
    small = HELD | {
        "significant_height_m": 0.1,
        "wave_direction_deg": 135,
        "simulation.duration_s": duration_s,
        "simulation.record_every_s": 0.5,
    }
    names = ["hull.roll", "hull.pitch", "hull.position.z", "boom.tip.point_position.z", "boom.acceleration.y",
             "load.acceleration.z", "pendant.first.joint_position", "pendant.second.joint_position",
             "pendant.joint_reaction.force_z"]  # fmt: skip
    runs = kingpost.Batch("offshore_vessel", {"simulation.seed": list(range(seeds))}, small).run(threads=1)
    simulation = kingpost.Simulation(kingpost.load("offshore_vessel", small))
    exact = spectral.transfer(simulation, names, [np.deg2rad(135)], [])
    ((sea,),) = simulation.sea_spectra(exact.omega_rad_s)
    density = np.asarray(sea["density_m2_s"])[:, None] * exact.squares[0]
    m0, m00 = (np.einsum("kc,k->c", density**n, exact.weights) for n in (1, 2))
    error = np.sqrt(2 * np.pi / (seeds * (duration_s - start_s)) * m00) / (2 * np.sqrt(m0))
    for name, sigma, standard_error in zip(names, np.sqrt(m0), error, strict=True):
        series = column(runs, name)
        measured = float(np.sqrt(series.sel(time=series.time > start_s).var("time").mean()))
        # The swing's own square is 3 % of the vertical force and acceleration in this sea.
        second_order = 0.04 * sigma if name.endswith(("acceleration.z", "force_z")) else 0.0
        assert abs(measured - sigma) < 3 * standard_error + second_order, (name, measured, sigma)


def test_limits_have_the_probability_of_rice() -> None:
    """Source: 1 - exp(-(T / Tz) exp(-(L - m)^2 / (2 sigma^2))), two bounds by the sum of both rates."""
    limits = {
        "roll": {"column": "hull.roll", "within": 3, "unit": "deg"},
        "rod": {"column": "pendant.joint_reaction.force_z", "at_most": 250, "unit": "kN"},
    }
    overrides = HELD | {"limits": limits, "wave_direction_deg": 120}
    found = spectral.spectral_response("offshore_vessel", [], 1800.0, overrides)
    assert found.column.values.tolist() == ["hull.roll", "pendant.joint_reaction.force_z"]
    bounds = [[-np.deg2rad(3), np.deg2rad(3)], [250e3]]
    for k, levels in enumerate(bounds):
        mean, sigma, period = (float(found[name][k]) for name in
                               ("mean", "standard_deviation", "zero_up_crossing_period"))  # fmt: skip
        rate = sum(np.exp(-((level - mean) ** 2) / (2 * sigma**2)) for level in levels)
        assert float(found.probability[k]) == pytest.approx(1 - np.exp(-1800 / period * rate), rel=1e-9)


def test_the_probability_is_that_of_the_largest_values_of_a_gaussian_process() -> None:
    """Source: 2000 records of sums of sines with random phases; crossings that are rare are independent."""
    rng = np.random.default_rng(5)
    omega = np.linspace(0.6, 1.0, 60)
    duration, t = 600.0, np.arange(0.0, 600.0, 0.4)
    parts = np.exp(-1j * np.outer(omega, t))
    phases = rng.rayleigh(1.0, (2000, 60)) * np.exp(2j * np.pi * rng.random((2000, 60)))
    largest = (phases @ parts).real.max(axis=1) / np.sqrt(60)
    period = 2 * np.pi / np.sqrt((omega**2).mean())
    expected = float(spectral.exceedance((None, 3.2), 0.0, 1.0, period, duration))
    share = float((largest > 3.2).mean())
    # Three errors of a share of 2000, and a tenth of it for crossings that come in groups.
    assert abs(share - expected) < 3 * np.sqrt(expected / 2000) + 0.1 * expected


def test_a_scenario_without_waves_and_a_zero_duration_are_refused() -> None:
    with pytest.raises(kingpost.KingpostError, match=r"sea.waves: found no enabled wave system"):
        spectral.spectral_response("offshore_vessel", ["hull.roll"])
    with pytest.raises(kingpost.KingpostError, match=r"duration_s: found 0, allowed: finite and greater"):
        spectral.spectral_response("offshore_vessel", ["hull.roll"], 0.0, HELD)


def test_the_error_of_interpolation_is_small() -> None:
    """Source: H at 3000 frequencies beside the splines."""
    overrides = HELD | {"wave_direction_deg": 135}
    names = ["hull.roll", "load.acceleration.z", "pendant.second.joint_position"]
    simulation = kingpost.Simulation(kingpost.load("offshore_vessel", overrides))
    found = spectral.spectral_response(simulation, names)
    omega = np.linspace(0.06, 2.617, 3000)
    h = simulation.column_response([np.deg2rad(135)], omega, names)["amplitudes"][0]
    ((sea,),) = simulation.sea_spectra(omega)
    m0 = np.trapezoid(np.asarray(sea["density_m2_s"])[:, None] * np.abs(h) ** 2, omega, axis=0)
    assert found.standard_deviation.values == pytest.approx(np.sqrt(m0), rel=2e-3)
    assert float(found.interpolation_error.max()) < 0.02


def test_the_response_has_the_phase_of_a_run_at_the_reference_point() -> None:
    found = kingpost.wave_response("offshore_vessel", [ELEVATION], [1.0], [0.3, 0.9], HELD)
    assert response.complex_amplitude(found, "response").values == pytest.approx(1.0)

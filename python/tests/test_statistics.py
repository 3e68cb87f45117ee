"""Statistics of records: Gaussian processes of a known spectrum, Gumbel samples, the engine's own sea."""

import numpy as np
import pytest
import xarray
from gaussian_samples import PEAK, WIDTH, density, gaussian_process
from kingpost import KingpostError
from kingpost.analysis import statistics


def test_a_gaussian_process_of_a_known_spectrum_gives_its_variance_and_period() -> None:
    records = [gaussian_process(np.random.default_rng(seed)) for seed in range(10)]
    found = xarray.concat([statistics.summary(record) for record in records], "seed")
    variance = found.sel(statistic="standard_deviation") ** 2
    # The variance of a sample variance is 2 pi Int S^2 dw / T (Bendat & Piersol, Random Data, 8.2).
    error = np.sqrt(2 * np.pi / (2 * WIDTH * np.sqrt(np.pi)) / 10800.0)
    assert abs(float(variance.mean()) - 1) < 4 * error / np.sqrt(10)
    assert float(variance.std()) == pytest.approx(error, rel=0.7)
    period = found.sel(statistic="zero_up_crossing_period")
    assert float(period.mean()) == pytest.approx(2 * np.pi / np.hypot(PEAK, WIDTH), rel=0.003)
    significant = found.sel(statistic="significant_double_amplitude") / found.sel(
        statistic="significant_amplitude"
    )
    assert np.allclose(significant, 2)


@pytest.mark.filterwarnings("error::RuntimeWarning")
@pytest.mark.parametrize("value", [1e308, float("inf")])
def test_sums_beyond_the_largest_number_are_infinite_or_nan_without_a_librarys_warning(value) -> None:
    """Source: a result in a file has any number; its extremes are what they are."""
    record = xarray.DataArray([value, value, value, 0.0], {"time": range(4)}, ("time",), "heave")
    found = statistics.summary(record)
    assert float(found.sel(statistic="maximum")) == value
    assert float(found.sel(statistic="minimum")) == 0
    assert not np.isfinite(found.sel(statistic="standard_deviation"))


def test_a_known_spectrum_is_recovered_with_its_moments() -> None:
    records = xarray.concat([gaussian_process(np.random.default_rng(seed)) for seed in range(4)], "run")
    found = statistics.spectrum(records, segment_s=400.0)
    assert found.dims == ("run", "omega")
    assert found.attrs["units"] == "(m)^2 s/rad"
    # Fifty segments a record and four of them: 7 % of error by line, and the window's own smearing.
    mean = found.mean("run")
    assert float(mean.max()) == pytest.approx(density(PEAK), rel=0.15)
    m0, m1, m2, _ = statistics.moments(mean).values
    variance = float((records.std("time") ** 2).mean())
    assert m0 == pytest.approx(variance, rel=0.01)
    assert m1 / m0 == pytest.approx(PEAK, rel=0.005)
    assert np.sqrt(m0 / m2) == pytest.approx(1 / np.hypot(PEAK, WIDTH), rel=0.005)


def test_a_sine_gives_all_of_its_power_to_its_line() -> None:
    time = 0.25 * np.arange(4000)
    wave = xarray.DataArray(3 * np.cos(2 * np.pi * time / 10), {"time": time}, ("time",), "roll")
    found = statistics.spectrum(wave, segment_s=100.0)
    assert float(found.integrate("omega")) == pytest.approx(4.5, rel=1e-3)
    assert float(found.idxmax("omega")) == pytest.approx(2 * np.pi / 10)


@pytest.mark.parametrize("length", [500, 501])
def test_the_spectrum_is_welchs_average_of_periodograms(length: int) -> None:
    """P. D. Welch, IEEE Trans. Audio Electroacoust. 15(2), 1967: segments that overlap by half, Hann windows
    over a period, squares over the window's. To rounding of some thousand sums."""
    record = gaussian_process(np.random.default_rng(5), duration_s=1000.0)
    found = statistics.spectrum(record, segment_s=0.25 * length)
    values = record.values - record.values.mean()
    window = 0.5 - 0.5 * np.cos(2 * np.pi * np.arange(length) / length)
    starts = range(0, len(values) - length + 1, length // 2)
    squares = [np.abs(np.fft.rfft(values[at : at + length] * window)) ** 2 for at in starts]
    sides = np.where(np.arange(length // 2 + 1) * 2 % length, 2.0, 1.0)
    expected = np.mean(squares, axis=0) * sides * 0.25 / (window**2).sum() / (2 * np.pi)
    assert np.allclose(found["omega"], 2 * np.pi * np.fft.rfftfreq(length, 0.25), rtol=1e-14)
    assert np.allclose(found, expected, rtol=1e-11, atol=1e-14 * expected.max())


def test_the_largest_value_of_three_hours_is_that_of_rayleigh_peaks() -> None:
    """Cartwright & Longuet-Higgins (Proc. Roy. Soc. A 237, 1956): of N peaks the largest is
    sigma (sqrt(2 ln N) + gamma / sqrt(2 ln N)) on average."""
    maxima = [float(gaussian_process(np.random.default_rng(seed)).max()) for seed in range(120)]
    found = statistics.extreme(maxima, record_s=10800.0)
    peaks = 10800.0 * np.hypot(PEAK, WIDTH) / (2 * np.pi)
    root = np.sqrt(2 * np.log(peaks))
    # Neighbouring peaks are alike and records miss the very tops, which lowers it by about a per cent.
    assert found.expected == pytest.approx(root + statistics.EULER / root, rel=0.02)
    assert found.expected_error == pytest.approx(np.std(maxima) / np.sqrt(120), rel=0.25)


def test_gumbel_parameters_are_recovered_within_their_standard_error() -> None:
    rng = np.random.default_rng(7)
    fits = [statistics.extreme(rng.gumbel(7.0, 0.5, 40), record_s=10800.0) for _ in range(400)]
    location, scale = (np.array([getattr(fit, name) for fit in fits]) for name in ("location", "scale"))
    errors = np.sqrt(np.mean([np.diag(fit.covariance) for fit in fits], axis=0))
    for values, true, error in ((location, 7.0, errors[0]), (scale, 0.5, errors[1])):
        # A deviation of 400 fits is known to 3.5 %.
        assert abs(values.mean() - true) < 4 * error / np.sqrt(400)
        assert values.std() == pytest.approx(error, rel=0.15)
    high = np.array([fit.quantile(0.9) for fit in fits])
    assert high.std() == pytest.approx(np.mean([fit.quantile_error(0.9) for fit in fits]), rel=0.15)


def test_five_records_give_a_gumbel_distribution_without_bias_and_their_errors() -> None:
    """L-moments are free of bias for any number of records, and the errors are those of this number."""
    rng = np.random.default_rng(11)
    fits = [statistics.extreme(rng.gumbel(7.0, 0.5, 5), record_s=1800.0) for _ in range(4000)]
    mean = {name: np.mean([getattr(fit, name) for fit in fits]) for name in ("scale", "expected")}
    true = {"scale": 0.5, "expected": 7.0 + 0.5 * (np.log(6) + statistics.EULER)}
    spread = {name: np.std([getattr(fit, name) for fit in fits]) for name in true}
    for name, value in true.items():
        assert abs(mean[name] - value) < 4 * spread[name] / np.sqrt(4000)
    # An error is in proportion to its own fit's scale: their mean square is larger by the variance of that.
    square = np.mean([(fit.expected_error / fit.scale * 0.5) ** 2 for fit in fits])
    assert spread["expected"] == pytest.approx(np.sqrt(square), rel=0.05)


def test_the_extreme_of_a_longer_time_is_the_largest_of_its_parts() -> None:
    rng = np.random.default_rng(3)
    parts = rng.gumbel(5.0, 0.3, (6, 3000))
    whole = statistics.extreme(parts.max(axis=0), record_s=10800.0)
    by_parts = statistics.extreme(parts.ravel(), record_s=1800.0)
    error = np.hypot(whole.expected_error, by_parts.expected_error)
    assert abs(whole.expected - by_parts.expected) < 4 * error
    assert by_parts.expected_error > 0


def test_the_start_of_a_record_is_left_out_and_the_rest_kept() -> None:
    time = np.arange(0.0, 101.0)
    series = xarray.DataArray(np.where(time < 20, 50.0, np.sin(time)), {"time": time}, ("time",), "sway")
    results = xarray.Dataset({"sway": series, "mass": 3.0})
    found = statistics.summary(results, after_s=20.0)
    assert float(found["sway"].sel(statistic="maximum")) < 1.01
    assert float(found["mass"]) == 3.0


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda s: statistics.summary(s, after_s=200.0), "after_s: found 200 s"),
        (lambda s: statistics.summary(s.rename(time="place")), "allowed: time among them"),
        (lambda s: statistics.spectrum(s, segment_s=1e4), "segment_s: found 10000 s"),
        (lambda s: statistics.spectrum(s.isel(time=[0, 1, 2, 4, 5, 6, 9, 10, 13])), "allowed: even steps"),
        (lambda s: statistics.extreme([1.0, 2.0], 10.0), "maxima: found 2 values"),
        (lambda s: statistics.extreme([1.0] * 9, 10.0), "values that differ"),
        (lambda s: statistics.extreme([1.0, 2, 3, 4, np.nan], 10.0), "all finite"),
        (lambda s: statistics.extreme([1.0, 2, 3, 4, 5], 0.0), "record_s: found 0"),
        (lambda s: statistics.extreme([1.0, 2, 3, 4, 5], 9.0).quantile(1.0), "probability: found 1"),
    ],
)  # fmt: skip
def test_bad_input_is_named(call, message: str) -> None:
    time = np.arange(0.0, 100.0)
    with pytest.raises(KingpostError, match=message):
        call(xarray.DataArray(np.sin(time), {"time": time}, ("time",), "sway"))

"""Extremes of Gaussian processes with a known spectrum, and of samples of the fitted distributions. The true
quantile of the process is from a million records: `python python/tests/test_extremes.py`.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from kingpost import KingpostError
from kingpost.analysis import extremes, statistics
from lanes import sampled
from scipy import stats

# A spectrum as broad as that of a sea, m0 = 1, about 0.8 rad/s; records of ten minutes.
PEAK, WIDTH = 0.8, 0.2
RECORD_S, STEP_S = 600.0, 0.5
ROWS = round(RECORD_S / STEP_S)
RUNS, TRIALS = 10, 400
TRUE = {1: 3.6101, 3: 3.8986}
"""Quantile 0.9 of the largest value of one record and of three; the command above prints them, +- 0.001."""


def records(rng: np.random.Generator, count: int) -> np.ndarray:
    """Rows of the process: normal amplitudes at the lines of a record, so that it is exactly Gaussian."""
    omega = 2 * np.pi * np.fft.rfftfreq(ROWS, STEP_S)
    density = np.exp(-0.5 * ((omega - PEAK) / WIDTH) ** 2) / (WIDTH * np.sqrt(2 * np.pi))
    size = np.sqrt(density * (omega[1] - omega[0]))
    phasors = rng.standard_normal((count, len(omega))) - 1j * rng.standard_normal((count, len(omega)))
    return np.fft.irfft(size * phasors, ROWS, axis=-1) * ROWS / 2


def gumbel(rows: np.ndarray, duration_s: float) -> extremes.Extreme:
    return extremes.extreme(rows.max(axis=1), RECORD_S, duration_s)


def weibull(rows: np.ndarray, duration_s: float) -> extremes.TailExtreme:
    found = [extremes.peaks(row, rows.mean()) for row in rows]
    return extremes.weibull(found, RECORD_S, duration_s, mean=rows.mean())


def pareto(rows: np.ndarray, duration_s: float) -> extremes.TailExtreme:
    found = [extremes.peaks(row, rows.mean()) for row in rows]
    return extremes.over_threshold(found, RECORD_S, duration_s)


@pytest.mark.parametrize("fit", sampled([gumbel, weibull, pareto], keep=[gumbel]))
@pytest.mark.parametrize("lasts", [1, 3], ids=["one record", "three records"])
def test_intervals_of_ten_seeds_cover_the_true_quantile_of_a_gaussian_process(
    fit: Callable[[np.ndarray, float], extremes.Extreme | extremes.TailExtreme], lasts: int
) -> None:
    """90 % intervals of the quantile 0.9 of an operation; 400 trials know the coverage to 1.5 %: 3 is two of
    these errors."""
    covered = 0
    for trial in range(TRIALS):
        rows = records(np.random.Generator(np.random.Philox([lasts, trial])), RUNS)
        low, high = fit(rows, lasts * RECORD_S).interval(0.9, confidence=0.9)
        covered += low <= TRUE[lasts] <= high
    assert covered / TRIALS == pytest.approx(0.90, abs=0.03)


def test_the_true_quantile_is_near_that_of_independent_up_crossings() -> None:
    """Rice (Bell Syst. Tech. J. 24, 1945): exp(-T / Tz exp(-x^2 / 2)). Crossings come in groups and rows
    miss the very tops, each of which lowers it, by a per cent together."""
    for lasts, true in TRUE.items():
        crossings = lasts * RECORD_S * np.hypot(PEAK, WIDTH) / (2 * np.pi)
        assert true == pytest.approx(np.sqrt(2 * np.log(crossings / -np.log(0.9))), rel=0.01)
        assert true < np.sqrt(2 * np.log(crossings / -np.log(0.9)))


@pytest.mark.parametrize("count", [5, 10, 40])
def test_intervals_are_exact_for_gumbel_samples_of_any_number(count: int) -> None:
    rng = np.random.default_rng(count)
    true = 7.0 + 0.5 * (np.log(3) - np.log(-np.log(0.9)))
    fits = [extremes.extreme(rng.gumbel(7.0, 0.5, count), 600.0, 1800.0) for _ in range(2000)]
    limits = np.array([fit.interval(0.9) for fit in fits])
    below, above = (true < limits[:, 0]).mean(), (true > limits[:, 1]).mean()
    # 5 % of 2000 trials are known to 0.5 %.
    assert below == pytest.approx(0.05, abs=0.02)
    assert above == pytest.approx(0.05, abs=0.02)
    expected = np.array([fit.expected_interval(0.8) for fit in fits])
    mean = 7.0 + 0.5 * (np.log(3) + extremes.EULER)
    assert ((expected[:, 0] <= mean) & (mean <= expected[:, 1])).mean() == pytest.approx(0.8, abs=0.036)


def test_an_interval_of_the_probability_is_that_of_the_quantile_read_the_other_way() -> None:
    rng = np.random.default_rng(2)
    covered = []
    for _ in range(400):
        found = extremes.extreme(rng.gumbel(7.0, 0.5, 10), 600.0, 600.0)
        low, high = found.exceedance_interval(8.0)
        assert low <= found.exceedance(8.0) <= high
        # At its ends the level is the end of the quantile's interval, within the table's steps.
        for side, end in ((low, 0), (high, 1)):
            if 1e-5 < side < 0.999:
                assert found.interval(1 - side)[end] == pytest.approx(8.0, abs=0.05)
        covered.append(low <= 1 - np.exp(-np.exp(-2.0)) <= high)
    assert np.mean(covered) == pytest.approx(0.9, abs=0.045)
    assert found.exceedance(found.quantile(0.9)) == pytest.approx(0.1)
    assert found.exceedance_interval(1e3) == (0.0, pytest.approx(0.0, abs=1e-6))
    assert found.exceedance_interval(-1e3) == (1.0, 1.0)


def test_intervals_do_not_depend_on_units_nor_on_the_order_of_the_seeds() -> None:
    maxima = np.random.default_rng(4).gumbel(2.0, 0.1, 10)
    found, other = (extremes.extreme(x, 600.0) for x in (maxima, 1e6 * maxima[::-1] + 5e6))
    assert np.allclose(1e6 * np.array(found.interval(0.9)) + 5e6, other.interval(0.9), rtol=1e-12)
    assert found.exceedance_interval(2.5) == pytest.approx(other.exceedance_interval(7.5e6), rel=1e-9)


def test_exponential_peaks_give_their_scale_and_cover_their_quantile() -> None:
    rng = np.random.default_rng(6)
    covered = {"exponential": 0, "generalised_pareto": 0}
    true = np.log(75 * 3 / -np.log(0.9))
    for _ in range(400):
        runs = [rng.exponential(1.0, rng.poisson(75)) for _ in range(10)]
        for name in covered:
            low, high = extremes.over_threshold(runs, 600.0, 1800.0, name).interval(0.9)
            covered[name] += low <= true <= high
    # Two and a half errors of 400 trials.
    assert {name: count / 400 for name, count in covered.items()} == pytest.approx(
        {"exponential": 0.9, "generalised_pareto": 0.9}, abs=0.0375
    )


def test_the_parameters_of_a_generalised_pareto_tail_are_recovered() -> None:
    rng = np.random.default_rng(8)
    runs = stats.genpareto(-0.2, 3.0, 0.5).rvs((200, 100), random_state=rng)
    found = extremes.over_threshold(runs, 600.0, 600.0, threshold=3.0)
    # 20,000 peaks: the shape is known to about (1 - shape)(1 - 2 shape) / sqrt(20000), 0.012.
    assert found.parameters["shape"] == pytest.approx(-0.2, abs=0.04)
    assert found.parameters["scale"] == pytest.approx(0.5, rel=0.04)
    assert found.parameters["rate_per_s"] == pytest.approx(100 / 600)
    true = stats.genpareto(-0.2, 3.0, 0.5).isf(-np.log(0.9) / 100)
    assert found.quantile(0.9) == pytest.approx(true, rel=0.02)
    assert found.exceedance(found.quantile(0.9)) == pytest.approx(0.1)
    assert found.fits.shape == (1 + 20, 3)


@pytest.mark.parametrize("threshold", [0.0, 1.0])
def test_rayleigh_peaks_give_a_weibull_shape_of_two_at_any_threshold(threshold: float) -> None:
    rng = np.random.default_rng(9)
    runs = 5.0 + rng.rayleigh(1.5, (100, 200))
    found = extremes.weibull(runs, 600.0, 600.0, mean=5.0, threshold=5.0 + threshold)
    assert found.parameters["shape"] == pytest.approx(2.0, abs=0.06)
    assert found.parameters["scale"] == pytest.approx(1.5 * np.sqrt(2), rel=0.03)
    assert found.most_probable == pytest.approx(5.0 + 1.5 * np.sqrt(2 * np.log(200)), rel=0.02)
    assert found.exceedance(found.quantile(0.9)) == pytest.approx(0.1)
    assert found.exceedance(11.0) == pytest.approx(-np.expm1(-200 * np.exp(-0.5 * (6 / 1.5) ** 2)), rel=0.15)


def test_the_largest_peaks_of_each_run_are_enough_if_the_count_of_all_is_given() -> None:
    rng = np.random.default_rng(10)
    runs = [rng.rayleigh(1.0, 75) for _ in range(10)]
    largest = [np.sort(run)[-48:] for run in runs]
    for fit in (extremes.weibull, extremes.over_threshold):
        whole, kept = fit(runs, 600.0), fit(largest, 600.0, counts=[75] * 10)  # type: ignore[operator]
        assert np.allclose(whole.fits, kept.fits, rtol=1e-12)
        assert whole.interval(0.9) == pytest.approx(kept.interval(0.9))
    with pytest.raises(KingpostError, match="found the largest 20 of 75 peaks, allowed: all peaks above"):
        extremes.weibull([np.sort(run)[-20:] for run in runs], 600.0, threshold=1.0, counts=[75] * 10)


def test_peaks_are_one_for_each_cycle_about_the_mean() -> None:
    time = np.arange(0.0, 100.0, 0.05)
    ripple = np.sin(2 * np.pi * time / 10) + 0.1 * np.sin(2 * np.pi * time / 0.7)
    assert len(extremes.peaks(ripple, 0.0)) in (8, 9)
    assert len(extremes.peaks(np.ones(50))) == 0


def test_the_module_statistics_keeps_its_public_names() -> None:
    assert statistics.extreme is extremes.extreme
    assert statistics.THREE_HOURS_S == extremes.THREE_HOURS_S


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: extremes.extreme([1, 2, 3, 4, 5.0], 9.0).interval(0.9, 1.0), "confidence: found 1, allowed"),
        (lambda: extremes.over_threshold([[1.0]] * 4, 600.0), "runs: found 4, allowed: 5 or more"),
        (lambda: extremes.over_threshold([[1.0, 2.0]] * 5, 600.0), "peaks over the threshold: found 1"),
        (lambda: extremes.over_threshold([[1.0] * 9] * 5, 600.0, threshold=0.5), "peaks over 0.5: found 45"),
        (lambda: extremes.over_threshold([[1.0]] * 5, -1.0), "record_s: found -1, allowed"),
        (lambda: extremes.over_threshold([[1.0]] * 5, 1.0, 1.0, "weibull"), "distribution: found 'weibull'"),
        (lambda: extremes.weibull(ranks(), 600.0, mean=70.0), "threshold: found 38, allowed: the mean 70"),
        (
            lambda: extremes.weibull(ranks(), 600.0, 60.0).quantile(0.01),
            "probability: found 0.01, allowed: more",
        ),
        (lambda: extremes.weibull(ranks(), 600.0).exceedance(1.0), "level: found 1, allowed: the threshold"),
    ],
)
def test_samples_that_cannot_be_fitted_are_refused(call: Callable[[], object], message: str) -> None:
    with pytest.raises(KingpostError, match=message):
        call()


def ranks() -> list[np.ndarray]:
    return [np.arange(1.0, 76.0)] * 10


def main() -> None:
    """The true quantiles, from a million records."""
    rng = np.random.Generator(np.random.Philox(1))
    largest = np.concatenate([records(rng, 5000).max(axis=1) for _ in range(200)])
    for lasts in TRUE:
        # Records are independent: the largest of three is below x with the third power of the probability.
        level = np.quantile(largest, 0.9 ** (1 / lasts))
        density = np.mean(np.abs(largest - level) < 0.02) / 0.04
        error = np.sqrt(0.9 ** (1 / lasts) * (1 - 0.9 ** (1 / lasts)) / len(largest)) / density
        print(f"{lasts}: {level:.4f} +- {error:.4f}")


if __name__ == "__main__":
    main()

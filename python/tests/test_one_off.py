"""Largest values of operations that happen once: order statistics, numbers of seeds, parts joined."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from kingpost import KingpostError
from kingpost.analysis import extremes
from kingpost.analysis.extremes import Joined, extreme, one_off
from kingpost.analysis.extremes.joined import Constant
from scipy import stats

STUDIES = 400
OF = {
    "gumbel": stats.gumbel_r(7.0, 0.5),
    "weibull": stats.weibull_min(2.0),
    "lognormal": stats.lognorm(0.5),
    "bounded": stats.beta(2.0, 1.2),
}
"""Distributions of the largest value of an operation; the last is bounded, as that of a blocked winch."""
CASES = [(10, 0.5), (40, 0.9)]
"""Seeds, and the quantile whose interval they give."""


def coverage(name: str, seeds: int, probability: float, studies: int) -> float:
    """Share of the synthetic studies whose 90 % interval holds the true quantile."""
    rng = np.random.Generator(np.random.Philox([seeds, list(OF).index(name)]))
    maxima = OF[name].ppf(rng.uniform(size=(studies, seeds)))
    true = OF[name].ppf(probability)
    ends = np.array([one_off(of).interval(probability, 0.9) for of in maxima])
    return float(np.mean((ends[:, 0] <= true) & (true <= ends[:, 1])))


@pytest.mark.parametrize("name", OF)
@pytest.mark.parametrize(("seeds", "probability"), CASES)
def test_intervals_of_400_studies_cover_the_true_quantile(name: str, seeds: int, probability: float) -> None:
    """Source: the sampled distribution. 400 studies know the coverage to 1.5 %: 3 is two of these errors."""
    assert coverage(name, seeds, probability, STUDIES) == pytest.approx(0.90, abs=0.03)


@pytest.mark.thorough
@pytest.mark.parametrize("name", OF)
@pytest.mark.parametrize(
    ("seeds", "probability"), [*CASES, (20, 0.5), (29, 0.9), (30, 0.9), (35, 0.9), (60, 0.95), (100, 0.9)]
)
def test_intervals_of_many_studies_cover_the_true_quantile(name: str, seeds: int, probability: float) -> None:
    """Source: the sampled distribution. 10,000 studies know the coverage to 0.3 %; the interpolation between
    the two largest values, for which a bounded distribution is the worst case, takes 1 % more."""
    assert coverage(name, seeds, probability, 10_000) == pytest.approx(0.90, abs=0.02)


@pytest.mark.thorough
def test_a_gumbel_distribution_would_not_cover_the_quantile_of_a_bounded_operation() -> None:
    """Source: the sampled distribution; the reason why operations that happen once are not fitted."""
    rng = np.random.Generator(np.random.Philox(3))
    ends = [extreme(OF["bounded"].ppf(rng.uniform(size=40)), 1.0, 1.0).interval(0.9) for _ in range(STUDIES)]
    true = OF["bounded"].ppf(0.9)
    assert np.mean([low <= true <= high for low, high in ends]) < 0.8


def test_the_numbers_of_seeds_are_those_of_the_binomial_distribution() -> None:
    """Source: ln(1 - c) / ln(1 - p); 59 for 5 % at 95 % is Wilks's number. The largest of 29 values is an
    upper limit of the quantile 0.9 at 95 %, that of 28 is not."""
    assert extremes.seeds_without_exceedance(0.05, 0.95) == 59
    assert extremes.seeds_without_exceedance(0.1, 0.9) == 22
    assert extremes.seeds_without_exceedance(0.5, 0.5) == 1
    for seeds, is_finite in ((29, True), (28, False)):
        assert np.isfinite(one_off(np.arange(seeds)).interval(0.9, 0.9)[1]) == is_finite
    assert extremes.seeds_for_interval(0.1, 0.9) == 29


def test_the_quantile_needs_the_seeds_that_are_said() -> None:
    fewest = extremes.seeds_for_quantile(0.1)
    assert one_off(np.arange(fewest)).quantile(0.9) <= fewest - 1
    with pytest.raises(
        KingpostError, match=r"realisations: found 6, allowed: 7 or more for the quantile 0\.9"
    ):
        one_off(np.arange(fewest - 1)).quantile(0.9)


def test_no_exceedance_in_n_seeds_leaves_the_closed_form_of_the_upper_limit() -> None:
    """Source: (1 - P)^n is half of 1 - c."""
    low, high = one_off(np.arange(22)).exceedance_interval(100.0, 0.8)
    assert (low, high) == (0.0, pytest.approx(1 - 0.1 ** (1 / 22)))
    assert one_off(np.arange(22)).exceedance(100.0) == 0


def test_the_exceedance_is_the_quantile_read_the_other_way() -> None:
    found = one_off(np.random.default_rng(2).gumbel(size=12))
    for probability in (0.1, 0.5, 0.83):
        assert found.exceedance(found.quantile(probability)) == pytest.approx(1 - probability)


def test_nothing_of_a_sample_depends_on_units() -> None:
    x = np.random.default_rng(3).gumbel(size=30)
    small, large = one_off(x), one_off(1e3 * x + 5e3)
    assert large.quantile(0.8) == pytest.approx(1e3 * small.quantile(0.8) + 5e3)
    assert large.interval(0.8) == pytest.approx([1e3 * end + 5e3 for end in small.interval(0.8)])


def gumbel(location: float, scale: float) -> extremes.Extreme:
    """An estimate that is exact."""
    nothing = np.zeros((2, 2))
    return extremes.Extreme(location, scale, 1.0, 10, nothing, 1.0, nothing)


def test_the_product_of_two_gumbel_distributions_of_one_scale_is_a_gumbel_distribution() -> None:
    """Source: exp(-e^-(x - a)) exp(-e^-(x - b)) has the location ln(e^a + e^b)."""
    joined = Joined((gumbel(3.0, 1.0), gumbel(4.0, 1.0)), (0.0, 10.0))
    whole = gumbel(np.log(np.exp(3.0) + np.exp(4.0)), 1.0)
    for probability in (0.1, 0.5, 0.99):
        assert joined.quantile(probability) == pytest.approx(whole.quantile(probability), rel=1e-9)
    assert joined.exceedance(5.0) == pytest.approx(whole.exceedance(5.0))


def test_a_part_that_stays_below_changes_nothing() -> None:
    found = one_off(np.random.default_rng(4).gumbel(size=40))
    joined = Joined((found, Constant(-100.0)), (-100.0, float(found.maxima[-1])))
    assert joined.quantile(0.9) == pytest.approx(found.quantile(0.9), rel=1e-9)
    assert joined.exceedance_interval(1.0) == found.exceedance_interval(1.0)
    # The interval is by counts, without the interpolation between two of them.
    low, high = joined.interval(0.9)
    assert low <= found.interval(0.9)[0] + 1e-9 < found.quantile(0.9) < found.interval(0.9)[1] - 1e-9 <= high


def of_parts(rng: np.random.Generator, seeds: int) -> Joined:
    """A lift-off, lognormal, and a hold, ten times as long as in the runs."""
    once, held = OF["lognormal"].ppf(rng.uniform(size=seeds)), rng.gumbel(1.0, 0.2, seeds)
    every = np.concatenate([once, held])
    return Joined((one_off(once), extreme(held, 60.0, 600.0)), (float(every.min()), float(every.max())))


def test_the_interval_of_joined_parts_covers_the_true_quantile() -> None:
    """Source: the product of the sampled distributions, by bisection. Parts that contribute alike cover more
    often than 90 %; 100 studies know it to 3 %."""
    rng = np.random.Generator(np.random.Philox(5))
    below: Callable[[float], float] = lambda x: (  # noqa: E731
        float(OF["lognormal"].cdf(x) * stats.gumbel_r(1 + 0.2 * np.log(10), 0.2).cdf(x))
    )
    low, high = 0.0, 20.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if below(middle) < 0.9 else (low, middle)
    ends = [of_parts(rng, 40).interval(0.9) for _ in range(100)]
    assert np.mean([least <= high <= most for least, most in ends]) > 0.84


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: one_off([1.0]), "maxima: found 1 values, allowed: 2 or more"),
        (lambda: one_off([1.0, np.nan]), "maxima: found 2 values, allowed: 2 or more, all finite"),
        (lambda: one_off([1.0, 2.0]).interval(1.0), "probability: found 1, allowed: between 0 and 1"),
        (lambda: one_off([1.0, 2.0]).interval(0.5, 0.0), "confidence: found 0, allowed: between 0 and 1"),
        (lambda: extremes.seeds_without_exceedance(0.0), "probability: found 0, allowed: between 0 and 1"),
    ],
)
def test_samples_and_probabilities_that_are_none_are_refused(
    call: Callable[[], object], message: str
) -> None:
    with pytest.raises(KingpostError, match=message):
        call()

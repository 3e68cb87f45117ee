"""Limiting heights of operations that happen once, and physical bounds of what is extrapolated."""

from __future__ import annotations

from dataclasses import replace

import kingpost
import numpy as np
import pytest
import xarray
from kingpost import KingpostError
from kingpost.reports import statistics as statistics_report
from kingpost.reports.limiting import accepted_text, height_text, interval_text
from kingpost.results.bounds import bounds
from kingpost.study.design import file
from kingpost.study.design.parts import parts
from kingpost.study.design.plan import plan
from kingpost.study.limiting.runs import limiting_heights
from kingpost.study.seeds import SeedCount, kind_of_runs, too_few
from kingpost.study_report.limiting_figure import draw
from scipy import stats

HEIGHTS = (1.0, 2.0, 3.0)
OF_METRE = stats.lognorm(0.2)
"""Largest value of an operation in a metre of height: its response is in proportion to the height."""
BOUND, ACCEPTANCE = 3.0, 0.1
LIFT = {"version": 1, "title": "Lift", "scenario": "lift_off_from_barge", "seeds": {"count": 10}}


def results(seeds: int, seed: int = 1, period_s: tuple[float, ...] = (8.0,)) -> xarray.Dataset:
    """Results of a study of an operation that happens once, as a study's store has them."""
    rng = np.random.default_rng(seed)
    axes = {"hs": HEIGHTS, "tp": period_s}
    grid = np.meshgrid(*axes.values(), np.arange(1, seeds + 1), indexing="ij")
    flat = {name: one.ravel() for name, one in zip([*axes, "seed"], grid, strict=True)}
    worst = flat["hs"] * OF_METRE.ppf(rng.uniform(size=len(flat["hs"])))
    return xarray.Dataset(
        {
            "limit_worst": (("run", "limit"), worst[:, None]),
            "status": ("run", np.zeros(len(worst), "i1")),
        },
        {name: ("run", values) for name, values in flat.items()}
        | {"limit": ["snap"], "at_least": ("limit", [np.nan]), "at_most": ("limit", [BOUND])},
        {"axes": " ".join(axes), "sea_significant_height": "hs", "sea_peak_period": "tp", "title": "made up",
         "duration_s": 200.0, "after_s": 0.0, "operation_s": 200.0, "acceptance": ACCEPTANCE, "one_off": 1},
    )  # fmt: skip


def with_steps(runs: xarray.Dataset, held_s: float, hold: np.ndarray) -> xarray.Dataset:
    """The same operation with a hold of 100 s at its end that is extrapolated to `held_s`."""
    count = runs.sizes["run"]
    worst = np.stack([runs["limit_worst"].values, hold[:, None]], axis=1)
    return runs.assign(
        step_limit_worst=(("run", "step", "limit"), worst),
        step_begin=(("run", "step"), np.tile([0.0, 100.0], (count, 1))),
        step_end=(("run", "step"), np.tile([100.0, 200.0], (count, 1))),
    ).assign_coords(
        step_name=("step", ["lift off", "hold"]),
        stationary_s=("step", [np.nan, held_s]),
        limit_from_s=("limit", [0.0]),
    )


def test_an_operation_that_happens_once_is_not_extrapolated() -> None:
    """Source: closed form: the height at which the quantile 0.9 of the sampled distribution is the bound.
    5000 seeds know it to 0.4 %; four of these errors."""
    found = limiting_heights(results(5000))
    assert float(found["limiting_height"][0, 0]) == pytest.approx(BOUND / OF_METRE.ppf(0.9), rel=0.016)
    longer = results(5000).assign_attrs(operation_s=1800.0, duration_s=20.0)
    assert limiting_heights(longer)["limiting_height"].equals(found["limiting_height"])
    assert accepted_text(found.attrs) == "10 % in an operation"
    with pytest.raises(
        KingpostError, match="operation_s: found 1800, allowed: none for runs that happen once"
    ):
        limiting_heights(results(50), operation_s=1800.0)


def test_a_stationary_step_is_extrapolated_by_its_own_length_and_joined() -> None:
    """Source: closed form: P(x) is that of the operation times that of nine holds of a Gumbel distribution.
    5000 seeds know the height to 0.5 %; four of these errors."""
    runs = results(5000)
    hs = runs["hs"].values
    hold = hs * (0.9 + 0.1 * np.random.default_rng(2).gumbel(size=len(hs)))
    found = limiting_heights(with_steps(runs, 900.0, hold))
    of_hold = stats.gumbel_r(0.9 + 0.1 * np.log(9), 0.1)
    low, high = 0.5, 3.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        exceeded = 1 - OF_METRE.cdf(BOUND / middle) * of_hold.cdf(BOUND / middle)
        low, high = (middle, high) if exceeded < ACCEPTANCE else (low, middle)
    assert float(found["limiting_height"][0, 0]) == pytest.approx(low, rel=0.02)
    assert low < 0.97 * BOUND / OF_METRE.ppf(0.9)
    # A hold as long as in the runs is the largest of both parts, as sampled.
    both = np.maximum(runs["limit_worst"].values[:, 0], hold)
    as_sampled = limiting_heights(runs.assign(limit_worst=(("run", "limit"), both[:, None])))
    as_long = limiting_heights(with_steps(runs, 100.0, hold))
    expected = float(as_sampled["limiting_height"][0, 0])
    assert float(as_long["limiting_height"][0, 0]) == pytest.approx(expected, rel=0.01)


def test_few_seeds_give_an_interval_from_below_the_smallest_height_and_fewer_give_none() -> None:
    """Source: 29 is ln 0.05 / ln 0.9 rounded up; with fewer the interval of the quantile has no upper end."""
    few = limiting_heights(results(28))
    assert float(few["limiting_height_low"][0, 0]) == 0
    assert interval_text(few, (0,)).startswith("below 1 to ")
    assert float(limiting_heights(results(29))["limiting_height_low"][0, 0]) > 1
    with pytest.raises(KingpostError, match="seeds: found 6, allowed: 7 or more"):
        limiting_heights(results(6))


def test_the_interval_of_a_limiting_height_covers_the_true_one() -> None:
    """Source: the sampled distribution. 200 studies know the coverage to 2 %: 4 is two of these errors."""
    true = BOUND / OF_METRE.ppf(0.9)
    ends = [limiting_heights(results(40, seed)) for seed in range(200)]
    covered = [
        float(one["limiting_height_low"].item()) <= true <= float(one["limiting_height_high"].item())
        for one in ends
    ]
    assert np.mean(covered) > 0.86


def test_a_limit_that_physics_keeps_is_never_exceeded() -> None:
    """Source: a rope only pulls: its tension is at least 0 whatever a fitted distribution says."""
    runs = results(10).drop_vars(["at_most", "at_least"])
    tension = 200 + 100 * np.random.default_rng(4).gumbel(size=runs.sizes["run"]).clip(-1.9, 1.5)
    runs["limit_worst"] = (("run", "limit"), tension[:, None])
    bounds_of = {"at_least": ("limit", [0.0]), "at_most": ("limit", [np.nan])}
    named = {"limit_column": ("limit", ["rope.rope_tension"]), "limit_unit_si": ("limit", [1.0])}
    stationary = runs.assign_attrs(one_off=0, operation_s=1e6)
    assert (limiting_heights(stationary.assign_coords(bounds_of))["limiting_height"] == 0).all()
    found = limiting_heights(stationary.assign_coords(bounds_of | named))
    assert (found["limiting_height_state"] == "above").all()
    assert (found["probability"] == 0).all()


@pytest.mark.parametrize(
    ("column", "least", "most"),
    [
        ("hull.pitch", -np.pi / 2, np.pi / 2),
        ("a.rope_tension", 0.0, np.inf),
        ("a.clearance", -np.inf, np.inf),
    ],
)
def test_bounds_are_those_of_the_columns_kind(column: str, least: float, most: float) -> None:
    assert bounds(column) == (least, most)


def test_the_expected_smallest_tension_of_three_hours_is_not_negative() -> None:
    """Source: a rope only pulls; ten records of 100 s with a least tension of some newtons."""
    rng = np.random.default_rng(5)
    runs = []
    for seed in range(10):
        tension = np.append(rng.uniform(500.0, 900.0, 100), rng.uniform(1.0, 400.0))
        attrs = {"scenario": f'{{"simulation": {{"seed": {seed}}}}}', "title": "made up"}
        of = {
            "rope_tension": (
                ("time", "rope"),
                tension[:, None],
                {"units": "N", "column": "{rope}.rope_tension"},
            )
        }
        runs.append(xarray.Dataset(of, {"time": np.arange(101.0), "rope": ["hoist"]}, attrs))
    found = statistics_report.frame(runs, 0.0, ["*.rope_tension"])
    assert found["extreme_smallest"].tolist() == [0.0]


def study(**fields: object) -> file.StudyFile:
    """A study with fields beside those of its file."""
    read = file.read(LIFT)
    return replace(read, content={**read.content, **fields})


def test_a_scenario_with_an_operation_happens_once_unless_the_study_decides_otherwise() -> None:
    scenario = kingpost.load("lift_off_from_barge")
    found = parts(study(), scenario.resolved)
    assert (found.one_off, found.steps) == (True, ("wait with a slack rope", "lift off", "hold"))
    assert np.isnan(found.stationary_s).all()
    assert parts(study(stationary_steps={"hold": 600.0}), scenario.resolved).stationary_s[2] == 600
    assert not parts(study(one_off=False, operation_s=600.0), scenario.resolved).one_off
    assert not parts(study(), kingpost.load("paper").resolved).one_off
    assert parts(study(one_off=True), kingpost.load("paper").resolved).one_off


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        (
            {"operation_s": 1800.0},
            "operation_s: found 1800 s of what happens once, allowed: none, stationary_",
        ),
        (
            {"stationary_steps": {"hld": 9.0}},
            "stationary_steps.hld: found 'hld', allowed: a step of the operat",
        ),
        (
            {"stationary_steps": {"hold": 9.0}, "one_off": False},
            "found a step of a stationary run, allowed: s",
        ),
    ],
)
def test_an_extrapolation_of_what_happens_once_is_refused(fields: dict, message: str) -> None:
    with pytest.raises(kingpost.ScenarioError, match=message):
        parts(study(**fields), kingpost.load("lift_off_from_barge").resolved)


def test_the_plan_says_how_many_seeds_its_accepted_probability_needs() -> None:
    """Source: 22 and 29 of the binomial distribution."""
    found = plan(study(stationary_steps={"hold": 600.0}))
    count = SeedCount.of(found)
    assert (count.found, count.without_exceedance, count.for_interval) == (10, 22, 29)
    # 1 - 0.9^10 = 0.65.
    assert "10 show it at 65 %" in " ".join(count.sentences())
    assert too_few(found).startswith("seeds: found 10 of each case, 29 give the value that is exceeded with")
    assert kind_of_runs(found).endswith("but hold to 600 s")


def test_a_height_below_those_of_the_study_and_an_interval_to_it_are_arrows() -> None:
    """Source: two periods, the second with twice the response: no height of the study is acceptable there."""
    runs = results(10, period_s=(8.0, 12.0))
    runs["limit_worst"] = runs["limit_worst"] * xarray.where(runs["tp"] == 12.0, 4.0, 1.0)
    found = limiting_heights(runs)
    assert [height_text(found, (k,)) for k in (0, 1)][1] == "below 1"
    (axes,) = draw({"by runs": found}, "tp", [], [()]).axes
    arrows = [(words.xy, words.xyann) for words in axes.texts]
    # The height itself, a thick arrow down from the smallest, and the lower end of both intervals at 0.
    assert ((12.0, 1.0 - 0.15 * 3.0), (12.0, 1.0)) in arrows
    assert sorted(end[0] for end, _ in arrows if end[1] == 0) == [8.0, 12.0]

"""Limiting heights from a study's results, and the share of a site's sea states below them."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
import xarray
from kingpost import KingpostError
from kingpost.reports.limiting import operable
from kingpost.study.limiting.operability import operability
from kingpost.study.limiting.runs import limiting_heights
from kingpost.study.limiting.sea import OUTSIDE, LimitingSea
from kingpost.study.sea_states import scatter

HEIGHTS, PERIODS, DIRECTIONS = (1.0, 1.5, 2.0, 3.0), (6.0, 8.0, 12.0), (150.0, 180.0)
RECORD_S, ACCEPTANCE = 600.0, 0.1
BOUNDS = {"heel": (np.nan, 5.0), "gap": (0.5, np.nan), "offlead": (-3.0, 3.0)}
"""What each limit allows: at least, at most."""


def slope(limit: str, period: float, direction: float) -> float:
    """The most probable largest value of a metre of height, of what varies in proportion to it."""
    size = {"heel": 1.0, "gap": 0.9, "offlead": 0.6}[limit]
    return size * (1 + 0.1 * np.cos(period)) * (1 + (180 - direction) / 100)


def results(seeds: int, seed: int = 1) -> xarray.Dataset:
    """As a study's store has them: Gumbel extremes whose location and scale go with the height."""
    rng = np.random.default_rng(seed)
    axes = {"hs": HEIGHTS, "tp": PERIODS, "direction_deg": DIRECTIONS, "load_t": (10.0,)}
    grid = np.meshgrid(*axes.values(), np.arange(1, seeds + 1), indexing="ij")
    flat = dict(zip([*axes, "seed"], (one.ravel() for one in grid), strict=True))
    worst = []
    for limit, (least, most) in BOUNDS.items():
        per_metre = np.array(
            [slope(limit, *case) for case in zip(flat["tp"], flat["direction_deg"], strict=True)]
        )
        largest = flat["hs"] * per_metre * (1 + 0.15 * rng.gumbel(size=len(per_metre)))
        if np.isnan(most):  # A distance of 4 m at rest.
            worst.append(4.0 - largest)
        else:
            worst.append(largest * (1 if np.isnan(least) else rng.choice([-1, 1], len(largest))))
    worst = np.stack(worst, axis=-1)
    low, high = np.array(list(BOUNDS.values())).T
    held = np.fmax(worst - high, low - worst) <= 0
    return xarray.Dataset(
        {
            "limit_worst": (("run", "limit"), worst),
            "limit_held": (("run", "limit"), held.astype("i1")),
            "status": ("run", np.zeros(len(worst), "i1")),
        },
        {name: ("run", values) for name, values in flat.items()}
        | {"limit": list(BOUNDS), "at_least": ("limit", low), "at_most": ("limit", high)},
        {
            "title": "made up",
            "axes": " ".join(axes),
            "sea_significant_height": "hs",
            "sea_peak_period": "tp",
            "sea_direction": "direction_deg",
            "duration_s": RECORD_S + 60,
            "after_s": 60.0,
            "operation_s": 3 * RECORD_S,
            "acceptance": ACCEPTANCE,
        },
    )


def test_a_limit_that_begins_later_has_a_shorter_record() -> None:
    """Source: closed form: the largest of a record of a third of the length is ln 3 scales lower, so that an
    operation three times as long is nine such records: Hs slope (1 + 0.15 (ln 9 + y)) is the bound."""
    runs = results(2000)
    begins = runs.assign_coords(limit_from_s=("limit", [0.0, 60.0, 60.0 + RECORD_S * 2 / 3]))
    before, found = (limiting_heights(of)["limiting_height"] for of in (runs, begins))
    for limit in ("heel", "gap"):
        assert found.sel(limit=limit).values.tolist() == before.sel(limit=limit).values.tolist()
    variate = -np.log(-np.log1p(-ACCEPTANCE))
    for period in PERIODS:
        for direction in DIRECTIONS:
            exact = 3.0 / slope("offlead", period, direction) / (1 + 0.15 * (np.log(9) + variate))
            got = float(found.sel(limit="offlead", tp=period, direction_deg=direction).squeeze())
            assert got == pytest.approx(exact, rel=0.021)


def true_height(limit: str, period: float, direction: float) -> float:
    """Where Hs slope (1 + 0.15 (ln 3 + y)) is the bound, y = -ln(-ln(1 - acceptance))."""
    bound = {"heel": 5.0, "gap": 3.5, "offlead": 3.0}[limit]
    return bound / slope(limit, period, direction) / (1 + 0.15 * (np.log(3) - np.log(-np.log1p(-ACCEPTANCE))))


def test_limiting_heights_equal_those_of_the_sampled_distribution() -> None:
    """Gumbel extremes in proportion to the height: a closed form. The standard error of 2000 seeds is
    0.7 % of the height; of 18 heights none is off by three of them."""
    found = limiting_heights(results(2000))
    assert found["limiting_height"].dims == ("limit", "tp", "direction_deg", "load_t")
    for limit in BOUNDS:
        for period in PERIODS:
            for direction in DIRECTIONS:
                true = true_height(limit, period, direction)
                one = found.sel(limit=limit, tp=period, direction_deg=direction, load_t=10)
                if true > 3:
                    assert one["limiting_height_state"] == "above"
                    assert float(one["limiting_height"]) == 3.0
                else:
                    assert one["limiting_height_state"] == "found"
                    assert float(one["limiting_height"]) == pytest.approx(true, rel=0.02)
                    assert one["limiting_height_low"] < one["limiting_height"] < one["limiting_height_high"]
    smallest = found["limiting_height"].min("limit")
    assert found["limiting_height_of_all"].equals(smallest)
    assert (found["limiting_height"].sel(limit=found["governs"]).values == smallest.values).all()


def test_the_interval_of_a_limiting_height_covers_the_true_one() -> None:
    """At least as often as it says: its ends lie between those of two heights with other seeds."""
    covered = []
    for seed in range(20):
        found = limiting_heights(results(10, seed + 100), confidence=0.9)
        for limit in BOUNDS:
            for period in PERIODS:
                for direction in DIRECTIONS:
                    one = found.sel(limit=limit, tp=period, direction_deg=direction, load_t=10)
                    true = true_height(limit, period, direction)
                    if 1.2 < true < 2.6:
                        covered.append(one["limiting_height_low"] <= true <= one["limiting_height_high"])
    assert len(covered) > 150
    # Two errors of 200 cases or so below it.
    assert np.mean(covered) > 0.86


def test_a_longer_operation_and_a_smaller_probability_lower_the_height() -> None:
    found = results(200)
    usual = limiting_heights(found)["limiting_height_of_all"]
    assert (limiting_heights(found, operation_s=6 * RECORD_S)["limiting_height_of_all"] < usual).all()
    assert (limiting_heights(found, acceptance=0.01)["limiting_height_of_all"] < usual).all()


def test_a_run_that_ended_early_counts_as_exceeded_and_a_constant_column_as_held_or_exceeded() -> None:
    found = results(10)
    found["status"].values[(found["hs"] == 2.0) & (found["seed"] == 3)] = 1
    found["limit_worst"].values[(found["hs"] == 2.0) & (found["seed"] == 3)] = np.nan
    limiting = limiting_heights(found)
    # P is 1 at 2 m: the height is below it for every limit.
    assert (limiting["limiting_height"] <= 2.0).all()
    assert (limiting["ended_early"].sel(hs=2.0) == 1).all()
    assert (limiting["probability"].sel(hs=2.0) > 0.999999).all()
    still = results(10)
    still["limit_worst"][:, 1] = 0.6
    assert (limiting_heights(still)["limiting_height_state"].sel(limit="gap") == "above").all()
    still["limit_worst"][:, 1] = 0.4
    below = limiting_heights(still)
    assert (below["limiting_height_state"].sel(limit="gap") == "below").all()
    assert (below["limiting_height_of_all"] == 0).all()
    assert (below["governs"] == "gap").all()


def test_between_periods_and_directions_the_height_is_linear_and_outside_it_is_not_known() -> None:
    found = limiting_heights(results(50))
    sea = LimitingSea.of(found)
    node = {(p, d): found["limiting_height"].sel(tp=p, direction_deg=d, load_t=10).values
            for p in PERIODS for d in DIRECTIONS}  # fmt: skip
    for (period, direction), heights in node.items():
        height, governs = sea(period, np.radians(direction))
        assert height == heights.min()
        assert governs == list(BOUNDS)[heights.argmin()]
    middle = sea.of_limits(7.0, np.radians(157.5))
    corner = 0.5 * (0.75 * node[6.0, 150.0] + 0.25 * node[6.0, 180.0]) + 0.5 * (
        0.75 * node[8.0, 150.0] + 0.25 * node[8.0, 180.0]
    )
    assert middle == pytest.approx(corner)
    # A whole turn is the same direction.
    assert sea(7.0, np.radians(165 - 360))[0] == pytest.approx(sea(7.0, np.radians(165))[0])
    for period, direction in ((5.9, 165), (12.1, 165), (8.0, 181), (8.0, 149)):
        height, governs = sea(period, np.radians(direction))
        assert np.isnan(height)
        assert governs == "outside the study"


def test_directions_over_the_whole_circle_are_interpolated_periodically() -> None:
    directions = np.radians(np.arange(0, 360, 45.0))
    heights = (2 + np.cos(directions))[None, None, :]
    sea = LimitingSea(np.array([8.0]), directions, heights, ("heel",))
    assert sea(8.0, np.radians(337.5))[0] == pytest.approx((heights[0, 0, 7] + heights[0, 0, 0]) / 2)
    assert sea(8.0, np.radians(-22.5))[0] == pytest.approx(sea(8.0, np.radians(337.5))[0])
    assert sea(8.0, -1e-17)[0] == pytest.approx(3.0)


def seas(count: int) -> tuple[np.ndarray, np.ndarray]:
    """Significant heights and peak periods of a made-up place."""
    rng = np.random.default_rng(5)
    heights = rng.lognormal(0.5, 0.6, count)
    return heights, rng.normal(6 + 2.5 * np.sqrt(heights), 1.2)


def curve(peak_period_s: float, direction_rad: float) -> tuple[float, str]:
    """A dip where the ship is tuned, nothing known beyond 14 s."""
    if not 4 <= peak_period_s <= 14:
        return np.nan, "outside the study"
    return 2.5 - 1.2 * np.exp(
        -((peak_period_s - 9) ** 2) / 4
    ), "roll" if 7 < peak_period_s < 11 else "tension"


def test_the_operability_by_single_seas_equals_counting() -> None:
    """Direct counting: exact, as points have no classes."""
    heights, periods = seas(3000)
    text = "hs,tp,month\n" + "\n".join(
        f"{h},{p},{k % 12 + 1}" for k, (h, p) in enumerate(zip(heights, periods, strict=True))
    )
    found = operability(scatter.parse(text), curve, 0.0)
    allowed = np.array([curve(period, 0.0)[0] for period in periods])
    works = heights <= allowed
    assert found.share == pytest.approx(works.mean(), abs=1e-12)
    assert found.outside == pytest.approx(np.isnan(allowed).mean(), abs=1e-12)
    for month in range(1, 13):
        assert found.by_month[month] == pytest.approx(works[month - 1 :: 12].mean(), abs=1e-12)
    assert sum(found.by_limit.values()) + found.outside + found.share == pytest.approx(1)


def test_the_operability_by_classes_equals_counting_except_for_the_class_width() -> None:
    """Classes of 0.25 m and 0.5 s. Evenly spread heights err by the curvature of the density, the period's
    middle by that of the curve: half a per cent of all seas bounds both."""
    heights, periods = seas(100_000)
    at_h, at_p = np.arange(0, 12.1, 0.25), np.arange(2, 22.1, 0.5)
    counts, _, _ = np.histogram2d(heights, periods, [at_h, at_p])
    text = "Hs\\Tp," + ",".join(f"{a}-{b}" for a, b in pairwise(at_p))
    for k, row in enumerate(counts):
        text += f"\n{at_h[k]}-{at_h[k + 1]}," + ",".join(f"{n:g}" for n in row)
    found = operability(scatter.parse(text), curve, 0.0)
    allowed = np.where(
        (periods >= 4) & (periods <= 14), 2.5 - 1.2 * np.exp(-((periods - 9) ** 2) / 4), np.nan
    )
    assert found.share == pytest.approx((heights <= allowed).mean(), abs=0.005)
    assert found.outside == pytest.approx(np.isnan(allowed).mean(), abs=0.005)


def test_directions_of_the_table_are_looked_up_each() -> None:
    table = scatter.parse("hs,tp,occurrences,direction_to_deg\n1,8,3,180\n1,8,1,90\n")
    found = operability(table, lambda period, direction: (2.0 if direction > 3 else 0.5, "roll"))
    assert found.share == 0.75
    assert found.by_direction_deg == {90: 0.0, 180: 1.0}


def test_mean_periods_become_peak_periods() -> None:
    asked = []
    operability(scatter.parse("hs,tz\n1,7.104\n"), lambda p, _: (asked.append(p) or 1.0, "roll"), 0.0, 1.0)
    assert asked == pytest.approx([10.0], rel=1e-3)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda r: r.isel(run=r["seed"].values <= 4), "seeds: found 4, allowed: 5 or more"),
        (lambda r: r.isel(run=slice(1, None)), "axes: found 143 runs of which the axes' values make 144"),
        (
            lambda r: r.assign_attrs(sea_significant_height=""),
            "significant height: found no axis of it among hs, tp",
        ),
        (lambda r: r.assign(status=r["status"] - (r["run"] < 7)), "runs: found 7 that have not run"),
        (lambda r: r.assign_attrs(acceptance=0.0), "acceptance: found 0, allowed: between"),
    ],
)
def test_unsuitable_results_are_refused(change, message: str) -> None:
    with pytest.raises(KingpostError, match=message):
        limiting_heights(change(results(6).assign_coords(run=np.arange(144))))


def test_missing_values_of_axes_and_a_missing_direction_are_reported() -> None:
    found = limiting_heights(results(6))
    two = xarray.concat([found, found.assign_coords(load_t=[20.0])], "load_t", data_vars="all")
    with pytest.raises(KingpostError, match=r"load_t: found no value, allowed: one of 10\.0, 20\.0"):
        LimitingSea.of(two)
    assert LimitingSea.of(two, at={"load_t": 20.0})(8.0, 3.0)[0] > 0
    with pytest.raises(KingpostError, match="peak period: found no axis of it among tp, direction_deg"):
        LimitingSea.of(found.assign_attrs(sea_peak_period=""))
    with pytest.raises(KingpostError, match="direction: found none in the scatter table"):
        operability(scatter.parse("hs,tp\n1,8\n"), curve)


def test_the_report_names_the_periods_outside_the_study() -> None:
    """Source: arithmetic: classes 4-6 and 10-12 s, of which the last never occurs, outside of 6 to 9 s."""
    table = scatter.parse("Hs/Tp,4-6,6-8,10-12,12-14\n0-1,30,20,10,0\n1-2,10,30,0,0")
    limits = lambda period_s, _: (2.0, "heel") if 6 <= period_s <= 9 else (np.nan, OUTSIDE)  # noqa: E731
    found = operability(table, limits, direction_rad=0.0)
    assert (found.outside, found.outside_periods_s) == (pytest.approx(0.5), (5.0, 11.0))
    assert "50.0 % are outside of the study (Tp 5, 11 s), and count as not operable" in operable(found)[1]

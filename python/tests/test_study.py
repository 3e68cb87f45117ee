"""`kingpost.Study`: runs, stored results, and refused input."""

from __future__ import annotations

import json

import kingpost
import numpy as np
import pytest
from kingpost import statistics
from kingpost.analysis.fatigue import rainflow
from kingpost.study import reduce
from kingpost.study.design.cases import cases
from study_samples import RUNS, SLEWING, written

WRITTEN = "bodies.tower.joint.revolute.position_m.0"
"""The field that the parameter `crane_x_m` writes."""


@pytest.fixture(scope="module")
def slewing(tmp_path_factory):
    """The fast study and its results."""
    study = kingpost.Study(SLEWING)
    return study, study.run(tmp_path_factory.mktemp("slewing"), workers=1)


def test_cases_are_every_combination_with_the_last_axis_fastest_and_seeds_inside(slewing) -> None:
    """Source: the definition in docs/studies.md."""
    study, found = slewing
    assert len(study) == RUNS == found.sizes["run"]
    assert found.crane_x_m.values.tolist() == np.repeat(np.linspace(-10, 0, 6), 4).tolist()
    assert found.motor_2.values.tolist() == [True, True, False, False] * 6
    assert found.seed.values.tolist() == [1, 2] * 12
    assert found.case.values.tolist() == np.repeat(np.arange(12), 2).tolist()


def test_a_run_has_the_numbers_that_it_has_alone(slewing) -> None:
    """Source: `kingpost.run` and `kingpost.statistics.summary`: the same formulas over the same rows, whose
    sums differ in their order at most, by rounding."""
    study, found = slewing
    for k in (0, 7, 23):
        alone = kingpost.run(study.scenario.with_overrides(study.overrides(k)))
        summary = statistics.summary(alone["roll"].sel(body="ship"), SLEWING["after_s"])
        ours = found.statistics.sel(column="ship.roll").isel(run=k)
        for name in ("mean", "standard_deviation", "zero_up_crossing_period", "maximum", "minimum"):
            np.testing.assert_allclose(ours.sel(statistic=name), summary.sel(statistic=name), rtol=1e-12)
        limit = alone.kingpost.limits[0]
        assert found.limit_worst.values[k, 0] == limit["worst"]
        assert found.limit_time.values[k, 0] == limit["worst_time_s"] >= SLEWING["after_s"]
        assert found.limit_held.values[k, 0] == limit["held"]
        of_roll = alone["roll"].sel(body="ship")[alone.time.values >= SLEWING["after_s"]]
        assert ours.sel(statistic="time_of_maximum") == of_roll.time[of_roll.values.argmax()]


def test_results_open_without_kingpost_and_carry_units_and_names(slewing, tmp_path) -> None:
    """Source: Zarr v3 and CF: what xarray reads by itself."""
    _, found = slewing
    assert found.column.values.tolist() == [
        "ship.position.x",
        "ship.position.y",
        "ship.position.z",
        "ship.roll",
    ]
    assert found.column_unit.values.tolist() == ["m", "m", "m", "rad"]
    assert (found.limit_unit.item(), found.at_most.item(), found.at_least.item()) == ("deg", 0.1, -0.1)
    assert found.status.attrs["flag_meanings"].split()[1:] == ["finished", "ended_early", "not_built"]
    assert json.loads(found.attrs["scenario"])["simulation"]["duration_s"] == 0.2
    assert found.attrs["operation_s"] == pytest.approx(0.15)
    # Cycles and peaks are of the column that asked for them.
    assert np.isfinite(found.damage.sel(column="ship.roll")).all()
    assert np.isnan(found.damage.sel(column="ship.position.x")).all()


def test_peaks_and_cycles_of_a_run_are_those_of_its_record() -> None:
    """Source: closed form: a sine of period 1 whose size grows has its peaks at a quarter of each period,
    which are recorded; the first and the last period are not between two up-crossings. And the functions for
    a record that a user has: the same bits."""
    time_s = np.arange(4000) / 100
    x = (1 + time_s / 40) * np.sin(2 * np.pi * time_s)
    kept = reduce.Kept(("x",), (), 0.0, (0,), 38, (0,), (3.0, 2.5))
    into = reduce.empty(kept, 1)
    reduce.reduce(into, 0, np.column_stack([time_s, x]), [1], [], True, kept)
    expected = 1 + (np.arange(1, 39) + 0.25) / 40
    np.testing.assert_allclose(into["peaks"][0, 0], expected[::-1], rtol=1e-12)
    assert into["peak_count"].item() == 38
    cycles = rainflow(x)
    assert into["cycles"].item() == cycles.count
    assert into["damage"][0, 0].tolist() == [cycles.damage(3.0), cycles.damage(2.5)]


def test_a_column_with_nan_has_no_cycles() -> None:
    """Source: what is not known is NaN."""
    kept = reduce.Kept(("x",), (), 0.0, (), 0, (0,), (3.0,))
    into = reduce.empty(kept, 1)
    reduce.reduce(into, 0, np.array([[0.0, 1.0], [1.0, np.nan], [2.0, 0.0]]), [1], [], True, kept)
    assert np.isnan([into["cycles"].item(), into["damage"].item()]).all()


def test_a_latin_hypercube_has_one_sample_in_each_strip_of_each_axis() -> None:
    """Source: McKay, Beckman & Conover, Technometrics 21(2), 1979: the definition."""
    axes = {
        "x": {"latin_hypercube": {"from": 0.0, "to": 50.0}},
        "side": {"values": ["port", "starboard"]},
        "y": {"latin_hypercube": {"from": -1.0, "to": 1.0}},
    }
    found = cases(axes, {"count": 50, "seed": 7})
    assert (found.count, found.names) == (100, ("x", "side", "y"))
    assert found.values["side"] == ["port", "starboard"] * 50
    assert found.drawn["sample"] == np.repeat(np.arange(50), 2).tolist()
    assert sorted(int(x) for x in found.values["x"][::2]) == list(range(50))
    assert sorted(int((y + 1) * 25) for y in found.values["y"][::2]) == list(range(50))
    assert cases(axes, {"count": 50, "seed": 7}) == found != cases(axes, {"count": 50, "seed": 8})


def test_runs_that_diverge_or_do_not_build_are_marked_and_the_others_continue(tmp_path) -> None:
    """Source: the contract of `status`; a rate above the limit of 0.001 rad/s ends a run."""
    study = kingpost.Study({
        **SLEWING,
        "axes": {"simulation.rate_limit": {"values": [1e4, 1e-3]}, "crane_x_m": {"values": [-10, 0]}},
        "seeds": {"count": 1},
    })  # fmt: skip
    found = study.run(tmp_path, workers=1)
    assert found.status.values.tolist() == [0, 0, 1, 1]
    numbers = found.statistics.values
    assert np.isfinite(numbers[:2, :, 0]).all()
    assert np.isnan(numbers[2:]).all()
    assert found.limit_held.values[2:, 0].tolist() == [-1, -1]
    assert np.isnan(found.limit_worst.values[2:]).all()
    marker = json.loads((tmp_path / "units" / "000000.json").read_text())
    assert "diverged at 0.002 s: the rate ship.roll" in marker["ends"]["2"]


def test_a_case_between_the_corners_that_does_not_build_is_recorded(tmp_path) -> None:
    """Source: the contract of `status`: single values and corners are tried before, what is between runs.
    The step is longer than the run in one combination of inner values alone."""
    axes = {
        "simulation.step_s": {"values": [0.002, 0.3, 0.004]},
        "simulation.duration_s": {"values": [0.5, 0.2, 0.4]},
    }
    study = kingpost.Study({**SLEWING, "set": {}, "axes": axes, "seeds": {"count": 1}})
    found = study.run(tmp_path, workers=1)
    expected = [reduce.NOT_BUILT if k == 4 else reduce.FINISHED for k in range(9)]
    assert found.status.values.tolist() == expected
    assert np.isnan(found.statistics.values[4]).all()
    marker = json.loads((tmp_path / "units" / "000001.json").read_text())
    assert marker["ends"]["4"].endswith("allowed: at most simulation.duration_s, 0.2")


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"axes": {"crane_x": {"values": [1]}}}, "axes.crane_x: found an unknown name"),
        ({"axes": {"crane_x_m": {"values": [1, 1000]}}}, "axes.crane_x_m.values.1: found 1000, allowed: a"),
        ({"axes": {"crane_x_m": {"values": []}}}, "axes.crane_x_m.values: found an empty list"),
        ({"axes": {"crane_x_m": {"values": [1, 1.0]}}}, "axes.crane_x_m.values.1: found 1 a second time"),
        ({"axes": {"crane_x_m": {"values": [1]}, WRITTEN: {"values": [2]}}}, "found a field a second time"),
        ({"axes": {"simulation.seed": {"values": [1]}}}, "allowed: what cases differ in; seeds has"),
        ({"axes": {"crane_x_m": {"latin_hypercube": {"from": 0, "to": 1}}}}, ": found no samples"),
        ({"samples": {"count": 5}}, "samples: found no axis latin_hypercube"),
        ({"sea": {"direction": "heading"}}, ": found \"heading\", allowed: crane_x_m or motor_2"),
        ({"seeds": {"count": 0}}, "seeds.count: found 0, allowed: a whole number from 1 to 100000"),
        ({"seeds": {"count": 1000000000}}, "seeds.count: found 1000000000"),
        ({"axes": {"crane_x_m": {"range": {"from": 0, "to": 1, "count": 900000}}}}, "found 1800000 runs"),
        ({"scenario": "papr"}, "scenario: papr: neither a file nor a name of the gallery"),
        ({"set": {"crane": 1}}, "set.crane: found an unknown name"),
        ({"limits": {"roll": {"column": "ship.rol", "within": 1}}}, "limits.roll.column: found ship.rol"),
        ({"record": ["ship.rol"]}, "record.0: found 'ship.rol', allowed: a column of the run, as ship.roll"),
        ({"after_s": 3}, "after_s: found 3, allowed: before the last records of a run"),
        ({"acceptance": 1}, "acceptance: found 1, allowed: a number greater than 0 and less than 1"),
        ({"acceptence": 0.1}, "did you mean acceptance?"),
    ],
)  # fmt: skip
def test_the_error_for_a_wrong_study_names_the_place(change, message, tmp_path) -> None:
    """Source: the contract of errors: file, line, column, field, what was found, what is allowed."""
    path = written({**SLEWING, **change}, tmp_path / "study.yaml")
    with pytest.raises(kingpost.ScenarioError) as caught:
        kingpost.Study(path)
    assert message in str(caught.value)
    assert str(caught.value).startswith(f"{path}:{caught.value.line}:{caught.value.column}: ")
    line = path.read_text().splitlines()[caught.value.line - 1]
    named = caught.value.field.rsplit(".", 1)[-1]
    assert named in line or named.isdigit() or caught.value.found in line or "axes" in caught.value.field


def test_the_error_for_a_value_that_the_hulls_database_refuses_names_the_axis_and_valid_values() -> None:
    """Source: the contract of errors: what is wrong is the study's value, not the database."""
    period = "sea.waves.wind_sea.jonswap.peak_period_s"
    with pytest.raises(kingpost.ScenarioError) as caught:
        kingpost.Study({
            "version": 1, "title": "x", "scenario": "offshore_vessel", "record": ["hull.roll"],
            "set": {"simulation.duration_s": 1, "waves": True, "significant_height_m": 0.5},
            "axes": {period: {"values": [8, 3.5, 10]}},
        })  # fmt: skip
    error = caught.value
    assert error.field == f"axes.{period}.values.1"
    assert (error.found, error.allowed) == ("3.5", "a value with which the scenario builds, as 8, 10")
    assert "hydrodynamics.database: found frequencies from 0.05984 to 2.618 rad/s, with " in str(error)


def test_a_wrong_scatter_table_is_refused_before_the_runs(tmp_path) -> None:
    """Source: what a user does: hours of runs end in a table that cannot be read."""
    (tmp_path / "climate.csv").write_text("Utsira\n1,2\n", encoding="utf-8")
    path = written({**SLEWING, "scatter": "climate.csv"}, tmp_path / "study.yaml")
    with pytest.raises(kingpost.KingpostError, match=r"climate\.csv:1: header: found none"):
        kingpost.Study(path)


def test_corners_are_cases_also_of_axes_that_are_drawn_together() -> None:
    """Source: the cells of a scatter table are points of one axis: no corner mixes two of them."""
    axes = {
        "height": {"scatter": "significant_height"},
        "load": {"values": [1, 2, 3]},
        "period": {"scatter": "peak_period"},
    }
    found = cases(axes, None, lambda: [(0.5, 6.0), (0.5, 8.0), (1.5, 10.0)])
    assert found.values["period"] == [6.0] * 3 + [8.0] * 3 + [10.0] * 3
    corners = [tuple(found.values[name][case] for name in axes) for case in found.corners()]
    assert corners == [(0.5, 1, 6.0), (0.5, 3, 6.0), (1.5, 1, 10.0), (1.5, 3, 10.0)]


def test_the_error_for_a_corner_that_does_not_build_names_its_values() -> None:
    """Source: the contract of errors; an inner step longer than the run stands in no single value."""
    axes = {"simulation.step_s": {"values": [0.3, 0.002]}, "simulation.duration_s": {"values": [0.2, 0.5]}}
    with pytest.raises(kingpost.ScenarioError, match=r"at most simulation\.duration_s, 0\.2"):
        kingpost.Study({**SLEWING, "set": {}, "axes": axes})
    fine = {"simulation.duration_s": {"values": [1e5]}, "crane_x_m": {"values": [0]}}
    with pytest.raises(kingpost.ScenarioError, match=r"duration_s: 100000\.0: .*found 0\.01, allowed"):
        kingpost.Study({**SLEWING, "set": {"simulation.step_s": 1e-5}, "axes": fine})


def test_the_axes_of_the_sea_are_found_by_the_fields_that_their_parameters_set() -> None:
    """Source: docs/studies.md; the parameters of `offshore_vessel`."""
    study = kingpost.Study({
        "version": 1, "title": "x", "scenario": "offshore_vessel", "record": ["hull.roll"],
        "set": {"simulation.duration_s": 1, "waves": True},
        "axes": {name: {"values": [10]} for name in ("peak_period_s", "load_t", "wave_direction_deg")},
    })  # fmt: skip
    assert study.plan.sea == {"peak_period": "peak_period_s", "direction": "wave_direction_deg"}

"""Steps of an operation in a study: kept numbers, the report's tables, the load chart with the path on it."""

from __future__ import annotations

import html
import json
import re
import shutil
from pathlib import Path
from typing import Any

import kingpost
import numpy as np
import pytest
import xarray
from kingpost.cli import main
from kingpost.reports.load_chart import load_chart_figure
from kingpost.study.study import Study
from kingpost.study_report import report, steps
from kingpost.study_report.cases import utilisation

WHEEL = """version: 1
title: A wheel
simulation: {step_s: 0.05, duration_s: 6, record_every_s: 0.05}
bodies:
  wheel:
    mass_t: 1
    inertia: {radii_of_gyration: {radii_m: [0.3, 0.3, 0.3]}}
    joint: {revolute: {name: axle, axis: [0, 0, 1]}}
drives: {drive: {motor: {joint: axle, torque_N_m: 1000, history: lever}}}
operation:
  steps:
    - {name: wait, until: {after_s: 1}}
    - {name: push, set: [{input: drive, to: 1}], until: {after_s: 2}}
    - {name: brake, set: [{input: drive, to: -1}], until: {after_s: 1}}
    - {name: run on, set: [{input: drive, to: 0}], until: {value: {column: axle.joint_position, above: 1000}}}
    - {name: never}
"""
TORQUES = (45.0, 90.0)
"""M of the wheel, N m: its inertia is 90 kg m2."""
STUDY: dict[str, Any] = {
    "version": 1,
    "title": "Push and brake",
    "scenario": "wheel.yaml",
    "axes": {"drives.drive.motor.torque_N_m": {"values": list(TORQUES)}},
    "seeds": {"count": 2},
    "after_s": 0.5,
    "limits": {
        "speed": {"column": "axle.joint_velocity", "at_most": 90, "unit": "deg/s"},
        "turn": {"column": "axle.joint_position", "at_most": 10, "from_s": 2.0},
        "braked": {"column": "axle.joint_velocity", "at_least": 0.6, "steps": ["brake"], "until_s": 3.75},
    },
}


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> tuple[Study, xarray.Dataset, Path]:
    folder = tmp_path_factory.mktemp("wheel")
    (folder / "wheel.yaml").write_text(WHEEL, encoding="utf-8")
    import yaml

    (folder / "study.yaml").write_text(yaml.safe_dump(STUDY, sort_keys=False), encoding="utf-8")
    study = Study(folder / "study.yaml")
    return study, study.run(folder / "out", workers=1), folder


def test_steps_begin_and_end_with_their_rows(made: tuple[Study, xarray.Dataset, Path]) -> None:
    """Source: the timeline: 1 s, 2 s, 1 s, and a condition that never holds; a step begins within a row."""
    _, runs, _ = made
    assert runs["step_name"].values.tolist() == ["wait", "push", "brake", "run on", "never"]
    begin, end = runs["step_begin"].values[0], runs["step_end"].values[0]
    assert begin[:4] == pytest.approx([0, 1, 3, 4], abs=0.051)
    assert end[:3] == pytest.approx(begin[1:4])
    assert end[3] == 6.0
    assert np.isnan(begin[4])


def test_a_limit_with_steps_counts_in_these_steps_until_its_end(
    made: tuple[Study, xarray.Dataset, Path],
) -> None:
    """Source: M = J alpha: at 3.75 s the speed is M / J 1.25 s, in the whole run 0. A row is 0.05 s."""
    _, runs, _ = made
    for torque, first in zip(TORQUES, (0, 2), strict=True):
        of = runs.isel(run=first).sel(limit="braked")
        assert np.isfinite(of["step_limit_worst"].values).tolist() == [False, False, True, False, False]
        for found in (of["step_limit_worst"][2], of["limit_worst"]):
            assert float(found) == pytest.approx(1.25 * torque / 90, abs=0.051 * torque / 90)
        assert int(of["limit_held"]) == int(torque / 90 * 1.25 > 0.6)


def test_extremes_and_worst_values_of_steps_are_those_of_the_motion(
    made: tuple[Study, xarray.Dataset, Path],
) -> None:
    """Source: M = J alpha: the speed rises by M t / J for 2 s and falls by half of that. A row is 0.05 s."""
    _, runs, _ = made
    for torque, first in zip(TORQUES, (0, 2), strict=True):
        rate = torque / 90
        of = runs.isel(run=first)
        speed = of["step_extremes"].sel(column="axle.joint_velocity")
        assert speed.sel(extreme="maximum").values[:4] == pytest.approx(
            [0, 2 * rate, 2 * rate, rate], abs=0.051 * rate
        )
        assert float(speed.sel(extreme="time_of_maximum")[1]) == pytest.approx(3, abs=0.051)
        worst = of["step_limit_worst"].sel(limit="speed").values
        assert worst[:4] == pytest.approx(np.degrees(speed.sel(extreme="maximum").values[:4]))
        # The limit counts from 2 s on, so not in the first step; angle is rate t^2 / 2.
        turn = of["step_limit_worst"].sel(limit="turn").values
        assert np.isnan(turn[0])
        assert turn[1] == pytest.approx(rate * 2, abs=0.2 * rate)


def test_the_worst_value_of_all_steps_is_that_of_the_run(made: tuple[Study, xarray.Dataset, Path]) -> None:
    """Source: the engine's own worst value of a limit, over the same rows."""
    _, runs, _ = made
    of_steps = runs["step_limit_worst"].max("step")
    np.testing.assert_allclose(of_steps.values, runs["limit_worst"].values, rtol=1e-12)
    at = runs["step_limit_worst"].fillna(-np.inf).argmax("step")
    assert runs["step_limit_time"].isel(step=at).values == pytest.approx(runs["limit_time"].values)


def cells(page: str, caption: str) -> list[list[str]]:
    """Rows of the table whose caption begins so."""
    table = re.search(rf"<caption>{re.escape(caption)}.*?</table>", page, re.DOTALL)
    assert table, caption
    rows = re.findall(r"<tr>(.*?)</tr>", table[0], re.DOTALL)
    return [[html.unescape(cell) for cell in re.findall(r"<td[^>]*>(.*?)</td>", row)] for row in rows[1:]]


def test_the_report_has_the_limits_of_each_step_with_run_and_time(
    made: tuple[Study, xarray.Dataset, Path], capsys: pytest.CaptureFixture[str]
) -> None:
    """Source: the motion: 2 rad/s is 114.6 deg/s, 1.27 times 90 deg/s, in the run with 90 N m, at 3 s."""
    study, runs, folder = made
    page = report.write(study.plan, folder / "out", folder / "report.html").read_text(encoding="utf-8")
    rows = {(step, limit): rest for step, limit, *rest in cells(page, "Limits by step")}
    allowed, worst, share, where = rows["push", "speed"]
    assert allowed == "at most 90 deg/s"
    assert float(worst) == pytest.approx(114.6, abs=3)
    assert float(share) == pytest.approx(float(worst) / 90, abs=0.006)
    assert re.fullmatch(r"run 2: drives\.drive\.motor\.torque_N_m 90, seed 1, (2\.95|3|3\.05) s", where)
    assert ("wait", "turn") not in rows
    by_case = cells(page, "Largest utilisation by case and step")
    assert [row[0] for row in by_case] == ["45", "90"]
    assert by_case[1][2] == f"{share} speed"
    reached = [row[3] for row in cells(page, "Steps over all runs")]
    assert reached == ["4 of 4"] * 4 + ["0 of 4"]
    assert "4 of 4 runs end before the operation's 'never'" in html.unescape(page)
    # A table of the report without an operation has no steps.
    assert steps.section(runs.drop_vars([name for name in runs if str(name).startswith("step")]), []) is None
    assert main(["study", str(folder / "study.yaml")]) == 0
    printed = capsys.readouterr().out
    assert "a run happens once: its largest value is a sample, without an extrapolation" in printed
    assert "22 without an exceedance show at most 10 % at 90 % confidence" in printed


@pytest.mark.parametrize(
    ("value", "least", "most", "share"),
    [
        (4.0, -5.0, 5.0, 0.8),
        (-6.0, -5.0, 5.0, 1.2),
        (1.0, np.nan, 10.0, 0.1),
        (-1.0, np.nan, 10.0, 0.0),
        (6.0, 3.0, np.nan, 0.5),
        (2.0, 3.0, np.nan, 1.5),
        (-1.0, 3.0, np.nan, np.inf),
        (-50.0, np.nan, -43.0, 0.86),
        (2.0, 0.0, np.nan, np.nan),
        (np.nan, -5.0, 5.0, np.nan),
    ],
)
def test_utilisation_is_1_at_the_bound_and_more_beyond(
    value: float, least: float, most: float, share: float
) -> None:
    assert utilisation(value, least, most) == pytest.approx(share, nan_ok=True)


CHART = {"joint": "slew", "radii_m": [8, 18, 30], "rated_loads_kg": [100e3, 68e3, 34e3]}


def lifted(charts: bool = True) -> xarray.Dataset:
    """A run of 4 rows in which a crane lifts and luffs out, as an engine records it."""
    steps_of = [{"name": "lift", "until": {"after_s": 2}}, {"name": "luff out"}]
    rope = {"rope": {"load_chart": CHART}} if charts else {"rope": {}}
    attrs = {
        "title": "made up",
        "scenario": json.dumps({"forces": {"hoist": rope}, "operation": {"steps": steps_of}}),
    }
    columns = {
        "load_radius": ("rope", [10.0, 10.0, 14.0, 18.0], "m"),
        "hook_load": ("rope", [0.0, 40e3, 44e3, 34e3], "kg"),
        "rated_load": ("rope", [93.6e3, 93.6e3, 80.8e3, 68e3], "kg"),
        "operation_step": ("operation", [1.0, 1.0, 2.0, 3.0], "1"),
    }
    found = {
        name: (("time", of), np.array(values)[:, None], {"units": unit, "column": f"{{{of}}}.{name}"})
        for name, (of, values, unit) in columns.items()
    }
    coords = {"time": np.arange(4.0), "rope": ["hoist"], "operation": ["operation"]}
    return xarray.Dataset(found, coords, attrs)


def test_the_path_on_the_load_chart_is_the_hook_load_over_the_radius_of_each_step() -> None:
    """Source: the rows themselves; 44 t of 80.8 t is the largest utilisation, 0.54. The last step, which has
    no end, has the rows to the end of the run."""
    (axes,) = load_chart_figure(lifted()).axes
    lines = {str(line.get_label()): np.array(line.get_xydata()).tolist() for line in axes.lines}
    assert lines["rated load"] == [[8, 100], [18, 68], [30, 34]]
    assert lines["lift"] == [[10, 0], [10, 40], [14, 44]]
    assert lines["luff out"] == [[14, 44], [18, 34], [18, 34]]
    assert lines["largest utilisation 0.54, at 2.0 s"] == [[14, 44]]


def test_a_run_without_a_load_chart_is_refused() -> None:
    with pytest.raises(
        kingpost.KingpostError, match="found no chart, allowed: a run whose scenario has a load"
    ):
        load_chart_figure(lifted(charts=False))
    with pytest.raises(kingpost.KingpostError, match="--load-chart: found whip, allowed: hoist"):
        load_chart_figure(lifted(), ["whip"])


@pytest.mark.parametrize("other", [["--channels", "hoist.*"], ["--range-graph"]])
def test_a_load_chart_beside_another_picture_is_refused(
    other: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    words = ["plot", "run.nc", "--load-chart", *other, "-o", str(tmp_path / "a.png")]
    assert main(words) == 2
    assert f"{other[0]}: found with --load-chart, allowed: one of both" in capsys.readouterr().err


def test_a_warning_and_an_early_end_name_their_first_run(
    made: tuple[Study, xarray.Dataset, Path], tmp_path: Path
) -> None:
    """Source: theta = M t^2 / 2 J: the push to 1.5 rad lasts 2.4 s with 45 N m, longer than its time-out of
    2 s, and 1.7 s with 90 N m. Both seeds of the first case end early."""
    text = WHEEL.replace("until: {after_s: 2}", "until: {value: {column: axle.joint_position, above: 1.5}}")
    (tmp_path / "wheel.yaml").write_text(text.replace("1.5}}", "1.5}}, time_out_s: 2"), encoding="utf-8")
    study = Study({**STUDY, "scenario": str(tmp_path / "wheel.yaml")})
    study.run(tmp_path / "out", workers=1)
    page = report.write(study.plan, tmp_path / "out", tmp_path / "report.html").read_text(encoding="utf-8")
    ((why, count, first),) = cells(page, "Runs that did not finish")
    assert "step" in why
    assert count == "2"
    assert first == "run 0: drives.drive.motor.torque_N_m 45, seed 1"


def test_stationary_steps_of_the_file_change_on_resume_without_new_runs(
    made: tuple[Study, xarray.Dataset, Path], tmp_path: Path
) -> None:
    """Source: the file itself: what is extrapolated is decided after the runs."""
    _, runs, folder = made
    shutil.copytree(folder / "out", tmp_path / "out")
    given = {**STUDY, "scenario": str(folder / "wheel.yaml")}
    held = Study({**given, "stationary_steps": {"run on": 600}})
    written = (tmp_path / "out" / "units" / "000000.json").stat().st_mtime_ns
    found = held.run(tmp_path / "out", workers=1, resume=True)
    assert (tmp_path / "out" / "units" / "000000.json").stat().st_mtime_ns == written
    assert found["stationary_s"].values[3] == 600
    assert np.isnan(found["stationary_s"].values[[0, 1, 2, 4]]).all()
    assert found["step_begin"].equals(runs["step_begin"].assign_coords(found["step_begin"].coords))
    stationary = Study({**given, "one_off": False, "operation_s": 600})
    assert stationary.run(tmp_path / "out", workers=1, resume=True).attrs["one_off"] == 0

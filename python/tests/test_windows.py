"""Weather windows of made-up series with known answers, and the command that decides from a forecast."""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import xarray
from kingpost import KingpostError
from kingpost.cli import main
from kingpost.study.sea_states.series import Series
from kingpost.study.weather_windows.decision import decide
from kingpost.study.weather_windows.statistics import by_month, persistence, waiting_h
from kingpost.study.weather_windows.windows import reference_period_h, windows
from kingpost.study.weather_windows.workable import Workable, workable
from study_samples import folder_of

START = np.datetime64("2026-01-01T00:00:00", "s")


def series(heights: list[float] | np.ndarray, hours: list[float] | np.ndarray | None = None) -> Series:
    """Heights at every hour, or at given ones; Tp 8 s."""
    hours = np.arange(len(heights)) if hours is None else np.asarray(hours, float)
    time = START + (np.asarray(hours) * 3600).astype("timedelta64[s]")
    return Series(time, np.asarray(heights, float), np.full(len(heights), 8.0))


def limit(peak_period_s: float, direction_rad: float) -> tuple[float, str]:
    """2 m from ahead, 1 m from abeam, where the tension governs; nothing is known beyond 12 s."""
    if peak_period_s > 12:
        return np.nan, "outside the study"
    return (2.0, "heel") if np.cos(direction_rad) < -0.5 else (1.0, "tension")


def found_in(heights: list[float] | np.ndarray, alpha: float = 1.0, **how: object) -> Workable:
    return workable(series(heights), limit, alpha, direction_rad=np.pi, **how)  # type: ignore[arg-type]


def square(calm_h: int, rough_h: int, times: int) -> np.ndarray:
    """Records of 1 m that span `calm_h` hours, then of 3 m for the hours between."""
    return np.tile(np.repeat([1.0, 3.0], [calm_h + 1, rough_h - 1]), times)


def test_a_square_wave_has_a_window_in_each_calm() -> None:
    """Source: counting. 13 records of calm span 12 h; from the first of the next calm it is 24 h on."""
    found = found_in(square(12, 12, 5))
    for reference_h, count in ((6.0, 5), (12.0, 5), (12.5, 0)):
        kept = windows(found, reference_h)
        assert len(kept) == count
        for k, window in enumerate(kept):
            assert window.start == START + np.timedelta64(24 * k, "h")
            assert window.duration_h == 12
            assert window.last_start(reference_h) == window.end - np.timedelta64(round(reference_h * 60), "m")
            assert window.governs == "heel"
            assert window.utilisation == 0.5
            assert window.ended_by == "heel"


def test_windows_at_both_ends_count_with_their_visible_part() -> None:
    kept = windows(found_in([1, 1, 1, 3, 3, 1, 1, 1, 1]), 2.0)
    assert [(window.duration_h, window.ended_by) for window in kept] == [
        (2, "heel"),
        (3, "end of the series"),
    ]
    assert windows(found_in([1, 1, 1, 3, 3, 1, 1, 1, 1]), 3.0)[0].duration_h == 3
    assert [window.duration_h for window in windows(found_in([1.0] * 25), 24.0)] == [24]


@pytest.mark.parametrize("alpha", [1.0, 0.8, 0.7, 0.65])
def test_a_height_equal_to_the_allowed_one_is_allowed(alpha: float) -> None:
    """alpha times 2 m, as a table would have it: rounding must not decide, a millimetre must."""
    allowed = round(2 * alpha, 6)
    assert len(windows(found_in([allowed] * 5, alpha), 4.0)) == 1
    assert windows(found_in([allowed + 1e-3] * 5, alpha), 0.0) == []


def test_alpha_reduces_the_allowed_height_and_alpha_of_1_does_not() -> None:
    """A ramp of 0.1 m an hour: Hs <= alpha 2 m for 20 alpha hours."""
    ramp = 0.1 * np.arange(40)
    for alpha in (1.0, 0.9, 0.5):
        (window,) = windows(found_in(ramp, alpha), 1.0)
        assert window.duration_h == round(20 * alpha)


def test_a_gap_ends_a_window() -> None:
    hours = [0, 1, 2, 3, 10, 11, 12]
    found = workable(series([1.0] * 7, hours), limit, 1.0, direction_rad=np.pi)
    assert [(window.duration_h, window.ended_by) for window in windows(found, 1.0)] == [
        (3, "gap in the series"),
        (2, "end of the series"),
    ]
    # A step that is said to be none is none.
    joined = workable(series([1.0] * 7, hours), limit, 1.0, direction_rad=np.pi, longest_step_h=7)
    assert [window.duration_h for window in windows(joined, 1.0)] == [12]
    with_nan = windows(found_in([1, 1, np.nan, 1, 1, 1]), 1.0)
    assert [(window.duration_h, window.ended_by) for window in with_nan] == [
        (1, "no data"),
        (2, "end of the series"),
    ]


def test_uneven_steps_count_by_their_time() -> None:
    found = workable(
        series([1, 1, 1, 1, 3], [0, 1, 2.5, 3, 4]), limit, 1.0, direction_rad=np.pi, longest_step_h=2
    )
    assert [window.duration_h for window in windows(found, 0.0)] == [3]


def test_conditions_that_were_not_studied_give_no_window() -> None:
    sea = series([1.0] * 6)
    sea.period_s[3] = 13.0
    kept = windows(workable(sea, limit, 1.0, direction_rad=np.pi), 0.0)
    assert [(window.duration_h, window.ended_by) for window in kept] == [
        (2, "not studied"),
        (1, "end of the series"),
    ]


def test_directions_of_the_series_are_seen_from_the_ship() -> None:
    """Waves of 1.5 m from north: from ahead 2 m are allowed, from abeam 1 m."""
    sea = series([1.5] * 4)
    sea = Series(sea.time, sea.height_m, sea.period_s, direction_from_deg=np.zeros(4))
    assert len(windows(workable(sea, limit, 1.0, x_axis_deg=0.0), 3.0)) == 1
    abeam = workable(sea, limit, 1.0, x_axis_deg=90.0)
    assert windows(abeam, 0.0) == []
    assert abeam.why_not(0) == "tension"


def test_waiting_times_of_a_square_wave() -> None:
    """12 h of calm in each 24 h, T_R 6 h: it may begin in the first 6 h of each calm, else one waits for the
    next."""
    found = found_in(square(12, 12, 3))
    waits = waiting_h(found, 6.0)
    expected = [0.0 if hour <= 6 else 24.0 - hour for hour in range(24)]
    assert waits[:24].tolist() == expected
    # After the last start there is nothing to wait for.
    assert np.isnan(waits[48 + 7 :]).all()
    assert np.isnan(waiting_h(found, 13.0)).all()


def test_months_have_their_own_shares() -> None:
    """January calm all along, February rough, March calm every other 12 h."""
    january, february = np.full(31 * 24, 1.0), np.full(28 * 24, 3.0)
    march = np.tile(np.repeat([1.0, 3.0], 12), 31)
    rows = by_month(found_in(np.concatenate([january, february, march])), 6.0).set_index("month")
    assert rows["records"].tolist() == [31 * 24, 28 * 24, 31 * 24]
    assert rows["workable_per_cent"].tolist() == [100, 0, 50]
    # Of 12 records in a calm, which spans 11 h, 6 leave 6 h.
    assert rows["start_per_cent"].tolist() == pytest.approx([100 * (31 * 24 - 6) / (31 * 24), 0, 25])
    assert rows["windows"].tolist() == [1, 0, 31]
    # In February one waits for March: from 28 days to an hour, evenly.
    assert rows.loc[2, "mean_waiting_h"] == pytest.approx((28 * 24 + 1) / 2)
    assert (rows["not_studied_per_cent"] == 0).all()


def test_persistence_counts_every_period() -> None:
    heights = np.concatenate([square(6, 6, 1), square(12, 12, 1), square(24, 12, 2)])
    found = persistence(found_in(heights), (6.0, 12.0, 24.0, 30.0))
    assert (found.periods, found.mean_h, found.longest_h) == (4, 16.5, 24)
    assert found.lasting == {6.0: 1.0, 12.0: 0.75, 24.0: 0.5, 30.0: 0.0}
    assert persistence(found_in([3.0, 3.0])).periods == 0


def test_go_when_the_reference_period_fits_from_now_on() -> None:
    sea = series(square(12, 12, 4))
    go = decide(sea, limit, 0.8, 12.0, direction_rad=np.pi)
    assert (go.is_go, go.lead_h, go.governs) == (True, 0.0, "heel")
    later = decide(sea, limit, 0.8, 12.0, now=START + np.timedelta64(1, "h"), direction_rad=np.pi)
    # 11 h of calm are left: the sea after it stands against it, and the next window begins in 23 h.
    assert (later.is_go, later.lead_h, later.governs) == (False, 23.0, "heel")
    # What is ahead ends after 72 h: the fourth window is seen for an hour, too short.
    assert [window.start for window in later.windows] == [START + np.timedelta64(24 * k, "h") for k in (1, 2)]


def test_rolling_over_a_forecast_counts_down_to_its_window() -> None:
    sea = series(np.concatenate([np.full(30, 3.0), np.full(60, 1.0)]))
    for hour in range(0, 31, 3):
        found = decide(sea, limit, 1.0, 12.0, now=START + np.timedelta64(hour, "h"), direction_rad=np.pi)
        assert found.lead_h == 30 - hour
        assert found.is_go == (hour == 30)


@pytest.mark.parametrize(
    ("heights", "reason"),
    [
        ([1.0] * 8 + [3.0] * 20, "heel"),
        ([1.0] * 8 + [np.nan] * 20, "no data"),
        ([1.0] * 8, "end of the series"),
    ],
)
def test_a_no_go_names_the_reason(heights: list[float], reason: str) -> None:
    found = decide(series(heights), limit, 1.0, 12.0, direction_rad=np.pi)
    assert not found.is_go
    assert found.governs == reason
    assert np.isnan(found.lead_h)


def test_now_between_two_records_counts_from_the_next() -> None:
    sea = series([1.0] * 30)
    found = decide(sea, limit, 1.0, 12.0, now=START + np.timedelta64(90, "m"), direction_rad=np.pi)
    assert (found.is_go, found.windows[0].start) == (True, START + np.timedelta64(2, "h"))


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: reference_period_h(73.0), "operation_hours: found 73, allowed: more than 0, at most 72"),
        (lambda: reference_period_h(70.0), "contingency_hours: found 70, allowed: from 0 to 26"),
        (lambda: found_in([1.0, 1.0], 1.1), "alpha: found 1.1, allowed: more than 0, at most 1"),
        (lambda: workable(series([1.0]), limit, 1.0), "direction: found neither"),
        (lambda: workable(series([1.0]), limit, 1.0, x_axis_deg=0.0), "direction: found none in the series"),
        (lambda: decide(series([1.0]), limit, 1.0, 80.0, direction_rad=0.0), "reference period: found 80 h"),
        (
            lambda: decide(
                series([1.0]), limit, 1.0, 1.0, now=START + np.timedelta64(9, "h"), direction_rad=0.0
            ),
            "now: found 2026-01-01T09:00:00, allowed: up to 2026-01-01T00:00:00",
        ),
    ],
)
def test_invalid_numbers_are_refused(call, message: str) -> None:
    with pytest.raises(KingpostError, match=message):
        call()


@pytest.fixture
def study(tmp_path: Path) -> Path:
    """A study's folder: a limit of 5 deg, 1.5 deg a metre at every period: about 2.4 m are allowed."""
    rng = np.random.default_rng(1)
    grid = np.meshgrid([1.0, 2.0, 4.0], [6.0, 10.0], np.arange(1, 21), indexing="ij")
    hs, tp, seed = (one.ravel() for one in grid)
    worst = hs * 1.5 * (1 + 0.15 * rng.gumbel(size=len(hs)))
    results = xarray.Dataset(
        {
            "limit_worst": (("run", "limit"), worst[:, None]),
            "limit_held": (("run", "limit"), (worst <= 5).astype("i1")[:, None]),
            "status": ("run", np.zeros(len(hs), "i1")),
        },
        {
            "hs": ("run", hs), "tp": ("run", tp), "seed": ("run", seed),
            "limit": np.array(["roll"], np.dtypes.StringDType()),
            "at_least": ("limit", [np.nan]), "at_most": ("limit", [5.0]),
        },
        {
            "title": "a made-up lift", "axes": "hs tp", "after_s": 60.0, "duration_s": 660.0,
            "sea_significant_height": "hs", "sea_peak_period": "tp", "operation_s": 1800.0,
            "acceptance": 0.1,
        },
    )  # fmt: skip
    return folder_of(results, tmp_path / "study")


def forecast(folder: Path, *options: str) -> list[str]:
    file = folder / "forecast.csv"
    heights = np.concatenate([np.full(10, 3.0), np.full(20, 1.0)])
    rows = [f"{START + np.timedelta64(k, 'h')},{height},8,20" for k, height in enumerate(heights)]
    file.write_text("time,hs,tp,mwd\n" + "\n".join(rows))
    return ["forecast", "--series", str(file), "--alpha", "0.8", *options]


def test_the_command_prints_the_windows_with_what_governs_and_the_lead_time(
    study: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(forecast(tmp_path, "--study", str(study), "--heading-deg", "20")) == 0
    printed = capsys.readouterr()
    assert printed.err == ""
    assert "a made-up lift" in printed.out
    assert "alpha 0.8, reference period 12 h" in printed.out
    assert "NO-GO at 2026-01-01 00:00 UTC: roll; the next window begins in 10 h" in printed.out
    assert "2026-01-01 10:00  2026-01-02 05:00  19  2026-01-01 17:00" in printed.out
    assert main(forecast(tmp_path, "--study", str(study), "--direction-deg", "180", "--json",
                         "--now", "2026-01-01T12:00+02:00")) == 0  # fmt: skip
    found = json.loads(capsys.readouterr().out)
    assert found["go"] is True
    assert found["lead_h"] == 0
    assert [window["governs"] for window in found["windows"]] == ["roll"]
    assert found["windows"][0]["start"] == "2026-01-01T10:00:00"
    assert len(found["records"]["time"]) == 20


def test_the_screen_is_asked_for_the_seas_of_the_forecast_that_the_scenario_can_have(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The screen itself stands aside: 2 m where waves come from ahead. Its hull takes no waves of 5 s."""
    asked = {}

    def screen(scenario, axes, operation_s, acceptance, height):  # type: ignore[no-untyped-def]
        asked.update(axes=axes, operation_s=operation_s, acceptance=acceptance)
        seas = axes["peak_period_s,wave_direction_deg"]
        heights = np.array([[2.0 if abs(direction) == 180 else 0.5 for _, direction in seas]])
        return xarray.Dataset({"limiting_height_of_all": (("hs", "sea"), heights),
                               "governs": (("hs", "sea"), np.full(heights.shape, "pitch"))})  # fmt: skip

    monkeypatch.setitem(sys.modules, "kingpost.study.screening.screen", SimpleNamespace(screen=screen))
    arguments = forecast(tmp_path, "offshore_vessel", "--set", "waves=true", "--heading-deg", "20", "--set",
                         "limits={pitch: {column: hull.pitch, within: 3, unit: deg}}")  # fmt: skip
    file = tmp_path / "forecast.csv"
    file.write_text(file.read_text().replace("3.0,8,20", "3.0,5,20").replace("1.0,8,20", "1.0,9.5,20"))
    assert main(arguments) == 0
    assert asked["axes"] == {
        "significant_height_m": [1.0],
        "peak_period_s,wave_direction_deg": [[9.5, -180.0]],
    }
    assert (asked["operation_s"], asked["acceptance"]) == (1800.0, 0.1)
    printed = capsys.readouterr()
    assert "limiting heights by linear response" in printed.out
    assert "the next window begins in 10 h" in printed.out
    assert printed.err.startswith("warning: Tp from 5 to 5 s: ")
    assert printed.err.endswith(
        "warning: 10 of 30 records have no limiting height: no data, or not studied\n"
    )


def test_conditions_that_were_not_studied_give_a_warning(
    study: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    arguments = forecast(tmp_path, "--study", str(study), "--direction-deg", "180")
    file = tmp_path / "forecast.csv"
    file.write_text(file.read_text().replace("1.0,8", "1.0,12"))
    assert main(arguments) == 0
    printed = capsys.readouterr()
    assert "no window of 12 h" in printed.out
    assert printed.err == "warning: 20 of 30 records have no limiting height: no data, or not studied\n"


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ((), "error: direction: found neither, allowed: --heading-deg"),
        (("--direction-deg", "180"), "error: SCENARIO, --study: found neither, allowed: one of them"),
        (("--direction-deg", "180", "--study", "nowhere"), "error: nowhere: found no study.json in it"),
        (("--heading-deg", "0", "--operation-hours", "80"), "error: operation_hours: found 80, allowed"),
        (
            ("--heading-deg", "0", "--columns", "height"),
            "error: --columns: found 'height', allowed: name=value",
        ),
        (("--heading-deg", "0", "--columns", "height=x"), "error: .*forecast.csv:1: columns: found 'x'"),
    ],
)
def test_the_command_forecast_reports_wrong_input(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], options: tuple[str, ...], message: str
) -> None:
    assert main(forecast(tmp_path, *options)) == 2
    assert re.match(message, capsys.readouterr().err)

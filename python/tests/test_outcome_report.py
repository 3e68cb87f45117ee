"""Report of the results of limits and of the engine's warnings, for one run or many."""

from __future__ import annotations

from pathlib import Path

import kingpost
import numpy as np
import pytest
import xarray
from kingpost.cli import main
from kingpost.reports import outcomes as outcome_report
from kingpost.reports import run as report
from kingpost.reports.outcomes import Outcome
from kingpost.results import entries

# The barge lies at -0.265 deg; the first two seas leave her within this limit.
LIMITS = {"trim": {"column": "ship.pitch", "at_least": -0.28, "unit": "deg"}}


@pytest.fixture(scope="module")
def seas(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A barge in waves for four seconds, with a limit, as a file."""
    path = tmp_path_factory.mktemp("seas") / "barge.json"
    path.write_text(kingpost.load("barge", {"simulation.duration_s": 4.0, "limits": LIMITS}, waves=True).json)
    return path


def row(shown: str, name: str) -> list[str]:
    """The words of the line of a table that begins with a name."""
    (line,) = (line for line in shown.splitlines() if line.startswith(f"{name} "))
    return line.split()


def test_the_report_of_many_seeds_prints_the_number_of_runs_in_which_a_limit_held_and_its_worst_value(
    seas, tmp_path, capsys
):
    """Source: the rows of each run, as its file has them; a limit that does not hold fails no run."""
    assert main(["run", str(seas), "--seeds", "3", "-o", str(tmp_path / "run_*.nc")]) == 0
    shown = capsys.readouterr().out
    files = [str(tmp_path / f"run_{seed}.nc") for seed in (1, 2, 3)]
    pitch = [np.rad2deg(xarray.load_dataset(file)["pitch"].sel(body="ship")) for file in files]
    smallest = [float(values.min()) for values in pitch]
    assert [value >= -0.28 for value in smallest] == [True, True, False]
    at_s = float(pitch[2].time[pitch[2].values.argmin()])
    expected = ["trim", "NO", "2", "of", "3", f"{smallest[2]:.4g}", "deg", "3", f"{at_s:.4g}"]
    assert row(shown, "trim") == [*expected, "at", "least", "-0.28", "ship.pitch"]
    assert main(["statistics", *files, "--after-s", "1"]) == 0
    assert row(capsys.readouterr().out, "trim")[:9] == expected
    assert main(["statistics", files[0], "--after-s", "1"]) == 0
    assert row(capsys.readouterr().out, "trim")[:3] == ["trim", "yes", f"{smallest[0]:.4g}"]


def test_the_file_of_a_seed_has_the_limits_of_that_run(seas, tmp_path):
    """Source: the run alone."""
    assert main(["run", str(seas), "--seeds", "2", "-o", str(tmp_path / "run_*.nc")]) == 0
    alone = kingpost.run(seas, {"simulation.seed": 2})
    found = xarray.load_dataset(tmp_path / "run_2.nc", engine="h5netcdf")
    assert entries.limits_of(found) == entries.limits_of(alone)
    assert entries.warnings_of(found) == entries.warnings_of(alone)


def test_runs_that_fail_are_named_by_their_seeds_beside_the_limits(seas, tmp_path, capsys):
    """Source: a limit of rates that the sea exceeds at once."""
    settings = ["--set=simulation.rate_limit=0.03"]
    assert main(["run", str(seas), *settings, "--seeds", "2", "-o", str(tmp_path / "run_*.nc")]) == 1
    shown = capsys.readouterr()
    assert "\n2 of 2 runs failed, of the seeds 1, 2: they count until then\n" in shown.out
    assert row(shown.out, "trim")[4] == "2"
    assert "run_2.nc: " in shown.err


def limit(worst: float | None, held: bool | None, at_s: float | None = 1.0) -> dict:
    bounds = {
        "at_least": -5.0,
        "at_most": 5.0,
        "percentile": 100.0,
        "held": held,
        "worst": worst,
        "worst_time_s": at_s,
    }
    return {"name": "heel", "column": "hull.roll", "unit": "deg", **bounds}


def test_the_worst_value_of_a_limit_with_two_bounds_is_farthest_beyond_a_bound():
    """Source: by hand; -5.5 is farther beyond its bound than 5.2 is."""
    runs = [Outcome(1, [limit(4.0, True)], []), Outcome(2, [limit(-5.5, False, at_s=67.3)], [])]
    runs += [Outcome(3, [limit(5.2, False)], []), Outcome(4, [limit(None, None, at_s=None)], [])]
    heading, line = outcome_report.limits(runs)
    assert " ".join(heading.split()) == "limit held in runs worst unit seed at, s allowed column"
    assert " ".join(line.split()) == "heel NO 1 of 3 -5.5 deg 2 67.3 -5 to 5 hull.roll"


def test_a_limit_without_evaluated_rows_is_reported_as_such():
    runs = [Outcome(seed, [limit(None, None, at_s=None)], []) for seed in (1, 2)]
    assert (
        " ".join(outcome_report.limits(runs)[1].split()) == "heel no row 0 of 0 - deg - - -5 to 5 hull.roll"
    )


PARTED = [{"time_s": 67.2913, "element": "hoist_rope", "code": "parts", "what": "parts"}]


def told(name: str, text: str, code: str = "made_up", time_s: float = 1.0) -> entries.WarningEntry:
    """A warning without a number."""
    return {"time_s": time_s, "code": code, "name": name, "value": None, "bound": None, "unit": "",
            "text": text}  # fmt: skip


def run_of(**made_up: list) -> xarray.Dataset:
    """A data set of events, warnings and limits alone."""
    return entries.with_entries(xarray.Dataset(), **made_up)


def came_of(warnings: list[entries.WarningEntry]) -> list[str]:
    """The lines of a run in which a rope parted, with a limit."""
    run = outcome_report.of_run(run_of(limits=[limit(1.0, True)], events=PARTED, warnings=warnings), 1)
    return [line for block in outcome_report.blocks([run]) for line in block]


def test_a_parted_rope_is_reported_above_the_limits():
    shown = came_of([told("hull", "heels")])
    assert shown[0] == "warning: hoist_rope parted at 67.29 s"
    assert shown[1].startswith("limit")
    assert shown[3:] == ["warning: hull: heels"]


def test_a_rope_that_parts_is_reported_once_with_the_time():
    warned = [
        told("hull", "heels"),
        told("hoist_rope", "parts: why", "parts", 67.2913),
    ]
    shown = came_of(warned)
    assert shown[0] == "warning: hoist_rope parted at 67.29 s: why"
    assert shown[1].startswith("limit")
    assert shown[3:] == ["warning: hull: heels"]


def test_ropes_that_part_in_several_runs_are_reported_above_the_limits_with_times():
    seconds = (64.35, 63.96)
    parts = [run_of(warnings=[told("hoist_rope", "parts", "parts", at_s)]) for at_s in seconds]
    runs = [outcome_report.of_run(found, seed) for seed, found in enumerate(parts, 1)]
    words = (
        "warning, in 2 of 2 runs, from 63.96 (seed 2) to 64.35 (seed 1), first: hoist_rope parted at 64.35 s"
    )
    assert outcome_report.blocks(runs) == [[words]]


def test_other_warnings_of_a_rope_that_parted_do_not_hide_it():
    shown = came_of([told("hoist_rope", "went slack")])
    assert shown[0] == "warning: hoist_rope parted at 67.29 s"
    assert shown[-1] == "warning: hoist_rope: went slack"


OFF = [told("energy", "is off by 12 kJ, 3 % of the energy in play, 400 kJ", "energy_off_balance")]


def test_limits_of_a_run_with_an_energy_error_are_headed_as_unreliable():
    heading, columns, *_ = outcome_report.limits([Outcome(1, [limit(1.0, True)], OFF)])
    assert heading == "limits, NOT reliable: the energy does not balance"
    assert columns.startswith("limit ")


def test_limits_of_several_runs_name_the_seeds_with_an_energy_error():
    runs = [Outcome(seed, [limit(1.0, True)], OFF if seed > 1 else []) for seed in (1, 2, 3)]
    heading, *_ = outcome_report.limits(runs)
    assert heading.endswith("the energy does not balance in 2 of 3 runs, seeds 2, 3")
    assert outcome_report.limits(runs[:1])[0].startswith("limit ")


def test_a_summary_does_not_repeat_the_warning_of_an_energy_error():
    """Source: one thought, said once; forward Euler gains energy."""
    scenario = kingpost.load(
        "paper", {"simulation.duration_s": 2.0, "simulation.integrator": "forward_euler"}
    )
    results = kingpost.run(scenario, {"simulation.step_s": 0.01, "simulation.record_every_s": 0.01})
    assert abs(results["energy_error"][-1]) > 0.01 * results["energy_scale"].max()
    assert "warning" not in report.summary(results, scenario)


def warned(*texts: str) -> list[Outcome]:
    """Runs of the seeds from 1 on, each with one warning of a boom."""
    return [Outcome(seed, [], [told("boom", text)]) for seed, text in enumerate(texts, 1)]


def test_a_warning_of_several_runs_has_the_range_of_its_first_number():
    near = "comes as near as {} m to leg_2, at {} s"
    _, lines = outcome_report.warnings(warned(near.format(2.89, 7), near.format(0.4, 9), near.format(12, 1)))
    range_of = "from 0.4 (seed 2) to 12 (seed 3)"
    assert lines == [f"warning, in 3 of 3 runs, {range_of}, first: boom: {near.format(2.89, 7)}"]


def test_a_warning_whose_number_is_the_same_in_all_runs_has_no_range():
    _, lines = outcome_report.warnings(warned("pushes with 3 kN", "pushes with 3 kN", "pushes"))
    assert lines == [
        "warning, in 2 of 3 runs, first: boom: pushes with 3 kN",
        "warning, in 1 of 3 runs, first: boom: pushes",
    ]


def test_digits_in_a_name_do_not_count_as_the_number_of_a_warning():
    _, lines = outcome_report.warnings(warned("meets leg_2 at 7 s", "meets leg_3 at 7 s"))
    assert [line[:28] for line in lines] == ["warning, in 1 of 2 runs, fir"] * 2

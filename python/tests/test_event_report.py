"""The report of the events of a run."""

from __future__ import annotations

import re
from pathlib import Path

import xarray
from kingpost.cli import main
from kingpost.reports import events as event_report
from kingpost.results.entries import with_entries
from kingpost.simulation.records import PARTS, REPEATING, STEP_BEGINS

ENGINE = Path(__file__).resolve().parents[2] / "crates" / "kingpost" / "src"


def shown(*events: tuple[float, str, str]) -> list[str]:
    """Lines of a run's events, with single blanks; an event's code is its name with _ for blanks."""
    found = [
        {"time_s": time_s, "element": element, "code": what.replace(" ", "_"), "what": what}
        for time_s, element, what in events
    ]
    lines = event_report.events(with_entries(xarray.Dataset(), events=found))
    return [" ".join(line.split()) for line in lines]


def test_important_events_come_first_in_order_of_time_and_repeating_ones_are_counted():
    slack = [(10.0 + k, "sling", ("goes slack", "comes taut")[k % 2]) for k in range(51)]
    deck = [(5.0, "deck", "touches"), (6.0, "deck", "slides"), (7.0, "deck", "slides")]
    assert shown(
        (0.0, "operation", 'begins "hoist"'),
        *deck,
        *slack,
        (67.29, "hoist_rope", "parts"),
        (68.0, "load", "is under water"),
    ) == [
        "at, s event",
        '0.00 operation begins "hoist"',
        "67.29 hoist_rope parts",
        "68.00 load is under water",
        "",
        "repeating events first at, s last at, s",
        "deck touches once, slides 2 times 5.00 7.00",
        "sling goes slack 26 times, comes taut 25 times 10.00 60.00",
    ]


def test_events_of_one_element_that_repeat_with_every_wave_are_counted():
    waves = [(float(k), "module", "meets the water") for k in range(5)]
    assert shown(*waves)[1:] == ["module meets the water 5 times 0.00 4.00"]
    assert shown(*waves[:4])[1:] == [f"{k}.00 module meets the water" for k in range(4)]


def test_a_run_ended_by_a_step_of_its_operation_reports_this_last(capsys):
    """Source: a load that is to be 9 m high after a second of its step, which begins at 30 s."""
    settings = {"simulation.duration_s": 40, "operation.steps.1.time_out_s": 1}
    assert (
        main(["run", "lift_off_from_barge", *(f"--set={name}={value}" for name, value in settings.items())])
        == 1
    )
    printed = capsys.readouterr()
    lines = [" ".join(line.split()) for line in printed.out.splitlines()]
    begins = lines.index('30.00 operation begins "lift off"')
    assert lines[begins + 1] == "31.00 the run ends early"
    assert "did not end within 1 s" in printed.err


def test_a_run_without_events_prints_no_table():
    assert shown() == []


def test_the_codes_that_the_reports_know_are_codes_of_the_engine():
    """Source: the codes of the engine's elements."""
    text = "\n".join(path.read_text(encoding="utf-8") for path in ENGINE.glob("elements/**/*.rs"))
    assert set(re.findall(r'"([a-z_]+)"', text)) >= {*REPEATING, PARTS, STEP_BEGINS}

"""Tests of the contract: accepted results and detected violations."""

from __future__ import annotations

import json
import random
import tempfile
from pathlib import Path

import kingpost
import numpy
import pytest
from kingpost.errors import KingpostError

from . import apart
from .contract import Case, judge
from .corpus import load, save
from .kinds import command_line, records

CASE = Case("records", {"record.csv": b"time_s\n", "below/x.csv": b"\xff\x00"}, ("decay", "python"))


def refused(*_: object) -> str:
    raise KingpostError("record.csv: found no roll, allowed: a column roll_deg")


def broken(*_: object) -> str:
    raise ZeroDivisionError("by 0")


def panicked(*_: object) -> str:
    raise KingpostError("the engine failed: index out of bounds; this is a defect of Kingpost")


def loud(*_: object) -> str:
    print("a\x1b[31mred")
    return "taken"


def endless(*_: object) -> str:
    print(10**300)
    return "taken"


@pytest.mark.parametrize(
    ("use", "says"),
    [
        (refused, "refused: record.csv: found no roll"),
        (broken, "WRONG: ZeroDivisionError at test_contract.py:"),
        (panicked, "WRONG: a panic"),
        (loud, "WRONG: a control character"),
        (endless, "WRONG: a number of 301 digits"),
    ],
)
def test_a_case_is_judged_by_output_and_exit_code(use, says, tmp_path) -> None:
    """Source: the public contract."""
    assert judge(use, CASE, tmp_path).startswith(says)
    assert list(tmp_path.iterdir()) == []


def test_a_case_reads_back_from_its_file(tmp_path) -> None:
    """Source: what is saved is replayed."""
    assert load(save(CASE, tmp_path, "WRONG")) == CASE


def test_a_saved_case_contains_no_folder_of_the_machine(tmp_path) -> None:
    """Source: a case of the corpus is read on other machines; their folders are not these."""
    drawn = f"{tempfile.gettempdir()}/tmpab_12x9z"
    says = (
        f"WRONG: {drawn}/below/x.csv:3: roll: found 1e400; {kingpost.__file__}:7: RuntimeWarning; "
        f"{numpy.__file__}:9; {tmp_path}/y.csv; at {drawn}; GET /files/x.nc; {Path.home()}/z"
    )
    found = json.loads(save(CASE, tmp_path, says).read_text())["found"]
    assert found.startswith(
        "WRONG: below/x.csv:3: roll: found 1e400; kingpost/__init__.py:7: RuntimeWarning; "
    )
    assert "; numpy/__init__.py:9; " in found
    assert "GET /files/x.nc" in found
    assert not any(folder in found for folder in (tempfile.gettempdir(), str(Path.home()), "tmpab"))


def test_the_same_seed_draws_the_same_case() -> None:
    """Source: a failure that cannot be repeated cannot be mended."""
    for kind in (command_line, records):
        drawn = [[kind.drawn(random.Random(seed)) for seed in range(20)] for _ in range(2)]
        assert drawn[0] == drawn[1]


def test_a_process_that_computes_does_not_hang_and_one_that_sleeps_does(monkeypatch) -> None:
    """Source: a machine that is busy with other things: a case is judged by its own time alone."""
    monkeypatch.setattr(apart, "LONGEST_WAIT_S", 1.0)
    process = apart.Apart()
    process.begin()
    used = iter([0.1, 0.2, 0.3, 0.3])
    monkeypatch.setattr(apart, "_processor_s", lambda _: next(used))

    class Ends:
        answers = iter([False, False, True])

        def poll(self, _: float) -> bool:
            return next(self.answers)

    ends, process.ends = process.ends, Ends()  # type: ignore[assignment]
    assert process._answers()
    used, Ends.answers = iter([0.1, 0.2, 0.2]), iter([False, False, True])
    assert not process._answers()
    process.ends = ends
    process.end()

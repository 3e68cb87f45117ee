"""Wrong inputs of every kind: each is accepted, or refused with a message. This run is short and
reproducible; `tools/attack.py` runs long. Failures of both are stored in `corpus/`, and a test replays them.
"""

from __future__ import annotations

import importlib
import os

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from lanes import THOROUGH

from .apart import Apart
from .corpus import FOLDER, load

# Number of cases in the short run, by the time of one case.
CASES = {
    "scenario_text": 60,
    "command_line": 100,
    "databases": 80,
    "rao_tables": 120,
    "records": 60,
    "meshes": 80,
    "netcdf": 30,
    "foreign": 60,
    "requests": 120,
}
TIMES = int(os.environ.get("KINGPOST_FUZZ_TIMES", "1"))
"""Factor on the number of cases, with new seeds each time."""
SHARE = 1 if THOROUGH else 6
"""One in so many cases is drawn by default."""


@pytest.fixture(scope="module")
def apart():
    """One process for all kinds, which loads modules only once."""
    process = Apart()
    yield process
    process.end()


@pytest.mark.parametrize("kind", CASES)
def test_a_mutated_input_is_accepted_or_refused_with_a_message(kind, apart):
    """Source: the public contract: `contract` says what is allowed."""
    drawn = importlib.import_module(f"fuzz.kinds.{kind}").drawn

    @settings(
        max_examples=CASES[kind] * TIMES // SHARE,
        derandomize=TIMES == 1,
        database=None,
        deadline=None,
        suppress_health_check=list(HealthCheck),
    )
    @given(st.randoms(use_true_random=False))
    def holds(draw) -> None:
        case = drawn(draw)
        says = apart.ask(case).says
        assert not says.startswith("WRONG"), f"{says}\n{case}"[:5000]

    holds()


def test_every_saved_failure_now_meets_the_contract(apart):
    """Source: the corpus: each of its cases came to what must not be."""
    paths = sorted(FOLDER.glob("*/*.json"))
    said = {path.relative_to(FOLDER).as_posix(): apart.ask(load(path)).says for path in paths}
    assert {name: says for name, says in said.items() if says.startswith("WRONG")} == {}

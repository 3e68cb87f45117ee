"""The numbers that the app must show: rows of gallery runs as `kingpost run` writes them, by their digests.

`web/tests/numbers.test.ts` runs the same in the app's engine and compares what its recording holds. After a
change of the numbers: `.venv/bin/python python/tests/test_app_numbers.py` writes the digests anew.
"""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

import kingpost
import numpy as np
import pytest

KEPT = Path(__file__).parents[2] / "web" / "tests" / "numbers.json"
ROWS = 10
DURATION_S = 6.0
SCENARIOS = {
    "barge": {"waves": True},
    "offshore_vessel": {"waves": True},
    "lift_off_from_barge": {},
    "two_ships": {},
    "knuckle_boom_crane": {},
    "tennis_racket": {},
}


def measured(name: str) -> dict[str, object]:
    """Ten rows of a run, from its first to its last: their places among all and a digest of each."""
    overrides = SCENARIOS[name]
    rows = kingpost.results.frame(kingpost.run(name, {**overrides, "simulation.duration_s": DURATION_S}))
    places = np.linspace(0, len(rows) - 1, ROWS).round().astype(int).tolist()
    numbers = np.ascontiguousarray(rows.to_numpy(dtype="<f8"))
    digests = [hashlib.sha256(numbers[place].tobytes()).hexdigest() for place in places]
    return {"scenario": name, "overrides": overrides, "places": places, "sha256": digests}


@pytest.mark.parametrize("name", SCENARIOS)
def test_the_stored_digests_match_the_rows_of_the_command_line(name):
    """Source: the run itself; the same file is held against the app's engine."""
    kept = {entry["scenario"]: entry for entry in json.loads(KEPT.read_text())}
    assert measured(name) == kept[name]


if __name__ == "__main__":
    KEPT.write_text(json.dumps([measured(name) for name in SCENARIOS], indent=1) + "\n")

"""Attributes of a file of results: those of a run are accepted, others are refused."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import kingpost
import pytest
from kingpost.results.kept import are_of_a_run

LIMIT = {"name": "heel", "column": "ship.roll", "unit": "deg", "at_least": -5.0, "at_most": 5.0, "held": True,
         "worst": 1.0, "worst_time_s": 0.5}  # fmt: skip
OF_A_RUN = {
    "scenario": {"sea": {"ramp_s": 30.0}, "simulation": {"seed": 1}, "parameters": [{"name": "crane_x_m"}]},
    "files": {"gallery:hydro/barge.hydro.json": "978f1a94"},
    "events": [{"time_s": 1.5, "element": "winch", "what": "stops"}],
    "warnings": [{"time_s": 4.0, "name": "ship", "text": "it heeled"}],
    "limits": [LIMIT],
    "floating_bodies": ["ship"],
}


def stored(tree: dict[str, Any]) -> dict[str, Any]:
    return {name: json.dumps(value) for name, value in tree.items()}


def test_attributes_of_a_run_and_of_a_batch_are_accepted():
    """Source: what the program itself writes."""
    short = {"simulation.duration_s": 0.02}
    assert are_of_a_run(kingpost.run("paper", short).attrs, None)
    assert are_of_a_run(kingpost.Batch("paper", {"crane_x_m": [0, 1]}, short).run().attrs, 2)
    assert are_of_a_run(stored(OF_A_RUN), None)
    assert are_of_a_run({}, None)


@pytest.mark.parametrize(
    "damage",
    [
        lambda tree: tree.update(events=[{"time_s": 1.5}]),
        lambda tree: tree.update(events={"time_s": 1.5}),
        lambda tree: tree["warnings"][0].pop("text"),
        lambda tree: tree["warnings"][0].update(time_s="soon"),
        lambda tree: tree["limits"][0].update(at_least=None, at_most=None),
        lambda tree: tree["limits"][0].update(worst=float("nan")),
        lambda tree: tree["limits"][0].update(held=1),
        lambda tree: tree.update(limits=[[LIMIT]]),
        lambda tree: tree["scenario"].update(sea={}, operation=[1]),
        lambda tree: tree["scenario"].update(sea={"ramp_s": None}),
        lambda tree: tree["scenario"].update(parameters=[1]),
        lambda tree: tree.update(scenario=[]),
        lambda tree: tree.update(files={"a": 1}),
        lambda tree: tree.update(floating_bodies=[1]),
    ],
)
def test_attributes_that_no_run_has_are_refused(damage: Callable[[dict[str, Any]], object]):
    """Source: found by damaging files; each led to a traceback of the command `statistics` or `plot`."""
    tree = json.loads(json.dumps(OF_A_RUN))
    damage(tree)
    assert not are_of_a_run(stored(tree), None)


def test_attributes_that_are_not_json_are_refused():
    for text in ("{", "[" * 100_000, 7):
        assert not are_of_a_run({"events": text}, None)

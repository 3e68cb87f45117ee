"""Lifts off a supply boat: the stored results in twenty seas agree with the engine and with the page."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest
from kingpost.analysis import lift_rules
from lanes import sampled
from studies import supply_boat_lifts as study

STORED = json.loads(Path(study.__file__).with_suffix(".json").read_text(encoding="utf-8"))
PAGE = Path(__file__).resolve().parents[2] / "docs" / "validation.md"


@pytest.mark.parametrize(("hook", "seed"), sampled([("0.45", 1), ("0.27", 2)], keep=[("0.45", 1)]))
def test_a_stored_lift_agrees_with_the_engine(hook, seed) -> None:
    """Source: the same run again; six digits are kept."""
    stored = STORED["lifts"][hook]
    run = study.lifts(stored["winch_rate_rad_s"], [seed]).isel(run=0)
    assert study.readings(run) == pytest.approx(stored["seeds"][seed - 1], rel=1e-5)


def test_the_stored_rule_is_that_of_the_class_formula() -> None:
    """Source: `lift_rules` at the wave height of the scenario and the stored speed of the tip."""
    rule, tip = STORED["rule"], STORED["significant_speeds_before"]["tip_m_s"]
    asked = lift_rules.hoisting_speed_m_s(1.5, tip, lift_rules.SEVERAL_FALLS)
    assert rule["hoisting_m_s"] == pytest.approx(asked, rel=1e-5)
    slow = STORED["lifts"]["0.27"]["winch_rate_rad_s"] * study.HOOK_M_PER_RAD
    # The rate of the winch is rounded to 0.01 rad/s.
    assert slow == pytest.approx(asked, abs=0.005 * study.HOOK_M_PER_RAD + 1e-6)
    assert rule["offlead_m"] == lift_rules.offlead_m(1.5)


def test_the_page_agrees_with_the_stored_study() -> None:
    page = PAGE.read_text(encoding="utf-8").split("### Twenty lifts off a supply boat")[1].split("\n### ")[0]
    rows = re.findall(r"^\| `(\w+)` \|.*?\| ([\d., -]+) \| ([\d., -]+) \|", page, re.MULTILINE)
    assert [name for name, *_ in rows] == list(STORED["lifts"]["0.45"]["seeds"][0])
    for name, *cells in rows:
        for cell, lifts in zip(cells, STORED["lifts"].values(), strict=True):
            of_seeds = [one[name] for one in lifts["seeds"]]
            found = (np.mean(of_seeds), min(of_seeds), max(of_seeds))
            for text, value in zip(cell.split(", "), found, strict=True):
                assert text == f"{value:.{len(text.partition('.')[2])}f}", name
    for number in STORED["significant_speeds_before"].values():
        assert f"{number:.2f} m/s" in page


def test_the_stored_study_names_its_origin() -> None:
    assert STORED["command"] == study.COMMAND
    assert study.COMMAND in study.__doc__

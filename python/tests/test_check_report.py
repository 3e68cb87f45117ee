"""The report of `kingpost check` as a lifting engineer reads it."""

from __future__ import annotations

import re

import kingpost
from kingpost.reports import model
from kingpost.simulation.simulate import Simulation


def body_rows(name: str) -> dict[str, str]:
    """The rows of the table of bodies, by body."""
    scenario = kingpost.load(name)
    said = model.text(scenario, Simulation(scenario).coordinates)
    (table,) = (block for block in said.split("\n\n") if re.match(r"body +mass", block))
    return {line.split()[0]: line for line in table.splitlines()[1:]}


def test_masses_of_one_table_are_in_one_unit() -> None:
    """Source: an engineer read 25 t above 20000 kg, and took the load for the heavier."""
    for name in ("offshore_vessel", "slew_and_land", "tennis_racket"):
        units = {re.search(r"[\d.e+-]+ (t|kg)\b", row)[1] for row in body_rows(name).values()}
        assert len(units) == 1, name


def test_a_hull_floats_and_a_load_on_its_deck_is_free() -> None:
    """Source: the kind of a joint is a word of the file format; a container on a deck does not float."""
    rows = body_rows("slew_and_land")
    assert rows["hull"].endswith("floating hull")
    assert rows["barge_ship"].endswith("floating barge_ship")
    assert rows["lift"].endswith("free lift")

"""The formulas of standards for lifts from a supply vessel."""

from __future__ import annotations

import math

import pytest
from kingpost import lift_rules
from kingpost.errors import KingpostError


@pytest.mark.parametrize(("height_m", "printed_m_s"), [(1.4, 0.45), (2.7, 0.76), (3.6, 0.93)])
def test_the_hoisting_speed_is_the_one_that_others_print(height_m: float, printed_m_s: float) -> None:
    # Two figures: half of the last, and 0.005 for a table that cuts where it should round.
    assert lift_rules.hoisting_speed_m_s(height_m) == pytest.approx(printed_m_s, abs=0.005)


def test_a_tip_that_moves_adds_as_the_root_of_squares() -> None:
    still, moving = (lift_rules.hoisting_speed_m_s(2.0, tip) for tip in (0.0, 0.9))
    assert moving == pytest.approx(math.hypot(still, 0.5 * 0.9), rel=1e-15)


def test_sidelead_is_half_of_offlead() -> None:
    assert lift_rules.offlead_m(2.0) == 5.5
    assert lift_rules.sidelead_m(2.0) == 2.75


@pytest.mark.parametrize("wrong", [-1.0, math.nan, math.inf])
def test_a_wave_height_that_is_none_is_refused(wrong: float) -> None:
    with pytest.raises(KingpostError, match=r"significant_height_m: found .*"):
        lift_rules.offlead_m(wrong)

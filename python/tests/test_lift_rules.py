"""The formulas of standards for lifts."""

from __future__ import annotations

import math
import subprocess
import sys

import kingpost
import pytest
from kingpost.analysis import lift_rules
from kingpost.errors import KingpostError


@pytest.mark.parametrize(("height_m", "printed_m_s"), [(1.4, 0.45), (2.7, 0.76), (3.6, 0.93)])
def test_the_hoisting_speed_equals_published_values(height_m: float, printed_m_s: float) -> None:
    # Two figures: half of the last, and 0.005 for a table that cuts where it should round.
    assert lift_rules.hoisting_speed_m_s(height_m) == pytest.approx(printed_m_s, abs=0.005)


def test_a_tip_that_moves_adds_as_the_root_of_squares() -> None:
    still, moving = (lift_rules.hoisting_speed_m_s(2.0, tip) for tip in (0.0, 0.9))
    assert moving == pytest.approx(math.hypot(still, 0.5 * 0.9), rel=1e-15)


def test_sidelead_is_half_of_offlead() -> None:
    assert lift_rules.offlead_m(2.0) == 5.5
    assert lift_rules.sidelead_m(2.0) == 2.75


@pytest.mark.parametrize("wrong", [-1.0, math.nan, math.inf])
def test_a_nan_wave_height_is_refused(wrong: float) -> None:
    with pytest.raises(KingpostError, match=r"significant_height_m: found .*"):
        lift_rules.offlead_m(wrong)


def _loss() -> tuple[kingpost.Scenario, kingpost.Scenario]:
    before = kingpost.load("loss_of_hook_load")
    return before, before.with_overrides({"bodies.lift.enabled": False, "operation.enabled": False})


def test_area_1_after_loss_of_the_hook_load_is_that_of_a_linear_gz_curve() -> None:
    """GM (phi_2 - phi_1)^2 / 2: to 5 degrees the arms are straight to phi^2 BM / (2 GM), 1.3 %, and each
    trapezium is within its own bend."""
    before, after = _loss()
    found = lift_rules.hook_load_loss(before, after)
    stiff = after.hydrostatics["hulls"][0]["metacentric_height_m"][0]
    angle = math.radians(found.heel_after_deg - found.heel_before_deg)
    assert found.side == "starboard"
    assert found.area_1_m_rad == pytest.approx(0.5 * stiff * angle**2, rel=0.03)
    assert found.area_2_m_rad > 10 * found.area_1_m_rad
    assert found.held


def test_a_ship_with_an_early_flooding_angle_fails_the_rule() -> None:
    found = lift_rules.hook_load_loss(*_loss(), flooding_deg=9.0)
    assert found.end_deg == pytest.approx(9.0)
    assert not found.held
    assert lift_rules.hook_load_loss(*_loss(), flooding_deg=9.0, required=0.1).held


def test_a_scenario_without_a_hull_is_refused() -> None:
    paper = kingpost.load("paper")
    with pytest.raises(KingpostError, match="found None, allowed: a hull in the water, none in this"):
        lift_rules.hook_load_loss(paper, paper)
    with pytest.raises(KingpostError, match="found tower, allowed: a hull in the water, hull"):
        lift_rules.hook_load_loss(*_loss(), body="tower")


def test_a_ship_that_still_lists_to_the_side_of_the_load_is_judged_on_the_other_side() -> None:
    """Without counter ballast the boom alone lists her to port; the loss sends her to starboard."""
    changed = {"bodies.ballast.mass_t": 0.1}
    before, after = (scenario.with_overrides(changed) for scenario in _loss())
    found = lift_rules.hook_load_loss(before, after)
    assert found.side == "starboard"
    assert found.heel_before_deg < found.heel_after_deg < 0.0
    assert found.area_1_m_rad > 0.0


def test_the_rules_are_available_from_the_imported_package() -> None:
    words = "import kingpost; print(kingpost.lift_rules.offlead_m(1.0))"
    found = subprocess.run([sys.executable, "-c", words], capture_output=True, text=True, check=False)
    assert (found.stdout.strip(), found.stderr) == ("4.0", "")
    assert "lift_rules" in kingpost.__all__

"""The tandem lift of docs/checked: list and hook loads agree with statics by hand."""

from __future__ import annotations

from math import cos, pi, radians, sin, tan
from pathlib import Path

import kingpost
import numpy as np
import pytest
import xarray
from scipy.optimize import brentq

FILE = Path(__file__).resolve().parents[2] / "docs" / "checked" / "tandem_lift.yaml"
G = 9.80665
LOAD_KN = 320 * G
BELOW_BAR_T_M = 300 * 5.5 + 20 * 0.75
BETWEEN_HOOKS_M = 30.0
FALLS = 8
LENGTH_M = 322.0
"""Of each rope, from its drum on."""


def weights() -> list[tuple[float, float, float]]:
    """Mass (t), distance to port and height above the keel (m) of all weights, the load at the tips."""

    def on_boom(along: float, above: float) -> tuple[float, float]:
        angle = radians(60)
        return along * cos(angle) - above * sin(angle), 14 + along * sin(angle) + above * cos(angle)

    crane = [(130.0, 0.0, 10.0), (70.0, *on_boom(25, 0)), (12.0, *on_boom(6, 2.4))]
    return [(6036.0, 0.0, 3.5), (600.0, -9.8, 1.5), *crane, *crane, (320.0, *on_boom(50.3, 0))]


def list_by_hand(hydrostatics: str) -> float:
    """List of a box of 24 m at 3 m, rad: wall-sided for a mesh, BM cos f for linear hydrostatics."""
    total = sum(mass for mass, _, _ in weights())
    arm = sum(mass * y for mass, y, _ in weights()) / total
    height = sum(mass * z for mass, _, z in weights()) / total
    beam_m, draught_m = 24.0, total / (1.025 * 100 * 24)
    kb, bm = draught_m / 2, beam_m**2 / (12 * draught_m)

    def righting(f: float) -> float:
        wide = bm * (1 + tan(f) ** 2 / 2) if hydrostatics == "mesh" else bm * cos(f)
        return (kb + wide - height) * sin(f)

    return brentq(lambda f: arm * cos(f) - righting(f), 0, 0.2, xtol=1e-15)


def hook_loads_kn(run: xarray.Dataset) -> tuple[np.ndarray, np.ndarray]:
    aft, forward = (FALLS * run.kingpost[f"{crane}_rope.rope_tension"] / 1e3 for crane in ("aft", "forward"))
    return aft, forward


def difference_by_hand_kn(tilt: float) -> float:
    return 2 * tan(tilt) * G * BELOW_BAR_T_M / BETWEEN_HOOKS_M


@pytest.mark.parametrize("hydrostatics", ["mesh", "linear"])
def test_the_list_under_a_tandem_lift_agrees_with_statics(hydrostatics: str) -> None:
    """Source: Barrass & Derrett, *Ship Stability*, wall-sided formula; theory.md, linear hydrostatics. Both
    are exact for a box with the load at the tips; the equilibrium leaves 1e-12 (measured)."""
    rest = kingpost.equilibrium(FILE, hydrostatics=hydrostatics)
    found = -float(rest.kingpost["hull.roll"])
    assert found == pytest.approx(list_by_hand(hydrostatics), rel=1e-9)
    assert abs(np.degrees(found) - 2.80) < 0.01


@pytest.mark.parametrize("higher_m", [0.5, 1.0, 2.0])
def test_the_hook_loads_under_a_tilted_beam_differ_by_the_moment_of_what_hangs_below_it(
    higher_m: float,
) -> None:
    """Source: moments about the middle of the beam. The falls, 37 m, lean by 15 m (1 - cos t) / 37 m, which
    adds 2 F tan t times this angle; a tenth of that is for the length of the falls and terms of higher order.
    """
    rope = {"forces.aft_rope.rope.unstretched_length_m": LENGTH_M - FALLS * higher_m}
    rest = kingpost.equilibrium(FILE, rope)
    aft, forward = (float(load) for load in hook_loads_kn(rest))
    tilt = float(rest.kingpost["beam.pitch"])
    lean = 2 * (LOAD_KN / 2) * tan(tilt) * 15 * (1 - cos(tilt)) / 37
    assert aft - forward == pytest.approx(difference_by_hand_kn(tilt) + lean, abs=0.1 * lean)
    assert aft + forward == pytest.approx(LOAD_KN, rel=1e-6)


def test_a_beam_at_1_91_degrees_has_a_difference_of_36_3_kn() -> None:
    """Source: 2 tan(1.91 deg) g (300 x 5.5 + 20 x 0.75) / 30."""
    assert difference_by_hand_kn(1.91 * pi / 180) == pytest.approx(36.3, abs=0.05)


def test_the_hook_loads_while_one_crane_is_ahead_have_the_difference_by_hand_in_the_mean() -> None:
    """The beam swings after the winch stops: the mean of 10 s leaves 1e-3 of the difference (measured)."""
    run = kingpost.run(FILE, {"simulation.duration_s": 65}).sel(time=slice(55, 65))
    aft, forward = (float(np.mean(load)) for load in hook_loads_kn(run))
    tilt = float(np.mean(run.kingpost["beam.pitch"]))
    assert np.degrees(tilt) == pytest.approx(1.91, abs=0.005)
    assert aft - forward == pytest.approx(difference_by_hand_kn(tilt), rel=2e-3)

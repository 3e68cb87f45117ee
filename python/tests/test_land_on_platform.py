"""The landing of docs/checked: impact speeds agree with a direct search in the rows, and the interval of the
exceedance with the binomial distribution."""

from __future__ import annotations

from math import comb
from pathlib import Path

import kingpost
import numpy as np
import pytest
import xarray
from kingpost.analysis.extremes import one_off
from lanes import sampled
from scipy.optimize import brentq

FILE = Path(__file__).resolve().parents[2] / "docs" / "checked" / "land_on_platform.yaml"
DECK_M = 9.0
ROW_S = 0.01
CORNERS = [f"lift.{end}_{side}" for end in ("aft", "forward") for side in ("near", "far")]


def searched(run: xarray.Dataset) -> list[tuple[float, float]]:
    """Speed of the corner that reaches the deck first, in the row before each touch, and the column's."""
    deck = run.sel(contact="deck")
    touching = deck.contact_points.values > 0
    height = run.point_position.sel(point=CORNERS, axis="z").values - DECK_M
    speed = -run.point_velocity.sel(point=CORNERS, axis="z").values
    found = []
    for row in np.flatnonzero(touching[1:] & ~touching[:-1]):
        sinking = speed[row] > 0
        left_s = np.where(sinking, height[row] / np.where(sinking, speed[row], 1), np.inf)
        found.append((float(speed[row, np.argmin(left_s)]), float(deck.contact_impact_speed[row + 1])))
    return found


@pytest.mark.parametrize("seed", sampled(range(1, 21), keep=[7]))
def test_the_impact_speed_of_the_first_touch_is_found_by_a_search_in_the_rows(seed: int) -> None:
    """Source: rows of each step. A row is up to 10 ms before the touch, in which a load that hangs on its
    rope changes its speed by less than 1 m/s^2 times this."""
    fine = {"simulation.record_every_s": ROW_S, "simulation.duration_s": 44, "simulation.seed": seed}
    touches = searched(kingpost.run(FILE, fine))
    assert touches
    by_search, by_column = touches[0]
    assert by_search == pytest.approx(by_column, abs=1.0 * ROW_S)


@pytest.mark.parametrize("above", [0, 1, 2, 20])
def test_the_interval_of_an_exceedance_is_that_of_the_binomial_distribution(above: int) -> None:
    """Source: Clopper & Pearson, Biometrika 26, 1934: tails of 5 %, by sums of the distribution."""

    def at_most(n: int, p: float) -> float:
        return sum(comb(20, k) * p**k * (1 - p) ** (20 - k) for k in range(n + 1))

    sample = one_off([0.4] * (20 - above) + [0.6] * above)
    low = brentq(lambda p: 1 - at_most(above - 1, p) - 0.05, 0, 1, xtol=1e-14) if above else 0.0
    high = brentq(lambda p: at_most(above, p) - 0.05, 0, 1, xtol=1e-14) if above < 20 else 1.0
    assert sample.exceedance_interval(0.5) == pytest.approx((low, high), abs=1e-9)

"""Screening of a study: single cases, the limiting sea, axes of every kind."""

from __future__ import annotations

import kingpost
import numpy as np
import pytest
from kingpost.analysis.spectral import exceedance, spectral_response
from kingpost.study.screening.limiting_height import limiting_height
from kingpost.study.screening.screen import screen

HELD = {"bodies.pedestal.joint.revolute.mode": "held", "waves": True}
LIMITS = {
    "roll": {"column": "hull.roll", "within": 3, "unit": "deg"},
    "rod": {"column": "pendant.joint_reaction.force_z", "at_most": 255, "unit": "kN"},
}
AXES = {
    "rope_length_m": [15.0, 20.0],
    "significant_height_m": [1.0, 2.0, 3.0],
    "peak_period_s": [8.0, 12.0],
    "wave_direction_deg": [120.0, 180.0],
}


@pytest.fixture(scope="module")
def found():
    return screen("offshore_vessel", AXES, ["hull.position.z"], LIMITS, overrides=HELD)


@pytest.mark.parametrize("case", [(20.0, 2.0, 12.0, 120.0), (15.0, 3.0, 8.0, 180.0)])
def test_a_case_is_the_spectral_response_of_its_scenario(found, case) -> None:
    """Source: one scenario by itself, whose frequencies lie elsewhere: to what the integrals' steps leave."""
    at = dict(zip(AXES, case, strict=True))
    alone = spectral_response(
        "offshore_vessel", ["hull.position.z"], overrides=HELD | at | {"limits": LIMITS}
    )
    here = found.sel(at)
    for name in ("mean", "standard_deviation", "zero_up_crossing_period"):
        for column in alone.column.values:
            expected = float(alone[name].sel(column=column))
            if abs(expected) > 1e-9:
                assert float(here[name].sel(column=column)) == pytest.approx(expected, rel=2e-4), (
                    name,
                    column,
                )
    assert here.probability.values == pytest.approx(alone.probability.values, rel=0.02, abs=1e-9)


def test_standard_deviations_are_proportional_to_the_height(found) -> None:
    """Source: a JONSWAP sea of the same period."""
    first = found.standard_deviation.sel(significant_height_m=1.0)
    for height in (2.0, 3.0):
        assert np.allclose(
            found.standard_deviation.sel(significant_height_m=height), height * first, rtol=1e-9
        )


def test_at_the_limiting_height_the_limit_is_exceeded_as_accepted(found) -> None:
    """Source: the spectral response of the scenario in that very sea."""
    at = {"rope_length_m": 20.0, "peak_period_s": 12.0, "wave_direction_deg": 120.0}
    for name in LIMITS:
        height = float(found.limiting_height.sel(at).sel(limit=name))
        overrides = HELD | at | {"significant_height_m": height, "limits": {name: LIMITS[name]}}
        alone = spectral_response("offshore_vessel", [], overrides=overrides)
        assert float(alone.probability[0]) == pytest.approx(0.1, rel=0.02), name
    smallest = found.limiting_height.min("limit")
    assert np.array_equal(found.limiting_height_of_all, smallest)
    governs = found.governs.sel(at).item()
    assert float(found.limiting_height.sel(at).sel(limit=governs)) == float(smallest.sel(at))


def test_a_roll_limit_of_a_symmetric_ship_is_never_reached_in_head_seas(found) -> None:
    """Source: symmetry."""
    ahead = found.limiting_height.sel(wave_direction_deg=180.0, limit="roll")
    assert (ahead.values > 1e3).all()


def test_a_constant_swell_lowers_the_limiting_height_of_the_wind_sea() -> None:
    """Source: variances add: of the wind sea what the swell leaves."""
    swell = {"jonswap": {"significant_height_m": 0.5, "peak_period_s": 14, "direction_deg": 120}}
    axes = {"significant_height_m": [1.0, 2.0]}
    limits = {"roll": LIMITS["roll"]}
    with_swell = screen("offshore_vessel", axes, (), limits,
                        overrides=HELD | {"sea.waves.swell": swell, "wave_direction_deg": 120})  # fmt: skip
    height = float(with_swell.limiting_height.squeeze())
    overrides = HELD | {"sea.waves.swell": swell, "wave_direction_deg": 120, "significant_height_m": height}
    alone = spectral_response("offshore_vessel", [], overrides=overrides | {"limits": limits})
    assert float(alone.probability[0]) == pytest.approx(0.1, rel=0.02)
    without = screen("offshore_vessel", axes, (), limits, overrides=HELD | {"wave_direction_deg": 120})
    assert height < float(without.limiting_height.squeeze())


def test_values_that_are_drawn_together_are_one_axis() -> None:
    together = {"significant_height_m, peak_period_s": [[1.0, 8.0], [2.0, 10.0], [3.0, 12.0]]}
    found = screen("offshore_vessel", together, ["hull.pitch"], overrides=HELD)
    assert found.standard_deviation.sizes == {"significant_height_m, peak_period_s": 3, "column": 1}
    apart = {"significant_height_m": [2.0], "peak_period_s": [10.0]}
    product = screen("offshore_vessel", apart, ["hull.pitch"], overrides=HELD)
    # Beside other periods the grid has other frequencies.
    assert found.standard_deviation[1, 0].item() == pytest.approx(product.standard_deviation.item(), rel=2e-4)


def test_a_variance_of_another_form_gives_an_interpolated_height() -> None:
    """Source: a deviation of Hs^1.5 / 4 and a limit of 3: where Rice's probability is 0.1."""
    heights = np.linspace(1.0, 3.0, 41)
    m0 = (heights**1.5 / 4) ** 2
    found = limiting_height(heights, (None, 3.0), 0 * m0, m0, m0, 1800.0, 0.1)
    sigma = found**1.5 / 4
    assert float(exceedance((None, 3.0), 0.0, sigma, 2 * np.pi, 1800.0)) == pytest.approx(0.1, rel=0.01)
    beyond = limiting_height(heights, (None, 30.0), 0 * m0, m0, m0, 1800.0, 0.1)
    assert np.isnan(beyond), "no height of the study reaches it"


def test_the_limiting_height_is_0_for_a_limit_reached_without_waves_and_infinite_for_one_out_of_reach() -> (
    None
):
    heights, m0 = np.array([1.0, 2.0]), np.array([0.04, 0.16])
    assert limiting_height(heights, (None, 1.0), np.full(2, 1.5), m0, m0, 1800.0, 0.1) == 0.0
    still = 0 * m0
    assert limiting_height(heights, (None, 1.0), still, still, still, 1800.0, 0.1) == np.inf


def test_a_limit_without_linear_response_is_not_screened_and_has_a_reason() -> None:
    limits = {"energy": {"column": "kinetic_energy", "at_most": 1e6}, "roll": LIMITS["roll"]}
    found = screen("offshore_vessel", {"significant_height_m": [1.0, 2.0]}, (), limits, overrides=HELD)
    assert "square of motions" in found.reason.sel(column="kinetic_energy").item()
    assert np.isnan(found.limiting_height.sel(limit="energy"))
    assert found.governs.item() in ("roll", "")


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"operation_s": 0.0}, "operation_s: found 0, allowed: finite and greater than 0"),
        ({"acceptance": 1.0}, "acceptance: found 1, allowed: between 0 and 1"),
        ({"axes": {"peak_period_s": []}}, "axes: found no values of peak_period_s, allowed: one or more"),
        ({"height": "hs"}, "height: found 'hs', allowed: significant_height_m"),
        ({"overrides": {}}, "sea.waves: found a case without any, allowed"),
        ({"columns": ["hull.rol"]}, "columns: found 'hull.rol', allowed"),
    ],
)
def test_a_study_that_cannot_be_screened_is_refused(change, message) -> None:
    given = {"axes": {"significant_height_m": [1.0]}, "columns": ["hull.roll"], "overrides": HELD} | change
    with pytest.raises(kingpost.KingpostError, match=message):
        screen("offshore_vessel", **given)

"""Numbers that seem to be in another unit are reported with their place."""

from __future__ import annotations

from pathlib import Path

import kingpost
import pytest
from kingpost.errors import ScenarioError

LINE = """version: 1
title: A line
simulation: {{step_s: 0.05, duration_s: 0.1}}
bodies:
  buoy:
    mass_kg: 1000
    shape: {{box: {{length_m: 2, width_m: 2, height_m: 1}}}}
    joint: {{floating: {{initial: {{position_m: [0, 0, 0]}}, hold_translation: true, hold_rotation: true}}}}
forces:
  gravity: {{gravity: {{}}}}
  chain:
    catenary_line:
      fairlead: {{body: buoy, position_m: [0, 0, 0]}}
      anchor_m: [400, 0, -50]
      unstretched_length_m: {length_m}
      weight_in_water_N_per_m: {weight}
      axial_stiffness_N: {stiffness}
"""
WIND_SEA = "sea.waves.wind_sea.jonswap"


def warnings_of(overrides: dict[str, object], name: str = "offshore_vessel") -> list[str]:
    return kingpost.load(name, overrides).model["warnings"]


@pytest.mark.parametrize(
    ("name", "overrides", "words"),
    [
        (
            "barge",
            {"bodies.ship.inertia": {"radii_of_gyration": {"radii_m": [3500, 6000, 6000]}}},
            "is it in mm",
        ),
        (
            "barge",
            {"bodies.ship.joint.floating.initial.orientation_rad": [0, 0, 90]},
            "90 is outside of one turn",
        ),
        (
            "offshore_vessel",
            {f"{WIND_SEA}.significant_height_m": 25, f"{WIND_SEA}.peak_period_s": 20},
            "is it in cm or feet",
        ),
    ],
)
def test_a_number_outside_the_range_of_ships_and_seas_gives_a_warning(
    name: str, overrides: dict[str, object], words: str
) -> None:
    settled = overrides | {"simulation.begin_at_equilibrium": False, "waves": True}
    assert any(words in one for one in warnings_of(settled, name)), warnings_of(settled, name)
    assert not any(words in one for one in warnings_of({}, name))


@pytest.mark.parametrize(
    ("length_m", "weight", "stiffness"), [(300, 3323, 1.674e9), (410, 3323, 1674.0), (410, 3323e3, 1.674e9)]
)
def test_a_line_stretched_beyond_breaking_is_refused(
    length_m: float, weight: float, stiffness: float, tmp_path: Path
) -> None:
    """Source: steel parts at a few percent, polyester at 12 %."""
    path = tmp_path / "line.yaml"
    path.write_text(LINE.format(length_m=length_m, weight=weight, stiffness=stiffness), encoding="utf-8")
    with pytest.raises(
        ScenarioError, match=r"unstretched_length_m: found .* a strain of .* allowed: a strain of 0.1"
    ):
        kingpost.load(path)


@pytest.mark.parametrize("line", ["\u00a0 \u00a0 mass_t: 410", "    \u2007mass_t: 410"])
def test_a_non_ascii_blank_is_named_with_its_place(line: str, tmp_path: Path) -> None:
    """Source: text that was copied from a web page or a word processor."""
    path = tmp_path / "a.yaml"
    path.write_text(f"version: 1\ntitle: t\nbodies:\n  hull:\n{line}\n", encoding="utf-8")
    with pytest.raises(
        ScenarioError, match=r"a.yaml:5:\d+: .*found a (no-break space|blank) \(U\+(00A0|2007)\)"
    ):
        kingpost.load(path)

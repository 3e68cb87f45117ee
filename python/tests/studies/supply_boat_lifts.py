"""Lifts off a supply boat in twenty seas, written to a file.

python python/tests/studies/supply_boat_lifts.py -o python/tests/studies/supply_boat_lifts.json
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path
from typing import Any

import kingpost
import numpy as np
import xarray
from kingpost.analysis import lift_rules

COMMAND = "python python/tests/studies/supply_boat_lifts.py -o python/tests/studies/supply_boat_lifts.json"
SCENARIO = "supply_boat_lift"
SEEDS = 20
FULLY_GROWN_S = 20.0
"""Time at which the waves are fully grown, s; the lift begins 20 s later."""
SNAP_S = 3.0
"""Time after the rope becomes taut within which the peak tension is the snap load, s."""
HOOK_M_PER_RAD = 0.15
"""Height of the hook per radian of the drum, m/rad: 0.6 m of rope on four falls."""
FINE = {"simulation.record_every_s": 0.02}
"""Recording interval with which a peak between two rows is within 1 % of a row: load and rope oscillate in
0.5 s."""


def lifts(winch_rate_rad_s: float, seeds: list[int]) -> xarray.Dataset:
    """Runs of the gallery's scenario in these seas, with this largest rate of the winch."""
    scenario = kingpost.load(SCENARIO, FINE, winch_rate_rad_s=winch_rate_rad_s)
    return kingpost.Batch(scenario, {"simulation.seed": seeds}).run()


def readings(run: xarray.Dataset) -> dict[str, float]:
    """Snap load and dynamic factor of the hook load in one lift, number of contacts with the deck after
    lift-off, and lead angle of the rope at the first lift-off."""
    time = run["time"].values
    tension = run["rope_tension"].sel(rope="hoist_rope").values
    static = _weight(run) / 4
    touching = run["contact_points"].sel(contact="cargo_deck").values > 0
    taut = int(np.argmax(tension > 0.01 * static))
    snap = tension[(time >= time[taut]) & (time <= time[taut] + SNAP_S)].max()
    left = taut + int(np.argmax(~touching[taut:]))
    again = touching[left:]
    lead = (run["point_position"].sel(point="lift.hook") - run["point_position"].sel(point="boom.tip")).values
    return {
        "snap": snap / static,
        "hook_daf": tension.max() / static,
        "times_back_on_deck": int((again[1:] & ~again[:-1]).sum()),
        "offlead_m": abs(lead[left, 1]),
        "sidelead_m": abs(lead[left, 0]),
    }


def _weight(run: xarray.Dataset) -> float:
    resolved = json.loads(run.attrs["scenario"])
    return (
        resolved["bodies"]["lift"]["mass_kg"] * resolved["forces"]["gravity"]["gravity"]["acceleration_m_s2"]
    )


def speeds_before(runs: xarray.Dataset) -> dict[str, float]:
    """Significant vertical speeds (twice the standard deviation) of the deck under the load and of the
    crane's tip, m/s, over all runs, from fully grown waves to the start of the lift."""
    before = runs.sel(time=slice(FULLY_GROWN_S, 2 * FULLY_GROWN_S))
    deck = before["velocity"].sel(body="lift", axis="z")
    tip = before["point_velocity"].sel(point="boom.tip", axis="z")
    return {"deck_m_s": 2 * float(deck.std()), "tip_m_s": 2 * float(tip.std())}


def study() -> dict[str, Any]:
    seeds = list(range(1, SEEDS + 1))
    height = kingpost.load(SCENARIO).resolved["sea"]["waves"]["wind_sea"]["jonswap"]["significant_height_m"]
    fast = lifts(3.0, seeds)
    speeds = speeds_before(fast)
    asked = lift_rules.hoisting_speed_m_s(height, speeds["tip_m_s"], lift_rules.SEVERAL_FALLS)
    slow_rate = round(asked / HOOK_M_PER_RAD, 2)
    found = {
        f"{3.0 * HOOK_M_PER_RAD:.2f}": fast,
        f"{slow_rate * HOOK_M_PER_RAD:.2f}": lifts(slow_rate, seeds),
    }
    return {
        "command": COMMAND,
        "significant_speeds_before": rounded(speeds),
        "rule": rounded(
            {
                "deck_m_s": lift_rules.deck_speed_m_s(height),
                "hoisting_m_s": asked,
                "offlead_m": lift_rules.offlead_m(height),
                "sidelead_m": lift_rules.sidelead_m(height),
            }
        ),
        "lifts": {
            hook: {
                "winch_rate_rad_s": slow_rate if runs is not fast else 3.0,
                "seeds": [rounded(readings(runs.isel(run=place))) for place in range(SEEDS)],
            }
            for hook, runs in found.items()
        },
    }


def rounded(numbers: dict[str, float]) -> dict[str, float]:
    return {
        name: value if isinstance(value, int) else float(f"{value:.6g}") for name, value in numbers.items()
    }


def text(found: dict[str, Any]) -> str:
    """As JSON, a lift a line."""
    lines = json.dumps(found, indent=1)
    for runs in found["lifts"].values():
        for one in runs["seeds"]:
            lines = lines.replace(json.dumps(one, indent=1).replace("\n", "\n    "), json.dumps(one), 1)
    return lines + "\n"


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("-o", "--output", type=Path, required=True)
    parser.parse_args().output.write_text(text(study()), encoding="utf-8")

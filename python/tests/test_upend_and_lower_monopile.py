"""The monopile of docs/checked: hook loads about its hinge, its release, and its weight in a gripper."""

from __future__ import annotations

from math import cos, radians, sin, sqrt
from pathlib import Path
from typing import Any

import kingpost
import numpy as np
import pytest
import xarray
from lanes import sampled

FILE = Path(__file__).resolve().parents[2] / "docs" / "checked" / "upend_and_lower_monopile.yaml"
WEIGHT_KN = 900 * 9.80665
LENGTH_M, TIP_M, FALLS = 60.0, 80.0, 12
BUOYANCY_KN_M = 1.025 * 9.80665 * 114.65 / LENGTH_M
DRUM_TO_TIP_M = 110.614
HINGE_M = np.array([-52.0, 0.0, 4.0])
"""Of the barge on even keel, in the world."""


class ColumnsOf:
    """Columns of a run by name."""

    def __init__(self, run: xarray.Dataset) -> None:
        self._run = run.kingpost

    def __getitem__(self, name: str) -> np.ndarray:
        return np.asarray(self._run[name])


def lying_at(elevation_deg: float) -> dict[str, Any]:
    """Overrides that put the pile at an elevation, with the falls as long as the way to its head."""
    angle = radians(elevation_deg)
    centre = HINGE_M + 0.5 * LENGTH_M * np.array([cos(angle), 0, sin(angle)])
    way = sqrt(LENGTH_M**2 + TIP_M**2 - 2 * LENGTH_M * TIP_M * sin(angle))
    begins = "bodies.pile.joint.floating.initial"
    path = DRUM_TO_TIP_M + FALLS * way
    stretch = WEIGHT_KN * way / (2 * TIP_M) / FALLS * (1 / 600 + path / 200_000)
    return {
        f"{begins}.position_m": centre.tolist(),
        f"{begins}.orientation_rad": [0, radians(90 - elevation_deg), 0],
        "forces.hoist_rope.rope.unstretched_length_m": path - stretch,
    }


@pytest.mark.parametrize("elevation_deg", [15, 30, 45, 60, 75, 88])
def test_the_hook_load_while_the_pile_is_upended_is_that_of_moments_about_its_hinge(
    elevation_deg: float,
) -> None:
    """Source: moments about the hinge, W 30 m cos(a - trim) = F 60 m x 80 m cos a / d, with the elevation a
    in axes of the barge and d from tip to head. The equilibrium leaves 1e-6 of the load (measured)."""
    rest = kingpost.equilibrium(FILE, lying_at(elevation_deg)).kingpost
    trim = float(rest["hull.pitch"])
    a = np.pi / 2 - float(rest["pile.pitch"]) + trim
    d = sqrt(LENGTH_M**2 + TIP_M**2 - 2 * LENGTH_M * TIP_M * sin(a))
    by_hand = WEIGHT_KN * d / (2 * TIP_M) * cos(a - trim) / cos(a)
    assert abs(np.degrees(a) - elevation_deg) < 1.5
    assert FALLS * float(rest["hoist_rope.rope_tension"]) / 1e3 == pytest.approx(by_hand, rel=1e-5)


def test_one_run_upends_lets_go_grips_and_lowers() -> None:
    """Source: moments about the hinge, and the weight less that of the displaced water. The winch turns the
    pile, so its damper adds 0.3 % from 15 to 75 degrees."""
    run = kingpost.run(FILE)
    columns = ColumnsOf(run)
    hook_kn = FALLS * columns["hoist_rope.rope_tension"] / 1e3
    trim = columns["hull.pitch"]
    a = np.pi / 2 - columns["pile.pitch"] + trim
    d = np.sqrt(LENGTH_M**2 + TIP_M**2 - 2 * LENGTH_M * TIP_M * np.sin(a))
    by_hand = WEIGHT_KN * d / (2 * TIP_M) * np.cos(a - trim) / np.cos(a)
    upended = (columns["hinge.connection_engaged"] > 0.5) & (a > radians(15)) & (a < radians(75))
    assert np.abs(hook_kn / by_hand - 1)[upended].max() < 3e-3
    # The hinge lets go of at most 100 kN, which the hook takes: at most twice of it, on an undamped spring.
    gripped = columns["gripper.connection_engaged"] > 0.5
    hangs = (columns["hinge.connection_engaged"] < 0.5) & ~gripped
    assert np.abs(hook_kn - WEIGHT_KN)[hangs].max() < 100
    # At rest at the end, upright to 0.1 degrees: 2e-6 of the immersed length. The gripper is smooth.
    immersed_m = LENGTH_M / 2 - columns["pile.position.z"][-1]
    assert immersed_m > 35
    assert hook_kn[-1] == pytest.approx(WEIGHT_KN - BUOYANCY_KN_M * immersed_m, rel=1e-5)
    assert columns["gripper.connection_angle"][gripped].max() < radians(1)
    scale = np.abs(columns["energy_scale"]).max()
    assert np.abs(columns["energy_error"]).max() < 1e-6 * scale


@pytest.mark.parametrize("seed", sampled(range(20), keep=[3]))
def test_the_hinge_lets_go_in_waves_and_energy_is_kept(seed: int) -> None:
    """Source: conservation. The pile stands upright, its weight on hook and hinge, in waves of 0.75 m, and
    the hinge lets go of its reaction at that time, without an impulse."""
    take = {"input": "hoist", "to": -1, "in_s": 18}
    upright = lying_at(89.9) | {
        "waves": True,
        "simulation.duration_s": 26,
        "operation.steps": [
            {"name": "take the weight", "set": [take], "until": {"after_s": 20}},
            {"name": "let go", "set": [{"input": "hinge", "to": 1}]},
        ],
    }
    columns = ColumnsOf(kingpost.run(FILE, upright | {"simulation.seed": seed}))
    held = columns["hinge.connection_engaged"] > 0.5
    reaction = columns["hinge.connection_reaction.force_z"]
    assert reaction[held][-1] > 1e5
    assert np.all(reaction[~held] == 0)
    # Hook and hinge carry the weight together, but for the heave of the barge: 0.05 m/s2 in these waves.
    both_kn = (FALLS * columns["hoist_rope.rope_tension"] + reaction) / 1e3
    assert np.abs(both_kn / WEIGHT_KN - 1)[held].max() < 0.02
    # rk4: 0.2 rad of the bounce on the hook in a step leave 2e-6 (measured).
    assert np.abs(columns["energy_error"]).max() < 5e-6 * np.abs(columns["energy_scale"]).max()


def test_derivatives_of_the_equilibrium_on_hinge_and_hook_are_those_of_differences() -> None:
    """Source: central differences over 1 mm, whose rounding leaves 1e-8 of the largest (measured)."""
    where = "loops.hinge.second.position_m.2"
    short = {"simulation.duration_s": 0.2, "simulation.record_every_s": 0.2}

    def at(by_m: float) -> dict[str, Any]:
        return short | {where: -30 + by_m}

    found = kingpost.gradient(kingpost.load(FILE, at(0)), [where])
    ahead, behind = (kingpost.run(FILE, at(by_m)) for by_m in (1e-3, -1e-3))
    for name in ("rope_tension", "connection_reaction", "position", "pitch"):
        differences = (ahead[name].values[-1] - behind[name].values[-1]) / 2e-3
        exact = found[f"{name}_derivative"].values[0][-1]
        assert np.abs(exact - differences).max() < 1e-7 * np.abs(differences).max(), name

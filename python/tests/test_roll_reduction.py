"""Gyros compared with closed forms, and the scenarios of roll reduction from a user's view."""

from __future__ import annotations

import json
from typing import Any

import kingpost
import numpy as np
import pytest
from kingpost.verify.control import roll
from lanes import sampled

SPIN, ROLL_RATE = 100.0, 0.05
AXIAL = 2.0e4
"""Moment of inertia of a wheel about its axis, kg m^2."""


def gyro(side: str, y_m: float, spin: float, mode: Any) -> dict[str, Any]:
    def hinge(axis: list[int], position: list[float], mode: Any) -> dict[str, Any]:
        place = {"axis": axis, "position_m": position, "child_position_m": [0, 0, 0]}
        return {"revolute": place | {"mode": mode, "name": f"hinge_{side}_{axis.index(1)}"}}

    gimbal = {
        "parent": "ship",
        "mass_kg": 5000,
        "inertia": {"tensor": {"moments_kg_m2": [4000, 4000, 6000]}},
        "joint": hinge([0, 1, 0], [0, y_m, 1], mode),
    }
    wheel = {
        "parent": f"gimbal_{side}",
        "mass_kg": 20000,
        "inertia": {"tensor": {"moments_kg_m2": [12000, 12000, AXIAL]}},
        "joint": hinge([0, 0, 1], [0, 0, 0], {"prescribed": {"rate_rad_s": spin}}),
    }
    return {f"gimbal_{side}": gimbal, f"wheel_{side}": wheel}


def rolling(bodies: dict[str, Any]) -> kingpost.Scenario:
    """A ship that rolls at a given rate about an axis through its centre, without weight."""
    joint = {"axis": [1, 0, 0], "position_m": [0, 0, 0], "child_position_m": [0, 0, 0]}
    ship = {
        "parent": "world",
        "mass_kg": 4e6,
        "inertia": {"tensor": {"moments_kg_m2": [2e8, 9e8, 9e8]}},
        "joint": {"revolute": joint | {"mode": {"prescribed": {"rate_rad_s": ROLL_RATE}}}},
    }
    settings = {"step_s": 0.005, "duration_s": 1, "record_every_s": 0.1}
    tree = {"version": 1, "title": "Gyros", "simulation": settings, "bodies": {"ship": ship} | bodies}
    return kingpost.Scenario(json.dumps(tree), "gyros.json")


def test_a_held_gimbal_of_a_rolling_ship_carries_the_torque_of_momentum_times_rate():
    ds = kingpost.run(rolling(gyro("port", 0.0, SPIN, "held")))
    found = np.abs(ds.kingpost["hinge_port_1.joint_reaction.moment_y"].values)
    # The wheel's two transverse moments are equal: no other torque about this axis. Round-off.
    assert np.allclose(found, AXIAL * SPIN * ROLL_RATE, rtol=1e-9)


def test_a_pair_that_spins_and_precesses_in_opposite_directions_leaves_no_moment_in_pitch_and_yaw():
    pair = gyro("port", 2.0, SPIN, "free") | gyro("starboard", -2.0, -SPIN, "free")
    ds = kingpost.run(rolling(pair)).kingpost
    precession = [ds[f"hinge_{side}_1.joint_position"].values for side in ("port", "starboard")]
    assert np.allclose(precession[0], -precession[1], atol=1e-9)
    assert np.abs(precession[0]).max() > 0.05
    one = AXIAL * SPIN * ROLL_RATE
    for axis in "yz":
        assert np.abs(ds[f"ship.joint_reaction.moment_{axis}"].values).max() < 1e-6 * one


@pytest.mark.parametrize(
    "device", sampled(["U-tank", "open tanks, pumped", "gyros, driven"], keep=["U-tank"])
)
def test_a_device_is_measured_and_printed_with_its_remaining_share_of_roll(device: str):
    row = roll.measure("Hs 2.0 m, Tp 11.5 s", device, without_deg=1.0, length_s=2.0)
    assert row.left is not None
    assert device in roll.text([row])

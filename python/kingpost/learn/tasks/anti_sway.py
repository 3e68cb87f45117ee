"""Move a load to a target and stop its swing there."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ...scenario import Scenario, load
from ..task import Columns, Goal, Observation, Task

SCENARIOS = Path(__file__).parents[1] / "scenarios"
BOOM_M = 30.0
"""Length of the boom in the scenario of `anti_sway`."""
ROPE_AT_REST = np.pi / 4
"""Angle from the boom, at 45 degrees, to the rope at the start of `anti_sway`, rad."""


def _distance(columns: Columns, goal: Goal) -> np.ndarray:
    """Horizontal distance of the load from its target, m."""
    x, y = columns["load.position.x"] - goal[:, 2], columns["load.position.y"] - goal[:, 3]
    return np.sqrt(x * x + y * y)


def _swing_along(columns: Columns, goal: Goal) -> np.ndarray:
    """Angle of the rope from the vertical in the boom's plane, rad; positive: hook nearer to the crane."""
    return columns["luff.joint_position"] + columns["pendant.second.joint_position"] + ROPE_AT_REST


def _anti_sway_reward(columns: Columns, goal: Goal, actions: np.ndarray) -> np.ndarray:
    away = _distance(columns, goal)
    x, y = columns["load.velocity.x"], columns["load.velocity.y"]
    speed = np.sqrt(x * x + y * y)
    near = 1.0 / (1.0 + away * away / 4.0)
    return -0.05 * (away / 10.0 + near * speed)


def _anti_sway_goal(random: np.random.Generator, start: Mapping[str, float]) -> Sequence[float]:
    """Slew and luff of the target, rad, and its place, m."""
    slew = float(random.uniform(np.pi / 9, np.pi / 2)) * (1.0 if random.random() < 0.5 else -1.0)
    return target(slew, float(random.uniform(-np.pi / 3, -np.pi / 6)))


def target(slew: float, luff: float) -> list[float]:
    """The goal of these angles, rad, with its place, m.

    >>> target(0.0, 0.0)
    [0.0, 0.0, 30.0, 0.0]
    """
    radius = BOOM_M * float(np.cos(luff))
    return [slew, luff, radius * float(np.cos(slew)), radius * float(np.sin(slew))]


def _swaying(field: str, amplitude: float, period_s: float, phase_deg: float) -> dict[str, Any]:
    return {
        "oscillation": {field: amplitude, "period_s": period_s, "phase_deg": phase_deg, "ramp_s": period_s}
    }


def _on_a_ship() -> Scenario:
    """The crane on a base that heaves, pitches and rolls as a ship in a swell, whatever the crane does."""

    def carrier(parent: str, joint: dict[str, Any]) -> dict[str, Any]:
        return {"parent": parent, "mass_t": 1, "shape": {"sphere": {"radius_m": 0.5}}, "joint": joint}

    heave = {"axis": [0, 0, 1], "mode": _swaying("amplitude_m", 0.5, 8.0, 0.0)}
    pitch = {"axis": [0, 1, 0], "mode": _swaying("amplitude_deg", 1.0, 8.0, 90.0)}
    roll = {"axis": [1, 0, 0], "mode": _swaying("amplitude_deg", 2.0, 11.0, 0.0)}
    return load(
        SCENARIOS / "anti_sway.yaml",
        {
            "bodies.heave": carrier("world", {"prismatic": heave}),
            "bodies.pitch": carrier("heave", {"revolute": pitch}),
            "bodies.roll": carrier("pitch", {"revolute": roll}),
            "bodies.pedestal.parent": "roll",
        },
    )


def anti_sway(randomised: bool = False, on_a_ship: bool = False) -> Task:
    """Move a load by slewing and luffing to a target, and stop its swing there.

    The crane of four bodies stands on a fixed base; hook and load are a double pendulum. Each episode draws a
    target: 20 to 90 degrees of slew to either side, 30 to 60 degrees of boom. With the distance d and speed
    v of the load over the ground, a control step of 50 ms gives
    ``-0.05 (d / 10 m + v / (1 m/s) / (1 + d^2 / 4 m^2))``.

    Parameters
    ----------
    randomised
        Whether each episode also draws the load, 5 to 35 t, and the rope, 8 to 22 m.
    on_a_ship
        Whether the base moves as a ship in a swell, by a given motion: 0.5 m of heave and 1 degree of pitch
        in 8 s, 2 degrees of roll in 11 s. The target stays in the world.

    Returns
    -------
    Task
        Two actions, slewing and luffing speed; 12 observations.

    >>> anti_sway().action_names
    ('slewing', 'luffing')
    """
    joints = ("pendant.first", "pendant.second", "sling.first", "sling.second")
    observations = [
        Observation(
            "slew_error", 0.5, "rad", lambda columns, goal: columns["slew.joint_position"] - goal[:, 0]
        ),
        Observation(
            "luff_error", 0.5, "rad", lambda columns, goal: columns["luff.joint_position"] - goal[:, 1]
        ),
        Observation("slew.joint_velocity", 0.1),
        Observation("luff.joint_velocity", 0.05),
        Observation(
            "swing_across", 0.1, "rad", lambda columns, goal: columns["pendant.first.joint_position"]
        ),
        Observation("swing_along", 0.1, "rad", _swing_along),
        *(Observation(f"{joint}.joint_position", 0.1) for joint in joints[2:]),
        *(Observation(f"{joint}.joint_velocity", 0.1) for joint in joints),
    ]
    over_ground = [f"load.{what}.{axis}" for what in ("position", "velocity") for axis in "xy"]
    return Task(
        _on_a_ship() if on_a_ship else SCENARIOS / "anti_sway.yaml",
        ["slewing", "luffing"],
        observations,
        _anti_sway_reward,
        columns=[
            "slew.joint_position",
            "luff.joint_position",
            *(f"{joint}.joint_position" for joint in joints[:2]),
            *over_ground,
        ],
        goal=_anti_sway_goal,
        randomised={"load_t": (5.0, 35.0), "pendant_length_m": (8.0, 22.0)} if randomised else {},
    )

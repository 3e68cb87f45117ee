"""Move a load to a target and stop its swing there."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from ...errors import KingpostError
from ..task import Columns, Goal, Observation, Task

SCENARIOS = Path(__file__).parents[1] / "scenarios"
BOOM_M = 30.0
"""Length of the boom in the scenario of `anti_sway`."""
ROPE_AT_REST = np.pi / 4
"""Angle from the boom to the rope at the start of `anti_sway`, with the boom at 45 degrees, rad."""


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
    """Slewing and luffing angle of the target, rad, and its position, m."""
    slew = float(random.uniform(np.pi / 9, np.pi / 2)) * (1.0 if random.random() < 0.5 else -1.0)
    return target(slew, float(random.uniform(-np.pi / 3, -np.pi / 6)))


def target(slew: float, luff: float) -> list[float]:
    """Goal for these slewing and luffing angles, rad, with the target's position, m.

    >>> target(0.0, 0.0)
    [0.0, 0.0, 30.0, 0.0]
    """
    radius = BOOM_M * float(np.cos(luff))
    return [slew, luff, radius * float(np.cos(slew)), radius * float(np.sin(slew))]


def anti_sway(randomised: bool = False, on_a_ship: bool = False, at_sea: bool = False) -> Task:
    """Move a load by slewing and luffing to a target, and stop its swing there.

    The crane of four bodies stands on a fixed base; hook and load are a double pendulum. Each episode draws a
    target: 20 to 90 degrees of slew to either side, 30 to 60 degrees of boom. With the load's distance d from
    the target and its speed v over the ground, the reward of a control step of 50 ms is ``-0.05 (d / 10 m + v
    / (1 m/s) / (1 + d^2 / 4 m^2))``.

    Parameters
    ----------
    randomised
        Whether each episode also draws the load, 5 to 35 t, and the rope, 8 to 22 m.
    on_a_ship
        Whether the base moves as a ship in a swell, by a given motion: 0.5 m of heave and 1 degree of pitch
        in 8 s, 2 degrees of roll in 11 s. The target is fixed in the world.
    at_sea
        Whether the crane stands on a ship that floats in a sea, the same in each episode: significant wave
        height 1.5 m, peak period 8 s, from 30 degrees off the bow. Ship and load interact. The target is
        fixed in the world.

    Returns
    -------
    Task
        Two actions, slewing and luffing speed; 12 observations.

    Raises
    ------
    KingpostError
        If both `on_a_ship` and `at_sea` are given.

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
    if on_a_ship and at_sea:
        raise KingpostError("on_a_ship, at_sea: found both, allowed: at most one")
    base = "anti_sway_on_a_ship" if on_a_ship else "anti_sway_at_sea" if at_sea else "anti_sway"
    over_ground = [f"load.{what}.{axis}" for what in ("position", "velocity") for axis in "xy"]
    return Task(
        SCENARIOS / f"{base}.yaml",
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

"""Task: hold a load at a point fixed in the world, from a ship in waves."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ...scenario import load
from ..task import Columns, Goal, Observation, Task

CONTROLLER = "controllers.compensation.three_axis_compensation.enabled"
TIP = [f"boom.tip.point_position.{axis}" for axis in "xyz"]
TIP_VELOCITY = [f"boom.tip.point_velocity.{axis}" for axis in "xy"]
BOOM = [f"boom.position.{axis}" for axis in "xyz"]
LOAD = [f"lift.position.{axis}" for axis in "xyz"]

Vector = tuple[np.ndarray, np.ndarray]


def _outwards(columns: Columns) -> tuple[Vector, np.ndarray]:
    """The horizontal unit vector along the boom, and the reach from the slewing axis to the tip, m.

    The boom's own position is its middle.
    """
    x, y = columns[TIP[0]] - columns[BOOM[0]], columns[TIP[1]] - columns[BOOM[1]]
    half = np.sqrt(x * x + y * y)
    return (x / half, y / half), 2.0 * half


def _along(columns: Columns, vector: Vector) -> np.ndarray:
    (x, y), _ = _outwards(columns)
    return x * vector[0] + y * vector[1]


def _across(columns: Columns, vector: Vector) -> np.ndarray:
    """Component of a vector to the left of the boom, seen from above."""
    (x, y), _ = _outwards(columns)
    return x * vector[1] - y * vector[0]


def _tip_error(columns: Columns, goal: Goal) -> Vector:
    return columns[TIP[0]] - goal[:, 0], columns[TIP[1]] - goal[:, 1]


def _tip_velocity(columns: Columns) -> Vector:
    return columns[TIP_VELOCITY[0]], columns[TIP_VELOCITY[1]]


def _swing(columns: Columns) -> Vector:
    """Horizontal distance of the load from the tip."""
    return columns[LOAD[0]] - columns[TIP[0]], columns[LOAD[1]] - columns[TIP[1]]


def _reward(columns: Columns, goal: Goal, actions: np.ndarray) -> np.ndarray:
    x, y, z = (columns[name] - goal[:, 2 + k] for k, name in enumerate(LOAD))
    return -0.05 * np.sqrt(x * x + y * y + z * z)


def _goal(random: np.random.Generator, start: Mapping[str, float]) -> Sequence[float]:
    """Horizontal position of the tip and position of the load at the start, m."""
    return [start[name] for name in (*TIP[:2], *LOAD)]


def three_axis(randomised: bool = True) -> Task:
    """Hold a load at a point fixed in the world by slewing, luffing and hoisting, on a ship in waves.

    The scenario is the gallery's `three_axis_compensation` without its controller. The reward of a control
    step of 0.1 s is ``-0.05 d / 1 m``, with the load's distance d from its position at the start.

    Parameters
    ----------
    randomised
        Whether each episode draws the significant wave height, 1 to 2.5 m, the peak period, 8 to 12 s, and
        the direction of the sea, 150 to 210 degrees: seas that the drives can follow. In higher seas from
        nearer to the beam luffing reaches its speed limit. The seed of the sea is drawn in any case.

    Returns
    -------
    Task
        Three actions, speeds of the drives; 14 observations.

    >>> three_axis().action_names
    ('slewing', 'luffing', 'hoist')
    """
    observations = [
        Observation("reach", 20.0, "m", lambda columns, goal: _outwards(columns)[1]),
        Observation(
            "tip_rise_over_foot", 20.0, "m", lambda columns, goal: 2.0 * (columns[TIP[2]] - columns[BOOM[2]])
        ),
        Observation(
            "error_along", 1.0, "m", lambda columns, goal: _along(columns, _tip_error(columns, goal))
        ),
        Observation(
            "error_across", 1.0, "m", lambda columns, goal: _across(columns, _tip_error(columns, goal))
        ),
        Observation("height_error", 1.0, "m", lambda columns, goal: columns[LOAD[2]] - goal[:, 4]),
        Observation("speed_along", 0.5, "m/s", lambda columns, goal: _along(columns, _tip_velocity(columns))),
        Observation(
            "speed_across", 0.5, "m/s", lambda columns, goal: _across(columns, _tip_velocity(columns))
        ),
        Observation("lift.velocity.z", 0.5),
        Observation("swing_along", 1.0, "m", lambda columns, goal: _along(columns, _swing(columns))),
        Observation("swing_across", 1.0, "m", lambda columns, goal: _across(columns, _swing(columns))),
        Observation("slew.joint_velocity", 0.05),
        Observation("luff.joint_velocity", 0.05),
        Observation("winch.joint_velocity", 2.0),
        Observation("hull.roll", 0.1),
    ]
    drawn = {
        "significant_height_m": (1.0, 2.5),
        "peak_period_s": (8.0, 12.0),
        "sea.waves.wind_sea.jonswap.direction_deg": (150.0, 210.0),
    }
    return Task(
        load("three_axis_compensation").with_overrides({CONTROLLER: False}),
        ["slewing", "luffing", "hoist"],
        observations,
        _reward,
        columns=[*TIP, *TIP_VELOCITY, *BOOM, *LOAD],
        control_period_s=0.1,
        duration_s=120.0,
        goal=_goal,
        randomised=drawn if randomised else {},
        seeded=True,
    )

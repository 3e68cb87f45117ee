"""Task: reduce the roll of a ship with two gyros."""

from __future__ import annotations

import numpy as np

from ...scenario import load
from ..task import Columns, Goal, Observation, Task

ROLL_RAD = 0.05
"""Roll angle that scales the reward, rad."""


def _reward(columns: Columns, goal: Goal, actions: np.ndarray) -> np.ndarray:
    roll = columns["hull.roll"] / ROLL_RAD
    return -0.05 * roll * roll


def roll_reduction(randomised: bool = True) -> Task:
    """Reduce the roll of a ship in beam seas with two gyros whose gimbals are driven.

    The scenario is the gallery's `roll_reduction_gyros`. The two wheels spin in opposite directions; a drive
    on each gimbal turns it. The reward of a control step of 0.1 s is ``-0.05 (roll / 0.05 rad)^2``.

    Parameters
    ----------
    randomised
        Whether each episode draws the significant wave height, 1 to 3 m, and the peak period, 8 to 15 s. The
        seed of the sea is drawn in any case.

    Returns
    -------
    Task
        Two actions, shares of the torque of the drives; 6 observations.

    >>> roll_reduction().action_names
    ('precession.push_port', 'precession.push_starboard')
    """
    sides = ("port", "starboard")
    return Task(
        load("roll_reduction_gyros").with_overrides(active=False),
        [f"precession.push_{side}" for side in sides],
        [
            Observation("hull.roll", ROLL_RAD),
            Observation("hull.angular_velocity.x", 0.03),
            *(Observation(f"precession_{side}.joint_position", 0.5) for side in sides),
            *(Observation(f"precession_{side}.joint_velocity", 0.3) for side in sides),
        ],
        _reward,
        control_period_s=0.1,
        duration_s=300.0,
        randomised={"significant_height_m": (1.0, 3.0), "peak_period_s": (8.0, 15.0)} if randomised else {},
        seeded=True,
    )

"""Task: move a load to a target, on a ship in a sea that differs in each episode."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from ..task import Columns, Goal, Observation, Task
from .anti_sway import anti_sway


def _from_the_boom(x: np.ndarray, y: np.ndarray, columns: Columns) -> tuple[np.ndarray, np.ndarray]:
    """Components of a horizontal world vector along the boom and across it."""
    heading = columns["hull.yaw"] + columns["slew.joint_position"]
    cos, sin = np.cos(heading), np.sin(heading)
    return x * cos + y * sin, y * cos - x * sin


def _off(columns: Columns, goal: Goal) -> tuple[np.ndarray, np.ndarray]:
    x, y = columns["load.position.x"] - goal[:, 2], columns["load.position.y"] - goal[:, 3]
    return _from_the_boom(x, y, columns)


def _speed(columns: Columns, goal: Goal) -> tuple[np.ndarray, np.ndarray]:
    return _from_the_boom(columns["load.velocity.x"], columns["load.velocity.y"], columns)


def _part(of: Callable[..., tuple[np.ndarray, np.ndarray]], k: int) -> Callable[[Columns, Goal], np.ndarray]:
    return lambda columns, goal: of(columns, goal)[k]


def anti_sway_at_sea() -> Task:
    """Move a load to a target fixed in the world and stop it there, on a ship in an unknown sea.

    Crane, load, targets and reward are those of `anti_sway`. The crane stands on an offshore vessel, which
    moves with the waves and with the load. Each episode draws its sea: its waves, a significant height of
    0.5 to 2 m, a peak period of 8 to 12 s, and a direction up to 60 degrees off the bow to either side.

    Returns
    -------
    Task
        Two actions, slewing and luffing speed; 16 observations: those of `anti_sway`, and the load's
        displacement from the target and its velocity over the ground, along the boom and across it.

    >>> anti_sway_at_sea().observation_names[-2:]
    ('load_speed_along', 'load_speed_across')
    """
    base = anti_sway(at_sea=True)
    over_ground = [
        Observation("load_off_along", 2.0, "m", _part(_off, 0)),
        Observation("load_off_across", 2.0, "m", _part(_off, 1)),
        Observation("load_speed_along", 0.5, "m/s", _part(_speed, 0)),
        Observation("load_speed_across", 0.5, "m/s", _part(_speed, 1)),
    ]
    return replace(
        base,
        observations=[*base.observations, *over_ground],
        columns=[*base.columns, "hull.yaw"],
        randomised={
            "significant_height_m": (0.5, 2.0),
            "peak_period_s": (8.0, 12.0),
            "wave_direction_deg": (120.0, 240.0),
        },
        seeded=True,
    )

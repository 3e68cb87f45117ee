"""Task: keep a load at constant height by the winch, on a ship in waves."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from ..task import Columns, Goal, Observation, Task

SCENARIOS = Path(__file__).parents[1] / "scenarios"


def _heave_reward(columns: Columns, goal: Goal, actions: np.ndarray) -> np.ndarray:
    return -0.05 * np.abs(columns["lift.position.z"] - goal[:, 0])


def heave_compensation(randomised: bool = True) -> Task:
    """Keep a load at constant height by the speed of the winch, on a ship in waves.

    The reward of a control step of 50 ms is ``-0.05 |z - z_0| / 1 m``, with the height z of the load, z_0 at
    the start.

    Parameters
    ----------
    randomised
        Whether each episode draws the significant wave height, 1 to 3.5 m, the peak period, 8 to 12 s,
        and the load, 10 to 30 t. The seed of the sea is drawn in any case.

    Returns
    -------
    Task
        One action, the speed of the winch; 7 observations.
    """
    observations = [
        Observation("height_error", 1.0, "m", lambda columns, goal: columns["lift.position.z"] - goal[:, 0]),
        Observation("lift.velocity.z", 0.5),
        Observation(
            "tip_rise", 1.0, "m", lambda columns, goal: columns["boom.tip.point_position.z"] - goal[:, 1]
        ),
        Observation("boom.tip.point_velocity.z", 0.5),
        Observation("winch.joint_velocity", 4.0),
        Observation("hull.roll", 0.1),
        Observation("hull.pitch", 0.1),
    ]
    drawn = {"significant_height_m": (1.0, 3.5), "peak_period_s": (8.0, 12.0), "load_t": (10.0, 30.0)}
    return Task(
        SCENARIOS / "heave_compensation.yaml",
        ["hoist"],
        observations,
        _heave_reward,
        columns=["lift.position.z", "boom.tip.point_position.z"],
        duration_s=120.0,
        goal=lambda random, start: (start["lift.position.z"], start["boom.tip.point_position.z"]),
        randomised=drawn if randomised else {},
        seeded=True,
    )

"""Policies: functions from observations to actions."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from .task import Task

Policy = Callable[[np.ndarray], np.ndarray]
"""Function from observations to actions, a row for each environment. Make a new policy for each run if it has
internal state."""


def do_nothing(task: Task) -> Policy:
    """All inputs in the middle of their range."""
    return lambda seen: np.zeros((len(seen), len(task.set)))


def in_units(task: Task, seen: np.ndarray) -> dict[str, np.ndarray]:
    """Observations by name in their units."""
    return {one.name: seen[:, k].astype(np.float64) * one.scale for k, one in enumerate(task.seen)}


def limited(task: Task, speeds: list[np.ndarray]) -> np.ndarray:
    """Convert speeds to actions, limited to -1 to 1."""
    highest = [high for _, high in task.bounds]
    return np.clip(np.stack(speeds, axis=1) / highest, -1.0, 1.0)

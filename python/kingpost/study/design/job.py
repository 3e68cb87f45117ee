"""Units of work: what a worker is handed, and what it hands back."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypedDict

import numpy as np
from numpy.typing import NDArray

from ...results.channels import Channel
from ...scenario import Json
from ..reduce import Kept

LANES = 4
"""Runs that the engine computes side by side."""
MOST_BYTES = 4_000_000_000
"""Rows of one run."""


@dataclass(frozen=True)
class Job:
    """Consecutive runs.

    Attributes
    ----------
    unit
        Its number, from 0.
    text, file, files
        Of the scenario, and what it names.
    variants
        What is set over the scenario in each run.
    kept
        What is kept of each run.
    run_bytes
        What the rows of one run take.
    """

    unit: int
    text: str
    file: str
    files: dict[str, str]
    variants: list[list[tuple[str, Json]]]
    kept: Kept
    run_bytes: float


class WarningCount(TypedDict):
    """Runs with one kind of warning, and the first text: texts that differ in their numbers alone are one
    kind."""

    name: str
    text: str
    runs: int


@dataclass(frozen=True)
class Result:
    """The results of a unit.

    Attributes
    ----------
    arrays
        By variable, along runs first.
    ends
        Why a run ended early or was not built, by its place in the unit.
    warnings
        What the engine warned of.
    engine
        Digest of the engine's sources that computed it.
    """

    unit: int
    arrays: dict[str, NDArray[np.generic]]
    ends: dict[int, str]
    warnings: list[WarningCount]
    engine: str


def columns(channels: list[Channel]) -> dict[str, str]:
    """The flat columns with their units, but for time."""
    names = [name for channel in channels for name in channel["columns"]]
    units = [unit for channel in channels for unit in channel["units"]]
    return {name: unit for name, unit in zip(names, units, strict=True) if name != "time"}


def run_bytes(settings: dict[str, float], channels: list[Channel]) -> float:
    """Return the memory that the rows of a run take, bytes, from its simulation's settings."""
    rows = settings["duration_s"] / max(settings["record_every_s"], settings["step_s"]) + 2
    return float(8 * rows * sum(channel["len"] for channel in channels))

"""Units of work: the input and the result of a worker."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypedDict

import numpy as np
from numpy.typing import NDArray

from ...results.channels import Channel
from ...scenario import Json
from ..reduce import Kept

LANES = 4
"""Number of runs that the engine computes in SIMD lanes."""
MOST_BYTES = 4_000_000_000
"""Largest memory of the rows of one run, bytes."""


@dataclass(frozen=True)
class Job:
    """Consecutive runs.

    Attributes
    ----------
    unit
        Number of the unit, from 0.
    text, file, files
        Text and file name of the scenario, and the texts of the files that it names.
    variants
        Overrides of the scenario in each run.
    kept
        Quantities that are kept of each run.
    run_bytes
        Memory of the rows of one run, bytes.
    """

    unit: int
    text: str
    file: str
    files: dict[str, str]
    variants: list[list[tuple[str, Json]]]
    kept: Kept
    run_bytes: float


class WarningCount(TypedDict):
    """Number of runs with one kind of warning, and its first text with its run; texts that differ only in
    numbers are one kind. In a unit, `first_run` counts from its first run."""

    code: str
    name: str
    text: str
    runs: int
    first_run: int


@dataclass(frozen=True)
class Result:
    """The results of a unit.

    Attributes
    ----------
    arrays
        Arrays by variable; the first dimension is the run.
    ends
        Reason why a run ended early or was not built, by its index in the unit.
    warnings
        Warnings of the engine.
    engine
        Digest of the sources of the engine that computed the unit.
    """

    unit: int
    arrays: dict[str, NDArray[np.generic]]
    ends: dict[int, str]
    warnings: list[WarningCount]
    engine: str


def columns(channels: list[Channel]) -> dict[str, str]:
    """Flat columns with their units, except time."""
    names = [name for channel in channels for name in channel["columns"]]
    units = [unit for channel in channels for unit in channel["units"]]
    return {name: unit for name, unit in zip(names, units, strict=True) if name != "time"}


def run_bytes(settings: dict[str, float], channels: list[Channel]) -> float:
    """Return the memory of the rows of a run, bytes, from the settings of its simulation."""
    rows = settings["duration_s"] / max(settings["record_every_s"], settings["step_s"]) + 2
    return float(8 * rows * sum(channel["len"] for channel in channels))

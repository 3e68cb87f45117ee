"""Work of a worker process: the runs of a unit, reduced. Nothing here knows where results go."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any

from numpy.typing import NDArray

from ..engine import engine, source_digest
from ..errors import KingpostError
from ..simulation.outcomes import NUMBER
from . import reduce

LANES = 4
TOGETHER_BYTES = 200_000_000
"""Rows that a worker has in memory at a time."""
MOST_BYTES = 4_000_000_000
"""Rows of one run."""
MOST_WARNINGS = 50
"""Kinds of warnings that are kept of a unit."""


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
    variants: list[list[tuple[str, Any]]]
    kept: reduce.Kept
    run_bytes: float


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
        What the engine warned of: name, the first text, and in how many runs; texts that differ in their
        numbers alone count as one.
    engine
        Digest of the engine's sources that computed it.
    """

    unit: int
    arrays: dict[str, NDArray[Any]]
    ends: dict[int, str]
    warnings: list[dict[str, Any]]
    engine: str


def compute(job: Job) -> Result:
    """Run and reduce a unit."""
    arrays = reduce.empty(job.kept, len(job.variants))
    ends: dict[int, str] = {}
    warned: dict[tuple[str, str], dict[str, Any]] = {}
    together = max(1, int(TOGETHER_BYTES / max(job.run_bytes, 1.0)))
    together = together // LANES * LANES or together
    for first in range(0, len(job.variants), together):
        _some(job, range(first, min(first + together, len(job.variants))), arrays, ends, warned)
    warnings = sorted(warned.values(), key=lambda one: (-one["runs"], one["name"], one["text"]))
    return Result(job.unit, arrays, ends, warnings[:MOST_WARNINGS], source_digest())


def _some(
    job: Job,
    runs: range,
    arrays: dict[str, NDArray[Any]],
    ends: dict[int, str],
    warned: dict[tuple[str, str], dict[str, Any]],
) -> None:
    """Runs side by side; each alone where one of them is no scenario or has other bodies."""
    variants = json.dumps([job.variants[run] for run in runs])
    try:
        rows, errors, published = engine.batch(job.text, job.file, job.files, variants, (1, MOST_BYTES), None)
    except KingpostError as error:
        if len(runs) == 1:
            arrays["status"][runs[0]] = reduce.NOT_BUILT
            ends[runs[0]] = str(error).removeprefix("run 0: ")
        else:
            for run in runs:
                _some(job, range(run, run + 1), arrays, ends, warned)
        return
    channels, warnings, limits = json.loads(published)
    places = _places(channels)
    missing = [name for name in job.kept.columns if name not in places]
    at = [places.get(name, 0) for name in job.kept.columns]
    for k, run in enumerate(runs):
        if missing:
            arrays["status"][run] = reduce.NOT_BUILT
            ends[run] = (
                f"found no column {missing[0]} in this run, allowed: the columns of the first run in all"
            )
            continue
        ended = errors[k]
        if ended is not None:
            ends[run] = str(ended)
        reduce.reduce(arrays, run, rows[k], at, limits[k], ended is None, job.kept)
        _count(warnings[k], warned)


def _count(warnings: list[dict[str, Any]], warned: dict[tuple[str, str], dict[str, Any]]) -> None:
    of_run = {(one["name"], NUMBER.sub("#", one["text"])): one["text"] for one in reversed(warnings)}
    for (name, pattern), text in of_run.items():
        entry = warned.setdefault((name, pattern), {"name": name, "text": text, "runs": 0})
        entry["runs"] += 1


def _places(channels: list[dict[str, Any]]) -> dict[str, int]:
    """Where each flat column is in a row."""
    return {name: channel["offset"] + k for channel in channels for k, name in enumerate(channel["columns"])}


def columns(channels: list[dict[str, Any]]) -> dict[str, str]:
    """The flat columns with their units, but for time."""
    names = [name for channel in channels for name in channel["columns"]]
    units = [unit for channel in channels for unit in channel["units"]]
    return {name: unit for name, unit in zip(names, units, strict=True) if name != "time"}


def run_bytes(settings: dict[str, float], channels: list[dict[str, Any]]) -> float:
    """Return the memory that the rows of a run take, bytes, from its simulation's settings."""
    rows = settings["duration_s"] / max(settings["record_every_s"], settings["step_s"]) + 2
    return float(8 * rows * sum(channel["len"] for channel in channels))

"""Work of a worker process: computes and reduces the runs of a unit, independent of the storage of
results."""

from __future__ import annotations

import json

import numpy as np
from numpy.typing import NDArray

from ...engine import engine, source_digest
from ...errors import KingpostError
from ...results.channels import Channel
from ...results.entries import WarningEntry
from ...results.operation_steps import COLUMN
from ...simulation.outcomes import kind_of
from .. import reduce
from ..design.job import LANES, MOST_BYTES, Job, Result, WarningCount

TOGETHER_BYTES = 200_000_000
"""Largest memory of the rows that a worker holds at a time, bytes."""
Warned = dict[tuple[str, str, str], WarningCount]
"""Warnings by their code, their name and their text without numbers."""
MOST_WARNINGS = 50
"""Largest number of kinds of warnings that are kept of a unit."""


def compute(job: Job) -> Result:
    """Run and reduce a unit."""
    arrays = reduce.empty(job.kept, len(job.variants))
    ends: dict[int, str] = {}
    warned: Warned = {}
    together = max(1, int(TOGETHER_BYTES / max(job.run_bytes, 1.0)))
    together = together // LANES * LANES or together
    for first in range(0, len(job.variants), together):
        _some(job, range(first, min(first + together, len(job.variants))), arrays, ends, warned)
    warnings = sorted(warned.values(), key=lambda one: (-one["runs"], one["name"], one["text"]))
    return Result(job.unit, arrays, ends, warnings[:MOST_WARNINGS], source_digest())


def _some(
    job: Job,
    runs: range,
    arrays: dict[str, NDArray[np.generic]],
    ends: dict[int, str],
    warned: Warned,
) -> None:
    """Compute runs together, or each alone if one of them is not a valid scenario or has other bodies."""
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
        reduce.reduce(arrays, run, rows[k], at, limits[k], ended is None, job.kept, places.get(COLUMN))
        _count(warnings[k], run, warned)


def _count(warnings: list[WarningEntry], run: int, warned: Warned) -> None:
    of_run = {kind_of(one): one["text"] for one in reversed(warnings)}
    for kind, text in of_run.items():
        none: WarningCount = {"code": kind[0], "name": kind[1], "text": text, "runs": 0, "first_run": run}
        warned.setdefault(kind, none)["runs"] += 1


def _places(channels: list[Channel]) -> dict[str, int]:
    """Index of each flat column in a row."""
    return {name: channel["offset"] + k for channel in channels for k, name in enumerate(channel["columns"])}

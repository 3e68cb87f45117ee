"""One scenario in many seas: runs that differ in their seed, each in a file of its own."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import results
from ..errors import KingpostError
from .batch import FINISHED, SEED, Batch
from .simulate import Progress

if TYPE_CHECKING:
    import xarray

    from ..scenario import Scenario

TOGETHER = 16
"""Runs that are in memory at a time."""


def files(pattern: str | Path, count: int) -> list[Path]:
    """A file for each seed from 1 on: its number replaces the one ``*`` of the pattern's name.

    >>> [path.name for path in files("run_*.nc", 10)][::9]
    ['run_01.nc', 'run_10.nc']

    Raises
    ------
    KingpostError
        When there is no such place, or a file cannot be written.
    """
    if count < 1:
        raise KingpostError(f"--seeds: found {count}, allowed: a whole number greater than 0")
    path = Path(pattern)
    if path.name.count("*") != 1:
        raise KingpostError(f"{pattern}: found no single * for the seed, allowed: a name such as run_*.nc")
    digits = len(str(count))
    names = (path.name.replace("*", f"{seed:0{digits}d}") for seed in range(1, count + 1))
    return [results.check_output(path.with_name(name)) for name in names]


def run(
    scenario: Scenario, paths: Sequence[Path], progress: Progress | None = None
) -> Iterator[tuple[Path, dict[str, Any]]]:
    """Run a scenario with a seed from 1 on for each of the `files`; yields them and the runs' attributes.

    Each has the bits that it has alone. `progress` is called with the number of runs that are done.
    """
    count = len(paths)
    for first in range(1, count + 1, TOGETHER):
        seeds = list(range(first, min(first + TOGETHER, count + 1)))
        together = Batch(scenario, {SEED: seeds}).run(progress=_from(first - 1, progress))
        for seed in seeds:
            one = _alone(scenario.with_overrides({SEED: seed}), together, seed - first)
            yield results.write(one, paths[seed - 1]), one.attrs


def _from(done: int, progress: Progress | None) -> Progress | None:
    return None if progress is None else lambda more: progress(done + more)


def _alone(scenario: Scenario, batch: xarray.Dataset, run: int) -> xarray.Dataset:
    """A run of a batch as `kingpost.run` has it."""
    of_batch = batch.isel(run=run)
    status = of_batch["status"].item()
    if status != FINISHED:
        recorded = np.isfinite(of_batch["kinetic_energy"].values)
        of_batch = of_batch.isel(time=np.arange(recorded.sum()))
    alone = of_batch.drop_vars(["run", "status", SEED])
    own = {name: json.dumps(json.loads(batch.attrs[name])[run]) for name in ("warnings", "limits")}
    own["model_warnings"] = batch.attrs["model_warnings"]
    return alone.assign_attrs(results.attributes(scenario, status) | own)

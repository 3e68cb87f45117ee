"""Runs of one scenario with different seeds, each stored in a separate file."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .. import results
from ..engine import source_digest
from ..errors import KingpostError
from ..results import entries
from ..results.kept import is_of_a_run
from .batch import FINISHED, MOST_MEMORY_GB, SEED, Batch
from .simulate import Progress, Simulation

if TYPE_CHECKING:
    import xarray

    from ..scenario import Scenario

MOST_SEEDS = 100_000
TOGETHER = 16
"""Largest number of runs in memory at a time, if their rows fit."""
MODEL_GB = 1e-3
"""Memory of the model of one run: ample, the engine counts 65 kB."""


def files(pattern: str | Path, count: int) -> list[Path]:
    """Paths of the files for seeds from 1 on: the seed replaces the ``*`` in the pattern.

    >>> [path.name for path in files("run_*.nc", 10)][::9]
    ['run_01.nc', 'run_10.nc']

    Raises
    ------
    KingpostError
        If the folder does not exist, or a file cannot be written.
    """
    if not 1 <= count <= MOST_SEEDS:
        raise KingpostError(f"--seeds: found {count}, allowed: a whole number from 1 to {MOST_SEEDS}")
    path = Path(pattern)
    if path.name.count("*") != 1:
        raise KingpostError(f"{pattern}: found no single * for the seed, allowed: a name such as run_*.nc")
    digits = len(str(count))
    names = (path.name.replace("*", f"{seed:0{digits}d}") for seed in range(1, count + 1))
    return [results.check_output(path.with_name(name)) for name in names]


@dataclass(frozen=True)
class OfSeed:
    """A run in a file: its events, warnings and limits, with its attributes, and whether the file of the same
    run existed already."""

    path: Path
    entries: xarray.Dataset
    was_there: bool = False

    @property
    def seed(self) -> int:
        """Seed of the run."""
        return int(self.entries.attrs["seed"])

    @property
    def status(self) -> str:
        """``finished``, or why the run ended."""
        return str(self.entries.attrs["status"])


def run(
    scenario: Scenario,
    paths: Sequence[Path],
    progress: Progress | None = None,
    patterns: Sequence[str] = (),
    units: str = results.NAMES,
    anew: bool = False,
) -> Iterator[OfSeed]:
    """Run a scenario with a seed from 1 on for each of the `files`, in order.

    Each run gives the same bits as it does alone. An existing NetCDF file is kept if its run finished and its
    attribute ``fingerprint`` shows the same scenario, files and engine; `anew` repeats it. `patterns` and
    `units` are those of `results.write`. `progress` is called with the number of finished runs.
    """
    seeds = {path: seed for seed, path in enumerate(paths, 1)}
    prints = {path: fingerprint(scenario, seed, patterns) for path, seed in seeds.items()}
    held = {} if anew else {path: _finished(path, prints[path]) for path in paths}
    there = {path: found for path, found in held.items() if found is not None}
    new = [path for path in paths if path not in there]
    done = dict(there)
    of_one_gb = _memory_gb(scenario) if new else MOST_MEMORY_GB
    count = max(1, min(TOGETHER, int(MOST_MEMORY_GB / of_one_gb)))
    for first in range(0, len(new), count):
        some = new[first : first + count]
        together = Batch(scenario, {SEED: [seeds[path] for path in some]}).run(
            progress=_from(len(there) + first, progress),
            # Runs whose rows do not fit together run one by one, as without seeds.
            memory_gb=max(MOST_MEMORY_GB, 1.01 * of_one_gb + MODEL_GB),
        )
        for k, path in enumerate(some):
            one = _alone(scenario.with_overrides({SEED: seeds[path]}), together, k)
            one.attrs["fingerprint"] = prints[path]
            results.write(one, path, patterns, units)
            done[path] = entries.only(one)
    for path in paths:
        yield OfSeed(path, done[path], path in there)


def _memory_gb(scenario: Scenario) -> float:
    """Memory of the rows of one run, bytes."""
    settings = scenario.resolved["simulation"]
    rows = settings["duration_s"] / max(settings["record_every_s"], settings["step_s"]) + 2
    return 8e-9 * rows * len(Simulation(scenario).row())


def fingerprint(scenario: Scenario, seed: int, patterns: Sequence[str] = ()) -> str:
    """SHA-256 of everything that determines the content of a run's file: the resolved scenario with its seed,
    the files that it names, the engine, and the written columns."""
    of_seed = scenario.with_overrides({SEED: seed})
    parts = [of_seed.json, of_seed.digests, source_digest(), list(patterns)]
    return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()


def _finished(path: Path, expected: str) -> xarray.Dataset | None:
    """The events, warnings and limits of a file that already holds this finished run; None for any other
    file."""
    import xarray

    if path.suffix.lower() != ".nc" or not os.path.isfile(path):
        return None
    try:
        with xarray.open_dataset(path, engine="h5netcdf") as found:
            held = entries.only(found)
    except Exception:
        # A file that cannot be read is replaced.
        return None
    matches = held.attrs.get("fingerprint") == expected and held.attrs.get("status") == FINISHED
    return held if matches and is_of_a_run(held) else None


def _from(done: int, progress: Progress | None) -> Progress | None:
    return None if progress is None else lambda more: progress(done + more)


def _alone(scenario: Scenario, batch: xarray.Dataset, run: int) -> xarray.Dataset:
    """One run of a batch as a data set like that of `kingpost.run`."""
    of_batch = entries.of_run(batch, run)
    status = of_batch["status"].item()
    if status != FINISHED:
        recorded = np.isfinite(of_batch["kinetic_energy"].values)
        of_batch = of_batch.isel(time=np.arange(recorded.sum()))
    alone = of_batch.drop_vars(["run", "status", SEED])
    return alone.assign_attrs(results.attributes(scenario, status))

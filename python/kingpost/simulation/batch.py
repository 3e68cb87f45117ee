"""Many runs at once: variants of one scenario over SIMD lanes and threads."""

from __future__ import annotations

import json
import logging
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import results
from ..engine import engine
from ..errors import KingpostError
from ..given import lists
from ..results import entries
from ..results.entries import LimitEntry, WarningEntry
from ..scenario import Overrides, Scenario, as_scenario
from .outcomes import in_words, with_partings
from .python_warnings import emit_warnings
from .simulate import Progress, Simulation

if TYPE_CHECKING:
    import xarray

LOG = logging.getLogger(__name__)
FINISHED = "finished"
SEED = "simulation.seed"

MOST_MEMORY_GB = 2.0
"""Memory for the rows of all runs; building their data set takes the same amount again."""
LARGEST_MEMORY_GB = 1e6
"""An upper bound that no machine reaches: it refuses infinity."""


class Batch:
    """Variants of one scenario, run together.

    Four variants of one structure run side by side in SIMD lanes, and such groups run in threads. Each run
    gives the same bits as it does alone. A run that diverges is marked, and the others continue.

    Parameters
    ----------
    scenario
        The scenario that all variants are based on.
    parameters
        Lists by parameter name or by the dotted path of a field: one value for each run, all of one length.

    Examples
    --------
    >>> batch = Batch("paper", {"crane_x_m": [-10, 0, 10]}, {"simulation.duration_s": 0.1})
    >>> len(batch)
    3
    >>> found = batch.run()
    >>> found.angular_velocity.dims
    ('run', 'time', 'body', 'axis')
    >>> found.status.values.tolist()
    ['finished', 'finished', 'finished']
    """

    def __init__(
        self,
        scenario: Scenario | str | Path,
        parameters: Mapping[str, Sequence[Any]],
        overrides: Overrides | None = None,
    ) -> None:
        self.scenario = as_scenario(scenario, overrides, {})
        self.parameters = lists("parameters", parameters)
        lengths = {name: len(values) for name, values in self.parameters.items()}
        if len(set(lengths.values())) != 1:
            found = ", ".join(f"{length} of {name}" for name, length in lengths.items()) or "no parameters"
            raise KingpostError(f"parameters: found {found}, allowed: lists of one length")

    def __len__(self) -> int:
        return len(next(iter(self.parameters.values())))

    def run(
        self, threads: int = 0, progress: Progress | None = None, memory_gb: float = MOST_MEMORY_GB
    ) -> xarray.Dataset:
        """Run every variant from start to end.

        Parameters
        ----------
        threads
            Number of threads; 0 takes as many as the machine has.
        progress
            Called at intervals with the number of finished runs.
        memory_gb
            Memory for the rows of all runs; building their data set takes the same amount again.

        Returns
        -------
        xarray.Dataset
            The variables of `kingpost.run` with a first dimension ``run``; along it the values of
            the parameters and ``status``, which is ``finished`` or the reason why the run ended. A run that
            ended early has NaN after its end. ``warning_run`` is the run of each warning, -1 for those about
            the model of the first run; results of limits have the dimensions ``run`` and ``limit``. Events
            are not recorded. Each warning is also a `KingpostWarning`; the same warning of many runs appears
            once.

        Raises
        ------
        ScenarioError
            If a variant is wrong; no variant has run then.
        KingpostError
            If the variants differ in their bodies or in the times of their records, or would record more than
            `memory_gb`.
        KeyboardInterrupt
            On Ctrl-C, within a second; nothing is kept.

        >>> found = Batch("paper", {"crane_x_m": [0, 5]}, {"simulation.duration_s": 0.1}).run()
        >>> found.sizes["run"]
        2
        """
        if threads < 0:
            raise KingpostError(f"threads: found {threads}, allowed: 0 or more")
        if not 0 < memory_gb < LARGEST_MEMORY_GB:
            raise KingpostError(
                f"memory_gb: found {memory_gb}, allowed: more than 0, and less than {LARGEST_MEMORY_GB:g}"
            )
        most_bytes = int(1e9 * memory_gb)
        engine.check_batch(max((len(values) for values in self.parameters.values()), default=1), most_bytes)
        variants = [self.scenario.overrides + variant for variant in self._variants()]
        known = self._known()
        rows, errors, published = engine.batch(
            self.scenario.text,
            self.scenario.file,
            self.scenario.files,
            json.dumps(variants),
            (threads, most_bytes),
            progress,
        )
        status = [FINISHED if error is None else str(error) for error in errors]
        summed_up = f"{status.count(FINISHED)} of {len(status)} runs finished"
        channels, warnings, limits = json.loads(published)
        LOG.info("%s: %s", self.scenario.title, summed_up)
        found = results.dataset(self.scenario, channels, _stacked(rows), summed_up)
        found = entries.with_entries_of_runs(found, warnings=warnings, limits=limits, model_warnings=known)
        emit_warnings([*known, *self._came_of(limits, warnings)])
        along = {name: ("run", np.array(values)) for name, values in self.parameters.items()}
        about = {"run": np.arange(len(status)), "status": ("run", np.array(status, str))}
        return found.assign_coords({**about, **along})

    def _known(self) -> list[str]:
        """Warnings about the model of the first run."""
        for variant in self._variants()[:1]:
            try:
                return Simulation(self.scenario.with_overrides(dict(variant))).model_warnings
            except KingpostError:
                # The engine's error names the wrong variant.
                break
        return []

    def _came_of(self, limits: list[list[LimitEntry]], warnings: list[list[WarningEntry]]) -> list[str]:
        """Warnings of the runs; runs that differ only in their seeds are identified by their seeds."""
        seeds = self.parameters.get(SEED) if len(self.parameters) == 1 else None
        counted_by = "run" if seeds is None else "seed"
        runs = zip(seeds or range(len(warnings)), limits, warnings, strict=True)
        outcomes = [with_partings(seed, of, told, counted_by=counted_by) for seed, of, told in runs]
        of_parting, others = in_words(outcomes)
        return [*of_parting, *others]

    def _variants(self) -> list[tuple[tuple[str, Any], ...]]:
        by_run = zip(*self.parameters.values(), strict=True)
        return [tuple(zip(self.parameters, values, strict=True)) for values in by_run]


def _stacked(rows: list[np.ndarray]) -> np.ndarray:
    """Runs over one time axis; a run that ended early is filled up with NaN."""
    if not rows:
        return np.empty((0, 0, 0))
    longest = max(rows, key=len)
    stacked = np.full((len(rows), *longest.shape), np.nan)
    for run, of_run in enumerate(rows):
        stacked[run, : len(of_run)] = of_run
        # The last row of a run that diverged is at its last good time, which is not on the grid.
        on_grid = of_run[:, 0] == longest[: len(of_run), 0]
        if not on_grid[:-1].all():
            raise KingpostError(
                f"run {run}: found rows at other times than in the longest run, "
                "allowed: the same simulation.record_every_s and simulation.step_s in all"
            )
        if not on_grid.all():
            stacked[run, len(of_run) - 1] = np.nan
    return stacked

"""`kingpost.Study`: many runs of one scenario, into a folder that lasts."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from concurrent.futures import Executor
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

from ..scenario import ParameterValue, Scenario
from .design import file
from .design.plan import Plan, plan
from .running import run
from .running.locks import Part
from .store.reading import open_results

if TYPE_CHECKING:
    import xarray


class Study:
    """Many runs of one scenario: every case of its axes with every seed.

    Parameters
    ----------
    source
        The file of a study (docs/studies.md), or its fields as a dictionary.

    Raises
    ------
    ScenarioError
        With file, line, column, field, what was found and what is allowed. Each value of an axis was tried by
        itself, and the first and last values of all axes together.

    Examples
    --------
    >>> study = Study({
    ...     "version": 1, "title": "Slewing", "scenario": "paper",
    ...     "set": {"simulation.duration_s": 0.1},
    ...     "axes": {"crane_x_m": {"values": [-10, 0]}}, "seeds": {"count": 2},
    ...     "record": ["ship.roll"],
    ... })
    >>> len(study), study.axes
    (4, {'crane_x_m': [-10.0, 0.0]})
    >>> import tempfile
    >>> found = study.run(tempfile.mkdtemp(), workers=1)
    >>> found.statistics.dims, found.status.values.tolist()
    (('run', 'column', 'statistic'), [0, 0, 0, 0])
    """

    def __init__(self, source: str | Path | Mapping[str, object]) -> None:
        self.file = file.read(source)
        self.plan: Plan = plan(self.file)

    def __len__(self) -> int:
        """How many runs there are."""
        return self.plan.runs

    @property
    def title(self) -> str:
        """The study's title."""
        return str(self.file.content["title"])

    @property
    def scenario(self) -> Scenario:
        """Scenario that all runs start from, with what the study sets over it."""
        return self.plan.scenario

    @cached_property
    def axes(self) -> dict[str, list[ParameterValue]]:
        """The values of each axis, each once, in their order."""
        return {name: list(dict.fromkeys(values)) for name, values in self.plan.cases.values.items()}

    def overrides(self, run: int) -> dict[str, ParameterValue]:
        """Return the values that a run sets over `scenario`: with them it is that very run.

        Parameters
        ----------
        run
            Its number, from 0.

        Returns
        -------
        dict
            Values by parameter name or dotted path, the seed among them.

        >>> study = Study({"version": 1, "title": "x", "scenario": "paper", "record": ["ship.roll"],
        ...     "axes": {"crane_x_m": {"values": [-5, 0]}}, "seeds": {"count": 10}})
        >>> study.overrides(13)
        {'crane_x_m': 0.0, 'simulation.seed': 4}
        >>> study.scenario.with_overrides(study.overrides(13))["crane_x_m"]
        0.0
        """
        return dict(self.plan.overrides(run))

    def run(
        self,
        folder: str | Path,
        executor: Executor | None = None,
        workers: int | None = None,
        resume: bool = False,
        part: Part | None = None,
        progress: Callable[[int], Callable[[float], None]] | None = None,
    ) -> xarray.Dataset:
        """Run what is missing in a folder, and open its results.

        A run has the same bits on any number of workers, here or elsewhere. Whatever ends this on the way,
        the units (up to 32 runs) that are finished stay, and ``resume=True`` goes on.

        Parameters
        ----------
        folder
            Where results are; made if it is not there.
        executor
            Any `concurrent.futures.Executor`: of Dask ``client.get_executor()``. Without it, processes of
            this machine; a script then needs ``if __name__ == "__main__":`` above its call.
        workers
            How many processes; as many as there are processors unless given. 1 computes in this process.
            With an executor: how many units are handed to it at a time, by half.
        resume
            Whether a study that is in the folder goes on. It has to be the same.
        part
            ``(k, n)`` computes every n-th unit from the k-th on, k from 1: parts may run side by side, on
            machines that share the folder, and find each other's work.
        progress
            Called once with the number of runs to compute; what it returns is called with the number of
            those done.

        Returns
        -------
        xarray.Dataset
            Read when it is asked for. See `open_study`.

        Raises
        ------
        KingpostError
            When there is a study in the folder and `resume` is not given, another study, or another
            process at work; a `RunError` when workers end again and again.
        OutputError
            When the folder cannot be written, as on a full disk.

        >>> import tempfile
        >>> study = Study({"version": 1, "title": "x", "scenario": "paper", "record": ["ship.roll"],
        ...     "set": {"simulation.duration_s": 0.1}, "seeds": {"count": 2}})
        >>> study.run(tempfile.mkdtemp(), workers=1).sizes["run"]
        2
        """
        run.run(self.plan, Path(folder), executor, workers, resume, part, progress)
        return open_study(folder)


def open_study(folder: str | Path) -> xarray.Dataset:
    """The results of a study, complete or not, by `xarray.open_zarr`: numbers are read when needed.

    Parameters
    ----------
    folder
        Of the study.

    Returns
    -------
    xarray.Dataset
        Along ``run``, with coordinates ``case``, ``seed`` and each axis:

        - ``status``: 0 finished, 1 ended early (it diverged), 2 not built (the case is no scenario), -1 not
          run;
        - ``statistics`` (run, column, statistic): mean, standard deviation, mean zero up-crossing period,
          maximum, minimum and their times, without the start of the run; SI units, ``column_unit``;
        - ``limit_held`` (run, limit): 1 held, 0 exceeded, -1 unknown; ``limit_worst``, the value nearest to a
          bound or farthest beyond one, in ``limit_unit``, and ``limit_time``, s;
        - ``peaks`` (run, column, peak), the largest first, and ``peak_count``, where the study asks for them;
        - ``cycles`` (run, column) and ``damage`` (run, column, slope), the same.

        Of a run that ended early numbers are NaN; a limit that it exceeded before counts as exceeded.

    Raises
    ------
    KingpostError
        When there is no study in the folder.

    >>> import tempfile
    >>> study = Study({"version": 1, "title": "x", "scenario": "paper", "record": ["ship.roll"],
    ...     "set": {"simulation.duration_s": 0.1}})
    >>> folder = tempfile.mkdtemp()
    >>> _ = study.run(folder, workers=1)
    >>> open_study(folder).statistics.sel(column="ship.roll", statistic="maximum").dims
    ('run',)
    """
    return open_results(Path(folder))

"""`kingpost.Study`: many runs of one scenario, stored in a folder."""

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
        With file, line, column, field, the value found and the allowed values. The scenario is built with
        each value of an axis separately, and with the first and last values of all axes together.

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
        """Number of runs."""
        return self.plan.runs

    @property
    def title(self) -> str:
        """The study's title."""
        return str(self.file.content["title"])

    @property
    def scenario(self) -> Scenario:
        """Scenario that all runs are based on, with the study's common overrides."""
        return self.plan.scenario

    @cached_property
    def axes(self) -> dict[str, list[ParameterValue]]:
        """Values of each axis without repetitions, in their order."""
        return {name: list(dict.fromkeys(values)) for name, values in self.plan.cases.values.items()}

    def overrides(self, run: int) -> dict[str, ParameterValue]:
        """Return the overrides of `scenario` that reproduce a run of the study.

        Parameters
        ----------
        run
            Number of the run, from 0.

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
        """Run the missing units of a folder, and open its results. A run gives the same bits on any number of
        workers, on this or another machine. If the study is stopped, finished units (up to 32 runs each) are
        kept, and ``resume=True`` continues.

        Parameters
        ----------
        folder
            Folder of the results; created if it does not exist.
        executor
            Any `concurrent.futures.Executor`, for Dask ``client.get_executor()``; default: processes on this
            machine; a script then needs ``if __name__ == "__main__":`` above its call.
        workers
            Number of processes; default: the number of processors. 1 computes in this process. With an
            executor: half of the number of units submitted at a time.
        resume
            Whether to continue a study in the folder, which must be the same study.
        part
            ``(k, n)`` computes every n-th unit from the k-th on, k from 1. Parts may run at the same time,
            also on several machines that share the folder, and find each other's finished units.
        progress
            Called once with the number of runs to compute; the function that it returns is called with the
            number of finished runs.

        Returns
        -------
        xarray.Dataset
            Results whose numbers are read when needed: see `open_study`.

        Raises
        ------
        KingpostError
            If the folder holds a study and `resume` is not given, or another study, or another process works
            in it; a `RunError` if workers end repeatedly.
        OutputError
            If the folder cannot be written, for example on a full disk.

        >>> import tempfile
        >>> study = Study({"version": 1, "title": "x", "scenario": "paper", "record": ["ship.roll"],
        ...     "set": {"simulation.duration_s": 0.1}, "seeds": {"count": 2}})
        >>> study.run(tempfile.mkdtemp(), workers=1).sizes["run"]
        2
        """
        run.run(self.plan, Path(folder), executor, workers, resume, part, progress)
        return open_study(folder)


def open_study(folder: str | Path) -> xarray.Dataset:
    """Open the results of a study, complete or not, by `xarray.open_zarr`: numbers are read when needed.

    Parameters
    ----------
    folder
        Folder of the study.

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
        If there is no study in the folder.

    >>> import tempfile
    >>> study = Study({"version": 1, "title": "x", "scenario": "paper", "record": ["ship.roll"],
    ...     "set": {"simulation.duration_s": 0.1}})
    >>> folder = tempfile.mkdtemp()
    >>> _ = study.run(folder, workers=1)
    >>> open_study(folder).statistics.sel(column="ship.roll", statistic="maximum").dims
    ('run',)
    """
    return open_results(Path(folder))

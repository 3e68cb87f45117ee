"""Execution of a study: distributes its missing units over workers and writes their results to its folder."""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator
from concurrent.futures import Executor
from contextlib import ExitStack, closing
from dataclasses import dataclass
from pathlib import Path

from ...engine import source_digest
from ...errors import KingpostError
from ..design.job import Job, Result
from ..design.plan import Plan
from ..store.writing import Store
from . import locks, pools

Progress = Callable[[float], None]


@dataclass(frozen=True)
class Done:
    """Numbers of runs in a call of `run`: computed, found finished, and left to other parts.

    Attributes
    ----------
    computed
        Number of runs that the call computed.
    kept
        Number of runs that were already finished.
    left
        Number of unfinished runs of other parts.
    """

    computed: int
    kept: int
    left: int


def run(
    plan: Plan,
    folder: Path,
    executor: Executor | None = None,
    workers: int | None = None,
    resume: bool = False,
    part: locks.Part | None = None,
    progress: Callable[[int], Progress] | None = None,
) -> Done:
    """Run the missing units. `progress` is called with the number of runs to compute, and returns a function
    that is called with the number of finished runs.

    Raises
    ------
    KingpostError
        If the folder holds another study, or another process works in it; `OutputError` if it cannot be
        written. Finished units are kept.
    """
    _check(workers, part)
    store = Store(folder, plan)
    with ExitStack() as held:
        if part is None:
            held.enter_context(locks.alone(folder))
            store.begin(resume, alone=True)
        else:
            held.enter_context(locks.beside_other_parts(folder, part))
            with locks.first_of_parts(folder):
                store.begin(resume=True)
        mine, others = _units(plan, part)
        kept = [unit for unit in mine if store.done(unit)]
        missing = sorted(set(mine).difference(kept))
        count = sum(len(plan.runs_in(unit)) for unit in missing)
        tell = progress(count) if progress else None
        computed = 0
        with closing(_results(plan, missing, executor, workers)) as results:
            for result in results:
                _check_engine(result)
                store.write(result)
                computed += len(plan.runs_in(result.unit))
                if tell:
                    tell(computed)
        left = sum(len(plan.runs_in(unit)) for unit in others if not store.marker(unit).exists())
    return Done(computed, sum(len(plan.runs_in(unit)) for unit in kept), left)


def _units(plan: Plan, part: locks.Part | None) -> tuple[list[int], list[int]]:
    """Units of this part, and units of the other parts."""
    which, of = part or (1, 1)
    every = range(plan.units)
    return [unit for unit in every if unit % of == which - 1], [
        unit for unit in every if unit % of != which - 1
    ]


def _results(
    plan: Plan, units: list[int], executor: Executor | None, workers: int | None
) -> Generator[Result, None, None]:
    jobs: Iterator[Job] = (plan.job(unit) for unit in units)
    if executor is not None:
        at_once = pools.AHEAD * (workers or getattr(executor, "_max_workers", None) or pools.processors())
        yield from pools.executor(jobs, executor, at_once)
        return
    count = min(workers or pools.processors(), max(len(units), 1))
    yield from pools.here(jobs) if count == 1 else pools.processes(jobs, count)


def _check(workers: int | None, part: locks.Part | None) -> None:
    if workers is not None and not 1 <= workers <= 10_000:
        raise KingpostError(f"workers: found {workers}, allowed: a whole number from 1 to 10000")
    if part is not None and not 1 <= part[0] <= part[1]:
        raise KingpostError(f"part: found {part[0]}/{part[1]}, allowed: K/N, K from 1 to N")


def _check_engine(result: Result) -> None:
    if result.engine != source_digest():
        raise KingpostError(
            "workers: found another version of the engine there, allowed: the same Kingpost on all machines"
        )

"""Computation of units: in this process, in worker processes, or by a given executor."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import (
    FIRST_COMPLETED,
    BrokenExecutor,
    CancelledError,
    Executor,
    Future,
    ProcessPoolExecutor,
    wait,
)
from multiprocessing.connection import wait as wait_for
from multiprocessing.context import SpawnContext, SpawnProcess
from typing import Any

from ...errors import KingpostError, RunError
from ..design.job import Job, Result
from .compute import compute

TRIES = 4
"""Largest number of attempts for a unit whose worker dies."""
LOOK_EVERY_S = 0.2
"""Time between two checks for Ctrl-C, s."""
END_S = 10.0
"""Time that a worker has to end, s."""
AHEAD = 2
"""Number of units queued for each worker, so that it never waits."""


def processors() -> int:
    """Number of processors that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def here(jobs: Iterable[Job]) -> Iterator[Result]:
    """Compute in this process, one unit after another."""
    return map(compute, jobs)


def processes(jobs: Iterable[Job], workers: int) -> Iterator[Result]:
    """Compute in worker processes. If a worker dies, a new one replaces it and its unit runs again."""
    pool = _pool(workers)

    def another() -> Executor:
        nonlocal pool
        _stop(pool)
        pool = _pool(workers)
        return pool

    try:
        yield from _Spread(jobs, pool, AHEAD * workers, another).results()
    finally:
        _stop(pool)


def executor(jobs: Iterable[Job], given: Executor, at_once: int) -> Iterator[Result]:
    """Compute by an executor, with a given number of units submitted at a time."""
    return _Spread(jobs, given, at_once, None).results()


class _Spread:
    """Distribution of units over an executor. A unit whose worker dies is submitted again, to another
    executor if this one is broken and `another` can make one."""

    def __init__(
        self, jobs: Iterable[Job], pool: Executor, at_once: int, another: Callable[[], Executor] | None
    ) -> None:
        self.left, self.again = iter(jobs), list[Job]()
        self.pool, self.at_once, self.another = pool, at_once, another
        self.waiting: dict[Future[Result], Job] = {}
        self.tries: dict[int, int] = {}

    def results(self) -> Iterator[Result]:
        """Yield results as they are completed."""
        try:
            self._ask()
            while self.waiting:
                done, _ = wait(self.waiting, LOOK_EVERY_S, FIRST_COMPLETED)
                for future in done:
                    if (result := self._result(future)) is not None:
                        yield result
                self._ask()
        finally:
            for future in self.waiting:
                future.cancel()

    def _ask(self) -> None:
        while len(self.waiting) < self.at_once and (job := self._next()):
            self.tries[job.unit] = self.tries.get(job.unit, 0) + 1
            try:
                self.waiting[self.pool.submit(compute, job)] = job
            except BrokenExecutor as error:
                self._begin_again([job], error)

    def _next(self) -> Job | None:
        return self.again.pop() if self.again else next(self.left, None)

    def _result(self, future: Future[Result]) -> Result | None:
        """Return the result of a unit; None if the unit runs again."""
        job = self.waiting.pop(future, None)
        if job is None:
            # The unit was already submitted again with all others.
            return None
        try:
            result = future.result()
        except BrokenExecutor as error:
            self._begin_again([job], error)
        except (KingpostError, MemoryError):
            raise
        except (Exception, CancelledError) as error:
            if self.another is not None:
                raise
            # A cluster raises its own exception for a lost worker.
            self._try_again(job, error)
        else:
            self.tries.pop(job.unit, None)
            return result
        return None

    def _begin_again(self, jobs: list[Job], error: BaseException) -> None:
        """Replace a broken executor and submit its units again."""
        if self.another is None:
            raise RunError(f"executor: found {error}, allowed: a working executor") from error
        for job in [*jobs, *self.waiting.values()]:
            self._try_again(job, error)
        self.waiting.clear()
        self.pool = self.another()

    def _try_again(self, job: Job, error: BaseException) -> None:
        if self.tries[job.unit] >= TRIES:
            hint = f": {error}" if str(error) else ""
            raise RunError(
                f"unit {job.unit}: its worker ended {TRIES} times{hint}; allowed: workers that keep running. "
                'A script that starts a study needs the line `if __name__ == "__main__":` above it'
            ) from error
        self.again.append(job)


class _Worker(SpawnProcess):
    """Worker process that ends with its parent, which would otherwise wait for the worker at exit."""

    def __init__(self, *arguments: Any, **named: Any) -> None:
        super().__init__(*arguments, **{**named, "daemon": True})


class _Spawned(SpawnContext):
    # Spawned, not forked: a process with threads must not be forked.
    Process = _Worker


def _pool(workers: int) -> ProcessPoolExecutor:
    return ProcessPoolExecutor(workers, _Spawned(), initializer=_begin)


def _stop(pool: ProcessPoolExecutor) -> None:
    """End the workers at once and discard their results."""
    started = list((pool._processes or {}).values())
    pool.shutdown(wait=False, cancel_futures=True)
    for process in started:
        process.terminate()
    for process in started:
        process.join(END_S)


def _begin() -> None:
    """Prepare a worker: it ignores Ctrl-C, which its parent handles, and ends with its parent."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()
    if parent is not None:
        threading.Thread(target=_end_with, args=(parent.sentinel,), daemon=True).start()


def _end_with(sentinel: int) -> None:
    wait_for([sentinel])
    os._exit(1)

"""Where units are computed: here, in worker processes, or by any executor that one hands over."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, CancelledError, Executor, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from multiprocessing.connection import wait as wait_for

from ..errors import KingpostError, RunError
from .compute import Job, Result, compute

TRIES = 4
"""How often a unit is begun whose worker dies."""
LOOK_EVERY_S = 0.2
"""Time between two looks for Ctrl-C."""
AHEAD = 2
"""Units that each worker has before it, so that it never waits."""


def processors() -> int:
    """How many processors this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def here(jobs: Iterable[Job]) -> Iterator[Result]:
    """Compute in this process, one unit after another."""
    return map(compute, jobs)


def processes(jobs: Iterable[Job], workers: int) -> Iterator[Result]:
    """Compute in worker processes. Where one dies, others take its place and its unit runs again."""
    pool = _pool(workers)

    def replaced(_: Executor) -> Executor:
        nonlocal pool
        _stop(pool)
        pool = _pool(workers)
        return pool

    try:
        yield from _spread(jobs, pool, AHEAD * workers, replaced)
    finally:
        _stop(pool)


def executor(jobs: Iterable[Job], given: Executor, at_once: int) -> Iterator[Result]:
    """Compute by an executor, of which so many units are asked at a time."""
    return _spread(jobs, given, at_once, None)


def _spread(
    jobs: Iterable[Job], pool: Executor, at_once: int, replaced: Callable[[Executor], Executor] | None
) -> Iterator[Result]:
    """Results as they come. A unit whose worker dies is asked for again."""
    left, again, tries = iter(jobs), list[Job](), dict[int, int]()
    waiting: dict[Future[Result], Job] = {}

    def ask() -> None:
        while len(waiting) < at_once and (job := again.pop() if again else next(left, None)):
            tries[job.unit] = tries.get(job.unit, 0) + 1
            waiting[pool.submit(compute, job)] = job

    try:
        ask()
        while waiting:
            done, _ = wait(waiting, LOOK_EVERY_S, FIRST_COMPLETED)
            broken = False
            for future in done:
                job = waiting.pop(future)
                try:
                    yield future.result()
                    tries.pop(job.unit, None)
                except (BrokenProcessPool, CancelledError) as error:
                    broken = True
                    _try_again(job, tries, again, error)
                except Exception as error:
                    if isinstance(error, KingpostError | MemoryError) or replaced is not None:
                        raise
                    # A cluster says in its own way that a worker is gone.
                    _try_again(job, tries, again, error)
            if broken:
                if replaced is None:
                    raise RunError("executor: found workers that ended, allowed: an executor that works")
                again.extend(waiting.values())
                waiting.clear()
                pool = replaced(pool)
            ask()
    finally:
        for future in waiting:
            future.cancel()


def _try_again(job: Job, tries: dict[int, int], again: list[Job], error: BaseException) -> None:
    if tries[job.unit] >= TRIES:
        hint = "" if str(error) == "" else f": {error}"
        raise RunError(
            f"unit {job.unit}: its worker ended {TRIES} times{hint}; allowed: workers that go on. "
            'A script that starts a study needs the line `if __name__ == "__main__":` above it'
        ) from error
    again.append(job)


def _pool(workers: int) -> ProcessPoolExecutor:
    # Spawned, not forked: what has threads may not be forked.
    return ProcessPoolExecutor(workers, multiprocessing.get_context("spawn"), initializer=_begin)


def _stop(pool: ProcessPoolExecutor) -> None:
    """End the workers at once: what they compute is not wanted."""
    started = list((pool._processes or {}).values())
    pool.shutdown(wait=False, cancel_futures=True)
    for process in started:
        process.terminate()
    for process in started:
        process.join()


def _begin() -> None:
    """What a worker does first: it leaves Ctrl-C to the process that started it, and ends when that ends."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()
    if parent is not None:
        threading.Thread(target=_end_with, args=(parent.sentinel,), daemon=True).start()


def _end_with(sentinel: int) -> None:
    wait_for([sentinel])
    os._exit(1)

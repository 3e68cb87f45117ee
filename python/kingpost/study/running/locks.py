"""Locks of a study's folder: for one process, or for the parts of a job array, each part once."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

import filelock

from ...errors import KingpostError, OutputError

FOLDER, WHOLE = "locks", "study.lock"
Part = tuple[int, int]
"""Number of a part, from 1, and number of all parts."""
WAIT_S = 60.0
"""Time that a part waits for another one to lay out the folder, s."""


@contextmanager
def alone(folder: Path) -> Iterator[None]:
    """Lock a folder for one process. The system releases the lock when the process ends, even if it is
    killed.

    Raises
    ------
    KingpostError
        If another process works in the folder.
    """
    with ExitStack() as held:
        held.enter_context(_held(folder, WHOLE, 0.0))
        for path in sorted((folder / FOLDER).glob("part-*.lock")):
            held.enter_context(_held(folder, path.name, 0.0))
        yield


@contextmanager
def beside_other_parts(folder: Path, part: Part) -> Iterator[None]:
    """Lock one part of a folder: other processes may lock other parts, but not the whole folder."""
    with ExitStack() as held:
        held.enter_context(_held(folder, f"part-{part[0]}-of-{part[1]}.lock", 0.0))
        # A process that locks the whole folder keeps the lock to its end.
        with first_of_parts(folder):
            pass
        yield


@contextmanager
def first_of_parts(folder: Path) -> Iterator[None]:
    """Lock the whole folder for a short time, between parts."""
    with _held(folder, WHOLE, WAIT_S):
        yield


@contextmanager
def _held(folder: Path, name: str, wait_s: float) -> Iterator[None]:
    try:
        (folder / FOLDER).mkdir(parents=True, exist_ok=True)
        lock = filelock.FileLock(folder / FOLDER / name, timeout=wait_s)
        with lock:
            yield
    except filelock.Timeout:
        raise KingpostError(
            f"{folder}: found another process at work there, allowed: one at a time, "
            "or parts of an array (--part K/N), each once"
        ) from None
    except (OSError, NotImplementedError) as error:
        reason = error if isinstance(error, OSError) else OSError(0, str(error))
        raise OutputError(folder, reason) from None

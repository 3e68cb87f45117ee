"""Who may work in a study's folder: one process, or the parts of an array side by side, each once."""

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
"""Parts that begin together lay out the folder one after another."""


@contextmanager
def alone(folder: Path) -> Iterator[None]:
    """Hold a folder against everybody else.

    The system lets go of a lock when its process ends, however it ends.

    Raises
    ------
    KingpostError
        When another process works there.
    """
    with ExitStack() as held:
        held.enter_context(_held(folder, WHOLE, 0.0))
        for path in sorted((folder / FOLDER).glob("part-*.lock")):
            held.enter_context(_held(folder, path.name, 0.0))
        yield


@contextmanager
def beside_other_parts(folder: Path, part: Part) -> Iterator[None]:
    """Hold one part of a folder: others may hold other parts, nobody the whole."""
    with ExitStack() as held:
        held.enter_context(_held(folder, f"part-{part[0]}-of-{part[1]}.lock", 0.0))
        # Who holds the whole does so to its end.
        with first_of_parts(folder):
            pass
        yield


@contextmanager
def first_of_parts(folder: Path) -> Iterator[None]:
    """Hold the whole for a short while, between parts."""
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

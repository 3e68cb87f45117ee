"""Storage of solved frequencies in a file next to the output, so that a stopped run can continue.

The file belongs to one set of settings: hull, attitude, lid, water, frequencies, directions and solver.
It contains the SHA-256 of these settings; a file of other settings is ignored. It is written atomically after
each frequency, and removed when the database is written.
"""

from __future__ import annotations

import glob
import hashlib
import zipfile
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import output
from ..errors import OutputError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from numpy.typing import NDArray

ENDING = ".partial.npz"


def digest(parts: Iterable[Any]) -> str:
    """SHA-256 of arrays, numbers and texts in this order.

    >>> digest([1.0, "a"]) == digest([1.0, "a"]), digest([1.0]) == digest([2.0])
    (True, False)
    """
    found = hashlib.sha256()
    for part in parts:
        if isinstance(part, np.ndarray):
            found.update(f"{part.dtype} {part.shape}".encode())
            found.update(np.ascontiguousarray(part).tobytes())
        else:
            found.update(repr(part).encode())
        found.update(b"\0")
    return found.hexdigest()


class Partial:
    """Arrays by frequency; the key of infinite frequency is ``infinite``.

    Parameters
    ----------
    path
        Path of the file, or `None` to store nothing.
    say
        Called with the number of frequencies that are reused, if any.
    """

    def __init__(self, path: Path | None, say: Callable[[int], None] = lambda _count: None) -> None:
        self.path, self.settings, self.say = path, "", say
        self.arrays: dict[str, tuple[NDArray, ...]] = {}

    def open(self, settings: str) -> int:
        """Load the solved frequencies for these settings; return their number."""
        self.settings, self.arrays = settings, {}
        if self.path is None or not self.path.is_file():
            return 0
        try:
            with np.load(self.path, allow_pickle=False) as stored:
                if str(stored["settings"]) != settings:
                    return 0
                for name in stored.files:
                    if name != "settings":
                        key, place = name.rsplit("/", 1)
                        self.arrays.setdefault(key, ())
                        self.arrays[key] += (stored[f"{key}/{int(place)}"],)
        except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile):
            # A file that cannot be read is ignored: everything is computed again.
            self.arrays = {}
        if self.arrays:
            self.say(len(self.arrays))
        return len(self.arrays)

    def get(self, key: str) -> tuple[NDArray, ...] | None:
        return self.arrays.get(key)

    def kept(self, key: str, solve: Callable[[], tuple[NDArray, ...]]) -> tuple[NDArray, ...]:
        """A frequency's arrays: stored ones, or solved now and stored."""
        found = self.get(key)
        if found is None:
            found = solve()
            self.put(key, found)
        return found

    def put(self, key: str, values: tuple[NDArray, ...]) -> None:
        """Store a frequency and write the file."""
        self.arrays[key] = values
        if self.path is None:
            return
        named = {f"{name}/{k}": value for name, some in self.arrays.items() for k, value in enumerate(some)}
        # If the file cannot be written, the computation continues.
        with suppress(OutputError), output.whole(self.path) as beside:
            np.savez(beside, settings=np.array(self.settings), **named)

    def done(self) -> None:
        """Remove the file once the database is written."""
        if self.path is not None:
            self.path.unlink(missing_ok=True)
            # Also remove the temporary file of a run that was killed while writing.
            for left in self.path.parent.glob(f".{glob.escape(self.path.name)}.*.npz"):
                left.unlink(missing_ok=True)

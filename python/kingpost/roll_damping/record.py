"""Records of decaying roll: time and angle."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ..errors import RollDampingError, shortened
from .sections import Array, read_columns

TIMES = ("time_s", "time")
ROLLS = ("roll_rad", "roll_deg", "roll")
FEWEST_SAMPLES = 16
LARGEST = {"time_s": 1e9, "roll_rad": 100.0}
"""Largest allowed magnitudes of time and angle in a record."""


@dataclass(frozen=True)
class DecayRecord:
    """Roll angles, rad, at increasing times, s.

    >>> time = np.linspace(0, 60, 601)
    >>> record = DecayRecord(time, 0.2 * np.exp(-0.02 * time) * np.cos(0.6 * time))
    >>> DecayRecord(time[:3], record.roll_rad[:3])
    Traceback (most recent call last):
    kingpost.errors.RollDampingError: samples: found 3, allowed: 16 or more
    """

    time_s: Array
    roll_rad: Array

    def __post_init__(self) -> None:
        for name in ("time_s", "roll_rad"):
            object.__setattr__(self, name, np.asarray(getattr(self, name), float))
            values = getattr(self, name)
            if values.ndim != 1 or len(values) != len(self.time_s):
                allowed = "one number for each time"
                raise RollDampingError(name, f"the shape {values.shape}", allowed)
            bad = np.flatnonzero(~(np.abs(values) <= LARGEST[name]))
            if len(bad):
                allowed = f"finite numbers, up to {LARGEST[name]:g}"
                raise RollDampingError(name, f"{values[bad[0]]} in row {bad[0] + 1}", allowed)
        if len(self.time_s) < FEWEST_SAMPLES:
            raise RollDampingError("samples", f"{len(self.time_s)}", f"{FEWEST_SAMPLES} or more")
        steps = np.diff(self.time_s)
        if (steps <= 0).any():
            row = np.flatnonzero(steps <= 0)[0] + 2
            raise RollDampingError("time_s", f"{self.time_s[row - 1]:g} in row {row}", "times that increase")

    @classmethod
    def read(cls, path: str | Path, column: str | None = None) -> DecayRecord:
        """A record from a CSV file with a line of names.

        Time is ``time_s`` or ``time``, in seconds. The roll is the given column, or ``roll_rad``,
        ``roll_deg``, ``roll``, or the only one whose name ends with ``.roll``, as `kingpost run -o run.csv`
        writes it: in radians, or in degrees where the name ends with ``_deg``.

        Raises
        ------
        RollDampingError
            If the file has no such columns or its numbers are not a record of roll.
        """
        columns = read_columns(path)
        times = [name for name in TIMES if name in columns]
        rolls = [name for name in ROLLS if name in columns] or [n for n in columns if n.endswith(".roll")]
        rolls = rolls if column is None else [name for name in columns if name == column]
        if len(times) != 1 or len(rolls) != 1:
            wanted = f"the column {column}" if column else "one of roll_rad, roll_deg, NAME.roll"
            allowed = f"time_s or time, and {wanted}"
            raise RollDampingError("columns", shortened(", ".join(columns)), allowed, str(path))
        roll = columns[rolls[0]]
        try:
            return cls(columns[times[0]], np.radians(roll) if rolls[0].endswith("_deg") else roll)
        except RollDampingError as error:
            raise RollDampingError(error.field, error.found, error.allowed, str(path)) from None

    def between(self, first_s: float, last_s: float) -> DecayRecord:
        """The part of the record between two times."""
        kept = (self.time_s >= first_s) & (self.time_s <= last_s)
        return DecayRecord(self.time_s[kept], self.roll_rad[kept])

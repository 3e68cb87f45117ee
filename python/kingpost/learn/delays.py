"""Delayed observations of a controller."""

from __future__ import annotations

import numpy as np


class Delays:
    """Buffer of the last observations of all copies; each copy has its own delay in control steps.

    Parameters
    ----------
    count
        Number of copies.
    longest
        Largest delay in control steps.
    width
        Number of observations.

    Examples
    --------
    >>> late = Delays(2, 3, 1)
    >>> for copy, steps in enumerate([0, 2]):
    ...     late.begin(copy, steps, np.zeros(1))
    >>> for now in (1.0, 2.0, 3.0):
    ...     late.push(np.full((2, 1), now))
    >>> late.seen().ravel().tolist()
    [3.0, 1.0]
    """

    def __init__(self, count: int, longest: int, width: int) -> None:
        self.steps = np.zeros(count, np.int64)
        self._past = np.zeros((longest + 1, count, width), np.float32)
        self._newest = 0

    def begin(self, copy: int, steps: int, seen: np.ndarray) -> None:
        """Begin an episode: the present observations are returned until the delay is over."""
        self.steps[copy] = steps
        self._past[:, copy] = seen

    def push(self, seen: np.ndarray) -> None:
        """Store the observations at the end of a control step."""
        self._newest = (self._newest + 1) % len(self._past)
        self._past[self._newest] = seen

    def seen(self) -> np.ndarray:
        """Return the delayed observations of each copy."""
        return self._past[(self._newest - self.steps) % len(self._past), np.arange(len(self.steps))]

    def of(self, copy: int) -> tuple[int, np.ndarray]:
        """Return delay and observations of one copy, the oldest first."""
        return int(self.steps[copy]), np.roll(self._past[:, copy], -self._newest - 1, axis=0)

    def set_all(self, given: tuple[int, np.ndarray]) -> None:
        """Set delay and observations of all copies, in the form that `of` returns."""
        self.steps[:], past = given
        self._past[:], self._newest = past[:, None], len(self._past) - 1

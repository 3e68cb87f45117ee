"""`kingpost verify --control`: every controller on its standard seas, with and without.

Each controller is one module of this folder; a new one is a line in `CONTROLLERS`. Two modules look at them
from other sides: `frequency` over the period of the waves, `sweep` in seas beyond the limits of the drives.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any, Protocol

from ..rows import FAILED
from . import cylinder, frequency, heave, platform, roll, sweep, three_axis
from .standard import AT_A_LIMIT


class Controller(Protocol):
    """Functions that the module of a controller offers."""

    def cases(self) -> Iterator[Any]:
        """Its runs."""

    def measured(self, update: Callable[[float], None]) -> Sequence[Any]:
        """Every run as a row, which has a `verdict`; `update` is called with the number of runs done."""

    def text(self, rows: Sequence[Any]) -> str:
        """Its table."""


CONTROLLERS: tuple[Controller, ...] = (heave, cylinder, frequency, roll, three_axis, platform, sweep)
"""In the order in which they are measured and printed."""


def count() -> int:
    """Number of runs of all controllers."""
    return sum(len(list(controller.cases())) for controller in CONTROLLERS)


def tables(update: Callable[[float], None]) -> Iterator[tuple[str, bool]]:
    """Each controller's table, and whether a run of it fails; `update` gets the number of runs done."""
    before = 0
    for controller in CONTROLLERS:
        done = before
        rows = controller.measured(lambda runs, done=done: update(done + runs))
        before += len(rows)
        yield controller.text(rows), any(row.verdict in (AT_A_LIMIT, FAILED) for row in rows)

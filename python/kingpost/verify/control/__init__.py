"""`kingpost verify --control`: performance of every controller on its standard seas, compared with the
uncontrolled motion. Each controller is one module of this folder and one line in `CONTROLLERS`. Two further
modules measure the frequency response (`frequency`) and seas beyond the limits of the drives (`sweep`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any, Protocol

from ..rows import FAILED
from . import cylinder, frequency, heave, platform, roll, sweep, three_axis
from .standard import AT_A_LIMIT


class Controller(Protocol):
    """Functions of a controller's module."""

    def cases(self) -> Iterator[Any]:
        """Cases of the runs."""

    def measured(self, update: Callable[[float], None]) -> Sequence[Any]:
        """Every run as a row with a `verdict`; `update` is called with the number of finished runs."""

    def text(self, rows: Sequence[Any]) -> str:
        """Table of the rows."""


CONTROLLERS: tuple[Controller, ...] = (heave, cylinder, frequency, roll, three_axis, platform, sweep)
"""Controllers in the order of measurement and print."""


def count() -> int:
    """Number of runs of all controllers."""
    return sum(len(list(controller.cases())) for controller in CONTROLLERS)


def tables(update: Callable[[float], None]) -> Iterator[tuple[str, bool]]:
    """Table of each controller, and whether one of its runs fails; `update` is called with the number of
    finished runs."""
    before = 0
    for controller in CONTROLLERS:
        done = before
        rows = controller.measured(lambda runs, done=done: update(done + runs))
        before += len(rows)
        yield controller.text(rows), any(row.verdict in (AT_A_LIMIT, FAILED) for row in rows)

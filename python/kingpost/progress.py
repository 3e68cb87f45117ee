"""Progress bar on a terminal; no bar in a pipe."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from tqdm import tqdm

_FORM = "{desc}{percentage:3.0f}%|{bar}| {n:.4g}/{total:.4g} {unit} [{elapsed}<{remaining}]"


@contextmanager
def bar(total: float, unit: str, description: str = "") -> Iterator[Callable[[float], None]]:
    """Show the progress of some work on stderr; call the yielded function with the amount done."""
    terminal = sys.stderr.isatty()
    with tqdm(total=total, unit=unit, desc=description, bar_format=_FORM, disable=not terminal,
              leave=False, file=sys.stderr) as shown:  # fmt: skip
        yield lambda done: _move(shown, min(done, total))


def _move(shown: tqdm, done: float) -> None:
    shown.update(max(0.0, done - shown.n))

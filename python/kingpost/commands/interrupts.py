"""Handling of Ctrl-C, SIGTERM and SIGHUP: an interrupt at once, or at the end of a block."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, NoReturn

BY_SYSTEM = ("SIGTERM", "SIGHUP")
"""Signals that are treated like Ctrl-C: a request to end, and the closing of the terminal."""


@contextmanager
def ended_as_interrupted() -> Iterator[None]:
    """Treat SIGTERM and SIGHUP (a terminal that closes) like Ctrl-C."""

    def interrupt(*_: object) -> NoReturn:
        raise KeyboardInterrupt

    with _handled(BY_SYSTEM, interrupt, lambda before: before is signal.SIG_DFL):
        yield


@contextmanager
def finished_first() -> Iterator[None]:
    """Defer the first interrupt until the end of the block; a second one stops the block.

    Raises
    ------
    KeyboardInterrupt
        After the block if there was an interrupt, or at the second one.
    """
    asked = 0

    def interrupt(*_: object) -> None:
        nonlocal asked
        asked += 1
        if asked > 1:
            raise KeyboardInterrupt

    with _handled(("SIGINT", *BY_SYSTEM), interrupt, lambda before: before is not signal.SIG_IGN):
        yield
    if asked:
        raise KeyboardInterrupt


@contextmanager
def _handled(
    names: tuple[str, ...], handler: Callable[..., Any], replaces: Callable[[Any], bool]
) -> Iterator[None]:
    """Handle signals in the block; only the main thread can."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    signals = [getattr(signal, name) for name in names if hasattr(signal, name)]
    before = {one: signal.getsignal(one) for one in signals}
    before = {one: old for one, old in before.items() if old is not None and replaces(old)}
    for one in before:
        signal.signal(one, handler)
    try:
        yield
    finally:
        for one, old in before.items():
            signal.signal(one, old)

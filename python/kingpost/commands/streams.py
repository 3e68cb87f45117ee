"""Standard output and standard error: closed, full, or a pipe whose reader has gone."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import Any, TextIO, cast

from ..errors import printable

STREAMS = (("stdin", os.O_RDONLY, "r"), ("stdout", os.O_WRONLY, "w"), ("stderr", os.O_WRONLY, "w"))
"""The standard streams in the order of their descriptors."""


def fill_closed() -> None:
    """Open the null device for each standard stream that is closed.

    Otherwise the next opened file gets the closed stream's descriptor, and output that a library prints is
    written into that file.
    """
    for descriptor, (name, flags, mode) in enumerate(STREAMS):
        if getattr(sys, name) is not None:
            continue
        opened = os.open(os.devnull, flags)
        if opened != descriptor:
            os.dup2(opened, descriptor)
            os.close(opened)
        setattr(sys, name, os.fdopen(descriptor, mode, encoding="utf-8"))


def say(line: str) -> None:
    """Print a line on standard error; ignore a failure to write it."""
    with suppress(OSError):
        print(printable(line), file=sys.stderr, flush=True)


class LostOutputError(Exception):
    """Standard output cannot be written; the cause is the system's error."""


class Watched:
    """Text stream whose write failures are distinguished from those of other files."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)

    def write(self, text: str) -> int:
        with _told():
            return self._stream.write(text)

    def flush(self) -> None:
        with _told():
            self._stream.flush()


@contextmanager
def _told() -> Iterator[None]:
    try:
        yield
    except OSError as error:
        raise LostOutputError from error


@contextmanager
def watched_output() -> Iterator[None]:
    """Raise `LostOutputError` in the block, at its end at the latest, if standard output cannot be written.

    The remaining output is then discarded, so that the exit of the program does not fail too.
    """
    before = sys.stdout
    sys.stdout = cast(TextIO, Watched(before))
    try:
        try:
            yield
        finally:
            sys.stdout.flush()
    except LostOutputError:
        _give_up(before)
        raise
    finally:
        sys.stdout = before


def _give_up(output: TextIO) -> None:
    with suppress(OSError, ValueError):
        null = os.open(os.devnull, os.O_WRONLY)
        os.dup2(null, output.fileno())
        os.close(null)
        output.flush()

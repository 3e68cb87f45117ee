"""What commands share: exit codes, the scenario with what is set over it, how a failure is said."""

from __future__ import annotations

import argparse
import json
import logging
import sys
from collections.abc import Iterator
from contextlib import contextmanager

from ..engine import engine
from ..scenario import Scenario, load

DONE, FAILED, WRONG_INPUT, INTERRUPTED = 0, 1, 2, 130


def add_scenario(command: argparse.ArgumentParser) -> None:
    """The scenario and what is set over it."""
    command.add_argument("scenario", metavar="SCENARIO", help="a file or a gallery name")
    command.add_argument("--set", action="append", default=[], metavar="name=value",
                         help="set a parameter or a field; may be repeated")  # fmt: skip


def scenario_of(options: argparse.Namespace) -> Scenario:
    """The scenario that the command line names."""
    pairs = (engine.parse_assignment(assignment) for assignment in options.set)
    return load(options.scenario, {name: json.loads(value) for name, value in pairs})


@contextmanager
def only_errors_of(library: str) -> Iterator[None]:
    """Keep what a library logs below an error off this command's stderr."""
    log = logging.getLogger(library)
    before = log.level
    log.setLevel(logging.ERROR)
    try:
        yield
    finally:
        log.setLevel(before)


def fail(error: object, code: int) -> int:
    """Say what went wrong, in one line, after what was printed so far."""
    sys.stdout.flush()
    print(f"error: {' '.join(str(error).split())}", file=sys.stderr)
    return code

"""What commands share: exit codes, the scenario with what is set over it, what is printed and how."""

from __future__ import annotations

import argparse
import json
import math
import sys
from collections.abc import Callable, Iterable, Mapping
from typing import Any

import numpy as np

from ..engine import engine
from ..scenario import Scenario, load

WARNING, WARNING_OF_RUNS = "warning: ", "warning, in "
"""How lines of a report begin that one should not miss."""
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


def add_output(command: argparse.ArgumentParser) -> None:
    """How much is printed, and in which form."""
    how = command.add_mutually_exclusive_group()
    how.add_argument("--json", action="store_true", help="print the numbers as JSON, in SI units")
    how.add_argument("-q", "--quiet", action="store_true", help="print warnings and errors alone")


def show(options: argparse.Namespace, text: Callable[[], str], data: Callable[[], Any]) -> None:
    """Print a report: as text, as JSON, or nothing. What it warns of goes to stderr in each case."""
    lines = text().splitlines()
    if options.json:
        print(json.dumps(plain(data()), indent=1, ensure_ascii=False, allow_nan=False))
    elif not options.quiet:
        print(_without_double_gaps(line for line in lines if not _is_warning(line)))
    warn(line for line in lines if _is_warning(line))


def note(options: argparse.Namespace, words: str) -> None:
    """Print a line beside a report: not where JSON or nothing is wanted."""
    if not (options.json or options.quiet):
        print(words)


def warn(every: Iterable[str]) -> None:
    """Print lines of warning on stderr."""
    sys.stdout.flush()
    for line in every:
        print(line, file=sys.stderr)


def plain(value: Any) -> Any:
    """A value as JSON knows it; what is not a number is null.

    >>> plain({"deviation": np.array([0.5, np.nan])})
    {'deviation': [0.5, None]}
    """
    if isinstance(value, np.ndarray | np.generic):
        value = value.tolist()
    if isinstance(value, Mapping):
        return {str(key): plain(entry) for key, entry in value.items()}
    if isinstance(value, list | tuple):
        return [plain(entry) for entry in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def _is_warning(line: str) -> bool:
    return line.startswith((WARNING, WARNING_OF_RUNS))


def _without_double_gaps(lines: Iterable[str]) -> str:
    """Lines, of empty ones one at a time and none at the end."""
    kept: list[str] = []
    for line in lines:
        if line or (kept and kept[-1]):
            kept.append(line)
    return "\n".join(kept).rstrip()


def fail(error: object, code: int) -> int:
    """Say what went wrong, in one line, after what was printed so far."""
    sys.stdout.flush()
    print(f"error: {' '.join(str(error).split())}", file=sys.stderr)
    return code

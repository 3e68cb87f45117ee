"""Shared by the commands: exit codes, the scenario with its overrides, printing."""

from __future__ import annotations

import argparse
import json
import logging
import math
import re
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from typing import Any

import numpy as np

from ..engine import engine
from ..errors import KingpostError, printable
from ..scenario import Scenario, load
from .streams import say

WORD = re.compile(
    r'"(?:[^"\\]|\\.)*"|'
    r"(?:true|false|null)(?=\s*[,}\]])|"
    r"(?P<number>[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)(?=\s*[,}\]])|"
    r"(?P<word>[^\s{}\[\],:\"][^{}\[\],\"]*?)(?=\s*(?::\s|[,}\]]))"
)
"""Quoted strings, keywords of JSON, numbers in any form, and bare words that need quotes."""
LONGEST_QUOTE, LONGEST_WHOLE = 100, 21
"""Longest quote of the input in an error, characters; most digits of a number that is kept as a whole
number."""
WARNING, WARNING_OF_RUNS = "warning: ", "warning, in "
"""The first words of a warning in a report."""
DONE, FAILED, WRONG_INPUT, INTERRUPTED = 0, 1, 2, 130


def add_scenario(command: argparse.ArgumentParser) -> None:
    """Add the scenario and its overrides."""
    command.add_argument("scenario", metavar="SCENARIO", help="a file or a gallery name")
    command.add_argument("--set", action="append", default=[], metavar="name=value",
                         help="set a parameter or a field; may be repeated")  # fmt: skip


def scenario_of(options: argparse.Namespace) -> Scenario:
    """The scenario that the command line names."""
    return load(options.scenario, dict(_assignment(given) for given in options.set))


def _assignment(given: str) -> tuple[str, Any]:
    """Name and value of ``name=value``; a value in braces is fields by name, as JSON."""
    name, value = engine.parse_assignment(given)
    value = json.loads(value)
    if not (isinstance(value, str) and value.startswith("{")):
        return name, value
    with suppress(json.JSONDecodeError, RecursionError):
        return name, json.loads(value)
    try:
        return name, json.loads(_quoted(value))
    except (json.JSONDecodeError, RecursionError):
        place, found = beginning(name, LONGEST_QUOTE), beginning(value, LONGEST_QUOTE)
        raise KingpostError(
            f"--set {place}: found {found!r}, allowed: fields as {{name: value, list: [1, 2]}}"
        ) from None


def beginning(text: str, longest: int) -> str:
    """Cut a text to a number of characters.

    >>> beginning("draught", 4), beginning("trim", 4)
    ('drau...', 'trim')
    """
    return text if len(text) <= longest else f"{text[:longest]}..."


def _quoted(fields: str) -> str:
    """Fields in braces as JSON; bare words get quotes.

    >>> _quoted('{prescribed: {rate_rad_s: .1, on: true, "file": gallery:a/b.csv}}')
    '{"prescribed": {"rate_rad_s": 0.1, "on": true, "file": "gallery:a/b.csv"}}'
    """

    def in_json(found: re.Match[str]) -> str:
        if found["number"] is not None:
            is_whole = found["number"].isdigit() and len(found["number"]) < LONGEST_WHOLE
            return json.dumps(int(found["number"]) if is_whole else float(found["number"]))
        return found[0] if found["word"] is None else json.dumps(found["word"].strip())

    return WORD.sub(in_json, fields)


def add_output(command: argparse.ArgumentParser) -> None:
    """Add the options for the amount and the form of the output."""
    how = command.add_mutually_exclusive_group()
    how.add_argument("--json", action="store_true", help="print the numbers as JSON, in SI units")
    how.add_argument("-q", "--quiet", action="store_true", help="print warnings and errors alone")


def show(options: argparse.Namespace, text: Callable[[], str], data: Callable[[], Any]) -> None:
    """Print a report as text, as JSON or not at all. Its warnings go to stderr in each case."""
    lines = printable(text()).split("\n")
    if options.json:
        print(json.dumps(plain(data()), indent=1, ensure_ascii=False, allow_nan=False))
    elif not options.quiet:
        print(_without_double_gaps(line for line in lines if not _is_warning(line)))
    warn(line for line in lines if _is_warning(line))


def note(options: argparse.Namespace, words: str) -> None:
    """Print a line in addition to the report; not with `--json` or `--quiet`."""
    if not (options.json or options.quiet):
        print(printable(words))


def warn(every: Iterable[str]) -> None:
    """Print lines of warning on stderr."""
    sys.stdout.flush()
    for line in every:
        say(line)


def plain(value: Any) -> Any:
    """A value as JSON; NaN becomes null.

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
    """Lines without repeated empty lines and without empty lines at the end."""
    kept: list[str] = []
    for line in lines:
        if line or (kept and kept[-1]):
            kept.append(line)
    return "\n".join(kept).rstrip()


@contextmanager
def only_errors_of(library: str) -> Iterator[None]:
    """Keep log messages of a library below the level of errors off stderr."""
    log = logging.getLogger(library)
    before = log.level
    log.setLevel(logging.ERROR)
    try:
        yield
    finally:
        log.setLevel(before)


def fail(error: object, code: int) -> int:
    """Print the error in one line, after the output so far."""
    sys.stdout.flush()
    say(f"error: {' '.join(str(error).split())}")
    return code

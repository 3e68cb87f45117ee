"""The command `kingpost`.

Exit codes: 0: success; 1: the run failed, results so far are kept; 2: the input is wrong; 130: interrupted
(Ctrl-C, or a signal of the system), results so far are kept.
"""

from __future__ import annotations

import argparse
import difflib
import sys
import warnings
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NoReturn

import shtab

from . import __version__
from .commands import (
    check,
    convert,
    fields,
    figure,
    film,
    forecast,
    gallery,
    hydro,
    modes,
    paper,
    plot,
    rao,
    roll_damping,
    run,
    serve,
    statistics,
    study,
    verify,
)
from .commands.common import DONE, FAILED, INTERRUPTED, WRONG_INPUT, beginning, fail
from .commands.interrupts import ended_as_interrupted
from .commands.streams import LostOutputError, fill_closed, watched_output
from .errors import KingpostError, KingpostWarning, RunError, printable

COMMANDS = {
    "run": run,
    "check": check,
    "modes": modes,
    "rao": rao,
    "statistics": statistics,
    "study": study,
    "plot": plot,
    "figure": figure,
    "film": film,
    "forecast": forecast,
    "list": gallery,
    "fields": fields,
    "paper": paper,
    "convert": convert,
    "hydro": hydro,
    "roll-damping": roll_damping,
    "verify": verify,
    "serve": serve,
}
"""Modules by their command's name, in the order of the help."""


LONGEST_MESSAGE = 2000
"""Longest message on a wrong command line, characters: the message repeats the user's text."""
FILES = ("FILE", "SCENARIO")
"""Metavars of the options and arguments that take a file."""


class Parser(argparse.ArgumentParser):
    """Argument parser that reports a wrong command line in one line. Options must be spelled in full:
    `--seed` does not stand for `--seeds`. Underscores count as hyphens."""

    def __init__(self, **settings: Any) -> None:
        super().__init__(**{"allow_abbrev": False} | settings)

    def error(self, message: str) -> NoReturn:
        unknown = message.removeprefix("unrecognized arguments: ")
        if unknown != message:
            message += self._hint(unknown.split())
        said = beginning(printable(" ".join(message.split())), LONGEST_MESSAGE)
        self.exit(WRONG_INPUT, f"error: {said} (see {self.prog} --help)\n")

    def _hint(self, unknown: list[str]) -> str:
        """Suggest the nearest valid argument for an unknown one."""
        first = unknown[0].partition("=")[0] if unknown else ""
        own = [option for option in self._option_string_actions if option.startswith("--")]
        near = difflib.get_close_matches(first, own, n=1) if first.startswith("--") else []
        if near:
            seed = " For one seed: --set simulation.seed=2" if first == "--seed" else ""
            return f"; did you mean {near[0]}?{seed}"
        if any(Path(name).suffix in (".nc", ".csv", ".parquet") for name in unknown):
            return "; a shell replaces * by the files that are there: write 'run_*.nc' in quotes"
        return ""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit code."""
    fill_closed()
    try:
        with watched_output():
            return _run(arguments)
    except LostOutputError as lost:
        # A reader such as `head` may close its pipe early.
        if isinstance(lost.__cause__, BrokenPipeError):
            return DONE
        why = getattr(lost.__cause__, "strerror", lost.__cause__)
        return fail(f"standard output cannot be written: {why}", FAILED)


def _run(arguments: Sequence[str] | None) -> int:
    given = sys.argv[1:] if arguments is None else arguments
    options, unknown = parser().parse_known_args([hyphened(argument) for argument in given])
    if unknown:
        options.parser.error(f"unrecognized arguments: {' '.join(unknown)}")
    try:
        with ended_as_interrupted(), warnings.catch_warnings():
            # The commands themselves print the warnings of a run.
            warnings.simplefilter("ignore", KingpostWarning)
            return options.command(options)
    except RunError as error:
        return fail(error, FAILED)
    except KingpostError as error:
        return fail(error, WRONG_INPUT)
    except KeyboardInterrupt:
        return fail("interrupted", INTERRUPTED)


def hyphened(argument: str) -> str:
    """Replace each underscore in the name of an option by a hyphen; leave other arguments unchanged.

    >>> hyphened("--after_s=3"), hyphened("--set=crane_x_m=0"), hyphened("crane_x_m=0")
    ('--after-s=3', '--set=crane_x_m=0', 'crane_x_m=0')
    """
    if not argument.startswith("--"):
        return argument
    name, is_given, value = argument.partition("=")
    return f"{name.replace('_', '-')}{is_given}{value}"


def _complete_files(command: argparse.ArgumentParser) -> None:
    """Let a shell complete file names for options and arguments that take a file."""
    for action in command._actions:
        if action.metavar in FILES:
            action.complete = shtab.FILE  # type: ignore[attr-defined]


def parser() -> argparse.ArgumentParser:
    """Build the parser of the command line."""
    top = Parser(prog="kingpost", description="Ships with cranes at sea by the moving frame method.")
    top.add_argument("--version", action="version", version=f"kingpost {__version__}")
    shtab.add_argument_to(
        top, "--print-completion", help="print what a shell needs to complete commands and options"
    )
    commands = top.add_subparsers(title="commands", metavar="COMMAND", required=True)
    for name, module in COMMANDS.items():
        command = commands.add_parser(name, help=module.HELP)
        module.add_options(command)
        command.set_defaults(command=module.run, parser=command)
        _complete_files(command)
    return top

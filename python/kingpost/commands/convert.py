"""`kingpost convert`: a scenario from the mooring system of another program."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..errors import KingpostError
from ..output import check as check_output
from ..output import write_text
from .common import DONE, FAILED, add_output, fail, note, show

if TYPE_CHECKING:
    from ..convert import Converted

HELP = "make a scenario of a mooring system of MoorDyn or MoorPy"
ENDINGS = (".yaml", ".yml")


def add_options(command: argparse.ArgumentParser) -> None:
    """The command's options."""
    command.add_argument("file", metavar="FILE", help="a MoorDyn input file, or a MoorPy file in .yaml")
    command.add_argument(
        "-o", "--output", metavar="FILE", help="the scenario, .yaml; without it, it is printed"
    )
    command.add_argument("--name", help="title of the scenario (default: the first line of the file)")
    add_output(command)


def run(options: argparse.Namespace) -> int:
    """Convert the file, write the scenario, list what is left out, and check the model."""
    from ..convert import convert

    output = None if options.output is None else check_output(options.output, ENDINGS)
    found = convert(options.file, options.name)
    if output is not None and output.exists() and output.samefile(options.file):
        raise KingpostError(f"--output: found {options.output!r}, allowed: another file than the input")
    if output is None:
        show(options, lambda: found.text, lambda: _data(found, None))
    else:
        write_text(output, found.text)
        show(options, lambda: _report(found), lambda: _data(found, output))
        note(options, f"\nwritten  {output}")
    return _checked(found, "scenario" if output is None else str(output))


def _checked(found: Converted, file: str) -> int:
    """Let the engine validate the scenario, up to the shapes of its lines at rest."""
    from ..scenario import Scenario
    from ..simulation.simulate import Simulation

    try:
        Simulation(Scenario(found.text, file))
    except KingpostError as error:
        return fail(f"the scenario is converted, but cannot run: {error}", FAILED)
    return DONE


def _report(found: Converted) -> str:
    from ..convert.yaml_text import rows
    from ..reports.tables import table

    lines = [
        found.title,
        "",
        f"lines   {', '.join(found.lines)}",
        f"bodies  {', '.join(found.bodies) or 'none'}",
    ]
    for heading, each in (("left out", found.notes.left_out), ("in another form", found.notes.converted)):
        lines += ["", heading if each else f"{heading}: nothing", *table(rows(each), "<<<")]
    return "\n".join(lines)


def _data(found: Converted, output: Path | None) -> dict[str, Any]:
    def notes(each: list[Any]) -> list[dict[str, Any]]:
        return [{"line": one.line, "text": one.text, "why": one.why} for one in each]

    written = {"scenario": found.text} if output is None else {"written": str(output)}
    return {
        "title": found.title, "lines": found.lines, "bodies": found.bodies,
        "left_out": notes(found.notes.left_out), "converted": notes(found.notes.converted), **written,
    }  # fmt: skip

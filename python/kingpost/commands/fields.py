"""`kingpost fields`: the fields of a scenario file."""

from __future__ import annotations

import argparse
from dataclasses import asdict

from ..reports import fields
from .common import DONE, add_output, show

HELP = "print the fields of a kind of entry: name, unit, default, meaning"


def add_options(command: argparse.ArgumentParser) -> None:
    """The command's options."""
    command.add_argument(
        "name", metavar="NAME", nargs="?",
        help="a kind of entry, a section of the file or a type; without it, the kinds are listed",
    )  # fmt: skip
    add_output(command)


def run(options: argparse.Namespace) -> int:
    """Print the fields of one kind, or the list of all kinds."""
    name = options.name
    if name is None:
        show(options, fields.listing, lambda: [asdict(kind) for kind in fields.kinds()])
    else:
        show(options, lambda: fields.reference(name), lambda: fields.data(name))
    return DONE

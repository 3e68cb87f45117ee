"""`kingpost paper`: the paper's figures and tables."""

from __future__ import annotations

import argparse

HELP = "the paper's figures and tables, and the integrators"


def add_options(command: argparse.ArgumentParser) -> None:
    """The command's options."""
    command.add_argument("-o", "--output", metavar="DIR", default="paper-results",
                         help="folder to write (default: %(default)s)")  # fmt: skip


def run(options: argparse.Namespace) -> int:
    """Compute and write them."""
    from .. import paper

    return paper.command(options.output)

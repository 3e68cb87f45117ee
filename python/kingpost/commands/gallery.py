"""`kingpost list`: the gallery."""

from __future__ import annotations

import argparse

from .. import gallery
from .common import DONE, add_output, show

HELP = "list the gallery"


def add_options(command: argparse.ArgumentParser) -> None:
    """The command's options."""
    add_output(command)


def run(options: argparse.Namespace) -> int:
    """Print the names and titles of the gallery's scenarios."""
    from ..reports.tables import table

    entries = gallery.entries()
    show(
        options,
        lambda: "\n".join(table(((entry.name, entry.title) for entry in entries), "<<")),
        lambda: [{"name": entry.name, "title": entry.title} for entry in entries],
    )
    return DONE

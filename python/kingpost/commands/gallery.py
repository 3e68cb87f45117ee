"""`kingpost list`: the gallery."""

from __future__ import annotations

import argparse

from .. import gallery
from .common import DONE

HELP = "list the gallery"


def add_options(_command: argparse.ArgumentParser) -> None:
    """It has none."""


def run(_options: argparse.Namespace) -> int:
    """Print the names and titles of the gallery's scenarios."""
    from ..reports.tables import table

    for line in table(((entry.name, entry.title) for entry in gallery.entries()), "<<"):
        print(line)
    return DONE

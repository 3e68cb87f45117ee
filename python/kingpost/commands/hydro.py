"""`kingpost hydro`: the hydrodynamic database of a hull."""

from __future__ import annotations

import argparse

from ..hydro import command
from ..hydro.command import add_options as add_options
from .common import DONE, only_errors_of

HELP = "compute the hydrodynamic database of a hull"


def run(options: argparse.Namespace) -> int:
    """Compute or read the database and write it."""
    with only_errors_of("capytaine"):
        command.run(options)
    return DONE

"""`kingpost roll-damping`: roll damping of a hull."""

from __future__ import annotations

import argparse

from ..roll_damping import command
from ..roll_damping.command import add_options as add_options
from .common import DONE

HELP = "roll damping from a hull's sections or a decay test"


def run(options: argparse.Namespace) -> int:
    """Compute and print it."""
    command.run(options)
    return DONE

"""`kingpost verify`: measure every verified quantity now."""

from __future__ import annotations

import argparse

from ..verify import command
from ..verify.command import add_options as add_options
from .common import only_errors_of

HELP = "measure every verified quantity now, and report whether it is within its tolerance"


def run(options: argparse.Namespace) -> int:
    """Measure, and print or write the rows."""
    with only_errors_of("capytaine"):
        return command.command(options)

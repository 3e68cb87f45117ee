"""`kingpost verify`: what is verified, measured now."""

from __future__ import annotations

import argparse

from ..verify import command
from ..verify.command import add_options as add_options
from .common import only_errors_of

HELP = "measure what is verified, now, and say whether it holds"


def run(options: argparse.Namespace) -> int:
    """Measure, and print or write the rows."""
    with only_errors_of("capytaine"):
        return command.command(options)

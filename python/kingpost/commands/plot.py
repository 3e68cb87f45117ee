"""`kingpost plot`: a picture of recorded runs."""

from __future__ import annotations

import argparse

from .common import DONE, add_output, note

HELP = "a picture of recorded runs over time"


def add_options(command: argparse.ArgumentParser) -> None:
    """The command's options."""
    add_output(command)
    command.add_argument("files", nargs="+", metavar="FILE", help="results in NetCDF")
    command.add_argument(
        "--channels", nargs="+", default=[], metavar="NAME",
        help="columns, such as ship.roll or 'load.*' (default: columns with limits, main columns)",
    )  # fmt: skip
    command.add_argument(
        "-o", "--output", metavar="FILE", required=True, help="the picture: .png, .svg or .pdf"
    )


def run(options: argparse.Namespace) -> int:
    """Read the runs and draw them."""
    from ..reports import plot
    from ..results import open_all

    runs = open_all(options.files)
    written = plot.write(runs, options.output, options.channels)
    note(options, f"written  {written}")
    return DONE

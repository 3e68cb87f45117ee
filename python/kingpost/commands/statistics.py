"""`kingpost statistics`: statistics and extremes of recorded runs."""

from __future__ import annotations

import argparse

from ..output import check as check_output
from ..output import write_csv
from .common import DONE, add_output, note, show

HELP = "statistics and extremes of recorded runs"


def add_options(command: argparse.ArgumentParser) -> None:
    """The command's options."""
    command.add_argument("files", nargs="+", metavar="FILE", help="results in NetCDF, one for each seed")
    command.add_argument("--after-s", type=float, metavar="T",
                         help="leave out earlier records, s (default: the ramp of the waves)")  # fmt: skip
    command.add_argument("--channels", nargs="+", default=[], metavar="NAME",
                         help="columns, such as ship.roll or 'load.*' (default: the main ones)")  # fmt: skip
    add_output(command)
    command.add_argument("-o", "--output", metavar="FILE", help="the table: .csv")


def run(options: argparse.Namespace) -> int:
    """Read the runs and print their statistics."""
    from ..reports.statistics import frame, text
    from ..results import open_all

    output = check_output(options.output, (".csv",)) if options.output is not None else None
    runs = open_all(options.files)
    found = frame(runs, options.after_s, options.channels)
    show(options, lambda: text(runs, found, options.after_s), lambda: found.to_dict("records"))
    if output:
        write_csv(found, output)
        note(options, f"\nwritten  {output}")
    return DONE

"""`kingpost plot`: a picture of recorded runs."""

from __future__ import annotations

import argparse

from ..errors import KingpostError
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
        "--range-graph", nargs="*", metavar="LINE",
        help="tension over the arc length of lines of the kind line (default: all of them), not over time",
    )  # fmt: skip
    command.add_argument(
        "--load-chart", nargs="*", metavar="ROPE",
        help="hook load over radius on the load chart of a crane, by its hoist (default: all), not over time",
    )  # fmt: skip
    command.add_argument(
        "--after-s", type=float, metavar="T",
        help="of --range-graph: leave out earlier records, s (default: the ramp of the waves)",
    )  # fmt: skip
    command.add_argument(
        "-o", "--output", metavar="FILE", required=True, help="the picture: .png, .svg or .pdf"
    )


def run(options: argparse.Namespace) -> int:
    """Read the runs and draw them."""
    from ..reports import plot
    from ..reports.load_chart import write_load_chart
    from ..reports.range_graph import write_range_graph
    from ..results import open_all

    kinds = {"--channels": options.channels or None, "--range-graph": options.range_graph,
             "--load-chart": options.load_chart}  # fmt: skip
    first, *others = [name for name, given in kinds.items() if given is not None] or ["--channels"]
    if others:
        raise KingpostError(f"{first}: found with {others[0]}, allowed: one of both")
    if options.range_graph is None and options.after_s is not None:
        raise KingpostError("--after-s: found without --range-graph, allowed: with it")
    runs = open_all(options.files)
    if options.load_chart is not None:
        if len(runs) > 1:
            raise KingpostError(f"--load-chart: found {len(runs)} runs, allowed: one run")
        written = write_load_chart(runs[0], options.output, options.load_chart)
    elif options.range_graph is None:
        written = plot.write(runs, options.output, options.channels)
    else:
        written = write_range_graph(runs, options.output, options.range_graph, options.after_s)
    note(options, f"written  {written}")
    return DONE

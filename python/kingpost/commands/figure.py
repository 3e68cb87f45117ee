"""`kingpost figure`: a folder with a figure of an article, for a static host."""

from __future__ import annotations

import argparse

from .common import DONE, add_output, add_scenario, note, scenario_of

HELP = "a folder with a figure that can be played in an article"


def add_options(command: argparse.ArgumentParser) -> None:
    """The command's options."""
    add_scenario(command)
    add_output(command)
    command.add_argument(
        "-o", "--output", metavar="DIR", required=True, help="the folder: page, still, scenario, app"
    )
    command.add_argument("--controls", nargs="+", default=[], metavar="NAME",
                         help="parameters and inputs that the reader can set")  # fmt: skip
    command.add_argument(
        "--plot", nargs="+", default=[], metavar="NAME", help="columns to plot, such as hull.roll"
    )
    command.add_argument(
        "--camera", default="free", metavar="VIEW",
        help="free, load, cab, bridge, top, section, or six numbers: eye and target from the first body, m",
    )  # fmt: skip
    command.add_argument("--caption", default="", metavar="TEXT", help="caption below the figure")
    command.add_argument(
        "--time", type=float, default=0.0, metavar="T", help="time of the still, s (default: 0)"
    )
    command.add_argument(
        "--app", default="", metavar="ADDRESS",
        help="folder of the app on the host, as seen from the page (default: a copy, DIR/app)",
    )  # fmt: skip


def run(options: argparse.Namespace) -> int:
    """Write the folder."""
    from ..figures import Choice, write

    choice = Choice(
        options.controls, options.plot, options.camera, options.caption, options.time, options.app
    )
    written = write(scenario_of(options), options.output, choice)
    note(options, f"written  {written}")
    return DONE

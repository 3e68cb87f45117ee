"""`kingpost rao`: response to regular waves."""

from __future__ import annotations

import argparse
import math

from ..output import check as check_output
from .common import DONE, add_output, add_scenario, note, scenario_of, show

HELP = "response of ship and crane to regular waves"


def add_options(command: argparse.ArgumentParser) -> None:
    """The command's options."""
    add_scenario(command)
    add_output(command)
    command.add_argument(
        "-o", "--output", metavar="FILE", help="amplitudes and phases: .nc, .csv; .png for a picture"
    )
    command.add_argument(
        "--directions-deg", nargs="+", type=float, metavar="D",
        help="directions that waves travel towards; 180 is a head sea at heading 0 (default: every 45)",
    )  # fmt: skip
    command.add_argument(
        "--frequencies-rad-s", metavar="from:to:n", help="default: the range that the data of all hulls cover"
    )
    command.add_argument("--points", nargs="+", metavar="NAME",
                         help="bodies and named points, such as arm.tip (default: the main)")  # fmt: skip
    command.add_argument(
        "--displacement-raos", metavar="FILE",
        help="displacement RAOs of the ship, a .csv file for the joint moved_by_waves",
    )  # fmt: skip


def run(options: argparse.Namespace) -> int:
    """Compute the response and print it."""
    from ..analysis import displacement_raos, response
    from ..reports.response import text

    scenario = scenario_of(options)
    output = check_output(options.output, response.ENDINGS) if options.output is not None else None
    table = options.displacement_raos
    table = check_output(table, displacement_raos.ENDINGS) if table is not None else None
    found = response.rao(
        scenario,
        None if options.directions_deg is None else [math.radians(angle) for angle in options.directions_deg],
        None if options.frequencies_rad_s is None else response.parse_range(options.frequencies_rad_s),
        response.main_points(scenario) if options.points is None else options.points,
    )
    show(options, lambda: text(found), found.to_dict)
    if output:
        note(options, f"\nwritten  {response.write(found, output)}")
    if table:
        note(options, f"\nwritten  {displacement_raos.write(found, table)}")
    return DONE

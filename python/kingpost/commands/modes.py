"""`kingpost modes`: modes of small motion about rest."""

from __future__ import annotations

import argparse

from ..output import check as check_output
from .common import DONE, add_output, add_scenario, note, scenario_of, show

HELP = "settle a scenario and print its modes of small motion"


def add_options(command: argparse.ArgumentParser) -> None:
    """The command's options."""
    add_scenario(command)
    add_output(command)
    command.add_argument("-o", "--output", metavar="FILE", help="modes with their shapes: .nc or .csv")
    command.add_argument("--sweep", metavar="name=from:to:n", help="n values of a parameter or a field")
    command.add_argument(
        "--all", action="store_true", help="also the modes of the water's memory of radiated waves"
    )


def run(options: argparse.Namespace) -> int:
    """Settle, and print the modes."""
    from ..analysis import vibration
    from ..reports import modes

    scenario = scenario_of(options)
    output = check_output(options.output, vibration.ENDINGS) if options.output is not None else None
    sweep = vibration.parse_sweep(options.sweep) if options.sweep is not None else None
    found = vibration.modes(scenario, sweep=sweep)
    show(options, lambda: modes.text(found, options.all), found.to_dict)
    if output:
        note(options, f"\nwritten  {vibration.write(found, output)}")
    return DONE

"""`kingpost check`: validate a scenario and print its model."""

from __future__ import annotations

import argparse

from ..simulation.simulate import Simulation
from .common import DONE, FAILED, WARNING, add_output, add_scenario, scenario_of, show, warn

HELP = "validate a scenario and print its model"


def add_options(command: argparse.ArgumentParser) -> None:
    """The command's options."""
    add_scenario(command)
    add_output(command)
    command.add_argument(
        "--allow-unstable",
        action="store_true",
        help="exit code 0, not 1, for a ship that would capsize",
    )


def run(options: argparse.Namespace) -> int:
    """Build the model and print it; return exit code 1 for a ship that would capsize."""
    from ..reports import model

    scenario = scenario_of(options)
    simulation = Simulation(scenario)
    names = simulation.coordinates
    show(options, lambda: model.text(scenario, names), lambda: model.data(scenario, names))
    of_run = simulation.model_warnings[len(scenario.model["warnings"]) :]
    warn(f"{WARNING}{words}" for words in of_run)
    return FAILED if model.is_unstable(scenario) and not options.allow_unstable else DONE

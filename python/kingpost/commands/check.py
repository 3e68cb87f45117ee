"""`kingpost check`: is a scenario valid, and what is the model."""

from __future__ import annotations

import argparse

from ..simulation.simulate import Simulation
from .common import DONE, add_scenario, scenario_of

HELP = "validate a scenario and print what the model is"


def add_options(command: argparse.ArgumentParser) -> None:
    """The command's options."""
    add_scenario(command)


def run(options: argparse.Namespace) -> int:
    """Build the model and print what it is."""
    from ..reports import model

    scenario = scenario_of(options)
    simulation = Simulation(scenario)
    print(model.text(scenario, simulation.coordinates))
    for words in simulation.model_warnings[len(scenario.model["warnings"]) :]:
        print(f"\nwarning: {words}")
    return DONE

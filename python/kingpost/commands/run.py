"""`kingpost run`: one run, or a run for each of many seeds."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

from ..errors import KingpostError, RunError
from ..output import check as check_output
from ..scenario import Scenario
from ..simulation.outcomes import Outcome
from ..simulation.simulate import Simulation
from .common import DONE, FAILED, INTERRUPTED, add_scenario, fail, scenario_of

HELP = "simulate a scenario and print a summary"


def add_options(command: argparse.ArgumentParser) -> None:
    """The command's options."""
    add_scenario(command)
    command.add_argument(
        "-o",
        "--output",
        metavar="FILE",
        help="results: .nc, .csv or .parquet; .png, .svg or .pdf for a picture",
    )
    command.add_argument("--seeds", type=int, metavar="N",
                         help="N runs, of the seeds 1 to N; -o has * for them, as run_*.nc")  # fmt: skip


def run(options: argparse.Namespace) -> int:
    """Run, print what came of it, write what was asked for."""
    from .. import progress, results
    from ..reports import afloat, events, outcomes, plot
    from ..reports.run import summary

    scenario = scenario_of(options)
    simulation = Simulation(scenario)
    for words in simulation.model_warnings:
        print(f"warning: {words}", file=sys.stderr)
    if options.seeds is not None:
        return _run_seeds(scenario, options)
    existed = options.output is not None and Path(options.output).exists()
    endings = (*results.ENDINGS, *plot.ENDINGS)
    output = check_output(options.output, endings) if options.output is not None else None
    if output:
        results.check_parquet(output)
    failure: RunError | KeyboardInterrupt | None = None
    with progress.bar(scenario.resolved["simulation"]["duration_s"], "s") as update:
        try:
            recorded = simulation.run(update)
        except (RunError, KeyboardInterrupt) as error:
            if simulation.results is None:
                raise
            failure, recorded = error, simulation.results
    print(summary(recorded, scenario))
    came_of = outcomes.of_runs([recorded])
    for block in (events.events(recorded), outcomes.limits(came_of)):
        if block:
            print("", *block, sep="\n")
    _warn(came_of)
    if words := afloat.text(recorded, scenario):
        print(f"\n{words}\n")
    if output:
        over = ", replaces an older file" if existed else ""
        write = plot.write if output.suffix.lower() in plot.ENDINGS else results.write
        print(f"written         {write(recorded, output)}{over}")
    if isinstance(failure, KeyboardInterrupt):
        return fail(f"interrupted at {recorded['time'].values[-1]:g} s", INTERRUPTED)
    return fail(failure, FAILED) if failure else DONE


def _warn(came_of: Sequence[Outcome]) -> None:
    """Say on stderr what the engine warned of."""
    from ..reports.outcomes import warnings

    sys.stdout.flush()
    for lines in warnings(came_of):
        for line in lines:
            print(line, file=sys.stderr)


def _run_seeds(scenario: Scenario, options: argparse.Namespace) -> int:
    from .. import progress
    from ..reports import outcomes
    from ..simulation import seeds
    from ..simulation.batch import FINISHED

    if options.output is None:
        raise KingpostError("--seeds: found no -o, allowed: -o with * for the seed, as run_*.nc")
    paths = seeds.files(options.output, options.seeds)
    older = sum(path.exists() for path in paths)
    with progress.bar(options.seeds, "runs") as update:
        runs = list(seeds.run(scenario, paths, update))
    failed = [(path, found) for path, found in runs if found["status"] != FINISHED]
    print(scenario.title, f"{len(runs)} runs, seeds 1 to {len(runs)}", sep="\n")
    if failed:
        of = ", ".join(str(found["seed"]) for _, found in failed)
        print(f"{len(failed)} of {len(runs)} runs failed, of the seeds {of}: they count until then")
    came_of = [outcomes.of_run(found, found["seed"]) for _, found in runs]
    if limits := outcomes.limits(came_of):
        print("", *limits, sep="\n")
    _warn(came_of)
    over = f", {older} replace an older file" if older else ""
    print(f"\nwritten         {runs[0][0]} to {runs[-1][0]}{over}")
    print(f"to go on        kingpost statistics {options.output}")
    for path, found in failed:
        fail(f"{path}: {found['status']}", FAILED)
    return FAILED if failed else DONE

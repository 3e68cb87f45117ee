"""`kingpost run`: one run, or a run for each of many seeds."""

from __future__ import annotations

import argparse
import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..errors import KingpostError, RunError
from ..output import check as check_output
from ..results import units as results_units
from ..results.entries import limits_of, warnings_of
from ..results.files import check_patterns
from ..scenario import Scenario
from ..simulation.simulate import Simulation
from .common import (
    DONE,
    FAILED,
    INTERRUPTED,
    WARNING,
    add_output,
    add_scenario,
    fail,
    note,
    scenario_of,
    show,
    warn,
)
from .interrupts import finished_first

if TYPE_CHECKING:
    import xarray

    from ..simulation.seeds import OfSeed

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
    add_output(command)
    command.add_argument("--record", nargs="+", default=[], metavar="NAME",
                         help="columns to write, such as ship.roll or 'load.*' (default: all)")  # fmt: skip
    command.add_argument(
        "--units", choices=results_units.CHOICES, default=results_units.NAMES,
        help="of the numbers in a .csv or .parquet: si or engineering (deg, kN, t), with the unit in each "
        "column's name; names: SI units, and names alone (default)",
    )  # fmt: skip
    command.add_argument("--seeds", type=int, metavar="N",
                         help="N runs, seeds 1 to N; -o has * for the seed, as in run_*.nc; .nc files of the "
                         "same runs that exist already are kept")  # fmt: skip
    command.add_argument("--anew", action="store_true", help="with --seeds: repeat runs that have a file")


def run(options: argparse.Namespace) -> int:
    """Run, print the report, write the results."""
    from .. import progress, results
    from ..reports import outcomes, plot
    from ..reports.run import numbers

    _check_options(options)
    scenario = scenario_of(options)
    simulation = Simulation(scenario)
    warn(f"{WARNING}{words}" for words in simulation.model_warnings)
    if options.record:
        columns = results.dataset(scenario, simulation.channels, simulation.row()[None, :], "")
        check_patterns(columns, options.record)
        if _ending(options) in plot.ENDINGS:
            plot.check(columns, options.record)
    if options.seeds is not None:
        return _run_seeds(scenario, options)
    existed = options.output is not None and os.path.exists(options.output)
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
    # Write before printing: the reader of a pipe may close it.
    written: Path | None = None
    try:
        with finished_first():
            written = _write(recorded, output, options) if output else None
    except KeyboardInterrupt as error:
        if written is None:
            raise
        failure = error
    show(options, lambda: _report(recorded, scenario), lambda: numbers(recorded, scenario))
    warn(line for lines in outcomes.warnings(outcomes.of_runs([recorded])) for line in lines)
    if output:
        note(options, f"\nwritten         {written}{', replaces an older file' if existed else ''}")
    if isinstance(failure, KeyboardInterrupt):
        return fail(f"interrupted at {recorded['time'].values[-1]:g} s", INTERRUPTED)
    return fail(failure, FAILED) if failure else DONE


def _ending(options: argparse.Namespace) -> str:
    return Path(options.output or "").suffix.lower()


def _check_options(options: argparse.Namespace) -> None:
    """Refuse options that would have no effect, before anything is computed."""
    results_units.check_units(options.units, options.output or None)
    if options.anew and options.seeds is None:
        raise KingpostError("--anew: found no --seeds, allowed: with --seeds alone")


def _write(recorded: xarray.Dataset, output: Path, options: argparse.Namespace) -> Path:
    from .. import results
    from ..reports import plot

    if output.suffix.lower() in plot.ENDINGS:
        return plot.write(recorded, output, options.record)
    return results.write(recorded, output, options.record, options.units)


def _report(recorded: xarray.Dataset, scenario: Scenario) -> str:
    from ..reports import afloat, events, outcomes
    from ..reports.run import summary

    blocks = (events.events(recorded), outcomes.limits(outcomes.of_runs([recorded])))
    afterwards = afloat.text(recorded, scenario)
    said = [summary(recorded, scenario), *("\n".join(block) for block in blocks), afterwards]
    return "\n\n".join(block for block in said if block)


def _run_seeds(scenario: Scenario, options: argparse.Namespace) -> int:
    from .. import progress
    from ..reports import outcomes
    from ..simulation import seeds
    from ..simulation.batch import FINISHED

    if options.output is None:
        raise KingpostError("--seeds: found no -o, allowed: -o with * for the seed, as run_*.nc")
    paths = seeds.files(options.output, options.seeds)
    older = sum(map(os.path.exists, paths))
    with progress.bar(options.seeds, "runs") as update:
        found = seeds.run(scenario, paths, update, options.record, options.units, options.anew)
        runs = list(found)
    kept = sum(one.was_there for one in runs)
    failed = [one for one in runs if one.status != FINISHED]
    came_of = [outcomes.of_run(one.entries, one.seed) for one in runs]
    show(options, lambda: _of_seeds(scenario, runs), lambda: [_numbers_of(one) for one in runs])
    warn(line for lines in outcomes.warnings(came_of) for line in lines)
    over = f", {older - kept} replace an older file" if older > kept else ""
    note(options, f"\nwritten         {paths[0]} to {paths[-1]}{over}")
    if kept:
        note(options, f"kept            {kept} existing files of the same runs (--anew repeats them)")
    note(options, f"to go on        kingpost statistics {options.output}")
    for one in failed:
        fail(f"{one.path}: {one.status}", FAILED)
    return FAILED if failed else DONE


def _of_seeds(scenario: Scenario, runs: Sequence[OfSeed]) -> str:
    from ..reports import outcomes
    from ..simulation.batch import FINISHED

    lines = [scenario.title, f"{len(runs)} runs, seeds 1 to {len(runs)}"]
    failed = [str(one.seed) for one in runs if one.status != FINISHED]
    if failed:
        of = ", ".join(failed)
        lines.append(f"{len(failed)} of {len(runs)} runs failed, of the seeds {of}: they count until then")
    limits = outcomes.limits([outcomes.of_run(one.entries, one.seed) for one in runs])
    return "\n".join([*lines, *(["", *limits] if limits else [])])


def _numbers_of(one: OfSeed) -> dict[str, Any]:
    return {
        "file": str(one.path),
        "seed": one.seed,
        "status": one.status,
        "was_there": one.was_there,
        "limits": limits_of(one.entries),
        "warnings": warnings_of(one.entries),
    }

"""The command `kingpost`.

Exit codes: 0 done; 1 the run failed, what was computed is kept; 2 the input is wrong; 130 it was
interrupted (Ctrl-C, or the system asked it to end), what was computed is kept.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import signal
import sys
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NoReturn

from . import __version__
from .errors import KingpostError, RunError
from .hydro import command as hydro_command
from .output import check as check_output
from .output import write_csv
from .roll_damping import command as roll_damping_command
from .scenario import Scenario, load
from .simulate import Simulation
from .verify import command as verify_command

DONE, FAILED, WRONG_INPUT, INTERRUPTED = 0, 1, 2, 130


class Parser(argparse.ArgumentParser):
    """Reports a wrong command line in one line. An option has one spelling: `--seed` is not `--seeds`."""

    def __init__(self, **settings: Any) -> None:
        super().__init__(**{"allow_abbrev": False} | settings)

    def error(self, message: str) -> NoReturn:
        unknown = message.removeprefix("unrecognized arguments: ")
        if unknown != message and any(
            Path(name).suffix in (".nc", ".csv", ".parquet") for name in unknown.split()
        ):
            message += "; a shell puts the files that are there in the place of *: write 'run_*.nc' in quotes"
        self.exit(WRONG_INPUT, f"error: {message} (see {self.prog} --help)\n")


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit code."""
    options = parser().parse_args(arguments)
    try:
        with _ended_as_interrupted():
            return options.command(options)
    except RunError as error:
        return _fail(error, FAILED)
    except KingpostError as error:
        return _fail(error, WRONG_INPUT)
    except KeyboardInterrupt:
        return _fail("interrupted", INTERRUPTED)
    except BrokenPipeError:
        # The reader of a pipe left; keep Python from complaining about it at its end.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return DONE


@contextmanager
def _ended_as_interrupted() -> Iterator[None]:
    """Where the system, or a terminal that closes, ends the program, do as at Ctrl-C."""

    def interrupt(*_: object) -> NoReturn:
        raise KeyboardInterrupt

    if threading.current_thread() is not threading.main_thread():
        yield
        return
    ends = [getattr(signal, name) for name in ("SIGTERM", "SIGHUP") if hasattr(signal, name)]
    before = {end: signal.signal(end, interrupt) for end in ends if signal.getsignal(end) is signal.SIG_DFL}
    try:
        yield
    finally:
        for end, handler in before.items():
            signal.signal(end, handler)


def parser() -> argparse.ArgumentParser:
    """The command line's options."""
    top = Parser(prog="kingpost", description="Ships with cranes at sea by the moving frame method.")
    top.add_argument("--version", action="version", version=f"kingpost {__version__}")
    commands = top.add_subparsers(title="commands", metavar="COMMAND", required=True)

    run = commands.add_parser("run", help="simulate a scenario and print a summary")
    _add_scenario(run)
    run.add_argument(
        "-o",
        "--output",
        metavar="FILE",
        help="results: .nc, .csv or .parquet; .png, .svg or .pdf for a picture",
    )
    run.add_argument("--seeds", type=int, metavar="N",
                     help="N runs, of the seeds 1 to N; -o has * for them, as run_*.nc")  # fmt: skip
    run.set_defaults(command=_run)

    check = commands.add_parser("check", help="validate a scenario and print what the model is")
    _add_scenario(check)
    check.set_defaults(command=_check)

    modes = commands.add_parser("modes", help="settle a scenario and print its modes of small motion")
    _add_scenario(modes)
    modes.add_argument("-o", "--output", metavar="FILE", help="modes with their shapes: .nc or .csv")
    modes.add_argument("--sweep", metavar="name=from:to:n", help="n values of a parameter or a field")
    modes.add_argument("--all", action="store_true", help="those of the water's memory of radiated waves too")
    modes.set_defaults(command=_modes)

    rao = commands.add_parser("rao", help="response of ship and crane to regular waves")
    _add_scenario(rao)
    rao.add_argument(
        "-o", "--output", metavar="FILE", help="amplitudes and phases: .nc, .csv; .png for a picture"
    )
    rao.add_argument("--directions_deg", nargs="+", type=float, metavar="D",
                     help="that waves go to; 180 is a head sea at heading 0 (default: every 45)")  # fmt: skip
    rao.add_argument("--frequencies_rad_s", metavar="from:to:n", help="default: what all hulls' data cover")
    rao.add_argument("--points", nargs="+", metavar="NAME",
                     help="bodies and named points, as arm.tip (default: the main ones)")  # fmt: skip
    rao.add_argument("--displacement_raos", metavar="FILE",
                     help="the ship's own, as a file .csv that the joint moved_by_waves reads")  # fmt: skip
    rao.set_defaults(command=_rao)

    statistics = commands.add_parser("statistics", help="statistics and extremes of recorded runs")
    statistics.add_argument("files", nargs="+", metavar="FILE", help="results in NetCDF, one for each seed")
    statistics.add_argument("--after_s", type=float, metavar="T",
                            help="leave out what is before, s (default: the ramp of the waves)")  # fmt: skip
    statistics.add_argument("--channels", nargs="+", default=[], metavar="NAME",
                            help="columns, as ship.roll or 'load.*' (default: the main ones)")  # fmt: skip
    statistics.add_argument("-o", "--output", metavar="FILE", help="the table: .csv")
    statistics.set_defaults(command=_statistics)

    plot = commands.add_parser("plot", help="a picture of recorded runs over time")
    plot.add_argument("files", nargs="+", metavar="FILE", help="results in NetCDF")
    plot.add_argument("--channels", nargs="+", default=[], metavar="NAME",
                      help="columns, as ship.roll or 'load.*' (default: limits, the main ones)")  # fmt: skip
    plot.add_argument("-o", "--output", metavar="FILE", required=True, help="the picture: .png, .svg or .pdf")
    plot.set_defaults(command=_plot)

    gallery = commands.add_parser("list", help="list the gallery")
    gallery.set_defaults(command=_list)

    paper = commands.add_parser("paper", help="the paper's figures and tables, and the integrators")
    paper.add_argument("-o", "--output", metavar="DIR", default="paper-results",
                       help="folder to write (default: %(default)s)")  # fmt: skip
    paper.set_defaults(command=_paper)

    hydro = commands.add_parser("hydro", help="compute the hydrodynamic database of a hull")
    hydro_command.add_options(hydro)
    hydro.set_defaults(command=_hydro)

    roll = commands.add_parser("roll-damping", help="roll damping from a hull's sections or a decay test")
    roll_damping_command.add_options(roll)
    roll.set_defaults(command=_roll_damping)

    verify = commands.add_parser("verify", help="measure what is verified, now, and say whether it holds")
    verify_command.add_options(verify)
    verify.set_defaults(command=verify_command.command)

    serve = commands.add_parser("serve", help="serve the browser app")
    serve.add_argument("scenario", nargs="?", metavar="SCENARIO", help="a file or a gallery name")
    serve.add_argument("--port", type=int, metavar="N", help="port (default: 8000, or the next free)")
    serve.add_argument("--host", metavar="H", help="address to listen on (default: this machine only)")
    serve.add_argument("--check", action="store_true", help="start, fetch the app once, and end")
    serve.set_defaults(command=_serve)
    return top


def _add_scenario(command: argparse.ArgumentParser) -> None:
    command.add_argument("scenario", metavar="SCENARIO", help="a file or a gallery name")
    command.add_argument("--set", action="append", default=[], metavar="name=value",
                         help="set a parameter or a field; may be repeated")  # fmt: skip


def _scenario(options: argparse.Namespace) -> Scenario:
    from .engine import engine

    pairs = (engine.parse_assignment(assignment) for assignment in options.set)
    return load(options.scenario, {name: json.loads(value) for name, value in pairs})


def _run(options: argparse.Namespace) -> int:
    from . import afloat_report, event_report, outcome_report, plot, progress, report, results
    from .stable_step import warning

    scenario = _scenario(options)
    simulation = Simulation(scenario)
    if words := warning(simulation):
        print(f"warning: {words}", file=sys.stderr)
    if options.seeds is not None:
        return _run_seeds(scenario, options)
    existed = options.output is not None and Path(options.output).exists()
    endings = (*results.ENDINGS, *plot.ENDINGS)
    output = check_output(options.output, endings) if options.output is not None else None
    failure: RunError | KeyboardInterrupt | None = None
    with progress.bar(scenario.resolved["simulation"]["duration_s"], "s") as update:
        try:
            recorded = simulation.run(update)
        except (RunError, KeyboardInterrupt) as error:
            if getattr(error, "results", None) is None:
                raise
            failure, recorded = error, error.results
    print(report.summary(recorded, scenario))
    came_of = outcome_report.blocks(outcome_report.of_runs([recorded]))
    for block in [event_report.events(recorded), *came_of]:
        if block:
            print("", *block, sep="\n")
    if afloat := afloat_report.text(recorded, scenario):
        print(f"\n{afloat}\n")
    if output:
        over = ", in the place of an older file" if existed else ""
        write = plot.write if output.suffix.lower() in plot.ENDINGS else results.write
        print(f"written         {write(recorded, output)}{over}")
    if isinstance(failure, KeyboardInterrupt):
        return _fail(f"interrupted at {recorded['time'].values[-1]:g} s", INTERRUPTED)
    return _fail(failure, FAILED) if failure else DONE


def _run_seeds(scenario: Scenario, options: argparse.Namespace) -> int:
    from . import outcome_report, progress, seeds
    from .batch import FINISHED

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
    for block in outcome_report.blocks([outcome_report.of_run(found, found["seed"]) for _, found in runs]):
        print("", *block, sep="\n")
    over = f", {older} in the place of an older file" if older else ""
    print(f"\nwritten         {runs[0][0]} to {runs[-1][0]}{over}")
    print(f"to go on        kingpost statistics {options.output}")
    for path, found in failed:
        _fail(f"{path}: {found['status']}", FAILED)
    return FAILED if failed else DONE


def _check(options: argparse.Namespace) -> int:
    from . import model_report
    from .stable_step import warning

    scenario = _scenario(options)
    simulation = Simulation(scenario)
    print(model_report.text(scenario, simulation.coordinates))
    if words := warning(simulation):
        print(f"\nwarning: {words}")
    return DONE


def _modes(options: argparse.Namespace) -> int:
    from . import modes_report, vibration

    scenario = _scenario(options)
    output = check_output(options.output, vibration.ENDINGS) if options.output is not None else None
    sweep = vibration.parse_sweep(options.sweep) if options.sweep is not None else None
    found = vibration.modes(scenario, sweep=sweep)
    print(modes_report.text(found, options.all))
    if output:
        print(f"\nwritten  {vibration.write(found, output)}")
    return DONE


def _rao(options: argparse.Namespace) -> int:
    from . import displacement_raos, response, response_report

    scenario = _scenario(options)
    output = check_output(options.output, response.ENDINGS) if options.output is not None else None
    table = options.displacement_raos
    table = check_output(table, displacement_raos.ENDINGS) if table is not None else None
    found = response.rao(
        scenario,
        None if options.directions_deg is None else [math.radians(angle) for angle in options.directions_deg],
        None if options.frequencies_rad_s is None else response.parse_range(options.frequencies_rad_s),
        response.main_points(scenario) if options.points is None else options.points,
    )
    print(response_report.text(found))
    if output:
        print(f"\nwritten  {response.write(found, output)}")
    if table:
        print(f"\nwritten  {displacement_raos.write(found, table)}")
    return DONE


def _statistics(options: argparse.Namespace) -> int:
    from . import statistics_report

    output = check_output(options.output, (".csv",)) if options.output is not None else None
    runs = [statistics_report.read(path) for path in options.files]
    found = statistics_report.frame(runs, options.after_s, options.channels)
    print(statistics_report.text(runs, found, options.after_s))
    if output:
        write_csv(found, output)
        print(f"\nwritten  {output}")
    return DONE


def _plot(options: argparse.Namespace) -> int:
    from . import plot, statistics_report

    runs = [statistics_report.read(path) for path in options.files]
    print(f"written  {plot.write(runs, options.output, options.channels)}")
    return DONE


def _list(_options: argparse.Namespace) -> int:
    from . import gallery, report

    for line in report.table(((entry.name, entry.title) for entry in gallery.entries()), "<<"):
        print(line)
    return DONE


def _paper(options: argparse.Namespace) -> int:
    from . import paper

    return paper.command(options.output)


def _hydro(options: argparse.Namespace) -> int:
    hydro_command.run(options)
    return DONE


def _roll_damping(options: argparse.Namespace) -> int:
    roll_damping_command.run(options)
    return DONE


def _serve(options: argparse.Namespace) -> int:
    from . import serve

    return serve.command(options.scenario, options.port, options.host, options.check)


def _fail(error: object, code: int) -> int:
    sys.stdout.flush()
    print(f"error: {' '.join(str(error).split())}", file=sys.stderr)
    return code

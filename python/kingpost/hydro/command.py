"""`kingpost hydro HULL -o FILE`: compute or import the hydrodynamic database of a hull."""

from __future__ import annotations

import argparse
from pathlib import Path

from .. import progress
from ..errors import HydrodynamicsError, flag
from . import attitude_command, demand, import_command, importers, resolution, several_command
from .build import FREQUENCIES, MOST_PANELS, PANELS, build, choose_lid, default_frequencies
from .command_output import fitted, print_demand, warn, warned_of
from .database import Database, Water
from .database_file import check_output
from .hull_options import (
    SHAPES,
    count_of,
    hull_of,
    is_parametric,
    parse_frequencies,
    parse_loading,
    water_of,
)
from .partial import ENDING, Partial
from .several import SeveralHulls
from .solve import capytaine
from .summary import summary

OF_A_HULL = (
    "frequencies_rad_s", "directions", "panels", "lid", "loading", "flip_normals", *attitude_command.OPTIONS
)  # fmt: skip


def add_options(command: argparse.ArgumentParser) -> None:
    """The command's options."""
    command.add_argument("hull", metavar="HULL", nargs="+", help=(
        "a mesh file (STL, OBJ, GDF or another format of meshio), another program's database "
        f"({importers.KINDS}), or a parametric hull such as "
        f"box:length_m=20,beam_m=10,draught_m=2,depth_m=5; of {', '.join(SHAPES)}; several hulls, each with "
        "its --at, are solved together"))  # fmt: skip
    several_command.add_options(command)
    command.add_argument("-o", "--output", metavar="FILE", required=True, help="database, NAME.hydro.json")
    command.add_argument("--title", metavar="TEXT", help="title of the database (default: the hull)")
    command.add_argument("--frequencies-rad-s", metavar="F", help=(
        f"from:to:n or a list a,b,c (default: {FREQUENCIES} frequencies for the hull's size)"))  # fmt: skip
    command.add_argument("--directions", metavar="N", type=int, help=(
        "number of wave directions on the circle; N resolve waves of 2 pi L / N and more (default: what the "
        "hull's length L and the shortest wave asked for need, "
        f"in steps of {resolution.STEP} from {resolution.FEWEST} to {resolution.MOST})"))  # fmt: skip
    command.add_argument("--panels", metavar="N", type=int,
                         help=f"approximate number of panels, wetted hull (default: {PANELS})")  # fmt: skip
    command.add_argument("--draught-m", metavar="T", type=float,
                         help="draught of a mesh file's hull (default: the water is at z = 0)")  # fmt: skip
    command.add_argument("--water-depth-m", metavar="H", type=float, help="water depth (default: infinite)")
    command.add_argument("--density-kg-m3", metavar="RHO", type=float,
                         help=f"density of the water (default: {Water.density_kg_m3:g})")  # fmt: skip
    command.add_argument("--lid", action=argparse.BooleanOptionalAction, default=None,
                         help="lid against irregular frequencies (default: if deep enough)")  # fmt: skip
    command.add_argument("--loading", metavar="L", help=(
        "loading of the hull, to compute its mean drift: kg_m=,roll_gyration_m=,pitch_gyration_m=,"
        "yaw_gyration_m=, and roll_damping_ratio= (default: 0.05 of the critical)"))  # fmt: skip
    attitude_command.add_options(command)
    command.add_argument(
        "--flip-normals", action="store_true", default=None, help="reverse the normals of a mesh file"
    )
    command.add_argument(
        "--highest-rad-s", metavar="W", type=float,
        help="leave out frequencies above it: for another program's file from all data, for a hull's "
        "computed data from the fit of the memory",
    )  # fmt: skip
    command.add_argument(
        "--accept-fit", action="store_true",
        help="if no fit of the memory meets 2 %%, take the best one and list the motions that miss the limit",
    )  # fmt: skip
    import_command.add_options(command)


def run(options: argparse.Namespace) -> Database | SeveralHulls:
    """Run with the options, print a summary and return the database."""
    if len(options.hull) > 1:
        return several_command.run(options)
    several_command.refuse(options)
    return run_one(argparse.Namespace(**{**vars(options), "hull": options.hull[0]}))


def run_one(options: argparse.Namespace) -> Database:
    """Run for one hull."""
    # Quick checks come before the computation, which takes minutes.
    target = check_output(options.output)
    if not is_parametric(options.hull) and importers.recognise(options.hull) is not None:
        _refuse_for_a_file(options)
        imported = import_command.run(options)
        warnings = resolution.of_database(imported)
        warn(warnings)
        return fitted(warned_of(imported, warnings), options, target, import_command.RESPONSE_SHARE)
    import_command.refuse(options)
    water = water_of(options)
    given = options.frequencies_rad_s
    frequencies = None if given is None else parse_frequencies(given)
    loading = None if options.loading is None else parse_loading(options.loading)
    directions = count_of("directions", options.directions, (4, 360))
    hull = hull_of(options, count_of("panels", options.panels, (50, 4 * MOST_PANELS)) or PANELS)
    capytaine()
    if frequencies is None:
        frequencies = default_frequencies(hull, water)
    length_m = hull.particulars.length_m
    directions = directions or resolution.default_directions(length_m, float(frequencies[-1]), water)
    print(summary(hull, water))
    print(f"{'wave directions':<20}{directions}")
    warnings = [*hull.remarks, *resolution.warnings(length_m, frequencies, directions, water)]
    warn(warnings)
    every = len(frequencies) + 1
    partial = _partial(target, every)
    has_lid, _ = choose_lid(hull, options.lid)
    warn(print_demand(demand.size(hull, has_lid, water, frequencies, directions)))
    with progress.bar(every, "frequencies") as update:
        title = options.title or hull.source
        database = build(hull, water, title, frequencies, directions, options.lid, loading, update, partial)
    database = fitted(warned_of(database, warnings), options, target)
    partial.done()
    return database


def _refuse_for_a_file(options: argparse.Namespace) -> None:
    """Refuse options of the computation for a file of another program."""
    for name in OF_A_HULL:
        if getattr(options, name) is not None:
            allowed = "a hull that is computed; another program's results are taken unchanged"
            raise HydrodynamicsError(flag(name), options.hull, allowed)


def _partial(target: Path, every: int) -> Partial:
    """Continue a stopped run and print a line about it."""
    left = f"of {every} frequencies are solved by the stopped run"
    return Partial(
        target.with_name(target.name + ENDING), lambda done: print(f"{'goes on':<20}{done} {left}")
    )

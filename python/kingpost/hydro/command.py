"""`kingpost hydro HULL -o FILE`: compute or import the hydrodynamic database of a hull."""

from __future__ import annotations

import argparse
import math
import os
from dataclasses import MISSING, fields, replace
from pathlib import Path

import numpy as np

from .. import progress
from ..errors import HydrodynamicsError, flag
from . import attitude_command, demand, import_command, importers, inclined, resolution, several_command
from .build import FREQUENCIES, MOST_PANELS, PANELS, build, choose_lid, default_frequencies
from .checks import check_water
from .database import Database, Provenance, Radiation, Water
from .database_file import One, check_output, rounded, write
from .drift import Loading
from .fit_data import FEWEST_FREQUENCIES
from .hull_files import HullFile
from .meshes import HullMeshes, parametric
from .partial import ENDING, Partial
from .radiation_fit import LIMIT, Misfit, fit, misfits
from .several import SeveralHulls
from .shapes import Box, Hemisphere, Shape, Sphere, Wigley
from .solve import capytaine
from .summary import summary
from .vessel import OffshoreVessel

SHAPES: dict[str, type[Shape]] = {
    "box": Box,
    "wigley": Wigley,
    "sphere": Sphere,
    "hemisphere": Hemisphere,
    "offshore_vessel": OffshoreVessel,
}
MOST_FREQUENCIES = 500
MOST_FIT_ERROR = 0.25
"""Largest error of a written fit of the memory, as a share of its peak: the heave amplitude at resonance has
at least the same error."""
NEXT_CUT = 0.85
"""Ratio of successive upper frequencies that are tried for the advice; each needs one fit."""
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
    partial = partial_of(target, every)
    has_lid, _ = choose_lid(hull, options.lid)
    warn(print_demand(demand.size(hull, has_lid, water, frequencies, directions)))
    with progress.bar(every, "frequencies") as update:
        title = options.title or hull.source
        database = build(hull, water, title, frequencies, directions, options.lid, loading, update, partial)
    database = fitted(warned_of(database, warnings), options, target)
    partial.done()
    return database


def partial_of(target: Path, every: int) -> Partial:
    """Continue a stopped run and print a line about it."""
    left = f"of {every} frequencies are solved by the stopped run"
    return Partial(
        target.with_name(target.name + ENDING), lambda done: print(f"{'goes on':<20}{done} {left}")
    )


def print_demand(run: demand.Size) -> list[str]:
    """Print the size of the computation before it starts; warn if the machine has too little memory."""
    threads = os.environ.get("OMP_NUM_THREADS") or os.cpu_count()
    lid = f", {run.lid_panels} of them a lid," if run.lid_panels else ""
    print(f"{'to be solved':<20}{run.panels} panels{lid} for 1 frequency at a time, {threads} threads")
    needed, matrix = demand.process_bytes(run), run.matrix_bytes
    print(f"{'memory':<20}{needed / 1e9:.3g} GB at most, whole process; {matrix / 1e6:.3g} MB a matrix")
    there = demand.machine_bytes()
    if there is not None and needed > there:
        return [f"this machine has {there / 1e9:.3g} GB of memory: use fewer panels"]
    return []


def fitted(database: One, options: argparse.Namespace, target: Path, response_share: float = 1.0) -> One:
    """Fit the memory, print its errors and write the database."""
    database = rounded(database)
    with progress.bar(1.0, "memory") as update:
        radiation = fit(
            database,
            highest_rad_s=options.highest_rad_s,
            accept=options.accept_fit,
            response_share=response_share,
            progress=update,
        )
    found = misfits(database, radiation, highest_rad_s=options.highest_rad_s)
    if radiation.fit_error > MOST_FIT_ERROR:
        raise HydrodynamicsError(
            "radiation",
            f"a memory fitted to {radiation.fit_error:.0%} of its peak",
            f"at most {MOST_FIT_ERROR:.0%}: with more it is no memory of this hull; {_cut(database, found)}",
        )
    print(f"{'memory of the water':<20}{_states(radiation)} states, fitted to {radiation.fit_error:.2%}")
    for one in found:
        print(
            f"{'  ' + one.motion:<20}{one.memory:.2%} of K, {one.added_mass:.2%} of A, {one.damping:.2%} of B"
        )
    missed = [_missed(one) for one in found if one.memory > LIMIT]
    warn(missed)
    database = replace(warned_of(database, missed), radiation=radiation)
    print(f"{'written':<20}{write(database, target)}")
    return database


def warned_of(database: One, warnings: list[str]) -> One:
    """Return the database with additional warnings, which are repeated at every use of it."""
    about: Provenance = database.provenance
    return replace(database, provenance=replace(about, warnings=(*about.warnings, *warnings)))


def _cut(database: Database | SeveralHulls, found: list[Misfit]) -> str:
    """Advice on the highest frequency up to which the memory can be fitted, if there is one."""
    omega = database.frequencies_rad_s
    cut = max(found, key=lambda one: one.memory).frequency_rad_s
    best: tuple[float, float] | None = None
    while (kept := omega[omega < cut]).size >= FEWEST_FREQUENCIES:
        cut = float(kept[-1])
        error = fit(database, highest_rad_s=cut, accept=True).fit_error
        if best is None or error < best[0]:
            best = error, cut
        if error <= LIMIT:
            break
        cut *= NEXT_CUT
    if best is None or best[0] > MOST_FIT_ERROR:
        return "compute the hull again, with a lid and more panels"
    error, cut = best
    return (
        f"above {cut:.4g} rad/s waves may be too short for the panels, or irregular frequencies lie there: "
        f"with {flag('highest_rad_s')} {cut:.4g} it is {error:.2%}"
    )


def _missed(one: Misfit) -> str:
    coupling = f", coupled with {one.coupled_with}," if one.coupled_with else ""
    return (
        f"the memory of {one.motion}{coupling} is fitted to {one.memory:.2%} only, at "
        f"{one.frequency_rad_s:.4g} rad/s "
        f"({one.added_mass:.1%} of its added mass, {one.damping:.1%} of its damping)"
    )


def warn(warnings: list[str]) -> None:
    """Print warnings."""
    for warning in warnings:
        print(f"warning: {warning}")


def _states(radiation: Radiation) -> int:
    """Real states of the fit: one for a real pole, two for a complex one."""
    return sum(int(np.where(mode.poles_rad_s.imag > 0, 2, 1).sum()) for mode in radiation.modes)


def water_of(options: argparse.Namespace) -> Water:
    """The water of the options."""
    for name in ("density_kg_m3", "water_depth_m"):
        value = getattr(options, name)
        if value is not None and not (math.isfinite(value) and value > 0):
            raise HydrodynamicsError(flag(name), f"{value:g}", "a number greater than 0")
    given = options.density_kg_m3
    water = Water(Water.density_kg_m3 if given is None else given, depth_m=options.water_depth_m)
    check_water(water)
    return water


def count_of(name: str, given: int | None, limits: tuple[int, int]) -> int | None:
    """Check a count within limits."""
    if given is not None and not limits[0] <= given <= limits[1]:
        raise HydrodynamicsError(flag(name), str(given), f"a whole number from {limits[0]} to {limits[1]}")
    return given


def _refuse_for_a_file(options: argparse.Namespace) -> None:
    """Refuse options of the computation for a file of another program."""
    for name in OF_A_HULL:
        if getattr(options, name) is not None:
            allowed = "a hull that is computed; another program's results are taken unchanged"
            raise HydrodynamicsError(flag(name), options.hull, allowed)


def parse_frequencies(text: str) -> np.ndarray:
    """Frequencies from ``from:to:n`` or ``a,b,c``, at least as many as the fit of the memory needs.

    >>> parse_frequencies("0.5:2.25:8")
    array([0.5 , 0.75, 1.  , 1.25, 1.5 , 1.75, 2.  , 2.25])
    """
    allowed = (
        f"from:to:n such as 0.1:3:30, or a list a,b,c,...; {FEWEST_FREQUENCIES} to {MOST_FREQUENCIES}, "
        "increasing and greater than 0"
    )
    try:
        if ":" in text:
            start, end, count = text.split(":")
            with np.errstate(all="ignore"):
                found = np.linspace(float(start), float(end), min(int(count), MOST_FREQUENCIES + 1))
        else:
            found = np.array([float(part) for part in text.split(",")])
    except (ValueError, MemoryError):
        raise HydrodynamicsError("--frequencies-rad-s", repr(text), allowed) from None
    fits = FEWEST_FREQUENCIES <= len(found) <= MOST_FREQUENCIES
    if not fits or not np.isfinite(found).all() or found[0] <= 0 or (np.diff(found) <= 0).any():
        raise HydrodynamicsError("--frequencies-rad-s", repr(text), allowed)
    return found


def is_parametric(hull: str) -> bool:
    """Whether a hull is given as a parametric description, whose last number may look like a file's
    ending."""
    return (hull.partition(":")[0] in SHAPES or "=" in hull) and not os.path.isfile(hull)


def hull_of(options: argparse.Namespace, panels: int) -> HullMeshes:
    """The hull of the options: a mesh file or a parametric hull."""
    if os.path.isfile(options.hull):
        file = HullFile(Path(options.hull), options.draught_m, bool(options.flip_normals))
        upright = file.meshes(panels)
        asked = attitude_command.parse(options, upright.particulars)
        return upright if asked is None else inclined.of_file(file, upright, panels, asked)
    if not is_parametric(options.hull):
        kinds = ", ".join(SHAPES)
        allowed = f"a mesh file, or a parametric hull: {kinds}"
        raise HydrodynamicsError("hull", "no such file", allowed, options.hull)
    if options.draught_m is not None:
        allowed = "a mesh file; a parametric hull has its own draught"
        raise HydrodynamicsError("--draught-m", "a parametric hull", allowed)
    shape = parse_shape(options.hull)
    upright = parametric(shape, options.hull, panels)
    asked = attitude_command.parse(options, upright.particulars)
    return upright if asked is None else inclined.of_shape(shape, upright, panels, asked)


def parse_shape(text: str) -> Shape:
    """A parametric hull from its description.

    >>> parse_shape("sphere:radius_m=5")
    Sphere(radius_m=5.0)
    """
    kind, _, description = text.partition(":")
    if kind not in SHAPES:
        raise HydrodynamicsError("hull", repr(kind), f"one of {', '.join(SHAPES)}")
    return SHAPES[kind](**_values(SHAPES[kind], description, "hull", f"{kind}:"))


def parse_loading(text: str) -> Loading:
    """A loading condition from its description.

    >>> parse_loading("kg_m=2.5,roll_gyration_m=3,pitch_gyration_m=6,yaw_gyration_m=6").kg_m
    2.5
    """
    return Loading(**_values(Loading, text, "--loading", ""))


def _values(kind: type, description: str, field: str, start: str) -> dict[str, float]:
    """Numbers ``name=value,...`` for the fields of a data class; fields without a default are required."""
    names = [each.name for each in fields(kind)]
    form = start + ",".join(f"{name}=..." for name in names)
    values: dict[str, float] = {}
    for assignment in filter(None, description.split(",")):
        name, _, value = (part.strip() for part in assignment.partition("="))
        if name not in names or name in values:
            found = "given twice" if name in values else "an unknown dimension"
            raise HydrodynamicsError(f"{field}.{name}", found, form)
        try:
            values[name] = float(value)
        except ValueError:
            raise HydrodynamicsError(f"{field}.{name}", repr(value), "a number") from None
    missing = [each.name for each in fields(kind) if each.default is MISSING and each.name not in values]
    if missing:
        raise HydrodynamicsError(field, f"no {missing[0]}", form)
    return values

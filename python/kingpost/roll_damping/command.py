"""`kingpost roll-damping`: damping forces of a scenario, from a hull's sections or from a decay test."""

from __future__ import annotations

import argparse
import math
from pathlib import Path

from ..errors import RollDampingError, flag
from ..hydro.database_file import ENDING, read
from ..output import check as check_output
from ..output import write_text
from . import report
from .bilge_keels import BilgeKeels
from .coefficients import Coefficients, fragment
from .cutting import STATIONS
from .decay import MODELS, DecayFit, from_decay
from .eddies import SHARPNESS
from .hulls import sections_of
from .ikeda import AMPLITUDES_DEG, SEA_WATER_KG_M3, SEA_WATER_M2_S, from_sections
from .radiated import radiated
from .record import DecayRecord

ENDINGS = (".yaml", ".yml")
KEELS = ("breadth_m", "length_m", "centre_m")
LARGEST = 1e15
"""Largest mass, inertia or height: squares of larger numbers overflow."""


def add_options(command: argparse.ArgumentParser) -> None:
    """The two subcommands and their options."""
    ways = command.add_subparsers(title="ways", metavar="WAY", required=True)
    sections = ways.add_parser("sections", help="by Ikeda's method, from the sections of a hull")
    _add_sections(sections)
    sections.set_defaults(way=of_sections)
    decay = ways.add_parser("decay", help="from the record of a decay test")
    _add_decay(decay)
    decay.set_defaults(way=of_decay)
    for way in (sections, decay):
        way.add_argument(
            "--body", metavar="NAME", default="ship", help="the hull in the scenario (default: ship)"
        )
        way.add_argument("-o", "--output", metavar="FILE", help="the forces of a scenario: .yaml")


def _add_sections(way: argparse.ArgumentParser) -> None:
    way.add_argument("hull", metavar="HULL", help=(
        "a table of sections .csv (x_m,beam_m,draught_m,area_m2 or area_coefficient, bilge_radius_m), a "
        f"database {ENDING} with its hull's mesh, a mesh file, or a parametric hull as `kingpost hydro` "
        "takes it"))  # fmt: skip
    way.add_argument("--kg-m", metavar="KG", type=float, required=True,
                     help="centre of gravity, and the roll axis, above the keel")  # fmt: skip
    way.add_argument("--period-s", metavar="T", type=float, required=True, help="of the roll")
    usual = ", ".join(f"{angle:g}" for angle in AMPLITUDES_DEG)
    way.add_argument("--amplitudes-deg", metavar="A", type=float, nargs="+", default=list(AMPLITUDES_DEG),
                     help=f"of the roll (default: {usual})")  # fmt: skip
    way.add_argument("--bilge-keels", metavar="K", help=(
        "breadth_m=,length_m= of each, and centre_m= along the ship (default: its middle)"))  # fmt: skip
    way.add_argument("--speed-m-s", metavar="U", type=float, default=0.0, help="forward speed (default: 0)")
    way.add_argument("--draught-m", metavar="D", type=float,
                     help="draught of a mesh file's hull (default: the water is at z = 0)")  # fmt: skip
    way.add_argument("--sharpness", choices=SHARPNESS, default=SHARPNESS[0], help=(
        "measure of the bilges in the eddies: their radius or, as the formula is printed, the area of the "
        "section (default: %(default)s)"))  # fmt: skip
    way.add_argument("--stations", metavar="N", type=int, default=STATIONS,
                     help="sections that a mesh is cut into (default: %(default)s)")  # fmt: skip
    way.add_argument("--density-kg-m3", metavar="RHO", type=float, default=SEA_WATER_KG_M3,
                     help="density of the water (default: %(default)g)")  # fmt: skip
    way.add_argument("--viscosity-m2-s", metavar="NU", type=float, default=SEA_WATER_M2_S,
                     help="kinematic viscosity of the water (default: %(default)g)")  # fmt: skip


def _add_decay(way: argparse.ArgumentParser) -> None:
    way.add_argument("record", metavar="FILE", help="time_s and roll_deg or roll_rad: .csv")
    way.add_argument("--column", metavar="NAME", help="column of the roll, if there are several")
    way.add_argument("--model", choices=tuple(MODELS), default="quadratic",
                     help="the highest term of the damping (default: %(default)s)")  # fmt: skip
    way.add_argument("--after-s", metavar="T", type=float,
                     help="leave out earlier records, s (default: from the largest angle on)")  # fmt: skip
    way.add_argument("--until-s", metavar="T", type=float, help="leave out later records, s")
    way.add_argument("--inertia-kg-m2", metavar="I", type=float, help="roll inertia, with added inertia")
    way.add_argument(
        "--mass-kg", metavar="M", type=float, help="with --gm-m: the inertia is m g GM / omega^2"
    )
    way.add_argument("--gm-m", metavar="GM", type=float, help="metacentric height")
    way.add_argument("--database", metavar="FILE", help=(
        f"the hull's {ENDING}: its radiation damping is left out of the scenario's forces"))  # fmt: skip
    way.add_argument(
        "--kg-m", metavar="KG", type=float, help="with --database: centre of gravity above the keel"
    )


def run(options: argparse.Namespace) -> None:
    """Print the tables and the forces of a scenario, and write the forces."""
    output = check_output(options.output, ENDINGS) if options.output is not None else None
    text = options.way(options)
    if text is None:
        return
    print(f"\n{text}", end="")
    if output is not None:
        write_text(output, text)
        print(f"\nwritten  {output}")


def of_sections(options: argparse.Namespace) -> str:
    """Print Ikeda's components; the forces as text."""
    keels = None if options.bilge_keels is None else parse_keels(options.bilge_keels)
    hull = sections_of(options.hull, options.draught_m, options.stations)
    amplitudes = [math.radians(angle) for angle in options.amplitudes_deg]
    found = from_sections(hull, options.kg_m, options.period_s, amplitudes, keels, options.speed_m_s,
                          options.density_kg_m3, options.viscosity_m2_s, options.sharpness)  # fmt: skip
    print(report.hull(hull, options.hull, options.kg_m))
    print(f"\n{report.components(found)}\n")
    print(report.second_opinion(hull, found, keels))
    if "warning" in found.attrs:
        print(f"warning: {found.attrs['warning']}")
    if str(options.hull).endswith(ENDING):
        waves = radiated(read(options.hull), options.kg_m, found.attrs["frequency_rad_s"])[1]
        print(f"radiated waves add {waves:.4g} N m s, by the database")
    of_what = f"roll of {Path(options.hull).name} at {options.period_s:g} s"
    title = f"{of_what} by Ikeda's method, without radiated waves"
    return fragment(Coefficients(float(found.linear), float(found.quadratic)), options.body, title)


def of_decay(options: argparse.Namespace) -> str | None:
    """Print the results of a decay test; return the forces as text if the inertia is known."""
    _check(options)
    record = DecayRecord.read(options.record, options.column)
    found = from_decay(record, options.model, options.after_s, options.until_s)
    inertia = _inertia(options, found)
    waves = _waves(options, found)
    print(report.decay(found, Path(options.record).name, inertia))
    if inertia is None:
        print("\nfor the forces of a scenario: --inertia-kg-m2, or --mass-kg and --gm-m")
        return None
    without = ""
    if options.database is not None:
        print(f"radiated waves are {waves:.4g} N m s of it, by the database; the forces have the rest")
        without = ", without radiated waves"
    forces = found.for_scenario(inertia, waves)
    print(report.of_forces(found, forces, inertia, waves))
    title = f"roll decay {Path(options.record).name}, {found.period_s:.4g} s{without}"
    return fragment(forces, options.body, title)


def _check(options: argparse.Namespace) -> None:
    """Refuse incompatible options, before the fit."""
    by_height = options.mass_kg is not None or options.gm_m is not None
    if options.inertia_kg_m2 is not None and by_height:
        raise RollDampingError("--inertia-kg-m2", "--mass-kg or --gm-m too", "one or the other")
    for pair in (("mass_kg", "gm_m"), ("database", "kg_m")):
        missing = [name for name in pair if getattr(options, name) is None]
        if len(missing) == 1:
            raise RollDampingError(flag(missing[0]), "none", f"{flag(pair[0])} and {flag(pair[1])} together")
    for name in ("inertia_kg_m2", "mass_kg", "gm_m", "kg_m"):
        value = getattr(options, name)
        if value is not None and not 0 < value <= LARGEST:
            raise RollDampingError(flag(name), f"{value:g}", f"a number greater than 0, up to {LARGEST:g}")
    if options.output is not None and options.inertia_kg_m2 is None and not by_height:
        allowed = "--inertia-kg-m2, or --mass-kg and --gm-m: forces need the inertia"
        raise RollDampingError("--output", "no inertia", allowed)


def _inertia(options: argparse.Namespace, found: DecayFit) -> float | None:
    if options.mass_kg is not None:
        return found.inertia_kg_m2(options.mass_kg, options.gm_m)
    return options.inertia_kg_m2


def _waves(options: argparse.Namespace, found: DecayFit) -> float:
    if options.database is None:
        return 0.0
    return radiated(read(options.database), options.kg_m, found.frequency_rad_s)[1]


def parse_keels(text: str) -> BilgeKeels:
    """Bilge keels from their description.

    >>> parse_keels("breadth_m=0.4,length_m=30")
    BilgeKeels(breadth_m=0.4, length_m=30.0, centre_m=None)
    """
    form = "breadth_m=...,length_m=... and, if not the ship's middle, centre_m=..."
    values: dict[str, float] = {}
    for assignment in filter(None, text.split(",")):
        name, _, value = assignment.partition("=")
        if name not in KEELS or name in values:
            raise RollDampingError("--bilge-keels", repr(assignment), form)
        try:
            values[name] = float(value)
        except ValueError:
            raise RollDampingError(f"--bilge-keels {name}", repr(value), "a number") from None
    if not {"breadth_m", "length_m"} <= values.keys():
        raise RollDampingError("--bilge-keels", repr(text), form)
    return BilgeKeels(**values)

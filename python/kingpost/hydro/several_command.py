"""`kingpost hydro HULL HULL ... --at X_M,Y_M,HEADING_DEG ... -o FILE`: the database of several hulls."""

from __future__ import annotations

import argparse
import math
import os
import re
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .. import progress
from ..errors import HydrodynamicsError, flag
from . import attitude_command, demand, import_command, importers, resolution
from .build import MOST_PANELS, PANELS, choose_lid
from .command_output import fitted, print_demand, warn, warned_of
from .database_file import check_output
from .hull_options import count_of, hull_of, is_parametric, parse_frequencies, water_of
from .partial import ENDING, Partial
from .several import Place, SeveralHulls
from .several_build import (
    ADDED,
    QUICK,
    build_several,
    check_count,
    check_members,
    extent_m,
    gap_warnings,
    several_directions,
    several_frequencies,
)
from .several_mesh import Cluster, Member
from .several_solve import MOST_ADDED, ClusterFlow, solved_directions
from .solve import capytaine
from .summary import summary

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .database import Water
    from .meshes import HullMeshes

OF_SEVERAL = ("at", "name")
OF_ONE = ("loading", *attitude_command.OPTIONS)
"""Options that several hulls do not have."""
RESPONSE_SHARE = 0.5
"""Error of the motions of free hulls that the fit of the memory aims for, over its limit: 1 % of their
peaks, with other damping of 5 % of the critical."""
FARTHEST_M = 1e5


def add_options(command: argparse.ArgumentParser) -> None:
    """Options of several hulls."""
    command.add_argument("--at", metavar="X_M,Y_M,HEADING_DEG", action="append", help=(
        "place of a hull that is solved together with others, once for each, in their order: its origin, and "
        "its heading counter-clockwise from x; write --at=-5,0,0 for a place that begins with a minus"
    ))  # fmt: skip
    command.add_argument("--name", metavar="NAME", action="append", help=(
        "name of a hull that is solved together with others, once for each (default: its file or shape)"
    ))  # fmt: skip


def refuse(options: argparse.Namespace) -> None:
    """Refuse options of several hulls for one."""
    for name in OF_SEVERAL:
        if getattr(options, name, None):
            raise HydrodynamicsError(flag(name), "one hull", "several hulls, one --at for each")


def run(options: argparse.Namespace) -> SeveralHulls:
    """Run with the options, print a summary and return the database."""
    target = check_output(options.output)
    for name in OF_ONE:
        if getattr(options, name) is not None:
            raise HydrodynamicsError(flag(name), "several hulls", "one hull")
    import_command.refuse(options)
    water = water_of(options)
    given = options.frequencies_rad_s
    frequencies = None if given is None else parse_frequencies(given)
    directions = count_of("directions", options.directions, (4, 360))
    panels = count_of("panels", options.panels, (50, 4 * MOST_PANELS)) or PANELS
    members = _members(options, panels)
    capytaine()
    check_members(members, water)
    every_one = several_frequencies(members, water) if frequencies is None else frequencies
    highest = float(every_one[-1])
    directions = directions or several_directions(members, highest, water)
    for one in members:
        print(f"{one.name}\n{'place':<20}{one.place.described}\n{summary(one.hull, water)}\n")
    print(f"{'wave directions':<20}{directions}")
    warnings = [f"{one.name}: {remark}" for one in members for remark in one.hull.remarks]
    warnings += [*gap_warnings(members, highest, water), *_unresolved(members, every_one, directions, water)]
    warn(warnings)
    every = _announce(options, members, water, every_one, directions, refine=frequencies is None)
    solved = "frequencies, infinity among them, are solved by the stopped run"
    partial = Partial(
        target.with_name(target.name + ENDING), lambda done: print(f"{'goes on':<20}{done} {solved}")
    )
    title = options.title or " and ".join(one.name for one in members)
    with progress.bar(every, "frequencies") as update:
        database = build_several(members, water, title, frequencies, directions, options.lid, update, partial)
    for note in database.provenance.notes:
        if note.startswith((ADDED, QUICK)):
            print(f"{'frequencies':<20}{len(database.frequencies_rad_s)}: {note}")
    database = fitted(warned_of(database, warnings), options, target, RESPONSE_SHARE)
    partial.done()
    return database


def _members(options: argparse.Namespace, panels: int) -> list[Member]:
    places, names = _places(options), _names(options)
    found = []
    for name, place, text in zip(names, places, options.hull, strict=True):
        found.append(Member(name, place, _hull(options, text, panels)))
    return found


def _hull(options: argparse.Namespace, text: str, panels: int) -> HullMeshes:
    shape = is_parametric(text)
    if not shape and importers.recognise(text) is not None:
        found, allowed = "another program's results", "a hull that is computed: its mesh or a parametric hull"
        raise HydrodynamicsError("hull", found, allowed, text)
    # A draught is that of the mesh files among the hulls.
    draught = None if shape else options.draught_m
    return hull_of(argparse.Namespace(**{**vars(options), "hull": text, "draught_m": draught}), panels)


def _places(options: argparse.Namespace) -> list[Place]:
    given = options.at or []
    if len(given) != len(options.hull):
        allowed = f"{len(options.hull)}, one for each hull: X_M,Y_M,HEADING_DEG"
        raise HydrodynamicsError("--at", f"{len(given)} places", allowed)
    return [parse_place(text) for text in given]


def parse_place(text: str) -> Place:
    """A place from its description.

    >>> parse_place("10,-3,180")
    Place(x_m=10.0, y_m=-3.0, heading_rad=3.141592653589793)
    """
    allowed = f"X_M,Y_M,HEADING_DEG such as 0,13,180, within {FARTHEST_M:g} m and 360 degrees"
    try:
        x, y, heading = (float(part) for part in text.split(","))
    except ValueError:
        raise HydrodynamicsError("--at", repr(text), allowed) from None
    if not (abs(x) <= FARTHEST_M and abs(y) <= FARTHEST_M and abs(heading) <= 360):
        raise HydrodynamicsError("--at", repr(text), allowed)
    return Place(x, y, math.radians(heading))


def _names(options: argparse.Namespace) -> list[str]:
    """The names given, or those of the files or shapes, made unique."""
    if options.name:
        if len(options.name) != len(options.hull):
            allowed = f"{len(options.hull)}, one for each hull"
            raise HydrodynamicsError("--name", f"{len(options.name)} names", allowed)
        return options.name
    found: list[str] = []
    for text in options.hull:
        stem = plain_name(Path(text).stem if os.path.isfile(text) else text.partition(":")[0])
        number = 1 + sum(one == stem or one.startswith(f"{stem}_") for one in found)
        found.append(stem if number == 1 else f"{stem}_{number}")
    return found


def plain_name(text: str) -> str:
    """A name for a hull that scenarios can use, from that of a file.

    >>> plain_name("Barge-A 300 ft"), plain_name("2nd_boat")
    ('barge_a_300_ft', 'hull_2nd_boat')
    """
    found = re.sub("[^a-z0-9]+", "_", text.lower()).strip("_")
    return found if found[:1].isalpha() else f"hull_{found}".rstrip("_")


def _unresolved(
    members: list[Member], frequencies: NDArray[np.float64], directions: int, water: Water
) -> list[str]:
    return resolution.warnings(extent_m(members), frequencies, directions, water)


def _announce(
    options: argparse.Namespace, members: list[Member], water: Water, frequencies: NDArray[np.float64],
    directions: int, refine: bool,
) -> int:  # fmt: skip
    """Print memory and minutes; return the number of frequencies, the infinite one among them."""
    cluster = Cluster.of(members, [choose_lid(one.hull, options.lid)[0] for one in members])
    check_count(cluster)
    angles, _ = solved_directions(cluster.headings_rad, directions)
    covers = 0 if cluster.cover is None else len(cluster.cover.faces)
    run = demand.Size(
        panels=len(cluster.panels.faces) + covers, lid_panels=covers, reflections=len(cluster.reflections),
        directions=len(angles), frequencies=len(frequencies), rings=0, motions=6 * len(members),
    )  # fmt: skip
    warn(print_demand(run))
    flow = ClusterFlow(capytaine(), cluster, water)
    minutes = flow.seconds(float(frequencies[len(frequencies) // 2]), len(angles)) / 60
    more = f", and up to {MOST_ADDED} that may be added" if refine else ""
    print(f"{'time':<20}about {minutes * len(frequencies):.2g} min for {len(frequencies)} frequencies{more}")
    return len(frequencies) + 1

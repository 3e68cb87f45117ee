"""Attitude options of `kingpost hydro`: angles, or a scenario in which the hull floats."""

from __future__ import annotations

import argparse
import json
import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..errors import HydrodynamicsError, flag
from ..scenario import Scenario, load
from .attitude import Inclination, from_degrees
from .database import Attitude, Hull
from .database_file import from_tree
from .surface import Particulars

OPTIONS = ("heel_deg", "trim_deg", "attitude_of")
SAME_HULL = 0.01
"""Largest relative difference of a hull's dimensions between a scenario's database and the computed ones."""
SAME_WEIGHT = 0.005
"""Largest relative difference of weight and displacement without a note."""
SAME_ANGLE = 1e-6
"""Angles, rad, and heights, m, that differ by less count as equal."""


def add_options(command: argparse.ArgumentParser) -> None:
    """Add the options for heel, trim, and a scenario that gives them."""
    command.add_argument("--heel-deg", metavar="A", type=float, help=(
        "heel of the hull, positive to starboard, at its upright displacement"))  # fmt: skip
    command.add_argument("--trim-deg", metavar="A", type=float, help=(
        "trim of the hull, positive by the bow, at its upright displacement"))  # fmt: skip
    command.add_argument("--attitude-of", metavar="SCENARIO", help=(
        "the hull stands as in this scenario (a file or a gallery name) at rest in still water, as `kingpost "
        "check` prints: heel, trim and height"))  # fmt: skip


def parse(options: argparse.Namespace, hull: Particulars) -> Inclination | None:
    """The attitude from the options; `None` for an upright hull.

    Raises
    ------
    HydrodynamicsError
        If an angle is not between -90 and 90 deg, angles and a scenario are both given, or the scenario does
        not have exactly one such hull.
    ScenarioError, KingpostError
        When the scenario cannot be read or its hulls cannot float.
    """
    if options.attitude_of is None:
        return from_degrees(options.heel_deg, options.trim_deg)
    for name in ("heel_deg", "trim_deg"):
        if getattr(options, name) is not None:
            raise HydrodynamicsError(flag(name), "--attitude-of, too", "one of the two")
    found = of_scenario(load(options.attitude_of), hull)
    return found if found.roll_rad or found.pitch_rad or found.height_m else None


@dataclass(frozen=True)
class _Candidate:
    """A hull of a scenario."""

    name: str
    hull: Hull
    afloat: dict[str, Any]


def of_scenario(scenario: Scenario, hull: Particulars) -> Inclination:
    """Attitude of the hull with these particulars in a scenario, at rest in still water.

    The hulls of a scenario are recognised by the dimensions in their databases.
    """
    file = Path(scenario.file).name
    found = [_candidate(scenario, one) for one in scenario.hydrostatics["hulls"]]
    same = [one for one in found if _difference(one.hull, hull) <= SAME_HULL]
    if not same:
        others = [f"{one.name}, {_sizes(one.hull)}" for one in found] or scenario.hydrostatics["warnings"]
        which = f"a scenario with a hull afloat of {_sizes(hull)}"
        what = "; ".join(others) or "no hull that floats"
        raise HydrodynamicsError("--attitude-of", f"{file} with {what}", which)
    stand = [_attitude(one.afloat, hull.draught_m) for one in same]
    if any(_apart(stand[0], one) > SAME_ANGLE for one in stand):
        names = ", ".join(one.name for one in same)
        allowed = "one hull of these dimensions, or hulls of equal attitude: give --heel-deg and --trim-deg"
        raise HydrodynamicsError("--attitude-of", f"{file} with {names} of other attitudes", allowed)
    first, afloat = stand[0], same[0].afloat
    # Without a mesh the submerged part of a hull is only estimated.
    displaced = afloat["displacement_m3"] if afloat["by_mesh"] else None
    source = f"as {same[0].name} floats in {file}"
    remarks = _remarks(same[0].name, afloat)
    return Inclination(first.roll_rad, first.pitch_rad, first.height_m, source, displaced, remarks)


def _remarks(name: str, afloat: dict[str, Any]) -> tuple[str, ...]:
    """A note if linear hydrostatics, which only use the waterplane, give another height than the mesh."""
    too_much = afloat["displacement_kg"] / afloat["mass_kg"] - 1
    if afloat["rests_by_mesh"] or not afloat["by_mesh"] or abs(too_much) <= SAME_WEIGHT:
        return ()
    return (
        f"{name} rests by linear hydrostatics, where its mesh displaces {too_much:+.1%} of its weight: with "
        "`hydrostatics: mesh` the scenario has the attitude of the mesh",
    )


def _candidate(scenario: Scenario, afloat: dict[str, Any]) -> _Candidate:
    name = scenario.resolved["forces"][afloat["force"]]["hydrodynamics"]["database"]
    return _Candidate(afloat["body"], from_tree(json.loads(scenario.files[name]), name).hull, afloat)


def _attitude(afloat: dict[str, Any], draught_m: float) -> Attitude:
    """The attitude with the height h = T n_z - depth, from the keel depth under the hull's origin, along the
    vertical."""
    roll, pitch = _settled(afloat["heel_rad"]), _settled(afloat["trim_rad"])
    height = draught_m * math.cos(roll) * math.cos(pitch) - afloat["draught_m"]
    return Attitude(roll, pitch, _settled(height))


def _settled(value: float) -> float:
    """Smaller angles count as zero, the accuracy of an equilibrium: so planes of symmetry remain."""
    return 0.0 if abs(value) < SAME_ANGLE else value


def _apart(one: Attitude, other: Attitude) -> float:
    return max(abs(a - b) for a, b in zip(vars(one).values(), vars(other).values(), strict=True))


def _difference(one: Hull | Particulars, other: Particulars) -> float:
    """The largest of length, beam, draught and volume."""
    names = ("length_m", "beam_m", "draught_m", "volume_m3")
    return max(abs(getattr(one, name) / getattr(other, name) - 1) for name in names)


def _sizes(hull: Hull | Particulars) -> str:
    return (
        f"{hull.length_m:.4g} x {hull.beam_m:.4g} m at a draught of {hull.draught_m:.4g} m, "
        f"{hull.volume_m3:.6g} m3"
    )

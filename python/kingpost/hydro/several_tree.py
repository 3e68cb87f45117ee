"""The file of several hulls (version 2) as a tree of plain values: every field is checked on reading.

It has what the file of one hull has (`database_tree`), with a record for each hull and matrices of all
motions.
"""

from __future__ import annotations

from typing import Any

from ..errors import HydrodynamicsError
from . import database_tree as parts
from .fields import Fields, shown
from .several import Place, PlacedHull, SeveralHulls

VERSION = 2

_TOP = ("format", "version", "title", "provenance", "water", "hulls", "frequencies_rad_s",
        "wave_directions_rad", "added_mass", "radiation_damping", "added_mass_infinite",
        "radiation")  # fmt: skip
_HULL = ("name", "place", "hull", "froude_krylov", "diffraction", "mean_drift")
_PLACE = ("x_m", "y_m", "heading_rad")


def names_of(tree: dict[str, Any]) -> list[str]:
    """Names of the hulls of a tree that is not yet checked."""
    records = tree["hulls"] if isinstance(tree["hulls"], list) else []
    return [shown(one["name"]) for one in records if isinstance(one, dict) and "name" in one]


def from_tree(tree: dict[str, Any], file: str | None = None) -> SeveralHulls:
    """The database that a tree of plain values describes, every field checked.

    Raises
    ------
    HydrodynamicsError
        If the tree is that of one hull, or a value is not allowed.
    """
    if tree.get("format") == parts.FORMAT and tree.get("version") == 1 and "hull" in tree:
        raise HydrodynamicsError("hull", "one hull", "several: kingpost.hydro.read(file) reads one", file)
    parts.check_format(tree, file, VERSION)
    top = Fields.of(tree, "", file, _TOP)
    frequencies, directions = parts.grid(top)
    n, m = len(frequencies), len(directions)
    hulls = _hulls(top, n, m)
    motions = 6 * len(hulls)
    return SeveralHulls(
        title=top.text("title"),
        provenance=parts.provenance(top),
        water=parts.water(top),
        hulls=hulls,
        frequencies_rad_s=frequencies,
        wave_directions_rad=directions,
        added_mass=top.numbers("added_mass", n, motions, motions),
        radiation_damping=top.numbers("radiation_damping", n, motions, motions),
        added_mass_infinite=top.numbers("added_mass_infinite", motions, motions),
        radiation=parts.radiation(top, motions),
    )


def _hulls(top: Fields, n: int, m: int) -> tuple[PlacedHull, ...]:
    records = top.values["hulls"]
    if not isinstance(records, list) or len(records) < 2:
        raise top.wrong("hulls", shown(records), "a list of two hulls or more")
    found: list[PlacedHull] = []
    for index, record in enumerate(records):
        at = Fields.of(record, top.at(f"hulls[{index}]"), top.file, _HULL, ("mean_drift_loading",))
        name = at.text("name")
        if not name or name in [one.name for one in found]:
            raise at.wrong("name", shown(name), "a name that no other hull has, not empty")
        found.append(_hull(at, name, n, m))
    return tuple(found)


def _hull(at: Fields, name: str, n: int, m: int) -> PlacedHull:
    place = at.fields("place", _PLACE)
    return PlacedHull(
        name=name,
        place=Place(*(place.number(one) for one in _PLACE)),
        hull=parts.hull(at),
        froude_krylov=parts.complex_forces(at, "froude_krylov", n, m),
        diffraction=parts.complex_forces(at, "diffraction", n, m),
        mean_drift=parts.mean_drift(at, n, m),
        mean_drift_loading=parts.drift_loading(at),
    )


def to_tree(database: SeveralHulls) -> dict[str, Any]:
    """The database as plain values, with seven digits except for the memory: the contents of its file."""
    hulls = [_hull_tree(one) for one in database.hulls]
    tree = {**parts.head_tree(database, VERSION), "hulls": hulls, **parts.matrices_tree(database)}
    return {**parts.plain(tree), "radiation": parts.radiation_tree(database.radiation)}


def _hull_tree(one: PlacedHull) -> dict[str, Any]:
    own = {"name": one.name, "place": vars(one.place), "hull": parts.hull_tree(one.hull)}
    return {**own, **parts.waves_tree(one)}

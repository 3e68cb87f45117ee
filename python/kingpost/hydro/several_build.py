"""Computation of the hydrodynamic database of several hulls that lie near each other, with checks."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from .. import __version__
from ..errors import HydrodynamicsError
from . import checks
from .attitude import described
from .build import (
    CENTRE,
    DEFAULT_PANELS_PER_WAVE,
    FREQUENCIES,
    HIGHEST,
    LOWEST,
    MOST_PANELS,
    check_depth,
    check_waves,
    choose_lid,
    database_hull,
)
from .database import Provenance, Water
from .overlap import check_apart, gaps_m, placed_triangles
from .resolution import default_directions
from .several import PlacedHull, SeveralHulls, reach_m
from .several_mesh import Cluster, Member
from .several_solve import SeveralCoefficients, solve_several

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .partial import Partial

RESONANT = 2.0
"""Limits of the checks over those of one hull: a resonance between hulls multiplies the errors of panels. Two
boxes with a gap of a seventh of their length differ by 11 % from symmetry with 150 panels each, by 4 % with
500, at the resonance alone."""
SHELTERED = 1.5
"""k T from which a gap keeps its waves: exp(-2 k T) is a twentieth."""
BELOW_SLOSHING = 0.9
"""Highest k over pi / g."""
NAME = re.compile("[a-z][a-z0-9_]*")
ADDED, QUICK = "frequencies added", "few frequencies"
"""Beginnings of notes on the frequencies."""
FACING = 2.0
"""Length over which two hulls face each other, over the gap, from which the gap is a channel: waves in a
shorter one leave at its ends."""
HELD = "zero forward speed, loads of waves on each hull with all hulls held, matrices made symmetric"


def several_frequencies(
    members: Sequence[Member], water: Water, count: int = FREQUENCIES
) -> NDArray[np.float64]:
    """Frequencies for the sizes of the hulls, rad/s, as `build.default_frequencies` has them for one.

    The lowest are those of the largest hull, the highest those of the smallest, if its panels and the others'
    resolve them and no water between hulls sloshes there (`sloshing_rad_s`).
    """
    units = [np.sqrt(water.gravity_m_s2 / one.hull.particulars.volume_m3 ** (1 / 3)) for one in members]
    size = max(one.hull.panel_size_m for one in members)
    resolved = np.sqrt(2 * np.pi * water.gravity_m_s2 / (DEFAULT_PANELS_PER_WAVE * size))
    middle = float(np.sqrt(min(units) * max(units)))
    highest = min(HIGHEST * max(units), resolved, sloshing_rad_s(members, water))
    ends = np.array([LOWEST * min(units), highest]) / middle
    part = np.linspace(*(ends / (ends + CENTRE)), count)
    return np.array([float(f"{middle * CENTRE * s / (1 - s):.4g}") for s in part])


def sloshing_rad_s(members: Sequence[Member], water: Water) -> float:
    """Frequency below which no water sloshes across a sheltered gap between two hulls; infinite without one.

    Waves of which half a length fits across a gap of width g run along it as in a channel, k > pi / g. Where
    the hulls are deep, k T > 1.5, hardly a twentieth of their energy leaves below the hulls, and resonances
    are so sharp that panels do not give their damping, which may come out negative.
    """
    found = np.inf
    for (one, other), gap in gaps_m(members).items():
        draught = min(members[k].hull.particulars.draught_m for k in (one, other))
        faces = facing_m(*(members[k] for k in (one, other)))
        if np.pi * draught / gap > SHELTERED and faces > FACING * gap:
            found = min(found, float(np.sqrt(BELOW_SLOSHING * np.pi / gap * water.gravity_m_s2)))
    return found


def facing_m(one: Member, other: Member) -> float:
    """Length over which two hulls face each other: that of both outlines, seen along the shortest way between
    them."""
    from scipy.spatial import KDTree

    first, second = (corners[..., :2].reshape(-1, 2) for corners in placed_triangles([one, other]))
    distances, nearest = KDTree(second).query(first)
    at = int(distances.argmin())
    way = second[nearest[at]] - first[at]
    across = np.array([-way[1], way[0]]) / max(float(np.linalg.norm(way)), 1e-300)
    low = max(float((points @ across).min()) for points in (first, second))
    high = min(float((points @ across).max()) for points in (first, second))
    return max(high - low, 0.0)


def gap_warnings(members: Sequence[Member], highest_rad_s: float, water: Water) -> list[str]:
    """Notes on gaps that the panels do not resolve, and on frequencies at which their water sloshes."""
    found = []
    for (i, j), gap in gaps_m(members).items():
        one, other = members[i], members[j]
        size = max(one.hull.panel_size_m, other.hull.panel_size_m)
        if gap < size:
            found.append(
                f"the gap of {gap:.3g} m between {one.name} and {other.name} is narrower than their panels "
                f"of {size:.3g} m: use more panels"
            )
    limit = sloshing_rad_s(members, water)
    if highest_rad_s > 0.99 * limit and highest_rad_s < 1.01 * limit:
        found.append(f"the frequencies end at {highest_rad_s:.3g} rad/s, below those that slosh across a gap")
    elif highest_rad_s > 1.01 * limit / np.sqrt(BELOW_SLOSHING):
        found.append(
            f"water sloshes across a gap between hulls from {limit:.3g} rad/s on, with resonances too sharp "
            "for panels"
        )
    return found


def several_directions(members: Sequence[Member], highest_rad_s: float, water: Water) -> int:
    """Number of directions that resolve the loads on each hull, with the others at their distances."""
    return default_directions(extent_m(members), highest_rad_s, water)


def extent_m(members: Sequence[Member]) -> float:
    """The length of a hull whose loads vary with the direction as those of these hulls do."""
    found = [one.hull.particulars for one in members]
    outlines = [(one.place, of.length_m, of.beam_m) for one, of in zip(members, found, strict=True)]
    return 2 * reach_m(outlines)


def build_several(
    members: Sequence[Member],
    water: Water,
    title: str,
    frequencies_rad_s: NDArray[np.float64] | None = None,
    directions: int | None = None,
    with_lid: bool | None = None,
    update: Callable[[float], None] = lambda _done: None,
    partial: Partial | None = None,
) -> SeveralHulls:
    """Run the panel method for all hulls together and check its results.

    Parameters
    ----------
    members
        Two hulls or more, each with a name of its own and its place.
    frequencies_rad_s
        `None`: those for the hulls' sizes, with more where the coefficients change quickly.
    directions
        Number of directions round the circle; `None`: the number that the hulls, their distances and the
        frequencies need.
    with_lid
        `None`: a lid in each hull whose draught allows one.
    partial
        Stores solved frequencies, and continues a stopped run.

    Raises
    ------
    HydrodynamicsError
        If a name is given twice, hulls overlap, the panels are too many or too large for the frequencies, the
        sea bed is above a keel, a draught is too small for the lid, or a result is unphysical.
    """
    check_members(members, water)
    refine = frequencies_rad_s is None
    if frequencies_rad_s is None:
        frequencies_rad_s = several_frequencies(members, water)
    highest = float(frequencies_rad_s[-1])
    directions = directions or several_directions(members, highest, water)
    for one in members:
        with _named(one):
            check_waves(one.hull, water, highest)
    lids, notes = _lids(members, with_lid)
    cluster = Cluster.of(members, lids)
    check_count(cluster)
    found = solve_several(members, cluster, water, frequencies_rad_s, directions, refine, update, partial)
    notes = (HELD, *notes, *_added(found), *_attitudes(members))
    database = _database(members, cluster, water, title, directions, found, notes)
    checks.check(database, "use more panels, a lid in each hull, or lower frequencies", RESONANT)
    return _symmetric(database)


def check_members(members: Sequence[Member], water: Water) -> None:
    """Refuse hulls that cannot be solved together, by their names."""
    if len(members) < 2:
        raise HydrodynamicsError("hulls", f"{len(members)}", "two or more")
    names = [one.name for one in members]
    for one in members:
        if names.count(one.name) > 1:
            found = f"{one.name!r} for {names.count(one.name)} hulls"
            raise HydrodynamicsError("--name", found, "a name for each hull that no other has")
        if not NAME.fullmatch(one.name):
            allowed = "a name that scenarios can use: small letters, digits and _, a letter first"
            raise HydrodynamicsError("--name", repr(one.name), allowed)
        with _named(one):
            check_depth(one.hull, water)
    check_apart(members)


@contextmanager
def _named(one: Member) -> Iterator[None]:
    """Name the hull in an error of it."""
    try:
        yield
    except HydrodynamicsError as error:
        raise HydrodynamicsError(
            error.field, f"{one.name}: {error.found}", error.allowed, error.file
        ) from None


def check_count(cluster: Cluster) -> None:
    """Refuse more panels than can be solved for."""
    count = len(cluster.panels.faces)
    if count > MOST_PANELS:
        allowed = f"at most {MOST_PANELS}: use fewer panels for each hull"
        raise HydrodynamicsError("hulls", f"{count} panels of all hulls to solve for", allowed)


def _lids(members: Sequence[Member], with_lid: bool | None) -> tuple[list[bool], tuple[str, ...]]:
    chosen = []
    for one in members:
        with _named(one):
            chosen.append(choose_lid(one.hull, with_lid))
    notes = [f"{one.name}: {note}" for one, (_, some) in zip(members, chosen, strict=True) for note in some]
    return [has for has, _ in chosen], tuple(notes)


def _symmetric(database: SeveralHulls) -> SeveralHulls:
    """The database with the means of A_ij and A_ji, B_ij and B_ji: panels give them alike only nearly, by
    less than the limit of `checks`, and the memory of all hulls is symmetric."""
    names = ("added_mass", "radiation_damping", "added_mass_infinite")
    matrices = {name: getattr(database, name) for name in names}
    means = {name: 0.5 * (one + np.swapaxes(one, -1, -2)) for name, one in matrices.items()}
    return replace(database, **means)


def _added(found: SeveralCoefficients) -> tuple[str, ...]:
    notes = []
    if found.added_rad_s:
        notes.append(
            f"{ADDED}: {len(found.added_rad_s)}, from {found.added_rad_s[0]:g} to "
            f"{found.added_rad_s[-1]:g} rad/s, where added mass or damping change quickly"
        )
    if found.quick is not None:
        change, low, high = found.quick
        notes.append(
            f"{QUICK}: added mass or damping change by {change:.0%} of their peaks from {low:g} to {high:g} "
            "rad/s; a resonance there may be missed"
        )
    return tuple(notes)


def _attitudes(members: Sequence[Member]) -> tuple[str, ...]:
    return tuple(
        f"{one.name}: {described(one.hull.attitude)}, {one.hull.attitude_source}"
        for one in members
        if one.hull.attitude is not None
    )


def _database(
    members: Sequence[Member], cluster: Cluster, water: Water, title: str, directions: int,
    found: SeveralCoefficients, notes: tuple[str, ...],
) -> SeveralHulls:  # fmt: skip
    hulls = [
        PlacedHull(one.name, one.place, database_hull(one.hull), found.froude_krylov[:, k],
                   found.diffraction[:, k])
        for k, one in enumerate(members)
    ]  # fmt: skip
    about = Provenance(
        tool=f"kingpost hydro {__version__}",
        solver=found.solver,
        source="; ".join(f"{one.name}: {one.hull.source} at {one.place.described}" for one in members),
        panels=sum(one.hull.panel_count for one in members),
        lid_panels=cluster.lid_panels,
        notes=notes,
    )
    return SeveralHulls(
        title=title,
        provenance=about,
        water=water,
        hulls=tuple(hulls),
        frequencies_rad_s=found.frequencies_rad_s,
        wave_directions_rad=2 * math.pi * np.arange(directions) / directions,
        added_mass=found.added_mass,
        radiation_damping=found.radiation_damping,
        added_mass_infinite=found.added_mass_infinite,
    )

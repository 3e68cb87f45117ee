"""Computation of a hydrodynamic database from a hull's meshes, with checks."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from .. import __version__
from ..errors import HydrodynamicsError
from . import checks
from .airy import wave_number
from .attitude import described
from .database import Database, Hull, Provenance, Water, Waterplane
from .drift import Loading, drift, stiffness_matrix, stored
from .resolution import default_directions
from .solve import PANELS_PER_WAVE, SHALLOWEST_LID, solve

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .meshes import HullMeshes
    from .partial import Partial

FREQUENCIES, PANELS = 40, 900
DEFAULT_PANELS_PER_WAVE = 6
MOST_PANELS = 6000
"""Largest number of panels of the unmirrored part: the matrices are dense."""
LOWEST, HIGHEST, CENTRE = 0.08, 3.5, 1.2
"""Ends of the frequency grid, and the frequency around which it is dense, in units of sqrt(g / V^(1/3))."""

_NO_LID = "no lid against irregular frequencies"


def default_frequencies(hull: HullMeshes, water: Water, count: int = FREQUENCIES) -> NDArray[np.float64]:
    """Frequencies for the size of the hull, rad/s: evenly spaced in w / (w + c), dense around waves of its
    length.

    The shortest wave is six panels long or longer.
    """
    unit = np.sqrt(water.gravity_m_s2 / hull.particulars.volume_m3 ** (1 / 3))
    resolved = np.sqrt(2 * np.pi * water.gravity_m_s2 / (DEFAULT_PANELS_PER_WAVE * hull.panel_size_m))
    ends = np.array([LOWEST, min(HIGHEST, resolved / unit)])
    part = np.linspace(*(ends / (ends + CENTRE)), count)
    return np.array([float(f"{unit * CENTRE * s / (1 - s):.4g}") for s in part])


def build(
    hull: HullMeshes,
    water: Water,
    title: str,
    frequencies_rad_s: NDArray[np.float64] | None = None,
    directions: int | None = None,
    with_lid: bool | None = None,
    loading: Loading | None = None,
    update: Callable[[float], None] = lambda _done: None,
    partial: Partial | None = None,
) -> Database:
    """Run the panel method and check its results.

    Parameters
    ----------
    directions
        Number of directions round the circle; `None`: the number that hull and frequencies need, see
        `resolution`.
    with_lid
        `None`: use a lid if the draught allows one.
    loading
        Loading for the mean drift; without it no mean drift is computed.
    partial
        Stores solved frequencies, and continues a stopped run.

    Raises
    ------
    HydrodynamicsError
        If the panels are too large for the frequencies, the sea bed is above the keel, the draught is too
        small for the lid, or a result is unphysical.
    """
    if frequencies_rad_s is None:
        frequencies_rad_s = default_frequencies(hull, water)
    highest = float(frequencies_rad_s[-1])
    if directions is None:
        directions = default_directions(hull.particulars.length_m, highest, water)
    check_depth(hull, water)
    _check_panels(hull)
    check_waves(hull, water, highest)
    lid_wanted, notes = choose_lid(hull, with_lid)
    if loading is not None:
        # Refuse a hull that would not stay upright before the long computation.
        stiffness_matrix(standing(hull), water, loading)
        notes = (*notes, loading.note)
    if hull.attitude is not None:
        notes = (*notes, f"{described(hull.attitude)}, {hull.attitude_source}", *hull.remarks)
    if hull.hull is None:
        notes = (*notes, f"no hull mesh: {hull.why_no_hull}")
    found = solve(hull, water, frequencies_rad_s, directions, lid_wanted, update, partial)
    database = Database(
        title=title,
        provenance=Provenance(
            tool=f"kingpost hydro {__version__}",
            solver=found.solver,
            source=hull.source,
            panels=hull.panel_count,
            lid_panels=found.lid_panels,
            notes=("zero forward speed", *notes),
        ),
        water=water,
        hull=database_hull(hull),
        frequencies_rad_s=frequencies_rad_s,
        wave_directions_rad=2 * np.pi * np.arange(directions) / directions,
        added_mass=found.added_mass,
        radiation_damping=found.radiation_damping,
        added_mass_infinite=found.added_mass_infinite,
        froude_krylov=found.froude_krylov,
        diffraction=found.diffraction,
    )
    checks.check(database, _remedy(hull, lid_wanted))
    if loading is None:
        return database
    stands = replace(database, hull=standing(hull))
    found_drift = drift(stands, found.far_field, loading, hull.reflections)
    kept = stored(loading, stands.hull, water)
    return replace(database, mean_drift=found_drift, mean_drift_loading=kept)


def check_depth(hull: HullMeshes, water: Water) -> None:
    """Refuse a sea bed above the keel."""
    draught = hull.particulars.draught_m
    if water.depth_m is not None and water.depth_m <= draught:
        allowed = f"more than the draught of {draught:g} m"
        raise HydrodynamicsError("water_depth_m", f"{water.depth_m:g}", allowed)


def _check_panels(hull: HullMeshes) -> None:
    count = len(hull.panels.faces)
    if count > MOST_PANELS:
        found = f"{count} panels to solve for, of {hull.panel_count}"
        raise HydrodynamicsError("hull", found, f"at most {MOST_PANELS}: use fewer panels or a coarser mesh")


def check_waves(hull: HullMeshes, water: Water, highest: float) -> None:
    """Refuse frequencies that the panels do not resolve."""
    wave_length = 2 * np.pi / wave_number(highest, water)
    if wave_length < PANELS_PER_WAVE * hull.panel_size_m:
        raise HydrodynamicsError(
            "frequencies",
            f"{highest:g} rad/s, a wave of {wave_length:.3g} m on panels of {hull.panel_size_m:.3g} m",
            f"waves of {PANELS_PER_WAVE} panels or more: use more panels or lower frequencies",
        )


def choose_lid(hull: HullMeshes, wanted: bool | None) -> tuple[bool, tuple[str, ...]]:
    """Whether a hull gets a lid, and a note if it gets none."""
    least = SHALLOWEST_LID * hull.panel_size_m
    possible = hull.particulars.draught_m >= least
    if wanted and not possible:
        raise HydrodynamicsError(
            "lid", f"a draught of {hull.particulars.draught_m:g} m",
            f"a draught of half a panel's size, {least:.3g} m, or more: use more panels or --no-lid",
        )  # fmt: skip
    if wanted is None and not possible:
        return False, (f"{_NO_LID}: the draught is less than half a panel's size",)
    return wanted is not False, () if wanted is not False else (_NO_LID,)


def _remedy(hull: HullMeshes, has_lid: bool) -> str:
    """Advice for unphysical coefficients: usually the hull has too few panels.

    Fewer than the default are few; twice as many halve the error, which is of first order in the panel area;
    a lid needs panels of at most twice the draught.
    """
    size, draught = hull.panel_size_m, hull.particulars.draught_m
    wanted = max(2.0 * hull.panel_count, PANELS)
    why = f"{hull.panel_count} panels may be too few"
    if not has_lid and draught < SHALLOWEST_LID * size:
        wanted = max(wanted, hull.panel_count * (SHALLOWEST_LID * size / draught) ** 2)
        why += " and leave no room for a lid"
    elif not has_lid:
        why += ", without a lid (--lid) too"
    count = math.ceil(wanted / 100) * 100
    if count > MOST_PANELS * 2 ** len(hull.reflections):
        return f"{why}: keep to lower frequencies (--frequencies-rad-s)"
    return f"{why}: try --panels {count}, or lower frequencies (--frequencies-rad-s)"


def database_hull(hull: HullMeshes) -> Hull:
    """Particulars and mesh of the upright hull for the database, and its attitude."""
    return replace(_record(hull.upright or hull), attitude=hull.attitude)


def standing(hull: HullMeshes) -> Hull:
    """Particulars of the submerged part, in the axes of the coefficients; the draught is that of the upright
    hull."""
    draught_m = (hull.upright or hull).particulars.draught_m
    return replace(_record(hull), draught_m=draught_m, attitude=hull.attitude)


def _record(hull: HullMeshes) -> Hull:
    """A hull's particulars, made exactly symmetric if the hull is symmetric."""
    found, plane = hull.particulars, hull.particulars.waterplane
    kept = np.array([axis not in hull.reflections for axis in (0, 1)], dtype=float)
    return Hull(
        draught_m=found.draught_m,
        length_m=found.length_m,
        beam_m=found.beam_m,
        volume_m3=found.volume_m3,
        centre_of_buoyancy_m=found.centre_of_buoyancy_m * [*kept, 1.0],
        waterplane=Waterplane(
            plane.area_m2,
            plane.first_moments_m3 * kept,
            plane.second_moments_m4 * [1.0, kept[0] * kept[1], 1.0],
        ),
        mesh=hull.hull,
    )

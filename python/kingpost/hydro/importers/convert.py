"""Conversion of a foreign file's contents to a database: about the origin, without weight, for the whole
circle."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from ... import __version__
from ...errors import HydrodynamicsError
from ..checks import HASKIND, check_water, haskind_difference
from ..database import Database, Hull, Provenance, Water, Waterplane
from ..infinite_mass import joint_added_mass_infinite
from .directions import Circle
from .foreign import ALLOWED, ASKED
from .long_waves import check_long_waves
from .repair import at_frequencies, positive, repaired, up_to

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .foreign import Foreign, Options


def convert(foreign: Foreign, options: Options, title: str, highest_rad_s: float | None = None) -> Database:
    """Cut, repair, complete missing values, move everything to the origin, remove the weight, check.

    Unphysical coefficients are repaired if the right repair is known, with a note of the change (`repair`);
    only unusable data are refused.

    Raises
    ------
    HydrodynamicsError
        If a value is neither in the file nor given, or a given value cannot be right.
    """
    notes = ["zero forward speed", *foreign.notes]
    foreign, file = repaired(_finite(up_to(foreign, highest_rad_s, notes), notes), notes), foreign.file
    options.asked_together([name for name in ASKED if getattr(foreign, name, None) is None], file)
    water = _water(foreign, options)
    reference = np.array(options.settled("reference_m", foreign.reference_m, file), float)
    motion = about_origin(reference)
    infinite = motion.T @ _infinite(foreign, options, notes) @ motion
    hull = _hull(foreign, options, water, reference)
    excitation = foreign.excitation @ motion
    if foreign.froude_krylov is None:
        froude_krylov, diffraction = np.zeros_like(excitation), excitation
        notes.append("Froude-Krylov forces are not apart in the file: all excitation stands in diffraction")
    else:
        froude_krylov = foreign.froude_krylov @ motion
        diffraction = excitation - froude_krylov
    circle = Circle(foreign, options)
    directions, froude_krylov = circle.whole(froude_krylov)
    _, diffraction = circle.whole(diffraction)
    database = Database(
        title=title,
        provenance=Provenance(
            f"kingpost hydro {__version__}", foreign.solver, _name(file), notes=tuple(notes)
        ),
        water=water,
        hull=hull,
        frequencies_rad_s=foreign.frequencies_rad_s,
        wave_directions_rad=directions,
        added_mass=motion.T @ foreign.added_mass @ motion,
        radiation_damping=motion.T @ foreign.radiation_damping @ motion,
        added_mass_infinite=infinite,
        froude_krylov=froude_krylov,
        diffraction=diffraction,
        mean_drift=_mean_drift(foreign, circle, reference),
    )  # fmt: skip
    check_long_waves(database, file, alone=not foreign.others_about)
    return _with_haskind(database)


def _with_haskind(database: Database) -> Database:
    """Add a note if excitation and damping do not satisfy Haskind's relation; the values are not changed."""
    found = haskind_difference(database)
    if found is None or found.largest <= HASKIND:
        return database
    note = (
        f"excitation and damping miss Haskind's relation by up to {found.largest:.1%} of the "
        f"largest damping, in "
        f"{found.motion} at {found.frequency_rad_s:.4g} rad/s: not changed"
    )
    provenance = replace(database.provenance, notes=(*database.provenance.notes, note))
    return replace(database, provenance=provenance)


def _mean_drift(
    foreign: Foreign, circle: Circle, reference: NDArray[np.float64]
) -> NDArray[np.float64] | None:
    """Mean drift about the origin, for the whole circle: it is mirrored and rotated like forces."""
    if foreign.mean_drift is None:
        return None
    surge, sway, yaw = np.moveaxis(foreign.mean_drift, 2, 0)
    moment = yaw + reference[0] * sway - reference[1] * surge
    nothing = np.zeros_like(surge)
    six = np.stack([surge, sway, nothing, nothing, nothing, moment], axis=2)
    return circle.whole(six)[1][:, :, [0, 1, 5]].real


def _finite(foreign: Foreign, notes: list[str]) -> Foreign:
    """Leave out frequencies with NaN, which Capytaine writes at the lowest frequencies."""
    kept = np.isfinite(foreign.excitation).all(axis=(1, 2))
    for matrices in (foreign.added_mass, foreign.radiation_damping):
        kept &= np.isfinite(matrices).all(axis=(1, 2))
    if kept.all():
        return foreign
    if not kept.any():
        raise HydrodynamicsError("added_mass", "no numbers at any frequency", "finite numbers", foreign.file)
    lost = foreign.frequencies_rad_s[~kept]
    notes.append(
        f"{len(lost)} frequencies left out for which the file has no numbers, from {lost[0]:.4g} rad/s"
    )
    return at_frequencies(foreign, kept)


def about_origin(reference_m: NDArray[np.float64]) -> NDArray[np.float64]:
    """T of nu_R = T nu_O, v_R = v_O + omega x R; so F_O = T^T F_R and A_O = T^T A_R T.

    >>> float(about_origin(np.array([0.0, 0.0, -2.0]))[0, 4])
    -2.0
    """
    x, y, z = reference_m
    motion = np.eye(6)
    motion[:3, 3:] = [[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]]
    return motion


def _name(file: str) -> str:
    return file.replace("\\", "/").rpartition("/")[2]


def _water(foreign: Foreign, options: Options) -> Water:
    file = foreign.file
    density = float(options.settled("density_kg_m3", foreign.density_kg_m3, file))
    gravity = float(options.settled("gravity_m_s2", foreign.gravity_m_s2, file))
    depth = float(options.settled("water_depth_m", foreign.water_depth_m, file))
    water = Water(density, gravity, None if np.isinf(depth) else depth)
    check_water(water, file)
    return water


def _infinite(foreign: Foreign, options: Options, notes: list[str]) -> NDArray[np.float64]:
    if foreign.added_mass_infinite is not None:
        return foreign.added_mass_infinite
    options.asked("added_mass_infinite", foreign.file)
    notes.append("added mass at infinite frequency from A and B, fitted together with the memory")
    found = joint_added_mass_infinite(
        foreign.frequencies_rad_s, foreign.added_mass, foreign.radiation_damping
    )
    return positive(found, "added mass at infinite frequency", notes)


def _hull(foreign: Foreign, options: Options, water: Water, reference: NDArray[np.float64]) -> Hull:
    """Waterplane moments about the origin from the restoring matrix, with the weight removed.

    With S the waterplane, V the volume, B the centre of buoyancy, G the centre of gravity and R the reference
    point, for a freely floating hull (mass rho V): C_33 = rho g S, C_34 = rho g Int (y - y_R), C_35 = -rho g
    Int (x - x_R),
    C_44 = rho g (Int (y - y_R)^2 + V (z_B - z_R)) - rho V g (z_G - z_R), C_55 the same with x,
    C_45 = -rho g Int (x - x_R) (y - y_R) (J. N. Newman, Marine Hydrodynamics, MIT Press 1977, section 6.16).
    """
    file = foreign.file
    volume = float(options.settled("volume_m3", foreign.volume_m3, file))
    buoyancy = np.array(options.settled("centre_of_buoyancy_m", foreign.centre_of_buoyancy_m, file), float)
    if foreign.restoring is None:
        raise HydrodynamicsError("restoring", "nothing in the file", ALLOWED["restoring"], file)
    stiffness = foreign.restoring / (water.density_kg_m3 * water.gravity_m_s2)
    lever = buoyancy[2] - reference[2]
    if options.settled("restoring_includes_weight", foreign.restoring_includes_weight, file):
        gravity_centre = options.settled("centre_of_gravity_m", foreign.centre_of_gravity_m, file)
        lever -= float(gravity_centre[2]) - reference[2]
    area = stiffness[2, 2]
    x, y = reference[:2]
    first = np.array([-stiffness[2, 4], stiffness[2, 3]])
    second = np.array([stiffness[4, 4], -stiffness[3, 4], stiffness[3, 3]]) - volume * lever * np.array(
        [1, 0, 1]
    )
    second += [2 * x * first[0] + x * x * area, x * first[1] + y * first[0] + x * y * area,
               2 * y * first[1] + y * y * area]  # fmt: skip
    hull = Hull(
        draught_m=float(options.preferred("draught_m", foreign.draught_m, file)),
        length_m=float(options.preferred("length_m", foreign.length_m, file)),
        beam_m=float(options.preferred("beam_m", foreign.beam_m, file)),
        volume_m3=volume,
        centre_of_buoyancy_m=buoyancy,
        waterplane=Waterplane(float(area), first + area * np.array([x, y]), second),
    )
    _check_waterplane(hull, file)
    return hull


def _check_waterplane(hull: Hull, file: str) -> None:
    """Refuse second moments of the waterplane that its area, length and beam do not permit."""
    plane = hull.waterplane
    if not plane.area_m2 > 0.0:
        raise HydrodynamicsError("restoring", f"a waterplane of {plane.area_m2:.4g} m2", "more than 0", file)
    centre = plane.first_moments_m3 / plane.area_m2
    own = plane.second_moments_m4[[0, 2]] / plane.area_m2 - centre**2
    for name, square, extent in zip(("length_m", "beam_m"), own, (hull.length_m, hull.beam_m), strict=True):
        if not 0.0 < square <= 0.25 * extent**2:
            raise HydrodynamicsError(
                "restoring",
                f"a waterplane of radius of gyration squared {square:.4g} m2 with {name} {extent:.4g}",
                f"between 0 and {0.25 * extent**2:.4g} m2; check restoring_includes_weight, reference_m, "
                "centre_of_gravity_m and centre_of_buoyancy_m",
                file,
            )

"""The hydrodynamic database: results of a panel method for a hull.

`database_file` stores it in one JSON file `NAME.hydro.json`.

Frame: x forward, y to port, z up, the origin on the water plane at the stated draught. All vectors of
six are (force or translation x, y, z; moment or rotation x, y, z) about that origin. A wave direction is the
direction that the wave travels towards, counter-clockwise from +x. Phases are those of exp(-i w t): the
elevation is Re{a exp(i (k x cos b + k y sin b - w t))}, the force Re{X a exp(-i w t)}. Zero forward speed.

For a hull that lists or trims (`Attitude`) the coefficients are in level axes: x forward along its heading, y
to port, z up, the origin on the water plane, vertically above or below the hull's own origin. Particulars,
waterplane and mesh remain those of the upright hull, in hull axes.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

MOTIONS = ("surge", "sway", "heave", "roll", "pitch", "yaw")


@dataclass(frozen=True)
class Provenance:
    """Origin of the numbers; without dates, so that equal input gives an equal file.

    Attributes
    ----------
    notes
        Assumptions and chosen settings.
    warnings
        Reasons to doubt the numbers, repeated at every use of the database.
    """

    tool: str
    solver: str
    source: str
    panels: int | None = None
    lid_panels: int | None = None
    notes: tuple[str, ...] = ()
    warnings: tuple[str, ...] = ()


@dataclass(frozen=True)
class Water:
    """Density, gravity and depth; `None` is infinitely deep."""

    density_kg_m3: float = 1025.0
    gravity_m_s2: float = 9.80665
    depth_m: float | None = None


@dataclass(frozen=True)
class Waterplane:
    """Area, (Int x dS, Int y dS) and (Int x^2 dS, Int xy dS, Int y^2 dS) of the waterplane."""

    area_m2: float
    first_moments_m3: NDArray[np.float64]
    second_moments_m4: NDArray[np.float64]


@dataclass(frozen=True)
class Mesh:
    """The whole closed hull with its deck; triangles are counter-clockwise seen from outside."""

    vertices_m: NDArray[np.float64]
    triangles: NDArray[np.int64]


@dataclass(frozen=True)
class Attitude:
    """Attitude of the hull in the axes of the coefficients, if it lists, trims or floats at another draught.

    A point r of the upright hull is at Ry(pitch) Rx(roll) r + (0, 0, height) there.

    Attributes
    ----------
    roll_rad, pitch_rad
        Heel to starboard and trim by the bow, rad.
    height_m
        Height of the hull's origin above the still water, m.
    """

    roll_rad: float
    pitch_rad: float
    height_m: float


@dataclass(frozen=True)
class Hull:
    """Particulars of the upright hull at its draught, and the attitude of the coefficients; `None`: upright
    at that draught."""

    draught_m: float
    length_m: float
    beam_m: float
    volume_m3: float
    centre_of_buoyancy_m: NDArray[np.float64]
    waterplane: Waterplane
    mesh: Mesh | None = None
    attitude: Attitude | None = None


@dataclass(frozen=True)
class DriftLoading:
    """The loading that a mean drift was computed for: mass, KG, radii of gyration in roll, pitch and yaw
    about the centre of gravity, and the added roll damping ratio."""

    mass_kg: float
    keel_to_gravity_m: float
    radii_of_gyration_m: NDArray[np.float64]
    roll_damping_ratio: float


@dataclass(frozen=True)
class RadiationMode:
    """Poles, rad/s, each with imaginary part >= 0, and residues (pole, force) of the memory of one motion.

    The retardation function is K_ij(s) = sum over poles p of r_i / (s - p) and, for a complex pole,
    its conjugate; the force on i is -K_ij times the velocity j.
    """

    poles_rad_s: NDArray[np.complex128]
    residues: NDArray[np.complex128]


@dataclass(frozen=True)
class Radiation:
    """The fitted memory, an entry for each of the six motions, and the relative error of the fit."""

    modes: tuple[RadiationMode, ...]
    fit_error: float


@dataclass(frozen=True)
class Database:
    """A hydrodynamic database. Arrays, with n frequencies and m wave directions:

    Attributes
    ----------
    frequencies_rad_s
        (n), increasing, greater than 0.
    wave_directions_rad
        (m), a regular grid of the whole circle that begins at 0.
    added_mass, radiation_damping
        (n, 6, 6): force by motion; kg, kg m, kg m2 and these per second.
    added_mass_infinite
        (6, 6): added mass at infinite frequency.
    froude_krylov, diffraction
        (n, m, 6), complex, per metre of wave amplitude; their sum is the excitation; N/m and N.
    mean_drift
        (n, m, 3) or `None`: surge force, sway force and yaw moment in the hull's axes per amplitude
        squared; N/m2 and N/m.
    radiation
        The fitted memory, or `None`.
    mean_drift_loading
        Loading for which the mean drift was computed, or `None` if it is unknown.
    """

    title: str
    provenance: Provenance
    water: Water
    hull: Hull
    frequencies_rad_s: NDArray[np.float64]
    wave_directions_rad: NDArray[np.float64]
    added_mass: NDArray[np.float64]
    radiation_damping: NDArray[np.float64]
    added_mass_infinite: NDArray[np.float64]
    froude_krylov: NDArray[np.complex128]
    diffraction: NDArray[np.complex128]
    mean_drift: NDArray[np.float64] | None = None
    radiation: Radiation | None = None
    mean_drift_loading: DriftLoading | None = None

    @property
    def excitation(self) -> NDArray[np.complex128]:
        """Froude-Krylov and diffraction together."""
        return self.froude_krylov + self.diffraction

    @property
    def every_hull(self) -> tuple[Hull, ...]:
        """The hull, as a database of several has them."""
        return (self.hull,)

    @property
    def motions(self) -> tuple[str, ...]:
        """Names of the motions."""
        return MOTIONS

    @property
    def reach_m(self) -> float:
        """Radius of the circle about the origin that encloses the water plane, for a hull about it."""
        return math.hypot(self.hull.length_m, self.hull.beam_m) / 2

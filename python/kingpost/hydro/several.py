"""Hydrodynamic databases of several hulls that are solved together, as they lie near each other.

Each hull has its own axes, as in `database`: forces, motions and wave directions of hull i are in the level
axes of hull i, about its origin. The motions of all hulls are numbered hull by hull, surge to yaw of the
first, surge to yaw of the second, ...; the block (i, j) of a matrix is the force on hull i along its axes for
a motion of hull j along the axes of j. So A and B of all hulls are symmetric.

The phase of the excitation of hull i is that of a crest at its own origin, and includes the waves that the
other hulls, held, scatter.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from ..errors import HydrodynamicsError
from .database import MOTIONS, Database, Radiation, RadiationMode

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .database import DriftLoading, Hull, Provenance, Water


@dataclass(frozen=True)
class Place:
    """Place of a hull in the common frame, in calm water: its origin, and its heading counter-clockwise from
    the frame's x axis."""

    x_m: float = 0.0
    y_m: float = 0.0
    heading_rad: float = 0.0

    @property
    def described(self) -> str:
        """The place in words.

        >>> Place(0.0, 13.0, math.pi).described
        'x 0 m, y 13 m, heading 180 deg'
        """
        return f"x {self.x_m:g} m, y {self.y_m:g} m, heading {math.degrees(self.heading_rad):g} deg"


@dataclass(frozen=True)
class PlacedHull:
    """One of several hulls, with the loads of waves on it.

    Attributes
    ----------
    froude_krylov, diffraction
        (n, m, 6), complex, as in `Database`, in the hull's own axes.
    mean_drift
        (n, m, 3) or `None`, as in `Database`, of the hull beside the others.
    """

    name: str
    place: Place
    hull: Hull
    froude_krylov: NDArray[np.complex128]
    diffraction: NDArray[np.complex128]
    mean_drift: NDArray[np.float64] | None = None
    mean_drift_loading: DriftLoading | None = None

    @property
    def excitation(self) -> NDArray[np.complex128]:
        """Froude-Krylov and diffraction together."""
        return self.froude_krylov + self.diffraction


@dataclass(frozen=True)
class SeveralHulls:
    """A hydrodynamic database of N hulls. Arrays, with n frequencies and m wave directions:

    Attributes
    ----------
    hulls
        Two or more, each with a name of its own.
    frequencies_rad_s
        (n), increasing, greater than 0.
    wave_directions_rad
        (m), a regular grid of the whole circle that begins at 0; each hull counts from its own x axis.
    added_mass, radiation_damping
        (n, 6 N, 6 N): force by motion.
    added_mass_infinite
        (6 N, 6 N): added mass at infinite frequency.
    radiation
        The fitted memory of all 6 N motions, or `None`.
    """

    title: str
    provenance: Provenance
    water: Water
    hulls: tuple[PlacedHull, ...]
    frequencies_rad_s: NDArray[np.float64]
    wave_directions_rad: NDArray[np.float64]
    added_mass: NDArray[np.float64]
    radiation_damping: NDArray[np.float64]
    added_mass_infinite: NDArray[np.float64]
    radiation: Radiation | None = None

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the hulls, in the order of their motions."""
        return tuple(one.name for one in self.hulls)

    @property
    def every_hull(self) -> tuple[Hull, ...]:
        """The hulls, in the order of their motions."""
        return tuple(one.hull for one in self.hulls)

    @property
    def motions(self) -> tuple[str, ...]:
        """Names of all motions, such as "barge surge"."""
        return tuple(f"{name} {motion}" for name in self.names for motion in MOTIONS)

    @property
    def excitation(self) -> NDArray[np.complex128]:
        """Excitation of all motions, (n, m, 6 N); each hull has its own directions and phase."""
        return np.concatenate([one.excitation for one in self.hulls], axis=2)

    @property
    def reach_m(self) -> float:
        """Largest distance from the origin of a hull to the far end of a hull, about it."""
        outlines = [(one.place, one.hull.length_m, one.hull.beam_m) for one in self.hulls]
        return reach_m(outlines)

    def of(self, name: str) -> Database:
        """One hull's part: its coefficients beside the other hulls, which are held.

        The waves of the other hulls' motions are left out.

        Parameters
        ----------
        name
            Name of the hull.

        Returns
        -------
        Database
            The diagonal blocks of the hull, and its excitation.

        Raises
        ------
        HydrodynamicsError
            If no hull has this name.
        """
        if name not in self.names:
            raise HydrodynamicsError("hulls", repr(name), f"one of {', '.join(self.names)}")
        index = self.names.index(name)
        own, here = slice(6 * index, 6 * index + 6), self.hulls[index]
        others = ", ".join(one for one in self.names if one != name)
        note = f"{name} beside {others}, which are held: the waves of their motions are left out"
        return Database(
            title=f"{self.title}: {name}",
            provenance=replace(self.provenance, notes=(*self.provenance.notes, note)),
            water=self.water,
            hull=here.hull,
            frequencies_rad_s=self.frequencies_rad_s,
            wave_directions_rad=self.wave_directions_rad,
            added_mass=self.added_mass[:, own, own],
            radiation_damping=self.radiation_damping[:, own, own],
            added_mass_infinite=self.added_mass_infinite[own, own],
            froude_krylov=here.froude_krylov,
            diffraction=here.diffraction,
            mean_drift=here.mean_drift,
            radiation=None if self.radiation is None else _part(self.radiation, own),
            mean_drift_loading=here.mean_drift_loading,
        )


def reach_m(outlines: Sequence[tuple[Place, float, float]]) -> float:
    """Largest distance from the origin of a hull to the far end of a hull, for places, lengths and beams.

    Loads on a hull, in the phase of a crest at its origin, have about k times this angular orders.

    >>> reach_m([(Place(), 6.0, 8.0), (Place(x_m=30.0), 6.0, 8.0)])
    35.0
    """
    return max(
        math.hypot(here.x_m - there.x_m, here.y_m - there.y_m) + math.hypot(length, beam) / 2
        for here, *_ in outlines
        for there, length, beam in outlines
    )


def _part(radiation: Radiation, own: slice) -> Radiation:
    """The memory of some motions: a principal part of a passive matrix is passive."""
    modes = tuple(RadiationMode(one.poles_rad_s, one.residues[:, own]) for one in radiation.modes[own])
    return Radiation(modes, radiation.fit_error)

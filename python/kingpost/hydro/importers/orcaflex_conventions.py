"""Conventions of OrcaFlex's vessel types, as stated by each vessel type."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..airy import wave_number
from ..database import Water
from .convert import about_origin

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from .foreign import Options
    from .orcaflex_file import Entry

# g of OrcaFlex's SI system: with it C_33 of its samples is rho g S to the last digit.
GRAVITY_M_S2 = 9.80665
LEVEL_DEG = 1e-3
FREQUENCIES: dict[str, Callable[[NDArray[np.float64]], NDArray[np.float64]]] = {
    "period (s)": lambda period: 2.0 * np.pi / period,
    "frequency (rad/s)": lambda omega: omega,
    "frequency (Hz)": lambda frequency: 2.0 * np.pi * frequency,
}
PHASE_UNITS = {"degrees": np.pi / 180.0, "radians": 1.0}
# Phase of each reference event behind the crest, at the phase origin, rad.
BEHIND_CREST = {
    "crest": 0.0,
    "zero down-crossing": 0.5 * np.pi,
    "trough": np.pi,
    "zero up-crossing": 1.5 * np.pi,
}
SENSES = {
    "SurgePositive": ("forward", "aft"),
    "SwayPositive": ("port", "starboard"),
    "HeavePositive": ("up", "down"),
    "RollPositiveStarboard": ("down", "up"),
    "PitchPositiveBow": ("down", "up"),
    "YawPositiveBow": ("port", "starboard"),
}
# `hull_symmetry` has no choice for the plane x = 0 alone: the reader itself mirrors in this plane.
ENDS_ALONE = "ends"
SYMMETRIES = {
    "None": "none",
    "xz plane": "port_starboard",
    "yz plane": ENDS_ALONE,
    "xz and yz planes": "both_planes",
    "circular": "revolution",
    "Circular": "revolution",
}


@dataclass(frozen=True)
class Conventions:
    """Conventions of a vessel type."""

    to_rad_s: Callable[[NDArray[np.float64]], NDArray[np.float64]]
    signs: NDArray[np.float64]
    phase_factor: float
    """Factor from a phase to a lag, rad; the lag is then shifted by `behind_rad` to be behind the crest."""
    behind_rad: float
    symmetry: str

    @classmethod
    def of(cls, vessel: Entry) -> Conventions:
        # `RAOResponseUnits`, degrees or radians, are those of displacement RAOs.
        vessel.choice("RAOWaveUnit", {"amplitude": None})
        signs = [
            vessel.choice(name, {positive: 1.0, negative: -1.0})
            for name, (positive, negative) in SENSES.items()
        ]
        way = vessel.choice("RAOPhaseConvention", {"lags": 1.0, "leads": -1.0})
        return cls(
            to_rad_s=vessel.choice("WavesReferredToBy", FREQUENCIES),
            signs=np.array(signs),
            phase_factor=way * vessel.choice("RAOPhaseUnitsConvention", PHASE_UNITS),
            behind_rad=vessel.choice("RAOPhaseRelativeToConvention", BEHIND_CREST),
            symmetry=vessel.choice("Symmetry", SYMMETRIES),
        )

    def frequencies(self, entry: Entry, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """Frequencies, rad/s; 0 and infinity are possible."""
        if (values < 0.0).any():
            raise entry.error("period or frequency", values.min(), "0 or more")
        with np.errstate(divide="ignore"):
            return self.to_rad_s(values)


@dataclass(frozen=True)
class Place:
    """Points of a draught, in the vessel's axes."""

    matrices: NDArray[np.float64]
    """Reference point of stiffness, added mass and damping, at `height` above the water."""
    height: float
    forces: NDArray[np.float64]
    phases: NDArray[np.float64]

    @classmethod
    def of(cls, draught: Entry) -> Place:
        height, *angles = draught.needed("ReferenceOriginDatumPosition")
        if np.abs(angles).max() > LEVEL_DEG:
            found = f"heel of {angles[0]:g} and trim of {angles[1]:g} deg"
            raise draught.error("ReferenceOriginDatumPosition", found, "a level datum position")
        raos = draught.entry("LoadRAOs")
        forces = raos.needed("RAOOrigin")
        phases = raos.vector("PhaseOrigin")
        return cls(draught.needed("ReferenceOrigin"), height, forces, forces if phases is None else phases)

    def here(self, point: NDArray[np.float64]) -> NDArray[np.float64]:
        """A point from the origin on the water plane at the forces' origin."""
        return point - np.array([self.forces[0], self.forces[1], self.matrices[2] - self.height])

    @property
    def reference(self) -> NDArray[np.float64]:
        return self.here(self.matrices)

    def notes(self) -> list[str]:
        x, y = self.forces[:2]
        if np.hypot(x, y) < 1e-9:
            return []
        return [f"the origin is on the water plane at x = {x:.4g}, y = {y:.4g} of the file, its load RAOs'"]

    def phased(
        self,
        omega: NDArray[np.float64],
        directions: NDArray[np.float64],
        forces: NDArray[np.complex128],
        options: Options,
        file: str,
    ) -> NDArray[np.complex128]:
        """Forces with the phase of a crest at their own origin O at t = 0 instead of P: X_O = X_P exp(i k (P
        - O))."""
        x, y = (self.phases - self.forces)[:2]
        if np.hypot(x, y) < 1e-9:
            return forces
        depth = float(options.asked("water_depth_m", file))
        water = Water(gravity_m_s2=GRAVITY_M_S2, depth_m=None if np.isinf(depth) else depth)
        numbers = np.array([wave_number(float(w), water) for w in omega])
        ahead = x * np.cos(directions) + y * np.sin(directions)
        return forces * np.exp(1j * np.outer(numbers, ahead))[:, :, None]

    def carried(self, forces: NDArray[np.complex128]) -> NDArray[np.complex128]:
        """Forces about the reference point of the matrices."""
        return forces @ about_origin(self.forces - self.matrices)

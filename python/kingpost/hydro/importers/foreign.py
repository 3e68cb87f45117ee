"""Contents of a foreign file in SI units, and the options for values that it lacks."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import TYPE_CHECKING

import numpy as np

from ...errors import HydrodynamicsError, flag

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

ALLOWED = {
    "restoring_includes_weight": "yes or no: does the file's restoring matrix include the hull's weight?",
    "centre_of_gravity_m": "x,y,z of the weight in the restoring matrix, z from the water up",
    "centre_of_buoyancy_m": "x,y,z, z from the water up",
    "reference_m": "x,y,z of the point that moments are about (WAMIT: XBODY), z from the water up",
    "volume_m3": "the displaced volume, greater than 0",
    "draught_m": "the draught, greater than 0",
    "length_m": "the waterline's length, greater than 0",
    "beam_m": "the waterline's beam, greater than 0",
    "density_kg_m3": "the water's density, greater than 0",
    "gravity_m_s2": "gravity, greater than 0",
    "water_depth_m": "the water's depth, greater than 0, or inf",
    "length_scale_m": "WAMIT's ULEN, greater than 0",
    "first_column": "period_s or frequency_rad_s: what the files' first column is",
    "time_sign": "+ or -: phases of exp(+i w t), as WAMIT's, or of exp(-i w t)",
    "hull_symmetry": "none, port_starboard, both_planes or revolution: the file's wave directions do not "
    "fill the circle",
    "added_mass_infinite": "from_damping, to compute it by Ogilvie's relation, or a file that has it",
    "restoring": "a file that has the restoring matrix",
    "vessel_type": "OrcaFlex's: the name of one of the file's vessel types",
    "draught_name": "OrcaFlex's: the name of one of the vessel type's draughts",
}
CHOICES = {
    "first_column": ("period_s", "frequency_rad_s"),
    "time_sign": ("+", "-"),
    "hull_symmetry": ("none", "port_starboard", "both_planes", "revolution"),
    "added_mass_infinite": ("from_damping",),
}
# Values that every database needs; few files have length and beam.
ASKED = ("density_kg_m3", "gravity_m_s2", "water_depth_m", "reference_m", "volume_m3", "centre_of_buoyancy_m",
         "draught_m", "length_m", "beam_m", "restoring_includes_weight")  # fmt: skip
VECTORS = ("centre_of_gravity_m", "centre_of_buoyancy_m", "reference_m")
TEXTS = ("vessel_type", "draught_name")


@dataclass(frozen=True)
class Options:
    """Values that a file may lack; none has a default. `ALLOWED` describes each."""

    restoring_includes_weight: bool | None = None
    centre_of_gravity_m: tuple[float, float, float] | None = None
    centre_of_buoyancy_m: tuple[float, float, float] | None = None
    reference_m: tuple[float, float, float] | None = None
    volume_m3: float | None = None
    draught_m: float | None = None
    length_m: float | None = None
    beam_m: float | None = None
    density_kg_m3: float | None = None
    gravity_m_s2: float | None = None
    water_depth_m: float | None = None
    length_scale_m: float | None = None
    first_column: str | None = None
    time_sign: str | None = None
    hull_symmetry: str | None = None
    added_mass_infinite: str | None = None
    vessel_type: str | None = None
    draught_name: str | None = None

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            if value is not None and not _good(field.name, value):
                raise HydrodynamicsError(field.name, repr(value), ALLOWED[field.name])

    def asked(self, name: str, file: str) -> object:
        """Return the option for a value that the file lacks.

        Raises
        ------
        HydrodynamicsError
            If the option was not given; the message names it.
        """
        value = getattr(self, name)
        if value is None:
            raise HydrodynamicsError(
                name, "nothing in the file", f"{ALLOWED[name]}; give it as {flag(name)}", file
            )
        return value

    def asked_together(self, names: Sequence[str], file: str) -> None:
        """Report all values that a file lacks in one error.

        Raises
        ------
        HydrodynamicsError
            If several values are missing; `asked` reports a single one.
        """
        missing = [name for name in names if getattr(self, name) is None]
        if len(missing) > 1:
            found = f"no {', '.join(missing)} in the file"
            allowed = (
                f"each as an option, {flag(missing[0])} and so on; `kingpost hydro --help` says what it is"
            )
            raise HydrodynamicsError("", found, allowed, file)

    def preferred(self, name: str, said: object, file: str) -> object:
        """Return the option, otherwise the value measured on another file, which may have another water
        line."""
        given = getattr(self, name)
        return (
            self.asked(name, file) if given is None and said is None else given if given is not None else said
        )

    def settled(self, name: str, said: object, file: str) -> object:
        """Return the value in the file, otherwise the option; if both are given they must agree."""
        given = getattr(self, name)
        if said is None:
            return self.asked(name, file)
        if given is not None and not _same(given, said):
            raise HydrodynamicsError(
                name, f"{given}, while the file says {said}", "the same or nothing", file
            )
        return said


def _good(name: str, value: object) -> bool:
    if name in CHOICES:
        return value in CHOICES[name]
    if name == "restoring_includes_weight":
        return isinstance(value, bool)
    if name in TEXTS:
        return isinstance(value, str) and bool(value)
    try:
        numbers = np.array(value, float)
    except (TypeError, ValueError):
        return False
    if name in VECTORS:
        return numbers.shape == (3,) and bool(np.isfinite(numbers).all())
    return (
        numbers.shape == () and bool(numbers > 0) and (name == "water_depth_m" or bool(np.isfinite(numbers)))
    )


def _same(given: object, said: object) -> bool:
    if isinstance(given, str | bool):
        return given == said
    return bool(np.allclose(np.array(given, float), np.array(said, float), rtol=1e-4, atol=1e-6))


@dataclass(frozen=True)
class Foreign:
    """Contents of a file in SI units; `None` for missing values.

    Moments and rotations are about `reference_m`. Waves go to `directions_rad`. Excitation is for
    exp(-i w t), per metre of amplitude, of shape (frequency, direction, 6), its phase that of the
    wave at x = y = 0. Added mass and damping are (frequency, force, motion); frequencies increase,
    greater than 0.
    """

    file: str
    solver: str
    frequencies_rad_s: NDArray[np.float64]
    directions_rad: NDArray[np.float64]
    added_mass: NDArray[np.float64]
    radiation_damping: NDArray[np.float64]
    added_mass_infinite: NDArray[np.float64] | None
    excitation: NDArray[np.complex128]
    froude_krylov: NDArray[np.complex128] | None
    restoring: NDArray[np.float64] | None
    density_kg_m3: float | None = None
    gravity_m_s2: float | None = None
    water_depth_m: float | None = None
    reference_m: NDArray[np.float64] | None = None
    restoring_includes_weight: bool | None = None
    centre_of_gravity_m: NDArray[np.float64] | None = None
    centre_of_buoyancy_m: NDArray[np.float64] | None = None
    volume_m3: float | None = None
    draught_m: float | None = None
    length_m: float | None = None
    beam_m: float | None = None
    hull_symmetry: str | None = None
    mean_drift: NDArray[np.float64] | None = None
    """(frequency, direction, 3): surge, sway and yaw about `reference_m` per metre squared of amplitude."""
    notes: tuple[str, ...] = ()
    others_about: bool = False
    """Whether there are other, fixed bodies: they diffract even the longest waves."""


def reading_error(found: str, allowed: str, file: str, field: str = "") -> HydrodynamicsError:
    """The error for a file that does not have the format of its name, or is truncated."""
    return HydrodynamicsError(field, found, allowed, file)

"""ShipX's files of VERES: STEM.re7 (coefficients) and STEM.re8 (exciting forces), at zero speed.

Six lines of text; density and gravity; Lpp, breadth and draught; LCG aft of Lpp/2 and VCG above the keel;
numbers of speeds, headings, frequencies and motions; in `.re7` the mass matrix. For each speed a line with
the speed, sinkage, trim and the point of the motions (x aft of Lpp/2, z above the keel), for each heading and
frequency A, B and C, in version 2 each followed by the user's additions, and a line of viscous roll damping;
in `.re8` motion, real and imaginary part. x is aft and z up there, so y is to
starboard; phases are those of exp(+i w t) and of the wave at the point of the motions, a heading of 0 is a
head sea and one of 90 goes to +y. C includes the weight (read_veres_ABC.m and read_veres_TF.m of the Marine
Systems Simulator read them so). The origin here is on the water plane, at the position of that point along
the hull.

Strip theory gives no added mass and damping in surge, and does not satisfy Haskind's relation.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ...errors import shortened
from ...reading import text_of
from .foreign import Foreign, Options, reading_error

if TYPE_CHECKING:
    from numpy.typing import NDArray

AXES = np.array([-1.0, -1.0, 1.0, -1.0, -1.0, 1.0])
"""From x aft, y to starboard to x forward, y to port."""
HEADER_LINES = 6
LONGEST_WORD = 40
"""Longest quote of a wrong word in a message, characters."""


def read(path: str, options: Options) -> Foreign:
    """Read STEM.re7 and STEM.re8 from the name of either.

    Raises
    ------
    HydrodynamicsError
        If one is missing or truncated, or has no zero speed.
    """
    coefficients = _File(_sibling(Path(path), ".re7"))
    forces = _File(_sibling(Path(path), ".re8"))
    omega, added_mass, damping, restoring, mass = _coefficients(coefficients)
    directions, excitation = _forces(forces, omega)
    particulars = coefficients.particulars
    aft, height = particulars.motion_point
    reference = np.array([0.0, 0.0, height - particulars.draught])
    lcg, vcg = particulars.gravity_centre
    centre = np.array([aft - lcg, 0.0, vcg - particulars.draught])
    where = f"{abs(aft):.4g} m {'aft' if aft > 0 else 'forward'} of Lpp/2, the file's point of the motions"
    notes = [f"the origin is on the water plane {where}", "viscous roll damping of the file is left out"]
    strips = not added_mass[:, 0].any() and not damping[:, 0].any()
    if strips:
        notes.append(
            "by strip theory: surge has no added mass and no damping; excitation in surge is taken as it is"
        )
    keel = _keel_to_buoyancy(Path(path))
    buoyancy = None
    if keel is not None:
        buoyancy = np.array([centre[0], 0.0, keel - particulars.draught])
        notes.append(
            "the centre of buoyancy is over that of gravity along x, its height that of the .hyd file"
        )
    return Foreign(
        file=path,
        solver=f"{coefficients.title.split('-')[-1].strip() or 'VERES'}, by ShipX",
        frequencies_rad_s=omega,
        directions_rad=directions,
        added_mass=added_mass,
        radiation_damping=damping,
        added_mass_infinite=None,
        excitation=excitation,
        froude_krylov=None,
        restoring=restoring,
        density_kg_m3=particulars.density,
        gravity_m_s2=particulars.gravity,
        reference_m=reference,
        restoring_includes_weight=True,
        centre_of_gravity_m=centre,
        centre_of_buoyancy_m=buoyancy,
        volume_m3=float(mass[0, 0] / particulars.density),
        draught_m=particulars.draught,
        length_m=particulars.length,
        beam_m=particulars.breadth,
        hull_symmetry="port_starboard",
        notes=tuple(notes),
    )


@dataclass
class _Particulars:
    density: float
    gravity: float
    length: float
    breadth: float
    draught: float
    gravity_centre: tuple[float, float]
    motion_point: tuple[float, float] = (0.0, 0.0)


class _File:
    """Numbers after the six lines of text, one after another."""

    def __init__(self, path: Path) -> None:
        self.path = path
        try:
            lines = text_of(path, "latin-1").splitlines()
        except OSError as error:
            raise reading_error(
                str(error.strerror), "ShipX's .re7 and .re8 beside each other", str(path)
            ) from None
        self.title = lines[0] if lines else ""
        self.numbers = [self._number(word) for line in lines[HEADER_LINES:] for word in line.split()]
        self.version_two = "(Version 2)" in self.title
        self.at = 0
        density, gravity, length, breadth, draught, lcg, vcg = self.take(7)
        self.particulars = _Particulars(density, gravity, length, breadth, draught, (lcg, vcg))

    def _number(self, word: str) -> float:
        try:
            return float(word)
        except ValueError:
            found = repr(shortened(word, LONGEST_WORD))
            raise reading_error(found, "numbers after six lines of text", str(self.path)) from None

    def take(self, count: int) -> list[float]:
        found = self.numbers[self.at : self.at + count]
        if len(found) < count:
            raise reading_error("an end too soon", "a whole file", str(self.path))
        self.at += count
        return found

    def matrix(self) -> NDArray[np.float64]:
        return np.array(self.take(36)).reshape(6, 6)

    def counts(self) -> tuple[int, int, int]:
        speeds, headings, frequencies, motions = (int(value) for value in self.take(4))
        if min(speeds, headings, frequencies) < 1 or motions != 6:
            found = (
                f"{speeds:g} speeds, {headings:g} headings, {frequencies:g} frequencies, {motions:g} motions"
            )
            raise reading_error(found, "one or more, in six motions", str(self.path))
        return speeds, headings, frequencies

    def begin_speed(self) -> None:
        speed, _, _, x, z = self.take(5)
        if abs(speed) > 1e-6:
            raise reading_error(f"a first speed of {speed:g} m/s", "zero speed first", str(self.path))
        self.particulars.motion_point = (x, z)


def _sibling(path: Path, ending: str) -> Path:
    for name in (path.with_suffix(ending), path.with_suffix(ending.upper())):
        if name.is_file():
            return name
    return path.with_suffix(ending)


def _coefficients(file: _File) -> tuple[NDArray[np.float64], ...]:
    """Frequencies, A, B, C and the mass matrix, for zero speed and the first heading, in Kingpost's axes."""
    if file.version_two:
        file.take(2)
    _, headings, frequencies = file.counts()
    mass = file.matrix()
    file.begin_speed()
    omega, found = [], []
    for heading in range(headings):
        file.take(1)
        for _ in range(frequencies):
            (frequency,) = file.take(1)
            matrices = [file.matrix() for _ in range(6 if file.version_two else 3)]
            file.take(3)
            if heading == 0:
                omega.append(frequency)
                found.append(matrices[:: 2 if file.version_two else 1])
    turned = np.array(found) * np.outer(AXES, AXES)
    order = np.argsort(omega)
    return np.array(omega)[order], turned[order, 0], turned[order, 1], turned[order[0], 2], mass


def _forces(file: _File, omega: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.complex128]]:
    """Directions that waves travel towards, rad, and excitation (frequency, direction, 6) of exp(-i w t)."""
    _, headings, frequencies = file.counts()
    file.begin_speed()
    directions, found = [], np.zeros((len(omega), headings, 6), complex)
    for heading in range(headings):
        directions.append(file.take(1)[0])
        for _ in range(frequencies):
            (frequency,) = file.take(1)
            near = int(np.argmin(np.abs(omega - frequency)))
            if abs(omega[near] - frequency) > 1e-4 * frequency:
                raise reading_error(
                    f"{frequency:g} rad/s", "the frequencies of the .re7 file", str(file.path)
                )
            values = np.array(file.take(18)).reshape(6, 3)
            found[near, heading, values[:, 0].astype(int) - 1] = values[:, 1] - 1j * values[:, 2]
    return np.radians(np.array(directions) + 180.0), found * AXES


def _keel_to_buoyancy(path: Path) -> float | None:
    """KB of STEM.hyd, m."""
    file = _sibling(path, ".hyd")
    if not file.is_file():
        return None
    for line in text_of(file, "latin-1").splitlines():
        if line.strip().endswith("*") and "KB" in line and "buoyancy" in line.replace("bouyancy", "buoyancy"):
            return float(line.split()[-1].rstrip("*"))
    return None

"""AQWA-LINE's file STEM.AH1, of version 5: a header, then named sections of numbers.

The header has, for each structure, its number, the numbers of directions and frequencies, and their values;
GENERAL the depth, density and gravity; COG, DRAFT, COB and DISPLACEMENT the hull; HYDSTIFFNESS the
restoring matrix about the centre of gravity, including weight; ADDEDMASS and DAMPING six lines for each
pair of structures and frequency, ADDEDMASS_HF added mass at 100 rad/s, taken as infinite frequency;
FORCERAO moduli and phases in degrees,
Froude-Krylov and diffraction together. Waves go to their directions, phases are those of exp(-i w t) and of
the wave at the centre of gravity (readAQWA.m of WEC-Sim reads them so). The origin here is on the water
plane, vertically above or below the centre of gravity.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...reading import text_of
from .foreign import Foreign, Options, reading_error

if TYPE_CHECKING:
    from numpy.typing import NDArray

ALLOWED = "an .AH1 file of AQWA-LINE, whole"


def read(path: str, options: Options) -> Foreign:
    """Read the first structure of a file.

    Raises
    ------
    HydrodynamicsError
        When it cannot be read, is cut short or lacks a section.
    """
    file = _File(path)
    notes = []
    if file.structures > 1:
        notes.append(f"structures 2 to {file.structures} are left out: they are held still")
    depth, density, gravity = file.section("GENERAL")[1:4]
    centre = np.array(file.section("COG")[1:4])
    buoyancy = np.array(file.section("COB")[1:4])
    if centre[:2].any():
        notes.append(
            f"the origin is on the water plane at x = {centre[0]:.4g}, y = {centre[1]:.4g} of the file"
        )
    shift = np.array([centre[0], centre[1], 0.0])
    infinite = None
    if file.has("ADDEDMASS_HF"):
        infinite = file.first_matrix("ADDEDMASS_HF")
        notes.append("added mass at infinite frequency is that of 100 rad/s")
    return Foreign(
        file=path,
        solver="AQWA-LINE",
        frequencies_rad_s=file.omega,
        directions_rad=np.radians(file.directions),
        added_mass=file.matrices("ADDEDMASS"),
        radiation_damping=file.matrices("DAMPING"),
        added_mass_infinite=infinite,
        excitation=file.forces("FORCERAO"),
        froude_krylov=None,
        restoring=np.array(file.section("HYDSTIFFNESS")[1:37]).reshape(6, 6),
        density_kg_m3=density,
        gravity_m_s2=gravity,
        water_depth_m=depth,
        reference_m=centre - shift,
        restoring_includes_weight=True,
        centre_of_gravity_m=centre - shift,
        centre_of_buoyancy_m=buoyancy - shift,
        volume_m3=file.section("DISPLACEMENT")[1],
        draught_m=file.section("DRAFT")[1],
        notes=tuple(notes),
        others_about=file.structures > 1,
    )


class _File:
    """Sections by name, each a list of numbers."""

    def __init__(self, path: str) -> None:
        self.path = path
        lines = text_of(path, "latin-1").splitlines()
        self.sections: dict[str, list[float]] = {"": []}
        name = ""
        for number, line in enumerate(lines, 1):
            if line.startswith("*") or not line.strip():
                continue
            if line[:1].isalpha():
                name = line.strip()
                self.sections[name] = []
                continue
            try:
                self.sections[name].extend(float(word) for word in line.split())
            except ValueError:
                raise reading_error(f"{line.strip()[:60]!r} in line {number}", ALLOWED, path) from None
        head = self.sections[""]
        if len(head) < 3:
            raise reading_error("no header", ALLOWED, path)
        _, count, frequencies = (int(value) for value in head[:3])
        if min(count, frequencies) < 1 or len(head) < 3 + count + frequencies:
            raise reading_error("a header cut short", ALLOWED, path)
        self.directions = np.array(head[3 : 3 + count])
        self.omega = np.array(head[3 + count : 3 + count + frequencies])
        self.structures = self._structures(head)

    def _structures(self, head: list[float]) -> int:
        """Number of structures in the header, each with its number, directions and frequencies."""
        found = begin = 0
        while begin < len(head):
            if len(head) < begin + 3 or head[begin] != found + 1:
                raise reading_error("a header cut short", ALLOWED, self.path)
            begin += 3 + int(head[begin + 1]) + int(head[begin + 2])
            found += 1
        if begin != len(head):
            raise reading_error("a header cut short", ALLOWED, self.path)
        return found

    def has(self, name: str) -> bool:
        return bool(self.sections.get(name))

    def section(self, name: str) -> list[float]:
        if not self.has(name):
            raise reading_error("nothing", ALLOWED, self.path, name)
        return self.sections[name]

    def _blocks(self, name: str, size: int) -> NDArray[np.float64]:
        """Rows of three labels and their numbers."""
        numbers = self.section(name)
        if len(numbers) % (3 + size):
            raise reading_error(f"{len(numbers)} numbers", f"{3 + size} of each", self.path, name)
        return np.array(numbers).reshape(-1, 3 + size)

    def matrices(self, name: str) -> NDArray[np.float64]:
        blocks = self._blocks(name, 36)
        first = blocks[(blocks[:, 0] == 1) & (blocks[:, 1] == 1)]
        if len(first) != len(self.omega):
            raise reading_error(f"{len(first)} matrices", f"{len(self.omega)} frequencies", self.path, name)
        return first[np.argsort(first[:, 2]), 3:].reshape(-1, 6, 6)

    def first_matrix(self, name: str) -> NDArray[np.float64]:
        """The matrix of structures 1 and 1, after its labels: two, or three as in other sections."""
        numbers, pairs = self.section(name), self.structures**2
        labels = len(numbers) // pairs - 36
        if len(numbers) % pairs or labels not in (2, 3):
            raise reading_error(f"{len(numbers)} numbers", f"36 of each of {pairs} pairs", self.path, name)
        return np.array(numbers[labels : labels + 36]).reshape(6, 6)

    def forces(self, name: str) -> NDArray[np.complex128]:
        blocks = self._blocks(name, 12)
        first = blocks[blocks[:, 0] == 1]
        found = np.full((len(self.omega), len(self.directions), 6), np.nan, complex)
        direction, frequency = first[:, 1].astype(int) - 1, first[:, 2].astype(int) - 1
        if (
            len(first) != found[..., 0].size
            or direction.max() >= found.shape[1]
            or frequency.max() >= len(found)
        ):
            raise reading_error(f"{len(first)} forces", f"{found[..., 0].size}", self.path, name)
        found[frequency, direction] = first[:, 3:9] * np.exp(1j * np.radians(first[:, 9:15]))
        return found

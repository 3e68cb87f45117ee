"""Nemoh's folder, of its versions 2 and 3, by its Nemoh.cal: Mesh/KH.dat, Mesh/Hydrostatics.dat and in
Results RadiationCoefficients.tec, ExcitationForce.tec and FKForce.tec.

Nemoh.cal has density, gravity and depth (0 is infinite), the points that rotations are about, and the ranges
of frequencies and directions. Coefficients are in SI units, waves go to their directions, phases are radians
of exp(-i w t) (readNEMOH.m of WEC-Sim conjugates them for exp(+i w t)). KH is the stiffness about the centre
of gravity that was given to Nemoh's mesh tool, including weight. Of several bodies the first is taken. These
versions have no infinite frequency.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ...reading import text_of
from .foreign import Foreign, Options, reading_error

if TYPE_CHECKING:
    from numpy.typing import NDArray

ALLOWED = "Nemoh.cal of one or more bodies in six motions, with Mesh and Results beside it"


def read(path: str, options: Options) -> Foreign:
    """Read a folder of Nemoh's.

    Raises
    ------
    HydrodynamicsError
        When a file is missing, cut short or of another form.
    """
    case = _Case(Path(path))
    notes = []
    if case.bodies > 1:
        notes.append(f"bodies 2 to {case.bodies} are left out: they are held still")
    omega, added_mass, damping = _radiation(case)
    froude_krylov = None
    if case.has("Results", "FKForce.tec"):
        froude_krylov = _forces(case, "FKForce.tec", len(omega))
    suffix = "" if case.bodies == 1 else "_0"
    volume, buoyancy, gravity_centre = _hydrostatics(case, f"Hydrostatics{suffix}.dat")
    restoring = np.array(case.numbers("Mesh", f"KH{suffix}.dat"))[:6, :6]
    if restoring.shape != (6, 6):
        raise reading_error(f"{restoring.shape[0]} rows", "six rows of six", str(case.file), "KH.dat")
    reference, area = case.reference, float(restoring[2, 2])
    notes.append(
        "restoring is taken about the file's centre of gravity, and carried to the point of its moments"
    )
    return Foreign(
        file=path,
        solver="Nemoh",
        frequencies_rad_s=omega,
        directions_rad=np.radians(case.directions),
        added_mass=added_mass,
        radiation_damping=damping,
        added_mass_infinite=None,
        excitation=_forces(case, "ExcitationForce.tec", len(omega)),
        froude_krylov=froude_krylov,
        restoring=restoring if area > 0.0 else None,
        density_kg_m3=case.density,
        gravity_m_s2=case.gravity,
        water_depth_m=case.depth,
        reference_m=reference,
        restoring_includes_weight=True,
        centre_of_gravity_m=gravity_centre,
        centre_of_buoyancy_m=buoyancy,
        volume_m3=volume,
        notes=tuple(notes),
        others_about=case.bodies > 1,
    )


class _Case:
    """Nemoh.cal: the numbers before the comment of each line."""

    def __init__(self, file: Path) -> None:
        self.file, self.folder = file, file.parent
        lines = text_of(file, "latin-1").splitlines()
        values = [_leading(line) for line in lines]
        try:
            self.density, self.gravity, depth = values[1][0], values[2][0], values[3][0]
            self.depth = np.inf if depth == 0.0 else depth
            self.bodies = int(values[6][0])
            rotations = [row for row in values if len(row) >= 7 and row[0] == 2.0]
            self.reference = np.array(rotations[0][4:7])
            at = next(k for k, line in enumerate(lines) if "wave directions" in line.lower())
            count, first, last = values[at][:3]
            self.directions = np.linspace(first, last, int(count))
        except (IndexError, StopIteration, ValueError):
            raise reading_error("a file of another form or cut short", ALLOWED, str(file)) from None

    def _path(self, folder: str, name: str) -> Path:
        for each in (folder, folder.lower()):
            if (self.folder / each / name).is_file():
                return self.folder / each / name
        return self.folder / folder / name

    def has(self, folder: str, name: str) -> bool:
        return self._path(folder, name).is_file()

    def text(self, folder: str, name: str) -> str:
        path = self._path(folder, name)
        try:
            return text_of(path, "latin-1")
        except OSError as error:
            raise reading_error(str(error.strerror), ALLOWED, str(path)) from None

    def numbers(self, folder: str, name: str) -> list[list[float]]:
        return [row for row in (_leading(line) for line in self.text(folder, name).splitlines()) if row]


def _leading(line: str) -> list[float]:
    found = []
    for word in line.replace(",", " ").split():
        try:
            found.append(float(word))
        except ValueError:
            break
    return found


def _zones(case: _Case, name: str) -> list[NDArray[np.float64]]:
    """The table under each line that begins with Zone."""
    zones: list[list[list[float]]] = []
    for line in case.text("Results", name).splitlines():
        if line.lstrip().lower().startswith("zone"):
            zones.append([])
        elif zones and (row := _leading(line)):
            zones[-1].append(row)
    if not zones or not zones[0] or any(len(row) != len(zones[0][0]) for zone in zones for row in zone):
        raise reading_error("no whole tables", ALLOWED, str(case.folder / "Results" / name))
    return [np.array(zone) for zone in zones]


def _radiation(case: _Case) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """A zone for each motion: frequency, then A and B of each force in turn."""
    zones = _zones(case, "RadiationCoefficients.tec")[:6]
    if len(zones) < 6 or zones[0].shape[1] < 13 or len({len(zone) for zone in zones}) > 1:
        found = f"{len(zones)} motions of {zones[0].shape[1]} columns"
        raise reading_error(found, "six motions", str(case.file), "RadiationCoefficients.tec")
    table = np.array([zone[:, :13] for zone in zones])
    return table[0, :, 0], table[:, :, 1:13:2].transpose(1, 2, 0), table[:, :, 2:13:2].transpose(1, 2, 0)


def _forces(case: _Case, name: str, frequencies: int) -> NDArray[np.complex128]:
    """(frequency, direction, 6): a zone for each direction; frequency, then modulus and phase of each
    force."""
    zones = _zones(case, name)[: len(case.directions)]
    if len(zones) < len(case.directions) or any(zone.shape[0] != frequencies for zone in zones):
        found = f"{len(zones)} directions of {len(zones[0])} frequencies"
        wanted = f"{len(case.directions)} of {frequencies}"
        raise reading_error(found, wanted, str(case.file), name)
    table = np.array([zone[:, :13] for zone in zones])
    return (table[:, :, 1:13:2] * np.exp(1j * table[:, :, 2:13:2])).transpose(1, 0, 2)


_CENTRE = re.compile(r"([XYZ])F\s*=\s*(\S+)\s*-\s*[XYZ]G\s*=\s*(\S+)")


def _hydrostatics(case: _Case, name: str) -> tuple[float, NDArray[np.float64], NDArray[np.float64]]:
    text = case.text("Mesh", name)
    rows = _CENTRE.findall(text)
    volume = re.search(r"Displacement\s*=\s*(\S+)", text)
    if len(rows) != 3 or volume is None:
        raise reading_error("another form", "XF, YF, ZF and Displacement", str(case.file), name)
    buoyancy, gravity_centre = (np.array([float(row[k]) for row in rows]) for k in (1, 2))
    return float(volume[1]), buoyancy, gravity_centre

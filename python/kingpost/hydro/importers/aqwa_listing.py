"""AQWA-LINE's listing STEM.LIS of one structure, for users without its STEM.AH1.

It has the contents of the .AH1 with fewer digits (five for coefficients, three for forces), and also the
separate Froude-Krylov forces and the depth of the lowest point. Frequencies have four decimals and
periods three: the more accurate one is taken. Coefficients and forces are about the centre of gravity,
with directions and phases as in the .AH1 (`aqwa`), added mass of 100 rad/s for infinite frequency.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import numpy as np

from ...reading import text_of
from .foreign import Foreign, Options, reading_error

if TYPE_CHECKING:
    from numpy.typing import NDArray

ALLOWED = "a listing of AQWA-LINE of one structure, whole"
ROWS = ("X", "Y", "Z", "RX", "RY", "RZ")
HIGH_RAD_S = 100.0
# From here up a frequency with four decimals is more accurate than a period with three.
BY_FREQUENCY_RAD_S = 0.8
TOTAL = "FROUDE KRYLOV + DIFFRACTION FORCES-VARIATION WITH WAVE PERIOD/FREQUENCY"
INCIDENT = "FROUDE KRYLOV FORCES-VARIATION WITH WAVE PERIOD/FREQUENCY"
_NUMBER = r"([-+]?\d*\.?\d+(?:[EeDd][-+]?\d+)?)"
_STRUCTURE = re.compile(r"F O R\s+S T R U C T U R E\s+(\d+)")
_PERIOD = re.compile(rf"WAVE PERIOD\s*=\s*{_NUMBER}\s+WAVE FREQUENCY\s*=\s*{_NUMBER}")
_FREQUENCY = re.compile(rf"WAVE FREQUENCY\s*=\s*{_NUMBER}\(RAD/S\)")


def read(path: str, options: Options) -> Foreign:
    """Read a listing.

    Raises
    ------
    HydrodynamicsError
        When it cannot be read, is cut short, lacks a section or has several structures.
    """
    text = text_of(path, "latin-1")
    structures = {int(number) for number in _STRUCTURE.findall(text)}
    if structures != {1}:
        found = f"{len(structures)} structures"
        raise reading_error(found, f"{ALLOWED}; of several, read the .AH1", path)
    said = _Said(text, path)
    matrices = _matrices(text.splitlines(), path)
    omega = np.array(sorted(w for w in matrices if w != np.inf))
    directions, excitation = _forces(text.splitlines(), TOTAL, omega, path)
    froude_krylov = None
    if INCIDENT in text.replace(TOTAL, ""):
        froude_krylov = _forces(text.splitlines(), INCIDENT, omega, path)[1]
    centre = said.vector("GX", "GY", "GZ")
    shift = np.array([*centre[:2], 0.0])
    notes = ["coefficients of five digits and forces of three, of a listing: the .AH1 has more"]
    if centre[:2].any():
        notes.append(
            f"the origin is on the water plane at x = {centre[0]:.4g}, y = {centre[1]:.4g} of the file"
        )
    if np.inf in matrices:
        notes.append(f"added mass at infinite frequency is that of {HIGH_RAD_S:g} rad/s")
    return Foreign(
        file=path,
        solver="AQWA-LINE",
        frequencies_rad_s=omega,
        directions_rad=np.radians(directions),
        added_mass=np.array([matrices[w]["ADDED MASS"] for w in omega]),
        radiation_damping=np.array([matrices[w]["DAMPING"] for w in omega]),
        added_mass_infinite=matrices[np.inf]["ADDED MASS"] if np.inf in matrices else None,
        excitation=excitation,
        froude_krylov=froude_krylov,
        restoring=_restoring(text, path),
        density_kg_m3=said.number(r"DENSITY\s+OF\s+WATER[ .]*=\s*"),
        gravity_m_s2=said.number(r"ACCELERATION\s+DUE\s+TO\s+GRAVITY[ .]*=\s*"),
        water_depth_m=said.number(r"WATER\s+DEPTH[ .]*=\s*"),
        reference_m=centre - shift,
        restoring_includes_weight=True,
        centre_of_gravity_m=centre - shift,
        centre_of_buoyancy_m=said.vector(r"BX", r"BY", r"BZ") - shift,
        volume_m3=said.number(r"MESH BASED DISPLACEMENT[ .]*=\s*"),
        draught_m=said.number(r"DEPTH OF LOWEST POINT ON VESSEL[ .]*\s"),
        notes=tuple(notes),
    )


class _Said:
    """Single numbers of the listing, found by the text before them."""

    def __init__(self, text: str, path: str) -> None:
        self.text, self.path = text, path

    def number(self, before: str) -> float:
        found = re.search(before + _NUMBER, self.text)
        if found is None:
            name = re.sub(r"\\s[*+]|\[[^]]*\][*]?|\\s", " ", before)
            raise reading_error(f"nothing after {' '.join(name.split())}", ALLOWED, self.path)
        return _float(found[1])

    def vector(self, *names: str) -> NDArray[np.float64]:
        return np.array([self.number(rf"{name}\s*=\s*") for name in names])


def _float(word: str) -> float:
    return float(word.replace("D", "E"))


def _matrices(lines: list[str], path: str) -> dict[float, dict[str, NDArray[np.float64]]]:
    """A and B by frequency, infinity for 100 rad/s; other limits are skipped."""
    found: dict[float, dict[str, NDArray[np.float64]]] = {}
    omega, name, rows = None, "", []
    for line in lines:
        words = line.split()
        if at := _PERIOD.search(line):
            period, frequency = _float(at[1]), _float(at[2])
            omega = frequency if frequency >= BY_FREQUENCY_RAD_S else 2.0 * np.pi / period
        elif at := _FREQUENCY.search(line):
            omega = np.inf if _float(at[1]) >= HIGH_RAD_S else None
        elif " ".join(words) in ("ADDED MASS", "DAMPING"):
            name, rows = " ".join(words), []
        elif omega is not None and name and len(words) == 7 and words[0] == ROWS[len(rows)]:
            rows.append([_float(word) for word in words[1:]])
            if len(rows) == 6:
                found.setdefault(omega, {})[name] = np.array(rows)
                name = ""
    whole = [w for w in found if w != np.inf]
    if not whole or any(len(found[w]) != 2 for w in whole):
        raise reading_error("no added mass and damping of each frequency", ALLOWED, path)
    return found


def _forces(
    lines: list[str], title: str, omega: NDArray[np.float64], path: str
) -> tuple[NDArray[np.float64], NDArray[np.complex128]]:
    """Directions in degrees and forces (frequency, direction, 6): tables of period, frequency, the direction
    on its first row, then moduli and phases in degrees."""
    rows, inside, direction = [], False, np.nan
    for line in lines:
        if "VARIATION WITH" in line or "* * * *" in line:
            inside = line.strip() == title
            continue
        if not inside:
            continue
        try:
            values = [_float(word) for word in line.split()]
        except ValueError:
            continue
        if len(values) == 15:
            direction = values.pop(2)
        if len(values) == 14:
            rows.append([direction, *values])
    table = np.array(rows).reshape(-1, 15)
    directions = np.unique(table[:, 0])
    if len(table) != len(directions) * len(omega) or np.isnan(directions).any():
        raise reading_error(f"{len(table)} rows of {title.split('-')[0].lower()}", ALLOWED, path)
    found = np.full((len(omega), len(directions), 6), np.nan, complex)
    nearest = np.abs(omega - table[:, 2:3]).argmin(axis=1)
    force = table[:, 3::2] * np.exp(1j * np.radians(table[:, 4::2]))
    found[nearest, np.searchsorted(directions, table[:, 0])] = force
    if np.isnan(found).any():
        raise reading_error(f"other frequencies in {title.split('-')[0].lower()}", ALLOWED, path)
    return directions, found


def _restoring(text: str, path: str) -> NDArray[np.float64]:
    """Read the hydrostatic stiffness, 6 x 6: its entries of heave, roll and pitch."""
    found = np.zeros((6, 6))
    names = (r"HEAVE\s*\(\s*Z\)", r"ROLL\s*\(RX\)", r"PITCH\s*\(RY\)")
    for i, name in enumerate(names):
        row = re.search(name + rf"\s*=\s*{_NUMBER}\s+{_NUMBER}\s+{_NUMBER}", text)
        if row is None:
            raise reading_error("no total hydrostatic stiffness", ALLOWED, path)
        found[i + 2, 2:5] = [_float(word) for word in row.groups()]
    return found

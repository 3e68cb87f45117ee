"""WAMIT's numeric output, FRC options 1, 3 and the restoring matrix: STEM.1, STEM.3 (or .2) and STEM.hst.

WAMIT User Manual, version 7, chapter 4, with L = ULEN and amplitude a: A = A' rho L^k, B = B' rho L^k w,
k = 3 between forces, 5 between moments, 4 across; X = X' rho g a L^m, m = 2 for forces, 3 for moments;
C_33 = C' rho g L^2, L^3 across, L^4 between rotations. Phases are those of exp(+i w t), and moments are
about XBODY. None of L, rho, g, the depth or XBODY stands in these files. Other programs write them too,
with a frequency for the period or the other sign of time: both are asked for. A period of 0 is an
infinite frequency and one of -1 frequency 0; among frequencies 0 is 0 and a negative one infinite.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .foreign import ASKED, Foreign, Options, reading_error

if TYPE_CHECKING:
    from numpy.typing import NDArray


def read(path: str, options: Options) -> Foreign:
    """Read STEM.1, STEM.3 and STEM.hst, and STEM.3fk where there is one, from the name of any.

    Raises
    ------
    HydrodynamicsError
        When one is missing, cut short or not of that form.
    """
    stem = Path(path).with_suffix("")
    radiation = _rows(stem.with_suffix(".1"), (4, 5))
    # Its files say nothing of the hull, the water or themselves: all is asked for at once.
    options.asked_together([*ASKED, "length_scale_m", "first_column", "time_sign"], path)
    scale = _Scale.of(options, path)
    omega = scale.frequency(radiation[:, 0])
    frequencies = np.unique(omega[(omega > 0) & np.isfinite(omega)])
    if not len(frequencies):
        raise reading_error("no frequency", "frequencies between 0 and infinity", f"{stem}.1")
    matrices = _by_frequency(radiation, omega, f"{stem}.1")
    added_mass = np.array([matrices[w][0] for w in frequencies]) * scale.mass
    damping = np.array([matrices[w][1] for w in frequencies]) * scale.mass * frequencies[:, None, None]
    infinite = matrices[np.inf][0] * scale.mass if np.inf in matrices else None
    total = stem.with_suffix(".3")
    directions, excitation = _waves(total, scale, frequencies)
    apart, froude_krylov = stem.with_suffix(".3fk"), None
    if apart.is_file():
        same, froude_krylov = _waves(apart, scale, frequencies)
        if not np.array_equal(same, directions):
            raise reading_error("other wave directions", f"those of {total.name}", str(apart))
    return Foreign(
        file=path,
        solver="WAMIT's format",
        frequencies_rad_s=frequencies,
        directions_rad=np.radians(directions),
        added_mass=added_mass,
        radiation_damping=damping,
        added_mass_infinite=infinite,
        excitation=excitation,
        froude_krylov=froude_krylov,
        restoring=_restoring(stem.with_suffix(".hst"), scale),
    )


@dataclass(frozen=True)
class _Scale:
    """Units, the meaning of the first column and the sign of time."""

    density: float
    gravity: float
    length: float
    by_period: bool
    conjugated: bool

    @classmethod
    def of(cls, options: Options, path: str) -> _Scale:
        number = {name: float(options.asked(name, path)) for name in  # type: ignore[arg-type]
                  ("density_kg_m3", "gravity_m_s2", "length_scale_m")}  # fmt: skip
        return cls(
            *number.values(),
            by_period=options.asked("first_column", path) == "period_s",
            conjugated=options.asked("time_sign", path) == "+",
        )

    def frequency(self, column: NDArray[np.float64]) -> NDArray[np.float64]:
        """rad/s."""
        safe = np.where(column > 0, column, 1.0)
        if self.by_period:
            return np.where(column > 0, 2.0 * np.pi / safe, np.where(column == 0, np.inf, 0.0))
        return np.where(column < 0, np.inf, column)

    @property
    def power(self) -> NDArray[np.float64]:
        """L of a motion: 1 of translations, L of rotations."""
        return np.repeat([1.0, self.length], 3)

    @property
    def mass(self) -> NDArray[np.float64]:
        return self.density * self.length**3 * np.outer(self.power, self.power)

    @property
    def force(self) -> NDArray[np.float64]:
        return self.density * self.gravity * self.length**2 * self.power

    @property
    def restoring(self) -> NDArray[np.float64]:
        return self.density * self.gravity * self.length**2 * np.outer(self.power, self.power)


def _rows(path: Path, columns: tuple[int, ...]) -> NDArray[np.float64]:
    """Numbers, a row a line, short rows filled with 0; a header line is passed over."""
    try:
        text = path.read_text(encoding="latin-1")
    except OSError as error:
        raise reading_error(str(error.strerror), "a file of WAMIT's numeric output", str(path)) from None
    if text and not text.endswith("\n"):
        # A number that is cut short is still a number.
        raise reading_error("a last line without an end", "a whole file", str(path))
    rows = []
    for number, line in enumerate(text.splitlines(), 1):
        words = line.replace("D", "E").split()
        try:
            values = [float(word) for word in words]
        except ValueError:
            if number == 1:
                continue
            raise _line_error(path, number, line, columns) from None
        if values and (len(values) not in columns or not np.isfinite(values).all()):
            raise _line_error(path, number, line, columns)
        if values:
            rows.append(values + [0.0] * (max(columns) - len(values)))
    if not rows:
        raise reading_error("no numbers", "a file of WAMIT's numeric output", str(path))
    return np.array(rows)


def _line_error(path: Path, number: int, line: str, columns: tuple[int, ...]) -> Exception:
    wanted = " or ".join(str(count) for count in columns)
    return reading_error(
        f"{line.strip()[:60]!r} in line {number}", f"{wanted} numbers in each line", str(path)
    )


def _indices(column: NDArray[np.float64], path: str) -> NDArray[np.intp]:
    if not (np.isin(column, range(1, 7))).all():
        wrong = column[~np.isin(column, range(1, 7))][0]
        raise reading_error(f"motion {wrong:g}", "motions 1 to 6, of one rigid body", path)
    return column.astype(np.intp) - 1


def _by_frequency(
    rows: NDArray[np.float64], omega: NDArray[np.float64], path: str
) -> dict[float, tuple[NDArray[np.float64], NDArray[np.float64]]]:
    """A' and B' of each frequency. Entries that WAMIT knows to be zero by symmetry are not in the file; each
    frequency has the same."""
    i, j = _indices(rows[:, 1], path), _indices(rows[:, 2], path)
    first = set(zip(i[omega == omega[0]], j[omega == omega[0]], strict=True))
    found = {}
    for value in np.unique(omega):
        here = omega == value
        if set(zip(i[here], j[here], strict=True)) != first or here.sum() != len(first):
            raise reading_error(
                f"{here.sum()} entries at {value:.5g} rad/s", f"the same {len(first)} at each frequency", path
            )
        matrices = np.zeros((2, 6, 6))
        matrices[:, i[here], j[here]] = rows[here, 3:5].T
        found[float(value)] = (matrices[0], matrices[1])
    return found


def _waves(
    path: Path, scale: _Scale, frequencies: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.complex128]]:
    """Directions in degrees and excitation (frequency, direction, 6) of exp(-i w t)."""
    rows = _rows(path, (7,))
    omega, motion = scale.frequency(rows[:, 0]), _indices(rows[:, 2], str(path))
    directions = np.unique(rows[:, 1])
    w = np.searchsorted(frequencies, omega * (1 - 1e-9))
    known = w < len(frequencies)
    if not known.all() or not np.allclose(frequencies[w], omega, rtol=1e-6):
        raise reading_error("other frequencies", "those of the .1 file", str(path))
    b = np.searchsorted(directions, rows[:, 1])
    count = np.zeros((len(frequencies), len(directions), 6), int)
    np.add.at(count, (w, b, motion), 1)
    if not (count == count[:1, :1]).all() or count.max() > 1:
        k, d, _ = np.argwhere(count != count[:1, :1])[0] if (count != count[:1, :1]).any() else (0, 0, 0)
        place = f"{frequencies[k]:.5g} rad/s and {directions[d]:g} deg"
        raise reading_error(f"other entries at {place}", "the same, once, at each", str(path))
    found = np.zeros(count.shape, complex)
    found[w, b, motion] = rows[:, 5] + 1j * rows[:, 6]
    return directions, (found.conj() if scale.conjugated else found) * scale.force


def _restoring(path: Path, scale: _Scale) -> NDArray[np.float64]:
    rows = _rows(path, (3,))
    i, j = _indices(rows[:, 0], str(path)), _indices(rows[:, 1], str(path))
    found = np.zeros((6, 6))
    found[i, j] = rows[:, 2]
    there = set(zip(np.minimum(i, j).tolist(), np.maximum(i, j).tolist(), strict=True))
    missing = [(a, b) for a in (2, 3, 4) for b in (2, 3, 4) if a <= b and (a, b) not in there]
    if missing:
        a, b = missing[0]
        raise reading_error(f"no C({a + 1},{b + 1})", "all of heave, roll and pitch", str(path))
    # Some writers give the upper half only.
    found = np.where((found == 0.0) & (np.arange(6)[:, None] > np.arange(6)), found.T, found)
    return found * scale.restoring

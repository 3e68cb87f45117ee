"""WAMIT's output, versions 6 and 7: STEM.1, STEM.3 (or .3fk and .3sc, or .2), STEM.hst, STEM.8 or .9.

WAMIT User Manual, version 7, chapter 4, with L = ULEN and amplitude a: A = A' rho L^k, B = B' rho L^k w,
k = 3 between forces, 5 between moments, 4 across; X = X' rho g a L^m, m = 2 for forces, 3 for moments;
C_33 = C' rho g L^2, L^3 across, L^4 between rotations; mean drift F' rho g a^2 L, L^2 of the moment. Phases
are those of exp(+i w t), and moments are about XBODY. These files contain none of L, rho, g, the depth or
XBODY: they are taken from STEM.out or STEM.mmx in the same folder, otherwise they must be given. If the
numeric files are missing, STEM.out alone is read (`wamit_out`). Other programs also write the numeric files,
with a frequency instead of the period or the other sign of time: the long waves show which, otherwise it must
be given. A period of 0 means infinite frequency and -1 means frequency 0, in either order; among frequencies,
0 is 0 and a negative one infinite.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ...reading import text_of
from . import wamit_motions, wamit_out
from .foreign import ASKED, Foreign, Options, reading_error
from .wamit_header import Header, beside, size
from .wamit_rows import HEADER, SIX_DIGITS, first_column, nearest, of_six_motions, rows

if TYPE_CHECKING:
    from numpy.typing import NDArray

DRIFT = (".8", ".7", ".9")
"""Mean drift by momentum, by a control surface, by pressure: the first existing file is used."""
SECOND_ORDER = (".10", ".10d", ".10s", ".11", ".11d", ".11s", ".12", ".12d", ".12s")


def read(path: str, options: Options) -> Foreign:
    """Read a database from the name of any of its files.

    Raises
    ------
    HydrodynamicsError
        If a file is missing, truncated or of another form.
    """
    stem, notes = Path(path).with_suffix(""), []
    header = beside(stem)
    tables = _Tables.of(stem, header, notes)
    said = {name: value for name, value in _said(header).items() if value is not None}
    asked = [name for name in [*ASKED, "length_scale_m"] if name not in said]
    extents = size(stem, header.reference)
    if extents is not None:
        asked = [name for name in asked if name not in ("length_m", "beam_m", "draught_m")]
        notes.append(f"length, beam and draught are those of {stem.name}.gdf if they were not given")
    column, sign = _conventions(tables, header, stem, options, notes)
    asked += [name for name, value in (("first_column", column), ("time_sign", sign)) if value is None]
    options.asked_together(asked, path)
    scale = _Scale.of(options, header, column, sign, path)
    foreign = _foreign(path, stem, tables, scale, header, extents, notes)
    return _with_the_rest(foreign, stem, scale)


def _with_the_rest(foreign: Foreign, stem: Path, scale: _Scale) -> Foreign:
    """Notes on further files: motions, which are compared, and second-order forces."""

    def responses(table: NDArray[np.float64], path: str) -> wamit_motions.Responses:
        directions, found = _waves(table, scale, foreign.frequencies_rad_s, path)
        return np.radians(directions), found / scale.force / scale.power

    notes = [*foreign.notes, *wamit_motions.notes(stem, foreign, scale.density, responses)]
    second = [ending for ending in SECOND_ORDER if stem.with_suffix(ending).is_file()]
    if second:
        notes.append(f"forces of second order are left out: {', '.join(second)}")
    return replace(foreign, notes=tuple(notes))


def _said(header: Header) -> dict[str, object]:
    return {
        "density_kg_m3": header.density, "gravity_m_s2": header.gravity, "water_depth_m": header.depth,
        "reference_m": header.reference, "volume_m3": header.volume, "length_scale_m": header.length_scale,
        "centre_of_buoyancy_m": header.buoyancy, "restoring_includes_weight": header.gravity_centre,
    }  # fmt: skip


def _foreign(
    path: str, stem: Path, tables: _Tables, scale: _Scale, header: Header,
    extents: tuple[float, float, float] | None, notes: list[str],
) -> Foreign:  # fmt: skip
    omega = scale.frequency(tables.radiation[:, 0])
    frequencies = np.unique(omega[(omega > 0) & np.isfinite(omega)])
    if not len(frequencies):
        raise reading_error("no frequency", "frequencies between 0 and infinity", f"{stem}.1")
    matrices = _by_frequency(tables.radiation, omega, f"{stem}.1")
    directions, excitation = _waves(tables.waves, scale, frequencies, tables.waves_name)
    froude_krylov = None
    if tables.froude_krylov is not None:
        same, froude_krylov = _waves(tables.froude_krylov, scale, frequencies, f"{stem}.3fk")
        if not np.array_equal(same, directions):
            raise reading_error("other wave directions", f"those of {tables.waves_name}", f"{stem}.3fk")
        _check_parts(tables, scale, frequencies, excitation, froude_krylov, stem, notes)
    length, beam, draught = extents or (None, None, None)
    return Foreign(
        file=path,
        solver="WAMIT's format",
        frequencies_rad_s=frequencies,
        directions_rad=np.radians(directions),
        added_mass=np.array([matrices[w][0] for w in frequencies]) * scale.mass,
        radiation_damping=np.array([w * matrices[w][1] for w in frequencies]) * scale.mass,
        added_mass_infinite=matrices[np.inf][0] * scale.mass if np.inf in matrices else None,
        excitation=excitation,
        froude_krylov=froude_krylov,
        restoring=tables.restoring * scale.restoring,
        density_kg_m3=header.density,
        gravity_m_s2=header.gravity,
        water_depth_m=header.depth,
        reference_m=header.reference,
        restoring_includes_weight=None if header.gravity_centre is None else True,
        centre_of_gravity_m=header.gravity_centre,
        centre_of_buoyancy_m=header.buoyancy,
        volume_m3=header.volume,
        length_m=length,
        beam_m=beam,
        draught_m=draught,
        mean_drift=_mean_drift(stem, scale, frequencies, directions, notes),
        hull_symmetry=header.symmetry,
        notes=tuple(notes),
        others_about=any(note.startswith("motions 7") for note in notes),
    )


@dataclass(frozen=True)
class _Tables:
    """Rows as in the files: (PER, I, J, A, B), (PER, BETA, I, MOD, PHA, RE, IM) and C."""

    radiation: NDArray[np.float64]
    waves: NDArray[np.float64]
    waves_name: str
    froude_krylov: NDArray[np.float64] | None
    scattered: NDArray[np.float64] | None
    restoring: NDArray[np.float64]
    by_wamit: bool

    @classmethod
    def of(cls, stem: Path, header: Header, notes: list[str]) -> _Tables:
        one = stem.with_suffix(".1")
        out = next((stem.with_suffix(e) for e in (".out", ".OUT") if stem.with_suffix(e).is_file()), None)
        if not one.is_file() and out is not None:
            return cls._of_listing(out, header, notes)
        parts = {
            ending: of_six_motions(rows(stem.with_suffix(ending), (7,)), (2,), f"{stem}{ending}", notes)
            for ending in (".3", ".3fk", ".3sc", ".2")
            if stem.with_suffix(ending).is_file()
        }
        radiation = of_six_motions(rows(one, (4, 5)), (1, 2), str(one), notes)
        apart = parts.get(".3fk"), parts.get(".3sc")
        name = next((ending for ending in (".3", ".2") if ending in parts), ".3")
        waves = parts.get(name)
        if waves is None and None not in apart:
            waves, name = _sum(*apart, str(stem)), ".3fk and .3sc"
        elif waves is None and out is not None:
            listed = cls._of_listing(out, header, notes)
            waves, name = listed.waves, ".out"
        elif waves is None:
            rows(stem.with_suffix(".3"), (7,))
        restoring = _restoring(stem.with_suffix(".hst"), header, notes)
        written = HEADER in text_of(one, "latin-1")[:80] or out is not None
        return cls(radiation, waves, f"{stem}{name}", *apart, restoring, written)

    @classmethod
    def _of_listing(cls, out: Path, header: Header, notes: list[str]) -> _Tables:
        radiation, waves = wamit_out.tables(out)
        notes.append("excitation by moduli and phases to a whole degree, of the .out file: up to 0.9 % wrong")
        radiation = of_six_motions(radiation, (1, 2), str(out), notes)
        waves = of_six_motions(waves, (2,), str(out), notes)
        restoring = _restoring(out.with_suffix(".hst"), header, notes)
        return cls(radiation, waves, str(out), None, None, restoring, True)


def _sum(first: NDArray[np.float64], second: NDArray[np.float64], stem: str) -> NDArray[np.float64]:
    if first.shape != second.shape or not np.array_equal(first[:, :3], second[:, :3]):
        raise reading_error("other rows", f"those of {stem}.3fk", f"{stem}.3sc")
    total = first.copy()
    total[:, 5:7] += second[:, 5:7]
    return total


def _conventions(
    tables: _Tables, header: Header, stem: Path, options: Options, notes: list[str]
) -> tuple[str | None, str | None]:
    """Meaning of the first column and sign of time: as given, otherwise from the program that wrote it and
    from long waves."""
    column = options.first_column
    if column is None:
        column = first_column(tables.radiation, tables.waves, float(tables.restoring[2, 2]))
        if column is not None:
            notes.append(f"the first column is {column}: the heave force is C_33 at its long waves")
    sign = options.time_sign
    if sign is None and tables.by_wamit:
        sign = "+"
    return column, sign


@dataclass(frozen=True)
class _Scale:
    """Units, the meaning of the first column and the sign of time."""

    density: float
    gravity: float
    length: float
    by_period: bool
    conjugated: bool

    @classmethod
    def of(cls, options: Options, header: Header, column: str | None, sign: str | None, path: str) -> _Scale:
        said = {"density_kg_m3": header.density, "gravity_m_s2": header.gravity,
                "length_scale_m": header.length_scale}  # fmt: skip
        number = [float(options.settled(name, value, path)) for name, value in said.items()]  # type: ignore[arg-type]
        return cls(
            *number,
            by_period=(column or options.asked("first_column", path)) == "period_s",
            conjugated=(sign or options.asked("time_sign", path)) == "+",
        )

    def frequency(self, column: NDArray[np.float64]) -> NDArray[np.float64]:
        """rad/s."""
        safe = np.where(column > 0, column, 1.0)
        if self.by_period:
            return np.where(column > 0, 2.0 * np.pi / safe, np.where(column == 0, np.inf, 0.0))
        return np.where(column < 0, np.inf, column)

    @property
    def power(self) -> NDArray[np.float64]:
        """L of a motion: 1 for translations, L for rotations."""
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


def _index(column: NDArray[np.float64]) -> NDArray[np.intp]:
    return column.astype(np.intp) - 1


def _by_frequency(
    table: NDArray[np.float64], omega: NDArray[np.float64], path: str
) -> dict[float, tuple[NDArray[np.float64], NDArray[np.float64]]]:
    """A' and B' of each frequency. The file omits entries that are zero by symmetry; each frequency must have
    the same entries."""
    i, j = _index(table[:, 1]), _index(table[:, 2])
    first = set(zip(i[omega == omega[-1]], j[omega == omega[-1]], strict=True))
    found = {}
    for value in np.unique(omega):
        here = omega == value
        if set(zip(i[here], j[here], strict=True)) != first or here.sum() != len(first):
            raise reading_error(
                f"{here.sum()} entries at {value:.5g} rad/s", f"the same {len(first)} at each frequency", path
            )
        matrices = np.zeros((2, 6, 6))
        matrices[:, i[here], j[here]] = table[here, 3:5].T
        found[float(value)] = (matrices[0], matrices[1])
    return found


def _waves(
    table: NDArray[np.float64], scale: _Scale, frequencies: NDArray[np.float64], path: str
) -> tuple[NDArray[np.float64], NDArray[np.complex128]]:
    """Directions in degrees and excitation (frequency, direction, 6) of exp(-i w t)."""
    omega, motion = scale.frequency(table[:, 0]), _index(table[:, 2])
    directions = np.unique(table[:, 1])
    w = nearest(frequencies, omega)
    if (w < 0).any():
        found = f"{omega[w < 0][0]:.6g} rad/s"
        raise reading_error(f"other frequencies, {found}", "those of the .1 file", path)
    b = np.searchsorted(directions, table[:, 1])
    count = np.zeros((len(frequencies), len(directions), 6), int)
    np.add.at(count, (w, b, motion), 1)
    if not (count == count[:1, :1]).all() or count.max() > 1:
        k, d, _ = np.argwhere(count != count[:1, :1])[0] if (count != count[:1, :1]).any() else (0, 0, 0)
        place = f"{frequencies[k]:.5g} rad/s and {directions[d]:g} deg"
        raise reading_error(f"other entries at {place}", "the same, once, at each", path)
    waves = np.zeros(count.shape, complex)
    waves[w, b, motion] = table[:, 5] + 1j * table[:, 6]
    return directions, (waves.conj() if scale.conjugated else waves) * scale.force


def _check_parts(
    tables: _Tables, scale: _Scale, frequencies: NDArray[np.float64], excitation: NDArray[np.complex128],
    froude_krylov: NDArray[np.complex128], stem: Path, notes: list[str],
) -> None:  # fmt: skip
    """Check that Froude-Krylov and scattered forces add up to the excitation, within three rounding
    errors."""
    if tables.scattered is None:
        return
    _, scattered = _waves(tables.scattered, scale, frequencies, f"{stem}.3sc")
    rounding = SIX_DIGITS * (np.abs(excitation) + np.abs(froude_krylov) + np.abs(scattered))
    # Single precision gives a force to seven digits of the largest force.
    floor = SIX_DIGITS * np.abs(excitation).max(axis=(0, 1))
    miss = np.abs(froude_krylov + scattered - excitation)
    if (miss > rounding + floor).any():
        worst = miss.max(axis=(0, 1)) / np.maximum(np.abs(excitation).max(axis=(0, 1)), 1e-300)
        notes.append(
            f".3fk and .3sc together miss {Path(tables.waves_name).suffix} by up to {worst.max():.2%} of the "
            "largest force: the sum of .3 is taken, and its Froude-Krylov part"
        )


def _mean_drift(
    stem: Path, scale: _Scale, frequencies: NDArray[np.float64], directions: NDArray[np.float64],
    notes: list[str],
) -> NDArray[np.float64] | None:  # fmt: skip
    """Surge, sway and yaw (frequency, direction, 3) about XBODY per amplitude squared, of waves of one
    direction; `None` if there is no such file, or its frequencies or directions differ."""
    path = next((stem.with_suffix(e) for e in DRIFT if stem.with_suffix(e).is_file()), None)
    if path is None:
        return None
    table = rows(path, (8,))
    table = table[(table[:, 1] == table[:, 2]) & np.isin(np.abs(table[:, 3]), (1, 2, 6))]
    w, b = nearest(frequencies, scale.frequency(table[:, 0])), nearest(directions + 1e3, table[:, 1] + 1e3)
    found = np.full((len(frequencies), len(directions), 3), np.nan)
    there = (w >= 0) & (b >= 0)
    column = np.searchsorted([1, 2, 6], np.abs(table[there, 3]))
    unit = scale.density * scale.gravity * scale.length * np.array([1.0, 1.0, scale.length])
    found[w[there], b[there], column] = table[there, 6]
    if np.isnan(found).any():
        notes.append(f"mean drift of {path.name} is not taken: it is not of all frequencies and directions")
        return None
    notes.append(f"mean drift of {path.name}, of the loading that it was computed for")
    return found * unit


def _restoring(path: Path, header: Header, notes: list[str]) -> NDArray[np.float64]:
    """C' of STEM.hst, otherwise of the listing's header."""
    if not path.is_file() and header.restoring is not None:
        notes.append("restoring to five digits, of the .out file")
        return header.restoring
    table = of_six_motions(rows(path, (3,)), (0, 1), str(path), notes)
    i, j = _index(table[:, 0]), _index(table[:, 1])
    found = np.zeros((6, 6))
    found[i, j] = table[:, 2]
    there = set(zip(np.minimum(i, j).tolist(), np.maximum(i, j).tolist(), strict=True))
    missing = [(a, b) for a in (2, 3, 4) for b in (2, 3, 4) if a <= b and (a, b) not in there]
    if missing:
        a, b = missing[0]
        raise reading_error(f"no C({a + 1},{b + 1})", "all of heave, roll and pitch", str(path))
    # Some writers give the upper half only.
    return np.where((found == 0.0) & (np.arange(6)[:, None] > np.arange(6)), found.T, found)

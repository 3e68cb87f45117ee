"""WAMIT's numeric files as rows of numbers, and the bookkeeping of their first columns.

Numbers have six or seven digits. A file of several bodies or of flexible modes has motions beyond six; they
are skipped with a note.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ...reading import text_of
from .foreign import reading_error

if TYPE_CHECKING:
    from collections.abc import Iterable

    from numpy.typing import NDArray

SIX_DIGITS = 5e-6
"""Relative rounding error of a number with six digits, 0.100000E+01: half of the last digit."""
HEADER = "WAMIT Numeric Output"


def rows(path: Path, columns: tuple[int, ...]) -> NDArray[np.float64]:
    """Numbers, a row for each line, short rows filled with 0; a header line is skipped.

    Raises
    ------
    HydrodynamicsError
        When the file cannot be read, is cut short or has a line of another form.
    """
    try:
        text = text_of(path, "latin-1")
    except OSError as error:
        raise reading_error(str(error.strerror), "a file of WAMIT's numeric output", str(path)) from None
    lines = text.splitlines()
    if text and not text.endswith("\n") and (len(lines) < 2 or len(lines[-1]) < len(lines[-2].rstrip())):
        # A truncated number is still a valid number: compare the length of the last line with that of the
        # line before.
        raise reading_error("a last line without an end", "a whole file", str(path))
    found = []
    for number, line in enumerate(lines, 1):
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
            found.append(values + [0.0] * (max(columns) - len(values)))
    if not found:
        raise reading_error("no numbers", "a file of WAMIT's numeric output", str(path))
    return np.array(found)


def _line_error(path: Path, number: int, line: str, columns: tuple[int, ...]) -> Exception:
    wanted = " or ".join(str(count) for count in columns)
    return reading_error(
        f"{line.strip()[:60]!r} in line {number}", f"{wanted} numbers in each line", str(path)
    )


def of_six_motions(
    table: NDArray[np.float64], columns: Iterable[int], path: str, notes: list[str]
) -> NDArray[np.float64]:
    """Rows whose motions, in these columns, are 1 to 6; higher ones are noted, and others are an error."""
    motions = table[:, list(columns)]
    wrong = (motions != np.round(motions)) | (motions < 1)
    if wrong.any():
        raise reading_error(f"motion {motions[wrong][0]:g}", "motions 1, 2, 3 and so on", path)
    beyond = (motions > 6).any(axis=1)
    if beyond.all():
        raise reading_error(f"motions from {motions.min():g}", "motions 1 to 6 of the first body", path)
    if beyond.any():
        note = (
            f"motions 7 to {motions.max():g} are left out: other bodies are held still, flexible modes stiff"
        )
        if note not in notes:
            notes.append(note)
    return table[~beyond]


def first_column(radiation: NDArray[np.float64], waves: NDArray[np.float64], c33: float) -> str | None:
    """Recognise `period_s` or `frequency_rad_s` by the heave force, whose modulus is C_33 in the longest
    waves and zero in the shortest; `None` if neither end agrees. All numbers are dimensionless, as in the
    files."""
    heave = waves[(waves[:, 2] == 3) & (waves[:, 0] > 0)]
    if not len(heave) or c33 <= 0.0:
        return None
    ends = [np.abs(heave[heave[:, 0] == at, 5] + 1j * heave[heave[:, 0] == at, 6]).max() / c33
            for at in (heave[:, 0].min(), heave[:, 0].max())]  # fmt: skip
    if abs(ends[1] - 1.0) < 0.3 and ends[0] < 0.5:
        return "period_s"
    if abs(ends[0] - 1.0) < 0.3 and ends[1] < 0.5:
        return "frequency_rad_s"
    return None


def nearest(frequencies: NDArray[np.float64], omega: NDArray[np.float64]) -> NDArray[np.intp]:
    """Index of each value among increasing frequencies, within two roundings; -1 if there is none."""
    k = np.clip(np.searchsorted(frequencies, omega), 1, max(len(frequencies) - 1, 1))
    low, high = frequencies[k - 1], frequencies[np.minimum(k, len(frequencies) - 1)]
    found = np.where(np.abs(omega - low) <= np.abs(high - omega), k - 1, np.minimum(k, len(frequencies) - 1))
    same = np.abs(frequencies[found] - omega) <= 2 * SIX_DIGITS * omega
    return np.where(same, found, -1)

"""WAMIT's listing STEM.out as rows of numeric files, for runs without numeric files.

Coefficients have seven digits there; excitation is a modulus of seven digits and a phase in whole degrees.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ...reading import text_of
from .foreign import reading_error

if TYPE_CHECKING:
    from numpy.typing import NDArray

_PERIOD = re.compile(r"Wave period(?: \(sec\))? =\s*(\S+)")
_HEADING = re.compile(r"Wave Heading \(deg\) :\s*(\S+)")
WAVES = ("DIFFRACTION EXCITING FORCES", "HASKIND EXCITING FORCES")
RADIATION = "ADDED-MASS"
# A section ends at the next line of capitals.
_OTHER = re.compile(r"^\s*[A-Z]{2}[A-Z,&\- ]{10,}")


def tables(path: Path) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Rows (PER, I, J, A, B) and (PER, BETA, I, MOD, PHA, RE, IM).

    Raises
    ------
    HydrodynamicsError
        When the listing has no coefficients or no exciting forces.
    """
    text = text_of(path, "latin-1")
    kind = next((name for name in WAVES if name in text), None)
    radiation: list[list[float]] = []
    waves: list[list[float]] = []
    period, heading, section = 0.0, 0.0, ""
    for line in text.splitlines():
        found = _PERIOD.search(line)
        if found:
            period = {"infinite": -1.0, "zero": 0.0}.get(found[1]) if found[1].isalpha() else float(found[1])
            section = ""
        elif RADIATION in line:
            section = RADIATION
        elif kind is not None and kind in line:
            section = kind
        elif _OTHER.match(line):
            section = ""
        elif found := _HEADING.search(line):
            heading = float(found[1])
        elif section:
            _row(line, section, period, heading, radiation if section == RADIATION else waves)
    if not radiation or not waves:
        wanted = "a listing with added mass and damping and exciting forces (options 1, and 2 or 3)"
        raise reading_error("no such tables", wanted, str(path))
    return np.array(radiation), np.array(waves)


def _row(line: str, section: str, period: float, heading: float, into: list[list[float]]) -> None:
    words = line.split()
    try:
        values = [float(word) for word in words]
    except ValueError:
        return
    if section == RADIATION and len(values) in (3, 4):
        into.append([period, *values, *([0.0] * (4 - len(values)))])
    elif section != RADIATION and len(values) == 3:
        force = values[1] * np.exp(1j * np.radians(values[2]))
        into.append([period, heading, *values, force.real, force.imag])

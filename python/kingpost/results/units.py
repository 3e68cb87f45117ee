"""Units as engineers say them, in tables and pictures: degrees, kN, t."""

from __future__ import annotations

import math
from pathlib import Path

from ..errors import KingpostError

NAMES, SI, IN_ENGINEERING = "names", "si", "engineering"
CHOICES = (NAMES, SI, IN_ENGINEERING)
"""How a table of results says its units: not at all, which is SI; in the names of its columns; and there, of
numbers as engineers say them."""
ENDINGS = (".csv", ".parquet")
"""Files in which it may be chosen; others carry the unit beside each number."""
ENGINEERING = {
    "rad": ("deg", math.pi / 180),
    "rad/s": ("deg/s", math.pi / 180),
    "rad/s^2": ("deg/s^2", math.pi / 180),
    "N": ("kN", 1e3),
    "N m": ("kN m", 1e3),
    "N s": ("kN s", 1e3),
    "N/m": ("kN/m", 1e3),
    "N s/m": ("kN s/m", 1e3),
    "Pa": ("kPa", 1e3),
    "kg": ("t", 1e3),
    "J": ("kJ", 1e3),
    "W": ("kW", 1e3),
}
"""By the SI unit: the unit that is shown, and how many of the SI unit it is."""


def engineering(unit: str) -> tuple[str, float]:
    """The unit that is shown instead of an SI unit, and how many of that it is.

    >>> engineering("N"), engineering("m")
    (('kN', 1000.0), ('m', 1.0))
    """
    return ENGINEERING.get(unit, (unit, 1.0))


def check_units(units: str, path: str | Path | None) -> None:
    """Make sure that a file, by its ending, has units to choose.

    Raises
    ------
    KingpostError
        When units other than ``names`` are asked for without a file, or of one that has its own.

    >>> check_units(SI, "run.csv")
    """
    if units != NAMES and (path is None or Path(path).suffix.lower() not in ENDINGS):
        found = "no file" if path is None else path
        raise KingpostError(f"--units {units}: found {found}, allowed: -o with {' or '.join(ENDINGS)}")

"""Engineering units in tables and pictures: degrees, kN, t."""

from __future__ import annotations

import math
from pathlib import Path

from ..errors import KingpostError

NAMES, SI, IN_ENGINEERING = "names", "si", "engineering"
CHOICES = (NAMES, SI, IN_ENGINEERING)
"""Units of a table of results: SI without units in the names; SI with units in the column names; engineering
units with units in the column names."""
ENDINGS = (".csv", ".parquet")
"""Files for which the units can be chosen; other files store the unit of each variable."""
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
"""Engineering unit and its size in the SI unit, by SI unit."""


def engineering(unit: str) -> tuple[str, float]:
    """The engineering unit for an SI unit, and its size in the SI unit.

    >>> engineering("N"), engineering("m")
    (('kN', 1000.0), ('m', 1.0))
    """
    return ENGINEERING.get(unit, (unit, 1.0))


def check_units(units: str, path: str | Path | None) -> None:
    """Check that the units of a file can be chosen, by its ending.

    Raises
    ------
    KingpostError
        If units other than ``names`` are given without a file, or for a file that stores its units.

    >>> check_units(SI, "run.csv")
    """
    if units != NAMES and (path is None or Path(path).suffix.lower() not in ENDINGS):
        found = "no file" if path is None else path
        raise KingpostError(f"--units {units}: found {found}, allowed: -o with {' or '.join(ENDINGS)}")

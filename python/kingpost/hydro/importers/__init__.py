"""Databases from other programs' files: Capytaine's NetCDF, WAMIT's numeric output, BEMIO's HDF5.

What a file does not say is asked for, never assumed; weight is taken out of the restoring matrix; moments
are carried to the origin; phases become those of exp(-i w t).
"""

from __future__ import annotations

from pathlib import Path

from ..database import Database
from . import bemio, capytaine_file, wamit
from .convert import convert
from .foreign import ALLOWED, CHOICES, VECTORS, Options, reading_error

__all__ = ["ALLOWED", "CHOICES", "KINDS", "VECTORS", "Options", "load", "recognise"]

HDF5, CLASSIC = b"\x89HDF\r\n\x1a\n", b"CDF"
READERS = {"bemio": bemio.read, "capytaine": capytaine_file.read, "wamit": wamit.read}
ENDINGS = {".h5": "bemio", ".nc": "capytaine", ".1": "wamit", ".3": "wamit", ".hst": "wamit"}
KINDS = "Capytaine's .nc, WAMIT's .1, .3 or .hst, BEMIO's .h5"


def recognise(path: str | Path) -> str | None:
    """``bemio``, ``capytaine`` or ``wamit`` by the name's ending; `None` of any other file.

    >>> recognise("hull.stl") is None, recognise("out/buoy.hst")
    (True, 'wamit')
    """
    return ENDINGS.get(Path(path).suffix.lower())


def load(path: str | Path, options: Options | None = None, title: str | None = None) -> Database:
    """Read a foreign file as a database, without the fitted memory.

    Raises
    ------
    HydrodynamicsError
        When the file is of no known kind, cannot be read or is cut short; when something that is needed
        is neither in it nor in the options; when the result cannot be a hull's.
    """
    kind, name = recognise(path), str(path)
    if kind is None:
        raise reading_error("a file of another kind", KINDS, name)
    _check_signature(kind, name)
    options = options or Options()
    return convert(READERS[kind](name, options), options, title or Path(path).stem)


def _check_signature(kind: str, name: str) -> None:
    try:
        with open(name, "rb") as file:
            head = file.read(8)
    except OSError as error:
        raise reading_error(str(error.strerror), KINDS, name) from None
    signatures = {"bemio": (HDF5,), "capytaine": (HDF5, CLASSIC), "wamit": (b"",)}[kind]
    if not head.startswith(signatures) or not head:
        raise reading_error("a file that is empty or of another kind", f"a file of {kind}'s", name)

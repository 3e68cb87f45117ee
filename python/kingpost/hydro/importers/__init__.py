"""Databases from other programs' files: Capytaine, WAMIT, BEMIO, ShipX (VERES), AQWA, Nemoh and OrcaFlex.

Values that a file lacks must be given; nothing is assumed. Weight is removed from the restoring matrix,
moments are moved to the origin, and phases become those of exp(-i w t).
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np

from ...reading import check_ends
from ...results.files import is_whole
from ..database import Database
from . import aqwa, aqwa_listing, bemio, capytaine_file, nemoh, orcaflex, veres, wamit
from .convert import convert
from .foreign import ALLOWED, CHOICES, TEXTS, VECTORS, Options, reading_error

__all__ = ["ALLOWED", "CHOICES", "KINDS", "TEXTS", "VECTORS", "Options", "load", "recognise"]

LONGEST_REASON = 100
"""Longest quote of a library's message in an error, characters."""
HDF5, CLASSIC = b"\x89HDF\r\n\x1a\n", b"CDF"
HYDROSTAR = (b"PROJECT", b"COORDIN", b"NBBODY")
READERS = {
    "bemio": bemio.read,
    "capytaine": capytaine_file.read,
    "wamit": wamit.read,
    "veres": veres.read,
    "aqwa": aqwa.read,
    "aqwa_listing": aqwa_listing.read,
    "nemoh": nemoh.read,
    "orcaflex": orcaflex.read,
    "orcawave": orcaflex.refuse_binary,
}
ENDINGS = {
    ".h5": "bemio",
    ".nc": "capytaine",
    **dict.fromkeys((".1", ".2", ".3", ".3fk", ".3sc", ".4", ".8", ".9", ".hst", ".out", ".mmx"), "wamit"),
    **dict.fromkeys(wamit.SECOND_ORDER, "wamit"),
    **dict.fromkeys((".re7", ".re8"), "veres"),
    ".ah1": "aqwa",
    ".lis": "aqwa_listing",
    ".cal": "nemoh",
    **dict.fromkeys((".yml", ".yaml"), "orcaflex"),
    ".owr": "orcawave",
}
KINDS = (
    "Capytaine's .nc, WAMIT's .1, .3, .hst or .out, BEMIO's .h5, ShipX's .re7 or .re8, AQWA's .AH1 or .LIS, "
    "Nemoh's Nemoh.cal, OrcaFlex's .yml"
)


def recognise(path: str | Path) -> str | None:
    """Return the format by the file's ending: ``bemio``, ``capytaine``, ``wamit`` and so on; `None` for any
    other file.

    >>> recognise("hull.stl") is None, recognise("out/buoy.hst"), recognise("hull.AH1")
    (True, 'wamit', 'aqwa')
    """
    return ENDINGS.get(Path(path).suffix.lower())


def load(
    path: str | Path,
    options: Options | None = None,
    title: str | None = None,
    highest_rad_s: float | None = None,
) -> Database:
    """Read a foreign file as a database, without the fitted memory; frequencies above a limit are
    left out first.

    Raises
    ------
    HydrodynamicsError
        If the file has no known format, cannot be read or is truncated; if a required value is neither in it
        nor in the options; if the result is unphysical.
    """
    kind, name = recognise(path), str(path)
    if kind is None:
        raise reading_error("a file of an unknown format", KINDS, name)
    _check_signature(kind, name)
    options = options or Options()
    with _told(kind, name):
        return convert(READERS[kind](name, options), options, title or Path(path).stem, highest_rad_s)


@contextmanager
def _told(kind: str, name: str) -> Iterator[None]:
    """Convert an error on a malformed or too large number into one `HydrodynamicsError`."""
    try:
        # Overflow is found by the checks of the imported numbers.
        with np.errstate(all="ignore"):
            yield
    except (ArithmeticError, LookupError, TypeError, ValueError) as error:
        reason = " ".join(str(error).split())[:LONGEST_REASON]
        raise reading_error(
            f"a file that is damaged ({reason})", f"a file of {kind}'s, whole", name
        ) from error


def _check_signature(kind: str, name: str) -> None:
    try:
        check_ends(name)
        with open(name, "rb") as file:
            head = file.read(8)
    except OSError as error:
        raise reading_error(str(error.strerror), KINDS, name) from None
    signatures = {"bemio": (HDF5,), "capytaine": (HDF5, CLASSIC)}.get(kind, (b"",))
    if not head.startswith(signatures) or not head:
        raise reading_error("a file that is empty or of another kind", f"a file of {kind}'s", name)
    if Path(name).suffix.lower() == ".hst" and head.lstrip().upper().startswith(HYDROSTAR):
        found = "a mesh of Hydrostar (PROJECT, COORDINATES, PANEL)"
        raise reading_error(
            found, "WAMIT's .hst of hydrostatic coefficients; of a mesh, STL, OBJ or GDF", name
        )
    if head.startswith(HDF5) and not is_whole(name):
        raise reading_error("a file that is damaged", f"a file of {kind}'s, whole", name)

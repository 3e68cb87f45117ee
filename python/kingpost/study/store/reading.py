"""Reading of a study's results, with an error that names damaged parts. The marker of each unit holds the
digest of the unit's numbers; the study's description holds the digest of the frame (coordinates and
attributes). A unit without a marker is not finished, and its numbers do not count.
"""

from __future__ import annotations

import json
import warnings
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...errors import KingpostError, shortened
from .digests import digest, frame_digest
from .layout import ABOUT, RESULTS, UNITS, About, about_of

if TYPE_CHECKING:
    import xarray

MOST_NAMED = 5
"""Largest number of damaged units that an error names."""
AGAIN = "`kingpost study FILE --resume` computes the damaged parts again"


def open_results(folder: Path) -> xarray.Dataset:
    """Read the results of a study into memory and verify every number by its digest.

    Raises
    ------
    KingpostError
        If there is no study, or its description, its coordinates or attributes, or the numbers of a unit are
        damaged.
    """
    import xarray
    import zarr

    about, path = about_of(folder), folder / RESULTS
    if about is None or not (path / "zarr.json").is_file():
        missing = ABOUT if about is None else RESULTS
        raise KingpostError(f"{folder}: found no {missing} in it, allowed: the folder of a study")
    # Before the numbers: a unit that another process finishes meanwhile does not count.
    markers = _markers(folder, about)
    with _named(path):
        found = xarray.open_zarr(str(path), consolidated=False, chunks=None).load()
        group = zarr.open_group(str(path), mode="r")
        raw: dict[str, Any] = {str(name): group[str(name)] for name in found.variables}
        arrays = {str(name): raw[str(name)][...] for name in found.data_vars}
        fills = {name: raw[name].fill_value for name in arrays}
        frame = frame_digest({str(name): raw[str(name)][...] for name in found.coords}, dict(group.attrs))
    if about.get("frame", frame) != frame:
        raise KingpostError(
            f"{path}: found coordinates or attributes that do not match their digest, "
            f"allowed: unchanged ones; {AGAIN}"
        )
    for runs in _not_done(folder, about, markers, arrays):
        for name in arrays:
            found[name].values[runs] = fills[name]
    # Texts in the form of other data sets.
    texts = {name: (one.dims, np.array(one.values.tolist(), str), one.attrs)
             for name, one in found.coords.items() if one.dtype.kind == "T"}  # fmt: skip
    return found.assign_coords(texts)


def _markers(folder: Path, about: About) -> list[str | None]:
    """Return the text of the marker of each unit: None without a marker, empty if it cannot be read."""
    units = range(-(-int(about["runs"]) // int(about["runs_of_unit"])))
    return [_text(folder / UNITS / f"{unit:06d}.json") for unit in units]


def _text(marker: Path) -> str | None:
    try:
        return marker.read_text(encoding="utf-8")
    except FileNotFoundError:
        return None
    except (OSError, ValueError):
        return ""


def _not_done(
    folder: Path, about: About, markers: Sequence[str | None], arrays: Mapping[str, NDArray[np.generic]]
) -> list[slice]:
    """Return the runs of the units without a marker.

    Raises
    ------
    KingpostError
        If a marker cannot be read, or the numbers of a unit do not match the digest in its marker.
    """
    size, damaged, missing = int(about["runs_of_unit"]), [], []
    for unit, marker in enumerate(markers):
        runs = slice(unit * size, min((unit + 1) * size, int(about["runs"])))
        if marker is None:
            missing.append(runs)
        elif not _is_whole(marker, about, arrays, runs):
            damaged.append(unit)
    if damaged:
        named = ", ".join(str(unit) for unit in damaged[:MOST_NAMED])
        more = f" and {len(damaged) - MOST_NAMED} more" if len(damaged) > MOST_NAMED else ""
        raise KingpostError(
            f"{folder}: found damaged numbers in unit {named}{more}, allowed: the written numbers; {AGAIN}"
        )
    return missing


def _is_whole(marker: str, about: About, arrays: Mapping[str, NDArray[np.generic]], runs: slice) -> bool:
    try:
        said = json.loads(marker)
        expected = (said["fingerprint"], said["runs"], said["sha256"])
    except (ValueError, TypeError, KeyError):
        return False
    found = digest({name: array[runs] for name, array in arrays.items()})
    return expected == (about["fingerprint"], [runs.start, runs.stop], found)


@contextmanager
def _named(path: Path) -> Iterator[None]:
    """Convert any exception of the library or its codecs on a damaged chunk into one `KingpostError`."""
    try:
        # The library's warnings about unknown parts are suppressed: the digests are checked anyway.
        with warnings.catch_warnings(action="ignore"):
            yield
    except Exception as error:
        reason = shortened(" ".join(str(error).split()) or type(error).__name__)
        raise KingpostError(
            f"{path}: found damaged results ({reason}), allowed: undamaged ones; {AGAIN}"
        ) from None

"""Files of results: NetCDF, CSV, Parquet."""

from __future__ import annotations

import importlib.util
import json
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from fnmatch import fnmatchcase
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .. import output
from ..errors import KingpostError
from ..reading import check_ends
from . import xarrays
from .columns import OVER_RUNS, columns, frame, nearest, places, unit_of
from .entries import as_json, with_entries_of
from .events import events, warnings
from .kept import is_of_a_run
from .units import IN_ENGINEERING, NAMES, check_units, engineering

if TYPE_CHECKING:
    import xarray

PARQUET = ".parquet"
ENDINGS = (".nc", ".csv", PARQUET)
ALLOWED = "allowed: results in NetCDF, as kingpost run -o FILE.nc writes them"
DAMAGED = "found a damaged file"
HDF5 = b"\x89HDF\r\n\x1a\n"
"""The first bytes of a NetCDF file."""
TIME_LIMIT_S = 60.0
"""Time allowed for reading one file, s."""


def check_output(path: str | Path) -> Path:
    """Make sure, before a run, that results can be written to `path`.

    Parameters
    ----------
    path
        With the ending ``.nc``, ``.csv`` or ``.parquet``.

    Returns
    -------
    pathlib.Path
        The same.

    Raises
    ------
    KingpostError
        If the ending is not allowed, the folder does not exist, or the ending is Parquet's and pyarrow is not
        installed.

    >>> check_output("run.nc").name
    'run.nc'
    """
    path = output.check(path, ENDINGS)
    check_parquet(path)
    return path


def check_parquet(path: Path) -> None:
    """Make sure that pyarrow is installed if a file has the ending of Parquet.

    Parameters
    ----------
    path
        A file with any ending.

    Raises
    ------
    KingpostError
        If pyarrow is missing; the message names the extra that installs it.

    >>> check_parquet(Path("run.nc"))
    """
    if path.suffix.lower() == PARQUET and importlib.util.find_spec("pyarrow") is None:
        raise KingpostError(
            f'{path}: Parquet needs pyarrow, which is not installed: pip install "kingpost[parquet]"'
        )


def write(
    results: xarray.Dataset, path: str | Path, patterns: Sequence[str] = (), units: str = NAMES
) -> Path:
    """Write results by the file's ending: ``.nc`` (NetCDF), ``.csv`` or ``.parquet``.

    NetCDF and Parquet also hold units and attributes (Parquet: in the metadata of each field), events,
    warnings and limits (Parquet: as JSON text in the entry ``entries`` of its metadata). A CSV holds only the
    numbers; tables of the events (`events`) and the warnings (`warnings`) stand next to it as
    ``<name>.events.csv`` and ``<name>.warnings.csv``, if there are any. Such tables of an earlier run are
    always overwritten.

    Parameters
    ----------
    results
        A data set of a run.
    path
        With the ending ``.nc``, ``.csv`` or ``.parquet``.
    patterns
        Columns to write, such as ``ship.roll`` or ``load.*``; default: all. NetCDF gets whole variables.
    units
        Units of a CSV or Parquet file: ``names``, ``si`` or ``engineering`` (`frame`).

    Returns
    -------
    pathlib.Path
        The written file.

    Raises
    ------
    KingpostError
        If the ending is not allowed, the file cannot be written, a pattern matches no column, or units are
        given for NetCDF, which is always in SI.

    >>> import tempfile
    >>> from kingpost import run
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     write(run("paper", {"simulation.duration_s": 0.1}), f"{folder}/run.csv").name
    'run.csv'
    """
    path = check_output(path)
    ending = path.suffix.lower()
    check_patterns(results, patterns)
    check_units(units, path)
    if ending == ".nc":
        return output.write_netcdf(_variables(results, patterns), path)
    if ending == ".csv":
        output.write_csv(frame(results, patterns, units), path)
        for of, table in (("event", events(results)), ("warning", warnings(results))):
            beside = path.with_suffix(f".{of}s.csv")
            if table.sizes[of] or beside.exists():
                output.write_csv(table.to_dataframe(), beside)
    else:
        with output.whole(path) as beside:
            _write_parquet(results, beside, patterns, units)
    return path


def check_patterns(results: xarray.Dataset, patterns: Sequence[str]) -> None:
    """Make sure that each pattern matches the name of a column."""
    names = list(places(results))
    for pattern in patterns:
        if not any(fnmatchcase(name, pattern) for name in names):
            allowed = f"columns such as {nearest(pattern, names)}, or a pattern such as 'load.*'"
            raise KingpostError(f"--record: found {pattern!r}, allowed: {allowed}")


def _variables(results: xarray.Dataset, patterns: Sequence[str]) -> xarray.Dataset:
    """The variables with a column that matches one of the patterns, and the events, warnings and limits."""
    if not patterns:
        return results
    every = places(results).items()
    wanted = {of.variable for name, of in every if any(fnmatchcase(name, pattern) for pattern in patterns)}
    return with_entries_of(results[[name for name in results.data_vars if name in wanted]], results)


def _write_parquet(results: xarray.Dataset, path: Path, patterns: Sequence[str], units: str) -> None:
    import pyarrow
    import pyarrow.parquet

    table = pyarrow.Table.from_pandas(frame(results, patterns, units), preserve_index=False)
    si = {"time": unit_of(results["time"]), **{name: unit_of(series) for name, series in columns(results)}}
    fields = []
    for field in table.schema:
        unit = si[field.name.partition(" [")[0]]
        shown = engineering(unit)[0] if units == IN_ENGINEERING else unit
        fields.append(field.with_metadata({"units": shown}))
    attributes = {key: str(value) for key, value in results.attrs.items()} | {"entries": as_json(results)}
    metadata = {**(table.schema.metadata or {}), **attributes}
    checked = table.cast(pyarrow.schema(fields, metadata))
    pyarrow.parquet.write_table(checked, path, write_page_checksum=True)


def read(path: str | Path) -> xarray.Dataset:
    """Read a data set that `kingpost run -o FILE.nc` or `Batch` wrote.

    Parameters
    ----------
    path
        A NetCDF file.

    Returns
    -------
    xarray.Dataset
        The data set, in memory.

    Raises
    ------
    KingpostError
        If the file does not exist, is damaged, or is not a file of results.

    >>> import tempfile
    >>> from kingpost import run
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = write(run("paper", {"simulation.duration_s": 0.1}), f"{folder}/run.nc")
    ...     read(path).sizes["time"]
    11
    """
    xarray = xarrays.load()
    with _told(path):
        return _checked(xarray.load_dataset(path, engine="h5netcdf"), path)


def open_all(paths: Sequence[str | Path], time_limit_s: float = TIME_LIMIT_S) -> list[xarray.Dataset]:
    """Open files as data sets, whose numbers are read only when used.

    The files are first read to the end in a separate process, because the HDF5 library hangs or crashes on
    some damaged files.

    Parameters
    ----------
    paths
        NetCDF files.
    time_limit_s
        Time allowed for reading one file, s.

    Returns
    -------
    list of xarray.Dataset
        One for each file.

    Raises
    ------
    KingpostError
        As for `read`, and if a file cannot be read to its end.

    >>> import tempfile
    >>> from kingpost import run
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = write(run("paper", {"simulation.duration_s": 0.1}), f"{folder}/run.nc")
    ...     with open_all([path])[0] as found:
    ...         found.sizes["time"]
    11
    """
    xarray = xarrays.load()
    for path in paths:
        with _told(path):
            Path(path).open("rb").close()
    _probe([str(path) for path in paths], time_limit_s)
    found = []
    for path in paths:
        with _told(path):
            found.append(_checked(xarray.open_dataset(path, engine="h5netcdf", cache=False), path))
    return found


def is_whole(path: str | Path, time_limit_s: float = TIME_LIMIT_S) -> bool:
    """Whether the library can read a file to its end, tested in a separate process.

    Parameters
    ----------
    path
        File: NetCDF, other HDF5 if the name ends with ``.h5``, otherwise a mesh.
    time_limit_s
        Time allowed for reading the file, s.

    Returns
    -------
    bool
        False if the library fails, crashes or does not end.

    >>> import tempfile
    >>> path = Path(tempfile.mkdtemp()) / "cut.nc"
    >>> _ = path.write_bytes(HDF5)
    >>> is_whole(path)
    False
    """
    try:
        _probe([str(path)], time_limit_s)
    except KingpostError:
        return False
    return True


def _probe(paths: Sequence[str], time_limit_s: float) -> None:
    command = [sys.executable, "-P", str(Path(__file__).with_name("probe.py"))]
    try:
        # Suppress the HDF5 library's messages about damage, which do not help a user.
        done = subprocess.run(
            command,
            input=json.dumps(paths).encode(),
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            timeout=time_limit_s * len(paths),
        )
        through = done.stdout
    except subprocess.TimeoutExpired as late:
        through = late.stdout or b""
    said = [*through.decode().split(), "stopped"]
    for path, of_path in zip(paths, said, strict=False):
        if of_path != "read":
            raise _unreadable(path)


@contextmanager
def _told(path: str | Path) -> Iterator[None]:
    """Convert a failure to read a file into an error of one line."""
    try:
        if not Path(path).is_file():
            kind = output.irregular(path)
            what = "no such file" if kind is None else f"is {kind}"
            columns = "" if Path(path).suffix.lower() == ".nc" else "; columns follow --channels"
            raise KingpostError(f"{path}: {what}, {ALLOWED}{columns}")
        yield
    except KingpostError:
        raise
    except Exception as error:
        # On a damaged file the libraries raise exceptions of many types.
        raise _unreadable(path) from error


def _unreadable(path: str | Path) -> KingpostError:
    try:
        check_ends(path)
        with Path(path).open("rb") as file:
            is_hdf5 = file.read(len(HDF5)) == HDF5
    except (OSError, ValueError) as error:
        return KingpostError(f"{path}: {getattr(error, 'strerror', None) or error}, {ALLOWED}")
    return KingpostError(f"{path}: {DAMAGED if is_hdf5 else 'found a file that is not NetCDF'}, {ALLOWED}")


def _checked(found: xarray.Dataset, path: str | Path) -> xarray.Dataset:
    """Check that a data set has a time, and readable attributes, events, warnings and limits."""
    if "time" not in found.dims or "time" not in found.coords:
        raise KingpostError(f"{path}: found no dimension time, {ALLOWED}")
    time = found["time"].values
    if not (time.dtype.kind == "f" and time.size and np.isfinite(time).all()):
        raise KingpostError(f"{path}: {DAMAGED}, {ALLOWED}")
    if not is_of_a_run(found):
        raise KingpostError(f"{path}: {DAMAGED}, {ALLOWED}")
    for key, variable in found.variables.items():
        labels = dict.fromkeys((str(dim) for dim in variable.dims if dim not in OVER_RUNS), "")
        str(variable.attrs.get("column", key)).format_map(labels)
    return found

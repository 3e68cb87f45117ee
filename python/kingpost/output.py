"""Atomic writing: the package writes a file completely or not at all."""

from __future__ import annotations

import logging
import os
import stat
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from .errors import KingpostError, OutputError

if TYPE_CHECKING:
    import pandas
    import xarray

LOG = logging.getLogger(__name__)
KINDS = ((stat.S_ISDIR, "a folder"), (stat.S_ISFIFO, "a pipe"), (stat.S_ISSOCK, "a socket"))


@contextmanager
def whole(path: str | Path) -> Iterator[Path]:
    """Yield a temporary file beside `path`, with the same ending, for the block to write.

    When the block has ended and the data is on the disk, the new file replaces `path` in one step; for a
    symbolic link, the file that it points to. If the block fails or is stopped, the old file stays.

    >>> import tempfile
    >>> target = Path(tempfile.mkdtemp()) / "numbers.csv"
    >>> with whole(target) as beside:
    ...     _ = beside.write_text("1,2")
    >>> target.read_text()
    '1,2'

    Raises
    ------
    OutputError
        If the file cannot be written, for example on a full disk.
    """
    check_regular(path)
    target = Path(os.path.realpath(path))
    try:
        number, name = tempfile.mkstemp(dir=target.parent, prefix=f".{target.name}.", suffix=target.suffix)
        os.close(number)
        beside = Path(name)
        try:
            yield beside
            _flush(beside)
            beside.chmod(_mode(target))
            beside.replace(target)
            LOG.info("written: %s", target)
        finally:
            beside.unlink(missing_ok=True)
    except OSError as error:
        raise OutputError(target, error) from None


def write_text(path: str | Path, text: str) -> Path:
    """Write a text in UTF-8 without changing its line ends."""
    with whole(path) as beside:
        beside.write_text(text, encoding="utf-8", newline="")
    return Path(path)


def write_csv(table: pandas.DataFrame, path: str | Path) -> Path:
    """Write a table with its headings and without its index."""
    with whole(path) as beside:
        table.to_csv(beside, index=False)
    return Path(path)


def write_netcdf(dataset: xarray.Dataset, path: str | Path) -> Path:
    """Write a data set as NetCDF. The file is built in memory first, because the HDF5 library crashes on a
    full disk. Numbers have a checksum (Fletcher's), which every reader verifies."""
    arrays = ((name, one) for name, one in dataset.variables.items() if one.size and one.ndim)
    numbers = (name for name, one in arrays if one.dtype.kind in "fiu")
    checked = {name: {"fletcher32": True} for name in numbers}
    with whole(path) as beside:
        beside.write_bytes(dataset.to_netcdf(engine="h5netcdf", encoding=checked))
    return Path(path)


def check(path: str | Path, endings: Sequence[str]) -> Path:
    """Make sure, before a computation, that its results can be written to `path`.

    Raises
    ------
    KingpostError
        If the ending is not allowed; `OutputError` if the folder does not exist or cannot be written to.
    """
    path = Path(path)
    if path.suffix.lower() not in endings:
        raise KingpostError(f"{path}: unknown ending, allowed: {', '.join(endings)}")
    check_regular(path)
    try:
        existed = path.exists()
        with path.open("ab"):
            pass
        if not existed:
            path.unlink()
    except OSError as error:
        raise OutputError(path, error) from None
    return path


def check_regular(path: str | Path) -> None:
    """Refuse an existing path that is not a regular file: writing a pipe may block for ever, and a device
    would be replaced.

    Raises
    ------
    KingpostError
        If the path is a folder, a pipe, a socket or a device.

    >>> check_regular(os.devnull)
    Traceback (most recent call last):
        ...
    kingpost.errors.KingpostError: /dev/null: found a device, allowed: a regular file
    """
    kind = irregular(path)
    if kind is not None:
        raise KingpostError(f"{path}: found {kind}, allowed: a regular file")


def irregular(path: str | Path) -> str | None:
    """Name the kind of an irregular file; `None` for a regular file or a free path.

    >>> irregular(os.curdir), irregular("no/such/file")
    ('a folder', None)
    """
    try:
        mode = os.stat(path).st_mode
    except OSError:
        return None
    if stat.S_ISREG(mode):
        return None
    return next((words for is_kind, words in KINDS if is_kind(mode)), "a device")


def _flush(path: Path) -> None:
    """Wait until the file is on the disk: otherwise a power cut after the renaming would leave it empty."""
    with path.open("rb+") as file:
        os.fsync(file.fileno())


def _mode(target: Path) -> int:
    """Permissions of the replaced file; for a new file, the user's default permissions."""
    try:
        return target.stat().st_mode & 0o777
    except FileNotFoundError:
        mask = os.umask(0)
        os.umask(mask)
        return 0o666 & ~mask

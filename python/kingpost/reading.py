"""Texts and bytes of files that a user names: a pipe or a device is refused, because it may never end."""

from __future__ import annotations

import codecs
import errno
import re
from pathlib import Path

from .output import irregular

CSV_TEXT = "CSV in UTF-8 (in Excel: save as CSV UTF-8)"
"""Description of the allowed encoding of a table, with the choice to make in a spreadsheet."""
GROUPED = re.compile(r"[+-]?\d{1,3}(,\d{3})+")
"""A number whose commas may group thousands."""


def check_ends(path: str | Path) -> None:
    """Refuse an existing path that is not a regular file.

    Raises
    ------
    OSError
        If the path is a folder, a pipe, a socket or a device; `strerror` gives the reason.

    >>> import os
    >>> check_ends(os.devnull)
    Traceback (most recent call last):
        ...
    OSError: [Errno 22] a device, no regular file: '/dev/null'
    """
    kind = irregular(path)
    if kind is not None:
        raise OSError(errno.EINVAL, f"{kind}, no regular file", str(path))


def text_of(path: str | Path, encoding: str = "utf-8-sig", errors: str = "strict") -> str:
    """Text of a file. UTF-16 is recognised by its byte-order mark: spreadsheets write it as *Unicode text*.

    Raises
    ------
    OSError
        If the file cannot be read, or is not a regular file.
    UnicodeDecodeError
        If its bytes are not valid in this encoding.

    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = Path(folder) / "series.txt"
    ...     _ = path.write_text("time,hs", encoding="utf-16")
    ...     text_of(path)
    'time,hs'
    """
    check_ends(path)
    with open(path, "rb") as file:
        mark = file.read(2)
    if mark in (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE):
        encoding = "utf-16"
    return Path(path).read_text(encoding=encoding, errors=errors)


def decimal(cell: str, separator: str) -> float:
    """Parse the number in a table's cell, with a decimal point, or with a decimal comma if the cell is quoted
    or commas do not separate the columns.

    Raises
    ------
    ValueError
        If it is not a number, or a comma before three digits between quotes may group thousands.

    >>> decimal("1,5", ";"), decimal("1,5", ","), decimal("1.5", ",")
    (1.5, 1.5, 1.5)
    >>> decimal("1,500", ",")
    Traceback (most recent call last):
        ...
    ValueError: 1,500
    """
    if separator == "," and GROUPED.fullmatch(cell.strip()):
        raise ValueError(cell)
    return float(cell.replace(",", "."))

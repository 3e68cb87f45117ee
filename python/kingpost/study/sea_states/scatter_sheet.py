"""File of a scatter table: rows with their line numbers, and the settings in the lines above them."""

from __future__ import annotations

import csv
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from ...reading import decimal
from .errors import SeaFileError

CENTRES, LOWER, UPPER = "centres", "lower edges", "upper edges"
CLASSES = (CENTRES, LOWER, UPPER)
OCCURRENCES, PER_CENT = "occurrences", "per cent"
SPELLED = {
    **dict.fromkeys(("percent", "%", "percentages"), PER_CENT),
    **dict.fromkeys(("centre", "center", "centers"), CENTRES),
    **dict.fromkeys(("lower", "lower edge"), LOWER),
    **dict.fromkeys(("upper", "upper edge"), UPPER),
}
"""Other spellings of the settings' values."""


HEADER = (
    "a line that begins with Hs and which period, as Hs\\Tp or Hs/Tz: rows Hs, columns the period; "
    "or one with the names hs, tp (or tz), occurrences"
)
"""Description of the header of a table, for messages."""


class ScatterError(SeaFileError):
    """An error in a scatter table."""


@dataclass(frozen=True)
class Sheet:
    """Rows of a file with their line numbers, and the settings in the lines above them."""

    file: str | None
    header: list[str]
    header_line: int
    rows: list[tuple[int, list[str]]]
    separator: str
    classes: str | None
    entries: str

    @classmethod
    def of(
        cls,
        text: str,
        file: str | None,
        classes: str | None,
        entries: str | None,
        is_header: Callable[[Sequence[str]], bool],
    ) -> Sheet:
        """Parse the sheet of a text. Lines above the header are titles and are ignored."""
        said = {"classes": classes, "entries": entries}
        allowed = {"classes": CLASSES, "entries": (OCCURRENCES, PER_CENT)}
        lines = []
        for number, line in enumerate(text.splitlines(), 1):
            name, colon, value = line.lstrip("# ").partition(":")
            if line.startswith("#") and colon and name.strip().lower() in said:
                value = " ".join(value.strip(" ,;\t").lower().split())
                said[name.strip().lower()] = SPELLED.get(value, value)
                _check(name.strip().lower(), said, allowed, file, number)
            elif line.strip(" ,;\t") and not line.startswith("#"):
                lines.append((number, line))
        for name in said:
            _check(name, said, allowed, file, None)
        if len(lines) < 2:
            raise ScatterError("rows", len(lines), "a header and one row or more", file)
        first = next((k for k, (_, line) in enumerate(lines) if is_header(_cells(line, _sign(line)))), None)
        if first is None:
            found = f"none; the first line is {lines[0][1][:60]!r}"
            raise ScatterError("header", found, HEADER, file, lines[0][0])
        if first == len(lines) - 1:
            raise ScatterError("rows", "none under the header", "one or more", file, lines[first][0])
        sign = _sign(lines[first][1])
        rows = [(number, _cells(line, sign)) for number, line in lines[first:]]
        return cls(
            file,
            rows[0][1],
            rows[0][0],
            rows[1:],
            sign,
            said["classes"],
            said["entries"] or OCCURRENCES,
        )

    def error(self, field: str, found: object, allowed: str, line: int | None = None) -> ScatterError:
        return ScatterError(field, found, allowed, self.file, line)

    def number(self, cell: str, field: str, line: int, least: float = 0.0) -> float:
        """Parse a finite number not less than `least`."""
        try:
            value = decimal(cell, self.separator)
        except ValueError:
            value = np.nan
        if not (np.isfinite(value) and value >= least):
            raise self.error(field, repr(cell), f"a number, {least:g} or more", line)
        return value


def _sign(line: str) -> str:
    return next(sign for sign in ";\t," if sign in line or sign == ",")


def _cells(line: str, sign: str) -> list[str]:
    return [cell.strip() for cell in next(csv.reader([line], delimiter=sign))]


def _check(
    name: str,
    said: dict[str, str | None],
    allowed: dict[str, tuple[str, ...]],
    file: str | None,
    line: int | None,
) -> None:
    if said[name] is not None and said[name] not in allowed[name]:
        raise ScatterError(name, repr(said[name]), ", ".join(allowed[name]), file, line)

"""The file of a scatter table: rows with their lines, and what the lines above them say."""

from __future__ import annotations

import csv
from dataclasses import dataclass

import numpy as np

from ..errors import KingpostError

CENTRES, LOWER, UPPER = "centres", "lower edges", "upper edges"
CLASSES = (CENTRES, LOWER, UPPER)
OCCURRENCES, PER_CENT = "occurrences", "per cent"


class ScatterError(KingpostError):
    """A scatter table that is wrong.

    Attributes
    ----------
    file, line
        Where; `None` where there is no such place.
    field, found, allowed
        What is wrong, what stands there and what may stand there.
    """

    def __init__(
        self, field: str, found: object, allowed: str, file: str | None = None, line: int | None = None
    ):
        place = "".join(f"{part}:" for part in (file, line) if part is not None)
        super().__init__(f"{place} {field}: found {found}, allowed: {allowed}".strip())
        self.file, self.line, self.field, self.found, self.allowed = file, line, field, found, allowed


@dataclass(frozen=True)
class Sheet:
    """Rows of a file with their lines, and what the lines above them say."""

    file: str | None
    header: list[str]
    header_line: int
    rows: list[tuple[int, list[str]]]
    decimal_comma: bool
    classes: str | None
    entries: str

    @classmethod
    def of(cls, text: str, file: str | None, classes: str | None, entries: str | None) -> Sheet:
        said = {"classes": classes, "entries": entries}
        allowed = {"classes": CLASSES, "entries": (OCCURRENCES, PER_CENT)}
        lines = []
        for number, line in enumerate(text.splitlines(), 1):
            name, colon, value = line.lstrip("# ").partition(":")
            if line.startswith("#") and colon and name.strip().lower() in said:
                said[name.strip().lower()] = " ".join(value.lower().split())
                _check(name.strip().lower(), said, allowed, file, number)
            elif line.strip(" ,;\t") and not line.startswith("#"):
                lines.append((number, line))
        for name in said:
            _check(name, said, allowed, file, None)
        if len(lines) < 2:
            raise ScatterError("rows", len(lines), "a header and one row or more", file)
        sign = next(sign for sign in ";\t," if sign in lines[0][1] or sign == ",")
        rows = [
            (number, [cell.strip() for cell in next(csv.reader([line], delimiter=sign))])
            for number, line in lines
        ]
        return cls(
            file,
            rows[0][1],
            rows[0][0],
            rows[1:],
            sign != ",",
            said["classes"],
            said["entries"] or OCCURRENCES,
        )

    def error(self, field: str, found: object, allowed: str, line: int | None = None) -> ScatterError:
        return ScatterError(field, found, allowed, self.file, line)

    def number(self, cell: str, field: str, line: int, least: float = 0.0) -> float:
        """A number that is finite and not less than `least`."""
        try:
            value = float(cell.replace(",", ".") if self.decimal_comma else cell)
        except ValueError:
            value = np.nan
        if not (np.isfinite(value) and value >= least):
            raise self.error(field, repr(cell), f"a number, {least:g} or more", line)
        return value


def _check(
    name: str,
    said: dict[str, str | None],
    allowed: dict[str, tuple[str, ...]],
    file: str | None,
    line: int | None,
) -> None:
    if said[name] is not None and said[name] not in allowed[name]:
        raise ScatterError(name, repr(said[name]), ", ".join(allowed[name]), file, line)

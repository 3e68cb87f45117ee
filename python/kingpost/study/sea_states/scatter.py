"""Scatter tables of a site: occurrences by significant height and period.

A file is CSV, with commas, semicolons or tabs, in one of two forms.

A matrix has a row for each class of Hs and a column for each class of the period. The first cell of the
header gives the kind of the period: ``Hs\\Tp``, ``Hs/Tz``. The labels are ranges, ``0.5-1.0``, or numbers;
for numbers, a line above the table gives their meaning: ``# classes: centres``, ``lower edges`` or ``upper
edges``. The first range may be ``<6`` and the last ``>14``: such a class is as wide as its neighbour. With a
line ``# entries: per cent`` the entries add up to 100; otherwise they are occurrences. A last row or column
``total`` or ``sum`` and lines above the header, such as a title, are ignored::

    # classes: centres
    Hs\\Tp, 6, 8, 10
    0.5,   10, 20,  5
    1.5,    2, 15, 10

The long form has a line for each class or sea, with the columns ``hs``, ``tp`` (or ``tz``), ``occurrences``,
and optionally ``month`` (1 to 12) and ``direction_to_deg`` (that waves travel towards) or
``direction_from_deg``. Its Hs and periods are points: all occurrences of the entry have exactly these values.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ...reading import CSV_TEXT, text_of
from .periods import PEAK, kind_of, ratio
from .scatter_classes import edges
from .scatter_sheet import OCCURRENCES, PER_CENT, ScatterError, Sheet

if TYPE_CHECKING:
    from numpy.typing import NDArray

HEIGHTS = ("hs", "hm0", "swh", "significant_height_m")
COUNTS = (OCCURRENCES, "occurrence", "count", "frequency", PER_CENT, "percent", "probability")
TOTALS = ("total", "totals", "sum", "all")
UNITS = re.compile(r"\s*(?:[\[(](?:m|s|%|-)[\])])$")
"""Unit at the end of a column's name."""
MONTHS, FROM, TO = ("month",), ("direction_from_deg", "mwd"), ("direction_to_deg",)
SUM_OFF = 1.0
"""Largest rounding difference of the sum of entries in per cent from 100."""


@dataclass(frozen=True)
class ScatterTable:
    """Classes of sea states with the occurrences of each.

    Attributes
    ----------
    height_m, height_from_m, height_to_m
        Hs of each class: its centre and its edges, which are equal for a point.
    period_s
        Period of each class at its centre.
    occurrences
        Occurrences of each class, in any unit; classes with 0 are included.
    period
        ``peak`` or the kind of a mean period: see `kingpost.study.sea_states.periods`.
    month
        Month of each class, 1 to 12, or `None`.
    direction_rad
        Direction of each class that waves travel towards, or `None`.
    """

    height_m: NDArray[np.float64]
    height_from_m: NDArray[np.float64]
    height_to_m: NDArray[np.float64]
    period_s: NDArray[np.float64]
    occurrences: NDArray[np.float64]
    period: str = PEAK
    month: NDArray[np.int64] | None = None
    direction_rad: NDArray[np.float64] | None = None

    @property
    def total(self) -> float:
        """Sum of all occurrences."""
        return float(self.occurrences.sum())

    def with_peak_periods(self, peak_enhancement: float = 3.3) -> ScatterTable:
        """Convert the periods to peak periods, by the ratio of the two in a JONSWAP spectrum.

        >>> table = ScatterTable(*np.ones((5, 1)), period="zero_up_crossing")
        >>> round(table.with_peak_periods().period_s.item(), 2)
        1.29
        """
        peak_s = self.period_s / ratio(self.period, peak_enhancement)
        return replace(self, period_s=peak_s, period=PEAK)

    def cells(self) -> list[tuple[float, float]]:
        """Hs (m) and peak period (s) of the classes with occurrences, without repetitions, in the table's
        order."""
        of_peak = self.with_peak_periods()
        found = zip(of_peak.height_m.tolist(), of_peak.period_s.tolist(), self.occurrences, strict=True)
        return list({(height, period): None for height, period, count in found if count > 0})


def read(path: str | Path, classes: str | None = None, entries: str | None = None) -> ScatterTable:
    """Read a scatter table from a CSV file.

    Parameters
    ----------
    path
        The file.
    classes
        Meaning of the numbers beside a matrix, if the file does not state it: ``centres``, ``lower edges``,
        ``upper edges``.
    entries
        ``occurrences`` or ``per cent``, if the file does not state it.

    Returns
    -------
    ScatterTable
        Its classes.

    Raises
    ------
    ScatterError
        If the file cannot be read or is not a scatter table; the error names the line.
    """
    try:
        text = text_of(path)
    except OSError as error:
        raise ScatterError("file", error.strerror, "a file that can be read", str(path)) from None
    except UnicodeDecodeError:
        raise ScatterError("file", "bytes that are no text", CSV_TEXT, str(path)) from None
    return parse(text, str(path), classes, entries)


def parse(
    text: str, file: str | None = None, classes: str | None = None, entries: str | None = None
) -> ScatterTable:
    """Parse a scatter table from the text of a file: see `read`.

    Parameters
    ----------
    text
        CSV.
    file
        Its name, for errors.
    classes, entries
        As in `read`.

    Returns
    -------
    ScatterTable
        Its classes.

    Raises
    ------
    ScatterError
        If the text is not a scatter table; the error names the line.

    >>> table = parse("Hs/Tz,4-6,6-8\\n0-1,30,20\\n1-2,10,40")
    >>> table.period, table.height_m.tolist(), table.total
    ('zero_up_crossing', [0.5, 0.5, 1.5, 1.5], 100.0)
    """
    sheet = Sheet.of(text, file, classes, entries, _is_header)
    names = _names(sheet.header)
    found = _long(sheet, names) if any(name in HEIGHTS for name in names) else _matrix(sheet)
    if not found.total > 0:
        raise sheet.error("entries", f"a sum of {found.total:g}", "a sum greater than 0")
    if sheet.entries == PER_CENT and found.total > 100 + SUM_OFF:
        raise sheet.error("entries", f"a sum of {found.total:g} per cent", "100 per cent or less")
    return found


def _names(cells: Sequence[str]) -> list[str]:
    """Names of columns without their units."""
    return [UNITS.sub("", cell.strip().lower()) for cell in cells]


def _parts(first_cell: str) -> list[str]:
    return [part for part in re.split(r"[\\/|, ]+|\bvs\b", first_cell) if part]


def _is_header(cells: Sequence[str]) -> bool:
    """Whether a line is the header of a table, by its names or its first cell; titles may stand above it."""
    if sum(bool(cell) for cell in cells) < 2:
        return False
    return any(name in HEIGHTS for name in _names(cells)) or any(map(kind_of, _parts(cells[0])))


def _matrix(sheet: Sheet) -> ScatterTable:
    line = sheet.header_line
    parts = _parts(sheet.header[0])
    kinds = [kind for part in parts if (kind := kind_of(part)) is not None]
    if len(kinds) != 1 or (parts and kind_of(parts[0]) is not None and len(parts) > 1):
        allowed = "Hs and which period, as Hs\\Tp or Hs/Tz: rows Hs, columns the period"
        raise sheet.error("first cell", repr(sheet.header[0]), allowed, line)
    labels = sheet.header[1:]
    if labels and labels[-1].lower() in TOTALS:
        labels = labels[:-1]
    periods = edges(sheet, "period", [(line, label) for label in labels])
    rows = [(number, cells) for number, cells in sheet.rows if cells[0].lower() not in TOTALS]
    heights = edges(sheet, "Hs", [(number, cells[0]) for number, cells in rows])
    occurrences = []
    for number, cells in rows:
        if len(cells) not in (len(sheet.header), len(labels) + 1):
            raise sheet.error("cells", len(cells), f"{len(sheet.header)}, as the header has", number)
        occurrences += [
            sheet.number(cell, "entry", number) if cell else 0.0 for cell in cells[1 : len(labels) + 1]
        ]
    columns = len(labels)
    return ScatterTable(
        height_m=np.repeat(heights.mean(axis=1), columns),
        height_from_m=np.repeat(heights[:, 0], columns),
        height_to_m=np.repeat(heights[:, 1], columns),
        period_s=np.tile(periods.mean(axis=1), len(rows)),
        occurrences=np.array(occurrences),
        period=kinds[0],
    )


def _long(sheet: Sheet, names: Sequence[str]) -> ScatterTable:
    line = sheet.header_line

    def place(field: str, wanted: Sequence[str] | None) -> int | None:
        at = [k for k, name in enumerate(names) if (name in wanted if wanted else kind_of(name) is not None)]
        if len(at) > 1:
            raise sheet.error(field, ", ".join(names[k] for k in at), "one column of these", line)
        return at[0] if at else None

    height, period = place("Hs", HEIGHTS), place("period", None)
    count = place("occurrences", COUNTS)
    if height is None or period is None:
        raise sheet.error(
            "columns", ", ".join(names), "hs, tp (or tz), occurrences[, month][, direction_to_deg]", line
        )
    month, of_from, of_to = place("month", MONTHS), place("direction", FROM), place("direction", TO)
    if of_from is not None and of_to is not None:
        raise sheet.error("direction", "direction_from_deg and direction_to_deg", "one of them", line)
    rows = list(_numbers(sheet, len(names)))
    values = np.array([row for _, row in rows])
    if month is not None:
        for (number, _), value in zip(rows, values[:, month], strict=True):
            if value not in range(1, 13):
                raise sheet.error("month", f"{value:g}", "a whole number from 1 to 12", number)
    direction = None
    if of_from is not None or of_to is not None:
        to_deg = values[:, of_from] + 180 if of_from is not None else values[:, of_to or 0]
        direction = np.radians(to_deg % 360)
    heights = values[:, height]
    return ScatterTable(
        height_m=heights,
        height_from_m=heights,
        height_to_m=heights,
        period_s=values[:, period],
        occurrences=np.ones(len(values)) if count is None else values[:, count],
        period=str(kind_of(names[period])),
        month=None if month is None else values[:, month].astype(int),
        direction_rad=direction,
    )


def _numbers(sheet: Sheet, columns: int) -> Iterator[tuple[int, list[float]]]:
    for number, cells in sheet.rows:
        if len(cells) != columns:
            raise sheet.error("cells", len(cells), f"{columns}, as the header has", number)
        names = sheet.header
        yield (
            number,
            [
                sheet.number(cell, names[k], number, -360.0 if "direction" in names[k].lower() else 0.0)
                for k, cell in enumerate(cells)
            ],
        )

"""Classes of a scatter table: their edges from ranges, or from numbers beside the matrix."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from .scatter_sheet import CLASSES, LOWER, UPPER, Sheet

if TYPE_CHECKING:
    from numpy.typing import NDArray

NUMBER = r"(\d+(?:[.,]\d+)?)"
RANGE = re.compile(rf"\s*{NUMBER}\s*(?:-|\u2013|\.\.|to)\s*{NUMBER}\s*")
BELOW = re.compile(rf"\s*(?:<=?|\u2264|below|under)\s*{NUMBER}\s*")
ABOVE = re.compile(rf"\s*(?:(?:>=?|\u2265|above|over)\s*{NUMBER}|{NUMBER}\s*\+)\s*")


def edges(sheet: Sheet, field: str, labels: Sequence[tuple[int, str]]) -> NDArray[np.float64]:
    """Lower and upper edge of each class; a class ends where the next begins."""
    if not labels:
        raise sheet.error(field, "no class", "one or more", sheet.header_line)
    found = _from_ranges([label for _, label in labels])
    if found is None:
        found = _from_numbers(sheet, field, labels)
    for (line, label), (low, high) in zip(labels, found, strict=True):
        if not low < high:
            raise sheet.error(field, repr(label), "classes from low to high", line)
    for k in np.flatnonzero(found[1:, 0] < found[:-1, 1] - 1e-9).tolist():
        raise sheet.error(
            field, repr(labels[k + 1][1]), "classes that increase and do not overlap", labels[k + 1][0]
        )
    return found


def _from_ranges(labels: Sequence[str]) -> NDArray[np.float64] | None:
    """Edges of classes given as ranges; the first may lack a lower edge, the last an upper edge."""
    below, above = BELOW.fullmatch(labels[0]), ABOVE.fullmatch(labels[-1])
    closed = labels[1 if below else 0 : len(labels) - (1 if above else 0)]
    ranges = [RANGE.fullmatch(label) for label in closed]
    if not closed or not all(ranges):
        return None
    found = [[float(part.replace(",", ".")) for part in one.groups()] for one in ranges if one]
    if below:
        high = float(below[1].replace(",", "."))
        found.insert(0, [max(high - (found[0][1] - found[0][0]), 0.0), high])
    if above:
        low = float((above[1] or above[2]).replace(",", "."))
        found.append([low, low + found[-1][1] - found[-1][0]])
    return np.array(found)


def _from_numbers(sheet: Sheet, field: str, labels: Sequence[tuple[int, str]]) -> NDArray[np.float64]:
    values = np.array([sheet.number(label, field, line) for line, label in labels])
    if sheet.classes is None:
        allowed = f"ranges, as 0.5-1.0, or a line '# classes: ...' with one of {', '.join(CLASSES)}"
        raise sheet.error(field, f"numbers, as {labels[0][1]}", allowed, labels[0][0])
    for k in np.flatnonzero(np.diff(values) <= 0).tolist():
        raise sheet.error(field, repr(labels[k + 1][1]), "classes that increase", labels[k + 1][0])
    if len(values) == 1:
        raise sheet.error(field, "one class", "two or more, or a range as 0.5-1.0", labels[0][0])
    if sheet.classes == LOWER:
        return np.column_stack([values, np.append(values[1:], 2 * values[-1] - values[-2])])
    if sheet.classes == UPPER:
        first = max(2 * values[0] - values[1], 0.0)
        return np.column_stack([np.insert(values[:-1], 0, first), values])
    # Edges half way between centres; the first and the last class are symmetric about their centres, not
    # below 0.
    between = (values[1:] + values[:-1]) / 2
    first, last = 2 * values[0] - between[0], 2 * values[-1] - between[-1]
    return np.column_stack([np.insert(between, 0, max(first, 0.0)), np.append(between, last)])

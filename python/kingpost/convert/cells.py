"""Values of an input file with their places, notes on what becomes of them, and errors that name places."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field
from pathlib import Path

from ..errors import ScenarioError, printable, shortened

LONGEST_QUOTE = 60
"""Longest quote of a file in a note, characters."""
SMALLEST, LARGEST = 1e-30, 1e30
"""Magnitudes of numbers whose products and quotients are finite."""
NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")


@dataclass(frozen=True)
class Cell:
    """One value as it stands in a file, and its place."""

    text: str
    file: str
    line: int
    column: int

    def error(self, name: str, allowed: str, found: str | None = None) -> ScenarioError:
        """Build the error that this value is wrong.

        >>> print(Cell("steel", "deck.txt", 5, 14).error("LINE TYPES.EA", "a number"))
        deck.txt:5:14: LINE TYPES.EA: found 'steel', allowed: a number
        """
        given = repr(shortened(printable(self.text))) if found is None else found
        place = f"{self.file}:{self.line}:{self.column}"
        message = f"{place}: {name}: found {given}, allowed: {allowed}"
        return ScenarioError(message, self.file, self.line, self.column, name, given, allowed)

    def number(self, name: str, lowest: float = -math.inf, above: bool = False) -> float:
        """Parse a finite number.

        Parameters
        ----------
        name
            Field for the message.
        lowest
            Smallest allowed number.
        above
            Whether the number must be greater than `lowest`.

        >>> Cell("3.27e9", "deck.txt", 5, 14).number("EA", 0, above=True)
        3270000000.0
        """
        found = float(self.text) if NUMBER.fullmatch(self.text) else math.nan
        if math.isfinite(found) and found and not SMALLEST <= abs(found) <= LARGEST:
            raise self.error(name, f"0, or a number from {SMALLEST:g} to {LARGEST:g} in magnitude")
        if math.isfinite(found) and (found > lowest if above else found >= lowest):
            return found
        if lowest == -math.inf:
            raise self.error(name, "a number")
        raise self.error(name, f"a number {'greater than' if above else 'of at least'} {lowest:g}")

    def whole(self, name: str, lowest: int) -> int:
        """Parse a whole number.

        >>> Cell("20", "deck.txt", 9, 30).whole("NumSegs", 1)
        20
        """
        if self.text.isascii() and self.text.isdigit() and len(self.text) < 10 and int(self.text) >= lowest:
            return int(self.text)
        raise self.error(name, f"a whole number of at least {lowest}")


@dataclass(frozen=True)
class Note:
    """Part of a file that is left out or written in another form.

    Attributes
    ----------
    line
        Line of the file; `None` for a value that the file does not contain.
    text
        The part of the file.
    why
        The reason, or the new form.
    """

    line: int | None
    text: str
    why: str


@dataclass
class Notes:
    """Notes on a conversion.

    Attributes
    ----------
    left_out
        Parts that are not in the scenario.
    converted
        Parts that are in it in another form, and values that were chosen.
    """

    left_out: list[Note] = field(default_factory=list)
    converted: list[Note] = field(default_factory=list)

    def leave_out(self, line: int | None, text: str, why: str) -> None:
        """Note a part that is left out."""
        self.left_out.append(Note(line, _quote(text), why))

    def convert(self, line: int | None, text: str, why: str) -> None:
        """Note a part that is written in another form."""
        self.converted.append(Note(line, _quote(text), why))

    def sorted(self) -> Notes:
        """Notes in the order of the file, without repetitions; those on no line are last."""

        def in_order(notes: list[Note]) -> list[Note]:
            return sorted(dict.fromkeys(notes), key=lambda note: (note.line is None, note.line or 0))

        return Notes(in_order(self.left_out), in_order(self.converted))


def _quote(text: str) -> str:
    return shortened(printable(" ".join(text.split())), LONGEST_QUOTE)


def unreadable(path: str | Path, why: object, allowed: str) -> ScenarioError:
    """Build the error that a file cannot be read as a whole."""
    words = getattr(why, "strerror", None) or str(why)
    said = shortened(printable(" ".join(words.split())), 300)
    message = f"{path}: found {said}, allowed: {allowed}"
    return ScenarioError(message, str(path), None, None, None, said, allowed)

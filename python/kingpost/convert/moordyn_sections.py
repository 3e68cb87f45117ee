"""The sections of a MoorDyn input file and their rows."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field
from pathlib import Path

from ..errors import ScenarioError
from ..reading import text_of
from .cells import Cell, unreadable

ALLOWED = "a MoorDyn input file, with the sections LINE TYPES, POINTS, LINES and OPTIONS"
RULE = "---"
LABELS = 2
"""Lines of headings and units at the beginning of a table."""
SECTIONS = {
    "LINE TYPES": ("LINE TYPES", "LINE DICTIONARY"),
    "ROD TYPES": ("ROD TYPES", "ROD DICTIONARY"),
    "BODIES": ("BODIES", "BODY LIST", "BODY PROPERTIES"),
    "RODS": ("RODS", "ROD LIST", "ROD PROPERTIES"),
    "POINTS": ("POINTS", "POINT LIST", "POINT PROPERTIES", "CONNECTION PROPERTIES", "NODE PROPERTIES"),
    "LINES": ("LINES", "LINE LIST", "LINE PROPERTIES"),
    "SYROPE IC": ("SYROPE IC",),
    "FAILURE": ("FAILURE",),
    "CONTROL": ("CONTROL",),
    "EXTERNAL LOADS": ("EXTERNAL LOADS",),
    "OPTIONS": ("OPTIONS",),
    "OUTPUTS": ("OUTPUT",),
}
"""Words of a section's header, by the section's name."""
WITHOUT_LABELS = ("OPTIONS", "OUTPUTS")
UNKNOWN = "an unknown section"
END = ("NEED THIS LINE", "END OF")


@dataclass(frozen=True)
class Row:
    """A line of a section."""

    cells: tuple[Cell, ...]
    text: str
    line: int
    section: str

    def __len__(self) -> int:
        return len(self.cells)

    def __getitem__(self, column: int) -> Cell:
        return self.cells[column]

    def require(self, columns: int, names: str) -> None:
        """Refuse a row with fewer values than its table has columns."""
        if len(self) < columns:
            raise self.cells[-1].error(self.section, f"{columns}: {names}", f"{len(self)} values")

    def number(self, column: int, name: str, lowest: float = -math.inf, above: bool = False) -> float:
        """Parse a number of the row; `name` is the column's."""
        return self.cells[column].number(f"{self.section}.{name}", lowest, above)


@dataclass
class Section:
    """A section of a file: its header's line, its headings and its rows."""

    name: str
    line: int
    headings: tuple[str, ...] = ()
    rows: list[Row] = field(default_factory=list)


@dataclass
class Sections:
    """A MoorDyn input file in sections, with the title that stands before them."""

    file: str
    title: str
    each: list[Section]

    def rows(self, name: str) -> list[Row]:
        """Rows of all sections of a name."""
        return [row for section in self.each if section.name == name for row in section.rows]

    def first(self, name: str) -> Section:
        """First section of a name.

        Raises
        ------
        ScenarioError
            If the file has none, or one without rows.
        """
        found = [section for section in self.each if section.name == name]
        if found and any(section.rows for section in found):
            return found[0]
        said = f"a section {name} without rows" if found else f"no section {name}"
        line = found[0].line if found else None
        place = self.file if line is None else f"{self.file}:{line}"
        message = f"{place}: {name}: found {said}, allowed: {ALLOWED}"
        raise ScenarioError(message, self.file, line, None, name, said, ALLOWED)


def read(path: str | Path) -> Sections:
    """Read the sections of a file.

    Raises
    ------
    ScenarioError
        If it cannot be read, or has no section.
    """
    try:
        lines = text_of(path, errors="replace").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise unreadable(path, error, ALLOWED) from None
    each: list[Section] = []
    title, current, labels = "", None, 0
    for number, line in enumerate(lines, 1):
        if RULE in line:
            current = _section(line, number, bool(each))
            labels = 0 if current is None or current.name in WITHOUT_LABELS else LABELS
            each += [current] if current is not None else []
        elif current is None:
            title = title or ("" if each else line.strip())
        elif labels:
            labels -= 1
            current.headings = current.headings or tuple(line.upper().split())
        elif cells := _cells(line, str(path), number):
            current.rows.append(Row(cells, line.strip(), number, current.name))
    if not any(section.name != UNKNOWN for section in each):
        raise unreadable(path, "no section with a known header", ALLOWED)
    return Sections(str(path), title, each)


def _section(header: str, number: int, is_after_first: bool) -> Section | None:
    """Section that a header begins; `None` for the end of the sections, and for the title's header."""
    words = " ".join(header.upper().replace("-", " ").split())
    for name, keys in SECTIONS.items():
        if any(re.search(rf"\b{key}", words) for key in keys):
            return Section(name, number)
    is_end = not words or words == "END" or any(end in words for end in END)
    return Section(UNKNOWN, number) if is_after_first and not is_end else None


def _cells(line: str, file: str, number: int) -> tuple[Cell, ...]:
    """Values of a line, without its comment, which begins at a word with a `#`."""
    found = []
    for word in re.finditer(r"\S+", line):
        if "#" in word[0]:
            break
        found.append(Cell(word[0], file, number, word.start() + 1))
    return tuple(found)

"""Reader of MoorDyn input files, of version 2 and in the columns of version 1."""

from __future__ import annotations

from pathlib import Path

from ..errors import ScenarioError
from . import moordyn_options, moordyn_sections, moordyn_types
from .cells import unreadable
from .deck import Deck, Point, Segment
from .moordyn_bodies import carrier, check_number, read_bodies, read_rods, words_of
from .moordyn_sections import Row, Sections

POINT_COLUMNS = "ID, attachment, X, Y, Z, mass, volume, CdA, Ca"
LINE_COLUMNS = "ID, type, AttachA, AttachB, UnstrLen, NumSegs"
LINE_COLUMNS_OF_V1 = "ID, type, UnstrLen, NumSegs, NodeAnch, NodeFair"
LEFT_OUT = {
    "ROD TYPES": "rods have no counterpart",
    "SYROPE IC": "lines of polyester by the Syrope model have no counterpart",
    "FAILURE": "lines do not break; a step of `operation` can switch a line off",
    "CONTROL": "lengths of lines do not change",
    "EXTERNAL LOADS": "constant forces and damping of objects have no counterpart",
    "OUTPUTS": "a run records all channels; --record chooses some",
    moordyn_sections.UNKNOWN: "an unknown section",
}
"""Reasons by section of which no row is carried over."""


def read(path: str | Path) -> Deck:
    """Read a MoorDyn input file.

    Raises
    ------
    ScenarioError
        If it cannot be read, or a value in it is wrong.
    """
    sections = moordyn_sections.read(path)
    deck = Deck(sections.file, sections.title)
    moordyn_options.read(sections, deck)
    deck.types = moordyn_types.read(sections)
    read_bodies(sections, deck)
    rod_ends = read_rods(sections, deck)
    _read_points(sections, deck)
    _read_lines(sections, deck, rod_ends)
    for name, why in LEFT_OUT.items():
        for row in sections.rows(name):
            deck.notes.leave_out(row.line, row.text, why)
    return deck


def _read_points(sections: Sections, deck: Deck) -> None:
    for number, row in enumerate(sections.rows("POINTS"), 1):
        row.require(9, POINT_COLUMNS)
        check_number(row, number)
        body = carrier(row[1], "POINTS.attachment", deck)
        x, y = row.number(2, "X"), row.number(3, "Y")
        on_seabed = row[4].text.lower() == "seabed"
        z = -deck.water.depth_m if on_seabed else row.number(4, "Z")
        # Rows of 12 values have a constant force before the drag.
        last = 10 if len(row) >= 12 else 7
        if last == 10 and any(row.number(7 + k, name) for k, name in enumerate(("FX", "FY", "FZ"))):
            text = " ".join(cell.text for cell in row.cells[7:10])
            deck.notes.leave_out(row.line, f"FX, FY, FZ {text}", "a constant force has no counterpart")
        deck.points[f"point_{number}"] = Point(
            f"point_{number}", row.line, body, (x, y, z), row.number(5, "Mass", 0),
            row.number(6, "Volume", 0), row.number(last, "CdA", 0), row.number(last + 1, "Ca", 0),
        )  # fmt: skip


def _read_lines(sections: Sections, deck: Deck, rod_ends: dict[str, str | None]) -> None:
    sections.first("LINES")
    is_v1 = moordyn_types.is_first_version(sections)
    # Columns of the ends, the length and the segments.
    a, b, length, segments = (4, 5, 2, 3) if is_v1 else (2, 3, 4, 5)
    for number, row in enumerate(sections.rows("LINES"), 1):
        row.require(6, LINE_COLUMNS_OF_V1 if is_v1 else LINE_COLUMNS)
        check_number(row, number)
        kind = deck.types.get(row[1].text)
        if kind is None:
            raise row[1].error("LINES.LineType", f"one of {', '.join(deck.types)}")
        _note_outputs(row, deck)
        ends = _end(row, a, "AttachA", deck, rod_ends), _end(row, b, "AttachB", deck, rod_ends)
        span = row.number(length, "UnstrLen", 0, above=True)
        count = row[segments].whole("LINES.NumSegs", 1)
        if ends[0] is None or ends[1] is None:
            why = "one of its ends is on a rod, which has no counterpart"
            deck.notes.leave_out(row.line, row.text, why)
        elif ends[0] == ends[1]:
            raise row[b].error("LINES.AttachB", "another point than at the first end")
        else:
            segment = Segment(f"line_{number}", row.line, kind, (ends[0], ends[1]), span, count)
            deck.lines.append(segment)


def _note_outputs(row: Row, deck: Deck) -> None:
    outputs = "".join(cell.text for cell in row.cells[6:])
    if outputs.strip("-"):
        why = "a run records the tension at both ends of each line"
        deck.notes.leave_out(row.line, f"outputs {outputs}", why)


def _end(row: Row, column: int, name: str, deck: Deck, rod_ends: dict[str, str | None]) -> str | None:
    """Name of the point at an end; `None` for the end of a rod that has no place."""
    cell = row[column]
    word, number, letter = words_of(cell.text)
    if word in ("R", "ROD") and number is not None and letter in ("A", "B"):
        if f"{number}{letter}" not in rod_ends:
            raise cell.error(f"LINES.{name}", "a number of POINTS, or an end of one of the RODS")
        return rod_ends[f"{number}{letter}"]
    if word in ("", "C", "CON", "P", "POINT") and f"point_{number}" in deck.points:
        return f"point_{number}"
    count = sum(point.startswith("point_") for point in deck.points)
    raise cell.error(
        f"LINES.{name}", f"a number of POINTS, from 1 to {count}, or an end of a rod, such as R1A"
    )


def without_lines(deck: Deck) -> ScenarioError:
    """Build the error that no line of a deck can be converted."""
    return unreadable(deck.file, "no line whose ends have places", "at least one line between points")

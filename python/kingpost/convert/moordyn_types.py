"""LINE TYPES of a MoorDyn input file."""

from __future__ import annotations

from pathlib import Path

from ..reading import text_of
from .cells import NUMBER, Cell, Notes
from .deck import LineType
from .moordyn_sections import Row, Sections

COLUMNS = "name, diameter, mass, EA, BA, EI, Cd, Ca, CdAx, CaAx"
COLUMNS_OF_V1 = "name, diameter, mass, EA, BA, Can, Cat, Cdn, Cdt"
COUNT, COUNT_OF_V1 = 10, 9
CURVE_HEADINGS = 3
"""Lines before the points in a file of stiffness over strain."""


def is_first_version(sections: Sections) -> bool:
    """Whether the file is of MoorDyn 1, whose line types have no EI."""
    rows = sections.rows("LINE TYPES")
    return bool(rows) and len(rows[0]) == COUNT_OF_V1


def read(sections: Sections) -> dict[str, LineType]:
    """Read the line types by name, each with notes that apply if a line uses it."""
    section = sections.first("LINE TYPES")
    is_v1 = is_first_version(sections)
    found: dict[str, LineType] = {}
    for row in sections.rows("LINE TYPES"):
        row.require(COUNT_OF_V1 if is_v1 else COUNT, COLUMNS_OF_V1 if is_v1 else COLUMNS)
        name = row[0].text
        if name in found:
            allowed = f"another name than that of line {found[name].line}"
            raise row[0].error("LINE TYPES.name", allowed)
        found[name] = _line_type(row, section.headings, is_v1)
    return found


def _line_type(row: Row, headings: tuple[str, ...], is_v1: bool) -> LineType:
    notes = Notes()
    stiffness = _stiffness(row, notes)
    damping = _damping(row, notes)
    if is_v1:
        added, added_along, drag, drag_along = _coefficients(row, 5, "Can Cat Cdn Cdt")
        bending = 0.0
    else:
        drag, added, drag_along, added_along = _coefficients(row, 6, "Cd Ca CdAx CaAx")
        bending = _bending(row, notes)
        _vibration(row, notes)
        if headings[6:7] in (("CAN",), ("CA",)):
            why = "read as Cd, Ca, CdAx, CaAx, by place as in MoorDyn 2: the headings have another order"
            notes.convert(row.line, " ".join(cell.text for cell in row.cells[6:COUNT]), why)
    return LineType(
        row[0].text, row.line, row.number(1, "Diam", 0, above=True), row.number(2, "Mass/m", 0, above=True),
        stiffness, damping, bending, drag, drag_along, added, added_along, notes,
    )  # fmt: skip


def _coefficients(row: Row, first: int, names: str) -> list[float]:
    return [row.number(first + k, name, 0) for k, name in enumerate(names.split())]


def _part(cell: Cell, index: int = 0) -> Cell:
    """One of the values of a cell that bars separate."""
    parts = cell.text.split("|")
    column = cell.column + sum(len(part) + 1 for part in parts[:index])
    return Cell(parts[index], cell.file, cell.line, column)


def _stiffness(row: Row, notes: Notes) -> float:
    cell = row[3]
    static = _part(cell)
    if "|" in cell.text:
        why = "viscoelastic stiffness has no counterpart; the line has the first value, the static stiffness"
        notes.leave_out(row.line, f"EA {cell.text}", why)
    if NUMBER.fullmatch(static.text):
        return static.number("LINE TYPES.EA", 0, above=True)
    found = _secant(static)
    why = f"a curve has no counterpart; the line has EA {found:.6g} N, the slope to the last point"
    notes.leave_out(row.line, f"EA {static.text}", why)
    return found


def _secant(cell: Cell) -> float:
    """Tension over strain at the last point of the file that a cell names."""
    allowed = "a number greater than 0, N, or a file beside this one with strains and tensions"
    try:
        lines = text_of(Path(cell.file).parent / cell.text.strip("\"'")).splitlines()[CURVE_HEADINGS:]
        rows = [[float(word) for word in line.split()[:2]] for line in lines if line.strip(" -")]
        strain, tension = rows[-1]
    except (OSError, ValueError, IndexError):
        raise cell.error("LINE TYPES.EA", allowed) from None
    if not (strain > 0 and 0 < tension / strain < float("inf")):
        raise cell.error("LINE TYPES.EA", allowed)
    return tension / strain


def _damping(row: Row, notes: Notes) -> float | None:
    cell = row[4]
    static = _part(cell)
    if "|" in cell.text:
        why = "viscoelastic damping has no counterpart; the line has the first value, the static damping"
        notes.leave_out(row.line, f"BA {cell.text}", why)
    if NUMBER.fullmatch(static.text):
        return static.number("LINE TYPES.BA")
    why = (
        "damping over the rate of strain has no counterpart; the line has the engine's default damping_time_s"
    )
    notes.leave_out(row.line, f"BA {static.text}", why)
    return None


def _bending(row: Row, notes: Notes) -> float:
    text = row[5].text
    if not NUMBER.fullmatch(text):
        notes.leave_out(row.line, f"EI {text}", "a curve of moments has no counterpart")
        return 0.0
    bending = row.number(5, "EI", 0)
    if bending:
        why = "a line with bending stiffness also pushes here; in MoorDyn it becomes slack"
        notes.convert(row.line, f"EI {text}", why)
    return bending


def _vibration(row: Row, notes: Notes) -> None:
    if len(row) > COUNT and row.number(COUNT, "Cl"):
        text = " ".join(cell.text for cell in row.cells[COUNT:])
        notes.leave_out(row.line, f"Cl, dF, cF: {text}", "vortex-induced vibration has no counterpart")

"""BODIES and RODS of a MoorDyn input file, and what points and rods are attached to."""

from __future__ import annotations

import math
import re

from .cells import Cell
from .deck import VESSEL, WORLD, Body, Deck, Point, Vector
from .moordyn_sections import Row, Sections

BODY_COLUMNS = "ID, attachment, X0, Y0, Z0, r0, p0, y0, mass, CG, I, volume, CdA, Ca"
ROD_COLUMNS = "ID, type, attachment, Xa, Ya, Za, Xb, Yb, Zb, NumSegs"
FIXED = ("ANCHOR", "FIXED", "FIX")
COUPLED = ("FAIRLEAD", "VESSEL", "VES", "COUPLED", "CPLD")
PINNED = ("VESSELPINNED", "VESPIN", "CPLDPIN", "COUPLEDPINNED")
FREE = ("POINT", "CONNECT", "CON", "FREE")
ATTACHMENTS = "Fixed, Coupled (or Vessel), Free (or Connect), Body1, Body2, ..."


def words_of(text: str) -> tuple[str, int | None, str]:
    """Letters, number and further letters of an attachment.

    >>> words_of("Body1Pinned"), words_of("fixed"), words_of("R2A")
    (('BODY', 1, 'PINNED'), ('FIXED', None, ''), ('R', 2, 'A'))
    """
    found = re.fullmatch(r"([A-Z_]*)(\d{0,9})([A-Z_]*)", text.upper())
    if found is None:
        return "", None, ""
    return found[1], int(found[2]) if found[2] else None, found[3]


def check_number(row: Row, expected: int) -> None:
    """Refuse a row whose number does not follow that of the row before it."""
    if row[0].text != str(expected):
        raise row[0].error(f"{row.section}.ID", f"{expected}: numbers rise by one from 1")


def vector(row: Row, column: int, names: str) -> Vector:
    """Three numbers from a column on."""
    x, y, z = (row.number(column + k, name) for k, name in enumerate(names.split()))
    return x, y, z


def listed(cell: Cell, name: str, counts: tuple[int, ...], lowest: float = -math.inf) -> list[float]:
    """Numbers of a cell that bars separate."""
    parts = cell.text.split("|")
    if len(parts) not in counts:
        words = " or ".join(str(count) for count in counts)
        raise cell.error(name, f"{words} numbers with | between them")
    return [Cell(part, cell.file, cell.line, cell.column).number(name, lowest) for part in parts]


def carrier(cell: Cell, name: str, deck: Deck) -> str | None:
    """Name of the body that carries a point, `WORLD`, or `None` for a free point.

    The vessel is added to the deck when the first point needs it.
    """
    word, number, _ = words_of(cell.text)
    if word in FIXED:
        return WORLD
    if word in FREE:
        return None
    if word == "BODY" and number is not None:
        if f"body_{number}" not in deck.bodies:
            count = sum(body.startswith("body_") for body in deck.bodies)
            raise cell.error(name, f"one of the {count} bodies in BODIES")
        return f"body_{number}"
    if word == "TURBINE" and number is not None:
        deck.notes.convert(
            cell.line, cell.text, "a held body at the origin: its place is in the driver's file"
        )
        return _held(deck, f"turbine_{number}")
    if word in COUPLED or word in PINNED:
        return _held(deck, VESSEL)
    raise cell.error(name, ATTACHMENTS)


def _held(deck: Deck, name: str) -> str:
    deck.bodies.setdefault(name, Body(name, None, "held"))
    return name


def read_bodies(sections: Sections, deck: Deck) -> None:
    """Read the bodies into the deck."""
    for number, row in enumerate(sections.rows("BODIES"), 1):
        row.require(14, BODY_COLUMNS)
        check_number(row, number)
        word = words_of(row[1].text)[0]
        motion = (
            "fixed"
            if word in FIXED
            else "held"
            if word in COUPLED
            else "pinned"
            if word in PINNED
            else "free"
        )
        centre = listed(row[9], "BODIES.CG", (1, 3))
        moments = listed(row[10], "BODIES.I", (1, 3), 0)
        drag = listed(row[12], "BODIES.CdA", (1, 2, 3, 6), 0)
        added = listed(row[13], "BODIES.Ca", (1, 3), 0)
        deck.bodies[f"body_{number}"] = Body(
            f"body_{number}", row.line, motion, vector(row, 2, "X0 Y0 Z0"), _orientation(row, deck),
            row.number(8, "Mass", 0), (0.0, 0.0, centre[0]) if len(centre) == 1 else _three(centre),
            _three(moments), row.number(11, "Volume", 0), _three(drag[:3] if len(drag) != 2 else drag[:1]),
            _three(added),
        )  # fmt: skip
        if len(drag) in (2, 6) and any(drag[len(drag) // 2 :]):
            deck.notes.leave_out(row.line, f"CdA {row[12].text}", "drag against rotation has no counterpart")


def _three(numbers: list[float]) -> Vector:
    x, y, z = numbers if len(numbers) == 3 else numbers * 3
    return x, y, z


UPRIGHT = 1e-9
"""Horizontal part of an axis, as a share of it, that is rounding."""


def _orientation(row: Row, deck: Deck) -> Vector:
    """Roll, pitch and yaw, rad, by intrinsic z-y-x angles, from intrinsic x-y-z angles in degrees."""
    from scipy.spatial.transform import Rotation

    angles = vector(row, 5, "r0 p0 y0")
    turned = Rotation.from_euler("XYZ", angles, degrees=True).as_matrix()
    level = math.hypot(turned[0, 0], turned[1, 0])
    pitch = math.atan2(-turned[2, 0], level)
    if level > UPRIGHT:
        yaw = math.atan2(turned[1, 0], turned[0, 0])
        roll = math.atan2(turned[2, 1], turned[2, 2])
    else:
        # At a pitch of 90 degrees one of many triples of angles is as good as another.
        yaw, roll = math.atan2(-turned[0, 1], turned[1, 1]), 0.0
    if sum(angle != 0 for angle in angles) > 1:
        text = " ".join(cell.text for cell in row.cells[5:8])
        deck.notes.convert(row.line, text, "angles about x, y, z in turn are written as roll, pitch, yaw")
    return roll, pitch, yaw


def read_rods(sections: Sections, deck: Deck) -> dict[str, str | None]:
    """Note the rods as left out, and keep their ends as points where these have a place.

    Returns
    -------
    dict
        Names of points by a rod's end, such as `1A`; `None` for an end without a place.
    """
    ends: dict[str, str | None] = {}
    for number, row in enumerate(sections.rows("RODS"), 1):
        row.require(10, ROD_COLUMNS)
        check_number(row, number)
        word, _, further = words_of(row[2].text)
        a, b = vector(row, 3, "Xa Ya Za"), vector(row, 6, "Xb Yb Zb")
        ends |= {f"{number}A": None, f"{number}B": None}
        is_short = row[9].whole("RODS.NumSegs", 0) == 0
        is_pinned = "PIN" in word or "PIN" in further
        body = WORLD if word in ("PINNED", "PIN") else carrier(row[2], "RODS.attachment", deck)
        why = "rods have no counterpart"
        if body is None and is_short:
            point = Point(f"rod_{number}", row.line, None, a)
            deck.points[point.name] = point
            ends |= {f"{number}A": point.name, f"{number}B": point.name}
            why += "; lines connect at its place without mass, drag and bending stiffness"
        elif body is not None:
            kept = [("A", a)] if is_pinned else [("A", a), ("B", b)]
            for letter, place in kept:
                point = Point(f"rod_{number}{letter.lower()}", row.line, body, place)
                deck.points[point.name] = point
                ends[f"{number}{letter}"] = point.name
            why += f"; a line may connect at {'end A' if is_pinned else 'its ends'}"
        deck.notes.leave_out(row.line, row.text, why)
    return ends

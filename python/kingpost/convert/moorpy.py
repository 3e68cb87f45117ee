"""Reader of MoorPy's YAML files: line types, points and lines by name."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from ..reading import text_of
from .cells import Cell, Notes, unreadable
from .deck import VESSEL, WORLD, Body, Deck, LineType, Point, Segment

if TYPE_CHECKING:
    import yaml

ALLOWED = "a MoorPy file in YAML, with line_types, points and lines"
DEEPEST = 50
SEGMENTS, STEP_S = 40, 0.01
"""Segments of a line, as in MoorPy, and the step of the run: the files have neither."""
DRAG = {"transverse_drag": 1.2, "tangential_drag": 0.0,
        "transverse_added_mass": 1.0, "tangential_added_mass": 0.0}  # fmt: skip
"""The engine's coefficients, for types without their own."""
KNOWN = ("water_depth", "rho", "water_density", "line_types", "points", "lines", "file")


@dataclass
class Entry:
    """A mapping of the file, with the cells of its values."""

    name: str
    place: Cell
    values: dict[str, yaml.Node]

    def cell(self, key: str, allowed: str = "a value") -> Cell:
        """Value of a key.

        Raises
        ------
        ScenarioError
            If there is none.
        """
        found = self.optional(key)
        if found is None:
            raise self.place.error(f"{self.name}.{key}", allowed, "nothing")
        return found

    def optional(self, key: str) -> Cell | None:
        """Value of a key; `None` if there is none."""
        node = self.values.get(key)
        return None if node is None else _cell(node, self.place.file)

    def number(self, key: str, lowest: float, above: bool = False) -> float:
        """Number of a key that must be there."""
        return self.cell(key, "a number").number(f"{self.name}.{key}", lowest, above)

    def entries(self, key: str) -> Iterator[Entry]:
        """Mappings of a list."""
        node = self.values.get(key)
        items = node.value if node is not None and node.id == "sequence" else None
        if not items:
            place = self.place if node is None else _cell(node, self.place.file)
            raise place.error(f"{self.name}{key}", "a list of mappings", "nothing" if node is None else None)
        for k, item in enumerate(items):
            yield entry(f"{self.name}{key}.{k}", item, self.place.file)

    def leave_out(self, notes: Notes, known: tuple[str, ...], why: dict[str, str]) -> None:
        """Note the keys that are not read."""
        for key, node in self.values.items():
            if key not in known:
                notes.leave_out(
                    node.start_mark.line + 1, f"{key}: {_cell(node, '').text}", why.get(key, "not read")
                )


def entry(name: str, node: yaml.Node, file: str) -> Entry:
    """Mapping of a node."""
    place = _cell(node, file)
    if node.id != "mapping":
        raise place.error(name, "a mapping")
    return Entry(name, place, {str(key.value): value for key, value in node.value})


def _cell(node: yaml.Node, file: str) -> Cell:
    text = node.value if node.id == "scalar" else {"mapping": "a mapping", "sequence": "a list"}[node.id]
    return Cell(str(text), file, node.start_mark.line + 1, node.start_mark.column + 1)


def read(path: str | Path) -> Deck:
    """Read a MoorPy file.

    Raises
    ------
    ScenarioError
        If it cannot be read, or a value in it is wrong.
    """
    whole = entry("", _root(path), str(path))
    deck = Deck(str(path))
    data, site = _mooring(whole, deck)
    if "file" in data.values and data.cell("file").text:
        raise data.cell("file").error("file", "no file: convert the MoorDyn file itself")
    _read_water(data, site, deck)
    for one in data.entries("line_types"):
        kind = _line_type(one, deck)
        deck.types[kind.name] = kind
    for one in data.entries("points"):
        _read_point(one, deck)
    for k, one in enumerate(data.entries("lines")):
        _read_line(one, f"line_{k + 1}", deck)
    deck.step_s = STEP_S
    deck.notes.convert(None, "no time step", f"simulation.step_s is {STEP_S:g} s")
    deck.notes.convert(None, "no segments", f"{SEGMENTS} segments for each line, as in MoorPy")
    deck.notes.convert(None, "no damping of lines", "damping_time_s is the engine's default")
    return deck


def _root(path: str | Path) -> yaml.Node:
    import yaml

    try:
        text = text_of(path)
        depth = 0
        for event in yaml.parse(text, Loader=yaml.SafeLoader):
            depth += isinstance(event, yaml.CollectionStartEvent)
            depth -= isinstance(event, yaml.CollectionEndEvent)
            if depth > DEEPEST:
                raise yaml.YAMLError(f"more than {DEEPEST} lists or mappings in each other")
        root = yaml.compose(text, Loader=yaml.SafeLoader)
    except (OSError, UnicodeDecodeError, RecursionError, yaml.YAMLError) as error:
        raise unreadable(path, error, ALLOWED) from None
    if root is None:
        raise unreadable(path, "an empty file", ALLOWED)
    return root


def _mooring(whole: Entry, deck: Deck) -> tuple[Entry, Entry | None]:
    """Entry of the mooring, and that of the site in a file of RAFT."""
    if "mooring" not in whole.values:
        whole.leave_out(deck.notes, KNOWN, {"anchor_types": "anchors hold in every direction"})
        return whole, None
    whole.leave_out(deck.notes, ("mooring", "site"), {})
    node = whole.values.get("site")
    site = None if node is None or node.id != "mapping" else entry("site", node, whole.place.file)
    if site is not None:
        site.leave_out(deck.notes, ("water_depth", "rho_water", "g"), {})
    data = entry("", whole.values["mooring"], whole.place.file)
    data.leave_out(deck.notes, KNOWN, {"anchor_types": "anchors hold in every direction"})
    return data, site


def _read_water(data: Entry, site: Entry | None, deck: Deck) -> None:
    fields = {"depth_m": ("water_depth",), "density_kg_m3": ("rho", "water_density", "rho_water"),
              "gravity_m_s2": ("g",)}  # fmt: skip
    for source in (site, data):
        for field, keys in fields.items():
            found = [
                cell for key in keys if source is not None and (cell := source.optional(key)) is not None
            ]
            if found:
                setattr(deck.water, field, found[0].number(keys[0], 0, above=True))


def _line_type(one: Entry, deck: Deck) -> LineType:
    notes = Notes()
    name = one.cell("name", "a name")
    if name.text in deck.types:
        raise name.error(f"{one.name}.name", f"another name than that of line {deck.types[name.text].line}")
    given = {}
    for key, default in DRAG.items():
        cell = one.optional(key)
        given[key] = default if cell is None else cell.number(f"{one.name}.{key}", 0)
        if cell is None:
            notes.convert(name.line, f"{name.text}: no {key}", f"{default:g}")
    known = ("name", "diameter", "mass_density", "stiffness", *DRAG)
    why = {
        "breaking_load": "write a limit of the tension under `limits`",
        "cost": "costs have no counterpart",
    }
    one.leave_out(notes, known, why)
    return LineType(
        name.text, name.line, one.number("diameter", 0, above=True),
        one.number("mass_density", 0, above=True), one.number("stiffness", 0, above=True), None, 0.0,
        given["transverse_drag"], given["tangential_drag"],
        given["transverse_added_mass"], given["tangential_added_mass"], notes,
    )  # fmt: skip


def _read_point(one: Entry, deck: Deck) -> None:
    name = one.cell("name", "a name")
    if name.text in deck.points:
        raise name.error(f"{one.name}.name", f"another name than that of line {deck.points[name.text].line}")
    node = one.values.get("location")
    if node is None or node.id != "sequence" or len(node.value) != 3:
        place = one.place if node is None else _cell(node, one.place.file)
        raise place.error(
            f"{one.name}.location", "a list of three numbers", "nothing" if node is None else None
        )
    x, y, z = (_cell(value, one.place.file).number(f"{one.name}.location") for value in node.value)
    optional = {
        key: 0.0 if (cell := one.optional(key)) is None else cell.number(f"{one.name}.{key}", 0)
        for key in ("mass", "volume")
    }
    body = _carrier(one.cell("type", "fixed, vessel or connection"), one.name, deck)
    deck.points[name.text] = Point(
        name.text, name.line, body, (x, y, z), optional["mass"], optional["volume"]
    )
    known = ("name", "type", "location", "mass", "volume")
    one.leave_out(deck.notes, known, {"anchor_type": "anchors hold in every direction"})


def _carrier(cell: Cell, name: str, deck: Deck) -> str | None:
    kind = cell.text.lower()
    if "anch" in kind or "fix" in kind:
        return WORLD
    if number := re.search(r"body\D*(\d+)", kind):
        body = f"body_{number[1]}"
    elif any(word in kind for word in ("fair", "ves", "coupl")):
        body = VESSEL
    elif "con" in kind or "free" in kind:
        return None
    else:
        raise cell.error(
            f"{name}.type", "fixed (or anchor), vessel (or fairlead), connection (or free), body1"
        )
    deck.bodies.setdefault(body, Body(body, None, "held"))
    return body


def _read_line(one: Entry, name: str, deck: Deck) -> None:
    kind = one.cell("type", "a name of line_types")
    if kind.text not in deck.types:
        raise kind.error(f"{one.name}.type", f"one of {', '.join(deck.types)}")
    ends = [one.cell(key, "a name of points") for key in ("endA", "endB")]
    for key, cell in zip(("endA", "endB"), ends, strict=True):
        if cell.text not in deck.points:
            raise cell.error(f"{one.name}.{key}", f"one of {', '.join(deck.points)}")
    if ends[0].text == ends[1].text:
        raise ends[1].error(f"{one.name}.endB", "another point than at the first end")
    given = one.optional("name")
    length = one.number("length", 0, above=True)
    deck.lines.append(
        Segment(name if given is None else given.text, one.place.line, deck.types[kind.text],
                (ends[0].text, ends[1].text), length, SEGMENTS)
    )  # fmt: skip
    one.leave_out(deck.notes, ("name", "type", "endA", "endB", "length"), {})

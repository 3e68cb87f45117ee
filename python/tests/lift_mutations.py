"""Wrong scenarios of lifts, drawn from a seed."""

from __future__ import annotations

import copy
import json
import math
import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from lift_mistakes import PLANS, Document

Path = tuple[str | int, ...]

NUMBERS = [
    0, -0.0, -1, 1, 2, 7, 1e-3, 1e-9, 1e-300, 5e-324, 1e3, 1e6, 1e12, 1e100, 1e308, -1e308, -1e-9, 0.5, -0.5,
    90, -90, 1.5, 2**31, 2**63, 2**64, -(2**63) - 1, math.nan, math.inf, -math.inf,
]  # fmt: skip
OTHERS: list[Any] = [
    None, True, False, "", "x", "world", "nowhere", "1", "off", [], {}, [0], [[]], {"x": 1}, [0, 0, 0],
    [1, 2], [math.nan, 0, 0], {"point": {}}, {"all": []}, "å🪝", "a.b", " ", "x" * 3000,
]  # fmt: skip
FACTORS = [-1, 0.5, 2, 0.1, 10, 0.99, 1.01, 1e-3, 1e3, 1e6, 1e-6]
NAMES = {"body", "parent", "joint", "input", "column", "unit", "axis", "name", "mode", "pays_out"}
# The elements of a lift are changed more often than the ship.
WEIGHTS = {
    "forces": 5,
    "drives": 5,
    "operation": 6,
    "limits": 3,
    "bodies": 2,
    "simulation": 2,
    "sea": 1,
    "wind": 1,
}
OF_LIFTS = {"rope": 6, "tugger_line": 8, "contact": 5, "submerged": 4}


@dataclass(frozen=True)
class Lift:
    """A wrong scenario and a description of the error."""

    seed: int
    base: str
    changes: tuple[str, ...]
    document: Document

    @property
    def text(self) -> str:
        """As a file: JSON that also has .nan and .inf, as YAML has them."""
        return written(self.document)

    def __str__(self) -> str:
        return f"seed {self.seed}: {self.base}: {'; '.join(self.changes)}"


def written(value: Any, depth: int = 0) -> str:
    """YAML in flow style, one entry a line, so that a line says something."""
    indent = "\n" + " " * (depth + 1)
    if isinstance(value, dict):
        entries = [f"{json.dumps(name)}: {written(entry, depth + 1)}" for name, entry in value.items()]
        return "{" + ",".join(indent + entry for entry in entries) + "}"
    if isinstance(value, list):
        return "[" + ",".join(indent + written(entry, depth + 1) for entry in value) + "]"
    if isinstance(value, float) and not math.isfinite(value):
        return ".nan" if math.isnan(value) else ".inf" if value > 0 else "-.inf"
    return json.dumps(value)


def case(bases: dict[str, Document], seed: int) -> Lift:
    """The case of a seed: one base with one change, or with two or three."""
    draw = random.Random(seed)
    base = draw.choice(sorted(bases))
    document = copy.deepcopy(bases[base])
    changes = []
    for _ in range(draw.choices([1, 2, 3], [6, 3, 1])[0]):
        change = at_a_place if draw.random() < 0.6 else draw.choice([*PLANS, all_of_a_kind])
        try:
            changes.append(change(document, draw))
        except (AttributeError, IndexError, KeyError, TypeError):
            changes.append("a change that the one before it left no room for")
    return Lift(seed, base, tuple(changes), document)


def places(value: Any, path: Path = ()) -> Iterator[Path]:
    """The paths of all values, those that hold others too."""
    if path:
        yield path
    entries = (
        value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    )
    for name, entry in entries:
        yield from places(entry, (*path, name))


def at(document: Any, path: Path) -> Any:
    for name in path:
        document = document[name]
    return document


def put(document: Document, path: Path, value: Any) -> None:
    at(document, path[:-1])[path[-1]] = value


def shown(path: Path) -> str:
    return ".".join(map(str, path))


def weight(path: Path) -> float:
    if path[0] == "forces" and len(path) > 2:
        return OF_LIFTS.get(str(path[2]), 0.3)
    return WEIGHTS.get(str(path[0]), 0.2)


def some_place(document: Document, draw: random.Random, fits: Callable[[Path, Any], bool]) -> Path | None:
    found = [path for path in places(document) if fits(path, at(document, path))]
    return draw.choices(found, [weight(path) for path in found])[0] if found else None


# Changes anywhere.


def at_a_place(document: Document, draw: random.Random) -> str:
    """Replace one value by another."""
    kinds = [
        number,
        number,
        number,
        other_type,
        removed,
        misspelt,
        other_name,
        other_name,
        list_changed,
        moved,
    ]
    return draw.choice(kinds)(document, draw)


def is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def number(document: Document, draw: random.Random) -> str:
    path = some_place(document, draw, lambda _, value: is_number(value))
    if path is None:
        return "no number"
    old = at(document, path)
    new = draw.choice(NUMBERS) if draw.random() < 0.6 else old * draw.choice(FACTORS)
    put(document, path, new)
    return f"{shown(path)}: {old!r} -> {new!r}"


def other_type(document: Document, draw: random.Random) -> str:
    path = some_place(document, draw, lambda *_: True)
    assert path is not None
    new = draw.choice(OTHERS)
    put(document, path, copy.deepcopy(new))
    return f"{shown(path)}: -> {str(new)[:40]!r}"


def removed(document: Document, draw: random.Random) -> str:
    path = some_place(document, draw, lambda *_: True)
    assert path is not None
    del at(document, path[:-1])[path[-1]]
    return f"{shown(path)}: removed"


def misspelt(document: Document, draw: random.Random) -> str:
    path = some_place(document, draw, lambda path, _: isinstance(path[-1], str))
    assert path is not None
    name = str(path[-1])
    k = draw.randrange(len(name) + 1)
    new = draw.choice(
        [name[:k] + name[k + 1 :], name[:k] + draw.choice("x_ .é") + name[k:], name.upper(), ""]
    )
    parent = at(document, path[:-1])
    entries = [(new if key == name else key, value) for key, value in parent.items()]
    parent.clear()
    parent.update(entries)
    return f"{shown(path)}: named {new!r}"


def other_name(document: Document, draw: random.Random) -> str:
    """Replace a name by another one in the scenario: of a body, a joint, a column, a unit."""
    path = some_place(document, draw, lambda path, value: isinstance(value, str) and path[-1] in NAMES)
    if path is None:
        return "no name"
    names = sorted(
        {at(document, place) for place in places(document) if isinstance(at(document, place), str)}
    )
    names = [name for name in names if len(name) < 40]
    keys = (
        sorted(document.get("bodies") or {}) + sorted(document.get("forces") or {}) + ["world", "time", "m"]
    )
    new = draw.choice(draw.choice([names, keys]))
    put(document, path, new)
    return f"{shown(path)}: -> {new!r}"


def list_changed(document: Document, draw: random.Random) -> str:
    path = some_place(document, draw, lambda _, value: isinstance(value, list) and value)
    if path is None:
        return "no list"
    entries = at(document, path)
    ways = {
        "emptied": [],
        "doubled": entries + copy.deepcopy(entries),
        "turned": entries[::-1],
        "mixed": draw.sample(entries, len(entries)),
        "cut": entries[:-1],
        "without its first": entries[1:],
        "a hundred times": copy.deepcopy(entries) * 100,
        "as a field": {"0": entries[0]},
    }
    way = draw.choice(sorted(ways))
    put(document, path, copy.deepcopy(ways[way]))
    return f"{shown(path)}: {way}"


def moved(document: Document, draw: random.Random) -> str:
    """Copy a part of the scenario to the place of another."""
    source = some_place(document, draw, lambda *_: True)
    target = some_place(document, draw, lambda *_: True)
    assert source is not None
    assert target is not None
    put(document, target, copy.deepcopy(at(document, source)))
    return f"{shown(target)}: what {shown(source)} is"


def all_of_a_kind(document: Document, draw: random.Random) -> str:
    """Set every number with the same name to one value."""
    names = sorted(
        {str(path[-1]) for path in places(document) if is_number(at(document, path)) and weight(path) >= 2}
    )
    if not names:
        return "no numbers"
    name, value = draw.choice(names), draw.choice(NUMBERS)
    for path in list(places(document)):
        if path[-1] == name and is_number(at(document, path)):
            put(document, path, value)
    return f"every {name} -> {value!r}"

"""Random parts of scenarios, drawn from the JSON Schema of the scenario."""

from __future__ import annotations

import copy
import json
import random
from functools import cache
from typing import Any

import kingpost
from lift_mutations import NUMBERS, OTHERS

NAMES = [
    "ship",
    "arm",
    "tower",
    "load",
    "hook",
    "world",
    "a",
    "b",
    "box",
    "boom",
    "hinge",
    "motor",
    "water",
    "tip",
]
TEXTS = [*NAMES, "ship.roll", "arm.tip", "x", "m", "deg", "gallery:hydro/sphere.hydro.json",
         "gallery:parts/paper_crane.yaml", "nowhere.csv"]  # fmt: skip
PLAUSIBLE = [0, 0.1, 0.3, 0.5, 1, 1.5, 2, 3, 5, 8, 10, 20, 45, 100, 1000, 1e4, 1e5, 1e6, -1, -2, -5, -90]
DEEPEST = 10


@cache
def schema() -> dict[str, Any]:
    """Schema in the package."""
    for folder in (kingpost.gallery.folder().parent / "schema", kingpost.gallery.folder() / "schema"):
        if (path := folder / "scenario.schema.json").is_file():
            return json.loads(path.read_text(encoding="utf-8"))
    raise FileNotFoundError("scenario.schema.json")


def section_changed(draw: random.Random, document: dict[str, Any]) -> dict[str, Any]:
    """Change one section of a scenario: add an entry, or replace it."""
    changed = copy.deepcopy(document)
    sections = schema()["properties"]
    name = draw.choice(sorted(sections))
    node = _resolved(sections[name])
    entries = node.get("additionalProperties")
    if isinstance(entries, dict) and draw.random() < 0.9:
        held = changed.get(name)
        old = held if isinstance(held, dict) else {}
        key = draw.choice([*NAMES, *map(str, old)])
        changed[name] = {**old, key: value_of(draw, entries)}
    else:
        changed[name] = value_of(draw, node)
    return changed


def value_of(draw: random.Random, node: Any, depth: int = 0) -> Any:
    """Draw a value that a node of the schema allows; one in a hundred is wrong."""
    node = _resolved(node)
    if draw.random() < 0.01 or depth > DEEPEST or not isinstance(node, dict):
        return copy.deepcopy(draw.choice(OTHERS))
    if "const" in node:
        return node["const"]
    if "enum" in node:
        return draw.choice(node["enum"])
    for several in ("oneOf", "anyOf"):
        if several in node:
            return value_of(draw, draw.choice(node[several]), depth + 1)
    kind = node.get("type", "object")
    return _of_type(draw, node, draw.choice(kind) if isinstance(kind, list) else kind, depth)


def _of_type(draw: random.Random, node: dict[str, Any], kind: str, depth: int) -> Any:
    if kind == "object":
        return _fields(draw, node, depth)
    if kind == "array":
        items = node.get("items", {"type": "number"})
        fewest = node.get("minItems", 0)
        count = draw.randrange(fewest, min(node.get("maxItems", fewest + 3), fewest + 3) + 1)
        return [value_of(draw, items, depth + 1) for _ in range(count)]
    if kind == "boolean":
        return draw.random() < 0.8
    if kind == "null":
        return None
    if kind == "string":
        return draw.choice(TEXTS)
    number = draw.choice(NUMBERS) if draw.random() < 0.05 else draw.choice(PLAUSIBLE)
    return int(number) if kind == "integer" and abs(number) < 1e300 else number


def _fields(draw: random.Random, node: dict[str, Any], depth: int) -> dict[str, Any]:
    required = set(node.get("required", ()))
    found = {}
    for name, field in node.get("properties", {}).items():
        is_alias = isinstance(field, dict) and "x-alias-of" in field
        if draw.random() < (0.99 if name in required else 0.03 if is_alias else 0.35 / (1 + depth / 3)):
            found[name] = value_of(draw, field, depth + 1)
    others = node.get("additionalProperties")
    if isinstance(others, dict):
        for _ in range(draw.randrange(3)):
            found[draw.choice(NAMES)] = value_of(draw, others, depth + 1)
    return found


def _resolved(node: Any) -> Any:
    while isinstance(node, dict) and "$ref" in node:
        node = schema()["$defs"][node["$ref"].rpartition("/")[2]]
    return node

"""Report of the fields of a scenario, from the JSON Schema of the engine: name, unit, range, default and
meaning."""

from __future__ import annotations

import difflib
import json
import re
import textwrap
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from ..errors import KingpostError
from .tables import table

Schema = dict[str, Any]

WIDTH = 110
"""Width of the printed text, characters."""
UNITS = {
    "m": "m", "m2": "m²", "m3": "m³", "m4": "m⁴", "kg": "kg", "t": "t", "s": "s", "N": "N", "kN": "kN",
    "rad": "rad", "deg": "deg", "Hz": "Hz", "Pa": "Pa", "GPa": "GPa", "bar": "bar", "W": "W", "kW": "kW",
    "m_s": "m/s", "m_s2": "m/s²", "m_s3": "m/s³", "rad_s": "rad/s", "rad_s2": "rad/s²", "rad_s3": "rad/s³",
    "deg_s": "deg/s", "deg_s2": "deg/s²", "deg_s3": "deg/s³", "kg_m2": "kg m²", "t_m2": "t m²",
    "kg_m3": "kg/m³", "kg_per_m": "kg/m", "N_m": "N m", "kN_m": "kN m", "N_per_m": "N/m", "kN_per_m": "kN/m",
    "N_m_s": "N m s", "kN_m_s": "kN m s", "N_m_s2": "N m s²", "N_s_m": "N s/m", "kN_s_m": "kN s/m",
    "N_s2_m2": "N s²/m²", "N_s_per_m": "N s/m", "kN_s_per_m": "kN s/m", "N_m_per_rad": "N m/rad",
    "kN_m_per_rad": "kN m/rad", "N_m_s_per_rad": "N m s/rad", "kN_m_s_per_rad": "kN m s/rad",
    "N_per_m_s": "N/(m s)", "N_m_per_rad_s": "N m/(rad s)", "N_m_per_deg_s": "N m/(deg s)",
    "s_per_m": "s/m", "s_per_rad": "s/rad", "s_per_deg": "s/deg", "rad_per_m": "rad/m",
}  # fmt: skip
"""Suffixes of names and their units. The longest suffix counts."""


@dataclass(frozen=True)
class Kind:
    """A name by which fields are looked up: a kind of entry, a section of the file or a type."""

    name: str
    of: str
    """The choice or the object in which the name stands."""
    type: str
    """The type of its fields."""
    about: str


@cache
def schema() -> Schema:
    """The JSON Schema of a scenario: the package's own, or the repository's in a development install."""
    package = Path(__file__).parents[1]
    folders = (package / "schema", package.parents[1] / "schema")
    found = (folder / "scenario.schema.json" for folder in folders)
    path = next(path for path in found if path.is_file())
    read: Schema = json.loads(path.read_text(encoding="utf-8"))
    return read


def kinds() -> list[Kind]:
    """Every kind of entry, by the choice in which it stands.

    >>> [kind.of for kind in kinds() if kind.name == "revolute"]
    ['Joint']
    """
    found = []
    for choice, one in schema()["$defs"].items():
        for other in one.get("oneOf", []):
            for name, inner in other.get("properties", {}).items():
                if "$ref" in inner:
                    found.append(Kind(name, choice, _type(inner), text(other) or text(inner)))
    return found


def _sections() -> list[Kind]:
    """Sections of the file, and types by their names."""
    whole = schema()
    types = [Kind(name, "types", name, text(one)) for name, one in whole["$defs"].items()]
    parts = whole["properties"].items()
    sections = [Kind(name, whole["title"], of, text(one)) for name, one in parts for of in references(one)]
    return [*sections, *types]


def find(name: str) -> list[Kind]:
    """Kinds with a name; sections of the file and types if there are none.

    Raises
    ------
    KingpostError
        If nothing has this name; the message suggests the nearest.

    >>> find("Joint")[0].type
    'Joint'
    """
    every, others = kinds(), _sections()
    for known in (every, others):
        found = [kind for kind in known if kind.name.lower() == name.lower()]
        if found:
            return found
    names = {kind.name.lower(): kind.name for kind in (*others, *every)}
    near = difflib.get_close_matches(name.lower(), names, n=1)
    hint = f"did you mean {names[near[0]]}?" if near else "kingpost fields lists the kinds"
    raise KingpostError(f"{name}: no kind, section or type of a scenario; {hint}")


def listing() -> str:
    """The kinds with their meaning, in groups."""
    groups: dict[str, list[Kind]] = {}
    for kind in kinds():
        groups.setdefault(kind.of, []).append(kind)
    lines: list[str] = []
    for choice, members in groups.items():
        rows = [
            ("  " + kind.name, textwrap.shorten(kind.about, WIDTH - 30, placeholder=" ..."))
            for kind in members
        ]
        lines += [choice, *table(rows, "<<"), ""]
    return "\n".join(
        [*lines, "kingpost fields NAME prints the fields of a kind, of a section of the file or of a type."]
    )


def reference(name: str) -> str:
    """The fields of everything with this name, and of the types within."""
    parts, seen = [], set[str]()
    for kind in find(name):
        parts.append([f"{kind.name} ({kind.of})", *_wrapped(kind.about, "  ")])
        for of in within(kind.type):
            if of not in seen:
                seen.add(of)
                parts.append(_of_type(of))
    return "\n\n".join("\n".join(lines) for lines in parts)


def data(name: str) -> list[dict[str, Any]]:
    """Content of `reference`: types with their fields."""
    types = dict.fromkeys(of for kind in find(name) for of in within(kind.type))
    return [
        {
            "type": of,
            "description": text(schema()["$defs"][of]),
            "fields": [
                {
                    "names": names,
                    "units": [unit(name) for name in names],
                    "value": value(one),
                    "required": required,
                    "default": one.get("default"),
                    "description": text(one),
                }
                for names, one, required in named(schema()["$defs"][of])
            ],
            "choices": [list(choice) for choice in choices(schema()["$defs"][of])],
        }
        for of in types
    ]


def within(name: str) -> list[str]:
    """A type and all types of its fields, each once, from the outside in."""
    found, at = [name], 0
    while at < len(found):
        found += [other for other in references(schema()["$defs"][found[at]]) if other not in found]
        at += 1
    return found


def references(one: Any) -> list[str]:
    """Names of the types that a schema refers to, each once."""
    if isinstance(one, dict):
        own = [_type(one)] if "$ref" in one else []
        return list(dict.fromkeys([*own, *(name for inner in one.values() for name in references(inner))]))
    if isinstance(one, list):
        return list(dict.fromkeys(name for inner in one for name in references(inner)))
    return []


def _type(one: Schema) -> str:
    return str(one["$ref"].rpartition("/")[2])


def _of_type(name: str) -> list[str]:
    one = schema()["$defs"][name]
    lines = [name, *_wrapped(text(one), "  ")]
    for names, inner, required in named(one):
        default = shown(inner.get("default"), bare=True)
        marks = [value(inner), "required" if required else f"default {default}" if default else ""]
        units = [unit(name) for name in names]
        spelled = ", ".join(f"{name} [{of}]" if of else name for name, of in zip(names, units, strict=True))
        lines += [
            f"  {spelled}: {', '.join(mark for mark in marks if mark)}",
            *_wrapped(text(inner), "      "),
        ]
    for choice, meaning in choices(one):
        lines += [f"  {choice}", *_wrapped(meaning, "      ")]
    return lines


def _wrapped(words: str, indent: str) -> list[str]:
    return textwrap.wrap(words, WIDTH, initial_indent=indent, subsequent_indent=indent)


def choices(one: Schema, link: Callable[[str], str] = str) -> Iterator[tuple[str, str]]:
    """Alternatives, each a keyword or a single field, with their meaning."""
    for other in one.get("oneOf", []):
        if "const" in other:
            yield str(other["const"]), text(other)
        elif "properties" in other:
            for name, inner in other["properties"].items():
                yield f"{name}: {value(inner, link)}", text(other) or text(inner)
        else:
            yield value(other, link), text(other)


def named(schema: Schema) -> Iterator[tuple[list[str], Schema, bool]]:
    """The fields of an object: the names of each, one for each unit, its schema, whether it is required."""
    known, required = schema.get("properties", {}), needed(schema)
    aliases: dict[str, list[str]] = {}
    for name, one in known.items():
        if "x-alias-of" in one:
            aliases.setdefault(one["x-alias-of"], []).append(name)
    for name, one in known.items():
        if "x-alias-of" not in one:
            yield [name, *aliases.get(name, [])], one, name in required


def needed(schema: Schema) -> set[str]:
    """Required fields, each under one of its names."""
    one_of = (choice for rule in schema.get("allOf", []) for choice in rule.get("oneOf", []))
    return {*schema.get("required", []), *(name for choice in one_of for name in choice.get("required", []))}


def value(one: Schema, link: Callable[[str], str] = str) -> str:
    """The type of a field, with its range; `link` writes the name of a type."""
    if "$ref" in one:
        return link(one["$ref"].rpartition("/")[2])
    either: list[Schema] = one.get("anyOf") or one.get("oneOf") or []
    if either:
        return " or ".join(value(other, link) for other in either if other != {"type": "null"})
    if "const" in one:
        return f"`{one['const']}`"
    kinds = one.get("type", [])
    kinds = [kind for kind in ([kinds] if isinstance(kinds, str) else kinds) if kind != "null"]
    if kinds == ["array"]:
        return f"list of {count(one)}{several(value(one.get('items', {})))}"
    if kinds == ["object"]:
        named = [*one.get("patternProperties", {}).values(), one.get("additionalProperties")]
        inner = [value(other, link) for other in named if isinstance(other, dict)]
        return f"{inner[0]} by name" if inner else "fields by name"
    if "pattern" in one:
        return "name" if one["pattern"].startswith("^[a-z]") else "text"
    return " or ".join(
        {"string": "text", "boolean": "true or false"}.get(kind, kind) for kind in kinds
    ) + limits(one)


def several(kind: str) -> str:
    """The type of a list's entries: numbers, names."""
    word, blank, limit = kind.partition(" ")
    plural = {"": "values", "number": "numbers", "integer": "integers", "name": "names", "text": "texts"}
    return plural.get(word, word) + blank + limit


def count(one: Schema) -> str:
    least, most = one.get("minItems"), one.get("maxItems")
    return f"{least} " if least is not None and least == most else ""


def limits(one: Schema) -> str:
    """The range of a number."""
    words = {"exclusiveMinimum": ">", "minimum": "≥", "exclusiveMaximum": "<", "maximum": "≤"}
    said = [f"{sign} {shown(one[key], bare=True)}" for key, sign in words.items() if key in one]
    return " " + ", ".join(said) if said else ""


def unit(name: str) -> str:
    """The unit at the end of a name; empty if it has none."""
    parts = name.split("_")[1:]
    for start in range(len(parts)):
        found = UNITS.get("_".join(parts[start:]))
        if found:
            return found
    return ""


def shown(default: Any, bare: bool = False) -> str:
    if default is None or (isinstance(default, (dict, list)) and not default):
        return ""
    if isinstance(default, dict):
        return "its own"
    number = isinstance(default, float) and default.is_integer() and abs(default) < 1e6
    said = json.dumps(int(default) if number else default)
    return said if bare else f"`{said}`"


def text(one: Schema) -> str:
    """The description in the schema, on one line."""
    return re.sub(r"\s+", " ", one.get("description", "")).strip()

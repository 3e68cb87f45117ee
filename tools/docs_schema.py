"""Generates the site's pages on the fields of a scenario and of a study from the JSON Schema: name, unit,
range, meaning."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

Schema = dict[str, Any]

# Suffixes of names and their units. The longest suffix counts.
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


ABOUT = {
    "Scenario": "A second name in another unit (`mass_t` for `mass_kg`) is listed too. How to build a "
    "scenario step by step: [Write a scenario](../scenarios.md).",
    "Study": "What a study is for: [From a scatter table to the operable share](../howto/operability.md).",
}


def page(path: Path) -> str:
    """All fields of the schema, as Markdown."""
    schema = json.loads(path.read_text(encoding="utf-8"))
    title = schema["title"]
    lines = [
        f"# Fields of a {title.lower()}",
        "",
        f"Made from [the JSON Schema](../../schema/{path.name}), which is made from the engine's own "
        f"types. An editor that knows JSON Schema shows the same while you write. The unit is in the name. "
        f"{ABOUT[title]}",
        "",
        f"## {title}",
        "",
        "The file.",
        "",
        *fields(schema),
    ]
    for name, one in sorted(schema["$defs"].items()):
        lines += [f"## {name}", "", text(one), "", *(choices(one) if "oneOf" in one else fields(one))]
    return "\n".join(lines) + "\n"


def fields(schema: Schema) -> list[str]:
    """A table of the fields of an object."""
    known = schema.get("properties", {})
    aliases: dict[str, list[str]] = {}
    for name, one in known.items():
        if "x-alias-of" in one:
            aliases.setdefault(one["x-alias-of"], []).append(name)
    required = needed(schema)
    rows = ["| field | unit | value | default | meaning |", "| --- | --- | --- | --- | --- |"]
    for name, one in known.items():
        if "x-alias-of" not in one:
            names = [name, *aliases.get(name, [])]
            rows.append(row(names, one, name in required))
    return in_rows(rows) if len(rows) > 2 else []


def in_rows(table: list[str]) -> list[str]:
    """Wraps a table so that each row becomes a paragraph on a phone."""
    return ['<div class="rows" markdown>', "", *table, "", "</div>", ""]


def row(names: list[str], one: Schema, required: bool) -> str:
    default = "required" if required else shown(one.get("default"))
    cells = (
        "<br>".join(f"`{name}`" for name in names),
        "<br>".join(unit(name) for name in names),
        value(one),
        default,
        text(one),
    )
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def needed(schema: Schema) -> set[str]:
    """Required fields, each under one of its names."""
    one_of = (choice for rule in schema.get("allOf", []) for choice in rule.get("oneOf", []))
    return {*schema.get("required", []), *(name for choice in one_of for name in choice.get("required", []))}


def choices(schema: Schema) -> list[str]:
    """A table of alternatives, each a keyword or a single field."""
    rows = ["| one of | meaning |", "| --- | --- |"]
    for one in schema["oneOf"]:
        if "const" in one:
            rows.append(f"| `{one['const']}` | {text(one)} |")
        elif "properties" in one:
            for name, inner in one["properties"].items():
                rows.append(f"| `{name}`: {value(inner)} | {text(one) or text(inner)} |")
        else:
            rows.append(f"| {value(one)} | {text(one)} |")
    return in_rows(rows)


def value(one: Schema) -> str:
    """The type of a field, with its range."""
    if "$ref" in one:
        name = one["$ref"].rpartition("/")[2]
        return f"[{name}](#{name.lower()})"
    if "anyOf" in one or "oneOf" in one:
        return " or ".join(
            value(other) for other in one.get("anyOf", one.get("oneOf")) if other != {"type": "null"}
        )
    if "const" in one:
        return f"`{one['const']}`"
    kinds = one.get("type", [])
    kinds = [kind for kind in ([kinds] if isinstance(kinds, str) else kinds) if kind != "null"]
    if kinds == ["array"]:
        return f"list of {count(one)}{several(value(one.get('items', {})))}"
    if kinds == ["object"]:
        named = [*one.get("patternProperties", {}).values(), one.get("additionalProperties")]
        inner = [value(other) for other in named if isinstance(other, dict)]
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

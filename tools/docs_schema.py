"""Generates the site's pages on the fields of a scenario and of a study from the JSON Schema: name, unit,
range, meaning."""

from __future__ import annotations

import json
from pathlib import Path

from kingpost.reports.fields import Schema, named, shown, text, unit, value

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
    rows = ["| field | unit | value | default | meaning |", "| --- | --- | --- | --- | --- |"]
    rows += [row(names, one, required) for names, one, required in named(schema)]
    return in_rows(rows) if len(rows) > 2 else []


def linked(name: str) -> str:
    """The name of a type as a link to its heading."""
    return f"[{name}](#{name.lower()})"


def in_rows(table: list[str]) -> list[str]:
    """Wraps a table so that each row becomes a paragraph on a phone."""
    return ['<div class="rows" markdown>', "", *table, "", "</div>", ""]


def row(names: list[str], one: Schema, required: bool) -> str:
    default = "required" if required else shown(one.get("default"))
    cells = (
        "<br>".join(f"`{name}`" for name in names),
        "<br>".join(unit(name) for name in names),
        value(one, linked),
        default,
        text(one),
    )
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def choices(schema: Schema) -> list[str]:
    """A table of alternatives, each a keyword or a single field."""
    rows = ["| one of | meaning |", "| --- | --- |"]
    for one in schema["oneOf"]:
        if "const" in one:
            rows.append(f"| `{one['const']}` | {text(one)} |")
        elif "properties" in one:
            for name, inner in one["properties"].items():
                rows.append(f"| `{name}`: {value(inner, linked)} | {text(one) or text(inner)} |")
        else:
            rows.append(f"| {value(one, linked)} | {text(one)} |")
    return in_rows(rows)

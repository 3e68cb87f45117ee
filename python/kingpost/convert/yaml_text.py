"""A scenario as YAML, with the notes of its conversion as comments at its beginning."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import yaml

from .cells import Note, Notes

WIDTH = 118
BLOCKS = ("simulation", "sea", "bodies", "forces", "line", "sections")
"""Fields whose values stand on lines of their own, with those of `bodies` and `forces`."""


class _Inline(dict[str, Any]):
    """A mapping on one line."""


class _Dumper(yaml.SafeDumper):
    """Writer of YAML with short lists in lines, and numbers in their shortest form."""

    def ignore_aliases(self, data: Any) -> bool:
        return True


def _number(dumper: yaml.SafeDumper, value: float) -> yaml.Node:
    if value == int(value) and abs(value) < 1e7:
        return dumper.represent_scalar("tag:yaml.org,2002:int", str(int(value)))
    mantissa, _, exponent = f"{value:.12g}".partition("e")
    text = (
        mantissa if not exponent else f"{mantissa if '.' in mantissa else mantissa + '.0'}e{int(exponent):+d}"
    )
    return dumper.represent_scalar("tag:yaml.org,2002:float", text)


_Dumper.add_representer(float, _number)
_Dumper.add_representer(
    _Inline, lambda d, v: d.represent_mapping("tag:yaml.org,2002:map", v, flow_style=True)
)
_Dumper.add_representer(
    list, lambda d, v: d.represent_sequence("tag:yaml.org,2002:seq", v, flow_style=not isinstance(v[0], dict))
)


def text(fields: Mapping[str, Any], source: str, notes: Notes) -> str:
    """Scenario as YAML."""
    inlined = {
        key: _inlined(value) if key in ("bodies", "forces") else value for key, value in fields.items()
    }
    for key in ("simulation", "sea"):
        inlined[key] = _Inline(fields[key])
    body = yaml.dump(inlined, Dumper=_Dumper, sort_keys=False, width=10_000, allow_unicode=True)
    return "\n".join([*_comments(source, notes), body])


def _inlined(entries: Mapping[str, Any]) -> dict[str, Any]:
    """Bodies and forces with their fields on a line each; the sections of a line too."""
    found: dict[str, Any] = {}
    for name, fields in entries.items():
        if "line" in fields:
            line = {key: _Inline(value) if isinstance(value, dict) else [_Inline(part) for part in value]
                    for key, value in fields["line"].items()}  # fmt: skip
            found[name] = {"line": line}
        elif "joint" in fields:
            found[name] = {k: _Inline(v) if isinstance(v, dict) else v for k, v in fields.items()}
        else:
            found[name] = _Inline(fields)
    return found


def _comments(source: str, notes: Notes) -> Iterator[str]:
    yield f"# Converted from {Path(source).name} by `kingpost convert`."
    for heading, each in (("Left out", notes.left_out), ("In another form", notes.converted)):
        if each:
            yield "#"
            yield f"# {heading}:"
        for where, what, why in rows(each):
            place = f"{where}: " if where else ""
            yield from textwrap.wrap(
                f"{place}{what}: {why}", WIDTH, initial_indent="# - ", subsequent_indent="#   "
            )


def rows(notes: list[Note]) -> list[tuple[str, str, str]]:
    """Lines, text and reason of each note; several in a row with one reason are one.

    >>> rows([Note(7, "FairTen1", "left out"), Note(8, "FairTen2", "left out")])
    [('lines 7-8', 'FairTen1 ...', 'left out')]
    """
    found: list[tuple[Note, Note]] = []
    for note in notes:
        if found and found[-1][0].why == note.why and note.line is not None:
            found[-1] = found[-1][0], note
        else:
            found.append((note, note))
    return [
        ("" if first.line is None else _lines(first.line, last.line), _several(first, last), first.why)
        for first, last in found
    ]


def _lines(first: int, last: int | None) -> str:
    return f"line {first}" if last in (None, first) else f"lines {first}-{last}"


def _several(first: Note, last: Note) -> str:
    return first.text if first is last else f"{first.text} ..."

"""A scenario as YAML, with the notes of its conversion as comments at its beginning."""

from __future__ import annotations

import itertools
import textwrap
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import yaml

from .cells import Note, Notes

WIDTH = 118


class _Inline(dict[str, Any]):
    """A mapping on one line."""


class _Dumper(yaml.SafeDumper):
    """Writer of YAML with short lists in lines, and numbers in their shortest form."""

    def ignore_aliases(self, data: Any) -> bool:
        """Write a repeated value each time."""
        return True

    def increase_indent(self, flow: bool = False, indentless: bool = False) -> None:
        """Indent lists in mappings."""
        super().increase_indent(flow, False)


def _number(dumper: yaml.SafeDumper, value: float) -> yaml.Node:
    if value == int(value) and abs(value) < 1e7:
        return dumper.represent_scalar("tag:yaml.org,2002:int", str(int(value)))
    text = f"{value:.10g}"
    if "." not in text or "e" in text:
        mantissa, _, exponent = f"{value:.9e}".partition("e")
        digits = mantissa.rstrip("0")
        text = f"{digits}{'0' * digits.endswith('.')}e{int(exponent):+d}"
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
            parts = {"sections": [_Inline(part) for part in fields["line"]["sections"]]}
            found[name] = {"line": _in_lines(fields["line"]) | parts}
        elif "joint" in fields:
            found[name] = _in_lines(fields)
        else:
            found[name] = _Inline(fields)
    return found


def _in_lines(fields: Mapping[str, Any]) -> dict[str, Any]:
    """Fields on a line each."""
    return {key: _Inline(value) if isinstance(value, dict) else value for key, value in fields.items()}


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
    """Lines, text and reason of each note; neighbours with one reason are one.

    >>> rows([Note(7, "FairTen1", "left out"), Note(8, "FairTen2", "left out"), Note(10, "T", "left out")])
    [('lines 7-8, 10', 'FairTen1 ...', 'left out')]
    """
    groups = [(why, list(each)) for why, each in itertools.groupby(notes, lambda note: note.why)]
    return [(_lines(each), each[0].text + " ..." * (len(each) > 1), why) for why, each in groups]


def _lines(notes: list[Note]) -> str:
    """Numbers of lines as ranges."""
    ranges: list[list[int]] = []
    for line in dict.fromkeys(note.line for note in notes if note.line is not None):
        if ranges and line == ranges[-1][1] + 1:
            ranges[-1][1] = line
        else:
            ranges.append([line, line])
    words = ", ".join(str(first) if first == last else f"{first}-{last}" for first, last in ranges)
    several = len(ranges) > 1 or (ranges and ranges[0][0] != ranges[0][1])
    return f"line{'s' * bool(several)} {words}" if ranges else ""

"""Conversion of mooring systems of other programs, MoorDyn and MoorPy, to scenarios."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from . import moordyn, moorpy, scenario
from .cells import Notes
from .yaml_text import text

YAML = (".yaml", ".yml")


@dataclass(frozen=True)
class Converted:
    """A scenario that was made from another program's file.

    Attributes
    ----------
    text
        The scenario, in YAML.
    title
        Its title.
    notes
        Parts of the file that are left out or written in another form.
    lines, bodies
        Names of its lines and bodies.
    """

    text: str
    title: str
    notes: Notes
    lines: list[str]
    bodies: list[str]


def convert(path: str | Path, title: str | None = None) -> Converted:
    """Convert a mooring system to a scenario.

    Parameters
    ----------
    path
        A MoorDyn input file, or a MoorPy file, which ends in `.yaml` or `.yml`.
    title
        Title of the scenario; by default the first line of the file.

    Raises
    ------
    ScenarioError
        If the file cannot be read, or a value in it is wrong; with the place of the value.
    """
    is_yaml = Path(path).suffix.lower() in YAML
    deck = moorpy.read(path) if is_yaml else moordyn.read(path)
    if not deck.lines:
        raise moordyn.without_lines(deck)
    given = title or deck.title or Path(path).stem
    fields = scenario.build(deck, given)
    notes = deck.notes.sorted()
    lines = [name for name, force in fields["forces"].items() if "line" in force]
    return Converted(text(fields, str(path), notes), given, notes, lines, list(fields["bodies"]))

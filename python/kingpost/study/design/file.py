"""Reading of a study file by the engine, and loading of its scenario."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from ... import gallery
from ...engine import engine
from ...errors import KingpostError, ScenarioError
from ...scenario import Json, Scenario, load
from .content import Content

SET = "--set "
"""Prefix with which the engine names an override in an error."""
UNKNOWN = "an unknown name"
"""Text of the engine's error for an unknown parameter."""


@dataclass(frozen=True)
class StudyFile:
    """Content of a study file.

    Attributes
    ----------
    text
        Text of the file.
    file
        Name of the file; empty if there is none.
    content
        All fields, with defaults.
    places
        Line and column of each value, by its dotted path.
    """

    text: str
    file: str
    content: Content
    places: dict[str, list[int]] = field(default_factory=dict)

    def error(self, path: str, found: str, allowed: str) -> ScenarioError:
        """Make the error for a value of the study, with its place.

        >>> str(StudyFile("", "lift.yaml", {}, {"axes": [4, 7]}).error("axes.x", "nothing", "a number"))
        'lift.yaml:4:7: axes.x: found nothing, allowed: a number'
        """
        words = f"found {found}, allowed: {allowed}"
        return self.error_of(path, words, found, allowed)

    def error_of(
        self, path: str, words: str, found: str | None = None, allowed: str | None = None
    ) -> ScenarioError:
        """Make an error with a given text for a value of the study, with its place."""
        place = self._place(path)
        at = f"{self.file}:{place[0]}:{place[1]}: " if self.file and place else ""
        line, column = place if self.file and place else (None, None)
        message = f"{at}{path}: {words}"
        return ScenarioError(message, self.file or None, line, column, path, found, allowed)

    def _place(self, path: str) -> list[int] | None:
        """Return the place of a path, or of its nearest parent with a known place."""
        while path and path not in self.places:
            path = path.rpartition(".")[0]
        return self.places.get(path)

    def placed(self, error: ScenarioError, where: Mapping[str, str]) -> ScenarioError:
        """Add the place in the study file to an engine error on an override. `where` maps the name of each
        override to its path in the study. Other errors are unchanged."""
        file = error.file or ""
        name = file.removeprefix(SET)
        if name == file or error.found is None or error.allowed is None:
            return error
        if name == "limits" and error.field in self.places:
            return self.error(error.field, error.found, error.allowed)
        if name not in where:
            return error
        path = where[name]
        if error.found == UNKNOWN:
            # The name of the override is wrong, not its value.
            path = path[: path.index(name) + len(name)]
        return self.error(path, error.found, error.allowed)

    def beside(self, name: str) -> Path:
        """Path of a file that the study names."""
        return Path(self.file).parent / name if self.file else Path(name)

    def scenario(self) -> Scenario:
        """Load the scenario with the overrides and limits of the study that hold for all runs. Limits count
        from `after_s` on, or from a later `from_s`.

        Raises
        ------
        ScenarioError
            If the scenario is missing or wrong, or an override is wrong.
        """
        name, given = self.content["scenario"], self.content["set"]
        path = self.beside(name)
        try:
            base = load(path if path.is_file() else gallery.find(name))
        except ScenarioError as error:
            raise self.error_of("scenario", str(error)) if error.found is None else error from None
        try:
            base = base.with_overrides(given)
            limits = self._limits(base)
            return base.with_overrides({"limits": limits}) if limits else base
        except ScenarioError as error:
            raise self.placed(error, {name: f"set.{name}" for name in given}) from None

    def _limits(self, base: Scenario) -> dict[str, dict[str, Json]]:
        merged = base.resolved.get("limits", {}) | self.content["limits"]
        after_s = self.content["after_s"]
        return {name: limit | {"from_s": max(limit["from_s"], after_s)} for name, limit in merged.items()}


def read(source: str | Path | Mapping[str, object]) -> StudyFile:
    """Read a study from its file, or from a dictionary of its fields.

    Raises
    ------
    ScenarioError
        With file, line, column, field, the value found and the allowed values.

    >>> read({"version": 1, "title": "x", "scenario": "paper"}).content["seeds"]
    {'first': 1, 'count': 1}
    """
    if isinstance(source, Mapping):
        try:
            text, file = json.dumps(source, indent=1), ""
        except TypeError as error:
            raise KingpostError(
                f"study: found {error}, allowed: texts, numbers, lists, dictionaries"
            ) from None
    else:
        path = Path(source)
        if path.is_dir() or not path.exists():
            what = "a folder" if path.is_dir() else "no such file"
            raise ScenarioError(f"{path}: found {what}, allowed: the file of a study", file=str(path))
        text, file = gallery.read_text(path), str(path)
    content, places = engine.read_study(text, file)
    return StudyFile(text, file, json.loads(content), json.loads(places))

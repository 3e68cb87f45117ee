"""Events, warnings, limits and the scenario of a run in the attributes of its data set.

They are stored as JSON, which every file format can hold. Only this module and `kept` read and write this
JSON.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any, TypedDict, TypeVar

T = TypeVar("T")


class EventEntry(TypedDict):
    """An event: its time, s, its element, and its name."""

    time_s: float
    element: str
    what: str


class WarningEntry(TypedDict):
    """A warning: its time, s, the name of its element, and its text."""

    time_s: float
    name: str
    text: str


class LimitEntry(TypedDict):
    """Result of a limit; its numbers are in `unit`, and None if missing."""

    name: str
    column: str
    unit: str
    at_least: float | None
    at_most: float | None
    held: bool | None
    worst: float | None
    worst_time_s: float | None


def write(attributes: dict[str, Any], **entries: Sequence[Any] | Mapping[str, Any]) -> None:
    """Convert entries to attributes by name: events, warnings, limits, model_warnings, sea.

    >>> attributes = {}
    >>> write(attributes, warnings=[{"time_s": 4.0, "name": "ship", "text": "it heeled"}])
    >>> warnings_of(attributes)[0]["name"]
    'ship'
    """
    attributes.update({name: json.dumps(of) for name, of in entries.items()})


def events_of(attributes: Mapping[str, Any]) -> list[EventEntry]:
    """Events of a run, in order of time."""
    return _read(attributes, "events", [])


def warnings_of(attributes: Mapping[str, Any]) -> list[WarningEntry]:
    """Warnings from the rows of a run, in order of time."""
    return _read(attributes, "warnings", [])


def limits_of(attributes: Mapping[str, Any]) -> list[LimitEntry]:
    """The limits of a run, in the order of its scenario."""
    return _read(attributes, "limits", [])


def limits_of_runs(attributes: Mapping[str, Any]) -> list[list[LimitEntry]]:
    """The limits of each run of a `Batch`."""
    return _read(attributes, "limits", [])


def warnings_of_runs(attributes: Mapping[str, Any]) -> list[list[WarningEntry]]:
    """Warnings from the rows of each run of a `Batch`."""
    return _read(attributes, "warnings", [])


def model_warnings_of(attributes: Mapping[str, Any]) -> list[str]:
    """Warnings about the model, from before the run."""
    return _read(attributes, "model_warnings", [])


def scenario_of(attributes: Mapping[str, Any]) -> dict[str, Any]:
    """The resolved scenario of a run."""
    return _read(attributes, "scenario", {})


def digests_of(attributes: Mapping[str, Any]) -> dict[str, str]:
    """Digests of the files that a scenario names."""
    return _read(attributes, "files", {})


def floating_bodies_of(attributes: Mapping[str, Any]) -> list[str]:
    """Names of the bodies that float."""
    return _read(attributes, "floating_bodies", [])


def sea_of(attributes: Mapping[str, Any]) -> dict[str, str]:
    """Axes of a study that set its sea, by quantity: significant_height, peak_period, direction."""
    return _read(attributes, "sea", {})


def axes_of(attributes: Mapping[str, Any]) -> list[str]:
    """Names of the axes of a study."""
    return _read(attributes, "axes", [])


def of_run(attributes: Mapping[str, Any], run: int) -> dict[str, Any]:
    """The attributes of one run of a `Batch`."""
    own: dict[str, Any] = {"model_warnings": attributes["model_warnings"]}
    write(own, warnings=warnings_of_runs(attributes)[run], limits=limits_of_runs(attributes)[run])
    return own


def _read(attributes: Mapping[str, Any], name: str, absent: T) -> T:
    """Read an attribute; an absent or empty one gives an empty value of its type."""
    text = attributes.get(name)
    return json.loads(text) if text else absent

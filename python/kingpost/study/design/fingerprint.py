"""Fingerprint of a study: digests of everything that determines its numbers, by part, and the names of parts
that differ."""

from __future__ import annotations

import hashlib
import inspect
import json
from collections.abc import Mapping

from ...analysis import fatigue
from ...analysis.extremes import peaks
from ...analysis.statistics import up_crossing_period
from .. import reduce, steps

MOST_NAMED = 3
"""Largest number of differing fields that a message names."""


def of_value(value: object) -> str:
    """SHA-256 of a value as JSON.

    >>> of_value({"b": 1, "a": [2]}) == of_value({"a": [2], "b": 1})
    True
    """
    return hashlib.sha256(json.dumps(value, sort_keys=True).encode()).hexdigest()


def reduction() -> str:
    """SHA-256 of the source code of the functions that reduce the rows of a run."""
    # Imports are part of the text of `reduce`: if that file moves, no study can be resumed.
    parts = (reduce, steps, peaks, up_crossing_period, fatigue)
    return hashlib.sha256("".join(inspect.getsource(part) for part in parts).encode()).hexdigest()


def differences(before: Mapping[str, str], now: Mapping[str, str]) -> list[str]:
    """List the parts whose digests differ.

    >>> differences({"axes": "1", "engine": "2"}, {"axes": "1", "engine": "3"})
    ['engine']
    """
    return [name for name in {**before, **now} if before.get(name) != now.get(name)]


def fields(before: object, now: object, path: str = "") -> list[str]:
    """List the dotted paths at which two values differ.

    >>> fields({"sea": {"depth_m": 10}, "title": "x"}, {"sea": {"depth_m": 20}, "title": "x"})
    ['sea.depth_m']
    """
    if isinstance(before, dict) and isinstance(now, dict):
        pairs = {str(key): (before.get(key), now.get(key)) for key in {**before, **now}}
    elif isinstance(before, list) and isinstance(now, list) and len(before) == len(now):
        pairs = {str(k): (before[k], now[k]) for k in range(len(now))}
    else:
        return [] if before == now else [path]
    return [
        found
        for key, (old, new) in pairs.items()
        for found in fields(old, new, f"{path}.{key}".removeprefix("."))
    ]


def in_words(parts: list[str], scenario_fields: list[str]) -> str:
    """Format the differing parts of a study for a message.

    >>> in_words(["scenario", "engine"], ["sea.depth_m"])
    'scenario (sea.depth_m), engine'
    """
    named = scenario_fields[:MOST_NAMED] + ["..."] * (len(scenario_fields) > MOST_NAMED)
    of_scenario = f"scenario ({', '.join(named)})" if named else "scenario"
    return ", ".join(of_scenario if part == "scenario" else part for part in parts)

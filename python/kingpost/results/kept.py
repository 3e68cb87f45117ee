"""JSON attributes of a file of results, and the form of each."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from types import NoneType
from typing import Any

import numpy as np

NUMBER, TEXT, FLAG, OR_NOTHING = "number", "text", "flag", "?"
KINDS = {TEXT: str, FLAG: bool}
ENTRIES = {
    "events": {"time_s": NUMBER, "element": TEXT, "what": TEXT},
    "warnings": {"time_s": NUMBER, "name": TEXT, "text": TEXT},
    "limits": {
        "name": TEXT, "column": TEXT, "unit": TEXT, "at_least": NUMBER + OR_NOTHING,
        "at_most": NUMBER + OR_NOTHING,
        "held": FLAG + OR_NOTHING, "worst": NUMBER + OR_NOTHING, "worst_time_s": NUMBER + OR_NOTHING,
    },
}  # fmt: skip
"""Attributes with a list of entries; for several runs a list for each run."""
TEXTS = ("model_warnings", "floating_bodies")
"""Attributes with a list of texts."""
FIELDS = ("scenario", "files", "versions")
"""Attributes with fields by name."""


def are_of_a_run(attributes: Mapping[str, Any], runs: int | None) -> bool:
    """Whether attributes have the form of those of a run, or of all runs of a `Batch`. Attributes may be
    missing: files of earlier versions have fewer.

    >>> are_of_a_run({"events": '[{"time_s": 1.5, "element": "winch", "what": "stops"}]'}, None)
    True
    >>> are_of_a_run({"events": '[{"time_s": 1.5}]'}, None), are_of_a_run({"limits": "[[]]"}, 2)
    (False, False)
    """
    try:
        found = {
            name: json.loads(attributes[name]) for name in (*ENTRIES, *TEXTS, *FIELDS) if name in attributes
        }
    except (TypeError, ValueError, RecursionError):
        return False
    return (
        all(_are_entries(found[name], fields, runs) for name, fields in ENTRIES.items() if name in found)
        and all(_is_list_of_texts(found[name]) for name in TEXTS if name in found)
        and all(isinstance(found[name], dict) for name in FIELDS if name in found)
        and all(isinstance(digest, str) for digest in found.get("files", {}).values())
        and _is_scenario(found.get("scenario", {}))
        and isinstance(attributes.get("seed", 0), int | np.integer)
    )


def _are_entries(found: object, fields: Mapping[str, str], runs: int | None) -> bool:
    if not isinstance(found, list):
        return False
    if runs is not None and found and all(isinstance(of_run, list) for of_run in found):
        return len(found) == runs and all(_are_entries(of_run, fields, None) for of_run in found)
    return all(
        isinstance(entry, dict) and all(name in entry and _is(entry[name], kind) for name,
        kind in fields.items())
        and not ("at_most" in fields and entry["at_least"] is None and entry["at_most"] is None)
        for entry in found
    )  # fmt: skip


def _is(value: object, kind: str) -> bool:
    if value is None:
        return kind.endswith(OR_NOTHING)
    kind = kind.removesuffix(OR_NOTHING)
    if kind == NUMBER:
        return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)
    return isinstance(value, KINDS[kind])


def _is_list_of_texts(found: object) -> bool:
    return isinstance(found, list) and all(isinstance(text, str) for text in found)


def _is_scenario(found: Any) -> bool:
    """Whether the fields of a scenario that statistics read have the right types."""
    if not isinstance(found, dict):
        return False
    sea, parameters = found.get("sea"), found.get("parameters")
    return (
        all(isinstance(found.get(name), dict | NoneType) for name in ("sea", "operation"))
        and isinstance(found.get("simulation", {}), dict)
        and (not sea or _is(sea.get("ramp_s"), NUMBER))
        and (
            not parameters
            or (
                isinstance(parameters, list)
                and all(isinstance(one, dict) and "name" in one for one in parameters)
            )
        )
    )

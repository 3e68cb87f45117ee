"""Form of what a file of results holds: its JSON attributes, and the variables of its events, warnings and
limits."""

from __future__ import annotations

import hashlib
import json
import math
from collections.abc import Mapping
from types import NoneType
from typing import TYPE_CHECKING, Any

import numpy as np

from .entry_tables import BOUNDS, HELD, MODEL, OF_RUNS, TABLES, Field

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

FIELDS = ("scenario", "files", "versions")
"""Attributes of JSON text, with fields by name."""
DIGEST = "attributes_sha256"
DIGESTED = (*FIELDS, "seed", "gravity_m_s2", "water_density_kg_m3")
"""Attributes with numbers, which checksums of the file do not cover."""


def digest_of(attributes: Mapping[str, Any]) -> str:
    """SHA-256 of the attributes with numbers.

    >>> digest_of({"seed": 1}) == digest_of({"seed": np.int64(1), "title": "a lift"})
    True
    """
    values = [attributes.get(name) for name in DIGESTED]
    plain = [value.item() if isinstance(value, np.generic) else value for value in values]
    return hashlib.sha256(json.dumps(plain).encode()).hexdigest()


def is_of_a_run(results: xarray.Dataset) -> bool:
    """Whether attributes, events, warnings and limits have the form of those of a run, or of all runs of a
    `Batch`. They may be missing: files of earlier versions have fewer.

    >>> import xarray
    >>> from .entries import with_entries
    >>> found = with_entries(xarray.Dataset(), model_warnings=["nothing carries the ship"])
    >>> is_of_a_run(found), is_of_a_run(found.drop_vars("warning_text"))
    (True, False)
    """
    return has_attributes(results.attrs) and has_entries(results)


def has_attributes(attributes: Mapping[str, Any]) -> bool:
    """Whether attributes have the form of those of a run.

    >>> has_attributes({"seed": 1}), has_attributes({"scenario": "[]"})
    (True, False)
    """
    try:
        found = {name: json.loads(attributes[name]) for name in FIELDS if name in attributes}
        digest = digest_of(attributes)
    except (TypeError, ValueError, RecursionError):
        return False
    return (
        all(isinstance(tree, dict) for tree in found.values())
        and all(isinstance(digest, str) for digest in found.get("files", {}).values())
        and _is_scenario(found.get("scenario", {}))
        and isinstance(attributes.get("seed", 0), int | np.integer)
        and isinstance(attributes.get("floating_bodies", ""), str)
        and attributes.get(DIGEST, digest) == digest
    )


def has_entries(results: xarray.Dataset) -> bool:
    """Whether the variables of events, warnings and limits have the form of those of a run; each table may be
    absent.

    >>> import xarray
    >>> has_entries(xarray.Dataset({"event_time": ("event", [1.5])}))
    False
    """
    runs = results.sizes.get("run")
    for dim, fields in TABLES.items():
        expected = [name for name, field in fields.items() if field.key != "run" or runs is not None]
        present = [name for name in fields if name in results.variables]
        if not present:
            continue
        expected = [name for name in expected if name in present or not fields[name].later]
        if not set(expected) <= set(present):
            return False
        held = {name: results.variables[name] for name in expected}
        if not all(_is_along(held[name], dim, name, runs) for name in expected):
            return False
        values = {name: np.asarray(one.values) for name, one in held.items()}
        if not all(_is_of_type(values[name], fields[name]) for name in expected):
            return False
        if not _makes_sense(dim, values, runs):
            return False
    return True


def _is_along(variable: xarray.Variable, dim: str, name: str, runs: int | None) -> bool:
    """Whether a variable has its dimensions: for several runs some have the dimension ``run``."""
    if runs is None or name not in (*OF_RUNS, *BOUNDS):
        return variable.dims == (dim,)
    return variable.dims == ("run", dim) or (name in BOUNDS and variable.dims == (dim,))


def _is_of_type(values: NDArray[Any], field: Field) -> bool:
    if field.kind is str:
        return values.dtype.kind == "U" or all(isinstance(text, str) for text in values.ravel().tolist())
    if field.kind is float:
        return values.dtype.kind == "f" and not np.isinf(values).any()
    return values.dtype.kind in "iu"


def _makes_sense(dim: str, values: Mapping[str, NDArray[Any]], runs: int | None) -> bool:
    """Whether the numbers that must be known are known."""
    if dim == "event":
        return not np.isnan(values["event_time"]).any()
    if dim == "warning":
        of_run = values.get("warning_run", np.empty(0, int))
        known = np.isfinite(values["warning_time"]) | (values["warning_code"] == MODEL)
        return bool(known.all() and (of_run >= -1).all() and (of_run < (runs or 0)).all())
    held, (least, most) = values[f"limit_{HELD}"], (values[f"limit_at_{side}"] for side in ("least", "most"))
    is_bounded = ~np.isnan(least) | ~np.isnan(most)
    is_judged = (held == -1) | ~np.isnan(values["limit_worst"])
    return bool(np.isin(held, (-1, 0, 1)).all() and is_bounded.all() and is_judged.all())


def _is_scenario(found: Any) -> bool:
    """Whether the fields of a scenario that statistics read have the right types."""
    if not isinstance(found, dict):
        return False
    sea, parameters = found.get("sea"), found.get("parameters")
    return (
        all(isinstance(found.get(name), dict | NoneType) for name in ("sea", "operation"))
        and isinstance(found.get("simulation", {}), dict)
        and (not sea or _is_number(sea.get("ramp_s")))
        and (
            not parameters
            or (
                isinstance(parameters, list)
                and all(isinstance(one, dict) and "name" in one for one in parameters)
            )
        )
    )


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)

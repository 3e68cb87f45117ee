"""Frame of a study's results: coordinates, attributes, and arrays that are filled run by run."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ...engine import engine
from ...results.entries import sea_attributes
from ..design.plan import Plan
from ..reduce import HELD_MEANINGS, STATISTICS, STATUS, variables
from ..steps import EXTREMES


def write_frame(path: Path, plan: Plan) -> None:
    """Write a Zarr group with all arrays, the coordinates filled and the others empty."""
    import zarr

    group = zarr.create_group(str(path), zarr_format=3, attributes={**group_attributes(plan)})
    for name, (dim, values, about) in coordinates(plan).items():
        array = group.create_array(
            name,
            shape=values.shape,
            chunks=values.shape,
            dtype=values.dtype,
            dimension_names=(dim,),
            attributes={**about},
        )
        array[:] = values
    for name, one in variables(plan.kept).items():
        group.create_array(
            name,
            shape=(plan.runs, *one.shape),
            chunks=(plan.runs_of_unit, *one.shape),
            dtype=one.dtype,
            fill_value=one.fill,
            dimension_names=("run", *one.dims),
            attributes={"long_name": one.long_name, **FLAGS.get(name, {})},
        )


def _flags(meanings: Mapping[int, str]) -> dict[str, list[int] | str]:
    return {"flag_values": list(meanings), "flag_meanings": " ".join(meanings.values())}


FLAGS: dict[str, Mapping[str, list[int] | str]] = {
    "status": _flags(STATUS),
    "limit_held": _flags(HELD_MEANINGS),
    "limit_time": {"units": "s"},
    "step_begin": {"units": "s"},
    "step_end": {"units": "s"},
    "step_limit_time": {"units": "s"},
}


def coordinates(plan: Plan) -> dict[str, tuple[str, NDArray[np.generic], dict[str, str]]]:
    """Dimension, values and attributes of each coordinate."""
    seeds, count = plan.seeds, plan.cases.count
    texts = np.dtypes.StringDType()
    units = {one["name"]: one["unit"] for one in plan.scenario.model["parameters"]}
    found: dict[str, tuple[str, NDArray[np.generic], dict[str, str]]] = {
        "run": ("run", np.arange(plan.runs), {}),
        "case": ("run", np.repeat(np.arange(count), len(seeds)), {}),
        "seed": ("run", np.tile(np.array(seeds, "u8"), count), {}),
    }
    for name in plan.cases.names:
        values = plan.cases.values[name]
        array = np.array(values, texts if isinstance(values[0], str) else None)
        about = {"units": units[name]} if units.get(name) else {}
        found[name] = ("run", np.repeat(array, len(seeds)), about)
    for name, draws in plan.cases.drawn.items():
        found[name] = ("run", np.repeat(np.array(draws), len(seeds)), {})
    found["column"] = ("column", np.array(list(plan.columns), texts), {})
    found["column_unit"] = ("column", np.array(list(plan.columns.values()), texts), {})
    found["statistic"] = ("statistic", np.array(STATISTICS, texts), {})
    if plan.limits:
        found["limit"] = ("limit", np.array([one.name for one in plan.limits], texts), {})
        found["limit_column"] = ("limit", np.array([one.column for one in plan.limits], texts), {})
        found["limit_unit"] = ("limit", np.array([one.unit for one in plan.limits], texts), {})
        # A missing bound is NaN.
        found["at_least"] = ("limit", np.array([one.at_least for one in plan.limits], float), {})
        found["at_most"] = ("limit", np.array([one.at_most for one in plan.limits], float), {})
        bounds = plan.kept.bounds
        found["limit_from_s"] = ("limit", np.array([one.from_s for one in bounds], float), {"units": "s"})
        duration_s = float(plan.scenario.resolved["simulation"]["duration_s"])
        until_s = np.minimum([one.until_s for one in bounds], duration_s)
        found["limit_until_s"] = ("limit", until_s, {"units": "s"})
        found["limit_percentile"] = ("limit", np.array([one.percentile for one in bounds], float), {})
        found["limit_unit_si"] = ("limit", np.array([one.unit_si for one in bounds], float), {})
    if plan.kept.steps:
        found["step"] = ("step", np.arange(1, len(plan.kept.steps) + 1), {})
        found["step_name"] = ("step", np.array(plan.kept.steps, texts), {})
        # NaN for a step that happens once.
        found["stationary_s"] = ("step", np.array(plan.parts.stationary_s, float), {"units": "s"})
        found["extreme"] = ("extreme", np.array(EXTREMES, texts), {})
    if plan.kept.peaks:
        found["peak"] = ("peak", np.arange(plan.kept.keep), {})
    if plan.kept.cycles:
        found["slope"] = ("slope", np.array(plan.kept.slopes), {})
    return found


def group_attributes(plan: Plan) -> dict[str, str | float]:
    """Attributes of the whole group, with the names of its coordinates."""
    named = " ".join(name for name, (dims, _, _) in coordinates(plan).items() if dims != name)
    return {**_attributes(plan), "coordinates": named}


def _attributes(plan: Plan) -> dict[str, str | float]:
    content, settings = plan.file.content, plan.scenario.resolved["simulation"]
    length_s = settings["duration_s"] - content["after_s"]
    return {
        "title": content["title"],
        "study": json.dumps(content),
        "scenario": plan.scenario.json,
        "source": plan.scenario.file,
        "files": json.dumps(plan.scenario.digests),
        "fingerprint": plan.fingerprint,
        "kingpost": engine.__version__,
        "axes": " ".join(plan.cases.names),
        **sea_attributes(plan.sea),
        "after_s": content["after_s"],
        "duration_s": settings["duration_s"],
        "operation_s": content.get("operation_s", length_s),
        "acceptance": content["acceptance"],
        "one_off": int(plan.parts.one_off),
    }

"""Trial builds before the first run: the values of each axis, and the corners of all axes."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import islice

from ...errors import ScenarioError
from ...scenario import ParameterValue, Scenario
from ...simulation.batch import SEED
from .cases import Cases, values_of
from .content import Axis
from .file import StudyFile

MOST_CHECKED = 100
"""Largest number of values of an axis, and of corners of all axes, that are tried before the first run."""
MOST_NAMED = 3
"""Largest number of valid values of an axis that an error names."""
TAKEN = {
    *("run", "case", "seed", "sample", "cell", "status", "statistic", "statistics"),
    *("column", "column_unit", "limit", "limit_column", "limit_unit", "limit_unit_si"),
    *("at_least", "at_most", "limit_from_s", "limit_until_s", "limit_percentile"),
    *("limit_held", "limit_worst", "limit_time"),
    *("step", "step_name", "step_begin", "step_end", "step_extremes"),
    *("step_limit_worst", "step_limit_time", "stationary_s", "extreme"),
    *("peak", "peaks", "peak_count", "slope", "damage", "cycles"),
}
"""Names of the results, which are not allowed for an axis."""


def _tried(axis: Axis) -> list[tuple[str, ParameterValue]]:
    """Tried values of an axis, with their places in the file."""
    if "latin_hypercube" in axis:
        interval = axis["latin_hypercube"]
        return [("latin_hypercube.from", interval["from"]), ("latin_hypercube.to", interval["to"])]
    if "scatter" in axis:
        return []
    values = values_of(axis)
    places = [f"values.{k}" if "values" in axis else "range" for k in range(len(values))]
    tried = list(zip(places, values, strict=True))
    return tried if len(tried) <= MOST_CHECKED else [*tried[: MOST_CHECKED - 1], tried[-1]]


def check_axes(file: StudyFile, scenario: Scenario) -> None:
    """Check that every axis has a unique name, known to the scenario, and allowed values."""
    writes = {one["name"]: one["writes"] for one in scenario.resolved.get("parameters", [])}
    written: dict[str, str] = {}
    for name, axis in file.content["axes"].items():
        if name in TAKEN:
            allowed = "a name that no variable of the results has; the path of the field that it writes"
            raise file.error(f"axes.{name}", f"{name}, a variable of the results", allowed)
        for path in writes.get(name, [name]):
            if path == SEED:
                allowed = "what cases differ in; seeds has the seeds of all of them"
                raise file.error(f"axes.{name}", "the seed", allowed)
            if path in written:
                allowed = f"one axis for {path}: {written[path]} writes it too"
                raise file.error(f"axes.{name}", "a field a second time", allowed)
            written[path] = name
        tried = _tried(axis)
        for place, value in tried:
            others = [other for _, other in tried if other != value]
            _try(file, scenario, [(name, value)], {name: f"axes.{name}.{place}"}, others)


def check_corners(file: StudyFile, scenario: Scenario, found: Cases) -> None:
    """Check that the scenario builds at all combinations of the axes' first and last points."""
    where = {name: f"axes.{name}" for name in found.names}
    for case in islice(found.corners(), MOST_CHECKED if found.names else 0):
        _try(file, scenario, found.overrides(case), where)


def _try(
    file: StudyFile,
    scenario: Scenario,
    pairs: list[tuple[str, ParameterValue]],
    where: dict[str, str],
    others: Sequence[ParameterValue] = (),
) -> None:
    try:
        scenario.with_overrides(dict(pairs))
    except ScenarioError as error:
        placed = file.placed(error, where)
        if placed is not error:
            raise placed from None
        # The error has a place in the scenario; add the case of the study that led to it.
        values = ", ".join(f"{name}: {value}" for name, value in pairs)
        if len(pairs) > 1:
            raise file.error_of("axes", f"with {values}: {error}") from None
        (name, value), works = pairs[0], _that_build(scenario, pairs[0][0], others)
        allowed = "a value with which the scenario builds" + (f", as {works}" if works else "")
        words = f"found {value}, allowed: {allowed}; with {values}: {error}"
        raise file.error_of(where[name], words, str(value), allowed) from None


def _that_build(scenario: Scenario, name: str, values: Sequence[ParameterValue]) -> str:
    """List at most three values of an axis with which the scenario builds."""
    found: list[str] = []
    for value in values:
        try:
            scenario.with_overrides({name: value})
        except ScenarioError:
            continue
        found.append(f"{value:g}" if isinstance(value, float) else str(value))
        if len(found) == MOST_NAMED:
            break
    return ", ".join(found)

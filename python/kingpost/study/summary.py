"""Summary of a study's results so far, as numbers and as text."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, TypedDict

import numpy as np

from ..scenario import ParameterValue
from ..simulation.outcomes import kind_of
from .design.job import WarningCount
from .design.plan import Plan
from .reduce import ENDED_EARLY, EXCEEDED, FINISHED, HELD, NOT_BUILT, NOT_RUN, UNKNOWN
from .seeds import SeedCount, kind_of_runs
from .store import layout
from .store.reading import open_results

if TYPE_CHECKING:
    import xarray

WARNED = 10
"""Largest number of kinds of warnings in a summary."""


class PlanSummary(TypedDict):
    """Runs that a study will make; `seeds` are the first and the last."""

    title: str
    scenario: str
    axes: dict[str, list[ParameterValue]]
    cases: int
    seeds: list[int]
    runs: int
    duration_s: float
    after_s: float
    columns: int
    limits: list[str]
    statistics: str
    seed_count: dict[str, float]
    about_seeds: list[str]


class EndedRun(TypedDict):
    """Reason why a run ended early or was not built."""

    run: int
    text: str


class LimitSummary(TypedDict):
    """Number of runs in which a limit held, and the worst value with its run, its time and the run's
    overrides."""

    name: str
    column: str
    unit: str
    held: int
    exceeded: int
    unknown: int
    worst: float | None
    worst_run: int | None
    worst_time_s: float | None
    worst_in: dict[str, ParameterValue]


class ResultSummary(TypedDict):
    """Numbers of runs by status, with the results of limits and the warnings."""

    finished: int
    ended_early: int
    not_built: int
    not_run: int
    ends: list[EndedRun]
    limits: list[LimitSummary]
    warnings: list[WarningCount]
    cut_short: str


def of_plan(plan: Plan) -> PlanSummary:
    """Summarise the runs that a study will make."""
    settings, count = plan.scenario.resolved["simulation"], SeedCount.of(plan)
    return {
        "title": plan.file.content["title"],
        "scenario": plan.scenario.title,
        "axes": {name: list(dict.fromkeys(plan.cases.values[name])) for name in plan.cases.names},
        "cases": plan.cases.count,
        "seeds": [plan.seeds[0], plan.seeds[-1]],
        "runs": plan.runs,
        "duration_s": settings["duration_s"],
        "after_s": plan.kept.after_s,
        "columns": len(plan.columns),
        "limits": [limit.name for limit in plan.limits],
        "statistics": kind_of_runs(plan),
        "seed_count": asdict(count),
        "about_seeds": list(count.sentences()),
    }


def of_results(folder: Path, plan: Plan) -> ResultSummary:
    """Summarise how the runs ended, how limits held, and the warnings of the engine."""
    found = open_results(folder)
    status = found["status"].values
    ends = {int(run): text for marker in layout.markers(folder) for run, text in marker["ends"].items()}
    return {
        "finished": int((status == FINISHED).sum()),
        "ended_early": int((status == ENDED_EARLY).sum()),
        "not_built": int((status == NOT_BUILT).sum()),
        "not_run": int((status == NOT_RUN).sum()),
        "ends": [{"run": run, "text": ends[run]} for run in sorted(ends)],
        "limits": [_limit(found, k, plan) for k in range(len(plan.limits))],
        "warnings": _warnings(folder),
        "cut_short": unfinished_operations(found),
    }


def unfinished_operations(found: xarray.Dataset) -> str:
    """Describe the runs that end before the last step of their operation; empty if there are none.

    >>> import xarray
    >>> of = {"status": ("run", [0, 0]), "step_begin": (("run", "step"), [[0.0, 9.0], [0.0, np.nan]])}
    >>> unfinished_operations(xarray.Dataset(of, {"step_name": ("step", ["lift off", "hold"])}))
    "1 of 2 runs end before the operation's 'hold': let simulation.duration_s be longer"
    """
    if "step_begin" not in found:
        return ""
    finished = found["status"].values == FINISHED
    short = int((finished & np.isnan(found["step_begin"].values[:, -1])).sum())
    name = str(found["step_name"].values[-1])
    of = f"{short} of {int(finished.sum())} runs end before the operation's {name!r}"
    return f"{of}: let simulation.duration_s be longer" if short else ""


def _limit(found: xarray.Dataset, k: int, plan: Plan) -> LimitSummary:
    limit = plan.limits[k]
    held, worst = found["limit_held"].values[:, k], found["limit_worst"].values[:, k]
    least, most = (float(found[name].values[k]) for name in ("at_least", "at_most"))
    margin = np.fmin(worst - least, most - worst)
    known = bool(np.isfinite(margin).any())
    run = int(np.nanargmin(margin)) if known else None
    return {
        "name": limit.name,
        "column": limit.column,
        "unit": limit.unit,
        "held": int((held == HELD).sum()),
        "exceeded": int((held == EXCEEDED).sum()),
        "unknown": int((held == UNKNOWN).sum()),
        "worst": None if run is None else float(worst[run]),
        "worst_run": run,
        "worst_time_s": None if run is None else float(found["limit_time"].values[run, k]),
        "worst_in": {} if run is None else dict(plan.overrides(run)),
    }


def _warnings(folder: Path) -> list[WarningCount]:
    alike: dict[tuple[str, str, str], WarningCount] = {}
    for marker in layout.markers(folder):
        for one in marker["warnings"]:
            # Units finished by an older version have no first run: theirs is the first of the unit.
            first = marker["runs"][0] + one.get("first_run", 0)
            none: WarningCount = {**one, "runs": 0, "first_run": first}
            entry = alike.setdefault(kind_of(one), none)
            entry["runs"] += one["runs"]
    return sorted(alike.values(), key=lambda one: (-one["runs"], one["name"]))


def plan_lines(about: PlanSummary) -> Iterator[str]:
    """Yield the lines of text on the runs that a study will make."""
    yield about["title"]
    yield f"scenario        {about['scenario']}"
    first, last = about["seeds"]
    seeds = f"seeds {first} to {last}" if last > first else f"seed {first}"
    after = f", statistics after {about['after_s']:g} s" if about["after_s"] else ""
    of = f"{about['duration_s']:g} s{after}: {about['cases']} cases, {seeds}"
    yield f"runs            {about['runs']} of {of}"
    yield f"statistics      {about['statistics']}"
    for heading, words in zip(("seeds", ""), about["about_seeds"], strict=False):
        yield f"{heading:<16}{words}"
    for name, values in about["axes"].items():
        yield f"axis            {name}: {_listed(values)}"
    limits = f"; limits: {', '.join(about['limits'])}" if about["limits"] else ""
    yield f"columns         {about['columns']}{limits}"


def result_lines(found: ResultSummary, runs: int) -> Iterator[str]:
    """Yield the lines of text on the results."""
    yield f"finished        {found['finished']} of {runs} runs"
    others = (found["ended_early"], "ended early"), (found["not_built"], "are no scenario")
    for count, words in (*others, (found["not_run"], "are left")):
        if count:
            yield f"                {count} {words}"
    for limit in found["limits"]:
        yield f"limit           {_limit_words(limit)}"


def warning_lines(found: ResultSummary, runs: int) -> Iterator[str]:
    """Yield the important warnings, one per line."""
    if found["cut_short"]:
        yield f"warning: {found['cut_short']}"
    if found["ends"]:
        first = found["ends"][0]
        yield f"warning, in {len(found['ends'])} of {runs} runs, first run {first['run']}: {first['text']}"
    for one in found["warnings"][:WARNED]:
        where = f"in {one['runs']} of {runs} runs, first in run {one['first_run']}"
        yield f"warning, {where}: {one['name']}: {one['text']}"
    if (more := len(found["warnings"]) - WARNED) > 0:
        yield f"warning, {more} more kinds of warnings: {layout.UNITS}/*.json have them"


def _limit_words(limit: LimitSummary) -> str:
    """The outcome of a limit in one line.

    >>> _limit_words({"name": "lift", "held": 1, "exceeded": 1, "worst": 0.5, "unit": "1", "worst_run": 61,
    ...               "worst_in": {"hs": 2.0}, "worst_time_s": 12.5})
    'lift held in 1 of 2 runs, worst 0.5 at 12.5 s in run 61 (hs 2)'
    """
    judged = limit["held"] + limit["exceeded"]
    words = f"{limit['name']} held in {limit['held']} of {judged} runs"
    if limit["worst_run"] is None:
        return words
    where = ", ".join(f"{name} {_shown(value)}" for name, value in limit["worst_in"].items())
    unit = "" if limit["unit"] == "1" else f" {limit['unit']}"
    worst = f"{limit['worst']:.4g}{unit}"
    return f"{words}, worst {worst} at {limit['worst_time_s']:.6g} s in run {limit['worst_run']} ({where})"


def _listed(values: list[ParameterValue]) -> str:
    shown = [_shown(value) for value in values]
    return ", ".join(shown) if len(shown) <= 8 else f"{len(shown)} values, {shown[0]} to {shown[-1]}"


def _shown(value: ParameterValue) -> str:
    return (
        f"{value:g}" if isinstance(value, float) else value if isinstance(value, str) else json.dumps(value)
    )

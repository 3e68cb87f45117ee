"""Recorded runs that may be averaged: realisations of one scenario, each with its own seed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import KingpostError
from ..results.entries import digests_of, scenario_of
from ..simulation.batch import SEED

if TYPE_CHECKING:
    import xarray

WORDS = ("title", "description")
"""Fields of a scenario that do not change a run."""


def check(runs: Sequence[xarray.Dataset]) -> None:
    """Refuse runs that differ in anything but their seeds; different seeds make them independent.

    Raises
    ------
    KingpostError
        Names the file, the field that differs and its value in the first run.
    """
    first, files = runs[0], dict[Any, str]()
    expected = _settings(first)
    for run in runs:
        file = file_of(run)
        for name, (found, allowed) in _differences(_settings(run), expected):
            raise KingpostError(
                f"{file}: found {name} {found}, allowed: {allowed}, as in {file_of(first)}: "
                f"runs of one scenario that differ in {SEED} only"
            )
        if not np.array_equal(run["time"].values, first["time"].values):
            found, allowed = (
                f"{len(t)} records to {t[-1]:g} s" for t in (run["time"].values, first["time"].values)
            )
            raise KingpostError(
                f"{file}: found {found}, allowed: {allowed}, as in {file_of(first)}: "
                "runs recorded at the same times"
            )
        for seed in seeds(run):
            if seed in files:
                raise KingpostError(
                    f"{file}: found {SEED} {seed}, which is that of {files[seed]}, allowed: another seed in "
                    "each run: the same seed gives the same waves"
                )
            files[seed] = file


def file_of(run: xarray.Dataset) -> str:
    """The file that a run was read from; otherwise the file of its scenario."""
    return str(run.encoding.get("source") or run.attrs.get("source", "results"))


def _settings(run: xarray.Dataset) -> dict[str, Any]:
    """The resolved scenario by dotted paths, without the seed and descriptive texts, with the digests of its
    files: two databases can have the same name."""
    found = _flat(scenario_of(run))
    kept = {name: value for name, value in found if name != SEED and name.partition(".")[0] not in WORDS}
    digests = digests_of(run)
    return kept | {f"the file {name} with SHA-256": digest[:12] for name, digest in digests.items()}


def _flat(tree: Any, name: str = "") -> Iterator[tuple[str, Any]]:
    if not isinstance(tree, dict | list):
        yield name, tree
        return
    for key, value in tree.items() if isinstance(tree, dict) else enumerate(tree):
        yield from _flat(value, f"{name}.{key}" if name else str(key))


def _differences(found: dict[str, Any], expected: dict[str, Any]) -> Iterator[tuple[str, tuple[Any, Any]]]:
    for name in {**expected, **found}:
        pair = (found.get(name, "nothing"), expected.get(name, "nothing"))
        if pair[0] != pair[1]:
            yield name, pair


def seeds(run: xarray.Dataset) -> list[Any]:
    """The seed of each run of a data set.

    Raises
    ------
    KingpostError
        If the runs of a `Batch` differ in something other than their seeds.
    """
    described = scenario_of(run)
    seed = described.get("simulation", {}).get("seed", 0)
    if "run" not in run.dims:
        return [seed]
    writes = {one["name"]: one.get("writes") for one in described.get("parameters") or []}
    found_seeds = [seed] * run.sizes["run"]
    for name, values in run.coords.items():
        if values.dims != ("run",) or name in ("run", "status"):
            continue
        if name == SEED or writes.get(str(name)) == [SEED]:
            found_seeds = values.values.tolist()
        elif len(found := np.unique(values.values)) > 1:
            raise KingpostError(
                f"{file_of(run)}: found runs with {name} {found[0]} and {found[1]}, allowed: "
                f"runs of one scenario that differ in {SEED} only"
            )
    return found_seeds

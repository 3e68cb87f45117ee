"""Helpers of the tests of studies: a fast study, and the comparison of two folders."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import xarray
import zarr
from kingpost.study.store import layout
from kingpost.study.store.digests import digest

RUNS = 24
SLEWING: dict[str, Any] = {
    "version": 1,
    "title": "Slewing",
    "scenario": "paper",
    "set": {"simulation.duration_s": 0.2, "simulation.step_s": 0.002, "simulation.record_every_s": 0.01},
    "axes": {
        "crane_x_m": {"range": {"from": -10, "to": 0, "count": 6}},
        "motor_2": {"values": [True, False]},
    },
    "seeds": {"count": 2},
    "after_s": 0.05,
    "record": ["ship.roll", "ship.position.*"],
    "limits": {"roll": {"column": "ship.roll", "within": 0.1, "unit": "deg"}},
    "peaks": {"columns": ["ship.roll"], "keep": 3},
    "rainflow": {"columns": ["ship.roll"], "slopes": [3]},
}
"""24 runs of the paper's crane ship, 0.2 s each."""


def numbers(folder: Path) -> dict[str, bytes]:
    """Content of the results of a study and of its markers, by file."""
    paths = [*(folder / "results.zarr").rglob("*"), *(folder / "units").glob("[0-9]*.json")]
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in paths if path.is_file()}


def written(study: dict[str, Any], path: Path) -> Path:
    """A study as a file: JSON is YAML."""
    path.write_text(json.dumps(study, indent=1), encoding="utf-8")
    return path


def folder_of(results: xarray.Dataset, folder: Path) -> Path:
    """A study's folder that holds made-up results, as one finished unit."""
    results.to_zarr(folder / layout.RESULTS, zarr_format=3, consolidated=False)
    group = zarr.open_group(str(folder / layout.RESULTS), mode="r")
    raw: dict[str, Any] = {str(name): group[str(name)] for name in results.data_vars}
    numbers_digest = digest({name: one[...] for name, one in raw.items()})
    runs = results.sizes["run"]
    about = {
        "version": layout.FORMAT,
        "depends_on": {},
        "fingerprint": "",
        "runs": runs,
        "runs_of_unit": runs,
    }
    (folder / layout.ABOUT).write_text(json.dumps(about), encoding="utf-8")
    (folder / layout.UNITS).mkdir()
    marker = {"fingerprint": "", "runs": [0, runs], "sha256": numbers_digest}
    (folder / layout.UNITS / "000000.json").write_text(json.dumps(marker), encoding="utf-8")
    return folder

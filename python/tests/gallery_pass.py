"""One pass over the gallery: each scenario is read, built and run once for all tests that need it."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import kingpost
import numpy as np
from filelock import FileLock
from kingpost import results
from kingpost.results import entries


@dataclass
class Gallery:
    """Results of the pass by scenario, in a folder that all test processes share."""

    folder: Path
    known: dict[str, dict[str, Any]] = field(default_factory=dict)

    def __getitem__(self, name: str) -> dict[str, Any]:
        """Return the results of a scenario; the first request runs it."""
        if name not in self.known:
            kept = self.folder / f"{name}.json"
            with FileLock(kept.with_suffix(".lock")):
                if not kept.exists():
                    kept.write_text(json.dumps(seen(name)), encoding="utf-8")
            self.known[name] = json.loads(kept.read_text(encoding="utf-8"))
        return self.known[name]


def seen(name: str) -> dict[str, Any]:
    """Read a scenario and its run over two steps."""
    scenario = kingpost.load(name)
    step_s = scenario.model["step_s"]
    short = {"simulation.duration_s": 2 * step_s, "simulation.record_every_s": step_s}
    simulation = kingpost.Simulation(scenario.with_overrides(short))
    found = simulation.run()
    units = [("time", results.unit_of(found["time"]))]
    units += [(column, results.unit_of(series)) for column, series in results.columns(found)]
    table = results.frame(found)
    return {
        "resolved": scenario.resolved,
        "model": scenario.model,
        "files": list(scenario.files),
        "model_warnings": entries.model_warnings_of(found),
        "channels": simulation.channels,
        "units": units,
        "columns": list(table.columns),
        "rows": len(table),
        "not_finite": [str(column) for column in table if not np.isfinite(table[column]).all()],
    }

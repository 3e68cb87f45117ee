"""Report of a floating run: the sea and heave."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .tables import fixed, table

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

    from ..scenario import Scenario

SHORTEST_RECORD_S = 60.0
"""A smaller significant height counts as no sea."""


def text(results: xarray.Dataset, scenario: Scenario) -> str:
    """Report of the sea and heave of a run; empty if there is neither."""
    parts = [_sea(results, scenario), _heave(results, scenario)]
    return "\n\n".join("\n".join(part) for part in parts if part)


def _rise(results: xarray.Dataset, body: str) -> NDArray[np.float64]:
    """Heave of a body's centre of mass since the start, m."""
    height = results["position"].sel(body=body, axis="z").values
    return height - height[0]


def _sea(results: xarray.Dataset, scenario: Scenario) -> list[str]:
    """Significant height of the waves at each hull, after their ramp."""
    sea = scenario.resolved.get("sea")
    if not sea or not results.sizes.get("hull", 0):
        return []
    after = results["time"].values >= sea["ramp_s"]
    time = results["time"].values[after]
    elevation = results["wave_elevation"].values[after]
    if len(time) < 2 or time[-1] - time[0] < SHORTEST_RECORD_S or not elevation.any():
        return []
    rows = [("waves at", "significant height", f"{time[0]:g} to {time[-1]:g} s")]
    rows += [(str(name), f"{4 * elevation[:, i].std():.3f} m", "four deviations")
             for i, name in enumerate(results["hull"].values)]  # fmt: skip
    return table(rows, "<><")


def _heave(results: xarray.Dataset, scenario: Scenario) -> list[str]:
    rows = [("rise since the start, m", "at the end", "highest", "lowest")]
    for hull in scenario.model["hulls"]:
        rise = _rise(results, hull["body"])
        rows.append((hull["body"], *(fixed(value, 4) for value in (rise[-1], rise.max(), rise.min()))))
    return table(rows) if len(rows) > 1 else []

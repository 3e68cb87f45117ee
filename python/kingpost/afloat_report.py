"""What the command line prints of a run afloat: sea, heave, lines, and where linear theory was left."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .report import MOST_ROWS, fixed, largest, table

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

    from .scenario import Scenario

LARGEST_ANGLE_DEG = 20.0
"""Heel or trim beyond which a run by linear hydrodynamics is warned of."""
LARGEST_HEAVE = 0.5
"""Heave beyond which it is, as a share of the draught."""
SHORTEST_RECORD_S = 60.0
"""A significant height of less is none."""


def text(results: xarray.Dataset, scenario: Scenario) -> str:
    """The sea, heave, tensions of lines and warnings of a run; empty where there is nothing of that kind."""
    parts = [_sea(results, scenario), _heave(results, scenario), _lines(results), warnings(results, scenario)]
    return "\n\n".join("\n".join(part) for part in parts if part)


def warnings(results: xarray.Dataset, scenario: Scenario) -> list[str]:
    """Where a hull left what linear hydrodynamics hold for: small angles, little heave, a dry deck."""
    found = []
    for hull in scenario.model["hulls"]:
        if hull["is_linear"]:
            found += _of_hull(results, hull)
    return [f"warning: {words}" for words in found]


def _of_hull(results: xarray.Dataset, hull: dict[str, Any]) -> list[str]:
    body, time = hull["body"], results["time"].values
    found = []
    for name, angle in (("heeled", "roll"), ("trimmed", "pitch")):
        values = np.degrees(results[angle].sel(body=body).values)
        worst = largest(values)
        if abs(worst) > LARGEST_ANGLE_DEG:
            at = time[np.argmax(np.abs(values))]
            found.append(
                f"{body}: it {name} to {worst:.2f} deg, at {at:g} s: linear hydrodynamics are for small "
                f"angles (warned of beyond {LARGEST_ANGLE_DEG:g} deg)"
            )
    rise = _rise(results, body)
    if abs(largest(rise)) > LARGEST_HEAVE * hull["draught_m"]:
        found.append(
            f"{body}: it {'rose' if largest(rise) > 0 else 'sank'} by {abs(largest(rise)):.2f} m, at "
            f"{time[np.argmax(np.abs(rise))]:g} s: linear hydrodynamics are for little of the draught, "
            f"{hull['draught_m']:g} m (warned of beyond half)"
        )
    height = _deck_height(results, hull)
    if height is not None and height.min() < 0:
        first = time[np.argmax(height < 0)]
        found.append(
            f"{body}: the edge of its deck went {-height.min():.2f} m under still water, first at "
            f"{first:g} s: linear hydrostatics know no deck; hydrostatics: mesh does"
        )
    return found


def _deck_height(results: xarray.Dataset, hull: dict[str, Any]) -> NDArray[np.float64] | None:
    """Of the lowest point of the deck's edge over still water, m; `None` without a mesh."""
    if hull["mesh"] is None:
        return None
    vertices = np.array(hull["mesh"]["vertices_m"])
    top = vertices[:, 2].max()
    deck = vertices[vertices[:, 2] > top - 1e-3 * np.ptp(vertices[:, 2])]
    roll, pitch = (results[angle].sel(body=hull["body"]).values for angle in ("roll", "pitch"))
    heights = np.stack([-np.sin(pitch), np.cos(pitch) * np.sin(roll), np.cos(pitch) * np.cos(roll)], axis=1)
    centre = results["position"].sel(body=hull["body"], axis="z").values
    return centre + (heights @ deck.T).min(axis=1)


def _rise(results: xarray.Dataset, body: str) -> NDArray[np.float64]:
    """Of a body's centre of mass since the start, m."""
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


def _lines(results: xarray.Dataset) -> list[str]:
    """Of each line the larger tension of its ends."""
    rows = [("line tension, kN", "at the end", "mean", "largest", "smallest")]
    for name in results["line"].values[:MOST_ROWS] if results.sizes.get("line", 0) else ():
        ends = (results[variable].sel(line=name).values for variable in ("line_tension", "line_end_tension"))
        tension = np.maximum(*ends) / 1000
        values = (tension[-1], tension.mean(), tension.max(), tension.min())
        rows.append((str(name), *(fixed(value, 2) for value in values)))
    return table(rows) if len(rows) > 1 else []

"""The unit of one column of results, where a variable has several: of force and moment, length and angle."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import xarray

SLIDING_AXES = {
    "prismatic": ("",),
    "cylindrical": (".translation",),
    "planar": (".x", ".y"),
    "moved_by_waves": (".x", ".y", ".z"),
}
"""What follows a joint's name in its coordinates that are lengths; those of the other kinds turn."""
SHEARS = (".shear_y", ".shear_z")
"""The same of the elastic joints between the segments of a flexible body."""


def sliding(results: xarray.Dataset) -> set[str]:
    """The coordinates of joints that are lengths, by the kinds of the joints in the scenario that was run.

    >>> from kingpost import run
    >>> found = sliding(run("flexible_boom", {"simulation.duration_s": 0.001}))
    >>> "boom.1.shear_z" in found, "boom.1.torsion" in found, "slew" in found
    (True, False, False)
    """
    bodies = json.loads(results.attrs.get("scenario", "{}")).get("bodies", {})
    coordinates = [str(name) for name in results["coordinate"].values] if "coordinate" in results.dims else []
    found = set()
    for body, given in bodies.items():
        ((kind, joint),) = given["joint"].items()
        found |= {f"{joint.get('name') or body}{axis}" for axis in SLIDING_AXES.get(kind, ())}
        if given.get("flexible"):
            found |= {name for name in coordinates if name.startswith(f"{body}.") and name.endswith(SHEARS)}
    return found.intersection(coordinates)


def of_column(series: xarray.DataArray, slides: set[str]) -> str:
    """The unit of one column; `slides` are the coordinates that are lengths."""
    units = str(series.attrs.get("units", ""))
    if ", " in units:
        along, about = units.split(", ")
        labels = [str(series.coords[dim].item()) for dim in ("component", "planar") if dim in series.coords]
        return about if any(label.startswith(("moment", "yaw")) for label in labels) else along
    if " or " in units and "coordinate" in series.coords:
        turning, length = units.split(" or ")
        return length if str(series.coords["coordinate"].item()) in slides else turning
    return units

"""Report of response amplitude operators."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..analysis.response import AXES
from ..results.columns import floating_bodies
from .tables import table

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

# Largest number of rows in the table of one direction; the file contains all.
MOST_FREQUENCIES = 16


def text(found: xarray.Dataset) -> str:
    """A table for each direction: amplitudes of points and floating bodies by frequency."""
    lines = [found.attrs["title"], "amplitudes for each metre of wave amplitude, about rest in still water"]
    for direction in found["direction"].values:
        lines += ["", f"waves to {np.rad2deg(direction):g} deg", *_table(found.sel(direction=direction))]
    if "warning" in found.attrs:
        lines += ["", f"warning: {found.attrs['warning']}"]
    return "\n".join(lines)


def _lines(values: NDArray[np.float64]) -> list[int]:
    """Indices of the printed rows: evenly spaced ones, and those with the largest value of a column."""
    every = -(-len(values) // MOST_FREQUENCIES)
    return sorted({*range(0, len(values), every), *values.argmax(axis=0).tolist()})


def _table(found: xarray.Dataset) -> list[str]:
    floating = floating_bodies(found)
    points = [str(point) for point in found["point"].values]
    bodies = [str(body) for body in found["body"].values if body in floating]
    heading = ["", "", *(part for point in points for part in (f"{point},", "m/m", ""))]
    heading += [part for body in bodies for part in (f"{body},", "deg/m", "")]
    under = ["rad/s", "s", *(AXES * len(points)), *(("roll", "pitch", "yaw") * len(bodies))]
    moved = found["displacement"].transpose("omega", "point", "axis").values
    turned = np.rad2deg(found["rotation"].sel(body=bodies).transpose("omega", "body", "angle").values)
    omega = found["omega"].values
    values = np.concatenate([moved.reshape(len(omega), -1), turned.reshape(len(omega), -1)], axis=1)
    rows = [heading, under]
    for k in _lines(values):
        at, row = omega[k], values[k]
        rows.append([f"{at:.3f}", f"{2 * np.pi / at:.2f}", *(f"{value:.3f}" for value in row)])
    rows.append(["largest", "", *(f"{value:.3f}" for value in values.max(axis=0))])
    rows.append(["at rad/s", "", *(f"{omega[k]:.3f}" for k in values.argmax(axis=0))])
    return table(rows, ">" * len(under))

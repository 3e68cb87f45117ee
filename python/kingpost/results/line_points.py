"""Points along lines: the line of each, and its place on it, as coordinates of a data set.

A variable at points along lines has a dimension of points, ``line_point``. Along it are the coordinates
``line_point_line``, the name of the line of each point, ``line_point_share``, its place as a share of the
unstretched length from the line's first end, and ``line_point_arc_length``, its place in m.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

    from .channels import Channel

LINE, SHARE, ARC_LENGTH = "_line", "_share", "_arc_length"
"""Endings of the names of the coordinates, after the name of the dimension."""


def line_point_coordinates(channels: Iterable[Channel], rows: NDArray[np.float64]) -> dict[str, Any]:
    """Coordinates of the points along lines, for `xarray.Dataset`.

    Parameters
    ----------
    channels
        The channel table.
    rows
        The recorded rows, shape (records, values), or (runs, records, values).

    Returns
    -------
    dict
        Dimensions, values and attributes by name. The arc length is that of the recorded length of the line:
        it has the dimensions ``time`` and ``run`` only where it differs along them.

    >>> line_point_coordinates([], np.empty((1, 0)))
    {}
    """
    every = list(channels)
    found: dict[str, Any] = {}
    for channel in every:
        along = channel["along"]
        if along is None:
            continue
        dim = channel["dims"][0]
        of_length = next(one for one in every if one["variable"] == along["length"])
        places = [of_length["offset"] + of_length["labels"][0].index(line) for line in along["lines"]]
        dims, arc_length = _without_equal(rows[..., places] * np.array(along["shares"]), dim)
        found |= {
            dim + LINE: (dim, np.array(along["lines"], str), {"long_name": "line"}),
            dim + SHARE: (
                dim,
                np.array(along["shares"]),
                {"units": "1", "long_name": "share of the unstretched length from the line's first end"},
            ),
            dim + ARC_LENGTH: (
                dims,
                arc_length,
                {"units": "m", "long_name": "unstretched length from the line's first end"},
            ),
        }
    return found


def _without_equal(arc_length: NDArray[np.float64], dim: str) -> tuple[tuple[str, ...], NDArray[np.float64]]:
    """The arc lengths without the dimensions ``time`` and ``run`` along which they are equal.

    A run that ended early has NaN after its end; its arc length is that of its first record.
    """
    dims = [*("run", "time")[3 - arc_length.ndim :], dim]
    for axis in reversed(range(len(dims) - 1)):
        first = arc_length.take([0], axis) if arc_length.shape[axis] else arc_length
        if first.size and (np.isnan(arc_length) | (arc_length == first)).all():
            arc_length = np.asarray(first.squeeze(axis))
            dims.pop(axis)
    return tuple(dims), arc_length


def points_dimension(variable: xarray.DataArray) -> Hashable | None:
    """The dimension of points along lines of a variable.

    Parameters
    ----------
    variable
        A variable of a run's data set.

    Returns
    -------
    hashable or None
        Name of the dimension, ``line_point``; None if the variable is not at points along lines.

    >>> from kingpost import run
    >>> points_dimension(run("paper", {"simulation.duration_s": 0.001})["roll"]) is None
    True
    """
    return next((dim for dim in variable.dims if f"{dim}{LINE}" in variable.coords), None)

"""Range graphs of lines: statistics of the tension and its fatigue over the arc length.

The results have the tension at points along a line of the kind ``line``: ``points_along`` in the scenario.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ..errors import KingpostError
from ..results.line_points import ARC_LENGTH, LINE, SHARE, points_dimension
from .fatigue import SLOPES, damage
from .records import after

if TYPE_CHECKING:
    import xarray

TENSION = "line_tension_along"
PARTS = {
    "least": "least tension",
    "mean": "mean tension",
    "largest": "largest tension",
    "standard_deviation": "standard deviation of the tension",
}
"""Variables of a range graph, with their long names."""


def lines_with_points(results: xarray.Dataset) -> list[str]:
    """Names of the lines that have a range graph.

    Parameters
    ----------
    results
        A data set of a run.

    Returns
    -------
    list of str
        The names, in the order of the scenario; empty if no line has its tension along it in the results.

    >>> from kingpost import run
    >>> lines_with_points(run("paper", {"simulation.duration_s": 0.001}))
    []
    """
    if TENSION not in results:
        return []
    dim = points_dimension(results[TENSION])
    return [] if dim is None else list(dict.fromkeys(map(str, results[f"{dim}{LINE}"].values)))


def range_graph(results: xarray.Dataset, line: str, after_s: float = 0.0) -> xarray.Dataset:
    """Least, mean and largest tension of a line, and its standard deviation, over the arc length.

    Parameters
    ----------
    results
        A data set of `run` or `Batch`, or read from a file of it.
    line
        Name of a line of the kind ``line``, with ``points_along`` in the scenario.
    after_s
        Leave out the records before this time, s.

    Returns
    -------
    xarray.Dataset
        ``least``, ``mean``, ``largest`` and ``standard_deviation``, N, along ``arc_length``: the unstretched
        length from the line's first end, m. Of a `Batch` also along ``run``. Where the length of the line
        differs over time or between runs, the dimension is ``share``, of that length, and ``arc_length`` is
        a coordinate with its mean over time. NaN for a run that ended early. The attributes have the name of
        the ``line`` and the times, s.

    Raises
    ------
    KingpostError
        If there is no such line with tensions along it, or less than two records are left.

    >>> from kingpost import run
    >>> chain = {"unstretched_length_m": 210, "elements": 8, "mass_kg_per_m": 50, "diameter_m": 0.1,
    ...          "axial_stiffness_kN": 1e5}
    >>> hung = {"first": {"body": "ship", "position_m": [0, 0, 0]}, "sections": [chain],
    ...         "second": {"body": "world", "position_m": [200, 0, -20]}, "points_along": 5}
    >>> ds = run("paper", {"forces.chain": {"line": hung}, "simulation.duration_s": 0.1})
    >>> graph = range_graph(ds, "chain")
    >>> graph.arc_length.values.tolist(), graph.largest.attrs["units"]
    ([0.0, 52.5, 105.0, 157.5, 210.0], 'N')
    >>> bool((graph.least <= graph.largest).all())
    True
    """
    tension = _along(results, line, after_s)
    time = tension["time"].values
    found = {
        "least": tension.min("time", skipna=False),
        "mean": tension.mean("time", skipna=False),
        "largest": tension.max("time", skipna=False),
        "standard_deviation": tension.std("time", skipna=False),
    }
    for name, variable in found.items():
        variable.attrs = {"units": "N", "long_name": PARTS[name]}
    about = {
        "title": results.attrs.get("title", ""),
        "line": line,
        "first_time_s": float(time[0]),
        "last_time_s": float(time[-1]),
    }
    return _dataset(found, about)


def line_fatigue(
    results: xarray.Dataset, line: str, slopes: Sequence[float] = SLOPES, after_s: float = 0.0
) -> xarray.Dataset:
    """Fatigue of the tension of a line over the arc length, by rainflow counts at each point.

    Parameters
    ----------
    results
        A data set of `run` or `Batch`, or read from a file of it.
    line
        Name of a line of the kind ``line``, with ``points_along`` in the scenario.
    slopes
        m of each damage sum.
    after_s
        Leave out the records before this time, s.

    Returns
    -------
    xarray.Dataset
        Along ``arc_length`` as for `range_graph`: ``damage``, the sums of `kingpost.fatigue.damage`, N^m, and
        ``equivalent_range``, N, the range of which as many cycles have the same damage, both also along
        ``slope``; ``cycles``, their number.

    Raises
    ------
    KingpostError
        If there is no such line with tensions along it, a slope is not greater than 0, or less than two
        records are left.

    >>> import xarray
    >>> time = np.arange(0.0, 100.1, 0.5)
    >>> pull = xarray.DataArray(
    ...     np.cos(np.pi * time / 2)[:, None] * np.array([[1.0, 2.0]]), dims=("time", "line_point"), coords={
    ...         "time": time, "line_point": ["chain.point_1", "chain.point_2"],
    ...         "line_point_line": ("line_point", ["chain", "chain"]),
    ...         "line_point_share": ("line_point", [0.0, 1.0]),
    ...         "line_point_arc_length": ("line_point", [0.0, 50.0])})
    >>> found = line_fatigue(xarray.Dataset({"line_tension_along": pull}), "chain", (3,))
    >>> found.equivalent_range.sel(arc_length=50).values.round(9).tolist()
    [4.0]
    """
    sums = damage(_along(results, line, after_s), slopes)
    cycles, duration_s = sums["cycles"], sums.attrs["duration_s"]
    with np.errstate(divide="ignore", invalid="ignore"):
        equivalent = ((sums / cycles) ** (1 / sums["slope"])).where(cycles != 0, 0.0)
    found = {"damage": sums, "equivalent_range": equivalent, "cycles": cycles}
    about = {
        "damage": ("N^m", "damage sum of the tension"),
        "equivalent_range": ("N", "equivalent range of the tension"),
        "cycles": ("1", "cycles of the tension"),
    }
    for name, (unit, long_name) in about.items():
        found[name] = found[name].drop_vars("cycles", errors="ignore").copy()
        found[name].attrs = {"units": unit, "long_name": long_name}
    more = {"line": line, "duration_s": duration_s}
    return _dataset(found, {"title": results.attrs.get("title", ""), **more})


def _along(results: xarray.Dataset, line: str, after_s: float) -> xarray.DataArray:
    """The tension of a line over time and along ``arc_length``, or ``share`` where the length differs."""
    every = lines_with_points(results)
    if line not in every:
        names = ", ".join(every) or "none: no line of the run has points_along"
        raise KingpostError(f"line: found {line!r}, allowed: {names}")
    dim = points_dimension(results[TENSION])
    of_line = results[TENSION].isel({dim: results[f"{dim}{LINE}"].values == line})
    kept = after(of_line, after_s)
    share, arc_length = kept[f"{dim}{SHARE}"], kept[f"{dim}{ARC_LENGTH}"]
    own = [name for name in kept.coords if str(name).startswith(str(dim))]
    same = arc_length.dims == (dim,)
    along = "arc_length" if same else "share"
    plain = kept.drop_vars(own).rename({dim: along})
    if same:
        return plain.assign_coords(arc_length=("arc_length", arc_length.values, arc_length.attrs))
    mean = arc_length.mean("time") if "time" in arc_length.dims else arc_length
    mean = mean.drop_vars(own, errors="ignore").rename({dim: along})
    mean.attrs = arc_length.attrs
    return plain.assign_coords(share=("share", share.values, share.attrs), arc_length=mean)


def _dataset(found: dict[str, xarray.DataArray], about: dict[str, object]) -> xarray.Dataset:
    import xarray

    return xarray.Dataset({name: one.rename(name) for name, one in found.items()}, attrs=about)

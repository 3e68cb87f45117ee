"""`ds.kingpost`: what Kingpost knows to do with a data set of a run.

It is there with every data set that Kingpost makes or reads; where xarray alone opens a file, once xarray was
imported before Kingpost, or `register` was called.
"""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from . import markup
from .results.columns import column, columns
from .results.events import events, warnings
from .results.xarrays import when_loaded

if TYPE_CHECKING:
    import pandas
    import xarray
    from matplotlib.figure import Figure


class Accessor:
    """Columns, statistics and pictures of a recorded run.

    Parameters
    ----------
    results
        A data set of `kingpost.run`, or of a file that it was written to.

    >>> import kingpost
    >>> ds = kingpost.run("paper", {"simulation.duration_s": 0.5})
    >>> ds.kingpost["ship.roll"].attrs["units"]
    'rad'
    >>> ds.kingpost.columns[:2]
    ['ship.position.x', 'ship.position.y']
    """

    def __init__(self, results: xarray.Dataset) -> None:
        self._results = results

    @property
    def columns(self) -> list[str]:
        """Names of the columns, as files and the app have them."""
        return [name for name, _ in columns(self._results, along=("time", "run"))]

    def __getitem__(self, name: str | tuple[str, ...]) -> xarray.DataArray:
        """A column over time, by its name or by the name's parts.

        >>> import kingpost
        >>> ds = kingpost.run("paper", {"simulation.duration_s": 0.5})
        >>> ds.kingpost["arm.tip", "point_position", "z"].equals(ds.kingpost["arm.tip.point_position.z"])
        True
        """
        return column(self._results, name if isinstance(name, str) else ".".join(name))

    def time_history(self, name: str, period_s: tuple[float, float] | None = None) -> xarray.DataArray:
        """A column over a period.

        Parameters
        ----------
        name
            Of the column, as ``ship.roll``.
        period_s
            From and to, s, both included; the whole run without.

        Returns
        -------
        xarray.DataArray
            Along ``time`` (s), of a `Batch` along ``run`` too; its ``units`` are SI.

        Raises
        ------
        KingpostError
            When there is no such column, or no record in the period.

        >>> import kingpost
        >>> ds = kingpost.run("paper", {"simulation.duration_s": 0.5})
        >>> ds.kingpost.time_history("ship.roll", (0.2, 0.3)).sizes["time"]
        11
        """
        return column(self._results, name, period_s)

    def statistics(self, *names: str, after_s: float | None = None) -> pandas.DataFrame:
        """What `kingpost statistics` prints of a run: a row for each column.

        Parameters
        ----------
        names
            Columns or patterns, as ``ship.*``; the main ones without.
        after_s
            Leave out what is before, s; without: the ramp of the waves.

        Returns
        -------
        pandas.DataFrame
            ``channel``, ``unit`` (deg, kN, t) and the statistics in it.

        Raises
        ------
        KingpostError
            When no column has a name, or the runs of a `Batch` differ in more than their seeds.

        >>> import kingpost
        >>> ds = kingpost.run("paper", {"simulation.duration_s": 0.5})
        >>> ds.kingpost.statistics("ship.roll")[["channel", "unit"]].values.tolist()
        [['ship.roll', 'deg']]
        """
        from .reports.statistics import frame

        return frame([self._results], after_s, names)

    def plot(self, *names: str) -> Figure:
        """A picture of columns over time, a panel for each unit, with the scenario's limits and the steps of
        its operation.

        Parameters
        ----------
        names
            Columns or patterns, as ``ship.*``; without, those with a limit and the main ones.

        Returns
        -------
        matplotlib.figure.Figure
            Which a notebook shows.

        Raises
        ------
        KingpostError
            When no column has a name, or more than can be told apart have it.

        >>> import kingpost
        >>> ds = kingpost.run("paper", {"simulation.duration_s": 0.5})
        >>> [axes.get_ylabel() for axes in ds.kingpost.plot("ship.roll").axes]
        ['deg']
        """
        from .reports.plot import figure

        return figure(self._results, names)

    @property
    def events(self) -> xarray.Dataset:
        """What happened, as `kingpost.results.events` has it."""
        return events(self._results)

    @property
    def warnings(self) -> xarray.Dataset:
        """What one should know, as `kingpost.results.warnings` has it."""
        return warnings(self._results)

    @property
    def limits(self) -> list[dict[str, Any]]:
        """How the scenario's limits held: ``name``, ``column``, ``unit``, ``held``, ``worst``, its time; of
        a `Batch` a list for each run."""
        return json.loads(self._results.attrs.get("limits", "[]"))

    def _repr_html_(self) -> str:
        about = self._results.attrs
        time = self._results["time"].values
        rows = [("status", about.get("status", "")), ("seed", about.get("seed", "")),
                ("recorded", f"{time[0]:g} to {time[-1]:g} s, {len(time)} rows")]  # fmt: skip
        parts = [markup.table(str(about.get("title", "")), rows)]
        if "run" not in self._results.sizes and self.limits:
            held = {True: "yes", False: "NO", None: "no row"}
            cells = [
                (one["name"], held[one["held"]], "" if one["worst"] is None else one["worst"], one["unit"])
                for one in self.limits
            ]
            parts.append(markup.table("Limits", cells, ("limit", "held", "worst", "unit")))
        if told := [str(text) for text in self.warnings["warning_text"].values]:
            names = self.warnings["warning_name"].values
            parts.append(markup.table("Warnings", zip(names, told, strict=True)))
        if "run" not in self._results.sizes:
            found = self.statistics()
            shown = found[[c for c in ("channel", "unit", "mean", "minimum", "maximum") if c in found]]
            parts.append(markup.table("Columns", shown.values.tolist(), list(shown)))
        return "".join(parts)


def register(xarray: Any) -> None:
    """Make `ds.kingpost` known to xarray."""
    xarray.register_dataset_accessor("kingpost")(Accessor)


when_loaded(register)

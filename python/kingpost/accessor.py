"""`ds.kingpost`: columns, statistics and pictures of the data set of a run.

Every data set that Kingpost makes or reads has this accessor. A data set that xarray itself opens has it if
xarray was imported before Kingpost, or if `register` was called.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import markup
from .results.columns import column, columns
from .results.entries import LimitEntry, limits_of, limits_of_runs
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
        A data set of `kingpost.run`, or read from its results file.

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
        """Names of the columns; files and the app use the same names."""
        return [name for name, _ in columns(self._results, along=("time", "run"))]

    def __getitem__(self, name: str | tuple[str, ...]) -> xarray.DataArray:
        """A column over time, found by its full name or by the parts of its name.

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
            Name of the column, such as ``ship.roll``.
        period_s
            First and last time, s, both included; default: the whole run.

        Returns
        -------
        xarray.DataArray
            Along ``time`` (s), and along ``run`` for a `Batch`; its ``units`` are SI.

        Raises
        ------
        KingpostError
            If there is no such column, or no record in the period.

        >>> import kingpost
        >>> ds = kingpost.run("paper", {"simulation.duration_s": 0.5})
        >>> ds.kingpost.time_history("ship.roll", (0.2, 0.3)).sizes["time"]
        11
        """
        return column(self._results, name, period_s)

    def statistics(self, *names: str, after_s: float | None = None) -> pandas.DataFrame:
        """The table that `kingpost statistics` prints: a row for each column.

        Parameters
        ----------
        names
            Columns or patterns, such as ``ship.*``; default: the main columns.
        after_s
            Leave out the records before this time, s; default: the ramp of the waves is left out.

        Returns
        -------
        pandas.DataFrame
            ``channel``, ``unit`` (deg, kN, t) and the statistics in that unit.

        Raises
        ------
        KingpostError
            If a name matches no column, or the runs of a `Batch` differ in more than their seeds.

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
            Columns or patterns, such as ``ship.*``; default: the columns with a limit and the main columns.

        Returns
        -------
        matplotlib.figure.Figure
            A notebook shows it.

        Raises
        ------
        KingpostError
            If a name matches no column, or matches more columns than one panel can show.

        >>> import kingpost
        >>> ds = kingpost.run("paper", {"simulation.duration_s": 0.5})
        >>> [axes.get_ylabel() for axes in ds.kingpost.plot("ship.roll").axes]
        ['deg']
        """
        from .reports.plot import figure

        return figure(self._results, names)

    def range_graph(self, *lines: str, after_s: float | None = None) -> Figure:
        """A picture of the tension along lines: least, mean and largest over the arc length.

        The numbers are those of `kingpost.range_graph`.

        Parameters
        ----------
        lines
            Names of lines of the kind ``line``; default: all that have ``points_along``.
        after_s
            Leave out the records before this time, s; default: the ramp of the waves is left out.

        Returns
        -------
        matplotlib.figure.Figure
            A panel for each line; a notebook shows it.

        Raises
        ------
        KingpostError
            If there is no such line.

        >>> import kingpost
        >>> wire = {"unstretched_length_m": 210, "elements": 8, "mass_kg_per_m": 50, "diameter_m": 0.1,
        ...         "axial_stiffness_kN": 1e5}
        >>> hung = {"first": {"body": "ship", "position_m": [0, 0, 0]}, "sections": [wire],
        ...         "second": {"body": "world", "position_m": [200, 0, -20]}}
        >>> ds = kingpost.run("paper", {"forces.wire": {"line": hung}, "simulation.duration_s": 0.1})
        >>> [axes.get_ylabel() for axes in ds.kingpost.range_graph("wire").axes]
        ['wire, kN']
        """
        from .reports.range_graph import range_graph_figure

        return range_graph_figure(self._results, lines, after_s)

    @property
    def events(self) -> xarray.Dataset:
        """The events of the run, as `kingpost.results.events` gives them."""
        return events(self._results)

    @property
    def warnings(self) -> xarray.Dataset:
        """The warnings of the run, as `kingpost.results.warnings` gives them."""
        return warnings(self._results)

    @property
    def limits(self) -> list[LimitEntry] | list[list[LimitEntry]]:
        """Evaluation of the scenario's limits: ``name``, ``column``, ``unit``, ``held``, ``worst`` and the
        time of the worst value; for a `Batch`, a list for each run."""
        several = "run" in self._results.sizes
        return limits_of_runs(self._results) if several else limits_of(self._results)

    def _repr_html_(self) -> str:
        about = self._results.attrs
        time = self._results["time"].values
        rows = [("status", about.get("status", "")), ("seed", about.get("seed", "")),
                ("recorded", f"{time[0]:g} to {time[-1]:g} s, {len(time)} rows")]  # fmt: skip
        parts = [markup.figure(self._results), markup.table(str(about.get("title", "")), rows)]
        limits = [] if "run" in self._results.sizes else limits_of(self._results)
        if limits:
            held = {True: "yes", False: "NO", None: "no row"}
            cells = [
                (one["name"], held[one["held"]], "" if one["worst"] is None else one["worst"], one["unit"])
                for one in limits
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

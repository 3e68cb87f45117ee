"""Screening of a study: its limits in every case by linear response, and the limiting sea."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...results.entries import sea_attributes
from ..design.plan import Plan
from .screen import screen

if TYPE_CHECKING:
    import xarray


def of_plan(plan: Plan) -> xarray.Dataset:
    """Screen the cases of a study by linear response about rest, without time-domain runs.

    The axes are those of the study; axes that are drawn together, from a Latin hypercube or a scatter table,
    form one axis. The operation's duration and the accepted probability are those of the study.

    Parameters
    ----------
    plan
        Plan of the study.

    Returns
    -------
    xarray.Dataset
        Result of `screen`, with the name of the axis of each quantity of the sea in an attribute, such as
        ``sea_peak_period``.

    Raises
    ------
    KingpostError
        If a case has no waves, or there is no equilibrium.
    """
    content, settings = plan.file.content, plan.scenario.resolved["simulation"]
    operation_s = content.get("operation_s") or settings["duration_s"] - content["after_s"]
    found = screen(
        plan.scenario,
        _axes(plan),
        list(plan.columns),
        operation_s=operation_s,
        acceptance=content["acceptance"],
        height=plan.sea.get("significant_height"),
    )
    return found.assign_attrs(sea_attributes(plan.sea))


def _axes(plan: Plan) -> dict[str, list[object]]:
    """Values of each axis; for axes drawn together, lists of values under their names, separated by
    commas."""
    kinds = {name: next(iter(axis)) for name, axis in plan.file.content["axes"].items()}
    values = plan.cases.values
    axes: dict[str, list[object]] = {}
    for name, kind in kinds.items():
        if kind in ("values", "range"):
            axes[name] = list(dict.fromkeys(values[name]))
    for drawn in ("latin_hypercube", "scatter"):
        if names := [name for name, kind in kinds.items() if kind == drawn]:
            together = zip(*(values[name] for name in names), strict=True)
            axes[",".join(names)] = [list(one) for one in dict.fromkeys(together)]
    return axes

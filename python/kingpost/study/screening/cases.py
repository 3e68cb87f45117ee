"""The screen of a study: its limits in every case by linear response, and the limiting sea."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...results import entries
from ..design.plan import Plan
from .screen import screen

if TYPE_CHECKING:
    import xarray


def of_plan(plan: Plan) -> xarray.Dataset:
    """The cases of a study by linear response about rest, without a run.

    The axes are those of the study; axes that are drawn together, of a Latin hypercube or of a scatter table,
    are one. The operation's length and the accepted probability are the study's.

    Parameters
    ----------
    plan
        Of the study.

    Returns
    -------
    xarray.Dataset
        That of `screen`, with the attribute ``sea`` that says which axis is which quantity of the sea.

    Raises
    ------
    KingpostError
        When a case has no waves, or nothing comes to rest.
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
    entries.write(found.attrs, sea=plan.sea)
    return found


def _axes(plan: Plan) -> dict[str, list[object]]:
    """The values of each axis; of those drawn together lists of values, under their names with commas."""
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

"""The operable share of a study's scatter table."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from ...results.entries import sea_of
from ..design.plan import Plan
from ..sea_states import scatter
from .operability import Operability, operability
from .sea import LimitingSea

if TYPE_CHECKING:
    import xarray


def of_plan(plan: Plan, found: xarray.Dataset) -> Iterator[tuple[str, Operability]]:
    """Compute the operable share for the scatter table of a study; empty without a scatter table or an axis
    of the period. A table without directions is counted once for each studied direction, as if all waves had
    this direction; the text then names the direction, otherwise it is empty.

    Parameters
    ----------
    plan
        Plan of the study.
    found
        Limiting heights, by runs or by linear response.
    """
    name = plan.file.content.get("scatter")
    sea = sea_of(found)
    if not name or sea.get("peak_period") not in found["limiting_height"].dims:
        return
    table = scatter.read(plan.file.beside(name))
    limiting, direction = LimitingSea.of(found), sea.get("direction")
    if table.direction_rad is not None or direction not in found["limiting_height"].dims:
        yield "", operability(table, limiting, 0.0)
        return
    values = np.sort(found[direction].values)
    for radians, value in zip(limiting.directions_rad.tolist(), values, strict=True):
        yield f"{direction} {value:g}", operability(table, limiting, radians)

"""Limiting sea by linear response, only at the periods and directions of a series."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ...errors import KingpostError, ScenarioError
from ...scenario import Scenario
from ..sea_states.quantities import QUANTITIES, quantities

if TYPE_CHECKING:
    from numpy.typing import NDArray

REFUSED = "not in the scenario"
"""Reason for a missing height: the scenario refuses the sea, or the sea was not given."""
DIGITS = 3
"""Decimal places of periods, s, and directions, deg, by which seas are distinguished."""


def sea_names(scenario: Scenario) -> dict[str, str]:
    """Find the parameters of a scenario that set height, peak period and direction of its waves.

    >>> from kingpost import load
    >>> sea_names(load("offshore_vessel"))["peak_period"]
    'peak_period_s'
    """
    parameters = scenario.resolved.get("parameters", [])
    return quantities({one["name"]: one.get("writes", []) for one in parameters})


@dataclass(frozen=True)
class ScreenedSea:
    """Limiting heights at given seas; called with peak period (s) and direction (rad).

    Attributes
    ----------
    known
        Limiting height and governing limit by period, s, and direction, deg.
    refused
        Reason why the scenario refuses some of the seas; empty if it accepts all.
    """

    known: dict[tuple[float, float], tuple[float, str]]
    refused: str

    def __call__(self, peak_period_s: float, direction_rad: float) -> tuple[float, str]:
        return self.known.get(_key(peak_period_s, float(np.degrees(direction_rad))), (np.nan, REFUSED))


def of_screen(
    scenario: Scenario,
    periods_s: NDArray[np.float64],
    directions_rad: NDArray[np.float64],
    operation_s: float,
    acceptance: float,
    names: dict[str, str] | None = None,
) -> ScreenedSea:
    """Compute limiting heights by linear response at given peak periods and directions.

    Parameters
    ----------
    scenario
        Scenario with waves and limits.
    periods_s, directions_rad
        Peak period and direction of each sea; seas with a NaN are left out.
    operation_s
        Duration of the operation, s.
    acceptance
        Accepted probability that a limit is exceeded in the operation.
    names
        Parameters of the scenario by ``significant_height``, ``peak_period``, ``direction``; default: result
        of `sea_names`.

    Returns
    -------
    ScreenedSea
        Function of period and direction that returns the height and the governing limit. The height is
        unknown for seas that were not given or that the scenario refuses, for example because its hull's data
        do not cover their frequencies.

    Raises
    ------
    KingpostError
        If the scenario has no such parameters or no limits, or refuses all seas.
    """
    from .screen import screen

    sea = sea_names(scenario) | (names or {})
    for quantity in QUANTITIES:
        if quantity not in sea:
            allowed = f"a parameter that writes the {quantity.replace('_', ' ')} of the waves"
            raise KingpostError(f"{scenario.title}: found no parameter of it, allowed: {allowed}")
    if not scenario.resolved.get("limits"):
        raise KingpostError(f"{scenario.title}: limits: found none, allowed: one or more")
    asked = zip(periods_s.tolist(), np.degrees(directions_rad).tolist(), strict=True)
    seas = list(dict.fromkeys(_key(*one) for one in asked if np.isfinite(one).all()))
    if not seas:
        raise KingpostError("series: found no sea with a period and a direction, allowed: one or more")
    refused = _refused(scenario, sea["peak_period"], [period for period, _ in seas])
    kept = [one for one in seas if one[0] not in refused]
    if not kept:
        raise next(iter(refused.values()))
    height, drawn = sea["significant_height"], f"{sea['peak_period']},{sea['direction']}"
    axes: dict[str, list[object]] = {height: [1.0], drawn: [list(one) for one in kept]}
    found = screen(scenario, axes, operation_s=operation_s, acceptance=acceptance, height=height)
    heights = found["limiting_height_of_all"].values.ravel().tolist()
    governs = found["governs"].values.ravel().tolist()
    known = dict(zip(kept, zip(heights, governs, strict=True), strict=True))
    return ScreenedSea(known, _in_words(refused))


def _refused(scenario: Scenario, name: str, periods: list[float]) -> dict[float, ScenarioError]:
    """Periods that the scenario refuses, with the error of each."""
    found = {}
    for period in dict.fromkeys(periods):
        try:
            scenario.with_overrides({name: period})
        except ScenarioError as error:
            found[period] = error
    return found


def _in_words(refused: dict[float, ScenarioError]) -> str:
    if not refused:
        return ""
    return f"Tp from {min(refused):g} to {max(refused):g} s: {refused[min(refused)]}"


def _key(period_s: float, direction_deg: float) -> tuple[float, float]:
    # From -180 to 180 deg, the range of the parameters.
    return round(period_s, DIGITS), round((direction_deg + 180) % 360 - 180, DIGITS) or 0.0

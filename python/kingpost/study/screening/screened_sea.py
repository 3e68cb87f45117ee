"""The limiting sea by the screen, at the periods and directions of a series alone."""

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
"""Where there is no height: the scenario cannot have the sea, or it was not asked for."""
DIGITS = 3
"""Decimal places of periods, s, and directions, deg, by which seas are told apart."""


def sea_names(scenario: Scenario) -> dict[str, str]:
    """The parameters of a scenario that write height, peak period and direction of its waves.

    >>> from kingpost import load
    >>> sea_names(load("offshore_vessel"))["peak_period"]
    'peak_period_s'
    """
    parameters = scenario.resolved.get("parameters", [])
    return quantities({one["name"]: one.get("writes", []) for one in parameters})


@dataclass(frozen=True)
class ScreenedSea:
    """Limiting heights at the seas that were asked for, called with peak period (s) and direction (rad).

    Attributes
    ----------
    known
        By period, s, and direction, deg.
    refused
        Why the scenario cannot have some of the seas; empty where it can have all.
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
    """Limiting heights by linear response at given peak periods and directions.

    Parameters
    ----------
    scenario
        With waves and limits.
    periods_s, directions_rad
        Of each sea; those with a NaN are left out.
    operation_s
        How long the operation lasts, s.
    acceptance
        Probability that a limit may be exceeded in it.
    names
        Parameters of the scenario, by ``significant_height``, ``peak_period``, ``direction``; as `sea_names`
        finds them unless given.

    Returns
    -------
    ScreenedSea
        Called with a period and a direction it gives the height and the limit. Seas that were not given are
        not known, nor are those that the scenario cannot have: its hull's data may not cover their
        frequencies.

    Raises
    ------
    KingpostError
        When the scenario has no such parameters, no limits, or can have none of the seas.
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
    """Periods that the scenario cannot have, with what it says of them."""
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
    # From -180 to 180, which parameters have.
    return round(period_s, DIGITS), round((direction_deg + 180) % 360 - 180, DIGITS) or 0.0

"""The limiting sea by the screen, at the periods and directions of a series alone."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..errors import KingpostError
from ..scenario import Scenario
from .limiting_sea import OUTSIDE, LimitingHeight

if TYPE_CHECKING:
    from numpy.typing import NDArray

SEA = {
    "significant_height": "significant_height_m",
    "peak_period": "peak_period_s",
    "direction": "direction_",
}
"""How the last name of a field begins that has a quantity of the sea."""
DIGITS = 3
"""Of periods, s, and directions, deg, by which seas are told apart."""


def sea_names(scenario: Scenario) -> dict[str, str]:
    """The parameters of a scenario that write height, peak period and direction of its waves.

    >>> from kingpost import load
    >>> sea_names(load("offshore_vessel"))["peak_period"]
    'peak_period_s'
    """
    found: dict[str, str] = {}
    for parameter in scenario.resolved.get("parameters", []):
        for path in parameter.get("writes", []):
            for quantity, beginning in SEA.items():
                if path.startswith("sea.") and path.rpartition(".")[2].startswith(beginning):
                    found.setdefault(quantity, parameter["name"])
    return found


def of_screen(
    scenario: Scenario,
    periods_s: NDArray[np.float64],
    directions_rad: NDArray[np.float64],
    operation_s: float,
    acceptance: float,
    names: dict[str, str] | None = None,
) -> LimitingHeight:
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
        Parameters of the scenario, by ``significant_height``, ``peak_period``, ``direction``; as
        `sea_names` finds them unless given.

    Returns
    -------
    callable
        By peak period and direction the height and the limit; other seas than the given are not known.

    Raises
    ------
    KingpostError
        When the scenario has no such parameters, or nothing of it is linear.
    """
    from .screen import screen

    sea = sea_names(scenario) | (names or {})
    for quantity in SEA:
        if quantity not in sea:
            allowed = f"a parameter that writes the {quantity.replace('_', ' ')} of the waves"
            raise KingpostError(f"{scenario.title}: found no parameter of it, allowed: {allowed}")
    asked = zip(periods_s.tolist(), np.degrees(directions_rad).tolist(), strict=True)
    seas = list(dict.fromkeys(_key(*one) for one in asked if np.isfinite(one).all()))
    if not seas:
        raise KingpostError("series: found no sea with a period and a direction, allowed: one or more")
    drawn = f"{sea['peak_period']},{sea['direction']}"
    axes = {sea["significant_height"]: [1.0], drawn: [list(one) for one in seas]}
    found = screen(
        scenario, axes, operation_s=operation_s, acceptance=acceptance, height=sea["significant_height"]
    )
    heights = found["limiting_height_of_all"].values.ravel()
    governs = found["governs"].values.ravel()
    known = {
        one: (float(height), str(name)) for one, height, name in zip(seas, heights, governs, strict=True)
    }

    def limiting_height(peak_period_s: float, direction_rad: float) -> tuple[float, str]:
        return known.get(_key(peak_period_s, float(np.degrees(direction_rad))), (np.nan, OUTSIDE))

    return limiting_height


def _key(period_s: float, direction_deg: float) -> tuple[float, float]:
    # From -180 to 180, which parameters have.
    return round(period_s, DIGITS), round((direction_deg + 180) % 360 - 180, DIGITS) or 0.0

"""Standard seas of compensations, and evaluation of runs after the start-up, common to all controllers."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import xarray

from ...errors import KingpostWarning
from ...simulation.simulate import run

LENGTH_S = 250.0
SEAS: dict[str, dict[str, Any]] = {
    "Hs 2.5 m, Tp 8 s": {"significant_height_m": 2.5, "peak_period_s": 8},
    "Hs 2.0 m, Tp 10 s": {"significant_height_m": 2.0, "peak_period_s": 10},
    "Hs 3.0 m, Tp 12 s": {"significant_height_m": 3.0, "peak_period_s": 12},
}
"""JONSWAP, gamma 1."""

LONGEST = 1.75
"""Longest period of the prediction over the peak period, which an operator knows."""

SETTLED_S = 100.0
"""Start-up time, s: the ramp of the sea and the slow transients of ship, sensor and prediction have then
ended."""

UNIT = "sensors.mru.motion_reference_unit"
"""The motion reference unit of the scenarios of compensations."""

INERTIAL = "sensors.inertial.inertial_unit"
"""The inertial unit of the scenario of heave compensation."""

AT_A_LIMIT = "at a limit"
"""Verdict on a run whose drive exceeds a limit; the command then fails."""


@dataclass(frozen=True)
class Settled:
    """The results of a run from `SETTLED_S` on."""

    results: xarray.Dataset

    def column(self, name: str) -> np.ndarray:
        """Return a column by its name."""
        return np.asarray(self.results.kingpost[name].values)

    def largest_share(self, drives: Sequence[str], limit: str) -> float:
        """Largest share of the drives' limits of speed, effort or power."""
        shares = (self.column(f"{drive}.drive_{limit}_utilisation") for drive in drives)
        return max(float(np.abs(share).max()) for share in shares)

    def driving_kw(self, drives: Sequence[str]) -> float:
        """Mean power while the drives deliver power, kW."""
        powers = (np.maximum(self.column(f"{drive}.drive_power"), 0.0).mean() for drive in drives)
        return float(sum(powers)) / 1e3


def in_sea(controller: str, sea: str, control: dict[str, Any]) -> dict[str, Any]:
    """Return the overrides for a run in a standard sea, with the prediction's band unless `control` sets it.

    >>> list(in_sea("controllers.c", "Hs 2.0 m, Tp 10 s", {"controllers.c.prediction": None}))
    ['significant_height_m', 'peak_period_s', 'controllers.c.prediction']
    """
    prediction = f"{controller}.prediction"
    band = {f"{prediction}.longest_period_s": LONGEST * SEAS[sea]["peak_period_s"]}
    return SEAS[sea] | control | ({} if prediction in control else band)


def settled(scenario: str, given: dict[str, Any], length_s: float) -> Settled:
    """Run a scenario of the gallery; in a short run the second half counts."""
    with warnings.catch_warnings(action="ignore", category=KingpostWarning):
        # Ignore warnings of submerged decks and of stops in the higher seas: the tables show the result.
        found = run(scenario, given | {"simulation.duration_s": length_s})
    return Settled(found.sel(time=slice(min(SETTLED_S, 0.5 * length_s), None)))


RECEIVER = {
    "body": "hull",
    "position_m": [-5, 0, 30],
    "period_s": 0.1,
    "delay_samples": 1,
    "vertical_errors": {"noise_m": 0.02, "resolution_m": 0.001},
}
"""A satellite receiver: noise of 2 cm at 10 Hz, 0.1 s of delay."""


def with_satellites(controller: str) -> dict[str, Any]:
    """Return overrides that add a satellite receiver to the unit, and extend the controller's prediction to
    short waves.

    >>> list(with_satellites("controllers.c"))[-1]
    'controllers.c.prediction.shortest_period_s'
    """
    satellites = {"sensors.satellites": {"satellite_receiver": RECEIVER}}
    return satellites | {f"{UNIT}.heave_filter.receiver": "satellites"} | short_waves(controller)


def with_inertial_unit(controller: str, *, satellites: bool = False) -> dict[str, Any]:
    """Return overrides to measure by the inertial unit, optionally with a satellite receiver.

    >>> list(with_inertial_unit("controllers.c"))
    ['controllers.c.sensor', 'controllers.c.prediction.shortest_period_s']
    """
    alone = {f"{controller}.sensor": "inertial"} | short_waves(controller)
    receiver = {"sensors.satellites": {"satellite_receiver": RECEIVER}, f"{INERTIAL}.receiver": "satellites"}
    return alone | (receiver if satellites else {})


def short_waves(controller: str) -> dict[str, Any]:
    """Return overrides for a prediction down to 3 s, possible with sensors without a high-pass filter.

    A rope of 1,000 m with its load has a period of 3 to 4 s, which waves of 8 s still reach.

    >>> short_waves("controllers.c")
    {'controllers.c.prediction.shortest_period_s': 3}
    """
    return {f"{controller}.prediction.shortest_period_s": 3}


def judged(ends: dict[str, float], allowed: float | None, utilisation: dict[str, float]) -> str:
    """Verdict on residuals, %, at the ends of a rope, and on the largest shares of the drive's limits.

    >>> judged({"winch": 1.5, "hook": 2.5}, 2.0, {"speed": 0.4})
    'misses at hook by 0.5 %'
    >>> judged({"winch": 1.5, "hook": 1.5}, 2.0, {"speed": 0.4}), judged({}, None, {"speed": 1.1})
    ('reached', 'at a limit')
    """
    if utilisation and max(utilisation.values()) > 1.0:
        return AT_A_LIMIT
    if allowed is None:
        return "-"
    missed = [f"{end} by {found - allowed:.1f} %" for end, found in ends.items() if found > allowed]
    return "misses at " + ", ".join(missed) if missed else "reached"

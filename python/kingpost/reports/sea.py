"""Report of the sea, the current and the wind of a scenario."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from .tables import table

if TYPE_CHECKING:
    from ..scenario import Scenario

UNITS = {"m": "m", "s": "s", "rad": "deg", "Hz": "Hz", "m_s": "m/s", "rad_s": "rad/s", "kg_m3": "kg/m3"}
"""Printed unit by the suffix of a field's name; the longest matching suffix counts."""


def lines(scenario: Scenario) -> list[str]:
    """The water, each wave system, the current and the wind, with the energy that is cut off the spectra;
    empty if there is neither water nor wind."""
    rows = [("sea and wind", "", "", "")]
    sea, wind = scenario.resolved.get("sea"), scenario.resolved.get("wind")
    if sea:
        water = ", ".join(_water(scenario.model["sea"], sea.get("stretching", "vertical")))
        rows.append(("water", "", "", water))
        for name, of_kind in (sea.get("waves") or {}).items():
            for kind, given in of_kind.items():
                rows.append((name, kind, _on(given), ", ".join(facts(given))))
        rows += _current(sea)
    if wind:
        rows.append(("wind", "", _on(wind), ", ".join(facts(wind))))
    return [*(table(rows, "<<<<") if len(rows) > 1 else []), *_cut(scenario.model["sea"])]


def facts(given: dict[str, Any]) -> Iterator[str]:
    """Format the numbers and texts among fields, in engineering units; nested tables are left out.

    >>> list(facts({"enabled": True, "significant_height_m": 2.5, "direction_rad": math.pi}))
    ['significant height 2.5 m', 'direction 180 deg']
    """
    for name, value in given.items():
        if name == "enabled" or isinstance(value, dict | list) or value is None:
            continue
        ending = max((end for end in UNITS if name.endswith(f"_{end}")), key=len, default="")
        words = name.removesuffix(f"_{ending}").replace("_", " ")
        if isinstance(value, float | int) and not isinstance(value, bool):
            value = f"{math.degrees(value) if ending == 'rad' else value:.6g}"
        yield f"{words} {value} {UNITS.get(ending, '')}".rstrip()


def _water(described: dict[str, Any], stretching: str) -> Iterator[str]:
    yield f"density {described['density_kg_m3']:g} kg/m3"
    yield "deep" if described["depth_m"] is None else f"depth {described['depth_m']:g} m"
    if not described["wave_components"]:
        yield "level: no waves act"
    else:
        yield f"stretching of the waves {stretching}"


def _current(sea: dict[str, Any]) -> list[tuple[str, str, str, str]]:
    x, y = sea.get("current_m_s") or (0.0, 0.0)
    speed = math.hypot(x, y)
    if not speed:
        return []
    to = f"speed {speed:.4g} m/s, to {math.degrees(math.atan2(y, x)):.4g} deg"
    return [("current", str(sea.get("current_profile", "")), "on", to)]


def _on(given: dict[str, Any]) -> str:
    return "on" if given.get("enabled", True) else "off"


def _cut(sea: dict[str, Any] | None) -> list[str]:
    """Report a line for each spectrum that is partly cut off: the lost energy, and Hs with and without."""
    found = []
    for cut in sea["cut_spectra"] if sea else []:
        whole, kept = cut["significant_height_m"], 1 - cut["energy_cut_off"]
        found.append(
            f"{cut['name']}: {100 * cut['energy_cut_off']:.2g} % of the spectrum's energy is cut off: "
            f"Hs {whole * kept**0.5:.4g} m of {whole:.4g} m"
        )
    return found

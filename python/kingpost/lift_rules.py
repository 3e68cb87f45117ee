"""What standards ask of a crane that lifts from another vessel, to stand beside what a run finds.

The formulas are those of EN 13852-1, *Offshore cranes: general-purpose offshore cranes*, annex B, for lifts
from a supply vessel, as public calculations of others quote them (C. Kunte, ``ckunte/m-one``, file
``inc/crane.typ``; C. Kunte, *Crane*, 2016). The standard's own text was not at hand: check them against it
before a lift rests on them. Its table of the crane tip's speeds was not found; that speed is yours to give.
"""

from __future__ import annotations

import math

from .errors import KingpostError

# K_H at the rated capacity, by whether the hook hangs on one fall or on several.
SINGLE_FALL = 0.50
SEVERAL_FALLS = 0.28


def deck_speed_m_s(significant_height_m: float) -> float:
    """V_D = 6 Hs / (Hs + 8): speed of the deck of a supply vessel, m/s.

    Raises
    ------
    KingpostError
        When the wave height is negative or no number.

    >>> round(deck_speed_m_s(2.7), 3)
    1.514
    """
    height = _not_negative("significant_height_m", significant_height_m)
    return 6.0 * height / (height + 8.0)


def hoisting_speed_m_s(
    significant_height_m: float, tip_speed_m_s: float = 0.0, factor: float = SINGLE_FALL
) -> float:
    """V_H = K_H sqrt(V_D^2 + V_C^2): the least speed of the hook at the rated capacity, m/s.

    Parameters
    ----------
    significant_height_m
        Hs of the waves, m.
    tip_speed_m_s
        V_C, vertical speed of the crane's tip, m/s; 0 for a crane on a fixed platform.
    factor
        K_H: `SINGLE_FALL` or `SEVERAL_FALLS`.

    Raises
    ------
    KingpostError
        When a number is negative or none.

    >>> [round(hoisting_speed_m_s(height), 3) for height in (1.4, 2.7, 3.6)]
    [0.447, 0.757, 0.931]
    """
    tip, factor = _not_negative("tip_speed_m_s", tip_speed_m_s), _not_negative("factor", factor)
    return factor * math.hypot(deck_speed_m_s(significant_height_m), tip)


def offlead_m(significant_height_m: float) -> float:
    """2.5 m + 1.5 Hs: how far the hook may be off the tip in the plane of the boom, m, when it lifts.

    Raises
    ------
    KingpostError
        When the wave height is negative or no number.

    >>> offlead_m(1.0)
    4.0
    """
    return 2.5 + 1.5 * _not_negative("significant_height_m", significant_height_m)


def sidelead_m(significant_height_m: float) -> float:
    """Half of the offlead, m: across the plane of the boom.

    >>> sidelead_m(1.0)
    2.0
    """
    return 0.5 * offlead_m(significant_height_m)


def _not_negative(name: str, value: float) -> float:
    if not (math.isfinite(value) and value >= 0.0):
        raise KingpostError(f"{name}: found {value}, allowed: a number not less than 0")
    return float(value)

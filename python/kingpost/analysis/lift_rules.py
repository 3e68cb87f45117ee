"""Requirements of standards for lifts, to compare with a run: hook speed, offlead and sidelead for a lift
from another vessel, and the ship's stability after a loss of hook load.

The formulas for the hook are those of EN 13852-1, *Offshore cranes: general-purpose offshore cranes*, annex
B,
for lifts from a supply vessel, as quoted in public calculations (C. Kunte, ``ckunte/m-one``, file
``inc/crane.typ``; C. Kunte, *Crane*, 2016). The text of the standard was not available: check the formulas
against it before you rely on them. Its table of crane tip speeds was not found; give that speed yourself.

The areas under the righting arms are those of the International Code on Intact Stability, 2008, part B,
section
2.9.5 (resolution MSC.415(97), 2016), for ships whose keel was laid from 2020 on. The text and the figure of
that section were not available either: check them too.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..errors import KingpostError
from ..given import not_negative
from ..scenario import Scenario

# K_H at the rated capacity, for a hook on one fall and on several falls.
SINGLE_FALL = 0.50
SEVERAL_FALLS = 0.28


def deck_speed_m_s(significant_height_m: float) -> float:
    """V_D = 6 Hs / (Hs + 8): speed of the deck of a supply vessel, m/s.

    Parameters
    ----------
    significant_height_m
        Hs of the waves, m.

    Returns
    -------
    float
        m/s.

    Raises
    ------
    KingpostError
        When the wave height is negative or NaN.

    >>> round(deck_speed_m_s(2.7), 3)
    1.514
    """
    height = not_negative("significant_height_m", significant_height_m)
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

    Returns
    -------
    float
        m/s.

    Raises
    ------
    KingpostError
        If a number is negative or NaN.

    >>> [round(hoisting_speed_m_s(height), 3) for height in (1.4, 2.7, 3.6)]
    [0.447, 0.757, 0.931]
    """
    tip, factor = not_negative("tip_speed_m_s", tip_speed_m_s), not_negative("factor", factor)
    return factor * math.hypot(deck_speed_m_s(significant_height_m), tip)


def offlead_m(significant_height_m: float) -> float:
    """2.5 m + 1.5 Hs: allowed offlead, the distance of the hook from the tip in the plane of the boom, m, at
    lift-off.

    Parameters
    ----------
    significant_height_m
        Hs of the waves, m.

    Returns
    -------
    float
        m.

    Raises
    ------
    KingpostError
        When the wave height is negative or NaN.

    >>> offlead_m(1.0)
    4.0
    """
    return 2.5 + 1.5 * not_negative("significant_height_m", significant_height_m)


def sidelead_m(significant_height_m: float) -> float:
    """Allowed sidelead, half of the offlead, m: across the plane of the boom.

    Parameters
    ----------
    significant_height_m
        Hs of the waves, m.

    Returns
    -------
    float
        m.

    Raises
    ------
    KingpostError
        When the wave height is negative or NaN.

    >>> sidelead_m(1.0)
    2.0
    """
    return 0.5 * offlead_m(significant_height_m)


# Required ratio of area 2 to area 1, in exposed and in unexposed waters.
EXPOSED_WATERS = 1.4
UNEXPOSED_WATERS = 1.0


@dataclass(frozen=True)
class HookLoadLoss:
    """The areas under the righting arms of a ship after a loss of hook load.

    She rolls to `side`. Area 1 drives her from `heel_before_deg`, her heel with the load, to
    `heel_after_deg`, her new equilibrium. Area 2 stops her, from there to `end_deg`: where her arm vanishes,
    water enters, or the curve ends at 60 degrees.
    Heel counts towards `side`.
    """

    side: str
    heel_before_deg: float
    heel_after_deg: float
    end_deg: float
    area_1_m_rad: float
    area_2_m_rad: float
    required: float

    @property
    def held(self) -> bool:
        """Whether area 2 exceeds area 1 times the required factor."""
        return self.area_2_m_rad > self.required * self.area_1_m_rad


def hook_load_loss(
    before: Scenario,
    after: Scenario,
    *,
    body: str | None = None,
    flooding_deg: float = 90.0,
    required: float = EXPOSED_WATERS,
) -> HookLoadLoss:
    """Check whether a ship survives a loss of hook load, by her righting arms: area 2 > 1.4 area 1.

    The arms on the side of the load follow from the symmetry of the hull: with GZ the arms to one side and a
    the arm at zero heel, ``GZ(-phi) = 2 a cos(phi) - GZ(phi)``. Areas are sums of trapezia of 5 degrees.

    Parameters
    ----------
    before
        The ship with the load on her hook.
    after
        The ship without the load, with the same counter ballast.
    body
        The hull's body; required if there are several.
    flooding_deg
        Heel at which water enters, deg.
    required
        Required ratio of area 2 to area 1: `EXPOSED_WATERS` or `UNEXPOSED_WATERS`.

    Returns
    -------
    HookLoadLoss
        Both areas, m rad, with the heels that bound them.

    Raises
    ------
    KingpostError
        If there is no such hull, it has no mesh, or the ship has no equilibrium at any heel.

    >>> from kingpost import load
    >>> before = load("loss_of_hook_load")
    >>> after = before.with_overrides({"bodies.lift.enabled": False, "operation.enabled": False})
    >>> found = hook_load_loss(before, after)
    >>> found.side, found.held
    ('starboard', True)
    """
    rest, heel, arm = _righting_arms(after, body)
    start, *_ = _righting_arms(before, body)
    way = 1.0 if rest >= start else -1.0
    rest, start = way * rest, way * start
    heel, arm = (way * one[:: int(way)] for one in (heel, arm))
    stop = min(_vanishing(heel, arm, rest), math.radians(not_negative("flooding_deg", flooding_deg)))
    return HookLoadLoss(
        "starboard" if way > 0.0 else "port",
        math.degrees(start),
        math.degrees(rest),
        math.degrees(stop),
        max(-_area(heel, arm, start, rest), 0.0),
        max(_area(heel, arm, rest, stop), 0.0),
        not_negative("required", required),
    )


def _hull(scenario: Scenario, body: str | None) -> dict[str, Any]:
    """The hull of a body, or the only one."""
    hulls = scenario.hydrostatics["hulls"]
    found = [hull for hull in hulls if body in (None, hull["body"])]
    if len(found) != 1:
        names = ", ".join(hull["body"] for hull in hulls) or "none in this scenario"
        raise KingpostError(f"body: found {body}, allowed: a hull in the water, {names}")
    return found[0]


def _righting_arms(scenario: Scenario, body: str | None) -> tuple[float, np.ndarray, np.ndarray]:
    """Heel at rest, heel and arms of a hull to both sides, rad and m, positive to starboard."""
    hull = _hull(scenario, body)
    curve = hull["righting_arm"]
    if curve is None:
        found = "found no mesh in its database, allowed: a mesh"
        raise KingpostError(f"righting arms of {hull['body']}: {found}")
    if curve["equilibrium_rad"] is None:
        found = "found no zero with a positive slope, allowed: a heel at equilibrium"
        raise KingpostError(f"righting arms of {hull['body']}: {found}")
    heel, arm = (np.array([point[name] for point in curve["points"]]) for name in ("heel_rad", "arm_m"))
    mirrored = 2.0 * arm[0] * np.cos(heel[:0:-1]) - arm[:0:-1]
    heel, arm = np.concatenate([-heel[:0:-1], heel]), np.concatenate([mirrored, arm])
    if curve["side"] == "port":
        return -curve["equilibrium_rad"], -heel[::-1], -arm[::-1]
    return curve["equilibrium_rad"], heel, arm


def _vanishing(heel: np.ndarray, arm: np.ndarray, rest: float) -> float:
    """The heel beyond equilibrium at which the arms fall through 0, or the last heel."""
    beyond = np.flatnonzero((heel[1:] > rest) & (arm[:-1] > 0.0) & (arm[1:] <= 0.0))
    if beyond.size == 0:
        return float(heel[-1])
    k = beyond[0]
    return float(heel[k] + (heel[k + 1] - heel[k]) * arm[k] / (arm[k] - arm[k + 1]))


def _area(heel: np.ndarray, arm: np.ndarray, start: float, end: float) -> float:
    """Area under the arms from one heel to another, m rad."""
    if end <= start:
        return 0.0
    at = np.unique([start, *heel[(heel > start) & (heel < end)], end])
    return float(np.trapezoid(np.interp(at, heel, arm), at))

"""Controllers and devices that are swept over the significant height, with their limits."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...scenario import load
from . import heave, platform, roll, three_axis
from .standard import LENGTH_S, LONGEST

HEIGHTS_M = (1.0, 2.0, 3.0, 4.0, 5.0, 6.0)
PEAK_PERIOD_S = 8.0
SLOW_WINCH_RAD_S = 1.0
"""Speed limit of the slow winch: a quarter of the scenario's limit, which is not reached at 6 m and 8 s."""

Limits = dict[str, tuple[float, float]]


@dataclass(frozen=True)
class Sweep:
    """A sweep of a controller or device in its scenario over the significant height."""

    scenario: str
    height: str
    """Field of the significant height."""
    without: tuple[tuple[str, Any], ...]
    """Overrides that switch the controller or device off."""
    moves: tuple[str, ...]
    """Columns of the motion, whose root of the sum of variances is measured."""
    limits: Callable[[], Limits]
    """Columns of limits, each with the lower and upper value at which its limit is reached."""
    unit: str = "m"
    factor: float = 1.0
    """Factor from SI to the unit of the motion."""
    given: tuple[tuple[str, Any], ...] = ()
    length_s: float = LENGTH_S
    heights_m: tuple[float, ...] = HEIGHTS_M


def _drives(*names: str) -> Callable[[], Limits]:
    """Required speed of a compensation, and speed, effort and power of its drives, over their limits."""
    columns = [
        "compensation.compensation_utilisation",
        *(f"{name}.drive_effort_utilisation" for name in names),
    ]
    return lambda: dict.fromkeys(columns, (-1.0, 1.0))


def _tank() -> Limits:
    """The levels at the ends of their columns."""
    tank = load("roll_reduction_tank").resolved["forces"]["tank"]["u_tank"]
    room = tank["duct_height_m"] / 2, tank["column_height_m"]
    return {f"tank.level_{side}": room for side in ("port", "starboard")}


def _flooded() -> Limits:
    """The levels at the openings and at the tops, and the pumps at their flows."""
    tank = load("roll_reduction_flooded_tanks").resolved["forces"]["tank_port"]["free_flooding_tank"]
    flow = tank["air_pump"]["flow_limit_m3_s"]
    sides = ("port", "starboard")
    levels = {f"tank_{side}.water_level": (0.0, tank["height_m"]) for side in sides}
    return levels | {f"tank_{side}.air_flow": (-flow, flow) for side in sides}


def _gyros(driven: bool = False) -> Limits:
    """The gimbals at their stops, and the drives at their torques."""
    bodies = load("roll_reduction_gyros").resolved["bodies"]
    sides = ("port", "starboard")
    stops = {side: bodies[f"gimbal_{side}"]["joint"]["revolute"]["limits"] for side in sides}
    found = {
        f"precession_{side}.joint_position": (one["lower_rad"], one["upper_rad"])
        for side, one in stops.items()
    }
    levers = {f"precession.push_{side}.commanded_lever": (-1.0, 1.0) for side in sides}
    return found | (levers if driven else {})


WIND_SEA = "sea.waves.wind_sea.jonswap.significant_height_m"
SWELL = "sea.waves.swell.jonswap.significant_height_m"
OFF = (("compensation", False),)
TIP = ("boom.tip.point_position.x", "boom.tip.point_position.y", "lift.hook.point_position.z")
DEGREES = {"unit": "deg", "factor": float(np.degrees(1.0))}


def _compensation(module: Any, moves: tuple[str, ...], given: dict[str, Any], **more: Any) -> Sweep:
    longest = LONGEST * given.get("peak_period_s", PEAK_PERIOD_S)
    band = {f"{module.CONTROLLER}.prediction.longest_period_s": longest}
    everything = tuple(({"peak_period_s": PEAK_PERIOD_S} | band | given).items())
    return Sweep(module.SCENARIO, WIND_SEA, OFF, moves, _drives(*module.DRIVES), given=everything, **more)


def _roll(device: str, limits: Callable[[], Limits]) -> Sweep:
    case = roll.DEVICES[device]
    without = tuple(roll.DEVICES[case.without].given.items()) if case.without else ()
    given = tuple(case.given.items())
    return Sweep(
        case.scenario, SWELL, without, ("hull.roll",), limits, given=given, length_s=roll.LENGTH_S, **DEGREES
    )


HALF_PLATFORM = {
    "drives.rising.linear_controlled_drive.speed_limit_m_s": 0.75,
    "drives.rolling.controlled_drive.speed_limit_rad_s": 0.1,
    "drives.pitching.controlled_drive.speed_limit_rad_s": 0.1,
}
"""Half of the scenario's speed limits, which are not reached at 6 m and 8 s."""
SLOW_WINCH = {"drives.hoist.controlled_drive.speed_limit_rad_s": SLOW_WINCH_RAD_S}
LONG_WAVES = {"peak_period_s": 12.0, "wave_direction_deg": 110.0}

SWEEPS: dict[str, Sweep] = {
    "heave, winch at 1 rad/s": _compensation(heave, ("compensation.compensation_residual",), SLOW_WINCH),
    "three axes": _compensation(three_axis, TIP, {}),
    "three axes, Tp 12 s, 70 deg off the bow": _compensation(
        three_axis, TIP, LONG_WAVES, heights_m=HEIGHTS_M[:-1]
    ),
    "platform at half speed: tilt": _compensation(
        platform,
        ("compensation.platform_offset.x", "compensation.platform_offset.y"),
        HALF_PLATFORM,
        **DEGREES,
    ),
    "platform at half speed: height": _compensation(
        platform, ("compensation.platform_offset.z",), HALF_PLATFORM
    ),
    "U-tank, Tp 11.5 s": _roll("U-tank", _tank),
    "open tanks, pumped, Tp 11.5 s": _roll("open tanks, pumped", _flooded),
    "gyros, dampers, Tp 11.5 s": _roll("gyros, dampers", _gyros),
    "gyros, driven, Tp 11.5 s": _roll("gyros, driven", lambda: _gyros(driven=True)),
}
"""Compensations with the sensor of their scenario, at Tp 8 s unless stated; anti-roll devices in beam seas at
the ship's natural roll period. In the third sweep the uncompensated ship heels so far at 6 m that its motion
is not a useful reference."""

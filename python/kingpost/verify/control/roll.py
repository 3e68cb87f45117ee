"""Performance of roll reduction in beam seas, with and without control: a U-tank, tanks open to the sea, and
two gyros. Each is measured on its scenario of the gallery. The comparison has the same mass, with the liquid
frozen, the openings closed or the wheels at rest.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ...reports.tables import table
from ...scenario import load
from .standard import settled

if TYPE_CHECKING:
    from numpy.typing import NDArray

LENGTH_S = 700.0

SEAS: dict[str, dict[str, Any]] = {
    "Hs 2.0 m, Tp 11.5 s": {"significant_height_m": 2.0, "peak_period_s": 11.5},
    "Hs 2.5 m, Tp 9 s": {"significant_height_m": 2.5, "peak_period_s": 9.0},
    "Hs 2.0 m, Tp 14 s": {"significant_height_m": 2.0, "peak_period_s": 14.0},
}
"""Beam seas: JONSWAP, gamma 3.3; the first has its peak at the ship's natural roll period."""


@dataclass(frozen=True)
class Device:
    """A device in one of its states."""

    scenario: str
    given: dict[str, Any]
    without: str | None
    """State of the device with which the roll is compared."""


DEVICES: dict[str, Device] = {
    "liquid frozen": Device("roll_reduction_tank", {"tank": False}, None),
    "U-tank": Device("roll_reduction_tank", {}, "liquid frozen"),
    "openings closed": Device("roll_reduction_flooded_tanks", {"tanks": False, "control": False}, None),
    "open tanks": Device("roll_reduction_flooded_tanks", {"control": False}, "openings closed"),
    "open tanks, pumped": Device("roll_reduction_flooded_tanks", {}, "openings closed"),
    "wheels at rest": Device("roll_reduction_gyros", {"spin_rad_s": 0.0}, None),
    "gyros, dampers": Device("roll_reduction_gyros", {}, "wheels at rest"),
    "gyros, driven": Device("roll_reduction_gyros", {"active": True}, "wheels at rest"),
}

ALLOWED = 0.5
"""Allowed ratio of the standard deviation of roll to that without the device."""


@dataclass(frozen=True)
class Rolled:
    """One run."""

    sea: str
    device: str
    roll_deg: float
    """Standard deviation of roll, degrees."""
    largest_deg: float
    left: float | None
    """Standard deviation of roll over that without the device."""
    utilisation: float | None
    """Largest share of the travel: of the liquid level's range, or of the gimbal's angle."""
    effort: float | None
    """Largest share of the drive's torque, or of the pumps' flow."""
    power_kw: float | None
    """Mean power while the drives deliver power, or least power of the pumps, kW."""

    @property
    def verdict(self) -> str:
        """Verdict: whether the roll is within the allowed ratio, and the device within its travel."""
        if self.left is None:
            return "-"
        reached = "reached" if self.left <= ALLOWED else f"misses by {100 * (self.left - ALLOWED):.0f} %"
        beyond = self.utilisation is not None and self.utilisation > 1.0
        return reached + (", meets its stops" if beyond else "")


class Used(NamedTuple):
    """Utilisation of a device's limits, and its power."""

    utilisation: float | None = None
    effort: float | None = None
    power_kw: float | None = None


Column = Callable[[str], "NDArray[np.float64]"]


def _levels(column: Column, case: Device) -> Used:
    tank = load(case.scenario).resolved["forces"]["tank"]["u_tank"]
    level = tank["level_m"]
    levels = np.concatenate([column("tank.level_port"), column("tank.level_starboard")]) - level
    room = min(tank["column_height_m"] - level, level - tank["duct_height_m"] / 2)
    return Used(float(np.abs(levels).max()) / room)


def _flooded(column: Column, case: Device) -> Used:
    tank = load(case.scenario).resolved["forces"]["tank_port"]["free_flooding_tank"]
    names = ("tank_port", "tank_starboard")
    levels = np.concatenate([column(f"{name}.water_level") for name in names])
    room = tank["height_m"] - tank["level_m"]
    utilisation = float(np.abs(levels - tank["level_m"]).max()) / room
    if not case.given.get("control", True):
        return Used(utilisation)
    flow = max(float(np.abs(column(f"{name}.air_flow")).max()) for name in names)
    power = sum(float(column(f"{name}.air_power").mean()) for name in names)
    return Used(utilisation, flow / tank["air_pump"]["flow_limit_m3_s"], power / 1e3)


def _gyros(column: Column, case: Device) -> Used:
    given = load(case.scenario).resolved
    angle = column("precession_port.joint_position")
    stops = given["bodies"]["gimbal_port"]["joint"]["revolute"]["limits"]
    utilisation = float(np.abs(angle).max()) / stops["upper_rad"]
    if not case.given.get("active"):
        return Used(utilisation, 0.0, 0.0)
    lever = column("precession.push_port.commanded_lever")
    torque = given["drives"]["push_port"]["motor"]["torque_N_m"] * lever
    work = torque * column("precession_port.joint_velocity")
    return Used(utilisation, float(np.abs(lever).max()), 2 * float(np.maximum(work, 0.0).mean()) / 1e3)


USED: dict[str, Callable[[Column, Device], Used]] = {
    "roll_reduction_tank": _levels,
    "roll_reduction_flooded_tanks": _flooded,
    "roll_reduction_gyros": _gyros,
}


def cases() -> Iterator[tuple[str, str]]:
    """Sea and device of each run.

    >>> len(list(cases()))
    24
    """
    return ((sea, device) for sea in SEAS for device in DEVICES)


def measure(sea: str, device: str, without_deg: float | None = None, length_s: float = LENGTH_S) -> Rolled:
    """Run one case, and measure it after the start-up; `without_deg` is the roll without the device."""
    case = DEVICES[device]
    column = settled(case.scenario, SEAS[sea] | case.given, length_s).column
    roll = np.degrees(column("hull.roll"))
    deviation = float(roll.std())
    left = None if without_deg is None else deviation / without_deg
    used = Used() if case.without is None else USED[case.scenario](column, case)
    return Rolled(sea, device, deviation, float(np.abs(roll).max()), left, *used)


def measured(update: Callable[[float], None]) -> list[Rolled]:
    """Every case; `update` is called after each."""
    rows: dict[tuple[str, str], Rolled] = {}
    for done, (sea, device) in enumerate(cases(), 1):
        without = DEVICES[device].without
        rows[sea, device] = measure(sea, device, rows[sea, without].roll_deg if without else None)
        update(done)
    return list(rows.values())


HEAD = ("sea", "device", "roll, deg", "largest, deg", "left, %", "travel", "effort", "power, kW", "verdict")


def text(rows: Sequence[Rolled]) -> str:
    """Table: roll, its ratio to that without the device, largest shares of the limits, mean power of the
    drives."""

    def number(value: float | None, form: str) -> str:
        return "-" if value is None else format(value, form)

    cells = [
        (
            row.sea,
            row.device,
            f"{row.roll_deg:.2f}",
            f"{row.largest_deg:.1f}",
            number(None if row.left is None else 100 * row.left, ".0f"),
            number(row.utilisation, ".2f"),
            number(row.effort, ".2f"),
            number(row.power_kw, ".1f"),
            row.verdict,
        )
        for row in rows
    ]
    return "\n".join(
        [*table([HEAD, *cells], "<<>>>>>><"), f"asked for: at most {100 * ALLOWED:g} % of the roll"]
    )

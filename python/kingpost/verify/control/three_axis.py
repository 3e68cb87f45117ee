"""Performance of compensation in three axes on its standard seas, with and without control. It is measured on
the gallery's scenario: the standard deviation of the tip's horizontal position and the load's height
together, over that without compensation in the same sea.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from ...reports.tables import table
from .standard import AT_A_LIMIT, LENGTH_S, SEAS, in_sea, settled

SCENARIO = "three_axis_compensation"
CONTROLLER = "controllers.compensation.three_axis_compensation"
DRIVES = ("slewing", "luffing", "hoist")

CONTROLS: dict[str, dict[str, Any]] = {
    "off": {"compensation": False},
    "ideal": {f"{CONTROLLER}.sensor": None},
    "sensor": {},
    "sensor, no prediction": {f"{CONTROLLER}.prediction": None},
}
"""`sensor`: noise, bias, high-pass filter of displacements with 20 s, 0.1 s of delay."""

ALLOWED = {"ideal": 8.0}
"""Allowed residual in three axes, % of the motion without compensation."""


@dataclass(frozen=True)
class HeldInThreeAxes:
    """One run of compensation in three axes."""

    sea: str
    control: str
    deviations_m: tuple[float, float, float]
    """Standard deviations of x and y of the tip and of the load's height, m."""
    still_m: float
    """Root of the sum of squares of the deviations without compensation, m."""
    utilisation: dict[str, float]
    """The largest share of all drives' limits: speed, torque, power."""
    power_kw: float
    """Mean power while the drives deliver power, kW."""

    @property
    def residual(self) -> float:
        """Motion in three axes over that without compensation, %."""
        return 100 * math.hypot(*self.deviations_m) / self.still_m

    @property
    def verdict(self) -> str:
        """Verdict: whether the residual is within the allowed one, and the drives within their limits."""
        if self.utilisation["speed"] > 1.0:
            return AT_A_LIMIT
        allowed = ALLOWED.get(self.control)
        if allowed is None:
            return "-"
        return "reached" if self.residual <= allowed else f"misses by {self.residual - allowed:.1f} %"


def cases() -> Iterator[tuple[str, str]]:
    """Sea and control of each run.

    >>> len(list(cases()))
    12
    """
    return ((sea, control) for sea in SEAS for control in CONTROLS)


def measure(sea: str, control: str, still_m: float = math.nan, length_s: float = LENGTH_S) -> HeldInThreeAxes:
    """Run one case, and measure it after the start-up; without compensation, `still_m` is measured."""
    found = settled(SCENARIO, in_sea(CONTROLLER, sea, CONTROLS[control]), length_s)
    places = ("boom.tip.point_position.x", "boom.tip.point_position.y", "lift.hook.point_position.z")
    x, y, z = (float(found.column(place).std()) for place in places)
    return HeldInThreeAxes(
        sea,
        control,
        deviations_m=(x, y, z),
        still_m=math.hypot(x, y, z) if control == "off" else still_m,
        utilisation={limit: found.largest_share(DRIVES, limit) for limit in ("speed", "effort", "power")},
        power_kw=found.driving_kw(DRIVES),
    )


def measured(update: Callable[[float], None]) -> list[HeldInThreeAxes]:
    """Every case; `update` is called after each."""
    rows: list[HeldInThreeAxes] = []
    still_m = math.nan
    for done, (sea, control) in enumerate(cases(), 1):
        rows.append(measure(sea, control, still_m))
        if control == "off":
            still_m = rows[-1].still_m
        update(done)
    return rows


HEAD = ("sea, 30 deg off the bow", "compensation", "x, m", "y, m", "z, m", "residual, %",
        "speed", "torque", "power", "mean, kW", "verdict")  # fmt: skip


def text(rows: Sequence[HeldInThreeAxes]) -> str:
    """Table: deviations, residual over that without compensation, largest shares of the drives' limits,
    power."""
    cells = [
        (
            row.sea,
            row.control,
            *(f"{deviation:.3f}" for deviation in row.deviations_m),
            f"{row.residual:.1f}",
            *(f"{share:.2f}" for share in row.utilisation.values()),
            f"{row.power_kw:.1f}",
            row.verdict,
        )
        for row in rows
    ]
    asked = f"asked for: {ALLOWED['ideal']:g} % in three axes with ideal sensors"
    return "\n".join([*table([HEAD, *cells], "<<>>>>>>>><"), asked])

"""Performance of the platform that keeps a crane level, on its standard seas, with and without control.

It is measured on the gallery's scenario: tilt and height of the platform, each over those without
compensation in the same sea.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...reports.tables import table
from .standard import AT_A_LIMIT, LENGTH_S, SEAS, in_sea, settled

SCENARIO = "level_platform"
CONTROLLER = "controllers.compensation.platform_compensation"
DRIVES = ("rising", "rolling", "pitching")

CONTROLS: dict[str, dict[str, Any]] = {
    "off": {"compensation": False},
    "ideal": {f"{CONTROLLER}.sensor": None},
    "sensor": {},
}
"""`sensor`: noise, bias, high-pass filter of heave with 20 s, 0.1 s of delay."""


@dataclass(frozen=True)
class LevelPlatform:
    """One run of the platform."""

    sea: str
    control: str
    tilt: float
    """Standard deviation of the tilt, about both axes together, rad."""
    height_m: float
    """Standard deviation of the height of the crane's foot, m."""
    utilisation: dict[str, float]
    """The largest share of all drives' limits: speed, force or torque."""
    power_kw: float
    """Mean power while the drives deliver power, kW."""

    @property
    def verdict(self) -> str:
        """Verdict: whether the drives are within their limits."""
        return AT_A_LIMIT if max(self.utilisation.values()) > 1.0 else "-"


def cases() -> Iterator[tuple[str, str]]:
    """Sea and control of each run.

    >>> len(list(cases()))
    9
    """
    return ((sea, control) for sea in SEAS for control in CONTROLS)


def measure(sea: str, control: str, length_s: float = LENGTH_S) -> LevelPlatform:
    """Run one case, and measure it after the start-up."""
    found = settled(SCENARIO, in_sea(CONTROLLER, sea, CONTROLS[control]), length_s)
    about_x, about_y, height = (found.column(f"compensation.platform_offset.{axis}").std() for axis in "xyz")
    return LevelPlatform(
        sea,
        control,
        tilt=float(np.hypot(about_x, about_y)),
        height_m=float(height),
        utilisation={limit: found.largest_share(DRIVES, limit) for limit in ("speed", "effort")},
        power_kw=found.driving_kw(DRIVES),
    )


def measured(update: Callable[[float], None]) -> list[LevelPlatform]:
    """Every case; `update` is called after each."""
    rows: list[LevelPlatform] = []
    for done, case in enumerate(cases(), 1):
        rows.append(measure(*case))
        update(done)
    return rows


HEAD = ("sea, 30 deg off the bow", "platform", "tilt, deg", "height, m", "tilt, %", "height, %",
        "speed", "force", "mean, kW", "verdict")  # fmt: skip


def text(rows: Sequence[LevelPlatform]) -> str:
    """Table: deviations, their ratios to those without compensation, largest shares of the drives' limits,
    power."""
    still = {row.sea: row for row in rows if row.control == "off"}
    cells = [
        (
            row.sea,
            row.control,
            f"{np.degrees(row.tilt):.3f}",
            f"{row.height_m:.4f}",
            f"{100 * row.tilt / still[row.sea].tilt:.1f}",
            f"{100 * row.height_m / still[row.sea].height_m:.1f}",
            *(f"{share:.2f}" for share in row.utilisation.values()),
            f"{row.power_kw:.1f}",
            row.verdict,
        )
        for row in rows
    ]
    return "\n".join(table([HEAD, *cells], "<<>>>>>>><"))

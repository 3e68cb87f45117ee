"""Performance of heave compensation by a cylinder in the hoist rope, on its standard seas: by gas, a drive,
or both.

It is measured on the gallery's scenario `hybrid_compensation`, with the load at 30 m: the residual at the
hook, the carriage's stroke, and force and power of the drive with and without gas.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...reports.tables import table
from .standard import LENGTH_S, SEAS, in_sea, judged, settled, with_satellites

SCENARIO = "hybrid_compensation"
CONTROLLER = "controllers.compensation.heave_compensation"
DRIVE = "cylinder"
DRIVES = (DRIVE,)
_LINEAR = f"drives.{DRIVE}.linear_controlled_drive"

GAS_ALONE = "gas alone"
CONTROLS: dict[str, dict[str, Any]] = {
    "locked": {"compensation": False},
    GAS_ALONE: {"active_cylinder": False},
    "drive alone, sensor": {
        "bodies.carriage.joint.prismatic.gas_spring": None,
        f"{_LINEAR}.force_limit_N": 4e5,
        f"{_LINEAR}.power_limit_W": 3e5,
    },
    "gas and drive, ideal": {f"{CONTROLLER}.sensor": None},
    "gas and drive, sensor": {},
    "gas and drive, sensor and satellites": with_satellites(CONTROLLER),
}
"""The sensor and the satellites are those of heave compensation by a winch."""

ALLOWED = {
    "drive alone, sensor": 5.0,
    "gas and drive, ideal": 2.0,
    "gas and drive, sensor": 5.0,
    "gas and drive, sensor and satellites": 5.0,
}
"""Allowed residual at the hook, % of the heave of the tip."""


@dataclass(frozen=True)
class ByCylinder:
    """One run of compensation by a cylinder."""

    sea: str
    control: str
    tip_m: float
    """Standard deviation of the height of the crane's tip, m."""
    hook: float
    """Standard deviation of the hook's height over that of the tip, %."""
    stroke_m: float
    """The carriage's largest distance from its middle, m."""
    force_kn: float
    """The drive's largest force, kN."""
    power_kw: float
    """Mean power while the drive delivers power, kW."""
    utilisation: dict[str, float]
    """The largest share of the drive's limits: speed, force, power."""

    @property
    def verdict(self) -> str:
        """Verdict: whether the residual is within the allowed one, and the drive within its limits."""
        return judged({"hook": self.hook}, ALLOWED.get(self.control), self.utilisation)


def cases() -> Iterator[tuple[str, str]]:
    """Sea and control of each run.

    >>> len(list(cases()))
    18
    """
    return ((sea, control) for sea in SEAS for control in CONTROLS)


def measure(sea: str, control: str, length_s: float = LENGTH_S) -> ByCylinder:
    """Run one case, and measure it after the start-up."""
    found = settled(SCENARIO, in_sea(CONTROLLER, sea, CONTROLS[control]), length_s)
    tip = float(found.column("boom.tip.point_position.z").std())
    drives = () if control == GAS_ALONE else DRIVES
    forces = [np.abs(found.column(f"{drive}.drive_force")).max() for drive in drives]
    limits = ("speed", "effort", "power") if drives else ()
    return ByCylinder(
        sea,
        control,
        tip_m=tip,
        hook=100 * float(found.column("lift.hook.point_position.z").std()) / tip,
        stroke_m=float(np.abs(found.column("slide.joint_position")).max()),
        force_kn=float(max(forces, default=0.0)) / 1e3,
        power_kw=found.driving_kw(drives),
        utilisation={limit: found.largest_share(drives, limit) for limit in limits},
    )


def measured(update: Callable[[float], None]) -> list[ByCylinder]:
    """Every case; `update` is called after each."""
    rows: list[ByCylinder] = []
    for done, case in enumerate(cases(), 1):
        rows.append(measure(*case))
        update(done)
    return rows


HEAD = ("sea", "carriage", "tip, m", "hook, %", "stroke, m", "force, kN", "mean, kW", "verdict")


def text(rows: Sequence[ByCylinder]) -> str:
    """Table: residual over the heave of the tip, stroke, force and power."""
    cells = [
        (
            row.sea,
            row.control,
            f"{row.tip_m:.3f}",
            f"{row.hook:.2f}",
            f"{row.stroke_m:.2f}",
            f"{row.force_kn:.1f}",
            f"{row.power_kw:.2f}",
            row.verdict,
        )
        for row in rows
    ]
    return "\n".join(table([HEAD, *cells], "<<>>>>><"))

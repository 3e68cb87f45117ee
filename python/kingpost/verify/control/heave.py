"""Performance of heave compensation on its standard seas, with and without control.

It is measured on the gallery's scenario: the residual of the tip's heave at the winch and at the hook, each
over the heave of the tip. A load far below the ship hangs on a long elastic rope, which adds stretch and
resonance.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from ...reports.tables import table
from .standard import LENGTH_S, SEAS, in_sea, judged, settled, with_inertial_unit, with_satellites

SCENARIO = "heave_compensation"
CONTROLLER = "controllers.compensation.heave_compensation"
DRIVES = ("hoist",)

CONTROLS: dict[str, dict[str, Any]] = {
    "off": {"compensation": False},
    "ideal": {f"{CONTROLLER}.sensor": None},
    "ideal, no prediction": {f"{CONTROLLER}.sensor": None, f"{CONTROLLER}.prediction": None},
    "sensor": {},
    "sensor, no prediction": {f"{CONTROLLER}.prediction": None},
    "sensor and satellites": with_satellites(CONTROLLER),
    "inertial unit": with_inertial_unit(CONTROLLER),
    "inertial unit and satellites": with_inertial_unit(CONTROLLER, satellites=True),
}
"""`sensor`: noise, bias, high-pass filter of heave with 20 s, 0.1 s of delay. `satellites`: a receiver with
noise of 2 cm at 10 Hz and 0.1 s of delay gives back what the filter removes. `inertial unit`:
accelerometers and gyroscopes with noise and bias, a filter that knows the waves, 0.1 s of delay."""

DEPTHS: dict[str, dict[str, Any]] = {"30 m": {}, "1000 m": {"load_height_m": -1000}}

ALLOWED = {"ideal": 2.0} | dict.fromkeys(
    ("sensor", "sensor and satellites", "inertial unit", "inertial unit and satellites"), 5.0
)
"""Allowed residual at the winch and at the hook, % of the heave of the tip."""


@dataclass(frozen=True)
class Compensated:
    """One run of heave compensation."""

    sea: str
    depth: str
    control: str
    tip_m: float
    """Standard deviation of the height of the crane's tip, m."""
    winch: float
    """Standard deviation of the residual at the winch over that of the tip, %."""
    hook: float
    """Standard deviation of the hook's height over that of the tip, %."""
    utilisation: dict[str, float]
    """The largest share of the drive's limits: speed, torque, power."""
    power_kw: float
    """Mean power while the drive delivers power, kW."""

    @property
    def verdict(self) -> str:
        """Verdict: whether the residuals are within the allowed ones, and the drive within its limits."""
        return judged({"winch": self.winch, "hook": self.hook}, ALLOWED.get(self.control), self.utilisation)


def cases() -> Iterator[tuple[str, str, str]]:
    """Sea, depth and control of each run.

    >>> len(list(cases()))
    48
    """
    return ((sea, depth, control) for sea in SEAS for depth in DEPTHS for control in CONTROLS)


def measure(sea: str, depth: str, control: str, length_s: float = LENGTH_S) -> Compensated:
    """Run one case, and measure it after the start-up."""
    found = settled(SCENARIO, in_sea(CONTROLLER, sea, CONTROLS[control]) | DEPTHS[depth], length_s)
    tip = float(found.column("boom.tip.point_position.z").std())
    return Compensated(
        sea,
        depth,
        control,
        tip_m=tip,
        winch=100 * float(found.column("compensation.compensation_residual").std()) / tip,
        hook=100 * float(found.column("lift.hook.point_position.z").std()) / tip,
        utilisation={limit: found.largest_share(DRIVES, limit) for limit in ("speed", "effort", "power")},
        power_kw=found.driving_kw(DRIVES),
    )


def measured(update: Callable[[float], None]) -> list[Compensated]:
    """Every case; `update` is called after each."""
    rows = []
    for done, case in enumerate(cases(), 1):
        rows.append(measure(*case))
        update(done)
    return rows


HEAD = ("sea", "load at", "compensation", "tip, m", "winch, %", "hook, %",
        "speed", "torque", "power", "mean, kW", "verdict")  # fmt: skip


def text(rows: Sequence[Compensated]) -> str:
    """Table: residuals over the heave of the tip, largest shares of the drive's limits, mean power."""
    cells = [
        (
            row.sea,
            row.depth,
            row.control,
            f"{row.tip_m:.3f}",
            f"{row.winch:.2f}",
            f"{row.hook:.2f}",
            *(f"{share:.2f}" for share in row.utilisation.values()),
            f"{row.power_kw:.1f}",
            row.verdict,
        )
        for row in rows
    ]
    asked = f"asked for: {ALLOWED['ideal']:g} % with ideal sensors, {ALLOWED['sensor']:g} % with the sensor"
    return "\n".join([*table([HEAD, *cells], "<<<>>>>>>><"), asked])

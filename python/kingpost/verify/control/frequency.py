"""Frequency response of heave compensation: amplitude of the residual over that of the tip.

Regular waves of several periods run at once (a multisine: Pintelon & Schoukens, *System Identification*, 2nd
ed., 2012, ch. 5), each with a whole number of periods in the measured window. The lines of
the Fourier transform of residual and tip are then those of the waves alone, without leakage, and the ratio of
two lines is the response at that frequency. Two effects are left out: the sensor's noise, which does not
depend on the waves, and the friction of the sheave, which the closed form does not contain.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from ...reports.tables import table
from ...scenario import load
from ...simulation.simulate import run
from ..pictures import OURS
from ..rows import FAILED, PASSED
from .heave import CONTROLLER, SCENARIO
from .standard import UNIT

WINDOW_S = 80.0
SETTLED_S = 300.0
"""Start-up time, s: the ship's natural roll, the least damped motion, has then decayed to e^-7."""
LINES = (4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 16, 18)
"""Numbers of waves in the window: periods from 20 s to 4.4 s."""
OMEGA = 2 * np.pi * np.array(LINES) / WINDOW_S
RECORDED_S = 0.1

SHEAVE = "forces.hoist_rope.rope.path.1.sheave"
SMOOTH = {f"{SHEAVE}.efficiency_{way}": 1.0 for way in ("hoisting", "lowering")}
EXACT = {f"{UNIT}.{signal}_errors": None for signal in ("angle", "heave", "heave_rate", "rate")}
AS_SENT = EXACT | {f"{UNIT}.heave_filter": None}
PREDICTION = f"{CONTROLLER}.prediction"
IDEAL = {f"{CONTROLLER}.sensor": None}

CONTROLS: dict[str, dict[str, Any]] = {
    "ideal": IDEAL,
    "ideal, no prediction": IDEAL | {PREDICTION: None},
    "delay alone, no prediction": AS_SENT | {PREDICTION: None},
    "sensor": EXACT,
    "sensor, no prediction": EXACT | {PREDICTION: None},
}
"""`sensor`: high-pass filter of heave with 20 s, 0.1 s of delay; with a delay alone without that filter."""

IN_CLOSED_FORM = ("ideal, no prediction", "delay alone, no prediction")
ALLOWED = 0.002
"""Allowed difference from the closed form: the inertia of the drum on its drive's spring causes w^2 I / k,
0.0017 of its motion at 4.4 s."""


@dataclass(frozen=True)
class OverFrequency:
    """One run."""

    control: str
    tip_m: np.ndarray
    """Amplitude of the tip at each of `OMEGA`, m."""
    ratio: np.ndarray
    """Amplitude of the residual over that of the tip."""
    formula: np.ndarray | None
    """The closed form, if there is one."""

    @property
    def distance(self) -> float | None:
        """Largest difference between the measured ratio and the closed form."""
        return None if self.formula is None else float(np.abs(self.ratio - self.formula).max())

    @property
    def verdict(self) -> str:
        """Whether the measured ratio agrees with the closed form within `ALLOWED`; `-` if there is none."""
        if self.distance is None:
            return "-"
        return PASSED if self.distance <= ALLOWED else FAILED


def left_by_delay(
    omega: np.ndarray, delay_s: float, period_s: float, lag_s: float, gain_per_s: float
) -> np.ndarray:
    """Residual of a sinusoid as a share of its amplitude, without prediction, if z and v are delayed.

    With D = e^(-s tau) of the sensor, P = e^(-s T_s/2) sinh(s T_s/2) / (s T_s/2) / (1 + s T) of hold and
    drive, and the rope L paid out, which the feedback measures without delay,

        s L = P (D (s + g) z - g L)

        |z - L| / |z| = |(s (1 - P D) + g P (1 - D)) / (s + g P)|,    s = i w

    Without hold, lag and feedback it is |1 - e^(-i w tau)| = 2 sin(w tau / 2).

    >>> omega = np.array([0.5, 1.0])
    >>> bool(np.allclose(left_by_delay(omega, 0.2, 0.0, 0.0, 0.0), 2 * np.sin(0.1 * omega)))
    True
    """
    s = 1j * omega
    hold = np.exp(-s * period_s / 2) * np.sinc(omega * period_s / 2 / np.pi)
    drive, late = hold / (1 + s * lag_s), np.exp(-s * delay_s)
    return np.abs((s * (1 - drive * late) + gain_per_s * drive * (1 - late)) / (s + gain_per_s * drive))


def closed_form(control: str, omega: np.ndarray = OMEGA) -> np.ndarray | None:
    """Residual by the closed form with the numbers of the scenario, if there is one."""
    if control not in IN_CLOSED_FORM:
        return None
    given = load(SCENARIO).resolved
    law = given["controllers"]["compensation"]["heave_compensation"]
    unit = given["sensors"]["mru"]["motion_reference_unit"]
    delay_s = 0.0 if control.startswith("ideal") else unit["delay_samples"] * unit["period_s"]
    lag_s = given["drives"]["hoist"]["controlled_drive"]["response_time_s"]
    return left_by_delay(omega, delay_s, law["period_s"], lag_s, law["position_gain_per_s"])


def _waves() -> dict[str, Any]:
    """Regular waves from ahead that replace the sea; short ones are higher, because they move the ship
    less."""
    waves: dict[str, Any] = {"sea.waves.wind_sea.jonswap.enabled": False}
    for i, line in enumerate(LINES):
        # Phases that grow quadratically give a low crest factor (Schroeder 1970).
        wave = {
            "height_m": 0.3 if line < 12 else 0.6 if line < 17 else 1.0,
            "period_s": WINDOW_S / line,
            "direction_deg": 180,
            "phase_deg": 180 * i**2 / len(LINES) % 360 - 180,
        }
        waves[f"sea.waves.line_{line}"] = {"regular": wave}
    return waves


@cache
def measure(control: str, settled_s: float = SETTLED_S) -> OverFrequency:
    """Run one of `CONTROLS`, once."""
    times = {"simulation.duration_s": settled_s + WINDOW_S, "simulation.record_every_s": RECORDED_S}
    results = run(SCENARIO, _waves() | SMOOTH | CONTROLS[control] | times).kingpost
    count = round(WINDOW_S / RECORDED_S)

    def lines(column: str) -> np.ndarray:
        return np.abs(np.fft.rfft(results[column].values[-count:])[list(LINES)]) * 2 / count

    tip = lines("boom.tip.point_position.z")
    ratio = lines("compensation.compensation_residual") / tip
    return OverFrequency(control, tip, ratio, closed_form(control))


def cases() -> Iterator[str]:
    """The control of each run.

    >>> len(list(cases()))
    5
    """
    return iter(CONTROLS)


def measured(update: Callable[[float], None]) -> list[OverFrequency]:
    """Every case; `update` is called after each."""
    rows = []
    for done, control in enumerate(cases(), 1):
        rows.append(measure(control))
        update(done)
    return rows


def text(rows: Sequence[OverFrequency]) -> str:
    """Table over the periods, with the closed form if there is one."""
    columns: dict[str, np.ndarray] = {}
    for row in rows:
        columns[row.control] = row.ratio
        if row.formula is not None:
            columns[f"{row.control}: formula"] = row.formula
    cells = [
        (
            f"{2 * np.pi / omega:.1f}",
            f"{rows[0].tip_m[i]:.3f}",
            *(f"{100 * one[i]:.1f}" for one in columns.values()),
        )
        for i, omega in enumerate(OMEGA)
    ]
    head = ("waves, s", "tip, m", *(f"{name}, %" for name in columns))
    told = [
        f"{row.control}: off its formula by {100 * row.distance:.2f} % of the tip's heave at most,"
        f" allowed {100 * ALLOWED:g} %: {row.verdict}"
        for row in rows
        if row.distance is not None
    ]
    return "\n".join([*table([head, *cells], ">" * len(head)), *told])


BLUE, RED, VIOLET = "#0072B2", "#D55E00", "#CC79A7"
PANELS = {
    "without prediction": {"ideal, no prediction": BLUE, "delay alone, no prediction": RED},
    "prediction, and a sensor that filters": {"ideal": BLUE, "sensor": RED, "sensor, no prediction": VIOLET},
}
"""The curves of the picture, with their colours."""


def picture(pyplot: Any) -> Any:
    """Draw the residual over the wave period: compared with closed forms, and with prediction."""
    figure, panels = pyplot.subplots(1, 2, figsize=(11, 4.2), sharey=True)
    periods = 2 * np.pi / OMEGA
    fine = np.linspace(OMEGA[0], OMEGA[-1], 200)
    for panel, (title, curves) in zip(panels, PANELS.items(), strict=True):
        for control, colour in curves.items():
            formula = closed_form(control, fine)
            alone = {"linestyle": "none"} if formula is not None else {}
            panel.semilogy(
                periods, 100 * measure(control).ratio, label=control, **(OURS | {"color": colour} | alone)
            )
            if formula is not None:
                panel.semilogy(
                    2 * np.pi / fine, 100 * formula, color=colour, linewidth=1, label="its formula"
                )
        panel.set(title=title, xlabel="period of the waves, s", xlim=(4, 20.5))
        panel.legend(fontsize=9)
    band = load(SCENARIO).resolved["controllers"]["compensation"]["heave_compensation"]["prediction"]
    ends = band["shortest_period_s"], band["longest_period_s"]
    panels[1].axvspan(*ends, color="#eeeeee", zorder=0, label="band of the prediction")
    panels[1].legend(fontsize=9)
    panels[0].set(ylabel="residual over the tip's heave, %")
    return figure

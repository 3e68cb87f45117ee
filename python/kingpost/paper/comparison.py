"""Comparison of the integrators: a table, a picture, a CSV file and a recommendation."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import Any

from .. import output
from .integrators import ADAPTIVE, LABELS, ORDERS, SHOWN_STEP_S, TIMED_STEP_S, Compared, Point
from .style import INTEGRATORS, plotting, save

NAME = "integrators"
Table = list[tuple[str, ...]]

PANELS = {
    ("paper", "energy"): ("Energy", "|energy error| / work of the motors", 10.0),
    ("paper", "momentum"): ("Angular momentum", "|momentum error|, N m s", 1e6),
    ("paper", "rotation"): ("Ship's rotation", "angle from the true orientation, rad", 10.0),
    ("stiff", "slew"): ("With the arm on a stiff spring: slew", "angle from the true one, rad", 10.0),
}
"""Title, axis and its upper end: larger errors mean that the run has diverged."""


def table(compared: list[Compared]) -> Table:
    """Orders, errors, cost and largest steps: a header, then a row for each integrator."""
    shown, timed = f"{1000 * SHOWN_STEP_S:g} ms", f"{1000 * TIMED_STEP_S:g} ms"
    rows: Table = [
        (
            "Integrator",
            "Order",
            "energy",
            "momentum",
            "rotation",
            f"Energy error, {shown}",
            "Momentum, N m s",
            f"Evaluations/s, {timed}",
            "Time/s, ms",
            "Largest step, ms",
            "stiff, ms",
        )
    ]
    for one in compared:
        slopes = one.slopes()
        point = one.shown()
        rows.append(
            (
                LABELS[one.integrator],
                str(ORDERS[one.integrator]),
                *(("own steps", "", "") if slopes is None else (f"{slope:.2f}" for slope in slopes)),
                f"{point.energy:.1e}",
                f"{point.momentum:.1e}",
                f"{one.evaluations:,.0f}",
                f"{one.time_ms:.2f}",
                *(_step(one, case) for case in ("paper", "stiff")),
            )
        )
    return rows


def _step(one: Compared, case: str) -> str:
    if one.integrator == ADAPTIVE:
        return "any"
    step_ms = 1000 * one.largest_step_s[case]
    return f"{step_ms:.3g}" if step_ms > 0 else f"under {1000 * TIMED_STEP_S:g}"


def recommendation(compared: list[Compared]) -> str:
    """One paragraph: which integrator suits which case."""
    by_name = {one.integrator: one for one in compared}
    rk4, alpha = by_name["rk4"], by_name["generalized_alpha"]
    ratio = by_name["forward_euler"].shown().energy / rk4.shown().energy
    return (
        "Take RK4, the default, for rigid cranes: at 10 ms its energy error is "
        f"{_power(ratio)} times smaller than that of the paper's forward Euler, for four times the work. "
        "Take Dormand-Prince if you prefer to set an error instead of a step: for small errors it "
        "needs the fewest evaluations. If a stiff spring, stop or servo swings faster "
        f"than you need to resolve, explicit schemes must still follow it (RK4: {_ms(rk4)} ms here), "
        "and generalized-alpha steps over it and damps it "
        f"({_ms(alpha)} ms); Newmark and the midpoint rule step over it without damping, and the midpoint "
        "rule keeps the momentum of free bodies to rounding. Forward Euler is included to "
        "compare with the paper; if only one evaluation per step is affordable, semi-implicit Euler costs "
        "the same and does not pump energy into oscillations."
    )


def _ms(one: Compared) -> str:
    return f"{1000 * one.largest_step_s['stiff']:.0f}"


def _power(ratio: float) -> str:
    return f"{float(f'{ratio:.1g}'):,.0f}"


def write(folder: Path, compared: list[Compared]) -> None:
    """Write the runs as CSV, one per line, and draw them."""
    with (
        output.whole(folder / f"{NAME}.csv") as beside,
        beside.open("w", newline="", encoding="utf-8") as file,
    ):
        lines = csv.writer(file)
        head = ("case", "integrator", "step_s", "tolerance", "energy_error_relative", "momentum_error_N_m_s")
        lines.writerow((*head, "rotation_error_rad", "slew_error_rad", "evaluations_per_s"))
        for one in compared:
            for case, points in one.points.items():
                lines.writerows((case, one.integrator, *_cells(one, point)) for point in points)
    draw(folder, compared)


def _cells(one: Compared, point: Point) -> tuple[object, ...]:
    setting = ("", point.setting) if one.integrator == ADAPTIVE else (point.setting, "")
    return (*setting, point.energy, point.momentum, point.rotation, point.slew, point.evaluations)


def draw(folder: Path, compared: list[Compared]) -> None:
    """Draw errors against cost on logarithmic axes, a panel for each error."""
    with plotting() as pyplot:
        drawn, panels = pyplot.subplots(2, 2, figsize=(12, 9.2))
        for panel, ((case, name), (title, unit, top)) in zip(panels.flat, PANELS.items(), strict=True):
            for one in compared:
                _curve(panel, one, case, name)
            panel.set(title=title, ylabel=unit, xlabel="Evaluations of the equations of motion per second")
            panel.set_ylim(top=min(top, panel.get_ylim()[1]))
        drawn.legend(*panels.flat[0].get_legend_handles_labels(), loc="outside lower center", ncols=4)
        save(drawn, folder / NAME)


def _curve(panel: Any, one: Compared, case: str, name: str) -> None:
    points = one.points[case]
    cost = [point.evaluations for point in points]
    panel.loglog(cost, [getattr(point, name) for point in points], label=LABELS[one.integrator],
                 **INTEGRATORS[one.integrator])  # fmt: skip

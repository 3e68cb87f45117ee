"""Checks of the lines of a moored ship: fairleads that move as the ship did, by MoorDyn, stored with their
origin in `moored_lines.json`; the motions are in `fairleads.json`."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from ..scenario import Scenario
from ..simulation.simulate import run
from .models import GRAVITY, scenario, settings
from .rows import Compared, check

AREA = "lines"
STEP_S = 0.05
ELEMENTS = 20


@cache
def kept(name: str) -> dict[str, Any]:
    """The motions (`fairleads`), or the results of MoorDyn (`moored_lines`).

    >>> kept("fairleads")["lines"]["windward"]["unstretched_length_m"]
    430.0
    """
    return json.loads((Path(__file__).parent / f"{name}.json").read_text(encoding="utf-8"))


def _slides(motion: dict[str, Any]) -> dict[str, Any]:
    """Three bodies of 1 g on slides along x, y and z; the last one moves as the fairlead."""
    bodies, parent = {}, "world"
    for axis, name in zip("xyz", ("surge", "sway", "fairlead"), strict=True):
        speeds = motion[f"speed_{axis}_mm_s"]
        times = [kept("fairleads")["every_s"] * i for i in range(len(speeds))]
        rate = {"speed_m_s": 1e-3, "history": "list", "list": {"time_s": times, "share": speeds}}
        joint = {"axis": [float(axis == one) for one in "xyz"], "mode": {"prescribed": rate}}
        if parent == "world":
            joint["position_m"] = motion["start_m"]
        bodies[name] = {
            "parent": parent,
            "mass_kg": 1e-3,
            "inertia": {"tensor": {"moments_kg_m2": [1e-3, 1e-3, 1e-3]}},
            "joint": {"prismatic": joint},
        }
        parent = name
    return bodies


def moored(side: str, sea: str, elements: int = ELEMENTS, step_s: float = STEP_S) -> Scenario:
    """A line from a fairlead that moves as that of the ship on this side, in this sea, to its anchor."""
    given, ground = kept("fairleads"), kept("moored_lines")["sea"]
    line = given["lines"][side]
    section = {name: one for name, one in line.items() if name not in ("anchor_m", "depth_m", "friction")}
    force = {
        "first": {"body": "fairlead"},
        "second": {"body": "world", "position_m": line["anchor_m"]},
        "sections": [section | {"elements": elements}],
        "seabed": {
            "friction": line["friction"],
            "stiffness_N_per_m3": ground["ground_stiffness_N_per_m3"],
            "damping_time_s": ground["ground_damping_N_s_per_m3"] / ground["ground_stiffness_N_per_m3"],
        },
    }
    return scenario(
        _slides(given["motions"][sea][side]),
        GRAVITY | {"line": {"line": force}},
        simulation=settings(step_s, given["duration_s"], integrator="rk4"),
        sea={"density_kg_m3": ground["density_kg_m3"], "depth_m": line["depth_m"]},
    )


@cache
def tension(side: str, sea: str) -> np.ndarray:
    """Tension at the fairlead every 0.05 s, N."""
    return run(moored(side, sea))["line_tension"].sel(line="line").values


FROM_S = 60.0
"""Time from which statistics are: that when the sea has its full height."""
SIDES = ("windward", "leeward", "side")


def compared(side: str, sea: str, figure: str, segments: int = 2 * ELEMENTS) -> Compared:
    """Standard deviation (`std`), maximum or minimum of the tension at the fairlead; the minimum as a share
    of the mean."""
    theirs = kept("moored_lines")["lines"][side][sea]["segments"][str(segments)]
    ours = getattr(tension(side, sea)[round(FROM_S / STEP_S) :], figure)()
    return Compared(float(ours), theirs[f"{figure}_N"], theirs["mean_N"] if figure == "min" else None)


def worst_line(sea: str, figure: str) -> Compared:
    """The figure of that of the three lines whose difference is largest."""
    return max((compared(side, sea, figure) for side in SIDES), key=lambda one: one.error)


MOORDYN = f"MoorDyn {kept('moored_lines')['moordyn']} (Hall & Goupee, Ocean Eng. 104, 2015, 590)"
FIGURES = {"std": "standard deviation", "max": "maximum", "min": "minimum"}


def _add(sea: str, figure: str, tolerance: float, why: str) -> None:
    height = kept("fairleads")["heights_m"][sea]
    check(
        f"line-moored-{sea}-{figure}",
        f"{FIGURES[figure]} of the tension of a ship's chain in waves of {height:g} m, worst of three chains",
        area=AREA,
        unit="N",
        source=f"{MOORDYN}, {2 * ELEMENTS} segments",
        tolerance=tolerance,
        why=why,
    )(lambda: worst_line(sea, figure))


STEPS = "ours changes by {} with half the step, by {} with twice the elements"
_add("moderate", "std", 2e-3, STEPS.format("2e-4", "8e-4"))
_add("moderate", "max", 2e-3, STEPS.format("3e-4", "8e-4"))
_add("moderate", "min", 4e-3, STEPS.format("3e-4", "3e-3"))
_add("high", "std", 5e-3, STEPS.format("3e-4", "6e-4") + "; the windward chain is slack at times")
_add("high", "max", 4e-3, STEPS.format("1.6e-3", "3e-4"))
_add(
    "high",
    "min",
    1e-2,
    "the windward chain is slack at times; ours changes by 6e-3 of the mean with half the step",
)

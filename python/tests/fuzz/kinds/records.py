"""Records in CSV: waves at a gauge, a decaying roll, the sections of a hull."""

from __future__ import annotations

import math
import random
from functools import cache
from pathlib import Path

import kingpost
from kingpost.cli import main
from kingpost.roll_damping import DecayRecord, Sections, from_decay, from_sections

from ..contract import Case, check_exit
from ..mutations import TABLE_WAYS, damaged, encoded

SCENARIO = """version: 1
title: In measured waves
simulation: {step_s: 0.05, duration_s: 0.2}
sea: {waves: {measured: {record: {file: record.csv, direction_deg: 180, highest_rad_s: 2}}}}
bodies:
  buoy: {mass_kg: 5, shape: {sphere: {radius_m: 1}}, joint: {floating: {}}}
forces:
  gravity: {gravity: {}}
  water: {submerged: {body: buoy, coefficients: {drag: 1, added_mass: 1}}}
"""


@cache
def tables() -> dict[str, str]:
    """A gauge's 40 s, a decay of 60 s, a hull of seven sections."""
    gauge = [f"{0.5 * k:g},{math.sin(0.4 * k) + 0.3 * math.sin(0.9 * k + 1):.4f}" for k in range(80)]
    decay = [f"{0.25 * k:g},{10 * math.exp(-0.01 * k) * math.cos(0.2 * k):.4f}" for k in range(240)]
    sections = [f"{10 * k},{20 - abs(k - 3):g},5,{90 - 10 * abs(k - 3)},1.5" for k in range(7)]
    return {
        "waves": "\n".join(["time_s,elevation_m", *gauge, ""]),
        "decay": "\n".join(["# measured", "time_s,roll_deg", *decay, ""]),
        "sections": "\n".join(["x_m,beam_m,draught_m,area_m2,bilge_radius_m", *sections, ""]),
    }


def drawn(draw: random.Random) -> Case:
    """Draw a wrong table."""
    kind = draw.choice(["waves", "waves", "decay", "decay", "sections"])
    files = {"record.csv": encoded(draw, damaged(draw, tables()[kind], TABLE_WAYS))}
    if kind == "waves":
        scenario = damaged(draw, SCENARIO) if draw.random() < 0.1 else SCENARIO
        files["case.yaml"] = encoded(draw, scenario)
    by_command = draw.random() < 0.05 and kind != "waves"
    return Case("records", files, (kind, "command" if by_command else "python"))


def use(case: Case, folder: Path) -> str:
    """Make waves or roll damping from the table."""
    kind, how = case.arguments
    path = folder / "record.csv"
    if how == "command":
        given = ["--gm-m", "2", "--mass-kg", "1e6"] if kind == "decay" else ["--kg-m", "6", "--period-s", "9"]
        code = main(["roll-damping", kind, str(path), *given])
        check_exit(code)
        return f"exit {code}"
    if kind == "decay":
        from_decay(DecayRecord.read(path))
        return "taken"
    if kind == "sections":
        from_sections(Sections.read(path), 6.0, 9.0)
        return "taken"
    simulation = kingpost.Simulation(kingpost.load(folder / "case.yaml"))
    try:
        simulation.step(2)
    except kingpost.RunError as error:
        return f"ended early: {error}"
    return "ran"

"""Displacement RAOs as CSV and as OrcaFlex's YAML, which move a ship."""

from __future__ import annotations

import random
from functools import cache
from pathlib import Path

import kingpost

from ..contract import Case
from ..mutations import TABLE_WAYS, damaged, encoded

SCENARIO = """version: 1
title: A ship that its RAOs move
simulation: {step_s: 0.05, duration_s: 0.2}
sea: {waves: {swell: {regular: {height_m: 1, period_s: 9, direction_deg: 180}}}}
forces: {gravity: {gravity: {}}}
bodies:
  hull:
    mass_t: 5434
    shape: {box: {length_m: 85, width_m: 20, height_m: 8}}
    joint: {moved_by_waves: {raos: RAOS, symmetric: true, origin_m: [0, 0, 5.5], heading_deg: 20}}
"""
ORCAFLEX = """%YAML 1.1
---
VesselTypes:
  - Name: Ship
    RAOResponseUnits: degrees
    RAOWaveUnit: amplitude
    WavesReferredToBy: period (s)
    RAOPhaseConvention: lags
    RAOPhaseUnitsConvention: degrees
    RAOPhaseRelativeToConvention: crest
    SurgePositive: forward
    SwayPositive: port
    HeavePositive: up
    RollPositiveStarboard: down
    PitchPositiveBow: down
    YawPositiveBow: port
    Symmetry: XZ plane
    Draughts:
      - Name: Draught
        DisplacementRAOs:
          RAOOrigin: [0, 0, 5.5]
          PhaseOrigin: [~, ~, ~]
          RAOs:
            - RAODirection: 0
              RAOPeriodOrFrequency, RAOSurgeAmp, RAOSurgePhase, RAOSwayAmp, RAOSwayPhase, RAOHeaveAmp, RAOHeavePhase, RAORollAmp, RAORollPhase, RAOPitchAmp, RAOPitchPhase, RAOYawAmp, RAOYawPhase:
                - [4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]
                - [9, 0.5, 90, 0, 0, 0.6, 10, 0, 0, 1.2, -90, 0, 0]
                - [20, 1, 90, 0, 0, 1, 0, 0, 0, 0.9, -90, 0, 0]
            - RAODirection: 180
              RAOPeriodOrFrequency, RAOSurgeAmp, RAOSurgePhase, RAOSwayAmp, RAOSwayPhase, RAOHeaveAmp, RAOHeavePhase, RAORollAmp, RAORollPhase, RAOPitchAmp, RAOPitchPhase, RAOYawAmp, RAOYawPhase:
                - [4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]
                - [9, 0.5, 90, 0, 0, 0.6, 10, 0, 0, 1.2, -90, 0, 0]
                - [20, 1, 90, 0, 0, 1, 0, 0, 0, 0.9, -90, 0, 0]
"""  # noqa: E501


@cache
def tables() -> dict[str, str]:
    """Every fourth direction and few frequencies of the gallery's table; OrcaFlex's."""
    path = kingpost.gallery.folder() / "hydro" / "supply_boat.raos.csv"
    title, heads, *rows = path.read_text(encoding="utf-8").splitlines()
    ways = list(dict.fromkeys(row.partition(",")[0] for row in rows))[::4]
    kept = [row for way in ways for row in [row for row in rows if row.partition(",")[0] == way][2::7]]
    csv = "\n".join([title, heads, *kept]) + "\n"
    by_period = csv.replace("frequency_rad_s", "period_s")
    return {"ship.raos.csv": csv, "period.csv": by_period, "ship.yml": ORCAFLEX}


def drawn(draw: random.Random) -> Case:
    """Draw a wrong table, rarely with wrong fields of the joint."""
    name = draw.choice(["ship.raos.csv", "ship.raos.csv", "period.csv", "ship.yml"])
    content = encoded(draw, damaged(draw, tables()[name], TABLE_WAYS))
    scenario = SCENARIO.replace("RAOS", name)
    if draw.random() < 0.1:
        scenario = damaged(draw, scenario)
    return Case("rao_tables", {name: content, "case.yaml": encoded(draw, scenario)})


def use(case: Case, folder: Path) -> str:
    """Move a ship by the table for a few steps."""
    simulation = kingpost.Simulation(kingpost.load(folder / "case.yaml"))
    try:
        simulation.step(3)
    except kingpost.RunError as error:
        return f"ended early: {error}"
    return "ran"

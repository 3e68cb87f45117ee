"""A ship that is moved by the displacement RAOs of one that floats."""

from __future__ import annotations

from pathlib import Path

import kingpost
import numpy as np
import pytest
from kingpost.analysis import displacement_raos
from kingpost.cli import main
from lanes import THOROUGH

SEA = {"significant_height_m": 0.01, "peak_period_s": 9, "gamma": 1, "direction_rad": 2.4,
       "realisation": {"components": 60}}  # fmt: skip
HEADING_DEG = 20
# The crane stands still, and the load as good as fixed to it. Roll is damped more, so that a table follows
# its resonance.
STILL = {
    "forces.bilge_keels.viscous_damping.angular_N_m_s": [8e7, 0, 0],
    "bodies.pedestal.joint.revolute.mode": "held",
    "bodies.load.joint.universal.first.damping_kN_m_s": 1e5,
    "bodies.load.joint.universal.second.damping_kN_m_s": 1e5,
    "bodies.hull.joint.floating.initial.orientation_deg": [0, 0, HEADING_DEG],
    "simulation.duration_s": 600,
    "simulation.record_every_s": 0.5,
    "sea.ramp_s": 60,
}
MOVED = """
version: 1
title: A ship moved by its RAOs
simulation: {step_s: 0.05, duration_s: 600, record_every_s: 0.5}
sea: {ramp_s: 60, waves: {}}
bodies:
  hull:
    mass_t: 5434
    inertia: {radii_of_gyration: {radii_m: [6.8, 20, 20]}}
    centre_of_mass_m: [-2.55, 0, 6.5]
    joint: {moved_by_waves: {raos: ship.csv, origin_m: [0, 0, 5.5]}}
forces: {gravity: {gravity: {}}}
"""


def turned(run, angle: str) -> np.ndarray:
    return run[angle].sel(body="hull").values


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """With the RAOs of the gallery's vessel, by the command line."""
    folder = tmp_path_factory.mktemp("raos")
    directions = [str(angle) for angle in range(0, 360, 10 if THOROUGH else 90)]
    settings = [part for name, value in STILL.items() for part in ("--set", f"{name}={value}")]
    table = str(folder / "ship.csv")
    command = ["rao", "offshore_vessel", *settings, "--points", "hull", "--directions-deg", *directions]
    grid = ["--frequencies-rad-s", "0.1:2.6:400" if THOROUGH else "0.1:2.6:40"]
    assert main([*command, *grid, "--displacement-raos", table]) == 0
    (folder / "moved.yaml").write_text(MOVED)
    return folder


@pytest.mark.thorough
def test_a_body_moved_by_displacement_raos_moves_as_the_floating_ship(folder: Path) -> None:
    """Source: the engine in time on the linear model, in the same irregular sea, so low that it is linear.
    The table is linear between directions 10 degrees apart, over which responses turn by some per cent."""
    sea = {"sea.waves": {"wind_sea": {"jonswap": SEA}}}
    floats = kingpost.run("offshore_vessel", STILL | sea | {"waves": True})
    place = floats.position.sel(body="hull").values[0]
    joint = "bodies.hull.joint.moved_by_waves"
    # The origin of the data lies 2.55 m ahead of the hull's centre of mass.
    heading = np.deg2rad(HEADING_DEG)
    origin = [place[0] + 2.55 * np.cos(heading), place[1] + 2.55 * np.sin(heading), 0]
    put = {f"{joint}.heading_rad": heading, f"{joint}.position_m": origin}
    moves = kingpost.run(folder / "moved.yaml", put | sea)
    after = floats.time.values > 300
    for angle in ("roll", "pitch"):
        free, moved = turned(floats, angle)[after], turned(moves, angle)[after]
        free, moved = free - free.mean(), moved - moved.mean()
        assert np.std(free - moved) < 0.03 * np.std(free), angle
    free = floats.position.sel(body="hull", axis="z").values[after]
    moved = moves.position.sel(body="hull", axis="z").values[after]
    assert np.std((free - free.mean()) - (moved - moved.mean())) < 0.03 * np.std(free)


def test_the_heave_of_a_body_moved_by_waves_is_in_metres(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    swell = "waves: {swell: {regular: {height_m: 2, period_s: 9, direction_deg: 150}}}"
    (folder / "swell.yaml").write_text(MOVED.replace("waves: {}", swell).replace("600", "10"))
    assert main(["run", str(folder / "swell.yaml")]) == 0
    lines = capsys.readouterr().out.splitlines()
    units = {line.split()[0]: line.split()[3] for line in lines if line.startswith("hull.")}
    lengths, turns = {"hull.x": "m", "hull.y": "m", "hull.z": "m"}, ("yaw", "pitch", "roll")
    assert units == lengths | {f"hull.{turn}": "deg" for turn in turns}


def test_a_table_of_raos_states_the_wave_directions_and_the_body(folder: Path) -> None:
    text = (folder / "ship.csv").read_text()
    assert text.startswith("# Offshore vessel with a pedestal crane: displacement RAOs")
    assert "direction_to_deg,frequency_rad_s,surge_forward_m_per_m,surge_lag_deg" in text
    found = kingpost.rao("barge", [0.0], [0.5], ["ship"])
    table = displacement_raos.displacement_raos(found)
    assert table.columns[2:].size == 12
    with pytest.raises(kingpost.KingpostError, match="body: found 'tower', allowed: ship"):
        displacement_raos.displacement_raos(found, "tower")

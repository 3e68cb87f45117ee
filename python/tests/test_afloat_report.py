"""Report of `kingpost run` on a floating ship."""

from __future__ import annotations

import kingpost
import numpy as np
import pytest
from kingpost.cli import main
from kingpost.reports import afloat as afloat_report
from kingpost.reports import run as report

MOORED = """\
version: 1
title: a moored barge
simulation: {step_s: 0.05, duration_s: 90, record_every_s: 0.25, begin_at_equilibrium: true}
sea:
  ramp_s: 10
  waves: {swell: {regular: {height_m: 0.4, period_s: 6, direction_deg: 180}}}
bodies:
  hull:
    mass_t: 410
    centre_of_mass_m: [0, 0, 2.5]
    inertia: {radii_of_gyration: {radii_m: [3.2, 6, 6.5]}}
    joint: {floating: {initial: {position_m: [0, 0, 0.5]}}}
forces:
  gravity: {gravity: {}}
  water: {hydrodynamics: {body: hull, database: barge.hydro.json, origin_m: [0, 0, 2]}}
  bow: {spring_line: {first: {body: hull, position_m: [10, 0, 5]}, second: {body: world, position_m: [40, 0, 3]}, unstretched_length_m: 29.9, axial_stiffness_kN: 600}}
  stern: {spring_line: {first: {body: hull, position_m: [-10, 0, 5]}, second: {body: world, position_m: [-40, 0, 3]}, unstretched_length_m: 29.9, axial_stiffness_kN: 600}}
"""  # noqa: E501


@pytest.fixture(scope="module")
def moored(tmp_path_factory: pytest.TempPathFactory) -> kingpost.Scenario:
    folder = tmp_path_factory.mktemp("moored")
    database = kingpost.gallery.folder() / "hydro" / "barge.hydro.json"
    (folder / "barge.hydro.json").write_text(database.read_text())
    (folder / "moored.yaml").write_text(MOORED)
    return kingpost.load(folder / "moored.yaml")


def test_a_moored_ship_in_waves_is_reported_with_numbers(moored) -> None:
    """Source: the results; of a regular wave of height H four deviations are sqrt(2) H."""
    results = kingpost.run(moored)
    shown = afloat_report.text(results, moored)
    rows = {line.split()[0]: line.split()[1:] for line in shown.splitlines() if line}
    assert float(rows["water"][0]) == pytest.approx(np.sqrt(2) * 0.4, rel=0.02)
    tension = results.line_tension.sel(line="bow").values
    (line,) = (
        line
        for line in report.summary(results, moored).splitlines()
        if line.startswith("bow") and "first end" in line
    )
    assert [1e3 * float(word) for word in line.split()[-4:-1]] == pytest.approx(
        [tension[-1], tension.min(), tension.max()], rel=1e-4
    )
    assert line.endswith("  kN")
    height = results.position.sel(body="hull", axis="z").values
    assert float(rows["hull"][1]) == pytest.approx(height.max() - height[0], abs=6e-5)
    assert "warning" not in shown


def test_a_load_that_capsizes_the_ship_gives_a_warning(tmp_path, capsys) -> None:
    """Source: 500 t over the side of a ship with a GM of 1.4 m."""
    settings = ["bodies.load.mass_t=500", "simulation.duration_s=40", "simulation.begin_at_equilibrium=false"]
    settings = [f"--set={setting}" for setting in settings]
    file = str(tmp_path / "run.csv")
    assert main(["run", "offshore_vessel", *settings, "-o", file]) == 0
    shown = capsys.readouterr()
    assert "warning: hull: it heeled to " in shown.err
    assert "replaces an older file" not in shown.out
    assert main(["run", "offshore_vessel", "--set=simulation.duration_s=1", "-o", file]) == 0
    shown = capsys.readouterr()
    assert shown.err == ""
    assert f"written         {file}, replaces an older file" in shown.out


def test_a_run_on_land_has_no_report_of_the_sea() -> None:
    scenario = kingpost.load("chain", {"simulation.duration_s": 0.1})
    assert afloat_report.text(kingpost.run(scenario), scenario) == ""

"""Use in notebooks: `ds.kingpost`, tables for the value of a cell, editing, time histories."""

from __future__ import annotations

import subprocess
import sys
from xml.etree import ElementTree

import kingpost
import numpy as np
import pytest
from kingpost import results
from kingpost.cli import main

LIMIT = {"limits": {"heel": {"column": "ship.roll", "within": 1, "unit": "deg"}}}


@pytest.fixture(scope="module")
def recorded():
    """A second of the paper's ship, with a limit that does not hold."""
    return kingpost.run("paper", {"simulation.duration_s": 1.0, **LIMIT})


def cells(html: str) -> list[str]:
    """Texts of the cells, by a parser of its own: the page is well-formed."""
    return ["".join(cell.itertext()) for cell in ElementTree.fromstring(f"<p>{html}</p>").iter("td")]


def test_a_column_by_name_equals_that_of_the_flat_table(recorded) -> None:
    """Source: the table that CSV files hold."""
    flat = results.frame(recorded)
    assert recorded.kingpost.columns == [name for name in flat if name != "time"]
    for name in ("ship.roll", "slew.joint_reaction.moment_z", "kinetic_energy"):
        found = recorded.kingpost[name]
        np.testing.assert_array_equal(found.values, flat[name])
        assert found.attrs["units"] == results.unit_of(found)
    parts = recorded.kingpost["arm.tip", "point_position", "z"]
    np.testing.assert_array_equal(parts.values, flat["arm.tip.point_position.z"])


def test_an_unknown_column_is_refused_with_similar_names(recorded) -> None:
    with pytest.raises(kingpost.KingpostError, match=r"found 'ship\.rol', allowed: .*ship\.roll"):
        recorded.kingpost["ship.rol"]


def test_a_time_history_has_the_records_of_its_period(recorded) -> None:
    """Source: the times themselves; both ends count."""
    found = recorded.kingpost.time_history("ship.roll", (0.25, 0.5))
    assert (found.time.values[[0, -1]] == [0.25, 0.5]).all()
    assert found.sizes["time"] == 26
    with pytest.raises(kingpost.KingpostError, match="period_s: found 3 to 4, allowed: within 0 to 1 s"):
        recorded.kingpost.time_history("ship.roll", (3, 4))


def test_a_simulation_gives_time_histories_of_its_run() -> None:
    simulation = kingpost.Simulation(kingpost.load("paper", {"simulation.duration_s": 0.5}))
    with pytest.raises(kingpost.KingpostError, match="found no run"):
        simulation.time_history("ship.roll")
    found = simulation.run()
    np.testing.assert_array_equal(simulation.time_history("ship.roll"), found.kingpost["ship.roll"])


def test_the_accessor_has_the_statistics_and_the_picture_of_the_command_line(
    recorded, tmp_path, capsys
) -> None:
    """Source: the command on the file of the same run."""
    path = results.write(recorded, tmp_path / "run.nc")
    assert main(["statistics", str(path), "--channels", "ship.*", "-o", str(tmp_path / "table.csv")]) == 0
    lines = (tmp_path / "table.csv").read_text().splitlines()
    table = recorded.kingpost.statistics("ship.*")
    assert lines[0].split(",") == list(table)
    assert [line.split(",")[0] for line in lines[1:]] == table["channel"].tolist()
    read = results.read(path)
    assert read.kingpost.statistics("ship.*").equals(table)
    assert [axes.get_ylabel() for axes in read.kingpost.plot("ship.roll").axes] == ["deg"]


def test_a_cell_shows_a_run_with_its_limits_and_its_statistics(recorded) -> None:
    found = cells(recorded.kingpost._repr_html_())
    assert found[found.index("heel") + 1] == "NO"
    assert "ship.roll" in found
    assert "finished" in found


def test_a_cell_shows_a_scenario_and_a_simulation() -> None:
    scenario = kingpost.load("paper", crane_x_m=5)
    found = cells(scenario._repr_html_())
    assert found[found.index("crane_x_m") + 1] == "5"
    simulation = kingpost.Simulation("slew_and_land")
    found = cells(simulation._repr_html_())
    assert set(simulation.coordinates) | set(simulation.inputs) <= set(found)


def test_a_scenario_is_edited_by_the_names_of_the_command_line() -> None:
    """Source: `--set`, whose overrides are those of `load`."""
    scenario = kingpost.load("paper")
    before = kingpost.Simulation(scenario)
    scenario["bodies.ship.mass_kg"] = 32000
    scenario["crane_x_m"] = 5
    assert scenario["bodies.ship.mass_kg"] == 32000
    assert scenario["crane_x_m"] == scenario.parameters["crane_x_m"] == 5
    same = kingpost.load("paper", {"bodies.ship.mass_kg": 32000, "crane_x_m": 5})
    assert scenario == same
    assert scenario.resolved == same.resolved
    # What was made of it before stays.
    assert before.scenario["bodies.ship.mass_kg"] == kingpost.load("paper")["bodies.ship.mass_kg"]


def test_a_wrong_edit_is_refused_with_its_place_and_changes_nothing() -> None:
    scenario = kingpost.load("paper")
    with pytest.raises(kingpost.ScenarioError, match="found -5, allowed: a number greater than 0"):
        scenario["bodies.ship.mass_kg"] = -5
    assert scenario == kingpost.load("paper")
    with pytest.raises(kingpost.KingpostError, match=r"found no shape_of in bodies\.ship, allowed: "):
        scenario["bodies.ship.shape_of"]


@pytest.mark.parametrize("first", ["kingpost", "xarray"])
def test_the_accessor_is_available_however_a_file_is_opened_first(first, recorded, tmp_path) -> None:
    path = results.write(recorded, tmp_path / "run.nc")
    program = {
        "kingpost": f"import kingpost; ds = kingpost.results.read({str(path)!r})",
        "xarray": "import xarray; import kingpost; "
        f"ds = xarray.open_dataset({str(path)!r}, engine='h5netcdf')",
    }[first]
    done = subprocess.run(
        [sys.executable, "-c", f"{program}; print(ds.kingpost['ship.roll'].size)"],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert done.stdout == "101\n"


def test_a_notebook_shows_a_run_that_ends_before_the_ramp() -> None:
    assert "Columns" in kingpost.run("barge", {"simulation.duration_s": 5}).kingpost._repr_html_()


def test_membership_in_a_scenario_is_by_parameter_or_path() -> None:
    scenario = kingpost.load("barge")
    assert "waves" in scenario
    assert "bodies.ship.mass_t" not in scenario
    assert "no_such_name" not in scenario
    with pytest.raises(TypeError, match="not iterable"):
        list(scenario)

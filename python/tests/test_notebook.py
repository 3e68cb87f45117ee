"""Use in notebooks: `ds.kingpost`, tables and pictures for the value of a cell, editing, time histories."""

from __future__ import annotations

import base64
import io
import os
import re
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import kingpost
import numpy as np
import pytest
from kingpost import gallery, link, results
from kingpost.cli import main
from kingpost.pictures import use_app
from kingpost.pictures.notebook import CELL_PX
from matplotlib.image import imread
from test_link import unpacked

CELL = Path(__file__).resolve().parents[2] / "web" / "tests" / "browser" / "notebook_cell.html"
"""A cell of a notebook, without the still."""
RUN = re.compile(r"#k1=[\w.-]+")
"""The part of an address that holds a run."""
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


def image_in(html: str) -> np.ndarray:
    """Pixels of the picture in a cell, from its data."""
    found = ElementTree.fromstring(f"<p>{html}</p>").find("figure/img")
    assert found is not None
    data = found.attrib["src"].removeprefix("data:image/png;base64,")
    read = imread(io.BytesIO(base64.b64decode(data)))
    return (read[..., :3] * 255).round().astype(np.uint8)


def test_a_cell_holds_the_picture_of_a_scenario_a_simulation_and_a_run(recorded) -> None:
    """Source: `kingpost.picture`; an exported page needs no other file."""
    scenario = kingpost.load("paper", {"simulation.duration_s": 1.0, **LIMIT})
    start = kingpost.picture(scenario, size_px=CELL_PX)
    for cell in (scenario._repr_html_(), recorded.kingpost._repr_html_()):
        assert np.array_equal(image_in(cell), start)
        addresses = re.findall(r'(?:src|href)="([^"]*)"', cell)
        assert all(address.startswith("data:image/png;base64,") for address in addresses)
    simulation = kingpost.Simulation(scenario)
    simulation.step(800)
    assert np.array_equal(image_in(simulation._repr_html_()), kingpost.picture(simulation, size_px=CELL_PX))
    assert "at 0.8 s" in simulation._repr_html_()


def test_a_cell_is_a_figure_of_the_app_that_is_named_with_the_still_within() -> None:
    """Source: the link that `kingpost.link` makes of the scenario."""
    scenario = kingpost.load("paper", crane_x_m=3)
    assert "<a " not in scenario._repr_html_()
    assert "<script" not in scenario._repr_html_()
    use_app("http://127.0.0.1:8000")
    try:
        cell = ElementTree.fromstring(f"<p>{scenario._repr_html_()}</p>")
    finally:
        use_app(None)
    run, app = link.fragment(scenario), "http://127.0.0.1:8000/"
    script, played = cell.find("figure/script"), cell.find("figure/kingpost-figure")
    opened = cell.find("figure/figcaption/a")
    assert script is not None
    assert played is not None
    assert opened is not None
    assert script.attrib["src"] == f"{app}kingpost-figure.js"
    assert played.attrib == {"src": app, "run": run}
    assert opened.attrib["href"] == app + run
    still = played.find("img")
    assert still is not None
    assert still.attrib["src"].startswith("data:image/png;base64,")


def test_the_cell_that_the_browser_plays_is_the_one_of_today() -> None:
    """Source: web/tests/browser/figure.mjs opens the file, as an export of a notebook shows it. Compressors
    may differ in their bytes, not in what they hold. KINGPOST_WRITE_PAGES=1 writes the file."""
    scenario = kingpost.load("paper", load=True, torque_history="pulse")
    use_app("http://app.example")
    try:
        shown = scenario._repr_html_().partition("</figure>")[0]
    finally:
        use_app(None)
    cell = re.sub(r"data:image/png;base64,[^\"]*", "data:,", shown) + "</figure>\n"
    if os.environ.get("KINGPOST_WRITE_PAGES"):
        CELL.write_text(cell, encoding="utf-8")
    kept = CELL.read_text(encoding="utf-8")
    assert RUN.sub("", kept) == RUN.sub("", cell)
    assert [unpacked(run) for run in RUN.findall(kept)] == [unpacked(run) for run in RUN.findall(cell)]


@pytest.mark.parametrize("address", ["javascript:alert(1)", "127.0.0.1:8000", 'http://a/"><b>', 8000])
def test_an_address_of_another_kind_is_refused(address) -> None:
    with pytest.raises(
        kingpost.KingpostError, match=r"address: found .*, allowed: an address such as http://"
    ):
        use_app(address)


def test_a_batch_and_a_run_of_a_changed_file_have_tables_without_a_picture(tmp_path) -> None:
    batch = kingpost.Batch("paper", {"crane_x_m": [0, 1]}, {"simulation.duration_s": 0.1}).run()
    assert "<figure" not in batch.kingpost._repr_html_()
    hull = (gallery.folder() / "hydro" / "sphere.hydro.json").read_text(encoding="utf-8")
    (tmp_path / "mine.hydro.json").write_text(hull, encoding="utf-8")
    path = tmp_path / "mine.yaml"
    text = kingpost.load("sphere_decay").text
    path.write_text(text.replace("gallery:hydro/sphere.hydro.json", "mine.hydro.json"), encoding="utf-8")
    run = kingpost.run(path, {"simulation.duration_s": 0.1})
    assert "<figure" in run.kingpost._repr_html_()
    (tmp_path / "mine.hydro.json").write_text(hull + "\n", encoding="utf-8")
    assert "<figure" not in run.kingpost._repr_html_()
    assert "<table" in run.kingpost._repr_html_()


def test_a_title_is_text_in_the_caption() -> None:
    scenario = kingpost.load("paper", {"title": "<script>alert(1)</script>"})
    assert "<script" not in scenario._repr_html_()

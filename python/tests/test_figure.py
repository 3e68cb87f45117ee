"""`kingpost figure`: the folder, its page as a browser reads it, and wrong input."""

from __future__ import annotations

import json
from html.parser import HTMLParser
from pathlib import Path

import kingpost
import numpy as np
import pytest
from kingpost import gallery
from kingpost.cli import main
from kingpost.figures import folder as figures
from kingpost.server import serve
from matplotlib.image import imread
from samples import SMALL
from served import made_app


@pytest.fixture
def app(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A stand-in for the built app, with the files of figures."""
    built = made_app(tmp_path / "built")
    (built / figures.PAGE).write_text("<!doctype html>")
    (built / figures.ELEMENT).write_text("customElements;")
    monkeypatch.setattr(serve, "app_folder", lambda: built)
    monkeypatch.setattr(figures, "STILL_PX", (160, 100))
    return built


class Elements(HTMLParser):
    """Tags of a page with their attributes."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.found: dict[str, dict[str, str | None]] = {}
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found[tag] = dict(attrs)


def test_a_folder_has_the_page_the_still_the_scenario_and_the_app(app, tmp_path, capsys) -> None:
    to = tmp_path / "figure"
    given = ["figure", "barge", "-o", str(to), "--set", "simulation.duration_s=5"]
    options = [
        "--controls",
        "waves",
        "--plot",
        "ship.roll",
        "ship.position.z",
        "--time",
        "2",
        "--camera",
        "top",
    ]
    assert main([*given, *options, "--caption", 'A "load" of 3 t & more']) == 0
    assert str(to / "index.html") in capsys.readouterr().out
    page = Elements((to / "index.html").read_text(encoding="utf-8")).found
    assert page["kingpost-figure"] == {
        "src": "app/",
        "scenario": "barge.json",
        "controls": "waves",
        "plot": "ship.roll, ship.position.z",
        "camera": "top",
        "caption": 'A "load" of 3 t & more',
    }
    for address in (page["script"]["src"], page["img"]["src"], page["kingpost-figure"]["scenario"]):
        assert (to / str(address)).is_file()
    assert (to / "app" / "assets" / "engine.wasm").read_bytes() == (
        app / "assets" / "engine.wasm"
    ).read_bytes()
    drawn = kingpost.picture(
        kingpost.load("barge", {"simulation.duration_s": 5}), 2.0, camera="top", size_px=(160, 100)
    )
    assert np.array_equal((imread(to / "still.png")[..., :3] * 255).round().astype(np.uint8), drawn)


def test_the_scenario_of_a_figure_runs_to_the_same_bits(app, tmp_path) -> None:
    """Source: the run of the scenario with its overrides."""
    overrides = {"simulation.duration_s": 1.0, "simulation.seed": 7}
    scenario = kingpost.load("knuckle_boom_crane", overrides)
    figures.write(scenario, tmp_path / "figure", figures.Choice())
    read = kingpost.load(tmp_path / "figure" / "knuckle_boom_crane.json")
    # Parts are in the one file.
    assert read.files == {}
    assert kingpost.run(read).equals(kingpost.run(scenario))


def test_files_that_a_scenario_names_are_beside_it_or_in_the_app(app, tmp_path) -> None:
    source = tmp_path / "ships"
    (source / "waters").mkdir(parents=True)
    database = (gallery.folder() / "hydro" / "sphere.hydro.json").read_text(encoding="utf-8")
    (source / "waters" / "mine.hydro.json").write_text(database, encoding="utf-8")
    text = kingpost.load("sphere_decay").text.replace(
        "gallery:hydro/sphere.hydro.json", "waters/mine.hydro.json"
    )
    (source / "mine.yaml").write_text(text, encoding="utf-8")
    to = tmp_path / "figure"
    figures.write(kingpost.load(source / "mine.yaml"), to, figures.Choice())
    assert (to / "waters" / "mine.hydro.json").read_text(encoding="utf-8") == database
    assert kingpost.load(to / "mine.json").hydrostatics["hulls"]
    figures.write(kingpost.load("offshore_vessel"), tmp_path / "other", figures.Choice())
    assert (tmp_path / "other" / "app" / "scenarios" / "hydro" / "offshore_vessel.hydro.json").is_file()


def test_an_app_elsewhere_is_named_and_not_copied(app, tmp_path) -> None:
    assert main(["figure", "paper", "-o", str(tmp_path / "figure"), "--app", "../../app"]) == 0
    page = Elements((tmp_path / "figure" / "index.html").read_text(encoding="utf-8")).found
    assert page["script"]["src"] == "../../app/kingpost-figure.js"
    assert page["kingpost-figure"]["src"] == "../../app/"
    assert sorted(path.name for path in (tmp_path / "figure").iterdir()) == [
        "index.html",
        "paper.json",
        "still.png",
    ]


def test_a_folder_is_written_anew_and_other_files_stay(app, tmp_path) -> None:
    to = tmp_path / "figure"
    assert main(["figure", "paper", "-o", str(to)]) == 0
    (to / "notes.txt").write_text("mine")
    (to / "app" / "older.js").write_text("")
    assert main(["figure", "paper", "-o", str(to), "--time", "1"]) == 0
    assert (to / "notes.txt").read_text() == "mine"
    assert not (to / "app" / "older.js").exists()


def test_titles_and_descriptions_are_text_on_the_page(app, tmp_path) -> None:
    path = tmp_path / "small.yaml"
    path.write_text(SMALL.replace("A box with a boom", "'<script>alert(1)</script>'"), encoding="utf-8")
    figures.write(kingpost.load(path), tmp_path / "figure", figures.Choice())
    text = (tmp_path / "figure" / "index.html").read_text(encoding="utf-8")
    assert "<script>alert" not in text
    assert "&lt;script&gt;alert" in text


@pytest.mark.parametrize(
    ("options", "says"),
    [
        (["--controls", "crane_x"], "--controls: found 'crane_x', allowed: such as crane_x_m"),
        (["--plot", "ship.rol"], "--plot: found 'ship.rol', allowed: such as ship.roll"),
        (
            ["--camera", "crow"],
            "--camera: found 'crow', allowed: free, load, cab, bridge, top, section, or six",
        ),
        (["--time", "4"], "time_s: found 4, allowed: 0 to 3"),
        (["--set", "nothing=1"], "nothing"),
    ],
)
def test_wrong_options_are_refused_before_anything_is_written(app, options, says, tmp_path, capsys) -> None:
    assert main(["figure", "paper", "-o", str(tmp_path / "figure"), *options]) == 2
    assert says in capsys.readouterr().err
    assert not (tmp_path / "figure" / "index.html").exists()


def test_an_unknown_scenario_is_refused_with_the_nearest(app, tmp_path, capsys) -> None:
    assert main(["figure", "papr", "-o", str(tmp_path / "figure")]) == 2
    assert "did you mean 'paper'?" in capsys.readouterr().err


def test_an_app_without_figures_is_refused_with_the_build_command(app, tmp_path, capsys) -> None:
    (app / figures.ELEMENT).unlink()
    assert main(["figure", "paper", "-o", str(tmp_path / "figure")]) == 2
    error = capsys.readouterr().err
    assert "found no kingpost-figure.js" in error
    assert "make web" in error


def test_a_folder_with_another_app_is_refused(app, tmp_path, capsys) -> None:
    (tmp_path / "figure" / "app").mkdir(parents=True)
    (tmp_path / "figure" / "app" / "mine.txt").write_text("mine")
    assert main(["figure", "paper", "-o", str(tmp_path / "figure")]) == 2
    assert "found other files than those of the app" in capsys.readouterr().err
    assert (tmp_path / "figure" / "app" / "mine.txt").read_text() == "mine"


def test_the_resolved_scenario_is_json(app, tmp_path) -> None:
    figures.write(kingpost.load("paper", motor_2=True), tmp_path / "figure", figures.Choice())
    read = json.loads((tmp_path / "figure" / "paper.json").read_text(encoding="utf-8"))
    assert read["drives"]["motor_2"]["motor"]["enabled"] is True

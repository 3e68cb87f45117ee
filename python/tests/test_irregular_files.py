"""Irregular files and links: as a scenario, as an output and within the gallery."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from kingpost import gallery
from kingpost.cli import main
from kingpost.errors import KingpostError, ScenarioError
from kingpost.hydro import database_file, hull_files, importers
from kingpost.learn import network
from kingpost.results import files as results_files
from kingpost.roll_damping import sections
from kingpost.study.sea_states import scatter, series_file

pytestmark = pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs POSIX pipes and links")
SHORT = ["run", "paper", "--set", "simulation.duration_s=0.01", "-q", "-o"]


def test_an_output_onto_a_pipe_is_refused_at_once(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Source: opening a pipe waits until another process reads it."""
    pipe = tmp_path / "pipe.csv"
    os.mkfifo(pipe)
    assert main([*SHORT, str(pipe)]) == 2
    assert capsys.readouterr().err == f"error: {pipe}: found a pipe, allowed: a regular file\n"
    assert pipe.is_fifo()


def test_an_output_onto_a_symbolic_link_is_written_to_its_target(tmp_path: Path) -> None:
    kept, link = tmp_path / "kept.csv", tmp_path / "link.csv"
    kept.write_text("old")
    link.symlink_to(kept)
    assert main([*SHORT, str(link)]) == 0
    assert link.is_symlink()
    assert kept.read_text().startswith("time")


@pytest.mark.parametrize("make", [os.mkfifo, os.mkdir])
def test_a_scenario_in_an_irregular_file_is_refused(make, tmp_path: Path, capsys) -> None:
    path = tmp_path / "odd.yaml"
    make(path)
    assert main(["check", str(path)]) == 2
    words = "found a pipe, allowed: a regular file" if path.is_fifo() else "is a folder, not a scenario file"
    assert words in capsys.readouterr().err


def test_a_device_as_a_scenario_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", "/dev/zero"]) == 2
    assert "/dev/zero: found a device, allowed: a regular file" in capsys.readouterr().err


@pytest.mark.parametrize(
    "name", ["gallery:../pyproject.toml", "gallery:/etc/passwd", "gallery:parts/../../x"]
)
def test_a_name_of_the_gallery_stays_in_the_gallery(name: str) -> None:
    with pytest.raises(ScenarioError, match="allowed: a file of the gallery"):
        gallery.place("a.yaml", name)


def test_a_link_to_a_scenario_finds_the_files_beside_the_scenario(tmp_path: Path) -> None:
    there, here = tmp_path / "there", tmp_path / "here"
    there.mkdir()
    here.mkdir()
    (there / "own.yaml").write_text("x")
    (there / "a.yaml").write_text("x")
    (here / "link.yaml").symlink_to(there / "a.yaml")
    assert gallery.place(here / "link.yaml", "own.yaml") == there / "own.yaml"


READERS = {
    "series": (series_file.read, ".csv"),
    "NetCDF series": (series_file.read, ".nc"),
    "scatter table": (scatter.read, ".csv"),
    "roll damping": (sections.read_columns, ".csv"),
    "database": (database_file.read, ".hydro.json"),
    "GDF": (hull_files.read, ".gdf"),
    "OBJ": (hull_files.read, ".obj"),
    "STL": (hull_files.read, ".stl"),
    "policy": (network.read_policy, ".json"),
    "results": (lambda path: results_files.open_all([path]), ".nc"),
    **{f"import {ending}": (importers.load, ending) for ending in importers.ENDINGS},
}


@pytest.mark.parametrize(("read", "ending"), READERS.values(), ids=READERS)
def test_a_pipe_is_refused_by_each_reader(read, ending: str, tmp_path: Path) -> None:
    """Source: opening a pipe waits until another process writes it."""
    pipe = tmp_path / f"pipe{ending}"
    os.mkfifo(pipe)
    with pytest.raises(KingpostError, match="a pipe"):
        read(pipe)

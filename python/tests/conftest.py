"""Fixtures of several tests: one run of the paper's case, one small scenario, a server of the app."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

# The tests' panel methods are small: threads that wait for each other make them several times as slow.
# Read when the libraries of linear algebra are loaded.
os.environ.setdefault("OMP_NUM_THREADS", "1")

import kingpost
import pytest
from gallery_pass import Gallery
from kingpost.server import serve
from lanes import THOROUGH
from samples import CALIBRATION, SMALL
from served import made_app, running

LONG = (
    "test_docs_run.py",
    "test_study_cluster.py",
    "test_study_resume.py",
    "test_hydro_demand.py",
    "test_hydro_importers.py",
    "test_seeds.py",
    "test_natural_modes.py",
    "test_gradients.py",
    "test_peers_bench.py",
)
"""Slowest files, which begin first: otherwise one would still run when the other processes have ended."""


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    if not THOROUGH:
        left_out = [item for item in items if item.get_closest_marker("thorough")]
        items[:] = [item for item in items if not item.get_closest_marker("thorough")]
        config.hook.pytest_deselected(items=left_out)
    items.sort(key=lambda item: LONG.index(item.path.name) if item.path.name in LONG else len(LONG))


def pytest_configure(config: pytest.Config) -> None:
    # Tests of warnings enable them.
    config.addinivalue_line("filterwarnings", "ignore::kingpost.KingpostWarning")


@pytest.fixture
def small(tmp_path: Path) -> Path:
    """A scenario file of two bodies, free to move."""
    path = tmp_path / "small.yaml"
    path.write_text(SMALL, encoding="utf-8")
    return path


@pytest.fixture(scope="session")
def calibration():
    """Results of the run on which three independent codes agree."""
    return kingpost.run("paper", CALIBRATION)


@pytest.fixture(scope="session")
def shown(tmp_path_factory: pytest.TempPathFactory) -> Gallery:
    """Results of one pass over the gallery, by scenario, shared by the processes of pytest-xdist."""
    folder = tmp_path_factory.getbasetemp()
    folder = (folder.parent if "PYTEST_XDIST_WORKER" in os.environ else folder) / "gallery"
    folder.mkdir(exist_ok=True)
    return Gallery(folder)


@pytest.fixture
def hang(tmp_path):
    """Writes a scenario of `samples.rod`s under gravity."""

    def write_rods(*rods: str, parameters: str = "") -> kingpost.Scenario:
        path = tmp_path / "rods.yaml"
        path.write_text(
            f"version: 1\ntitle: rods\n{parameters}simulation: {{step_s: 0.005, duration_s: 4}}\n"
            f"bodies:\n{''.join(rods)}forces:\n  gravity: {{gravity: {{}}}}\n",
            encoding="utf-8",
        )
        return kingpost.load(path)

    return write_rods


@pytest.fixture
def app(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A stand-in for the folder of a built app, with the same kinds of files."""
    folder = made_app(tmp_path)
    monkeypatch.setattr(serve, "app_folder", lambda: folder)
    return folder


@pytest.fixture(scope="session")
def address(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """Address of a server of the app with the gallery and one more scenario, common to all tests of a
    process."""
    folder = tmp_path_factory.mktemp("served")
    given = folder / "small.yaml"
    given.write_text(SMALL, encoding="utf-8")
    files, _ = serve.scenarios(str(given))
    yield from running(
        serve.open_server(made_app(folder), files, serve.LOOPBACK, 0, serve.databases(str(given)))
    )


@pytest.fixture
def own_address(app: Path) -> Iterator[str]:
    """Address of a server without scenarios, for an app that the test may change."""
    yield from running(serve.open_server(app, {}, serve.LOOPBACK, 0))

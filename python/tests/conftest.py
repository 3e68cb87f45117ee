"""What several tests share: one run of the paper's case, one small scenario."""

from __future__ import annotations

import os
from pathlib import Path

# The tests' panel methods are small: threads that wait for each other make them several times as slow.
# Read when the libraries of linear algebra are loaded.
os.environ.setdefault("OMP_NUM_THREADS", "1")

import kingpost
import pytest
from samples import CALIBRATION, SMALL


def pytest_configure(config: pytest.Config) -> None:
    # Tests of what is warned of ask for it.
    config.addinivalue_line("filterwarnings", "ignore::kingpost.KingpostWarning")


@pytest.fixture
def small(tmp_path: Path) -> Path:
    """A scenario file of two bodies, free to move."""
    path = tmp_path / "small.yaml"
    path.write_text(SMALL, encoding="utf-8")
    return path


@pytest.fixture(scope="session")
def calibration():
    """Results of the run that three independent codes agree on."""
    return kingpost.run("paper", CALIBRATION)


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

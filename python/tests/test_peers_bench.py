"""The benchmark script runs and prints machine-readable lines; speed is not tested."""

from __future__ import annotations

import importlib.util
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

# It compiles C++ and Rust.
pytestmark = pytest.mark.thorough

REPOSITORY = Path(__file__).resolve().parents[2]
SCRIPT = REPOSITORY / "benches" / "run.py"


def peers_here() -> set[str]:
    """Engines whose programs a quick run builds or finds on this machine; Pinocchio's is optional in it."""
    found = {"kingpost"} if shutil.which("cargo") else set()
    if shutil.which("g++") and importlib.util.find_spec("mujoco"):
        found.add("mujoco")
    return found


@pytest.fixture(scope="module")
def lines(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    """What a quick run prints."""
    if not peers_here():
        pytest.skip("neither cargo nor g++ with MuJoCo is installed")
    output = tmp_path_factory.mktemp("bench") / "bench.txt"
    command = [sys.executable, str(SCRIPT), "--quick", "-o", str(output)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert output.read_text() == done.stdout
    return done.stdout.splitlines()


def test_bench_prints_readable_lines(lines: list[str]) -> None:
    rows = [line.split("|") for line in lines if not line.startswith("#")]
    assert peers_here() <= {row[0] for row in rows}
    for _engine, model, operation, nanoseconds, instructions in rows:
        assert re.fullmatch("paper_free_load|chain_[0-9]+|offshore_vessel_[a-z]+|lift_over_sheave", model)
        assert re.fullmatch(
            "forward|euler_step|rk4_step(_ledger)?|lanes_(euler|rk4)|batch_(euler|rk4)_[12]", operation
        )
        # many runs at once are the difference of two times, so short that a busy machine can turn it
        assert operation.startswith("batch_") or float(nanoseconds) > 0.0
        assert instructions == "-" or float(instructions) > 0.0


def test_the_engines_of_the_bench_agree(lines: list[str]) -> None:
    agreements = [line for line in lines if line.startswith("# agreement")]
    assert len(agreements) >= len(peers_here()) - 1
    for line in agreements:
        limit = 1e-9 if "forward" in line else 1e-4
        assert float(line.split(": ")[-1].split()[0]) < limit, line


def test_instructions_grow_linearly_with_the_links_of_a_chain(lines: list[str]) -> None:
    """One more link takes as many instructions in a long chain as in a short one, within 2 %.

    What is left is in the branches of sine and cosine, which depend on each angle.
    """
    growth = [line for line in lines if line.startswith("# growth: kingpost,")]
    if not growth:
        pytest.skip("valgrind counts no instructions here")
    counts = [float(count.replace(",", "")) for count in re.findall(r"([0-9,]+) to", growth[0])]
    assert len(counts) == 2
    assert max(counts) < 1.02 * min(counts), growth


def test_the_bench_of_lines_prints_readable_lines() -> None:
    command = [sys.executable, str(SCRIPT.with_name("lines.py")), "--quick"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    rows = [line.split("|") for line in done.stdout.splitlines() if not line.startswith("#")]
    engines = {"kingpost", "moordyn"} if importlib.util.find_spec("moordyn") else {"kingpost"}
    assert {row[0] for row in rows} == engines
    assert {row[1] for row in rows} == {"wire", "moored_ship_lines", "moored_ship_catenaries"}
    for row in rows:
        assert all(float(number) > 0.0 for number in row[2:] if number != "-")

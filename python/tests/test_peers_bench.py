"""The benchmark script runs and prints what a script can read; how fast is no matter of a test."""

from __future__ import annotations

import importlib.util
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
SCRIPT = REPOSITORY / "benches" / "run.py"


def peers_here() -> set[str]:
    """Engines whose programs a quick run builds or finds on this machine; Pinocchio's is optional in it."""
    found = {"kingpost"} if shutil.which("cargo") else set()
    if shutil.which("g++") and importlib.util.find_spec("mujoco"):
        found.add("mujoco")
    return found


def test_bench_prints_readable_lines(tmp_path: Path) -> None:
    if not peers_here():
        pytest.skip("neither cargo nor g++ with MuJoCo is installed")
    output = tmp_path / "bench.txt"
    command = [sys.executable, str(SCRIPT), "--quick", "-o", str(output)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert output.read_text() == done.stdout
    rows = [line.split("|") for line in done.stdout.splitlines() if not line.startswith("#")]
    assert peers_here() <= {row[0] for row in rows}
    for _engine, model, operation, nanoseconds, instructions in rows:
        assert model == "paper_free_load"
        assert operation in {"forward", "rk4_step", "rk4_step_ledger"}
        assert float(nanoseconds) > 0.0
        assert instructions == "-" or float(instructions) > 0.0
    for line in done.stdout.splitlines():
        if line.startswith("# agreement"):
            limit = 1e-9 if "forward" in line else 1e-4
            assert float(line.split(": ")[-1].split()[0]) < limit, line

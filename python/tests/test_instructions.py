"""Instruction counts of the engine's operations compared with stored ones, to detect a loss of speed."""

from __future__ import annotations

import importlib.util
import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

BENCHES = Path(__file__).resolve().parents[2] / "benches"
MOST_MORE = 1.02
"""Sine and cosine branch on each angle: one build from another differs by less than this."""


@pytest.mark.thorough
@pytest.mark.skipif(
    shutil.which("valgrind") is None, reason="valgrind, which counts instructions, is not installed"
)
@pytest.mark.skipif(shutil.which("cargo") is None, reason="cargo is not installed")
@pytest.mark.skipif(
    importlib.util.find_spec("mujoco") is None, reason="the models are written by peers' translators"
)
def test_no_operation_takes_more_instructions_than_stored(tmp_path: Path) -> None:
    """Source: `python benches/run.py --counts benches/instructions.json`, which wrote the table."""
    counted = tmp_path / "instructions.json"
    command = [sys.executable, str(BENCHES / "run.py"), "--counts", str(counted)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    found, stored = (
        json.loads(path.read_text(encoding="utf-8")) for path in (counted, BENCHES / "instructions.json")
    )
    assert {model: set(counts) for model, counts in found.items()} == {
        model: set(counts) for model, counts in stored.items()
    }
    more = {
        (model, operation): (count, stored[model][operation])
        for model, counts in found.items()
        for operation, count in counts.items()
        if count > MOST_MORE * stored[model][operation]
    }
    assert not more

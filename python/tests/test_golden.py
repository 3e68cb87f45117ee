"""The golden runs, bit for bit: those of the native tests, through Python."""

from __future__ import annotations

import json
from pathlib import Path

import kingpost
import numpy as np
import pytest

FOLDER = Path(__file__).resolve().parents[2] / "crates/kingpost/tests/golden"
GOLDEN = {
    (path.stem, one["name"]): one
    for path in sorted(FOLDER.glob("*.json"))
    if path.suffixes == [".json"]
    for one in json.loads(path.read_text(encoding="utf-8"))
}


@pytest.mark.parametrize("case", GOLDEN, ids="-".join)
def test_the_golden_rows_equal_the_native_run_bit_for_bit(case) -> None:
    """Source: `cargo run -p kingpost --example write_golden`."""
    golden = GOLDEN[case]
    simulation = kingpost.Simulation(kingpost.load(case[0], golden["overrides"]))
    simulation.step(golden["steps"])
    expected = np.array(golden["row"], float)
    assert simulation.row().view(np.uint64).tolist() == expected.view(np.uint64).tolist()

"""Links that open a run in the app, from Python: the app's own test reads the same file."""

from __future__ import annotations

import base64
import json
import zlib
from pathlib import Path
from typing import Any

import kingpost
import pytest
from kingpost import link

GOLDEN = Path(__file__).resolve().parents[2] / "web" / "tests" / "golden" / "python_link.json"
"""A run and the link that `link.packed` made of it."""


def unpacked(fragment: str) -> dict[str, Any]:
    text, mark = fragment.removeprefix("#k1=").split(".")
    content = zlib.decompress(base64.urlsafe_b64decode(text + "=" * (-len(text) % 4)), -zlib.MAX_WBITS)
    assert link.digest(content) == mark
    return json.loads(content)


def test_the_link_that_the_app_reads_is_the_form_that_python_writes() -> None:
    """Source: web/tests/link.test.ts reads the same file. Compressors may differ in their bytes, not in what
    they hold."""
    golden = json.loads(GOLDEN.read_text(encoding="utf-8"))
    assert unpacked(golden["link"]) == golden["run"]
    assert unpacked(link.packed(golden["run"])) == golden["run"]


def test_a_link_contains_the_scenario_with_its_overrides_and_parameters_applied() -> None:
    scenario = kingpost.load("offshore_vessel", {"simulation.seed": 7}, waves=True, peak_period_s=9)
    given = unpacked(link.fragment(scenario))["scenario"]
    again = kingpost.scenario.Scenario(given["text"], given["file"])
    assert again.resolved == scenario.resolved
    assert again.resolved["simulation"]["seed"] == 7
    assert given["opened"] == {}


def test_a_link_contains_the_local_files_that_its_scenario_names(tmp_path: Path) -> None:
    crane = kingpost.load("offshore_vessel").files["gallery:parts/pedestal_crane.yaml"]
    (tmp_path / "crane.yaml").write_text(crane, encoding="utf-8")
    text = kingpost.load("offshore_vessel").text.replace("part: pedestal_crane", "part: crane.yaml")
    (tmp_path / "own.yaml").write_text(text, encoding="utf-8")
    given = unpacked(link.fragment(kingpost.load(tmp_path / "own.yaml")))["scenario"]
    assert list(given["opened"]) == ["crane.yaml"]


def test_a_link_that_is_too_long_is_refused_with_its_length(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(link, "LONGEST", 100)
    with pytest.raises(kingpost.KingpostError, match=r"link: found \d+ characters, allowed: 100"):
        link.fragment(kingpost.load("paper"))

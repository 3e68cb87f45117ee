"""The tutorial, the recipes and the whole job: every command and example runs and prints what is shown."""

from __future__ import annotations

import shutil
from pathlib import Path

import matplotlib
import pytest
from pages import DOCS, SLOW, blocks, not_printed, run_page

PAGES = [
    "index.md",
    "tutorial.md",
    *sorted(f"howto/{page.name}" for page in DOCS.glob("howto/*.md")),
    "job/index.md",
]


@pytest.mark.parametrize("name", PAGES)
def test_every_command_and_example_of_a_page_runs_and_prints_the_lines_of_the_page(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = DOCS / name
    languages = {block.language for block in blocks(path.read_text(encoding="utf-8"))}
    if not languages & {"bash", "python"}:
        pytest.skip(f"{name} has no command and no example")
    if "hydro" in path.read_text(encoding="utf-8"):
        pytest.importorskip("capytaine")
    # A page's folder is what its reader has: scenario files, records.
    for beside in path.parent.glob("*"):
        if beside.suffix in (".yaml", ".csv", ".stl"):
            shutil.copy(beside, tmp_path)
    monkeypatch.chdir(tmp_path)
    matplotlib.use("Agg")
    wrong = run_page(path, tmp_path)
    assert not wrong, (
        "to write the numbers anew: KINGPOST_WRITE_PAGES=1 pytest python/tests/test_docs_run.py\n"
        + "\n".join(wrong)
    )


def test_a_page_that_shows_another_number_than_the_program_is_found() -> None:
    printed = "limit held\nheel  yes  -4.3\ndaf   yes  1.16\n"
    assert not_printed("heel yes -4.3\n...\ndaf yes 1.16\n", printed) == []
    assert not_printed("heel yes -4.4\n", printed) == ["heel yes -4.4"]
    assert not_printed("daf yes 1.16\nheel yes -4.3\n", printed) == ["heel yes -4.3"]


def test_slow_blocks_are_marked_where_a_reader_sees_it() -> None:
    slow = [
        block for name in PAGES for block in blocks((DOCS / name).read_text(encoding="utf-8")) if block.slow
    ]
    assert slow or not SLOW
    assert all(block.title.startswith("takes about ") for block in slow)

"""The tutorial, the recipes, the whole job, the lifts checked by hand and the book: every command and example
runs and prints what is shown."""

from __future__ import annotations

import shutil
from pathlib import Path

import matplotlib
import pytest
from lanes import THOROUGH
from pages import DOCS, blocks, digest, not_kept, not_printed, ran_well, run_page, to_run

PAGES = [
    "index.md",
    "tutorial.md",
    *sorted(f"howto/{page.name}" for page in DOCS.glob("howto/*.md")),
    "job/index.md",
    *sorted(f"checked/{page.name}" for page in DOCS.glob("checked/*.md")),
    *sorted(f"book/{page.name}" for page in DOCS.glob("book/*.md")),
]
TO_WRITE = "to write it anew: KINGPOST_WRITE_PAGES=1 pytest python/tests/test_docs_run.py"


def files_beside(page: Path) -> list[Path]:
    """What a page's reader has: scenario files, records."""
    return sorted(file for file in page.parent.glob("*") if file.suffix in (".yaml", ".csv", ".stl"))


def what_runs(name: str) -> str:
    """A digest of a page's blocks and of the files beside it."""
    path = DOCS / name
    texts = [block.text for block in blocks(path.read_text(encoding="utf-8"))]
    return digest([*texts, *(file.read_bytes() for file in files_beside(path))])


def has_something_to_run(name: str) -> bool:
    page = (DOCS / name).read_text(encoding="utf-8")
    return any(block.language in ("bash", "python") for block in blocks(page))


NOW = {name: what_runs(name) for name in PAGES if has_something_to_run(name)}


@pytest.mark.parametrize("name", to_run(NOW, always="howto/batch.md"))
def test_every_command_and_example_of_a_page_runs_and_prints_the_lines_of_the_page(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = DOCS / name
    if "hydro" in path.read_text(encoding="utf-8"):
        pytest.importorskip("capytaine")
    for beside in files_beside(path):
        shutil.copy(beside, tmp_path)
    monkeypatch.chdir(tmp_path)
    matplotlib.use("Agg")
    wrong = run_page(path, tmp_path)
    assert not wrong, "\n".join([TO_WRITE, *wrong])
    ran_well(name, what_runs(name))


def test_the_pages_are_as_they_last_ran() -> None:
    assert not_kept(NOW) == [], TO_WRITE


def test_a_page_that_shows_another_number_than_the_program_is_found() -> None:
    printed = "limit held\nheel  yes  -4.3\ndaf   yes  1.16\n"
    assert not_printed("heel yes -4.3\n...\ndaf yes 1.16\n", printed) == []
    assert not_printed("heel yes -4.4\n", printed) == ["heel yes -4.4"]
    assert not_printed("daf yes 1.16\nheel yes -4.3\n", printed) == ["heel yes -4.3"]


def test_slow_blocks_are_marked_where_a_reader_sees_it() -> None:
    slow = [
        block for name in PAGES for block in blocks((DOCS / name).read_text(encoding="utf-8")) if block.slow
    ]
    assert slow or not THOROUGH
    assert all(block.title.startswith("takes about ") for block in slow)

"""Links of every page lead to an existing file and heading; web addresses are not checked."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FENCE = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\(([^)\s]+)\)")
# Made when the site is built; `mkdocs build` checks links to and from them.
MADE = {
    "docs/gallery.md",
    *(f"docs/reference/{name}.md" for name in ("scenario", "study", "command_line")),
}


def pages() -> list[Path]:
    return sorted(
        [
            *ROOT.glob("*.md"),
            *ROOT.glob("docs/**/*.md"),
            *ROOT.glob("benches/*.md"),
            *ROOT.glob("scenarios/**/*.md"),
        ]
    )


def anchor(heading: str) -> str:
    """A heading's anchor, as the site and code hosts make it."""
    heading = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    return re.sub(r"\s", "-", re.sub(r"[^\w\s-]", "", heading.strip().lower()))


def anchors(page: Path) -> set[str]:
    text = FENCE.sub("", page.read_text(encoding="utf-8"))
    return {anchor(heading) for heading in re.findall(r"^#+ (.*)$", text, re.MULTILINE)}


def broken(page: Path) -> list[str]:
    found = []
    for target in LINK.findall(FENCE.sub("", page.read_text(encoding="utf-8"))):
        if re.match(r"[a-z]+:", target):
            continue
        path, _, part = target.partition("#")
        file = (page.parent / path).resolve() if path else page
        if file.is_relative_to(ROOT) and str(file.relative_to(ROOT)) in MADE:
            continue
        if not file.exists() or (part and file.suffix == ".md" and part not in anchors(file)):
            found.append(target)
    return found


@pytest.mark.parametrize("page", pages(), ids=lambda page: str(page.relative_to(ROOT)))
def test_every_link_of_a_page_leads_somewhere(page: Path) -> None:
    assert broken(page) == []


def test_a_link_to_nothing_is_found(tmp_path: Path) -> None:
    (tmp_path / "other.md").write_text("# A heading with `code`\n")
    page = tmp_path / "page.md"
    page.write_text(
        "[a](other.md#a-heading-with-code) [b](other.md#none) [c](gone.md) [d](https://example.org/x)\n"
    )
    assert broken(page) == ["other.md#none", "gone.md"]


def test_files_to_which_pages_link_are_under_version_control() -> None:
    kept = subprocess.run(
        ["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=False
    ).stdout.splitlines()
    if not kept:
        pytest.skip("no version control here")
    folders = {str(parent) for path in kept for parent in Path(path).parents}
    for page in pages():
        for target in LINK.findall(FENCE.sub("", page.read_text(encoding="utf-8"))):
            path = target.partition("#")[0]
            if not path or re.match(r"[a-z]+:", target):
                continue
            name = str((page.parent / path).resolve().relative_to(ROOT))
            assert name in kept or name in folders or name in MADE, f"{page.relative_to(ROOT)}: {target}"

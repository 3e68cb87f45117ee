"""The project's English: words of docs/words.txt stand in no page, message, label or comment."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
LIST = ROOT / "docs" / "words.txt"
READ = [
    *("*.md", "Makefile", "docs/**/*.md", "benches/*.md", "scenarios/**/*.yaml", "scenarios/**/*.md"),
    *("docs/job/*.yaml", "python/kingpost/**/*.py", "tools/*.py", "web/src/**/*.ts", "web/index.html"),
    *("crates/*/src/**/*.rs", "schema/*.json"),
]
# Words of a programming language or of a library, not of ours.
CODE = re.compile(r"`[^`]*`|\bcolor\s*[:=]|https?://\S+|<[^>]*>")


@cache
def rules() -> list[tuple[re.Pattern[str], str]]:
    lines = [
        line for line in LIST.read_text(encoding="utf-8").splitlines() if line and not line.startswith("#")
    ]
    return [
        (re.compile(word, re.IGNORECASE), better) for word, better in (line.split("\t") for line in lines)
    ]


@cache
def any_rule() -> re.Pattern[str]:
    return re.compile("|".join(f"(?:{word.pattern})" for word, _ in rules()), re.IGNORECASE)


def files() -> list[Path]:
    found = {path for pattern in READ for path in ROOT.glob(pattern)}
    return sorted(path for path in found if not {"generated", "pkg", "node_modules"} & set(path.parts))


def text_of(path: Path) -> list[tuple[int, str]]:
    """The lines that a person reads: all of a page, of a program its comments and its texts."""
    lines = enumerate(path.read_text(encoding="utf-8").splitlines(), 1)
    if path.suffix not in (".ts", ".py", ".rs"):
        return list(lines)
    spoken = re.compile(r"//|#|\"|'|`|^\s*\*|^\s+[A-Za-z(]")
    return [(number, line) for number, line in lines if spoken.search(line)]


def found_in(lines: list[tuple[int, str]]) -> list[str]:
    stripped = ((number, CODE.sub("", line)) for number, line in lines)
    suspect = [(number, line) for number, line in stripped if any_rule().search(line)]
    return [
        f"{number}: found {match[0]!r}, allowed: {better}"
        for number, line in suspect
        for word, better in rules()
        if (match := word.search(line))
    ]


@pytest.mark.parametrize(
    "folder", ["docs", "python", "web", "crates", "scenarios", "schema", "benches", "tools", "."]
)
def test_no_word_of_the_list_stands_in_what_a_person_reads(folder: str) -> None:
    inside = [path for path in files() if path.parent == ROOT or path.relative_to(ROOT).parts[0] == folder]
    inside = [path for path in inside if (path.parent == ROOT) == (folder == ".")]
    assert inside
    wrong = [f"{path.relative_to(ROOT)}:{line}" for path in inside for line in found_in(text_of(path))]
    assert not wrong, "\n".join(wrong)


def test_a_word_of_the_list_is_found_and_code_is_not() -> None:
    assert found_in([(1, "A winch wants a drum")]) == ["1: found 'wants', allowed: needs, asks for"]
    assert found_in([(1, "what is not a number is left out")]) == [
        "1: found 'what is not a number', allowed: NaN"
    ]
    assert found_in([(1, "If you want to lift, call `this.wants()`")]) == []

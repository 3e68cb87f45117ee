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
    *(
        "docs/job/*.yaml",
        "docs/checked/*.yaml",
        "python/kingpost/**/*.py",
        "tools/*.py",
        "web/src/**/*.ts",
        "web/index.html",
        "web/figure/**/*.ts",
        "web/figure/*.md",
        "web/figure.html",
    ),
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
    """Lines that a person reads: all lines of a page; comments and texts of a program."""
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


LEANS = re.compile(r"(The same|As|These|What|Which|Of)\b")
"""First words of a docstring that depends on its neighbours; an editor shows each docstring alone."""


def openings(path: Path) -> list[tuple[int, str]]:
    """First lines of the documentation in a file, with their numbers."""
    text = path.read_text(encoding="utf-8")
    lines = text.splitlines()
    if path.suffix == ".rs":
        comment = [re.match(r"\s*//[/!] ?(.*)", line) for line in lines]
        first = [at for at, found in enumerate(comment) if found and not (at and comment[at - 1])]
        return [(at + 1, found[1]) for at in first if (found := comment[at])]
    opens = {".py": r'^[ \t]*r?"""(.*)', ".ts": r"/\*\*\s*\*?\s*(.*)"}[path.suffix]
    found = re.finditer(opens, text, re.MULTILINE)
    return [(text[: one.start()].count("\n") + 1, one[1]) for one in found]


def test_documentation_begins_with_a_verb_or_a_noun_of_the_field() -> None:
    read = [path for path in files() if path.suffix in (".rs", ".py", ".ts")]
    assert len(read) > 500
    wrong = [
        f"{path.relative_to(ROOT)}:{line}: {opening[:80]}"
        for path in read
        for line, opening in openings(path)
        if LEANS.match(opening)
    ]
    assert not wrong, "\n".join(wrong)


def test_an_opening_of_a_docstring_that_depends_on_its_neighbours_is_found(tmp_path: Path) -> None:
    one = tmp_path / "one.rs"
    one.write_text(
        "/// The same, mutable.\n/// What follows is free.\nfn f() {}\n/// Ends.\n", encoding="utf-8"
    )
    assert [bool(LEANS.match(opening)) for _, opening in openings(one)] == [True, False]
    other = tmp_path / "other.py"
    other.write_text('"""As text."""\nX = 1\n"""Offset, m."""\n', encoding="utf-8")
    assert [bool(LEANS.match(opening)) for _, opening in openings(other)] == [True, False]

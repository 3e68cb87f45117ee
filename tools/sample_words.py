"""Draws a random sample of the project's texts for review by a reader who does not know the code.

`sample_words.py --seed 2` prints 80 comments, messages, labels, names of tests and subjects of commits, each
with its file and line. The same seed and the same files give the same lines. `--root` reads another checkout.
"""

from __future__ import annotations

import argparse
import ast
import io
import random
import re
import subprocess
import tokenize
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[1]
COUNTS = {"comments": 32, "messages": 16, "labels": 12, "tests": 10, "commits": 10}
SOURCES = {
    ".rs": ["crates/*/src/**/*.rs", "xtask/src/**/*.rs"],
    ".py": ["python/**/*.py", "tools/*.py", "benches/*.py"],
    ".ts": ["web/src/**/*.ts"],
}
TESTS = {".rs": "crates/*/tests/**/*.rs", ".py": "python/tests/test_*.py", ".ts": "web/tests/**/*.test.ts"}
TEST = {
    ".rs": re.compile(r"#\[test\]\n(?:#\[[^\n]*\n)*\s*fn (\w+)"),
    ".py": re.compile(r"^def test_(\w+)", re.MULTILINE),
    ".ts": re.compile(r'\bit(?:\.each\([^)]*\))?\("([^"]+)"'),
}
LEAST_WORDS = 3
COMMITS = 200
LABEL = re.compile(r"\b(?:label|title|description): *(?:\"([^\"]+)\"|([^,}\"|>][^,}]*))")
TEXT = re.compile(r'"((?:[^"\\]|\\.)*)"', re.DOTALL)


class Found(NamedTuple):
    """A text with its file and line."""

    path: Path
    line: int
    text: str


def main() -> None:
    """Prints the sample."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=1, help="seed of the sample (default: %(default)s)")
    parser.add_argument("--root", type=Path, default=ROOT, help="checkout to read")
    options = parser.parse_args()
    drawn = random.Random(options.seed)
    pools = {"comments": comments(options.root), "messages": messages(options.root)}
    pools |= {"labels": labels(options.root), "tests": tests(options.root), "commits": commits(options.root)}
    for name, pool in pools.items():
        found = sorted(each for each in pool if len(re.findall(r"[^\W\d]{2,}", each.text)) >= needed(name))
        print(f"\n{name}: {COUNTS[name]} of {len(found)}")
        for path, line, text in drawn.sample(found, COUNTS[name]):
            print(f"{path.relative_to(options.root)}:{line}: {text}")


def needed(name: str) -> int:
    """Smallest number of words of a drawn text; a label may have one."""
    return 1 if name == "labels" else LEAST_WORDS


def files(root: Path, ending: str) -> Iterator[Path]:
    """Files of a language without tests and generated files."""
    for path in sorted({path for pattern in SOURCES[ending] for path in root.glob(pattern)}):
        if not {"generated", "tests", "node_modules", "pkg"} & set(path.relative_to(root).parts):
            yield path


def comments(root: Path) -> Iterator[Found]:
    """Comments and docstrings; consecutive comment lines are one text."""
    for path in files(root, ".py"):
        yield from python_comments(path)
    for ending, mark in (
        (".rs", re.compile(r"^\s*//[/!]? ?")),
        (".ts", re.compile(r"^\s*(?://|/\*\*|\*/?) ?")),
    ):
        for path in files(root, ending):
            lines = path.read_text(encoding="utf-8").splitlines()
            yield from blocks(path, [(k, mark.sub("", s)) for k, s in enumerate(lines, 1) if mark.match(s)])


def python_comments(path: Path) -> Iterator[Found]:
    """Comments from the tokens, docstrings from the syntax tree."""
    text = path.read_text(encoding="utf-8")
    tokens = tokenize.generate_tokens(io.StringIO(text).readline)
    marked = [(t.start[0], t.string.lstrip("# ")) for t in tokens if t.type == tokenize.COMMENT]
    yield from blocks(path, marked)
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef) and ast.get_docstring(node):
            yield Found(path, node.body[0].lineno, " ".join((ast.get_docstring(node) or "").split()))


def blocks(path: Path, lines: list[tuple[int, str]]) -> Iterator[Found]:
    """Joins consecutive lines."""
    start, end, joined = 0, -2, ""
    for number, line in [*lines, (-1, "")]:
        if number == end + 1:
            end, joined = number, f"{joined} {line.strip()}"
        else:
            if joined:
                yield Found(path, start, joined.replace("*/", "").strip())
            start, end, joined = number, number, line.strip()


def messages(root: Path) -> Iterator[Found]:
    """Texts of errors and warnings: of Python's exceptions and warnings, and the engine's texts of several
    words."""
    for path in files(root, ".py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            said = isinstance(node, ast.Raise) or (
                isinstance(node, ast.Call) and "warn" in ast.unparse(node.func)
            )
            if said:
                texts = [
                    n.value
                    for n in ast.walk(node)
                    if isinstance(n, ast.Constant) and isinstance(n.value, str)
                ]
                yield Found(path, node.lineno, " ".join(" ... ".join(texts).split()))
    for path in files(root, ".rs"):
        text = re.sub(r"(?m)^[ \t]*//.*$", "", path.read_text(encoding="utf-8")).split("#[cfg(test)]")[0]
        for match in TEXT.finditer(text):
            words = re.sub(r"\\\s+", "", match[1])
            if " " in words and "::" not in words and "\n" not in words:
                yield Found(path, text[: match.start()].count("\n") + 1, words)


def labels(root: Path) -> Iterator[Found]:
    """Labels and titles of scenarios, and the texts of the app's pages."""
    for path in sorted(root.glob("scenarios/**/*.yaml")):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            yield from (Found(path, number, m[1] or m[2]) for m in LABEL.finditer(line))
    for path in sorted(root.glob("web/src/texts/en/**/*.ts")):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if not line.lstrip().startswith(("import", "export *", "/*", "*", "//")):
                yield from (
                    Found(path, number, m[1] or m[2]) for m in re.finditer(r'"([^"]+)"|`([^`]+)`', line)
                )


def tests(root: Path) -> Iterator[Found]:
    """Names of tests, in words."""
    for ending, pattern in TESTS.items():
        for path in sorted(root.glob(pattern)):
            text = path.read_text(encoding="utf-8")
            for match in TEST[ending].finditer(text):
                yield Found(path, text[: match.start(1)].count("\n") + 1, match[1].replace("_", " "))


def commits(root: Path) -> Iterator[Found]:
    """Subjects of the last commits."""
    asked = ["git", "-C", str(root), "log", f"--max-count={COMMITS}", "--format=%s"]
    subjects = subprocess.run(asked, capture_output=True, text=True, check=True).stdout.splitlines()
    yield from (Found(root / "commit", number, subject) for number, subject in enumerate(subjects, 1))


if __name__ == "__main__":
    main()

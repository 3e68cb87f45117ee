"""The commands and examples on a page of Markdown, run as a reader runs them. A block fenced with `bash` or
`python` runs; a block whose title begins with "takes" runs only in the thorough lane. A block fenced with
`text` holds lines of the preceding block's output, in their order, with `...` for omitted lines. An exercise
states its answer, and the expression `by` that gives it after all blocks of the page.

The thorough lane runs every page. The default lane runs the shortest page of a kind, and pages that have
changed since their last successful run: `pages.json` stores a digest of each page's blocks.
KINGPOST_WRITE_PAGES=1 runs every page, and rewrites the printed lines and the digests.
"""

from __future__ import annotations

import contextlib
import hashlib
import io
import json
import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import docs_book
import kingpost
from filelock import FileLock
from lanes import THOROUGH, sampled

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
BLOCK = re.compile(
    r'^```(bash|python|text|yaml|exercise)(?: title="([^"\n]*)")?\n(.*?)^```', re.MULTILINE | re.DOTALL
)
WRITE = os.environ.get("KINGPOST_WRITE_PAGES") == "1"
DIGESTS = Path(__file__).with_name("pages.json")


@dataclass(frozen=True)
class Block:
    """One fenced block and the position of its text on the page."""

    language: str
    title: str
    text: str
    start: int
    line: int

    @property
    def slow(self) -> bool:
        return self.title.startswith("takes")


def blocks(page: str) -> list[Block]:
    return [
        Block(found[1], found[2] or "", found[3], found.start(3), page.count("\n", 0, found.start()) + 1)
        for found in BLOCK.finditer(page)
    ]


def digest(texts: Iterable[str | bytes]) -> str:
    """Digest of a page's blocks and of the files that it uses."""
    found = hashlib.sha256()
    for text in texts:
        content = text if isinstance(text, bytes) else text.encode()
        found.update(len(content).to_bytes(8, "big") + content)
    return found.hexdigest()[:16]


def kept_digests() -> dict[str, str]:
    """Digests of the pages at their last successful run."""
    return json.loads(DIGESTS.read_text(encoding="utf-8"))


def changed_pages(digests: dict[str, str]) -> list[str]:
    """Pages that have changed since their last successful run."""
    kept = kept_digests()
    return [name for name, now in digests.items() if kept.get(name) != now]


def to_run(digests: dict[str, str], always: str) -> list[Any]:
    """Pages as cases of a test: by default one page, and those that have changed."""
    changed = changed_pages(digests)
    return sampled(digests, keep=lambda name: WRITE or name == always or name in changed)


def ran_well(name: str, now: str) -> None:
    """Stores the digest of a page if pages are rewritten."""
    if WRITE:
        with FileLock(Path(tempfile.gettempdir()) / "kingpost_pages.lock"):
            text = json.dumps(kept_digests() | {name: now}, indent=1, sort_keys=True)
            DIGESTS.write_text(text + "\n", encoding="utf-8")


def not_kept(digests: dict[str, str]) -> list[str]:
    """Pages with outdated digests; none while pages are rewritten."""
    return [] if WRITE else changed_pages(digests)


def commands_folder(folder: Path) -> Path:
    """Folder with the command `kingpost` of the tested package."""
    folder.mkdir(exist_ok=True)
    command = folder / "kingpost"
    command.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m kingpost "$@"\n')
    command.chmod(0o755)
    return folder


def run_bash(text: str, folder: Path, commands: Path) -> str:
    """Output of a shell; `kingpost serve` runs its check and ends."""
    text = re.sub(r"^(kingpost serve .*)$", r"\1 --check --port 0", text, flags=re.MULTILINE)
    path = f"{commands}{os.pathsep}{os.environ['PATH']}"
    package = os.pathsep.join([str(Path(kingpost.__file__).parents[1]), os.environ.get("PYTHONPATH", "")])
    done = subprocess.run(
        ["bash", "-euo", "pipefail", "-c", text],
        cwd=folder,
        env=os.environ | {"PATH": path, "PYTHONPATH": package, "MPLBACKEND": "Agg"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, f"{text}\n{done.stdout}\n{done.stderr}"
    return done.stdout


def run_python(text: str, where: str, names: dict[str, Any]) -> str:
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile(text, where, "exec"), names)
    return printed.getvalue()


def words(line: str) -> list[str]:
    return line.split()


def not_printed(shown: str, printed: str) -> list[str]:
    """Lines of a page that are missing in the program's output, or in another order."""
    left = iter([words(line) for line in printed.splitlines()])
    lines = [line for line in shown.splitlines() if line.strip() not in ("", "...")]
    return [line for line in lines if words(line) not in left]


def anew(shown: str, printed: str) -> str:
    """Update the lines of a page from the present output: each becomes the next line that begins with the
    same word."""
    left = printed.splitlines()
    lines = []
    for line in shown.splitlines():
        same = [i for i, other in enumerate(left) if words(line) and words(other)[:1] == words(line)[:1]]
        if line.strip() in ("", "...") or not same:
            lines.append(line)
            continue
        exact = [i for i in same if words(left[i])[:2] == words(line)[:2]]
        at = (exact or same)[0]
        lines.append(left[at].rstrip())
        left = left[at + 1 :]
    return "\n".join(lines) + "\n"


def wrong_answers(text: str, names: dict[str, Any]) -> list[str]:
    """Answers of an exercise that are not true: the right one, or a usual wrong one that is accepted or is
    not the value of its expression."""
    exercise = docs_book.read("exercise", text)
    found = [(exercise["answer"], exercise["by"], True)]
    found += [(one["answer"], one.get("by"), False) for one in exercise["wrong"]]
    said: list[str] = []
    for answer, by, right in found:
        if docs_book.accepts(exercise, answer) != right:
            said.append(f"{answer} is {'not ' if right else ''}accepted")
        computed = None if by is None else eval(by, names)
        if exercise["kind"] == "sign" and computed is not None:
            computed = "0" if computed == 0 else "-" if computed < 0 else "+"
        if computed is not None and not docs_book.same(exercise, answer, computed):
            said.append(f"{answer} is stated, {by} gives {computed}")
    return said


def run_page(path: Path, folder: Path) -> list[str]:
    """Runs a page in a folder. Returns its lines that are not printed."""
    page = path.read_text(encoding="utf-8")
    commands = commands_folder(folder / ".commands")
    names: dict[str, Any] = {}
    wrong: list[str] = []
    printed: str | None = None
    for block in blocks(page):
        where = f"{path.name}:{block.line}"
        if block.slow and not THOROUGH:
            printed = None
        elif block.language == "bash":
            printed = run_bash(block.text, folder, commands)
        elif block.language == "python":
            printed = run_python(block.text, where, names)
        elif block.language == "yaml" and block.title.endswith(".yaml"):
            (folder / block.title).write_text(block.text)
        elif block.language == "text" and printed is not None:
            lines = not_printed(block.text, printed)
            wrong += [f"{where}: {line}" for line in lines]
            if lines and WRITE:
                page = page.replace(block.text, anew(block.text, printed))
    for block in blocks(page):
        if block.language == "exercise":
            wrong += [f"{path.name}:{block.line}: {line}" for line in wrong_answers(block.text, names)]
    if WRITE:
        path.write_text(page, encoding="utf-8")
    return wrong

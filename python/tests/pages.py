"""The commands and examples that stand on a page of Markdown, run as a reader runs them.

A block that is fenced with `bash` or `python` runs; one whose title begins with "takes" runs in the thorough
lane. A block that is fenced with `text` holds lines of what the block before it prints, in their order, with
`...` for lines left out.

The thorough lane runs every page. The default lane runs the shortest of a kind, and those that have changed
since they last ran well: `pages.json` keeps a digest of what runs on each page. KINGPOST_WRITE_PAGES=1 runs
every page, and writes the printed lines and the digests anew.
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

import kingpost
from filelock import FileLock
from lanes import THOROUGH, sampled

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
BLOCK = re.compile(r'^```(bash|python|text|yaml)(?: title="([^"\n]*)")?\n(.*?)^```', re.MULTILINE | re.DOTALL)
WRITE = os.environ.get("KINGPOST_WRITE_PAGES") == "1"
DIGESTS = Path(__file__).with_name("pages.json")


@dataclass(frozen=True)
class Block:
    """One fenced block, and where its text stands on the page."""

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
    """A digest of what runs on a page, of files beside it too."""
    found = hashlib.sha256()
    for text in texts:
        content = text if isinstance(text, bytes) else text.encode()
        found.update(len(content).to_bytes(8, "big") + content)
    return found.hexdigest()[:16]


def kept_digests() -> dict[str, str]:
    """The digests of the pages when they last ran well."""
    return json.loads(DIGESTS.read_text(encoding="utf-8"))


def changed_pages(digests: dict[str, str]) -> list[str]:
    """Pages that have changed since they last ran well."""
    kept = kept_digests()
    return [name for name, now in digests.items() if kept.get(name) != now]


def to_run(digests: dict[str, str], always: str) -> list[Any]:
    """Pages as cases of a test: by default those that have changed, and one of them always."""
    changed = changed_pages(digests)
    return sampled(digests, keep=lambda name: WRITE or name == always or name in changed)


def ran_well(name: str, now: str) -> None:
    """Keeps the digest of a page, where pages are written anew."""
    if WRITE:
        with FileLock(Path(tempfile.gettempdir()) / "kingpost_pages.lock"):
            text = json.dumps(kept_digests() | {name: now}, indent=1, sort_keys=True)
            DIGESTS.write_text(text + "\n", encoding="utf-8")


def not_kept(digests: dict[str, str]) -> list[str]:
    """Pages whose digests are outdated; none while they are written anew."""
    return [] if WRITE else changed_pages(digests)


def commands_folder(folder: Path) -> Path:
    """A folder with the command `kingpost` of the package that is tested."""
    folder.mkdir(exist_ok=True)
    command = folder / "kingpost"
    command.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m kingpost "$@"\n')
    command.chmod(0o755)
    return folder


def run_bash(text: str, folder: Path, commands: Path) -> str:
    """What a shell prints; the server checks itself and ends."""
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
    """Lines of a page that the program does not print, or not in this order."""
    left = iter([words(line) for line in printed.splitlines()])
    lines = [line for line in shown.splitlines() if line.strip() not in ("", "...")]
    return [line for line in lines if words(line) not in left]


def anew(shown: str, printed: str) -> str:
    """The lines of a page as they are printed now: each is the next that begins with the same word."""
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


def run_page(path: Path, folder: Path) -> list[str]:
    """Runs a page in a folder. Returns what stands on it and is not so."""
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
    if WRITE:
        path.write_text(page, encoding="utf-8")
    return wrong

"""Cases of former failures as small files: `corpus/KIND/NAME.json`."""

from __future__ import annotations

import base64
import hashlib
import json
import re
import sys
import sysconfig
import tempfile
from pathlib import Path
from typing import Any

import kingpost

from .contract import Case

FOLDER = Path(__file__).parent / "corpus"
OF_THE_MACHINE = (
    *(Path(kingpost.__file__).parents[1], FOLDER.parents[1], FOLDER.parents[3]),
    *(Path(sysconfig.get_path(name)) for name in ("purelib", "stdlib")),
    *(Path(name) for name in (tempfile.gettempdir(), sys.prefix, sys.base_prefix)),
    *(Path.cwd(), Path.home()),
)
"""Folders of this machine, which differ on others."""


def load(path: Path) -> Case:
    """A case from its file."""
    tree: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    files = {name: _content(held) for name, held in tree["files"].items()}
    return Case(path.parent.name, files, tuple(tree["arguments"]))


def save(case: Case, folder: Path, says: str, name: str | None = None) -> Path:
    """Write a case with its result."""
    digest = hashlib.sha256(repr((case.files, case.arguments)).encode()).hexdigest()[:10]
    path = folder / case.kind / f"{name or digest}.json"
    path.parent.mkdir(parents=True, exist_ok=True)
    files = {file: _held(content) for file, content in case.files.items()}
    tree = {"found": without_folders(says)[:600], "arguments": list(case.arguments), "files": files}
    path.write_text(json.dumps(tree, indent=1, ensure_ascii=True) + "\n", encoding="utf-8")
    return path


def without_folders(says: str) -> str:
    """Replace folders in a text, so that files are named relative to the package, the libraries or the case's
    folder."""
    names = sorted({str(path) for path in OF_THE_MACHINE if path != Path(path.anchor)}, key=len)
    found = "|".join(re.escape(name) for name in reversed(names))
    # In the folder for temporary files each case has one of its own: its name is drawn.
    drawn = rf"(?:{re.escape(tempfile.gettempdir())}/tmp\w+)"
    return re.sub(rf"(?:{drawn}|{found})(?:/|\b)", "", says)


def _held(content: bytes) -> str | dict[str, str]:
    try:
        return content.decode()
    except UnicodeDecodeError:
        return {"base64": base64.b64encode(content).decode()}


def _content(held: str | dict[str, str]) -> bytes:
    return held.encode() if isinstance(held, str) else base64.b64decode(held["base64"])

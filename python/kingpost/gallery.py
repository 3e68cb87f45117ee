"""Where scenarios come from: a file, or a name of the gallery."""

from __future__ import annotations

import difflib
import json
from dataclasses import dataclass
from pathlib import Path

from . import _engine
from .errors import ScenarioError

ENDINGS = (".yaml", ".yml", ".json")


@dataclass(frozen=True)
class Entry:
    """One scenario of the gallery."""

    name: str
    title: str
    path: Path


def folder() -> Path:
    """Folder of the gallery: the package's own, or the repository's in a development install."""
    package = Path(__file__).parent
    for candidate in (package / "scenarios", package.parents[1] / "scenarios"):
        if candidate.is_dir() and any(candidate.glob("*.yaml")):
            return candidate
    return package / "scenarios"


def names() -> list[str]:
    """Names of the gallery, sorted.

    >>> "paper" in names()
    True
    """
    return sorted(path.stem for path in folder().glob("*.yaml"))


def entries() -> list[Entry]:
    """The gallery, each scenario with the title that its file gives."""
    found = (folder() / f"{name}.yaml" for name in names())
    return [Entry(path.stem, _title(path), path) for path in found]


def _title(path: Path) -> str:
    text, file = read_text(path), str(path)
    names = _engine.file_names(text, file, "[]")
    files = {name: read_text(found) for name in names if (found := beside(file, name)) is not None}
    resolved: str = _engine.read(text, file, "[]", files)
    return json.loads(resolved)["title"]


def find(path_or_name: str | Path) -> Path:
    """Return the file that a path or a gallery name stands for.

    Raises
    ------
    ScenarioError
        When it is neither; the message names the nearest gallery name.

    >>> find("paper").name
    'paper.yaml'
    """
    text = str(path_or_name)
    if Path(text).exists() and not Path(text).is_dir():
        return Path(text)
    gallery = names()
    if text in gallery:
        return folder() / f"{text}.yaml"
    if Path(text).is_dir():
        raise ScenarioError(f"{text}: is a folder, not a scenario file", file=text)
    if Path(text).suffix.lower() in ENDINGS or Path(text).parent != Path("."):
        raise ScenarioError(f"{text}: no such file", file=text)
    near = difflib.get_close_matches(text, gallery, n=1)
    hint = f"did you mean {near[0]!r}?" if near else f"the gallery has: {', '.join(gallery)}"
    raise ScenarioError(f"{text}: neither a file nor a name of the gallery; {hint}", file=text)


def beside(file: str | Path, name: str) -> Path | None:
    """Return the file of this name beside another; `None` where there is none.

    >>> beside(find("barge"), "hydro/barge.hydro.json").name
    'barge.hydro.json'
    >>> beside("nowhere.yaml", "hydro/barge.hydro.json")
    """
    path = Path(file).parent / name
    return path if path.is_file() else None


def read_text(path: Path) -> str:
    """Text of a scenario file, or a `ScenarioError` that says why it cannot be read."""
    try:
        return path.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        raise ScenarioError(f"{path}: not a text file in UTF-8", file=str(path)) from None
    except OSError as error:
        raise ScenarioError(f"{path}: {error.strerror}", file=str(path)) from None

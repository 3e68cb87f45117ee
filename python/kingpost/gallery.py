"""Sources of scenarios: files, and names of the gallery."""

from __future__ import annotations

import difflib
import json
import os
from dataclasses import dataclass
from pathlib import Path

from .engine import engine
from .errors import ScenarioError
from .output import irregular

ENDINGS = (".yaml", ".yml", ".json")
GALLERY = "gallery:"
"""Prefix of the names of files in the gallery."""


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


def groups() -> dict[str, str]:
    """The group of each scenario of the gallery by its name, in the order in which they are shown.

    >>> groups()["paper"], next(iter(groups()))
    ('The paper: Jardim et al. (2019)', 'paper')
    """
    listed = json.loads(read_text(folder() / "gallery.json"))["groups"]
    return {name: group["title"] for group in listed for name in group["scenarios"]}


def entries() -> list[Entry]:
    """The gallery, each scenario with the title that its file gives."""
    found = (folder() / f"{name}.yaml" for name in names())
    return [Entry(path.stem, _title(path), path) for path in found]


def _title(path: Path) -> str:
    text, file = read_text(path), str(path)
    resolved: str = engine.read(text, file, "[]", texts(text, file))
    return json.loads(resolved)["title"]


def find(path_or_name: str | Path) -> Path:
    """Return the file of a path or of a gallery name.

    Raises
    ------
    ScenarioError
        If it is neither; the message suggests the nearest gallery name.

    >>> find("paper").name
    'paper.yaml'
    """
    text = str(path_or_name)
    if os.path.exists(text) and not os.path.isdir(text):
        return Path(text)
    gallery = names()
    if text in gallery:
        return folder() / f"{text}.yaml"
    if os.path.isdir(text):
        raise ScenarioError(f"{text}: is a folder, not a scenario file", file=text)
    if Path(text).suffix.lower() in ENDINGS or Path(text).parent != Path("."):
        raise ScenarioError(f"{text}: no such file{_like(Path(text))}", file=text)
    near = difflib.get_close_matches(text, gallery, n=1)
    hint = f"did you mean {near[0]!r}?" if near else f"the gallery has: {', '.join(gallery)}"
    raise ScenarioError(f"{text}: neither a file nor a name of the gallery; {hint}", file=text)


def _like(path: Path) -> str:
    """Suggest, as a question, the scenario file in the same folder with the name nearest to a misspelt
    one."""
    try:
        beside = [one.name for one in path.parent.iterdir() if one.suffix.lower() in ENDINGS]
    except OSError:
        return ""
    near = difflib.get_close_matches(path.name, beside, n=1)
    return f"; did you mean {path.with_name(near[0])}?" if near else ""


def parts() -> list[str]:
    """Names of the parts that a scenario can be made of, sorted.

    >>> "pedestal_crane" in parts()
    True
    """
    return sorted(path.stem for path in (folder() / "parts").glob("*.yaml"))


def place(file: str | Path, name: str) -> Path:
    """Path of a file that a scenario names: in the folder of the scenario, or in the gallery.

    >>> place("ships/mine.yaml", "hulls/mine.hydro.json").as_posix()
    'ships/hulls/mine.hydro.json'
    >>> place("ships/mine.yaml", "gallery:parts/pedestal_crane.yaml").is_file()
    True
    """
    in_gallery = name.removeprefix(GALLERY)
    if in_gallery == name:
        # Files are beside the scenario, not beside a symbolic link to it.
        beside = os.path.realpath(file) if os.path.islink(file) else file
        return Path(beside).parent / name
    if Path(in_gallery).is_absolute() or ".." in Path(in_gallery).parts:
        raise ScenarioError(f"{file}: found {name}, allowed: a file of the gallery", file=str(file))
    return folder() / in_gallery


def texts(text: str, file: str, overrides_json: str = "[]") -> dict[str, str]:
    """Texts of the files that a scenario names, and of the files that these name, by name. Missing files are
    left out.

    >>> sorted(texts("{version: 1, title: x, parts: {crane: {part: pedestal_crane}}}", "x.yaml"))
    ['gallery:parts/pedestal_crane.yaml']
    """
    found: dict[str, str] = {}
    asked: set[str] = set()
    # A part may name more files, which are known only when its text has been read.
    while new := set(engine.file_names(text, file, overrides_json, found)) - asked:
        asked |= new
        paths = {name: place(file, name) for name in sorted(new)}
        found |= {name: read_text(path) for name, path in paths.items() if os.path.isfile(path)}
    return found


def read_text(path: Path) -> str:
    """Read the text of a scenario file; raise a `ScenarioError` with the reason if it cannot be read."""
    kind = irregular(path)
    if kind is not None:
        raise ScenarioError(f"{path}: found {kind}, allowed: a regular file", file=str(path))
    try:
        # Some programs begin a text with a byte-order mark.
        return path.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError:
        raise ScenarioError(f"{path}: not a text file in UTF-8", file=str(path)) from None
    except OSError as error:
        raise ScenarioError(f"{path}: {error.strerror}", file=str(path)) from None

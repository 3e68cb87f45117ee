"""How the package's files import each other."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import kingpost

PACKAGE = Path(kingpost.__file__).parent


def module_of(path: Path) -> str:
    """Dotted name of a file below the package; of the package itself empty."""
    parts = path.relative_to(PACKAGE).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def imports(path: Path, modules: set[str]) -> Iterator[str]:
    """Modules that a file imports, in functions and for types too."""
    folder = path.relative_to(PACKAGE).parts[:-1]
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if not isinstance(node, ast.ImportFrom) or not node.level:
            continue
        above = folder[: len(folder) - node.level + 1]
        base = ".".join([*above, *(node.module or "").split(".")]).strip(".")
        for name in node.names:
            full = f"{base}.{name.name}".strip(".")
            yield full if full in modules else base


def graph() -> dict[str, set[str]]:
    """Modules with those that each imports. `__init__` offers what is in its folder, and the version stands
    in that of the package."""
    paths = {module_of(path): path for path in PACKAGE.rglob("*.py")}
    return {
        module: {used for used in imports(path, set(paths)) if used}
        for module, path in paths.items()
        if path.name not in ("__init__.py", "__main__.py")
    }


def circle_in(graph: dict[str, set[str]]) -> list[str]:
    """Nodes of a circle; empty where there is none."""
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        return list(error.args[1])
    return []


def test_no_two_files_import_each_other_not_even_for_types() -> None:
    """Source: the definition of a directed graph without circles."""
    assert circle_in(graph()) == []
    assert len(graph()) > 100


def test_no_two_folders_beside_each_other_import_each_other() -> None:
    """Source: the definition of a directed graph without circles, of the files and folders in each folder."""
    beside: dict[tuple[str, ...], dict[str, set[str]]] = {}
    for module, used in graph().items():
        for own, other in ((module.split("."), name.split(".")) for name in used):
            shared = next((k for k, (a, b) in enumerate(zip(own, other, strict=False)) if a != b), None)
            if shared is not None:
                folder = beside.setdefault(tuple(own[:shared]), {})
                folder.setdefault(own[shared], set()).add(other[shared])
    assert beside[("study",)]["running"] >= {"design", "store"}
    assert {folder: circle_in(graph) for folder, graph in beside.items() if circle_in(graph)} == {}


def test_attributes_with_entries_are_read_and_written_as_json_in_one_place() -> None:
    """Source: `kingpost.results.entries`; `kept` checks the form of what a file holds."""
    reads = re.compile(r"json\.loads\([^)]*\battr|attrs\[[^]]*\] = json\.|assign_attrs\([^)]*json\.")
    readers = {module_of(path) for path in PACKAGE.rglob("*.py") if reads.search(path.read_text("utf-8"))}
    assert readers <= {"results.entries", "results.kept"}

"""How the package's files import each other."""

from __future__ import annotations

import ast
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


def test_no_two_files_import_each_other_not_even_for_types() -> None:
    """Source: the definition of a directed graph without circles. `__init__` offers what is in its folder,
    and the version stands in that of the package."""
    paths = {module_of(path): path for path in PACKAGE.rglob("*.py")}
    graph = {
        module: {used for used in imports(path, set(paths)) if used}
        for module, path in paths.items()
        if path.name not in ("__init__.py", "__main__.py")
    }
    circle: list[str] = []
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        circle = error.args[1]
    assert circle == []
    assert len(graph) > 100

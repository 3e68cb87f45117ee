"""The package names no kind of force or drive: the engine describes what to show."""

from __future__ import annotations

import ast
import json
import re
from collections.abc import Iterator
from pathlib import Path

import kingpost

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = Path(kingpost.__file__).parent
EXCEPTIONS = {
    # Writes scenarios of the mooring systems of other programs: lines, bodies and the water on them.
    "convert",
    # Computes what the water does to a hull before there is a scenario: its gravity is that of the water.
    "hydro",
    # The paper's own case, whose scenario it reads and writes about.
    "paper",
    # Computes a ship's roll damping before there is a scenario, and writes the forces that stand for it.
    "roll_damping",
    # Writes scenarios of its own, as the gallery's files are, each for a number that is known.
    "verify",
    # Knows which columns are never negative, or are angles of an arctangent, by their names.
    "results/bounds.py",
}


def schema(name: str) -> dict:
    return json.loads((ROOT / "schema" / f"{name}.schema.json").read_text(encoding="utf-8"))


def published() -> set[str]:
    """Names of what the engine says of every model, as ``gravity_m_s2``."""
    return set(schema("model")["$defs"]["Description"]["properties"])


def kinds() -> set[str]:
    """Kinds of forces and drives, by the schema of scenarios."""
    definitions = schema("scenario")["$defs"]
    return {
        name
        for choice in ("Force", "Drive")
        for tagged in definitions[choice]["oneOf"]
        for name in tagged["properties"]
    }


def words(tree: ast.AST) -> Iterator[tuple[int, str]]:
    """Names and texts of a module, docstrings left out."""
    documented = (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)
    prose = {
        id(node.value)
        for scope in ast.walk(tree)
        if isinstance(scope, documented)
        for node in scope.body
        if isinstance(node, ast.Expr)
    }
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in prose:
            yield node.lineno, node.value
        for field in ("id", "attr", "name", "arg"):
            if isinstance(name := getattr(node, field, None), str):
                yield node.lineno, name


def test_no_kind_of_element_is_named() -> None:
    """Source: the schema, so that a kind that comes later counts too."""
    known = kinds()
    assert {"gravity", "motor", "hydrodynamics", "cylinder"} <= known
    # As a word, or as the beginning of the name of a variable: `cylinder_force`.
    # A line is also one of a file or of a plot.
    named = re.compile(rf"\b({'|'.join(sorted(known - {'line'}))})s?(_|\b)")
    found = [
        f"{path.relative_to(PACKAGE)}:{line}: {text}"
        for path in sorted(PACKAGE.rglob("*.py"))
        if not EXCEPTIONS & {path.relative_to(PACKAGE).parts[0], path.relative_to(PACKAGE).as_posix()}
        for line, text in words(ast.parse(path.read_text(encoding="utf-8")))
        if named.search(text) and text not in published()
    ]
    assert found == []

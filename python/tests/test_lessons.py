"""The lessons: every notebook runs from its first cell to its last, and what it asserts holds."""

from __future__ import annotations

import ast
import json
import re
import warnings
from pathlib import Path
from typing import Any

import pytest
from kingpost.paper.equations import Equation
from kingpost.simulation.matrices import Formula
from pages import digest, not_kept, ran_well, to_run

FOLDER = Path(__file__).parents[2] / "lessons"
LESSONS = sorted(FOLDER.glob("*.ipynb"))


def cells(path: Path, kind: str) -> list[str]:
    """The texts of a notebook's cells of one kind."""
    notebook = json.loads(path.read_text(encoding="utf-8"))
    return ["".join(cell["source"]) for cell in notebook["cells"] if cell["cell_type"] == kind]


def run_cell(text: str, name: str, namespace: dict[str, Any]) -> Any:
    """Runs a cell as a notebook does: what the last expression gives is what it shows."""
    tree = ast.parse(text, name)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, name, "exec"), namespace)
    if last is None:
        return None
    return eval(compile(ast.Expression(last.value), name, "eval"), namespace)


@pytest.fixture
def pyplot(monkeypatch):
    """Matplotlib without a screen; a figure that is shown is drawn, and closed."""
    import matplotlib

    matplotlib.use("agg")
    from matplotlib import pyplot

    def show() -> None:
        for number in pyplot.get_fignums():
            pyplot.figure(number).canvas.draw()
        pyplot.close("all")

    monkeypatch.setattr(pyplot, "show", show)
    yield pyplot
    pyplot.close("all")


NOW = {path.stem: digest(cells(path, "code")) for path in LESSONS}


@pytest.mark.parametrize("name", to_run(NOW, always=LESSONS[0].stem))
def test_a_lesson_runs_and_its_assertions_hold(name, pyplot):
    """Source: the lessons' own asserts; any warning is an error."""
    path = FOLDER / f"{name}.ipynb"
    code, namespace = cells(path, "code"), {"__name__": "__main__"}
    assert sum(text.count("assert ") for text in code) >= 5
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for number, text in enumerate(code, start=1):
            shown = run_cell(text, f"{path.stem}, cell {number}", namespace)
            assert repr(shown)
            if isinstance(shown, Formula | Equation):
                assert shown._repr_latex_().startswith("$")
    assert not pyplot.get_fignums(), "a figure was not shown"
    ran_well(name, NOW[name])


def test_the_lessons_are_as_they_last_ran():
    assert not_kept(NOW) == [], "KINGPOST_WRITE_PAGES=1 pytest python/tests/test_lessons.py keeps them"


def test_lessons_are_numbered_from_one_in_their_titles():
    """Source: their order is the order of the theory."""
    assert len(LESSONS) == 8
    for number, path in enumerate(LESSONS, start=1):
        assert path.stem.startswith(f"{number:02}_")
        assert cells(path, "markdown")[0].startswith(f"# {number}. ")


@pytest.mark.parametrize("path", LESSONS, ids=lambda path: path.stem)
def test_a_lesson_is_stored_without_outputs_and_uses_only_public_names(path):
    """Source: outputs are made, not kept; a lesson is an example of the public interface."""
    notebook = json.loads(path.read_text(encoding="utf-8"))
    for cell in notebook["cells"]:
        assert not cell.get("outputs")
        assert cell.get("execution_count") is None
    code = "\n".join(cells(path, "code"))
    assert not re.search(r"\b_engine\b|\._[a-z]", code)
    allowed = {"kingpost", "numpy", "matplotlib", "warnings"}
    assert set(re.findall(r"^(?:from|import) (\w+)", code, re.M)) <= allowed

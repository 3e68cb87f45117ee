"""The book: every equation of the paper is in it, once in its table; exercises accept what is right and
reject what is often answered. The pages themselves run in test_docs_run.py."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import docs_book
import kingpost
import pytest
from kingpost import figures
from pages import blocks, wrong_answers

BOOK = Path(__file__).resolve().parents[2] / "docs" / "book"
CHAPTERS = sorted(BOOK.glob("[1-9]_*.md"))
EQUATIONS = list(range(1, 64))
NUMBER: dict[str, Any] = {
    "kind": "number",
    "question": "How long?",
    "answer": 2.5,
    "by": "1 + 1.5",
    "tolerance": 0.1,
    "tolerance_reason": "two digits are asked for",
    "right": "It is.",
    "wrong": [{"answer": 3, "because": "Too long."}],
}


def text(**changes: object) -> str:
    import json

    return json.dumps(NUMBER | changes)


def test_every_equation_of_the_paper_is_set_in_a_chapter() -> None:
    pages = "".join(chapter.read_text(encoding="utf-8") for chapter in CHAPTERS)
    numbers = [int(found) for found in re.findall(r"\\tag\{(\d+)", pages)]
    assert sorted(set(numbers)) == EQUATIONS


def test_the_table_has_every_equation_once_in_the_chapter_that_sets_it() -> None:
    table = (BOOK / "index.md").read_text(encoding="utf-8").split("## Each equation")[1]
    listed: list[int] = []
    for first, last, chapter in re.findall(r"^\| (\d+)(?:-(\d+))? \|.*?\]\((\w+\.md)#", table, re.MULTILINE):
        numbers = range(int(first), int(last or first) + 1)
        listed += numbers
        page = (BOOK / chapter).read_text(encoding="utf-8")
        assert [n for n in numbers if not re.search(rf"\\tag\{{{n}\D?\}}", page)] == []
    assert listed == EQUATIONS


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda chapter: chapter.stem)
def test_a_chapter_has_a_figure_a_prediction_and_exercises_that_reject_the_usual_wrong_answer(
    chapter: Path,
) -> None:
    page = chapter.read_text(encoding="utf-8")
    assert docs_book.figures(page)
    assert "**Predict" in page
    exercises = docs_book.exercises(page)
    assert len(exercises) >= 2
    for exercise in exercises:
        assert docs_book.accepts(exercise, exercise["answer"])
        assert exercise["wrong"]
        assert not [one for one in exercise["wrong"] if docs_book.accepts(exercise, one["answer"])]
        assert set(map(str, exercise.get("options", []))) >= (
            {exercise["answer"]} if "options" in exercise else set()
        )


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda chapter: chapter.stem)
def test_the_figures_of_a_chapter_name_controls_columns_and_cameras_that_exist(chapter: Path) -> None:
    for one in docs_book.figures(chapter.read_text(encoding="utf-8")):
        simulation = kingpost.Simulation(kingpost.load(one["scenario"], **one.get("set", {})))
        choice = figures.Choice(one.get("controls", []), one.get("plot", []), one.get("camera", "free"))
        assert figures.checked(simulation, choice)


def test_a_figure_is_played_in_the_page_where_the_app_is_built(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    fields = {"scenario": "paper", "set": {"load": True}, "controls": ["load"], "plot": ["ship.roll"]}
    monkeypatch.setattr(docs_book, "BUILT_APP", tmp_path)
    assert "<kingpost-figure" not in docs_book.picture(fields, "..")
    (tmp_path / "kingpost-figure.js").write_text("", encoding="utf-8")
    made = docs_book.picture(fields, "..")
    assert (
        '<kingpost-figure src="../app/" scenario="paper" set="load=true" controls="load" plot="ship.roll"'
        in made
    )
    assert '<a href="../app/?scenario=paper&amp;load=true"><img src="../cards/paper.webp"' in made


def test_an_answer_that_the_run_does_not_give_is_found() -> None:
    assert wrong_answers(text(), {}) == []
    assert wrong_answers(text(by="1 + 1"), {}) == ["2.5 is stated, 1 + 1 gives 2"]
    assert wrong_answers(text(wrong=[{"answer": 2.55, "because": "?"}]), {}) == ["2.55 is accepted"]
    sign = text(kind="sign", answer="-", by="-3", wrong=[{"answer": "+", "by": "-3", "because": "?"}])
    assert wrong_answers(sign, {}) == ["+ is stated, -3 gives -"]


def test_a_field_that_is_missing_or_unknown_is_named() -> None:
    with pytest.raises(ValueError, match="missing or unknown: scenario, colour"):
        docs_book.read("figure", "{caption: x, colour: red}")


def test_an_exercise_is_part_of_what_a_page_runs() -> None:
    page = f"# A page\n\n```exercise\n{text()}\n```\n"
    assert [block.language for block in blocks(page)] == ["exercise"]

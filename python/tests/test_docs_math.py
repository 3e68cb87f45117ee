"""Formulas of the documentation: each can be set, on the site and on a code host; none is typed as code."""

from __future__ import annotations

import re
from pathlib import Path

import docs_book
import docs_math
import pytest
import yaml

ROOT = Path(__file__).resolve().parents[2]
PAGES = sorted(ROOT.glob("docs/**/*.md"))
# A code host takes these inside $...$ as Markdown before it sees TeX.
EATEN = re.compile(r"\\[^A-Za-z]|[*|`]|\]\(")


def name(path: Path) -> str:
    return str(path.relative_to(ROOT))


def ascii_equations(page: str) -> list[str]:
    """Blocks of code that are equations: of indented lines, or fenced as text and not the output of a block
    before."""
    found: list[str] = []
    prints = False
    for part in re.split(r"(^```.*?^```[ ]*$)", page, flags=re.MULTILINE | re.DOTALL):
        language = part[3:].split("\n", 1)[0].split(" ")[0] if part.startswith("```") else None
        if language == "text" and not prints:
            found.append(part)
        if language:
            prints = language in ("bash", "python") or (language == "text" and prints)
        if language is None:
            found += re.findall(r"(?:\A|\n)[ \t]*\n((?:    [^\n]*(?:\n|\Z))+)", part)
    return [block for block in found if re.search(r" (=|->|<=) |\^", block)]


@pytest.mark.parametrize("path", PAGES, ids=name)
def test_every_formula_of_a_page_can_be_set(path: Path) -> None:
    for latex, displayed in docs_math.formulas(path.read_text(encoding="utf-8")):
        html = docs_math.display(latex) if displayed else docs_math.mathml(latex)
        assert "<math" in html
        assert "merror" not in html
        assert displayed or not EATEN.search(latex), f"{latex}: use \\thinspace, \\ast, \\lvert, \\lbrace"


@pytest.mark.parametrize("path", sorted(ROOT.glob("docs/book/*.md")), ids=name)
def test_figures_and_exercises_of_a_page_can_be_set(path: Path) -> None:
    page = path.read_text(encoding="utf-8")
    for fields in docs_book.figures(page):
        assert (ROOT / "scenarios" / f"{fields['scenario']}.yaml").is_file()
        assert (ROOT / "web" / "public" / "cards" / f"{fields['scenario']}.webp").is_file()
        known = {one["name"] for one in parameters(fields["scenario"])}
        assert {*fields.get("set", {}), *fields.get("controls", [])} <= known
    for block in docs_book.BLOCK.finditer(page):
        for formula in re.finditer(docs_math.INLINE, block[2]):
            assert "<math" in docs_math.mathml(formula[1])


def parameters(scenario: str) -> list[dict]:
    text = (ROOT / "scenarios" / f"{scenario}.yaml").read_text(encoding="utf-8")
    return yaml.safe_load(text).get("parameters", [])


def test_no_equation_is_typed_as_code() -> None:
    wrong = {name(path): ascii_equations(path.read_text(encoding="utf-8")) for path in PAGES}
    assert {page: found for page, found in wrong.items() if found} == {}


def test_an_equation_that_is_typed_as_code_is_found() -> None:
    assert ascii_equations("With\n\n    F = -k x\n\nand\n") == ["    F = -k x\n"]
    assert len(ascii_equations("With\n\n```text\nT = 2 pi sqrt(m / k)\n```\n")) == 1
    output = "```python\nprint(1)\n```\n\n```text\nheel = 1\n```\n\nand\n\n```text\nx = 2\n```\n"
    assert ascii_equations(output) == []
    assert ascii_equations("As in\n\n    hoist:\n      body: load\n") == []


def test_a_number_of_an_equation_is_an_anchor() -> None:
    html = docs_math.display(r"[M^*] = [B]^T [M] [B] \tag{60a}")
    assert html.startswith('<div class="equation" id="eq-60a"><math display="block">')
    assert html.endswith('</math><span class="number">(60a)</span></div>')


def test_a_command_that_does_not_exist_ends_the_build() -> None:
    with pytest.raises(ValueError, match=r"formula '\\\\fraction.*Unknown command"):
        docs_math.mathml(r"\fraction{1}{2}")


def test_code_and_prices_are_no_formulas() -> None:
    page = (
        "It costs $5 or $6, `$HOME` and `a$b$`, but $x$ and\n\n```math\ny\n```\n\n```bash\necho $A $B\n```\n"
    )
    assert [(latex.strip(), displayed) for latex, displayed in docs_math.formulas(page)] == [
        ("y", True),
        ("x", False),
    ]

"""Formulas of the documentation: TeX between dollar signs, or in a block fenced with `math`, becomes MathML
when the site is built. A code host renders both ways of writing too.
"""

from __future__ import annotations

import io
import re
from collections.abc import Iterator
from functools import cache
from html import escape, unescape
from typing import Any

from math_core import LatexError, LatexToMathML

FENCE = re.compile(r"^```(\w*)[^\n]*\n(.*?)^```[ ]*$", re.MULTILINE | re.DOTALL)
CODE = re.compile(r"(`+).+?(?<!`)\1(?!`)", re.DOTALL)
# No space inside the dollar signs, no digit behind them, no empty line between them: prices stay prices.
INLINE = r"(?<![\\$])\$(?![\s$])((?:(?!\n\s*\n)[^$])+?)(?<![\s\\])\$(?![\d$])"
# What a browser draws although it is not in the text: italic letters, and the sign of a root.
DRAWN = [*range(0x1D434, 0x1D468), 0x210E, *range(0x1D6E2, 0x1D71C), 0x221A]
TAG = re.compile(r"\\tag\{([^{}]+)\}")


@cache
def converter() -> LatexToMathML:
    return LatexToMathML(fancy_error=False)


def mathml(latex: str, *, display: bool = False) -> str:
    """MathML of a formula.

    Raises
    ------
    ValueError
        The formula has a command or a structure that cannot be set.
    """
    try:
        return converter().convert_with_local_state(latex.strip(), displaystyle=display)
    except LatexError as error:
        raise ValueError(f"formula {latex.strip()!r}: {error}") from error


def display(latex: str) -> str:
    """HTML of a displayed equation, with the number of its tag and an anchor to link to."""
    numbers = TAG.findall(latex)
    set_formula = mathml(TAG.sub("", latex), display=True)
    if not numbers:
        return f'<div class="equation">{set_formula}</div>'
    number = escape(numbers[0])
    anchor = "eq-" + re.sub(r"[^0-9a-z]+", "-", number.lower()).strip("-")
    return f'<div class="equation" id="{anchor}">{set_formula}<span class="number">({number})</span></div>'


def font(html: str) -> bytes:
    """Cuts STIX Two Math to the characters of the formulas in the pages, as WOFF, for devices without a font
    that has the sizes and positions of mathematics. It comes with ziamath, under the Open Font License."""
    from importlib.resources import files

    from fontTools.subset import Options, Subsetter
    from fontTools.ttLib import TTFont

    source = TTFont(io.BytesIO((files("ziamath") / "fonts" / "STIXTwoMath-Regular.ttf").read_bytes()))
    characters = set(
        unescape(re.sub(r"<[^>]+>", "", "".join(re.findall(r"<math\b.*?</math>", html, re.DOTALL))))
    )
    subset = Subsetter(Options(layout_features=["*"], name_IDs=[0, 1, 2, 3, 4, 5, 6, 13, 14]))
    subset.populate(unicodes=[*map(ord, characters), *DRAWN])
    subset.subset(source)
    source.flavor = "woff"
    out = io.BytesIO()
    source.save(out)
    return out.getvalue()


def formulas(page: str) -> Iterator[tuple[str, bool]]:
    """Formulas of a page in Markdown, each with whether it is displayed."""
    for language, text in FENCE.findall(page):
        if language == "math":
            yield text, True
    prose = CODE.sub("", FENCE.sub("", page))
    for found in re.finditer(INLINE, prose):
        yield found[1], False


def formatter(source: str, *_: Any, **__: Any) -> str:
    """Sets a fenced block of the language `math`, for the extension SuperFences."""
    from pymdownx.superfences import SuperFencesException

    try:
        return display(source)
    except ValueError as error:
        raise SuperFencesException(str(error)) from error


def extension() -> Any:
    """Extension of Python-Markdown for formulas between dollar signs."""
    from markdown import Extension, Markdown
    from markdown.inlinepatterns import InlineProcessor

    class Formula(InlineProcessor):
        """Sets one formula; escapes and emphasis inside it are left to TeX."""

        def handleMatch(self, m: re.Match[str], data: str) -> tuple[str, int, int]:  # noqa: N802
            return self.md.htmlStash.store(mathml(m[1])), m.start(0), m.end(0)

    class Formulas(Extension):
        """Formulas between dollar signs."""

        def extendMarkdown(self, md: Markdown) -> None:  # noqa: N802
            # After code spans (190), before escapes (180).
            md.inlinePatterns.register(Formula(INLINE, md), "formula", 185)

    return Formulas()

"""Text in pictures."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .errors import printable

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def as_written(drawn: Figure) -> None:
    """Draw the texts of a figure literally: replace control characters, and draw $ as a character.

    >>> from matplotlib.figure import Figure
    >>> drawn = Figure()
    >>> title = drawn.suptitle("Costs $5\\x1b a $tonne")
    >>> as_written(drawn)
    >>> title.get_text(), title.get_parse_math()
    ('Costs $5? a $tonne', False)
    """
    from matplotlib.text import Text

    for words in drawn.findobj(Text):
        words.set_text(printable(words.get_text()))
        words.set_parse_math(False)

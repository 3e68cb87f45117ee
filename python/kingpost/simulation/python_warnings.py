"""Warnings of a run as Python warnings."""

from __future__ import annotations

import re
import sys
import warnings
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from ..errors import KingpostWarning

PACKAGE = str(Path(__file__).parents[1])
NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(\.\d+)?(e[-+]?\d+)?(?!\w)")
"""A number among words; a digit within a name is none."""


ONCE = ("default", "module", "once")
"""Actions of Python's filters that show a warning once for each line of a program."""
_SHOWN: set[tuple[str, int, str]] = set()
"""File, line and kind of each warning that was shown: Python's own registry is cleared whenever a library
changes a filter."""


def _kind(words: str) -> str:
    """Words of a warning without its numbers: in a loop of runs the same warning has other numbers.

    >>> _kind("leg_1: off by -0.3 % at 1e-05 s")
    'leg_1: off by # % at # s'
    """
    return NUMBER.sub("#", words)


def _fits(pattern: str | re.Pattern[str] | None, text: str) -> bool:
    """Match a filter's pattern: none, a compiled expression or, in Python's own filters, a plain name."""
    return pattern is None or (pattern == text if isinstance(pattern, str) else bool(pattern.match(text)))


def _action(words: str, module: str, line: int) -> str:
    """Action of the first of Python's filters that matches a warning."""
    for action, pattern, category, of_module, of_line in warnings.filters:
        if (
            issubclass(KingpostWarning, category)
            and _fits(pattern, words)
            and _fits(of_module, module)
            and of_line in (0, line)
        ):
            return action
    return "default"


def emit_warnings(words: Iterable[str]) -> None:
    """Raise each as a warning that points to the line that called the package.

    Where Python shows a warning once for a line, its default, one that differs in numbers only is the same.

    >>> with warnings.catch_warnings(record=True) as told:
    ...     warnings.simplefilter("always")
    ...     emit_warnings(["ship: it heeled to 21.00 deg, at 4 s"])
    >>> told[0].category.__name__, str(told[0].message)
    ('KingpostWarning', 'ship: it heeled to 21.00 deg, at 4 s')
    """
    frame, level = sys._getframe(), 1
    while frame.f_back is not None and frame.f_code.co_filename.startswith(PACKAGE):
        frame, level = frame.f_back, level + 1
    file, line, module = frame.f_code.co_filename, frame.f_lineno, frame.f_globals.get("__name__", "")
    for one in words:
        if _action(one, module, line) in ONCE:
            place = (file, line, _kind(one))
            if place in _SHOWN:
                continue
            _SHOWN.add(place)
        warnings.warn(one, KingpostWarning, stacklevel=level)


def record_warnings(attributes: dict[str, Any], words: Iterable[str]) -> None:
    """Store warnings of an analysis in its attribute ``warning``, each once, and raise each as a warning.

    >>> attributes = {}
    >>> with warnings.catch_warnings(record=True) as told:
    ...     warnings.simplefilter("always")
    ...     record_warnings(attributes, ["a list of 4.7 deg", "a list of 4.7 deg"])
    >>> attributes, len(told)
    ({'warning': 'a list of 4.7 deg'}, 1)
    """
    each = list(dict.fromkeys(words))
    if each:
        attributes["warning"] = "; ".join(each)
        emit_warnings(each)

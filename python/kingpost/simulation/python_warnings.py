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
"""Pattern of a number in a text; a digit within a name does not count."""


ONCE = ("default", "module", "once")
"""Filter actions of Python that show a warning only once for each line of a program."""
_SHOWN: set[tuple[str, int, str]] = set()
"""File, line and kind of each shown warning: Python's registry is cleared whenever a library changes a
filter."""


def _kind(words: str) -> str:
    """Text of a warning without its numbers, which differ between the runs of a loop.

    >>> _kind("leg_1: off by -0.3 % at 1e-05 s")
    'leg_1: off by # % at # s'
    """
    return NUMBER.sub("#", words)


def _fits(pattern: str | re.Pattern[str] | None, text: str) -> bool:
    """Whether a text matches a filter's pattern: none, a compiled expression or, in Python's default filters,
    a plain name."""
    return pattern is None or (pattern == text if isinstance(pattern, str) else bool(pattern.match(text)))


def _action(words: str, module: str, line: int) -> str:
    """Action of the first filter of Python that matches a warning."""
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
    """Emit each as a Python warning at the line that called the package. If Python shows a warning once per
    line, the default, warnings that differ only in numbers count as the same.

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
    """Store warnings of an analysis in its attribute ``warning``, each once, and emit each as a Python
    warning.

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

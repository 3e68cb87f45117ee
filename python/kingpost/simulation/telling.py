"""Warnings of a run as Python warnings."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from ..errors import KingpostWarning

PACKAGE = str(Path(__file__).parents[1])


def tell(words: Iterable[str]) -> None:
    """Raise each as a warning that points to the line that called the package.

    >>> with warnings.catch_warnings(record=True) as told:
    ...     warnings.simplefilter("always")
    ...     tell(["ship: it heeled to 21.00 deg, at 4 s"])
    >>> told[0].category.__name__, str(told[0].message)
    ('KingpostWarning', 'ship: it heeled to 21.00 deg, at 4 s')
    """
    frame, level = sys._getframe(), 1
    while frame.f_back is not None and frame.f_code.co_filename.startswith(PACKAGE):
        frame, level = frame.f_back, level + 1
    for one in words:
        warnings.warn(one, KingpostWarning, stacklevel=level)


def note_warnings(attributes: dict[str, Any], words: Iterable[str]) -> None:
    """Store warnings of an analysis in its attribute ``warning``, each once, and raise each as a warning.

    >>> attributes = {}
    >>> with warnings.catch_warnings(record=True) as told:
    ...     warnings.simplefilter("always")
    ...     note_warnings(attributes, ["a list of 4.7 deg", "a list of 4.7 deg"])
    >>> attributes, len(told)
    ({'warning': 'a list of 4.7 deg'}, 1)
    """
    each = list(dict.fromkeys(words))
    if each:
        attributes["warning"] = "; ".join(each)
        tell(each)

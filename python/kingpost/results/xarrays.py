"""Loads xarray late, because it takes a second, and calls what waits for it."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from types import ModuleType

_waiting: list[Callable[[Any], None]] = []


def when_loaded(register: Callable[[Any], None]) -> None:
    """Call `register` with xarray: now where it is loaded, else with the first data set."""
    _waiting.append(register)
    if "xarray" in sys.modules:
        load()


def load() -> ModuleType:
    """Load xarray, call what waits for it, and return it."""
    import xarray

    while _waiting:
        _waiting.pop()(xarray)
    return xarray

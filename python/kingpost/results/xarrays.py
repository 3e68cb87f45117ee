"""Deferred import of xarray, which takes a second, with functions that run after it."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from types import ModuleType

_waiting: list[Callable[[Any], None]] = []


def when_loaded(register: Callable[[Any], None]) -> None:
    """Call `register` with xarray: at once if xarray is loaded, otherwise with the first data set."""
    _waiting.append(register)
    if "xarray" in sys.modules:
        load()


def load() -> ModuleType:
    """Import xarray, call the registered functions, and return xarray."""
    import xarray

    while _waiting:
        _waiting.pop()(xarray)
    return xarray

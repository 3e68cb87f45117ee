"""The compiled engine, in the build that fits this processor.

Where the processor has AVX2 and the package carries a build for it, that is the one. Both give the
same bits: AVX2 makes the registers wider, and nothing fuses multiplication and addition.
"""

from __future__ import annotations

from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING

from . import _engine as plain

if TYPE_CHECKING:
    from . import _engine as engine


def _for_this_processor() -> ModuleType:
    if plain.has_avx2():
        try:
            return import_module("kingpost.avx2._engine")
        except ModuleNotFoundError:
            pass
    return plain


if not TYPE_CHECKING:
    engine = _for_this_processor()

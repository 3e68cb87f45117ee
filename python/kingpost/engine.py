"""The compiled engine, in the build for this processor.

A wheel carries a second build for AVX2, which is used if the processor has AVX2. A build from source has one
module, for the processor that it was built on. All builds give the same bits: AVX2 only makes the registers
wider, and no build fuses a multiplication with an addition.
"""

from __future__ import annotations

from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING

from . import _engine as packed

if TYPE_CHECKING:
    from . import _engine as engine


def _for_this_processor() -> ModuleType:
    if packed.has_avx2():
        try:
            return import_module("kingpost.avx2._engine")
        except ModuleNotFoundError:
            pass
    return packed


if not TYPE_CHECKING:
    engine = _for_this_processor()


def source_digest() -> str:
    """SHA-256 of the engine's sources: the same for the builds for all processors, which give the same bits.

    >>> len(source_digest())
    64
    """
    return engine.__source_digest__

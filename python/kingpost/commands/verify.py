"""`kingpost verify`: what is verified, measured now."""

from __future__ import annotations

from ..verify.command import add_options as add_options
from ..verify.command import command as run

__all__ = ["HELP", "add_options", "run"]

HELP = "measure what is verified, now, and say whether it holds"

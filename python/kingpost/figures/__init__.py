"""Figures: runs that can be played in an article, as a folder for a static host."""

from .folder import Choice, write

__all__ = ["Choice", "write"]

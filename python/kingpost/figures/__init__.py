"""Figures: runs that can be played in an article, as a folder for a static host."""

from .folder import Choice, checked, write

__all__ = ["Choice", "checked", "write"]

"""Hydrodynamics of a hull: from its shape to one database of coefficients.

`database` is the file that every part reads; the rest makes such files.
"""

from .database import Database, read, write

__all__ = ["Database", "read", "write"]

"""Hydrodynamics of a hull: from its shape to one database of coefficients.

`database` is the file that every part reads; the rest makes such files.
"""

from .database import Database, read, write
from .memory import retardation
from .radiation_fit import fit, impulse_response

__all__ = ["Database", "fit", "impulse_response", "read", "retardation", "write"]

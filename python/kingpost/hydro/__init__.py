"""Hydrodynamics of a hull: from its shape to one database of coefficients.

All parts use `database`, read from a file; the other modules make such files.
"""

from .database import Database
from .database_file import read, write
from .dataset import to_dataset
from .memory import retardation
from .radiation_fit import fit, impulse_response

__all__ = ["Database", "fit", "impulse_response", "read", "retardation", "to_dataset", "write"]

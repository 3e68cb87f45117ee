"""Hydrodynamics of a hull: from its shape to one database of coefficients.

`database` is what every part reads, from a file; the rest makes such files.
"""

from .database import Database
from .database_file import read, write
from .dataset import to_dataset
from .memory import retardation
from .radiation_fit import fit, impulse_response

__all__ = ["Database", "fit", "impulse_response", "read", "retardation", "to_dataset", "write"]

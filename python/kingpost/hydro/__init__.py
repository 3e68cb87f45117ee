"""Hydrodynamics of hulls: from the shape of one, or of several beside each other, to one database of
coefficients.

All parts use `database`, read from a file; the other modules make such files.
"""

from .database import Database
from .database_file import read, read_several, write
from .dataset import to_dataset
from .memory import retardation
from .radiation_fit import fit, impulse_response
from .several import Place, PlacedHull, SeveralHulls

__all__ = [
    "Database",
    "Place",
    "PlacedHull",
    "SeveralHulls",
    "fit",
    "impulse_response",
    "read",
    "read_several",
    "retardation",
    "to_dataset",
    "write",
]

"""Results: recorded rows as a labelled data set, its flat columns, and its files."""

from .columns import column, column_name, columns, floating_bodies, frame, unit_coordinate, unit_of
from .dataset import attributes, dataset
from .events import events, warnings
from .files import ENDINGS, check_output, check_parquet, open_all, read, write
from .units import NAMES

__all__ = [
    "ENDINGS",
    "NAMES",
    "attributes",
    "check_output",
    "check_parquet",
    "column",
    "column_name",
    "columns",
    "dataset",
    "events",
    "floating_bodies",
    "frame",
    "open_all",
    "read",
    "unit_coordinate",
    "unit_of",
    "warnings",
    "write",
]

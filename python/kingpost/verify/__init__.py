"""Verification that any user can repeat: rows measured with the installed package.

`kingpost verify` prints them. Each compares a number of the engine with an independent one: a
closed form, a published value, another engine, a measurement. To add a row, write one function with the
decorator `rows.check` in the file of its area.

>>> from kingpost import verify
>>> rows = verify.run("loops")
>>> {row.verdict for row in rows}
{'pass'}
"""

from .rows import ABSENT, AREAS, CHECKS, FAILED, PASSED, Check, Compared, NotInstalledError, Row, check
from .running import run

__all__ = [
    "ABSENT",
    "AREAS",
    "CHECKS",
    "FAILED",
    "PASSED",
    "Check",
    "Compared",
    "NotInstalledError",
    "Row",
    "check",
    "run",
]

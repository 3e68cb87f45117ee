"""Measurement of all rows, or those of one area."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module

from ..errors import KingpostError
from .rows import AREAS, CHECKS, Check, Row, measured

FURTHER = (
    "tops",
    "flume_forces",
    "cylinders",
    "rolling",
    "spheres",
    "ropes",
    "wave_energy",
    "swimming",
    "lowering",
    "moored_lines",
    "chain_tensions",
)
FILES = (*AREAS, *FURTHER)
"""The modules of the rows: one for each area, and some for further rows."""


def checks(only: str | None = None) -> list[Check]:
    """The rows of an area, or all, in the order of `AREAS`.

    >>> {one.area for one in checks("mooring")}
    {'mooring'}
    """
    if only is not None and only not in AREAS:
        raise KingpostError(f"area: found {only!r}, allowed: {', '.join(AREAS)}")
    for area in FILES:
        import_module(f".{area}", __package__)
    return [one for area in AREAS for one in CHECKS if one.area == area and only in (None, area)]


def run(only: str | None = None, progress: Callable[[int], None] = lambda _done: None) -> list[Row]:
    """Measure every row, or those of one area, now.

    Parameters
    ----------
    only
        One of `AREAS`.
    progress
        Called with the number of measured rows.

    Returns
    -------
    list of Row
        The rows with their measured numbers and verdicts.

    Raises
    ------
    KingpostError
        If there is no such area. A failing row is returned like any other; it raises no error.

    >>> {row.verdict for row in run("integrators")}
    {'pass'}
    """
    rows = []
    for one in checks(only):
        rows.append(measured(one))
        progress(len(rows))
    return rows

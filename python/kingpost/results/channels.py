"""Channels of a recorded row, as the engine describes them."""

from __future__ import annotations

from typing import TypedDict


class Channel(TypedDict):
    """Variable of the results: its names, units, dimensions and place in a row.

    `unit` is None if the units of its numbers differ; `units` and `columns` have one entry for each number.
    """

    variable: str
    long_name: str
    description: str
    unit: str | None
    units: list[str]
    frame: str
    dims: list[str]
    labels: list[list[str]]
    column: str
    columns: list[str]
    of_elements: bool
    offset: int
    len: int

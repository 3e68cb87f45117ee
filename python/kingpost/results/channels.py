"""Channels of a recorded row, as the engine describes them."""

from __future__ import annotations

from typing import TypedDict


class PlacesAlong(TypedDict):
    """Places along lines of the labels of a channel.

    `lines` has the line of each label, `shares` its place on it, as a share of the unstretched length from
    the first end; `length` is the variable with that length, m.
    """

    lines: list[str]
    shares: list[float]
    length: str


class Channel(TypedDict):
    """Variable of the results: its names, units, dimensions and place in a row.

    `unit` is None if the units of its numbers differ; `units` and `columns` have one entry for each number.
    `along` is None unless its labels are points along lines.
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
    along: PlacesAlong | None
    of_elements: bool
    offset: int
    len: int

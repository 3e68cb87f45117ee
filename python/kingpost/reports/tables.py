"""Text tables, and numbers formatted for them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

HUGE = 1e10
"""Magnitude from which on no decimals are printed."""
LARGEST_IN_KG = 2e4
"""Largest mass in a table in kg; a table with a larger mass is in t."""


def table(rows: Iterable[Sequence[str]], align: str = "") -> list[str]:
    """Cells in columns; `align` has ``<`` or ``>`` for each (default: the first ``<``).

    >>> table([("ship", "1"), ("arm", "10")])
    ['ship   1', 'arm   10']
    >>> table([("ship", "1"), ("arm", "10")], "><")
    ['ship  1', ' arm  10']
    """
    rows = list(rows)
    if not rows:
        return []
    align = align or "<".ljust(len(rows[0]), ">")
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    formats = [f"{{:{side}{width}}}" for side, width in zip(align, widths, strict=True)]
    form = "  ".join(formats)
    return [form.format(*row).rstrip() for row in rows]


def fixed(value: float, places: int) -> str:
    """A number with a fixed count of decimals and no sign on a zero; a huge number gets five digits.

    >>> fixed(-0.00001, 4), fixed(-0.0617, 4), fixed(1e300, 4)
    ('0.0000', '-0.0617', '1e+300')
    """
    if abs(value) >= HUGE:
        return f"{value:.5g}"
    return f"{value:z.{places}f}"


def significant(value: float, scale: float) -> str:
    """A number with five digits; 0 if it is a rounding error relative to `scale`.

    >>> significant(17922.43, 2e4), significant(1e-8, 2e4)
    ('17922', '0')
    """
    return f"{0.0 if abs(value) < 1e-12 * scale else value:.5g}"


def joules(value: float) -> str:
    """Format an energy with a prefix suited to its magnitude.

    >>> joules(171588.0), joules(-0.0)
    ('171.588 kJ', '0 J')
    """
    for size, unit in ((1e9, "GJ"), (1e6, "MJ"), (1e3, "kJ")):
        if abs(value) >= size:
            return f"{value / size:.6g} {unit}"
    return f"{value + 0.0:.6g} J"


def kilograms(value: float) -> str:
    """Format a mass, a large one in t.

    >>> kilograms(1.19e7), kilograms(500.0), kilograms(10000.0)
    ('11900 t', '500 kg', '10000 kg')
    """
    return masses([value])[0]


def of_the_time(percentile: float) -> str:
    """Format the percentage of the time for which a limit must hold, if it is not all.

    >>> of_the_time(100.0), of_the_time(99.5)
    ('', ' for 99.5 % of the time')
    """
    return "" if percentile >= 100 else f" for {percentile:g} % of the time"


def unit_cell(unit: str) -> str:
    """Format a unit for a table; empty for a dimensionless number.

    >>> unit_cell("kN"), unit_cell("1")
    ('kN', '')
    """
    return "" if unit == "1" else unit


def masses(values: Sequence[float]) -> list[str]:
    """Masses of one table, all in t if the largest needs it, else all in kg.

    >>> masses([5.434e6, 500.0]), masses([500.0, 2000.0])
    (['5434 t', '0.5 t'], ['500 kg', '2000 kg'])
    """
    if max(map(abs, values), default=0.0) > LARGEST_IN_KG:
        return [f"{value / 1000:.7g} t" for value in values]
    return [f"{value:.6g} kg" for value in values]


def largest(values: np.ndarray) -> float:
    """Return the value with the largest magnitude, with its sign.

    >>> float(largest(np.array([1.0, -3.0, 2.0])))
    -3.0
    """
    return values[np.argmax(np.abs(values))]

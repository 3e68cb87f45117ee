"""Matrices of the moving frame method: numbers with labels and units, and formulas."""

from __future__ import annotations

import csv
import json
import re
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import output
from ..errors import KingpostError

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

ENVIRONMENTS = ("bmatrix", "pmatrix", "array")
NOISE = 1e-12
"""Entries below this fraction of a matrix's largest entry are printed as 0."""


@dataclass(frozen=True)
class Formula:
    """A matrix as block formulas in the paper's notation.

    Attributes
    ----------
    name, symbol, equation
        Key of the matrix, its symbol in LaTeX, and the paper's equation.
    rows, columns
        Names of the block rows and columns, in LaTeX.
    blocks
        Blocks by row, in LaTeX.
    """

    name: str
    symbol: str
    equation: str
    rows: list[str]
    columns: list[str]
    blocks: list[list[str]]

    def block(self, row: int, column: int) -> str:
        """A block by the paper's indices, which count from 1: B_52 is ``block(5, 2)``."""
        try:
            return self.blocks[_from_one(row)][_from_one(column)]
        except IndexError:
            size = f"1 to {len(self.blocks)} and 1 to {len(self.blocks[0])}"
            raise KingpostError(f"{self.name}: no block ({row}, {column}), allowed: {size}") from None

    def latex(self, environment: str = "bmatrix") -> str:
        """The equation in LaTeX; ``array`` adds the names of rows and columns.

        A matrix of two blocks only is written without brackets.
        """
        if self.blocks == [self.blocks[0][:1]]:
            return f"{self.symbol} = {self.blocks[0][0]}"
        return f"{self.symbol} = {_environment(environment, self.blocks, self.rows, self.columns)}"

    def _repr_latex_(self) -> str:
        return rf"$\displaystyle {self.latex()}$"


class MovingFrame(dict[str, "xarray.DataArray"]):
    """The matrices at one instant by name, with their LaTeX, their formulas and their CSV files.

    Each is an array with dimensions ``row`` and ``column`` and the coordinates ``row_unit`` and
    ``column_unit``: it maps a vector in the units of its columns to a vector in the units of its rows. The
    coordinate ``unit`` gives the unit of each entry.
    """

    def __init__(self, blocks: Iterable[tuple[Any, ...]], symbols_json: Callable[[bool], str]) -> None:
        super().__init__({block[0]: matrix(*block) for block in blocks})
        self._symbols_json = symbols_json

    def formulas(self, names: bool = False) -> dict[str, Formula]:
        """The blocks as formulas, with bodies by number as in the paper, or by name.

        >>> from kingpost import Simulation, load
        >>> formulas = Simulation(load("paper")).moving_frame().formulas()
        >>> print(formulas["B"].block(5, 4))
        R^{(1)} R^{(2/1)} R^{(3/2)} S(s_{C_{3}})^T e_y
        """
        return {entry["name"]: Formula(**entry) for entry in json.loads(self._symbols_json(names))}

    def latex(self, name: str, environment: str = "bmatrix", digits: int = 4) -> str:
        """One matrix in LaTeX, see `latex`."""
        return latex(self[name], environment, digits)

    def write_csv(self, folder: str | Path) -> list[Path]:
        """Write each matrix to a separate file, see `write_csv`; return the files.

        ``E_tower/ship`` is written to ``E_tower-ship.csv``.
        """
        folder = Path(folder)
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise KingpostError(f"{folder}: cannot be written: {error.strerror}") from None
        return [write_csv(matrix, folder / f"{name.replace('/', '-')}.csv") for name, matrix in self.items()]


def matrix(
    name: str, values: NDArray[np.float64], labels: Sequence[list[str]], units: Sequence[list[str]]
) -> xarray.DataArray:
    """A matrix with the labels and the units of its rows and of its columns.

    >>> inertia = matrix("M_star", np.ones((1, 1)), [["slew"], ["slew"]], [["N m"], ["rad/s^2"]])
    >>> inertia.attrs["units"]
    'kg m^2'
    """
    import xarray

    entries = [entry_unit(row, column) for row in units[0] for column in units[1]]
    by_entry = np.array(entries, str).reshape(len(units[0]), len(units[1]))
    coordinates = {
        "row": labels[0],
        "column": labels[1],
        "row_unit": ("row", units[0]),
        "column_unit": ("column", units[1]),
        "unit": (("row", "column"), by_entry),
    }
    different = set(by_entry.ravel().tolist())
    unit = different.pop() if len(different) == 1 else "by row and column"
    return xarray.DataArray(values, coordinates, ("row", "column"), name, {"units": unit})


def entry_unit(row: str, column: str) -> str:
    """Unit of an entry: the unit of its row over the unit of its column, without radians.

    >>> entry_unit("N m", "rad/s^2"), entry_unit("m/s", "rad/s"), entry_unit("N", "m/s"), entry_unit("m", "m")
    ('kg m^2', 'm', 'kg/s', '1')
    >>> entry_unit("rad/s", "1")
    'rad/s'
    """
    if column == "1":
        return row
    powers = _powers(row)
    powers.subtract(_powers(column))
    above = [_power(unit, powers[unit]) for unit in ("kg", "m", "s") if powers[unit] > 0]
    below = [_power(unit, -powers[unit]) for unit in ("kg", "m", "s") if powers[unit] < 0]
    return (" ".join(above) or "1") + "".join(f"/{unit}" for unit in below)


def latex(matrix: xarray.DataArray, environment: str = "bmatrix", digits: int = 4) -> str:
    r"""A matrix of numbers in LaTeX, in ``bmatrix``, ``pmatrix`` or a labelled ``array``.

    Numbers are rounded to `digits` significant digits; entries below 1e-12 of the largest become 0.

    >>> row = matrix("M", np.array([[57260.4, 1e-15]]), [["a"], ["a", "b"]], [["N"], ["1", "1"]])
    >>> print(latex(row))
    \begin{bmatrix} 57260 & 0 \end{bmatrix}
    >>> print(latex(row, "array", digits=2))
    \begin{array}{l|rr} & \mathrm{a} & \mathrm{b} \\ \hline \mathrm{a} & 57000 & 0 \end{array}
    """
    values = np.atleast_2d(matrix.values)
    noise = NOISE * np.abs(values).max(initial=0.0)
    cells = [[number(0.0 if abs(value) <= noise else value, digits) for value in row] for row in values]
    rows, columns = ([_roman(str(label)) for label in matrix[side].values] for side in matrix.dims)
    return _environment(environment, cells, rows, columns)


def number(value: float, digits: int = 4) -> str:
    r"""A number in LaTeX with `digits` significant digits; from a million on with a power of ten.

    >>> number(0.25), number(-1.23456e-7), number(28700.0)
    ('0.25', '-1.235 \\times 10^{-7}', '28700')
    """
    if digits < 1:
        raise KingpostError(f"digits: found {digits}, allowed: 1 or more")
    text = f"{value:.{digits}g}"
    if "e+" in text and abs(float(text)) < 1e6:
        text = f"{float(text):.0f}"
    mantissa, _, exponent = text.partition("e")
    return rf"{mantissa} \times 10^{{{int(exponent)}}}" if exponent else mantissa


def write_csv(matrix: xarray.DataArray, path: str | Path) -> Path:
    """Write a matrix: labels in the first row and column, units in the second, numbers in full.

    Read it back with ``pandas.read_csv(path, header=[0, 1], index_col=[0, 1],
    float_precision="round_trip")``.
    """
    path = Path(path)
    head = [
        [str(matrix.name), "", *matrix["column"].values],
        ["", "unit", *matrix["column_unit"].values],
    ]
    labels = zip(matrix["row"].values, matrix["row_unit"].values, matrix.values.tolist(), strict=True)
    with output.whole(path) as beside, beside.open("w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows([*head, *([label, unit, *row] for label, unit, row in labels)])
    return path


def _environment(
    environment: str, cells: Sequence[Sequence[str]], rows: Sequence[str], columns: Sequence[str]
) -> str:
    if environment not in ENVIRONMENTS:
        raise KingpostError(f"environment: found {environment}, allowed: {', '.join(ENVIRONMENTS)}")
    lines = [" & ".join(row) for row in cells]
    if environment != "array":
        return rf"\begin{{{environment}}} " + r" \\ ".join(lines) + rf" \end{{{environment}}}"
    labelled = [f"{label} & {line}" for label, line in zip(rows, lines, strict=True)]
    head = " & ".join(["", *columns]).strip()
    sides = f"l|{'r' * len(columns)}"
    return rf"\begin{{array}}{{{sides}}} {head} \\ \hline " + r" \\ ".join(labelled) + r" \end{array}"


def _roman(label: str) -> str:
    return rf"\mathrm{{{label.replace('_', chr(92) + '_')}}}"


def _from_one(index: int) -> int:
    if index < 1:
        raise IndexError(index)
    return index - 1


def _powers(unit: str) -> Counter[str]:
    """Powers of kg, m and s in a unit such as ``N m`` or ``rad/s^2``."""
    powers: Counter[str] = Counter()
    for sign, part in zip((1, -1), unit.split("/"), strict=False):
        for name, exponent in re.findall(r"([A-Za-z]+)(?:\^(\d+))?", part):
            base = {"N": {"kg": 1, "m": 1, "s": -2}, "rad": {}}.get(name, {name: 1})
            powers.update({key: sign * count * int(exponent or 1) for key, count in base.items()})
    return powers


def _power(unit: str, exponent: int) -> str:
    return unit if exponent == 1 else f"{unit}^{exponent}"

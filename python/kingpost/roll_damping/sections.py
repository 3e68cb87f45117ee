"""A hull as a series of sections: beam, draught, area and bilge radius at stations."""

from __future__ import annotations

import csv
import io
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..errors import RollDampingError, shortened
from ..reading import text_of

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import ArrayLike

Array = NDArray[np.float64]

COLUMNS = "x_m,beam_m,draught_m and area_m2 or area_coefficient; bilge_radius_m is optional"
FEWEST_STATIONS = 3
SMALLEST, LARGEST = 1e-9, 1e9
"""Bounds of a hull's dimensions, m and m2: powers of smaller and of larger numbers overflow."""
# Straight edges of a mesh and rounded tables may give an area slightly above that of the rectangle.
FULLEST = 1.0 + 1e-3
THINNEST = 0.01


@dataclass(frozen=True)
class Sections:
    """Sections of the wetted hull in the order of x. Arrays, one number for each:

    Attributes
    ----------
    x_m
        Position along the ship, forward, in any frame.
    length_m
        Length of ship that the section represents.
    beam_m, draught_m
        Greatest breadth and greatest depth under the water plane.
    area_m2
        Area under the water plane, both sides.
    bilge_radius_m
        Radius of the bilge.
    ends_m
        The ends of the wetted hull along x.

    >>> box = Sections.of_table({"x_m": [0, 50, 100], "beam_m": [20] * 3, "draught_m": [5] * 3,
    ...     "area_coefficient": [0.98] * 3})
    >>> round(box.volume_m3), round(float(box.bilge_radius_m[0]), 2)
    (9800, 2.16)
    """

    x_m: Array
    length_m: Array
    beam_m: Array
    draught_m: Array
    area_m2: Array
    bilge_radius_m: Array
    ends_m: tuple[float, float]

    @classmethod
    def of_table(cls, columns: Mapping[str, ArrayLike], file: str | None = None) -> Sections:
        """Sections from columns of a table, with the trapezoidal rule between stations.

        Raises
        ------
        RollDampingError
            If a column is missing, or a value is impossible for a section.
        """
        given = {name: np.asarray(values, float) for name, values in columns.items()}
        areas = {"area_m2", "area_coefficient"} & given.keys()
        if not {"x_m", "beam_m", "draught_m"} <= given.keys() or len(areas) != 1:
            raise RollDampingError("columns", shortened(", ".join(given)) or "none", COLUMNS, file)
        order = np.argsort(given["x_m"], kind="stable")
        given = {name: values[order] for name, values in given.items()}
        _check(given, file)
        x, beam, draught = given["x_m"], given["beam_m"], given["draught_m"]
        area = given["area_m2"] if "area_m2" in given else given["area_coefficient"] * beam * draught
        area = np.minimum(area, beam * draught)
        radius = given.get("bilge_radius_m", estimated_bilge_radius(beam, draught, area))
        steps = np.diff(x)
        length = (np.append(steps, 0.0) + np.append(0.0, steps)) / 2
        return cls(x, length, beam, draught, area, radius, (float(x[0]), float(x[-1])))

    @classmethod
    def read(cls, path: str | Path) -> Sections:
        """Sections from a CSV file: a line of names, a line for each section; ``#`` begins a remark.

        The columns are ``x_m``, ``beam_m``, ``draught_m``, ``area_m2`` or ``area_coefficient``, and
        optionally ``bilge_radius_m``.
        """
        return cls.of_table(read_columns(path), str(path))

    @property
    def area_coefficient(self) -> Array:
        """sigma = A / (B d)."""
        return self.area_m2 / (self.beam_m * self.draught_m)

    @property
    def volume_m3(self) -> float:
        """Displaced volume."""
        return float(self.area_m2 @ self.length_m)

    @property
    def total_length_m(self) -> float:
        """Length of the wetted hull."""
        return self.ends_m[1] - self.ends_m[0]

    @property
    def midship(self) -> int:
        """The section of the largest area; among several equal ones, the middle one."""
        largest = np.flatnonzero(self.area_m2 >= self.area_m2.max() * (1 - 1e-6))
        return int(largest[len(largest) // 2])

    @property
    def block_coefficient(self) -> float:
        """C_B = V / (L B d), with the largest beam and draught."""
        return self.volume_m3 / (self.total_length_m * self.beam_m.max() * self.draught_m.max())

    @property
    def midship_coefficient(self) -> float:
        """C_M = A / (B d) of the largest section, B and d being the largest of the ship."""
        return float(self.area_m2.max() / (self.beam_m.max() * self.draught_m.max()))

    def at(self, x_m: Array) -> Sections:
        """Sections between the stations by linear interpolation; their length is zero."""
        between = {
            name: np.interp(x_m, self.x_m, getattr(self, name))
            for name in ("beam_m", "draught_m", "area_m2", "bilge_radius_m")
        }
        return replace(self, x_m=x_m, length_m=np.zeros_like(x_m), **between)

    def scaled(self, factor: float) -> Sections:
        """A geometrically similar hull, `factor` times as long."""
        lengths = ("x_m", "length_m", "beam_m", "draught_m", "bilge_radius_m")
        found = {name: factor * getattr(self, name) for name in lengths}
        ends = factor * self.ends_m[0], factor * self.ends_m[1]
        return replace(self, area_m2=factor**2 * self.area_m2, ends_m=ends, **found)

    def with_draught(self, draught_m: float) -> Sections:
        """Sections of the same areas with a given greatest draught.

        The meshes of parametric hulls are deeper than the hull, to compensate for the area lost to flat
        panels.
        """
        draught = self.draught_m * (draught_m / self.draught_m.max())
        area = np.minimum(self.area_m2, self.beam_m * draught)
        radius = estimated_bilge_radius(self.beam_m, draught, area)
        return replace(self, draught_m=draught, area_m2=area, bilge_radius_m=radius)


def estimated_bilge_radius(beam_m: Array, draught_m: Array, area_m2: Array) -> Array:
    """Radius of the quarter circles that leave a section its area between flat sides and bottom.

    A = B d - 2 (1 - pi / 4) R^2, so R = 2 d sqrt(H0 (1 - sigma) / (4 - pi)), H0 = B / 2d, and no more than
    the draught or half the beam (ITTC 7.5-02-07-04.5, 2021, eq. 57).

    >>> area = np.array([100 - 2 * (1 - np.pi / 4)])
    >>> round(estimated_bilge_radius(np.array([20.0]), np.array([5.0]), area).item(), 12)
    1.0
    """
    radius = np.sqrt(np.maximum(beam_m * draught_m - area_m2, 0.0) / (2 - np.pi / 2))
    return np.minimum(radius, np.minimum(draught_m, beam_m / 2))


def _check(given: Mapping[str, Array], file: str | None) -> None:
    for name, values in given.items():
        bad = values[~np.isfinite(values)]
        if len(bad):
            raise RollDampingError(name, f"{bad[0]}", "finite numbers", file)
    x = given["x_m"]
    if len(x) < FEWEST_STATIONS:
        raise RollDampingError("sections", f"{len(x)}", f"{FEWEST_STATIONS} or more", file)
    if (np.diff(x) <= 0).any():
        at = x[np.flatnonzero(np.diff(x) <= 0)[0]]
        raise RollDampingError("x_m", f"{at:g} twice", "each place once", file)
    for name in ("beam_m", "draught_m", "area_m2", "area_coefficient"):
        if name in given and not (given[name] > 0).all():
            raise RollDampingError(name, f"{given[name].min():g}", "numbers greater than 0", file)
    for name, values in given.items():
        sizes = np.abs(values[values != 0])
        wrong = sizes[(sizes < SMALLEST) | (sizes > LARGEST)]
        if len(wrong):
            raise RollDampingError(
                name, f"{wrong[0]:g}", f"0, or sizes from {SMALLEST:g} to {LARGEST:g}", file
            )
    if "bilge_radius_m" in given and not (given["bilge_radius_m"] >= 0).all():
        raise RollDampingError("bilge_radius_m", f"{given['bilge_radius_m'].min():g}", "0 or more", file)
    sigma = given.get("area_coefficient")
    if sigma is None:
        with np.errstate(all="ignore"):
            sigma = given["area_m2"] / (given["beam_m"] * given["draught_m"])
    if sigma.max() > FULLEST:
        allowed = "an area of at most beam times draught"
        raise RollDampingError("area_m2", f"{sigma.max():.4g} times beam times draught", allowed, file)
    if sigma.min() < THINNEST:
        allowed = f"an area of at least {THINNEST:g} times beam times draught"
        raise RollDampingError("area_m2", f"{sigma.min():.4g} times beam times draught", allowed, file)


def read_columns(path: str | Path) -> dict[str, Array]:
    """Columns of a CSV file of numbers by the names in its first line; ``#`` begins a remark.

    Raises
    ------
    RollDampingError
        If the file cannot be read, or a number is missing in a line.
    """
    file = str(path)
    try:
        text = text_of(path)
    except UnicodeDecodeError:
        raise RollDampingError("", "a file that is not text", "a CSV file", file) from None
    except OSError as error:
        raise RollDampingError("", error.strerror, "a CSV file", file) from None
    lines = [line for line in text.splitlines() if line.strip() and not line.lstrip().startswith("#")]
    rows = list(csv.reader(io.StringIO("\n".join(lines)), skipinitialspace=True))
    if not rows:
        raise RollDampingError("", "an empty file", "a line of names, then lines of numbers", file)
    names = [name.strip() for name in rows[0]]
    values = np.empty((len(rows) - 1, len(names)))
    for number, row in enumerate(rows[1:]):
        try:
            values[number] = [float(cell) for cell in row]
        except ValueError:
            place = f"row {number + 1} after the names"
            raise RollDampingError(place, ",".join(row)[:60], f"{len(names)} numbers", file) from None
    return dict(zip(names, values.T, strict=True))

"""Rows of the verification: their definition, the list of all, and the measurement."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from time import perf_counter
from typing import Any

import numpy as np

from ..errors import KingpostError

AREAS = {
    "multibody": "Rigid bodies and joints, by closed forms",
    "paper": "The paper's crane ship",
    "integrators": "Order and stability of the integrators",
    "beams": "Flexible beams",
    "loops": "Closed loops",
    "waves": "Waves and seas",
    "hydrostatics": "Hydrostatics and stability",
    "hydrodynamics": "Added mass, damping and wave loads",
    "mooring": "Mooring lines",
    "lines": "Lines with mass",
    "flow": "Drag, wind and current",
    "positioning": "Dynamic positioning",
    "response": "Response to waves",
    "peers": "Other engines",
    "measured": "Measurements",
}
"""The areas, in the order of the table, with their titles."""

PASSED, FAILED, ABSENT = "pass", "FAIL", "not installed"


class NotInstalledError(KingpostError):
    """Error of a row whose other program is not installed; the row does not count."""


@dataclass(frozen=True)
class Compared:
    """Result of a measurement.

    Attributes
    ----------
    ours, theirs
        The two numbers, in the row's unit. For a curve, at the point of the largest difference.
    scale
        Divisor of the difference; default: the magnitude of `theirs`.
    """

    ours: float
    theirs: float
    scale: float | None = None

    @property
    def error(self) -> float:
        """Magnitude of the difference over the scale.

        >>> round(Compared(1.01, 1.0).error, 9)
        0.01
        >>> Compared(0.5, 0.0, scale=10.0).error
        0.05
        """
        scale = abs(self.theirs) if self.scale is None else self.scale
        return abs(self.ours - self.theirs) / scale


@dataclass(frozen=True)
class Check:
    """Definition of a row.

    Attributes
    ----------
    id, area, what, unit
        Name of the row, one of `AREAS`, the compared quantity, and the unit of both numbers.
    source
        Source of the other number: a law, a book, a paper, a program.
    tolerance, why
        Largest error that passes, as a share of the scale, and its reason.
    measure
        Function that measures the row.
    """

    id: str
    area: str
    what: str
    unit: str
    source: str
    tolerance: float
    why: str
    measure: Callable[[], Compared]


@dataclass(frozen=True)
class Row:
    """A measured row; missing numbers are `None`, and `message` gives the reason."""

    id: str
    area: str
    what: str
    unit: str
    source: str
    ours: float | None
    theirs: float | None
    error: float | None
    tolerance: float
    why: str
    verdict: str
    seconds: float
    message: str = ""

    def as_dict(self) -> dict[str, Any]:
        """The row as a dictionary, for JSON."""
        return asdict(self)


CHECKS: list[Check] = []
"""Every row, in the order of `AREAS`: the file of each area adds its rows."""


def check(
    name: str, what: str, *, area: str, unit: str = "1", source: str, tolerance: float, why: str
) -> Callable[[Callable[[], Compared]], Callable[[], Compared]]:
    """Add a measuring function to the list of rows.

    Parameters
    ----------
    name
        Name of the row; it must be unique.
    what
        Description of the measured quantity.
    area
        One of `AREAS`.
    unit
        Unit of both numbers.
    source
        Source of the other number.
    tolerance
        Largest difference, relative to the other number.
    why
        Reason of the tolerance.

    Returns
    -------
    Callable
        A decorator, which returns the function.

    Raises
    ------
    KingpostError
        If there is no such area, or the name is taken.

    >>> @check("two", "one and one", area="multibody", source="Peano", tolerance=1e-15, why="exact")
    ... def one_and_one():
    ...     return Compared(1.0 + 1.0, 2.0)
    >>> measured(CHECKS.pop()).verdict
    'pass'
    """
    if area not in AREAS:
        raise KingpostError(f"area: found {area!r}, allowed: {', '.join(AREAS)}")

    def add(measure: Callable[[], Compared]) -> Callable[[], Compared]:
        if any(one.id == name for one in CHECKS):
            raise KingpostError(f"id: found {name!r} twice, allowed: once")
        CHECKS.append(Check(name, area, what, unit, source, tolerance, why, measure))
        return measure

    return add


def measured(one: Check) -> Row:
    """Measure a row. A row that raises an exception has failed; its message names the exception.

    >>> def broken():
    ...     raise ValueError("no water")
    >>> row = measured(Check("x", "waves", "a wave", "m", "none", 0.1, "none", broken))
    >>> row.verdict, row.message
    ('FAIL', 'ValueError: no water')
    """
    start = perf_counter()
    try:
        found = one.measure()
        ours, theirs, error = float(found.ours), float(found.theirs), float(found.error)
        # NaN does not pass.
        verdict, message = PASSED if error <= one.tolerance else FAILED, ""
    except NotInstalledError as absent:
        ours = theirs = error = None
        verdict, message = ABSENT, str(absent)
    except Exception as failure:
        ours = theirs = error = None
        verdict, message = FAILED, " ".join(f"{type(failure).__name__}: {failure}".split())
    seconds = perf_counter() - start
    return Row(
        one.id,
        one.area,
        one.what,
        one.unit,
        one.source,
        ours,
        theirs,
        error,
        one.tolerance,
        one.why,
        verdict,
        seconds,
        message,
    )


def worst(ours: Sequence[float] | np.ndarray, theirs: Sequence[float] | np.ndarray) -> Compared:
    """Compare two curves at the point of their largest difference, relative to the largest value of the other
    curve.

    >>> worst([1.0, 2.0, 4.5], [1.0, 2.0, 4.0])
    Compared(ours=4.5, theirs=4.0, scale=4.0)
    """
    one, other = np.asarray(ours, float).ravel(), np.asarray(theirs, float).ravel()
    at = int(np.abs(one - other).argmax())
    return Compared(float(one[at]), float(other[at]), float(np.abs(other).max()))

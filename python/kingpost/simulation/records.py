"""What a simulation hands out: its state, inputs and lines, what happened, how limits held.

Units are SI, angles in radians; the world's z points up.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


@dataclass(frozen=True)
class State:
    """The motion at one instant.

    Attributes
    ----------
    time_s
        Time, s.
    q
        Positions: of a floating body x, y, z (m, world) and the quaternion w, x, y, z; then
        joint positions (rad or m). Held coordinates are included.
    v
        Velocities: of a floating body the world velocity of its centre of mass (m/s) and the
        angular velocity in body axes (rad/s); then joint rates (rad/s or m/s).
    s
        Further states of forces, drives and the energy ledger.
    """

    time_s: float
    q: NDArray[np.float64]
    v: NDArray[np.float64]
    s: NDArray[np.float64]


@dataclass(frozen=True)
class Input:
    """An input that may change during a run; it keeps its value from step to step."""

    name: str
    unit: str
    lower: float
    upper: float
    value: float


@dataclass(frozen=True)
class LimitBounds:
    """What a limit allows its column, in the column's SI unit; None where there is no bound."""

    name: str
    column: str
    at_least: float | None
    at_most: float | None


@dataclass(frozen=True)
class DrawnLine:
    """A line that a picture draws: the rope of a load, a mooring line, a tube.

    Attributes
    ----------
    name
        Whose it is.
    style
        ``rope``, ``barrel``, ``rod`` or ``pin``.
    radius_m
        0 where it is too thin to be drawn to scale.
    points_m
        In the world, m, shape (points, 3); of a pin one.
    """

    name: str
    style: str
    radius_m: float
    points_m: NDArray[np.float64]


@dataclass(frozen=True)
class Event:
    """Something that an element watched for and that happened inside a step.

    Attributes
    ----------
    time_s
        When, located to 1e-12 s.
    element
        The element that watched for it.
    what
        What happened.
    """

    time_s: float
    element: str
    what: str


REPEATING = frozenset({"goes slack", "comes taut", "touches", "leaves", "slides", "holds"})
"""Events of ropes and contacts that come again and again; all others say what began, ended or broke."""


PARTS = "parts"
"""The event of a rope at its breaking load; a warning of it begins so too."""


@dataclass(frozen=True)
class Warning:
    """What one should know of a run: a rod that stands for a rope pushes, a hull heels too far.

    Attributes
    ----------
    time_s
        When it was so, s.
    name
        A joint, a closed loop, a body, a force or a drive.
    text
        What was so.
    """

    time_s: float
    name: str
    text: str


@dataclass(frozen=True)
class Limit:
    """How a limit of the scenario held in the rows of a run.

    Attributes
    ----------
    name
        Its name in the scenario.
    column
        The column of the results.
    unit
        Unit of all numbers here.
    at_least, at_most
        The smallest and the largest value that are allowed; None where that side is free.
    held
        Whether it held; None where no row counted.
    worst, worst_time_s
        The value nearest to a bound, or farthest beyond one, and when that was, s.
    """

    name: str
    column: str
    unit: str
    at_least: float | None
    at_most: float | None
    held: bool | None
    worst: float | None
    worst_time_s: float | None


@dataclass(frozen=True)
class LeverMove:
    """An input that a hand set.

    Attributes
    ----------
    time_s
        The end of the last step before, s.
    input
        Its name.
    value
        In its unit.
    """

    time_s: float
    input: str
    value: float

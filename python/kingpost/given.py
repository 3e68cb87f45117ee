"""Checks of a caller's arguments: a `KingpostError` names a value of a wrong type."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from .errors import KingpostError, shortened

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


def number(field: str, value: Any) -> float:
    """A real number.

    Raises
    ------
    KingpostError
        If the value is None, text, complex or a list.

    >>> number("threads", np.int64(3))
    3.0
    >>> number("threads", "many")
    Traceback (most recent call last):
        ...
    kingpost.errors.KingpostError: threads: found 'many', allowed: a number
    """
    if isinstance(value, bool | np.bool_ | int | float | np.integer | np.floating):
        return float(value)
    raise KingpostError(f"{field}: found {shortened(repr(value))}, allowed: a number")


def not_negative(field: str, value: Any) -> float:
    """A finite number from 0 up.

    Raises
    ------
    KingpostError
        If the value is not a number, or is negative or infinite.

    >>> not_negative("speed_m_s", 0.5)
    0.5
    >>> not_negative("speed_m_s", -1)
    Traceback (most recent call last):
        ...
    kingpost.errors.KingpostError: speed_m_s: found -1.0, allowed: a number not less than 0
    """
    found = number(field, value)
    if not (np.isfinite(found) and found >= 0.0):
        raise KingpostError(f"{field}: found {found}, allowed: a number not less than 0")
    return found


def numbers(field: str, values: ArrayLike) -> NDArray[np.float64]:
    """Real numbers as a one-dimensional array for the engine.

    Raises
    ------
    KingpostError
        If one of them is None, text or complex.

    >>> numbers("q", [[0, 1], [2, 3]])
    array([0., 1., 2., 3.])
    >>> numbers("q", [1j])
    Traceback (most recent call last):
        ...
    kingpost.errors.KingpostError: q: found [1j], allowed: real numbers
    """
    try:
        given = np.asarray(values)
    except ValueError:
        given = np.asarray(None)
    if given.dtype.kind not in "fiub":
        raise KingpostError(f"{field}: found {shortened(repr(values))}, allowed: real numbers")
    return np.ascontiguousarray(given, dtype=np.float64).ravel()


def lists(field: str, values: Any) -> dict[str, list[Any]]:
    """Lists of values by name.

    Raises
    ------
    KingpostError
        If the argument is not a mapping, or a name has a single value instead of a list.

    >>> lists("parameters", {"crane_x_m": np.array([-10, 0])})
    {'crane_x_m': [-10, 0]}
    >>> lists("sweep", {"damping": 5})
    Traceback (most recent call last):
        ...
    kingpost.errors.KingpostError: sweep: found 5 for damping, allowed: a list of values
    """
    if not isinstance(values, Mapping):
        raise KingpostError(f"{field}: found {shortened(repr(values))}, allowed: lists of values by name")
    found = {str(name): np.asarray(given).tolist() for name, given in values.items()}
    for name, given in found.items():
        if not isinstance(given, list):
            raise KingpostError(
                f"{field}: found {shortened(repr(given))} for {name}, allowed: a list of values"
            )
    return found

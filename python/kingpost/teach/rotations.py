"""Rotations: skew matrices, and their exponential by the Cayley-Hamilton theorem."""

from __future__ import annotations

from math import factorial
from typing import TYPE_CHECKING

import numpy as np

from ..errors import KingpostError

if TYPE_CHECKING:
    import xarray
    from numpy.typing import ArrayLike, NDArray

SMALL_RAD = 1e-4
"""Angle below which sin(t)/t and (1 - cos t)/t^2 are computed by their series, exact to rounding, rad."""


def skew(vector: ArrayLike) -> NDArray[np.float64]:
    """Matrix of the cross product, S(a) b = a x b (paper eq. 8).

    >>> skew([1, 2, 3]) @ [4, 5, 6]
    array([-3.,  6., -3.])
    """
    x, y, z = vector_of_three(vector)
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def unskew(matrix: ArrayLike) -> NDArray[np.float64]:
    """The vector of a skew matrix (paper eq. 10); for any other matrix, the vector of its skew part.

    >>> unskew(skew([1, 2, 3]))
    array([1., 2., 3.])
    """
    m = np.asarray(matrix, dtype=np.float64)
    return 0.5 * np.array([m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]])


def rodrigues(rotation_vector: ArrayLike) -> NDArray[np.float64]:
    """exp(S(a)) by Rodrigues' formula, I + sin(t)/t S(a) + (1 - cos t)/t^2 S(a)^2 with t = |a| in rad.

    >>> np.round(rodrigues([0, 0, np.pi / 2]) @ [1, 0, 0], 15)
    array([0., 1., 0.])
    """
    a = vector_of_three(rotation_vector)
    t = float(np.linalg.norm(a))
    if t < SMALL_RAD:
        sine, versine = 1 - t * t / 6, 0.5 - t * t / 24
    else:
        sine, versine = np.sin(t) / t, 2 * (np.sin(t / 2) / t) ** 2
    return np.eye(3) + sine * skew(a) + versine * skew(a) @ skew(a)


def exponential_sums(axis: ArrayLike, angle_rad: float, terms: int = 20) -> xarray.Dataset:
    """Partial sums of exp(t S(e)) = I + t S(e) + t^2/2! S(e)^2 + ..., and their closed forms.

    The unit axis e gives S(e) the characteristic polynomial x^3 + x, and by the Cayley-Hamilton
    theorem S(e)^3 = -S(e). So every power is S(e) or S(e)^2 with a sign, and a partial sum is
    I + a S(e) + b S(e)^2, where a and b are partial sums of sin t and 1 - cos t.

    Parameters
    ----------
    axis
        Any nonzero vector; e is its direction.
    angle_rad
        t, rad.
    terms
        The highest power in the sum, 170 at most (larger factorials overflow).

    Returns
    -------
    xarray.Dataset
        By ``power``, from 0: ``partial_sum``, ``sine`` (a) and ``versine`` (b), ``error`` (largest
        entry of the difference from Rodrigues' formula), and ``bound``, t^(n+1)/(n+1)! e^t.

    >>> sums = exponential_sums([0, 0, 1], np.pi / 2)
    >>> bool(sums.error[-1] < 1e-15)
    True
    """
    import xarray

    e = vector_of_three(axis)
    if not np.linalg.norm(e) > 0:
        raise KingpostError("axis: found the zero vector, allowed: any other")
    if not 0 <= terms <= 170:
        raise KingpostError(f"terms: found {terms}, allowed: 0 to 170")
    s = skew(e / np.linalg.norm(e))
    powers = np.arange(terms + 1)
    weights = np.array([angle_rad**n / factorial(n) for n in range(terms + 1)])
    matrices = np.cumsum([w * np.linalg.matrix_power(s, n) for n, w in enumerate(weights)], axis=0)
    # S^(2k+1) = (-1)^k S and S^(2k+2) = (-1)^k S^2.
    signs = np.where((powers - 1) // 2 % 2 == 0, 1.0, -1.0)
    sine = np.cumsum(np.where(powers % 2 == 1, signs * weights, 0.0))
    versine = np.cumsum(np.where((powers % 2 == 0) & (powers > 0), signs * weights, 0.0))
    limit = rodrigues(angle_rad * e / np.linalg.norm(e))
    remainder = np.abs(weights * angle_rad) / (powers + 1) * np.exp(abs(angle_rad))
    return xarray.Dataset(
        {
            "partial_sum": (("power", "row", "column"), matrices, {"units": "1"}),
            "sine": ("power", sine, {"units": "1", "long_name": "partial sum of sin t"}),
            "versine": ("power", versine, {"units": "1", "long_name": "partial sum of 1 - cos t"}),
            "error": ("power", np.abs(matrices - limit).max(axis=(1, 2)), {"units": "1"}),
            "bound": ("power", remainder, {"units": "1"}),
        },
        {"power": powers, "row": list("xyz"), "column": list("xyz")},
        {"angle_rad": angle_rad},
    )


def vector_of_three(values: ArrayLike) -> NDArray[np.float64]:
    """Three finite numbers as an array."""
    vector = np.asarray(values, dtype=np.float64)
    if vector.shape != (3,) or not np.isfinite(vector).all():
        raise KingpostError(f"found {values!r}, allowed: three finite numbers")
    return vector

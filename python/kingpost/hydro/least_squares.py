"""Least squares under linear inequalities, by the non-negative least squares of scipy."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def least_distance(rows: Array, bounds: Array) -> Array | None:
    """The shortest x with rows x >= bounds; `None` if there is none.

    Least distance programming by non-negative least squares (C. L. Lawson and R. J. Hanson, "Solving Least
    Squares Problems", SIAM 1995, chapter 23, algorithm LDP, 23.27).

    >>> least_distance(np.array([[1.0, 1.0]]), np.array([2.0])).round(12).tolist()
    [1.0, 1.0]
    """
    from scipy.optimize import nnls

    if not len(rows) or (bounds <= 0.0).all():
        return np.zeros(rows.shape[1])
    scale = bounds.max()
    dual = np.vstack([rows.T, bounds[None, :] / scale])
    target = np.zeros(len(dual))
    target[-1] = 1.0
    residual = dual @ nnls(dual, target)[0] - target
    if np.linalg.norm(residual) < 1e-12:
        return None
    return -scale * residual[:-1] / residual[-1]

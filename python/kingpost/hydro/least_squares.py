"""Least squares under linear inequalities.

C. L. Lawson and R. J. Hanson, "Solving Least Squares Problems", SIAM 1995, chapter 23: non-negative least
squares (algorithm NNLS, 23.10) and, with it, least distance programming (algorithm LDP, 23.27).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def nonnegative(matrix: Array, right: Array) -> Array:
    """The x >= 0 that minimises |matrix x - right|.

    >>> nonnegative(np.eye(2), np.array([1.0, -1.0])).round(12).tolist()
    [1.0, 0.0]
    """
    n = matrix.shape[1]
    x, free = np.zeros(n), np.zeros(n, bool)
    # Nearly parallel columns cannot be distinguished better than this.
    square = matrix.T @ matrix + 1e-14 * np.eye(n) * (matrix**2).sum(axis=0).max(initial=0.0)
    projected = matrix.T @ right
    tolerance = 1e-13 * np.abs(matrix).sum(axis=0).max() * np.linalg.norm(right)
    for _ in range(10 * n):
        gradient = projected - square @ x
        if free.all() or gradient[~free].max() <= tolerance:
            break
        free[np.argmax(np.where(free, -np.inf, gradient))] = True
        while True:
            trial = np.zeros(n)
            trial[free] = np.linalg.solve(square[np.ix_(free, free)], projected[free])
            if trial[free].min(initial=0.0) >= 0.0 and (trial[free] > 0.0).all():
                break
            blocking = free & (trial <= 0.0)
            step = np.min(x[blocking] / (x[blocking] - trial[blocking] + 1e-300))
            x = x + step * (trial - x)
            free &= x > 1e-15 * np.abs(x).max(initial=0.0)
            x[~free] = 0.0
            if not free.any():
                break
        x = trial if free.any() else np.zeros(n)
    return x


def least_distance(rows: Array, bounds: Array) -> Array | None:
    """The shortest x with rows x >= bounds; `None` if there is none.

    >>> least_distance(np.array([[1.0, 1.0]]), np.array([2.0])).round(12).tolist()
    [1.0, 1.0]
    """
    if not len(rows) or (bounds <= 0.0).all():
        return np.zeros(rows.shape[1])
    scale = bounds.max()
    dual = np.vstack([rows.T, bounds[None, :] / scale])
    target = np.zeros(len(dual))
    target[-1] = 1.0
    residual = dual @ nonnegative(dual, target) - target
    if np.linalg.norm(residual) < 1e-12:
        return None
    return -scale * residual[:-1] / residual[-1]

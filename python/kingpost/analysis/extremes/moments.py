"""First and second L-moments: of all values, and with values or groups left out."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray


def l_moments(x: NDArray[np.float64]) -> NDArray[np.float64]:
    """The mean, and half the mean of |x_i - x_j| over all pairs, along the last axis.

    Hosking, *J. R. Stat. Soc. B* 52, 1990, p. 113.

    >>> l_moments(np.array([1.0, 2.0, 4.0])).tolist()
    [2.3333333333333335, 1.0]
    """
    weights = 2 * np.arange(x.shape[-1]) / (x.shape[-1] - 1) - 1
    return np.stack([x.mean(-1), (weights * np.sort(x, axis=-1)).mean(-1)], axis=-1)


def without_each(x: NDArray[np.float64]) -> NDArray[np.float64]:
    """Both moments with one value along the last axis left out, in rising order of that value.

    >>> np.allclose(without_each(np.array([1.0, 2.0, 4.0]))[0], l_moments(np.array([2.0, 4.0])))
    True
    """
    x = np.sort(x, axis=-1)
    n = x.shape[-1]
    rank = np.arange(n)
    above = np.cumsum(x[..., ::-1], axis=-1)[..., ::-1] - x
    first = (x.sum(-1, keepdims=True) - x) / (n - 1)
    ranked = (rank * x).sum(-1, keepdims=True) - rank * x - above
    return np.stack([first, 2 * ranked / ((n - 1) * (n - 2)) - first], axis=-1)


def without_groups(x: NDArray[np.float64], group: NDArray[np.int64], groups: int) -> NDArray[np.float64]:
    """Number of values and both moments: of all values, then with each group left out.

    >>> found = without_groups(np.array([1.0, 2.0, 4.0]), np.array([0, 1, 1]), 2)
    >>> found[1].tolist()
    [2.0, 3.0, 1.0]
    """
    order = np.argsort(x, kind="stable")
    x, group = x[order], group[order]
    kept = np.vstack([np.ones(len(x), bool), group != np.arange(groups)[:, None]])
    count = kept.sum(1)
    ranked = ((np.cumsum(kept, axis=1) - 1) * kept) @ x
    with np.errstate(invalid="ignore", divide="ignore"):
        first = (kept @ x) / count
        second = 2 * ranked / (count * (count - 1)) - first
    return np.stack([count, first, second], axis=-1)


def jackknife(without: NDArray[np.float64]) -> NDArray[np.float64]:
    """Jackknife variance of an estimate, from the estimates with one of g parts left out, along the first
    axis.

    (g - 1) / g times the sum of the squared deviations (Miller, *Biometrika* 61, 1974, p. 1). For vectors,
    their covariance.

    >>> float(jackknife(np.array([1.0, 2.0, 3.0])))
    1.3333333333333333
    """
    parts = len(without)
    off = without - without.mean(axis=0)
    square = np.einsum("i...,i...->...", off, off) if off.ndim == 1 else np.einsum("ia,ib->ab", off, off)
    return (parts - 1) / parts * square

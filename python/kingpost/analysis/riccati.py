"""Matrices of linear-quadratic control: weights, sampling, Riccati's equation, the closed loop."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import KingpostError

Matrix = NDArray[np.float64]

SMALLEST_SHARE = 1e-10
"""Singular values below this share of the largest count as zero."""
NO_REST = (
    "Q: found weights without a regulator that comes to rest ({}), allowed: a weight on each motion that "
    "does not decay by itself"
)


def places(what: str, wanted: list[str], existing: list[str]) -> list[int]:
    """Indices of names; an error lists those that exist."""
    if not wanted:
        raise KingpostError(f"{what}: found none, allowed: {', '.join(existing) or 'none exist'}")
    for k, name in enumerate(wanted):
        if name not in existing:
            raise KingpostError(f"{what}: found {name!r}, allowed: {', '.join(existing) or 'none exist'}")
        if name in wanted[:k]:
            raise KingpostError(f"{what}: found {name!r} a second time, allowed: each name once")
    return [existing.index(name) for name in wanted]


def weights_of(
    what: str, given: Mapping[str, float] | ArrayLike, names: list[str], positive: bool = False
) -> Matrix:
    """A symmetric matrix of weights, semidefinite or definite."""
    n = len(names)
    if isinstance(given, Mapping):
        places(what, list(given), names)
        given = [given.get(name, 0.0) for name in names]
    try:
        weights = np.asarray(given, float)
    except (TypeError, ValueError):
        raise KingpostError(f"{what}: found {given!r}, allowed: numbers") from None
    if weights.ndim == 1:
        weights = np.diag(weights)
    if weights.shape != (n, n):
        raise KingpostError(f"{what}: found a shape of {weights.shape}, allowed: {n} or {n} x {n} numbers")
    if not np.isfinite(weights).all():
        raise KingpostError(f"{what}: found NaN or infinity, allowed: finite numbers")
    if np.abs(weights - weights.T).max() > SMALLEST_SHARE * np.abs(weights).max():
        raise KingpostError(f"{what}: found a matrix that is not symmetric, allowed: a symmetric one")
    values = np.linalg.eigvalsh(weights)
    least = float(values.min())
    if positive and least <= 0:
        raise KingpostError(f"{what}: found an eigenvalue of {least:g}, allowed: greater than 0")
    if least < -SMALLEST_SHARE * max(1.0, float(values.max())):
        raise KingpostError(f"{what}: found an eigenvalue of {least:g}, allowed: 0 or greater")
    return weights


def check_reach(a: Matrix, b: Matrix, names: list[str]) -> None:
    """Refuse inputs that do not move every mode that does not decay."""
    scale = max(float(np.abs(a).max()), 1.0)
    for value, about in unreached(a, b, names):
        if value.real >= -1e-9 * scale:
            period = f" of period {2 * math.pi / value.imag:.4g} s" if value.imag > 1e-6 * scale else ""
            raise KingpostError(
                f"inputs: found no effect on the mode{period} in which {about} takes part, allowed: inputs "
                "that damp every mode that does not decay; or leave its states out of states"
            )


def unreached(a: Matrix, b: Matrix, names: list[str]) -> list[tuple[complex, str]]:
    """Eigenvalues of the modes that no input moves, each with a state that takes part.

    Popov, Belevitch and Hautus: the inputs move the mode of s where [A - s I, B] has full rank.
    """
    found: list[tuple[complex, str]] = []
    for value in np.linalg.eigvals(a):
        if value.imag < 0:
            continue
        test = np.hstack([a - value * np.eye(len(a)), b / max(float(np.abs(b).max()), 1e-300)])
        left, singular, _ = np.linalg.svd(test)
        if singular[-1] < SMALLEST_SHARE * singular[0] or singular[-1] < 1e-8:
            found.append((complex(value), names[int(np.abs(left[:, -1]).argmax())]))
    return found


def solve(a: Matrix, b: Matrix, q: Matrix, r: Matrix, period_s: float | None) -> tuple[Matrix, Matrix]:
    """K and P."""
    from scipy.linalg import solve_continuous_are, solve_discrete_are

    try:
        if period_s is None:
            p = solve_continuous_are(a, b, q, r)
            return np.linalg.solve(r, b.T @ p), p
        held, moved, weight, cross, of_input = sampled(a, b, q, r, period_s)
        p = solve_discrete_are(held, moved, weight, of_input, s=cross)
        return np.linalg.solve(of_input + moved.T @ p @ moved, moved.T @ p @ held + cross.T), p
    except (np.linalg.LinAlgError, ValueError) as error:
        raise KingpostError(NO_REST.format(error)) from None


def sampled(a: Matrix, b: Matrix, q: Matrix, r: Matrix, period_s: float) -> tuple[Matrix, ...]:
    """A and B between samples, and the weights of x, of x with u, and of u over a sampling period."""
    from scipy.linalg import expm

    n, m = b.shape
    whole = np.zeros((n + m, n + m))
    whole[:n, :n], whole[:n, n:] = a, b
    weight = np.block([[q, np.zeros((n, m))], [np.zeros((m, n)), r]])
    both = np.block([[-whole.T, weight], [np.zeros_like(whole), whole]])
    step = expm(both * period_s)
    move = step[n + m :, n + m :]
    cost = move.T @ step[: n + m, n + m :]
    cost = (cost + cost.T) / 2
    return move[:n, :n], move[:n, n:], cost[:n, :n], cost[:n, n:], cost[n:, n:]


def closed_loop(a: Matrix, b: Matrix, gains: Matrix, period_s: float | None) -> NDArray[np.complex128]:
    """Eigenvalues of the closed loop, 1/s, the slowest decay first."""
    if period_s is None:
        values = np.linalg.eigvals(a - b @ gains).astype(complex)
    else:
        none = np.zeros_like(a)
        held, moved = sampled(a, b, none, np.zeros((b.shape[1],) * 2), period_s)[:2]
        with np.errstate(divide="ignore"):
            values = np.log(np.linalg.eigvals(held - moved @ gains).astype(complex)) / period_s
    return values[np.lexsort((values.imag, -values.real))]

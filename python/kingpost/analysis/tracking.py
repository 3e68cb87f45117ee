"""Tracking of modes from system to system along a sweep."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from .eigenmodes import Mode

SMALLEST_CORRELATION = 1e-3
"""Modes with a smaller correlation are not paired."""
SLOWEST_SHARE = 1e-3
"""Frequency assigned to a zero mode, as a share of the highest one: so it can be paired with a slow mode."""


def tracks(
    points: Sequence[Sequence[Mode]], masses: Sequence[NDArray[np.float64]]
) -> list[list[Mode | None]]:
    """Order the modes of each point so that a mode has the same index at all points.

    Modes are paired by correlation, the best pair first. A mode without a partner ends its track or begins a
    new one. Tracks are in the order of the first point; later tracks follow.
    """
    last = list(points[0]) if points else []
    order: list[list[Mode | None]] = [list(last)] if points else []
    for k in range(1, len(points)):
        here: list[Mode | None] = [None] * len(last)
        matches, alone = pairs(last, points[k], masses[k])
        for track, index in matches:
            here[track] = points[k][index]
        here += [points[k][index] for index in alone]
        order = [[*row, *[None] * len(alone)] for row in order] + [here]
        # A track that ended may continue if its mode comes back.
        last = [
            mode or before for mode, before in zip(here, last + [points[k][i] for i in alone], strict=True)
        ]
    return order


def pairs(
    before: Sequence[Mode], after: Sequence[Mode], mass: NDArray[np.float64]
) -> tuple[list[tuple[int, int]], list[int]]:
    """Indices of the paired modes, and of the unpaired modes of `after`."""
    fastest = max((abs(mode.eigenvalue) for mode in [*before, *after]), default=0.0)
    slowest = SLOWEST_SHARE * fastest or 1.0
    table = np.array([[correlation(a, b, mass, slowest) for b in after] for a in before])
    found = []
    while table.size and table.max() > SMALLEST_CORRELATION:
        one, other = np.unravel_index(np.argmax(table), table.shape)
        found.append((int(one), int(other)))
        table[one, :], table[:, other] = 0.0, 0.0
    taken = {other for _, other in found}
    return found, [index for index in range(len(after)) if index not in taken]


def correlation(one: Mode, other: Mode, mass: NDArray[np.float64], slowest: float) -> float:
    """Correlation of two modes, from 0 to 1.

    The modal assurance criterion of the states (shape, rate of the shape), in the metric of the
    mass matrix and with the rates scaled by the mean of both eigenvalues (Allemang, The Modal
    Assurance Criterion, Sound and Vibration, 2003, p. 14). So two modes of the same shape, such as those of a
    heavily damped coordinate, are distinguished by their eigenvalues.
    """
    # A state without mass, such as that of a drive, has the weight 1.
    metric = np.eye(len(one.shape))
    metric[: len(mass), : len(mass)] = mass

    def product(a: NDArray, b: NDArray) -> complex:
        return a.conj() @ metric @ b

    shapes = abs(product(one.shape, other.shape)) ** 2
    shapes /= product(one.shape, one.shape).real * product(other.shape, other.shape).real
    a, b = (mode.eigenvalue if abs(mode.eigenvalue) > slowest else slowest for mode in (one, other))
    square = abs(a) * abs(b)
    rates = abs(1 + a.conjugate() * b / square) ** 2
    rates /= (1 + abs(a) ** 2 / square) * (1 + abs(b) ** 2 / square)
    return float(shapes * rates)

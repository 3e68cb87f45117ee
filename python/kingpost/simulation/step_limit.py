"""Longest step at which an explicit scheme is stable, by eigenvalues."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

GROWTH: dict[str, Callable[[NDArray[np.complex128]], NDArray[np.complex128]]] = {
    "forward_euler": lambda z: 1 + z,
    "midpoint_euler": lambda z: 1 + z,
    "rk4": lambda z: 1 + z * (1 + z / 2 * (1 + z / 3 * (1 + z / 4))),
}
"""Amplification factor of a motion exp(lambda t) in one step h, with z = h lambda (Hairer & Wanner, *Solving
Ordinary Differential Equations II*, 1996, sec. IV.2)."""
ADVANCING = ("forward_euler", "rk4")
"""Schemes that leave the nodes of lines to an implicit rule, whose own motions set no limit."""
DAMPED = 0.02
"""Smallest damping ratio of the judged motions: with less damping, Euler's method is unstable at any step."""
ROUNDING = 1e-12
"""Growth in one step, and share of a rate, that are taken as rounding of a motion without damping."""
LONGEST_S, HALVINGS = 1e3, 60
MOST_LIMITS, SAME_LIMIT = 30, 0.98
"""Number of limits for lines, each with the step of the last, and the share of it that ends the search."""
MOST_STATES = 1000
"""Largest number of states for which eigenvalues are computed before each run, which takes a second or
two."""


def longest_step_s(
    integrator: str,
    matrix: NDArray[np.float64],
    advanced: NDArray[np.bool_] | None = None,
    step_s: float = LONGEST_S,
) -> float | None:
    """The longest stable step, s, of a scheme on x' = A x; None if there is no such limit.

    The states of lines are marked as `advanced`: they follow their ends by the implicit midpoint rule over a
    step `step_s`.

    >>> print(f"{longest_step_s('rk4', np.diag([-1.0])):.5f}")
    2.78529
    """
    growth = GROWTH.get(integrator)
    # If the rates overflow, the run itself reports it.
    if growth is None or not np.isfinite(matrix).all():
        return None
    if advanced is None or not advanced.any() or integrator not in ADVANCING:
        values = np.linalg.eigvals(matrix).astype(complex)
        return _longest_s(growth, values[-values.real > DAMPED * np.abs(values)])
    # Lines are stiffer over a shorter step: that of a limit has a lower limit.
    for _ in range(MOST_LIMITS):
        values = np.linalg.eigvals(_with_lines_at_ends(matrix, advanced, 2 / step_s)).astype(complex)
        # A light body on a line is damped by its waves, which the matrix does not show. What grows by itself
        # grows at any step.
        least = -ROUNDING if integrator == "rk4" else DAMPED
        judged = values[-values.real >= least * np.abs(values)]
        limit_s = _longest_s(growth, judged)
        if limit_s is None or limit_s >= SAME_LIMIT * step_s:
            break
        step_s = limit_s
    return limit_s


def _longest_s(
    growth: Callable[[NDArray[np.complex128]], NDArray[np.complex128]], values: NDArray[np.complex128]
) -> float | None:
    """The longest step, s, at which none of these motions grows; None if there is no limit."""
    # Leave out motions slower than an hour: they set no limit, and zero eigenvalues are rounded to such
    # values.
    values = values[np.abs(values) > 1 / LONGEST_S]
    # Keep one eigenvalue of each conjugate pair.
    values = values[values.imag >= 0]
    return float(_limits(growth, values).min()) if values.size else None


def left_out(states: int) -> str:
    """Warning for a model whose longest stable step is not estimated.

    >>> left_out(7200)
    'the longest stable step is not estimated: 7200 states, more than 1000; compare with half the step'
    """
    return (
        f"the longest stable step is not estimated: {states} states, more than {MOST_STATES}; compare with "
        "half the step"
    )


NOT_FINITE = (
    "the longest stable step is not estimated: at the start the derivatives of the rates are not finite; "
    "compare with half the step"
)
"""Warning for a model whose matrix has entries that are not finite."""


def warning(
    settings: dict[str, Any], linear: Callable[[], tuple[NDArray[np.float64], NDArray[np.bool_]]]
) -> str | None:
    """A warning if the step in the settings of a simulation is too long, otherwise None.

    `linear` computes A and the marks of advanced states; it is called only for schemes with a limit.
    """
    if settings["integrator"] not in GROWTH:
        return None
    matrix, advanced = linear()
    if not np.isfinite(matrix).all():
        return NOT_FINITE
    limit = longest_step_s(settings["integrator"], matrix, advanced, settings["step_s"])
    if limit is None or settings["step_s"] <= limit:
        return None
    return (
        f"the step of {settings['step_s']:g} s is too long for {settings['integrator']}: at the start its "
        f"fastest motion grows with steps longer than {limit:.2g} s; take shorter steps, dormand_prince, "
        "which chooses its own steps, or an implicit scheme (docs/schemes.md)"
    )


def _with_lines_at_ends(
    matrix: NDArray[np.float64], advanced: NDArray[np.bool_], sigma: float
) -> NDArray[np.float64]:
    """A of the other states: the advanced ones follow them as they do on average over a step h, with sigma =
    2 / h, A + A_oa (sigma - A_aa)^-1 A_ao."""
    own, others = np.flatnonzero(advanced), np.flatnonzero(~advanced)
    alone = sigma * np.eye(own.size) - matrix[np.ix_(own, own)]
    followed = np.linalg.solve(alone, matrix[np.ix_(own, others)])
    return matrix[np.ix_(others, others)] + matrix[np.ix_(others, own)] @ followed


def _limits(
    growth: Callable[[NDArray[np.complex128]], NDArray[np.complex128]], values: NDArray[np.complex128]
) -> NDArray[np.float64]:
    """Step from which on each damped motion grows, found by a scan and then by bisection."""
    steps = np.geomspace(1e-3, 1e2, 2000) / np.abs(values)[:, None]
    grows = np.abs(growth(steps * values[:, None])) > 1 + ROUNDING
    first = np.where(grows.any(axis=1), grows.argmax(axis=1), steps.shape[1] - 1)
    each = np.arange(len(values))
    low, high = steps[each, np.maximum(first - 1, 0)], steps[each, first]
    # For a motion that does not grow at any step of the scan, the result is the end of the scan.
    bounded = grows.any(axis=1) & (first > 0)
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        beyond = np.abs(growth(middle * values)) > 1 + ROUNDING
        low, high = np.where(beyond, low, middle), np.where(beyond, middle, high)
    return np.where(bounded, low, steps[each, first])

"""The quadratic programs of predictive control, solved by Clarabel."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..errors import KingpostError
from .riccati import Matrix

Rows = tuple[Matrix, Matrix, Matrix]
"""G, lower and upper of ``lower <= G u <= upper``."""
PENALTY = 1e6
"""Penalty on the excess of a soft limit, over the largest weight: so the excess is the smallest possible
one."""
TOLERANCE = 1e-9
"""Gap and residuals at which the solver stops."""


@dataclass(frozen=True)
class Bounds:
    """Limits of the variables: `hard` ones always hold, `soft` ones as far as the hard ones permit."""

    hard: list[Rows]
    soft: list[Rows]


def minimum(weight: Matrix, slope: Matrix, bounds: Bounds) -> tuple[Matrix, float]:
    """The u with the least ``u' weight u / 2 + slope' u`` within bounds, and how far soft ones are exceeded.

    If the minimum without bounds is within them, it is the answer, exact to rounding.

    >>> bounds = Bounds([(np.eye(2), np.array([-1.0, -1]), np.array([1.0, 1]))], [])
    >>> minimum(np.eye(2), np.array([-0.5, -3.0]), bounds)[0].round(6).tolist()
    [0.5, 1.0]
    """
    free = np.asarray(-np.linalg.solve(weight, slope), np.float64)
    every = [*bounds.hard, *bounds.soft]
    if all(((g @ free >= lower) & (g @ free <= upper)).all() for g, lower, upper in every):
        return free, 0.0
    found = _solved(weight, slope, every)
    if found is not None:
        return found, 0.0
    # Not all limits can hold: add a common excess of the soft limits as a variable.
    size = len(slope)
    scale = PENALTY * float(np.abs(weight).max())
    wider = np.zeros((size + 1, size + 1))
    wider[:size, :size], wider[size, size] = weight, scale
    hard = [(np.hstack([g, np.zeros((len(g), 1))]), lower, upper) for g, lower, upper in bounds.hard]
    ones = [(g, np.ones((len(g), 1)), lower, upper) for g, lower, upper in bounds.soft]
    soft = [(np.hstack([g, one]), lower, np.full_like(upper, np.inf)) for g, one, lower, upper in ones]
    soft += [(np.hstack([g, -one]), np.full_like(lower, -np.inf), upper) for g, one, lower, upper in ones]
    found = _solved(wider, np.append(slope, scale), [*hard, *soft])
    if found is None:
        raise KingpostError(
            "limits: found limits of inputs and of their rates that no inputs hold, "
            "allowed: the last inputs within the limits"
        )
    return found[:size], max(0.0, float(found[size]))


def _solved(weight: Matrix, slope: Matrix, every: list[Rows]) -> Matrix | None:
    """Solution by Clarabel; None if no u satisfies the limits."""
    clarabel = _clarabel()
    from scipy.sparse import csc_matrix, triu

    rows = np.vstack([g for g, _, _ in every])
    lower = np.concatenate([low for _, low, _ in every])
    upper = np.concatenate([high for _, _, high in every])
    below, above = np.isfinite(lower), np.isfinite(upper)
    g = np.vstack([rows[above], -rows[below]])
    h = np.concatenate([upper[above], -lower[below]])
    # One scale for all entries: the solver also has absolute tolerances.
    size = float(np.abs(weight).max())
    settings = clarabel.DefaultSettings()
    settings.verbose = False
    settings.tol_gap_abs = settings.tol_gap_rel = settings.tol_feas = TOLERANCE
    problem = csc_matrix(triu(weight / size)), slope / size, csc_matrix(g), h
    solver = clarabel.DefaultSolver(*problem, [clarabel.NonnegativeConeT(len(h))], settings)
    solution = solver.solve()
    if solution.status in (clarabel.SolverStatus.Solved, clarabel.SolverStatus.AlmostSolved):
        return np.array(solution.x)
    return None


def _clarabel() -> Any:
    try:
        import clarabel
    except ImportError:
        raise KingpostError(
            'mpc: found no solver of quadratic programs, allowed: with pip install "kingpost[control]"'
        ) from None
    return clarabel

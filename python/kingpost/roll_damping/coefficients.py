"""Linear, quadratic and cubic damping, their equivalent linear damping, and the forces of a scenario."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..errors import RollDampingError

if TYPE_CHECKING:
    from .sections import Array

LEAST_IN_FULL, MOST_IN_FULL = 1e-9, 1e21
QUADRATIC, CUBIC = 8 / (3 * math.pi), 3 / 4
"""Equivalent linear factors of b2 |v| v and b3 v^3 in a harmonic motion of speed amplitude v."""


@dataclass(frozen=True)
class Coefficients:
    """The moment -(B1 v + B2 |v| v + B3 v^3) against a roll rate v.

    Attributes
    ----------
    linear, quadratic, cubic
        B1, N m s; B2, N m s^2; B3, N m s^3.

    >>> found = Coefficients(2e6, 3e7)
    >>> round(found.equivalent(frequency_rad_s=0.5, amplitude_rad=0.2) / 1e6, 3)
    4.546
    """

    linear: float
    quadratic: float = 0.0
    cubic: float = 0.0

    def equivalent(self, frequency_rad_s: float, amplitude_rad: Array | float) -> Array | float:
        """The linear damping, N m s, that dissipates the same energy in a period:
        B1 + 8 / (3 pi) omega phi B2 + 3/4 omega^2 phi^2 B3 (ITTC 7.5-02-07-04.5, 2021, eq. 15)."""
        speed = frequency_rad_s * amplitude_rad
        return self.linear + QUADRATIC * speed * self.quadratic + CUBIC * speed**2 * self.cubic


def fitted(amplitudes_rad: Array, damping: Array, frequency_rad_s: float) -> Coefficients:
    """The best linear and quadratic coefficients, neither negative, for a damping over the amplitude.

    Least squares of the relative error. A scenario has no cubic damping, and its forces only dissipate
    energy.

    >>> amplitudes = np.radians([2.0, 5.0, 10.0])
    >>> again = fitted(amplitudes, Coefficients(2e6, 3e7).equivalent(0.5, amplitudes), 0.5)
    >>> round(again.linear), round(again.quadratic)
    (2000000, 30000000)
    """
    from scipy.optimize import nnls

    columns = np.stack([np.ones_like(amplitudes_rad), QUADRATIC * frequency_rad_s * amplitudes_rad], axis=1)
    size = np.abs(columns / damping[:, None]).max(axis=0)
    found = nnls(columns / damping[:, None] / size, np.ones_like(damping))[0] / size
    return Coefficients(float(found[0]), float(found[1]))


def fragment(found: Coefficients, body: str, title: str) -> str:
    """The forces of a scenario with this damping, as YAML.

    Parameters
    ----------
    found
        Coefficients without a cubic part.
    body
        Name of the hull in the scenario.
    title
        A comment for the first line: the ship or the test.

    Raises
    ------
    RollDampingError
        If there is a cubic or a negative part, which no force of a scenario has: `fitted` gives suitable
        coefficients.

    Examples
    --------
    >>> print(fragment(Coefficients(2e6, 3.45e7), "ship", "a ship"))
    # a ship
    forces:
      roll_damping: {viscous_damping: {body: ship, angular_N_m_s: [2000000, 0, 0]}}
      roll_drag: {quadratic_damping: {body: ship, angular_N_m_s2: [34500000, 0, 0]}}
    <BLANKLINE>
    """
    if found.cubic:
        allowed = "0: a scenario has linear and quadratic damping"
        raise RollDampingError("cubic", f"{found.cubic:g}", allowed)
    for name in ("linear", "quadratic"):
        if not getattr(found, name) >= 0:
            raise RollDampingError(name, f"{getattr(found, name):g}", "0 or more")
    linear, quadratic = _plain(found.linear), _plain(found.quadratic)
    return (
        f"# {' '.join(title.split())}\n"
        "forces:\n"
        f"  roll_damping: {{viscous_damping: {{body: {body}, angular_N_m_s: [{linear}, 0, 0]}}}}\n"
        f"  roll_drag: {{quadratic_damping: {{body: {body}, angular_N_m_s2: [{quadratic}, 0, 0]}}}}\n"
    )


def _plain(value: float) -> str:
    """Format six significant digits, without an exponent unless the number is very small or large.

    >>> _plain(3.45e7), _plain(1e-61)
    ('34500000', '1e-61')
    """
    if not LEAST_IN_FULL <= abs(value) < MOST_IN_FULL:
        return f"{value:.6g}"
    return np.format_float_positional(float(f"{value:.6g}"), trim="-")

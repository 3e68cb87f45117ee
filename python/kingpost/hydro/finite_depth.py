"""Green's function for finite water depth, as accurate as that for deep water.

Capytaine splits it into four deep-water functions and a smooth remainder (G. Delhommeau, "Les problemes de
diffraction-radiation et de resistance des vagues", thesis, ENSM Nantes 1987). The integral of the remainder
has a closed form if it is a sum of exponentials: with x = k' h, the wave's k h, and K = k h tanh k h,

    f(x) = (x + K) exp(x) / (x sinh x - K cosh x) - c / (x - k h) - 2 = sum of a_n exp(lambda_n x),
    c = (1 + tanh k h)^2 / (1 - tanh^2 k h + tanh k h / k h).

Version 3.0 of Capytaine looks for the fewest exponentials by Prony's method, on points drawn at random,
until their mean square error is below 1e-4: f, of order 1, is then wrong by up to 0.2, differently in
each run, and below k h = 0.1 no sum is found. For a prism of 8 x 0.4 x 0.2 m in 1 m of water the heave
damping at k h = 6.5 becomes 45 % too small. Here the rates lambda_n are a geometric series, and the
amplitudes follow by linear least squares.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import HydrodynamicsError

if TYPE_CHECKING:
    from numpy.typing import NDArray

SLOWEST, FASTEST = 0.1, 20.0
"""Rates of decay of the exponentials in water that is not shallow. f is fitted up to x = 20."""
POLE = 8.0
"""The fastest rate times k h of shallow water, where f has a pole at x = -k h."""
DENSITY = 3
"""Number of exponentials per factor e of their rates: the error of f is at most 1e-5 for all k h."""
SHALLOWEST = 0.005
"""The smallest tested k h."""
INFINITE = 1e5
"""From this k h on f has its form at infinite frequency, 2 - 2 / (1 + exp(-2 x))."""


def rest(kh: float, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """f(x) for a wave with this k h, away from x = k h.

    >>> rest(np.inf, np.array([0.0])), rest(30.0, np.array([0.0])).round(12)
    (array([1.]), array([1.]))
    """
    if kh > INFINITE:
        return 2 - 2 / (1 + np.exp(-2 * x))
    tanh = np.tanh(kh)
    c = (1 + tanh) ** 2 / (1 - tanh**2 + tanh / kh)
    # exp(x) / cosh(x), without overflow.
    ratio = 2 / (1 + np.exp(-2 * x))
    return (x + kh * tanh) * ratio / (x * np.tanh(x) - kh * tanh) - c / (x - kh) - 2


def decomposition(kh: float) -> NDArray[np.float64]:
    """Rates and amplitudes of the exponentials, shape (2, terms).

    >>> x = np.linspace(0.0, 10.0, 101)
    >>> rates, amplitudes = decomposition(0.77)
    >>> float(np.abs(np.exp(np.outer(x, rates)) @ amplitudes - rest(0.77, x)).max()) < 1e-5
    True

    Raises
    ------
    HydrodynamicsError
        When k h is less than `SHALLOWEST`.
    """
    if not kh >= SHALLOWEST:
        allowed = (
            f"{SHALLOWEST:g} or more: leave out lower frequencies, or shorten their waves in deeper water"
        )
        raise HydrodynamicsError("frequencies", f"a wave number times depth of {kh:.3g}", allowed)
    fastest = max(FASTEST, POLE / kh)
    rates = -np.geomspace(SLOWEST, fastest, int(np.ceil(DENSITY * np.log(fastest / SLOWEST))) + 1)
    x = np.append(0.0, np.geomspace(0.01 / fastest, FASTEST, 700))
    # Both terms of f have a pole at k h; the poles cancel, which loses digits near k h.
    x = x[np.abs(x - kh) > 1e-4 * min(1.0, kh)]
    amplitudes = np.linalg.lstsq(np.exp(np.outer(x, rates)), rest(kh, x), rcond=1e-12)[0]
    return np.stack([rates, amplitudes])


def green_function(module: Any) -> Any:
    """Capytaine's Green function with the exponentials of `decomposition`."""

    class FiniteDepth(module.Delhommeau):
        def find_best_exponential_decomposition(self, kh: float, *, method: str | None = None) -> Any:
            return decomposition(kh)

    found = FiniteDepth()
    found.exportable_settings["finite_depth_exponentials"] = (
        f"{DENSITY} from {SLOWEST} to {FASTEST} or {POLE} / k h"
    )
    return found

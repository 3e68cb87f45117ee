"""Linear waves: dispersion, group velocity and the profile of the pressure under them."""

from __future__ import annotations

import numpy as np

from .database import Water


def wave_number(frequency: float, water: Water) -> float:
    """Root k of w^2 = g k tanh(k h), by Newton's method; 1/m.

    >>> round(wave_number(1.0, Water(gravity_m_s2=9.81)), 6)
    0.101937
    >>> k = wave_number(0.5, Water(gravity_m_s2=9.81, depth_m=10.0))
    >>> round(9.81 * k * float(np.tanh(10 * k)), 12)
    0.25
    """
    deep = frequency**2 / water.gravity_m_s2
    if water.depth_m is None or deep * water.depth_m > 30:
        return deep
    wanted = deep * water.depth_m
    kh = max(wanted, wanted**0.5)
    for _ in range(50):
        tanh = np.tanh(kh)
        kh -= (kh * tanh - wanted) / (tanh + kh * (1 - tanh**2))
    return float(kh / water.depth_m)


def group_ratio(frequency: float, water: Water) -> float:
    """Group velocity over phase velocity, (1 + 2kh / sinh 2kh) / 2.

    >>> group_ratio(1.0, Water())
    0.5
    """
    if water.depth_m is None:
        return 0.5
    kh = wave_number(frequency, water) * water.depth_m
    return 0.5 if kh > 100 else float(0.5 + kh / np.sinh(2 * kh))


def decay(k: float, z: np.ndarray, water: Water) -> tuple[np.ndarray, np.ndarray]:
    """cosh k(z + h) / cosh kh and its derivative along z, without overflow."""
    if water.depth_m is None:
        return np.exp(k * z), k * np.exp(k * z)
    below, bed = np.exp(-2 * k * (z + water.depth_m)), np.exp(-2 * k * water.depth_m)
    return np.exp(k * z) * (1 + below) / (1 + bed), k * np.exp(k * z) * (1 - below) / (1 + bed)

"""Colours of pictures: those of the app's light theme (`web/src/styles/theme.css`)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

HEX = {
    "hull": "#2f5c86",
    "bottom": "#9c4a3c",
    "stripe": "#f4f1ea",
    "deck": "#cfc4ab",
    "load": "#efa12d",
    "plain": "#9fb0bf",
    "barrel": "#3c4650",
    "rod": "#d9e0e5",
    "line": "#3b4753",
    "pin": "#23292f",
    "grid": "#6d8496",
    "haze": "#c3d6e4",
    "deep": "#0a3d63",
    "shallow": "#1f7f9e",
    "house": "#eceae3",
    "window": "#1d2a36",
    "sky-high": "#dbe7f0",
    "sky-low": "#f7fafc",
}
"""Colours by their names in the theme, without ``--scene-``."""


def colour(name: str) -> NDArray[np.float64]:
    """Red, green and blue of a named colour, 0 to 1.

    >>> colour("load").round(2)
    array([0.94, 0.63, 0.18])
    """
    return parsed(HEX[name])


def parsed(text: str) -> NDArray[np.float64]:
    """Red, green and blue of a colour as a scenario writes it.

    >>> parsed("#ff0000")
    array([1., 0., 0.])
    """
    from matplotlib.colors import to_rgb

    return np.array(to_rgb(text))

"""A deckhouse with a wheelhouse and a mast on the deck of a ship, where the crane and its load leave room."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from .faces import Faces, cuboid, joined
from .palette import colour

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Box = tuple[NDArray[np.float64], NDArray[np.float64]]

SITES = ((0.6, 0.82), (0.05, 0.25))
"""Ends of a deckhouse, as shares of the length from the stern: forward if there is room, otherwise aft."""
STOREY_SHARE, STOREY_MOST_M = 1 / 30, 2.8
"""Height of a storey, as a share of the hull's length, and its upper bound."""
STOREYS = 3
ROOM = 8
"""Height above the deck that a deckhouse needs, storeys."""
POINTED_AT, POINTED_BELOW = 0.97, 0.55
"""A hull is a ship's if its beam at this share of its length from the stern is less than this share of the
full beam."""


def deckhouse(hull: Faces, obstacles: Sequence[Box]) -> Faces:
    """Faces of a deckhouse, hull axes; none for a barge or without room.

    Parameters
    ----------
    hull
        Faces of the hull, with a level deck.
    obstacles
        Boxes around all other bodies, in the axes of the hull.
    """
    low, high = hull.box
    length = high[0] - low[0]
    corners = hull.corners.reshape(-1, 3)
    on_deck = corners[corners[:, 2] > high[2] - 1e-3 * (high[2] - low[2])]
    if not _is_pointed(on_deck, low[0], length):
        return joined([])
    storey = min(STOREY_MOST_M, STOREY_SHARE * length)
    for aft, fore in SITES:
        x = low[0] + length * np.array([aft, fore])
        half = min(_half_beam(on_deck, end) for end in x)
        room = np.array([x[0], low[1], high[2] + 0.02]), np.array([x[1], high[1], high[2] + ROOM * storey])
        if half > 0 and not any(_overlap(room, one) for one in obstacles):
            return _built(x, 0.82 * half, high[2], storey)
    return joined([])


def _is_pointed(on_deck: NDArray[np.float64], stern: float, length: float) -> bool:
    full = np.abs(on_deck[:, 1]).max()
    return _half_beam(on_deck, stern + POINTED_AT * length) < POINTED_BELOW * full


def _half_beam(on_deck: NDArray[np.float64], x: float) -> float:
    """Half of the beam of the deck at a place along it."""
    port = on_deck[on_deck[:, 1] > 1e-6]
    order = np.argsort(port[:, 0])
    # The outermost point of each station.
    stations, first = np.unique(port[order, 0].round(3), return_index=True)
    if not len(stations):
        return 0.0
    return float(np.interp(x, stations, np.maximum.reduceat(port[order, 1], first), right=0.0))


def _overlap(one: Box, other: Box) -> bool:
    return bool(((one[0] < other[1]) & (other[0] < one[1])).all())


def _built(x: NDArray[np.float64], half: float, deck: float, storey: float) -> Faces:
    """Storeys, a wheelhouse with a band of windows, a mast."""
    length, middle = x[1] - x[0], x.mean()
    house, window = colour("house"), colour("window")
    parts = [
        cuboid((length * (1 - 0.1 * k), 2 * half * (1 - 0.04 * k), storey), house).moved(
            (middle + 0.01 * k * length, 0, deck + (k + 0.5) * storey)
        )
        for k in range(STOREYS)
    ]
    bridge, roof = deck + STOREYS * storey, 0.45 * length
    place = middle + 0.14 * length
    for share, high, paint in (
        (1.0, (0.0, 0.4), house),
        (0.97, (0.4, 0.8), window),
        (1.06, (0.8, 1.0), house),
    ):
        size = (share * roof, share * 1.7 * half, (high[1] - high[0]) * storey)
        parts.append(cuboid(size, paint).moved((place, 0, bridge + sum(high) / 2 * storey)))
    mast = cuboid((0.2 * storey, 0.2 * storey, 2.5 * storey), house)
    parts.append(mast.moved((place - 0.1 * length, 0, bridge + 2.25 * storey)))
    for k in range(STOREYS):
        row = cuboid(
            (0.86 * length * (1 - 0.1 * k), 2 * half * (1 - 0.04 * k) + 0.06 * storey, 0.3 * storey), window
        )
        parts.append(row.moved((middle + 0.01 * k * length, 0, deck + (k + 0.55) * storey)))
    return joined(parts)

"""Number of wave directions that the loads on a hull need.

N directions on the circle resolve N / 2 harmonics of a load; for a hull of length L, a wave with wave number
k has about k L / 2 harmonics. So N directions resolve waves of 2 pi L / N and more. `kingpost check` warns of
a sea by this rule.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from .airy import wave_number

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from .database import Database, Water

STEP = 12
"""The default number of directions is a multiple of this: it contains ahead, astern and abeam."""
FEWEST, MOST = 24, 120


def shortest_resolved_m(length_m: float, directions: int) -> float:
    """The shortest wave that this number of directions resolves for a hull of this length, m.

    >>> round(shortest_resolved_m(80.0, 24), 1)
    20.9
    """
    return 2 * math.pi * length_m / directions


def default_directions(length_m: float, highest_rad_s: float, water: Water) -> int:
    """The smallest multiple of 12, from 24 to 120, that resolves the shortest wave, N >= k L.

    >>> from .database import Water
    >>> [default_directions(length_m, 1.8, Water()) for length_m in (20.0, 80.0, 160.0, 400.0)]
    [24, 36, 60, 120]
    """
    wanted = math.ceil(wave_number(highest_rad_s, water) * length_m / STEP) * STEP
    return min(max(wanted, FEWEST), MOST)


def warnings(
    length_m: float, frequencies_rad_s: NDArray[np.float64], directions: int, water: Water
) -> list[str]:
    """A note on frequencies whose waves are too short for the directions; empty if there are none."""
    shortest_m = shortest_resolved_m(length_m, directions)
    shorter = [w for w in frequencies_rad_s if 2 * math.pi / wave_number(w, water) < shortest_m * (1 - 1e-9)]
    if not shorter:
        return []
    return [
        f"{directions} wave directions of the database resolve waves of {shortest_m:.1f} m and more about "
        f"its {length_m:.1f} m: those from {shorter[0]:.4g} rad/s on are shorter, with inaccurate loads at "
        "headings between the directions"
    ]


def of_database(database: Database) -> list[str]:
    """Return a note on a database's frequencies whose waves are too short for its directions, or nothing."""
    count = len(database.wave_directions_rad)
    return warnings(database.hull.length_m, database.frequencies_rad_s, count, database.water)

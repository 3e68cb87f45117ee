"""Ratios of mean periods of a sea to its peak period."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from ...errors import KingpostError

PEAK, ZERO_UP_CROSSING, ENERGY, MEAN = "peak", "zero_up_crossing", "energy", "mean"
MOMENTS = {ZERO_UP_CROSSING: (0, 2), ENERGY: (-1, 0), MEAN: (0, 1)}
"""Orders (i, j) of the spectral moments of each mean period, 2 pi (m_i / m_j)^(1 / (j - i))."""
NAMES = {
    "tp": PEAK,
    "pp1d": PEAK,
    "vtpk": PEAK,
    "peak_period_s": PEAK,
    "tz": ZERO_UP_CROSSING,
    "tm02": ZERO_UP_CROSSING,
    "vtm02": ZERO_UP_CROSSING,
    "mp2": ZERO_UP_CROSSING,
    "te": ENERGY,
    "tm10": ENERGY,
    "tm-10": ENERGY,
    "vtm10": ENERGY,
    "mwp": ENERGY,
    "tm01": MEAN,
    "mp1": MEAN,
    "peak period": PEAK,
    "peak wave period": PEAK,
    "wave peak period": PEAK,
    "zero up crossing period": ZERO_UP_CROSSING,
    "zero upcrossing period": ZERO_UP_CROSSING,
    "zero crossing period": ZERO_UP_CROSSING,
    "mean zero crossing period": ZERO_UP_CROSSING,
    "energy period": ENERGY,
}
"""Kind of a period by its name in tables and series, including names of ERA5 (mwp is T(-1, 0)) and names in
full; hyphens and underscores count as blanks."""


def kind_of(name: str) -> str | None:
    """Return the kind of a period by its name; `None` for an unknown one.

    >>> kind_of("Tz (s)"), kind_of("pp1d"), kind_of("Zero-up-crossing period(s)"), kind_of("Hs")
    ('zero_up_crossing', 'peak', 'zero_up_crossing', None)
    """
    plain = name.strip().lower().removesuffix("(s)").removesuffix("[s]").strip(" _")
    return NAMES.get(plain) or NAMES.get(" ".join(plain.replace("-", " ").replace("_", " ").split()))


@lru_cache(maxsize=64)
def ratio(kind: str, peak_enhancement: float = 3.3) -> float:
    """Compute the ratio of a mean period to the peak period of a JONSWAP spectrum.

    S(w) ~ w^-5 exp(-5/4 w^-4) gamma^exp(-(w - 1)^2 / (2 s^2)), s = 0.07 up to the peak and 0.09 above
    (Hasselmann et al. 1973; DNV-RP-C205, 3.5.5), integrated to w = 100.

    Parameters
    ----------
    kind
        ``peak``, ``zero_up_crossing``, ``energy`` or ``mean``.
    peak_enhancement
        gamma, from 1 (Pierson-Moskowitz) to 10.

    Returns
    -------
    float
        Ratio, 1; below 1 except for the peak period itself.

    Raises
    ------
    KingpostError
        If the kind is unknown or gamma is out of its range.

    >>> round(ratio("zero_up_crossing", 1.0), 3), round(ratio("energy"), 3)
    (0.71, 0.903)
    """
    if kind != PEAK and kind not in MOMENTS:
        raise KingpostError(f"period: found {kind!r}, allowed: {', '.join((PEAK, *MOMENTS))}")
    if not 1 <= peak_enhancement <= 10:
        raise KingpostError(f"peak_enhancement: found {peak_enhancement:g}, allowed: from 1 to 10")
    if kind == PEAK:
        return 1.0
    w = np.geomspace(0.2, 100.0, 20001)
    width = np.where(w <= 1, 0.07, 0.09)
    density = w**-5 * np.exp(-1.25 * w**-4) * peak_enhancement ** np.exp(-((w - 1) ** 2) / (2 * width**2))
    first, second = MOMENTS[kind]
    lower, upper = (np.trapezoid(density * w**order, w) for order in (first, second))
    return float((lower / upper) ** (1 / (second - first)))

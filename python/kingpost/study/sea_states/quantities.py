"""Parameters and fields of a scenario that set quantities of the sea."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

QUANTITIES = {
    "significant_height": "significant_height_m",
    "peak_period": "peak_period_s",
    "direction": "direction_",
}
"""Prefix of the last name in the path of a field with a quantity of the sea."""


def quantities(writes: Mapping[str, Sequence[str]]) -> dict[str, str]:
    """Find the first name that sets each quantity of the sea.

    Parameters
    ----------
    writes
        Paths of the fields that each name sets.

    >>> quantities({"tp_s": ["sea.waves.wind_sea.jonswap.peak_period_s"], "load_t": ["bodies.load.mass_t"]})
    {'peak_period': 'tp_s'}
    """
    found: dict[str, str] = {}
    for name, paths in writes.items():
        for path in paths:
            for quantity, beginning in QUANTITIES.items():
                if path.startswith("sea.") and path.rpartition(".")[2].startswith(beginning):
                    found.setdefault(quantity, name)
    return found

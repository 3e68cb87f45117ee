"""Whether a database's frequencies cover a sea."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..errors import HydrodynamicsError

if TYPE_CHECKING:
    from .database import Database


def coverage(database: Database, lowest_rad_s: float, highest_rad_s: float) -> None:
    """Refuse a sea with waves beyond the database's frequencies: coefficients are not extrapolated.

    Parameters
    ----------
    lowest_rad_s, highest_rad_s
        Of the sea's components, rad/s.

    Raises
    ------
    HydrodynamicsError
        When one of them is outside the database's.
    """
    first, last = database.frequencies_rad_s[0], database.frequencies_rad_s[-1]
    if not (first <= lowest_rad_s <= highest_rad_s <= last):
        raise HydrodynamicsError(
            "frequencies_rad_s",
            f"{first:.4g} to {last:.4g} rad/s",
            f"frequencies that cover the sea's, {lowest_rad_s:.4g} to {highest_rad_s:.4g} rad/s: compute "
            "more of them, or cut the spectrum",
        )

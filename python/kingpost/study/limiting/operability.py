"""Operability: the share of a site's sea states in which work is possible."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from ...errors import KingpostError
from ..sea_states.scatter import ScatterTable
from .sea import OUTSIDE, LimitingHeight

if TYPE_CHECKING:
    from numpy.typing import NDArray


@dataclass(frozen=True)
class Operability:
    """The share of a scatter table below the limiting height, from 0 to 1.

    Attributes
    ----------
    share
        Operable share of all occurrences.
    outside
        Share of occurrences whose period or direction is outside the studied range; they count as not
        operable.
    by_month
        Operable share of each month's occurrences, by the month's number; empty if the table has no months.
    by_direction_deg
        Operable share by the direction that the waves travel towards, in whole degrees.
    by_limit
        Share of all occurrences that each limit excludes: seas above its limiting height where this limit
        governs.
    total
        Sum of the table's occurrences.
    outside_periods_s
        Peak periods of the table outside the studied range, s, from low to high.
    """

    share: float
    outside: float
    by_month: dict[int, float]
    by_direction_deg: dict[int, float]
    by_limit: dict[str, float]
    total: float
    outside_periods_s: tuple[float, ...] = ()

    def to_dict(self) -> dict[str, Any]:
        """Return the operability as dictionaries and numbers."""
        return asdict(self)


def operability(
    table: ScatterTable,
    limiting_height: LimitingHeight,
    direction_rad: float | None = None,
    peak_enhancement: float = 3.3,
) -> Operability:
    """Compute the share of a scatter table's occurrences with a significant height up to the limiting one.

    Within a class the heights are uniformly distributed between its edges; its period is that of its centre.
    A class whose period or direction was not studied is not operable.

    Parameters
    ----------
    table
        Scatter table of the site.
    limiting_height
        Function of peak period (s) and direction (rad) that returns the limiting height and the governing
        limit, such as a `LimitingSea`.
    direction_rad
        Direction that all waves travel towards, in the scenario's axes, if the table has no directions.
    peak_enhancement
        gamma of JONSWAP, by which mean periods of the table become peak periods.

    Returns
    -------
    Operability
        The shares.

    Raises
    ------
    KingpostError
        If there is no direction, neither in the table nor given.

    >>> from kingpost.study.sea_states.scatter import parse
    >>> table = parse("Hs/Tp,4-6,6-8\\n0-1,30,20\\n1-2,10,40")
    >>> limits = lambda period_s, _: (1.5, "heel") if period_s < 6 else (1.0, "tension")
    >>> found = operability(table, limits, direction_rad=0.0)
    >>> round(found.share, 9), found.by_limit
    (0.55, {'heel': 0.05, 'tension': 0.4})
    """
    if table.direction_rad is None and direction_rad is None:
        raise KingpostError(
            "direction: found none in the scatter table, allowed: a column of it, or one direction of all "
            "waves (direction_rad)"
        )
    table = table.with_peak_periods(peak_enhancement)
    directions = (
        np.full(len(table.period_s), direction_rad or 0.0)
        if table.direction_rad is None
        else table.direction_rad
    )
    known: dict[tuple[float, float], tuple[float, str]] = {}
    for key in zip(table.period_s.tolist(), directions.tolist(), strict=True):
        if key not in known:
            known[key] = limiting_height(*key)
    limits = [known[key] for key in zip(table.period_s.tolist(), directions.tolist(), strict=True)]
    heights = np.array([height for height, _ in limits])
    governs = np.array([name for _, name in limits])
    share = _below(table, heights)
    weights = table.occurrences / table.total
    lost = weights * (1 - share)
    is_outside = np.isnan(heights)
    return Operability(
        share=float((weights * share).sum()),
        outside=float(weights[is_outside].sum()),
        by_month=_by(table.month, weights, share),
        by_direction_deg=_by(_whole_degrees(table.direction_rad), weights, share),
        by_limit={
            str(name): float(lost[~is_outside & (governs == name)].sum())
            for name in dict.fromkeys(governs.tolist())
            if name != OUTSIDE and lost[governs == name].sum() > 0
        },
        total=table.total,
        outside_periods_s=tuple(np.unique(table.period_s[is_outside & (weights > 0)]).tolist()),
    )


def _below(table: ScatterTable, heights: NDArray[np.float64]) -> NDArray[np.float64]:
    """Share of each class up to the limiting height; 0 where that height is NaN."""
    width = table.height_to_m - table.height_from_m
    is_point = width == 0
    with np.errstate(invalid="ignore", divide="ignore"):
        part = np.clip((heights - table.height_from_m) / width, 0.0, 1.0)
    return np.nan_to_num(np.where(is_point, (table.height_m <= heights).astype(float), part), nan=0.0)


def _by(
    keys: NDArray[np.int64] | None, weights: NDArray[np.float64], share: NDArray[np.float64]
) -> dict[int, float]:
    if keys is None:
        return {}
    found = {}
    for key in np.unique(keys).tolist():
        of_key = weights * (keys == key)
        if of_key.sum() > 0:
            found[int(key)] = float((of_key * share).sum() / of_key.sum())
    return found


def _whole_degrees(radians: NDArray[np.float64] | None) -> NDArray[np.int64] | None:
    return None if radians is None else np.round(np.degrees(radians)).astype(np.int64) % 360

"""Limiting sea at any period and direction within the studied ones."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ...errors import KingpostError
from ...results.entries import sea_of

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

    from ...scenario import ParameterValue

OUTSIDE = "outside the study"
NO_LIMIT = "no limit"

LimitingHeight = Callable[[float, float], tuple[float, str]]
"""Function of peak period (s) and of the direction that the waves travel towards in the scenario's axes
(rad). It returns the limiting significant height (m) and the governing limit. The height is NaN if it is
unknown, and infinite if no limit is reached."""


@dataclass(frozen=True)
class LimitingSea:
    """Limiting heights over peak period and direction, interpolated linearly between the studied values.
    Called with a peak period (s) and the direction that the waves travel towards (rad, in the scenario's
    axes), it returns the smallest limiting height (m) and the governing limit; outside the studied range NaN
    and `OUTSIDE`.

    Attributes
    ----------
    periods_s
        Rising.
    directions_rad
        Rising; without any, the height is that of all directions.
    heights_m
        Along limits, periods and, if there are any, directions.
    limits
        Names.

    >>> heights_m = np.array([[2.0, 1.0], [1.5, 1.5]])
    >>> sea = LimitingSea(np.array([6.0, 8.0]), np.empty(0), heights_m, ("heel", "tension"))
    >>> sea(6.5, 0.0), sea(8.0, 0.0)
    ((1.5, 'tension'), (1.0, 'heel'))
    >>> sea(9.0, 0.0)
    (nan, 'outside the study')
    """

    periods_s: NDArray[np.float64]
    directions_rad: NDArray[np.float64]
    heights_m: NDArray[np.float64]
    limits: tuple[str, ...]

    @classmethod
    def of(
        cls,
        found: xarray.Dataset,
        at: Mapping[str, ParameterValue] | None = None,
        sea: Mapping[str, str] | None = None,
    ) -> LimitingSea:
        """Make the limiting sea from limiting heights by runs (`limiting_heights`) or by the screen.

        Parameters
        ----------
        found
            ``limiting_height`` along ``limit`` and axes.
        at
            Values of the axes other than peak period and direction, by name; axes with one value may be
            omitted.
        sea
            Names of the axes of ``peak_period`` and ``direction``; default: the attributes
            ``sea_peak_period`` and ``sea_direction``.

        Raises
        ------
        KingpostError
            If there is no axis of the peak period, or the value of another axis is missing.
        """
        names = sea_of(found) | dict(sea or {})
        period, direction = names.get("peak_period"), names.get("direction")
        heights = found["limiting_height"]
        if period not in heights.dims:
            axes = ", ".join(str(dim) for dim in heights.dims if dim != "limit") or "none"
            raise KingpostError(f"peak period: found no axis of it among {axes}, allowed: one")
        for name in heights.dims:
            if name in ("limit", period, direction):
                continue
            heights = _at(heights, str(name), (at or {}).get(str(name)))
        dims = ["limit", period] + ([direction] if direction in heights.dims else [])
        heights = heights.transpose(*dims).sortby(period)
        radians = np.empty(0)
        if direction in heights.dims:
            values = np.asarray(heights[direction].values, float)
            units = str(heights[direction].attrs.get("units", ""))
            is_deg = units in ("deg", "degree", "degrees") or str(direction).endswith("_deg")
            radians = np.radians(values) if is_deg else values
            order = np.argsort(radians)
            heights, radians = heights.isel({direction: order}), radians[order]
        limits = tuple(str(name) for name in found["limit"].values)
        return cls(
            np.asarray(heights[period].values, float), radians, np.asarray(heights.values, float), limits
        )

    def __call__(self, peak_period_s: float, direction_rad: float) -> tuple[float, str]:
        of_limits = self.of_limits(peak_period_s, direction_rad)
        if np.isnan(of_limits).all():
            return np.nan, OUTSIDE
        smallest = int(np.nanargmin(of_limits))
        height = float(of_limits[smallest])
        return height, self.limits[smallest] if np.isfinite(height) else NO_LIMIT

    def of_limits(self, peak_period_s: float, direction_rad: float) -> NDArray[np.float64]:
        """The height of each limit, m."""
        heights = self.heights_m
        place = _place(self.periods_s, peak_period_s)
        if place is None:
            return np.full(len(self.limits), np.nan)
        heights = _between(heights, place, axis=1)
        if not len(self.directions_rad):
            return heights
        directions, heights = _round(self.directions_rad, heights)
        turns = (direction_rad - directions[0]) % (2 * np.pi)
        # Rounding may put the first direction one turn further.
        turns = (
            0.0 if 2 * np.pi - turns < 1e-9 and directions[-1] - directions[0] < 2 * np.pi - 1e-6 else turns
        )
        place = _place(directions, directions[0] + turns)
        return np.full(len(self.limits), np.nan) if place is None else _between(heights, place, axis=1)


def _at(heights: xarray.DataArray, name: str, value: ParameterValue | None) -> xarray.DataArray:
    values = heights[name].values.tolist()
    if value is None and len(values) == 1:
        return heights.isel({name: 0}, drop=True)
    if value not in values:
        found = "no value" if value is None else repr(value)
        raise KingpostError(f"{name}: found {found}, allowed: one of {', '.join(map(str, values))}")
    return heights.isel({name: values.index(value)}, drop=True)


def _place(values: NDArray[np.float64], value: float) -> tuple[int, int, float] | None:
    """Indices of the values on both sides, and the weight of the second; `None` outside."""
    tolerance = 1e-9 * max(abs(values[0]), abs(values[-1]), 1.0)
    if not values[0] - tolerance <= value <= values[-1] + tolerance:
        return None
    if len(values) == 1:
        return 0, 0, 0.0
    k = int(np.clip(np.searchsorted(values, value, side="right") - 1, 0, len(values) - 2))
    return k, k + 1, float(np.clip((value - values[k]) / (values[k + 1] - values[k]), 0.0, 1.0))


def _between(heights: NDArray[np.float64], place: tuple[int, int, float], axis: int) -> NDArray[np.float64]:
    first, second, share = place
    low, high = np.take(heights, first, axis), np.take(heights, second, axis)
    # At a studied value the neighbour, which may be infinite or NaN, must not contribute.
    if share in (0.0, 1.0):
        return high if share else low
    with np.errstate(invalid="ignore"):
        return np.where(low == high, low, (1 - share) * low + share * high)


def _round(
    directions: NDArray[np.float64], heights: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Append the first direction one turn later if the directions cover the whole circle."""
    if len(directions) < 3:
        return directions, heights
    gap = directions[0] + 2 * np.pi - directions[-1]
    if not 1e-9 < gap <= np.diff(directions).max() * (1 + 1e-6):
        return directions, heights
    return np.append(directions, directions[0] + 2 * np.pi), np.concatenate([heights, heights[:, :1]], axis=1)

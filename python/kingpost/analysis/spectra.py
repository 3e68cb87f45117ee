"""Spectral densities of records, and their moments."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..errors import KingpostError
from .records import after, even

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray


def spectrum(
    series: xarray.DataArray, after_s: float = 0.0, segment_s: float | None = None
) -> xarray.DataArray:
    """Spectral density by Welch's method, over the angular frequency ``omega``, rad/s.

    The record, less its mean, is cut into segments that overlap by half; each is multiplied by a Hann
    window and transformed, and the squares are averaged (Welch, *IEEE Trans. Audio Electroacoust.*
    15(2), 1967). The density is one-sided and divided by the mean square of the window, so that its integral
    is the variance, except for sampling error.

    Parameters
    ----------
    series
        Record with even steps of ``time``; other dimensions are kept.
    after_s
        Records before this time, s, are left out.
    segment_s
        Length of a segment, s; default: an eighth of the record. The frequency spacing is 2 pi / segment.

    Returns
    -------
    xarray.DataArray
        Along ``omega`` (rad/s), in the square of the unit times s/rad.

    Raises
    ------
    KingpostError
        When the record is uneven or too short for the segment.

    >>> from kingpost import run
    >>> roll = run("paper", {"simulation.duration_s": 0.5})["roll"].sel(body="ship")
    >>> spectrum(roll, segment_s=0.25).dims
    ('omega',)
    """
    import xarray

    kept, step_s = even(after(series, after_s))
    length = round((kept.sizes["time"] * step_s / 8 if segment_s is None else segment_s) / step_s)
    if not 8 <= length <= kept.sizes["time"]:
        allowed = f"from {8 * step_s:g} to {kept.sizes['time'] * step_s:g} s, the record's length"
        raise KingpostError(f"segment_s: found {length * step_s:g} s, allowed: {allowed}")
    axis = kept.get_axis_num("time")
    omega, density = _welch(np.moveaxis(kept.values, axis, -1), step_s, length)
    dims = [dim for dim in kept.dims if dim != "time"]
    coordinates = {dim: kept[dim] for dim in dims if dim in kept.coords}
    about = {"units": "rad/s", "long_name": "angular frequency"}
    unit = kept.attrs.get("units", "")
    return xarray.DataArray(
        density,
        {**coordinates, "omega": ("omega", omega, about)},
        (*dims, "omega"),
        kept.name,
        {"units": f"({unit})^2 s/rad", "long_name": f"spectral density of {kept.name}"},
    )


def moments(density: xarray.DataArray, orders: tuple[int, ...] = (0, 1, 2, 4)) -> xarray.DataArray:
    """Spectral moments ``m_n = Int w^n S(w) dw`` by the trapezoidal rule, along the dimension ``order``.

    With them the standard deviation is sqrt(m0), the significant double amplitude 4 sqrt(m0) and the mean
    zero up-crossing period 2 pi sqrt(m0 / m2).

    Parameters
    ----------
    density
        Result of `spectrum`, along ``omega`` (rad/s).
    orders
        Order n of each moment.

    Returns
    -------
    xarray.DataArray
        Along ``order``.

    >>> import xarray
    >>> flat = xarray.DataArray([1.0, 1.0], {"omega": [0.0, 2.0]}, ("omega",))
    >>> moments(flat, (0, 1)).values
    array([2., 2.])
    """
    import xarray

    omega = density["omega"]
    parts = [(density * omega**n).integrate("omega") for n in orders]
    return xarray.concat(parts, xarray.DataArray(np.array(orders), dims="order", name="order"))


def _welch(
    values: NDArray[np.float64], step_s: float, length: int
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Angular frequencies and the one-sided density, along the last axis. The mean of the whole record is
    subtracted, not that of each segment, so that slow motions are kept."""
    from scipy.signal import welch

    values = values - values.mean(axis=-1, keepdims=True)
    overlap = length - length // 2
    hz, density = welch(values, 1 / step_s, "hann", length, noverlap=overlap, detrend=False)
    return 2 * np.pi * hz, density / (2 * np.pi)

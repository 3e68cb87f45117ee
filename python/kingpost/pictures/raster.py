"""Triangles to pixels, with a depth buffer."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray


class Raster:
    """Picture of triangles: the nearest one at each sample.

    Depths are stored as their inverses, which are linear over a triangle on the screen. 0 is infinitely far.

    Parameters
    ----------
    width, height
        Samples of the picture.

    Attributes
    ----------
    nearness
        1 over the depth of each sample, 1/m; shape (height, width).
    colours
        Red, green and blue of each sample; shape (height, width, 3). Not set where `nearness` is 0.

    >>> raster = Raster(4, 4)
    >>> corners = np.array([[[0, 0, 0.5], [8, 0, 0.5], [0, 8, 0.5]]])
    >>> raster.add(corners, np.ones((1, 3)))
    >>> bool((raster.nearness == 0.5).all())
    True
    """

    def __init__(self, width: int, height: int) -> None:
        self.nearness = np.zeros((height, width), np.float32)
        self.colours = np.zeros((height, width, 3), np.float32)

    def add(self, corners: NDArray[np.float64], colours: NDArray[np.float64]) -> None:
        """Draw triangles.

        Parameters
        ----------
        corners
            Corners on the screen: x to the right and y down, samples, and 1 over the depth, 1/m; shape
            (triangles, 3, 3).
        colours
            Shape (triangles, 3).
        """
        triangle, row, left, right = _spans(corners, *self.nearness.shape)
        length = right - left
        pixel = np.repeat(row * self.nearness.shape[1] + left, length) + _counts(length)
        of = np.repeat(triangle, length)
        across, start = _slopes(corners, triangle, row, left)
        nearness = np.repeat(start, length) + np.repeat(across, length) * _counts(length)
        nearness = nearness.astype(np.float32)
        flat, painted = self.nearness.reshape(-1), self.colours.reshape(-1, 3)
        np.maximum.at(flat, pixel, nearness)
        wins = nearness == flat[pixel]
        painted[pixel[wins]] = colours[of[wins]]


def _spans(corners: NDArray[np.float64], height: int, width: int) -> tuple[NDArray[np.intp], ...]:
    """Triangle, row, first sample and one past the last sample of each row that a triangle covers."""
    x, y = corners[:, :, 0], corners[:, :, 1]
    first = np.clip(np.ceil(y.min(axis=1) - 0.5), 0, height).astype(np.intp)
    last = np.clip(np.ceil(y.max(axis=1) - 0.5), 0, height).astype(np.intp)
    rows = np.maximum(last - first, 0)
    triangle = np.repeat(np.arange(len(corners)), rows)
    row = np.repeat(first, rows) + _counts(rows)
    middle = row + 0.5
    left, right = np.full(len(row), np.inf), np.full(len(row), -np.inf)
    for k in range(3):
        x0, y0, x1, y1 = x[:, k], y[:, k], x[:, k - 1], y[:, k - 1]
        rise = np.where(y1 == y0, np.inf, y1 - y0)
        slope = ((x1 - x0) / rise)[triangle]
        crosses = (middle - y0[triangle]) * (middle - y1[triangle]) <= 0
        at = x0[triangle] + slope * (middle - y0[triangle])
        left = np.where(crosses, np.minimum(left, at), left)
        right = np.where(crosses, np.maximum(right, at), right)
    begin = np.clip(np.ceil(left - 0.5), 0, width).astype(np.intp)
    end = np.clip(np.ceil(right - 0.5), 0, width).astype(np.intp)
    kept = end > begin
    return triangle[kept], row[kept], begin[kept], end[kept]


def _counts(lengths: NDArray[np.intp]) -> NDArray[np.intp]:
    """0 to length - 1, for each length.

    >>> _counts(np.array([2, 3]))
    array([0, 1, 0, 1, 2])
    """
    ends = np.cumsum(lengths)
    return np.arange(ends[-1] if len(ends) else 0) - np.repeat(ends - lengths, lengths)


def _slopes(
    corners: NDArray[np.float64], triangle: NDArray[np.intp], row: NDArray[np.intp], left: NDArray[np.intp]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Change of the nearness from sample to sample, and its value at the first sample of each span."""
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    area = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
    area = np.where(area == 0, np.inf, area)
    along_x = (first[:, 2] * second[:, 1] - first[:, 1] * second[:, 2]) / area
    along_y = (first[:, 0] * second[:, 2] - first[:, 2] * second[:, 0]) / area
    x0, y0, near = corners[:, 0].T
    start = near[triangle] + along_x[triangle] * (left + 0.5 - x0[triangle])
    start += along_y[triangle] * (row + 0.5 - y0[triangle])
    return along_x[triangle], start

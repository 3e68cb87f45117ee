"""Sky, water and floor of a picture: all that does not move while the camera stands."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .camera import FIELD_RAD, Camera
from .palette import colour

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Pixels = NDArray[np.floating[Any]]

RIPPLES = ((0.9, 0.3, 3.0), (-1.0, 1.6, 3.7), (0.75, -3.3, 4.9), (6.4, 3.6, 7.8), (-6.0, 9.5, 10.2))
"""Wave numbers along x and y, over 9 / size of the scene, and phase of the ripples of the drawn surface: they
give it a scale, and are not the waves of the run."""
FAR = 9.0
"""Distance at which 1/e of the contrast of water and floor is left, sizes of the scene."""


@dataclass(frozen=True)
class Surroundings:
    """Water and floor of a scene.

    Attributes
    ----------
    has_sea
        Whether still water is at height 0; otherwise a floor with a grid lies below everything.
    is_submerged
        Whether everything is under water: the surface is then not drawn.
    floor_m
        Height of the floor.
    size_m
        Diagonal of everything.
    clear_m
        Path through water after which 1/e of the light is left.
    """

    has_sea: bool
    is_submerged: bool
    floor_m: float
    size_m: float
    clear_m: float


class Backdrop:
    """Light of each pixel without an object.

    Parameters
    ----------
    camera, around
        Viewpoint and surroundings.
    size_px
        Width and height, pixels.

    Attributes
    ----------
    light
        Red, green and blue, shape (height, width, 3).
    """

    def __init__(self, camera: Camera, around: Surroundings, size_px: tuple[int, int]) -> None:
        self.around = around
        width, height = size_px
        tangent = np.tan(FIELD_RAD / 2)
        self._axes = (camera.back, camera.right * tangent * camera.aspect, camera.top * tangent)
        self._drop_m = camera.eye_m[2] - (0.0 if around.has_sea else around.floor_m)
        x = ((np.arange(width, dtype=np.float32) + 0.5) * 2 / width - 1)[None, :]
        y = (1 - (np.arange(height, dtype=np.float32) + 0.5) * 2 / height)[:, None]
        self.light = _sky(around, x, y)
        nearness = self.nearness(x, y)
        rows, columns = np.nonzero(nearness > 0)
        if around.is_submerged or not len(rows):
            return
        depth = 1 / nearness[rows, columns]
        rays = self._rays(x[0, columns], y[rows, 0])
        place = camera.eye_m[:2, None].astype(np.float32) + depth * rays[:2]
        lay = _water if around.has_sea else _floor
        steepness = -rays[2] / np.linalg.norm(rays, axis=0)
        self.light[rows, columns] = lay(self.light[rows, columns], place, depth, steepness, around)

    def _rays(self, x: Pixels, y: Pixels) -> Pixels:
        """Directions through places of the picture, of length 1 along the direction of view."""
        back, right, top = (axis.astype(np.float32) for axis in self._axes)
        return np.multiply.outer(right, x) + np.multiply.outer(top, y) - back[:, None]

    def nearness(self, x: Pixels, y: Pixels) -> Pixels:
        """1 over the depth of the water or the floor at places of the picture, 1/m; negative above the
        horizon."""
        back, right, top = (np.float32(axis[2] / self._drop_m) for axis in self._axes)
        return back - right * x - top * y

    def path_m(self, x: Pixels, y: Pixels, behind: Pixels) -> Pixels:
        """Path through the water from its surface to an object of a nearness; negative for one before it."""
        return (1 / behind - 1 / self.nearness(x, y)) * np.linalg.norm(self._rays(x, y), axis=0)


def _sky(around: Surroundings, x: Pixels, y: Pixels) -> Pixels:
    """Light without an object: paler towards the horizon; under water blue."""
    rise = np.clip(0.5 + 0.5 * y, 0, 1)[:, :, None]
    low, high = colour("sky-low"), colour("sky-high")
    if around.is_submerged:
        low, high = (share * colour("haze") + (1 - share) * colour("shallow") for share in (0.55, 0.85))
    return np.repeat((low + rise * (high - low)).astype(np.float32), x.shape[1], axis=1)


def _water(behind: Pixels, place: Pixels, depth: Pixels, steepness: Pixels, around: Surroundings) -> Pixels:
    """Light from the surface of the sea; `steepness` is the sine of the angle at which it is seen."""
    wave = np.float32(9.0 / around.size_m)
    slope = sum(
        np.sin(wave * (np.float32(kx) * place[0] + np.float32(ky) * place[1]) + np.float32(phase)) / (1 + k)
        for k, (kx, ky, phase) in enumerate(RIPPLES)
    )
    slope = slope * np.exp(-depth / (4 * around.size_m))
    mirror = np.clip((1 - steepness) ** 3 + 0.05 * slope, 0, 1)[:, None]
    body = 0.30 * colour("deep") + 0.35 * colour("shallow") + 0.35 * colour("haze")
    light = body + mirror * (colour("sky-high") - body)
    fade = np.exp(-depth / (FAR * around.size_m))[:, None]
    return (fade * light + (1 - fade) * colour("sky-low")).astype(np.float32)


def _floor(behind: Pixels, place: Pixels, depth: Pixels, steepness: Pixels, around: Surroundings) -> Pixels:
    """A floor with a grid of lines."""
    spacing = grid_spacing_m(around.size_m)
    width = np.maximum(0.012 * spacing, 0.0009 * depth)
    off = np.abs(place / spacing - np.round(place / spacing)) * spacing
    line = np.clip(1.5 - off / width, 0, 1).max(axis=0)
    share = (0.32 * line * np.exp(-depth / (FAR * around.size_m)))[:, None]
    return (behind + share * (colour("grid") - behind)).astype(np.float32)


def grid_spacing_m(size_m: float) -> float:
    """Distance of the lines of a grid: 1, 2 or 5 times a power of ten.

    >>> grid_spacing_m(22.0), grid_spacing_m(300.0)
    (5.0, 50.0)
    """
    power = 10.0 ** np.floor(np.log10(size_m / 5))
    return float(min((part * power for part in (1, 2, 5, 10)), key=lambda one: abs(np.log(one * 5 / size_m))))

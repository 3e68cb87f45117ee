"""Pixels of a scene: shaded faces and threads before a backdrop, under water and above it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from .backdrop import Backdrop
from .camera import Camera
from .faces import Faces
from .palette import colour
from .raster import Raster

if TYPE_CHECKING:
    from numpy.typing import NDArray

TO_SUN = np.array([-0.35, -0.62, 0.70])
"""Direction to the sun: from the side of the default view, so that faces towards the eye are lit."""
SUN, SKY, GROUND = 0.58, 0.58, 0.34
"""Light on a face towards the sun, towards the zenith and towards the ground."""
SAMPLES = 2
"""Samples of a pixel along each axis: their mean smooths edges."""
THREAD_PX = 1.6
"""Width of a line that is too thin to be drawn to scale, pixels."""
TOWARDS_EYE = 1.002
"""Factor on the nearness of threads, so that those on a surface are not hidden by it."""
NEAR = 0.02
"""Smallest depth of a drawn corner, sizes of the scene."""
OPACITY = 0.34
"""Share of the water's own light in the light from an object just below its surface."""


def paint(
    faces: Faces,
    lines: Sequence[NDArray[np.float64]],
    camera: Camera,
    backdrop: Backdrop,
) -> NDArray[np.uint8]:
    """Draw a scene.

    Parameters
    ----------
    faces
        Triangles, world.
    lines
        Points of thin lines, world, m.
    camera, backdrop
        Viewpoint and surroundings.

    Returns
    -------
    numpy.ndarray
        Red, green and blue, shape (height, width, 3).
    """
    height, width = backdrop.light.shape[:2]
    raster = Raster(SAMPLES * width, SAMPLES * height)
    corners, paints = _shaded(faces, camera, NEAR * backdrop.around.size_m)
    strips, dark = _strips(lines, camera, height)
    seen = np.concatenate([camera.seen(corners), strips])
    x = (seen[..., 0] + 1) * (SAMPLES * width / 2)
    y = (1 - seen[..., 1]) * (SAMPLES * height / 2)
    raster.add(np.stack([x, y, seen[..., 2]], axis=-1), np.concatenate([paints, dark]))
    picture = backdrop.light.copy()
    _merge(picture, raster, backdrop)
    return (np.clip(picture, 0, 1) * 255 + 0.5).astype(np.uint8)


def _shaded(faces: Faces, camera: Camera, near_m: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Corners of the faces before the eye, and their colours in the light."""
    kept = (camera.depths(faces.corners) > near_m).all(axis=1)
    corners = faces.corners[kept]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    # The inner side of an open mesh is lit like its outer side.
    to_eye = np.einsum("fi,fi->f", normals, camera.eye_m - corners[:, 0])
    normals = np.where((to_eye < 0)[:, None], -normals, normals)
    sun = np.maximum(normals @ (TO_SUN / np.linalg.norm(TO_SUN)), 0.0)
    up = 0.5 + 0.5 * normals[:, 2]
    light = SUN * sun + SKY * up + GROUND * (1 - up)
    return corners, np.minimum(faces.colours[kept] * light[:, None], 1.0)


def _strips(
    lines: Sequence[NDArray[np.float64]], camera: Camera, height_px: int
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Two triangles in the picture for each part of a line, with a width in pixels, and their colours."""
    starts = np.concatenate([np.empty((0, 3)), *(line[:-1] for line in lines)])
    ends = np.concatenate([np.empty((0, 3)), *(line[1:] for line in lines)])
    kept = (camera.depths(starts) > 0) & (camera.depths(ends) > 0)
    first, second = camera.seen(starts[kept]), camera.seen(ends[kept])
    shape = np.array([camera.aspect, 1.0])
    way = (second - first)[:, :2] * shape
    way /= np.maximum(np.linalg.norm(way, axis=1, keepdims=True), 1e-300)
    aside = np.stack([-way[:, 1], way[:, 0]], axis=1) / shape * (THREAD_PX / height_px)
    offset = np.concatenate([aside, np.zeros((len(aside), 1))], axis=1)
    corners = [(first + offset), (first - offset), (second - offset), (second + offset)]
    a, b, c, d = (corner * [1.0, 1.0, TOWARDS_EYE] for corner in corners)
    strips = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    return strips, np.tile(colour("line"), (len(strips), 1))


def _merge(picture: NDArray[np.float32], raster: Raster, backdrop: Backdrop) -> None:
    """Lay the samples of a raster over a backdrop, and the water over those under it."""
    height, width = picture.shape[:2]
    blocks = (height, SAMPLES, width, SAMPLES)
    rows, columns = np.nonzero(raster.nearness.reshape(blocks).any(axis=(1, 3)))
    behind = picture[rows, columns]
    sums = np.zeros_like(behind)
    for down in range(SAMPLES):
        for across in range(SAMPLES):
            row, column = SAMPLES * rows + down, SAMPLES * columns + across
            nearness, light = raster.nearness[row, column], raster.colours[row, column]
            is_solid = nearness > 0
            if backdrop.around.has_sea and not backdrop.around.is_submerged:
                x = (column + np.float32(0.5)) * np.float32(2 / (SAMPLES * width)) - 1
                y = 1 - (row + np.float32(0.5)) * np.float32(2 / (SAMPLES * height))
                is_wet = is_solid & (backdrop.nearness(x, y) > nearness)
                path = backdrop.path_m(x[is_wet], y[is_wet], nearness[is_wet])
                through = (1 - OPACITY) * np.exp(-path / backdrop.around.clear_m)[:, None]
                light[is_wet] = through * light[is_wet] + (1 - through) * behind[is_wet]
            sums += np.where(is_solid[:, None], light, behind)
    picture[rows, columns] = sums / SAMPLES**2

"""Hulls as meshes: panels of the wetted part and the closed hull with its deck."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .database import Attitude, Mesh
from .panels import Panels, corners_of, mirrored, of_patches
from .surface import Particulars, Surface, check_closed, particulars

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from .shapes import Shape

HULL_TRIANGLES = 530
"""Approximate number of triangles of the closed hull in a database."""
PARTICULARS_PANELS = 30_000
"""Approximate number of panels for the volume and the waterplane of a parametric hull."""


@dataclass(frozen=True)
class HullMeshes:
    """Meshes and particulars of a hull for the panel method and the database, z = 0 on the water plane.

    Attributes
    ----------
    source
        Description of the hull, for the provenance.
    reflections
        Axes (0 is x, 1 is y) along which `panels` are mirrored to give the whole wetted hull.
    panels
        The wetted part, or a half or a quarter of it.
    particulars
        Particulars of the whole wetted hull.
    hull
        The closed hull with its deck, or `None` if the mesh ends at the water line or has too many triangles.
    why_no_hull
        The reason if there is none; otherwise empty.
    attitude
        Attitude of the hull, if it is not upright: panels, particulars and their axes are then those of the
        wetted hull in this attitude.
    upright
        For a hull with an attitude: the upright hull, whose particulars and mesh the database stores.
    attitude_source
        Origin of the attitude, for the provenance.
    remarks
        Notes about the attitude.
    """

    source: str
    reflections: tuple[int, ...]
    panels: Panels
    particulars: Particulars
    hull: Mesh | None
    why_no_hull: str = ""
    attitude: Attitude | None = None
    upright: HullMeshes | None = None
    attitude_source: str = ""
    remarks: tuple[str, ...] = ()

    @property
    def panel_count(self) -> int:
        """Panels of the whole wetted hull."""
        return len(self.panels.faces) * 2 ** len(self.reflections)

    @property
    def panel_size_m(self) -> float:
        """Side of a square with a panel's mean area."""
        return (self.panels.surface.area / len(self.panels.faces)) ** 0.5


def whole(part: Surface, reflections: tuple[int, ...]) -> Surface:
    """A part with its mirror images."""
    for axis in reflections:
        part = part.joined(part.mirrored(axis))
    return part


def parametric(shape: Shape, source: str, panels: int) -> HullMeshes:
    """Meshes of a parametric hull with approximately the given number of panels.

    The particulars are those of a much finer mesh. The meshes are stretched, because their flat panels cut
    off some volume, so that they displace the same volume.
    """
    size, fine = ((shape.wetted_area_m2 / count) ** 0.5 for count in (panels, PARTICULARS_PANELS))
    found = particulars(whole(_wetted(shape, fine).surface, shape.reflections))
    coarse = _hull_size(shape)
    stretch = _stretch(shape, coarse, found.volume_m3)
    wet = [grid * stretch for grid in shape.wetted(coarse)]
    dry = [grid * [*stretch[:2], 1.0] for grid in shape.dry(coarse)]
    hull = whole(of_patches([*wet, *dry], _inside(shape)).surface, shape.reflections)
    check_closed(hull, None)
    wetted = _wetted(shape, size, _stretch(shape, size, found.volume_m3))
    return HullMeshes(source, shape.reflections, wetted, found, Mesh(hull.vertices, hull.triangles))


def closed(shape: Shape, size_m: float, volume_m3: float | None = None) -> Surface:
    """The whole hull of a shape with its deck, points not merged: triangles of `closed_panels` and their
    images."""
    quads = closed_panels(shape, size_m, volume_m3, shape.reflections)
    corners = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    return Surface(corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3))


def closed_panels(
    shape: Shape, size_m: float, volume_m3: float | None, reflections: Sequence[int]
) -> NDArray[np.float64]:
    """Corners of the panels of a shape with its deck, shape (panels, 4, 3), panels of approximately the
    stated size.

    They cover the part that the shape describes, and its mirror images; stretched if a volume is given,
    so that the whole upright hull displaces it.
    """
    stretch = np.ones(3) if volume_m3 is None else _stretch(shape, size_m, volume_m3)
    # A sphere is stretched above the water as below it; other hulls only along x and y.
    above = stretch if len(shape.stretched) == 3 else stretch * [1, 1, 0] + [0, 0, 1]
    patches = [grid * stretch for grid in shape.wetted(size_m)] + [grid * above for grid in shape.dry(size_m)]
    quads = corners_of(patches, _inside(shape))
    for axis in reflections:
        quads = np.concatenate([quads, mirrored(quads, axis)])
    return quads


def _inside(shape: Shape) -> NDArray[np.float64]:
    return np.array([0.0, 0.0, -0.5 * shape.draught_m])


def _wetted(shape: Shape, size: float, stretch: NDArray[np.float64] | float = 1.0) -> Panels:
    return of_patches([grid * stretch for grid in shape.wetted(size)], _inside(shape))


def _stretch(shape: Shape, size: float, volume: float) -> NDArray[np.float64]:
    """Stretch factors along x, y, z with which a mesh of this size displaces the volume."""
    found = particulars(whole(_wetted(shape, size).surface, shape.reflections)).volume_m3
    factors = np.ones(3)
    factors[list(shape.stretched)] = (volume / found) ** (1 / len(shape.stretched))
    return factors


def _hull_size(shape: Shape) -> float:
    """The smallest panel with which the closed hull has no more than the wanted triangles."""
    size = (shape.wetted_area_m2 / 20) ** 0.5
    while True:
        finer = 0.95 * size
        patches = [*shape.wetted(finer), *shape.dry(finer)]
        part = of_patches(patches, _inside(shape)).surface
        if len(part.triangles) * 2 ** len(shape.reflections) > HULL_TRIANGLES:
            return size
        size = finer

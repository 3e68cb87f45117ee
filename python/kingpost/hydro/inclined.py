"""Meshes of a hull that lists or trims: the closed hull is rotated, lifted and cut at the water plane."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from ..errors import HydrodynamicsError
from .attitude import Inclination, described, placed, settled
from .database import Attitude
from .hull_files import HullFile, file_panels
from .meshes import HullMeshes, closed, closed_panels
from .panels import under_water
from .surface import Surface, particulars

if TYPE_CHECKING:
    from .shapes import Shape

FINE_PANELS = 6000
"""Approximate number of submerged panels of the mesh that gives the attitude of a parametric hull."""
SAME_VOLUME = 0.01
"""Largest relative difference of a hull's displacement from that of the source of its attitude."""


def of_shape(shape: Shape, upright: HullMeshes, panels: int, asked: Inclination) -> HullMeshes:
    """A parametric hull in its attitude, with approximately the given number of panels.

    Raises
    ------
    HydrodynamicsError
        If it is dry, or its displacement differs from that of the source of its attitude.
    """
    size, fine = ((shape.wetted_area_m2 / count) ** 0.5 for count in (panels, FINE_PANELS))
    volume = upright.particulars.volume_m3
    hull = closed(shape, fine, volume)
    attitude, wetted, remarks = _afloat(hull, upright, asked)
    kept = _kept(upright.reflections, attitude)
    lost = [axis for axis in shape.reflections if axis not in kept]
    part = under_water(placed(closed_panels(shape, size, volume, lost), attitude))
    return replace(
        upright, reflections=kept, panels=part, particulars=particulars(wetted), attitude=attitude,
        upright=upright, attitude_source=asked.source, remarks=remarks,
    )  # fmt: skip


def of_file(file: HullFile, upright: HullMeshes, panels: int, asked: Inclination) -> HullMeshes:
    """The hull of a mesh file in its attitude, with approximately the given number of panels or more.

    Raises
    ------
    HydrodynamicsError
        As for `of_shape`, and if the mesh ends at the water line: the newly submerged part is unknown.
    """
    hull = file.placed()
    if not file.check(hull):
        found = "a mesh that ends at the water line, to be inclined"
        allowed = "a closed hull with its deck, or none of --heel-deg, --trim-deg, --attitude-of"
        raise HydrodynamicsError("hull", found, allowed, str(file.path))
    attitude, wetted, remarks = _afloat(hull, upright, asked)
    kept, part = file_panels(wetted, panels, _kept((0, 1), attitude))
    return replace(
        upright, reflections=kept, panels=part, particulars=particulars(wetted), attitude=attitude,
        upright=upright, attitude_source=asked.source, remarks=remarks,
    )  # fmt: skip


def _kept(reflections: tuple[int, ...], attitude: Attitude) -> tuple[int, ...]:
    """Remaining planes of symmetry: heel removes y = 0, trim removes x = 0."""
    turned = {0: attitude.pitch_rad, 1: attitude.roll_rad}
    return tuple(axis for axis in reflections if turned[axis] == 0)


def _afloat(
    hull: Surface, upright: HullMeshes, asked: Inclination
) -> tuple[Attitude, Surface, tuple[str, ...]]:
    """Attitude of a closed hull, its submerged part, and notes about it."""
    attitude = settled(hull, asked, upright.particulars.volume_m3)
    stands = Surface(placed(hull.vertices, attitude), hull.triangles)
    wetted = stands.below()
    if len(wetted.triangles) == 0:
        found = f"{described(attitude)}: a hull that is dry"
        raise HydrodynamicsError("--attitude-of", found, "a hull that floats")
    if asked.displaced_m3 is not None:
        _check_displaced(asked, particulars(wetted).volume_m3)
    return attitude, wetted, (*asked.remarks, *_remarks(hull, stands))


def _check_displaced(asked: Inclination, found_m3: float) -> None:
    if abs(found_m3 - asked.displaced_m3) > SAME_VOLUME * asked.displaced_m3:
        raise HydrodynamicsError(
            "--attitude-of",
            f"a hull that displaces {asked.displaced_m3:.6g} m3 {asked.source}",
            f"the displacement of this hull there, {found_m3:.6g} m3, to {SAME_VOLUME:.0%}",
        )


def _remarks(hull: Surface, stands: Surface) -> tuple[str, ...]:
    """Note for a hull whose deck is immersed or whose bottom emerges."""
    before, z = hull.vertices[:, 2], stands.vertices[:, 2]
    near = 1e-6 * np.ptp(hull.vertices, axis=0).max()
    found = []
    if (z[before > before.max() - near] < -near).any():
        found.append("the highest part of the hull, its deck, is partly under water")
    if (z[before < before.min() + near] > near).any():
        found.append("the bottom is partly out of the water")
    return tuple(f"{what}: linear coefficients are those of small motions about that" for what in found)

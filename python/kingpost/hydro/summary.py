"""Summary of a hull that `kingpost hydro` prints before the computation."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .attitude import described

if TYPE_CHECKING:
    from .database import Water
    from .meshes import HullMeshes


def summary(hull: HullMeshes, water: Water) -> str:
    """Particulars of the upright hull, its attitude if inclined, and its panels."""
    upright = hull.upright or hull
    found, plane = upright.particulars, upright.particulars.waterplane
    x, y = plane.first_moments_m3 / plane.area_m2
    transverse = plane.second_moments_m4[2] - y**2 * plane.area_m2
    longitudinal = plane.second_moments_m4[0] - x**2 * plane.area_m2
    heights = [moment / found.volume_m3 for moment in (transverse, longitudinal)]
    planes = {(): "none", (1,): "y = 0", (0,): "x = 0", (0, 1): "x = 0 and y = 0"}[hull.reflections]
    rows = [
        ("hull", hull.source),
        ("length, beam", f"{found.length_m:.4g} m, {found.beam_m:.4g} m"),
        ("draught", f"{found.draught_m:.4g} m"),
        ("volume", f"{found.volume_m3:.6g} m3, {found.volume_m3 * water.density_kg_m3 / 1000:.6g} t"),
        ("block coefficient", f"{found.block_coefficient:.4f}"),
        ("centre of buoyancy", _centre(upright)),
        ("waterplane", f"{plane.area_m2:.6g} m2"),
        ("BM", f"{heights[0]:.4g} m transverse, {heights[1]:.4g} m longitudinal"),
        *(() if hull.attitude is None else _inclined(hull)),
        ("panels", f"{hull.panel_count} of about {hull.panel_size_m:.3g} m; planes of symmetry: {planes}"),
    ]
    lines = [f"{name:<20}{value}" for name, value in rows]
    if hull.hull is None:
        lines.append(
            f"warning: the database gets no hull mesh, because {hull.why_no_hull}; without it there are no "
            "righting arms, no hydrostatics or wave pressure of the mesh, and no hull in the app's picture"
        )
    return "\n".join(lines)


def _inclined(hull: HullMeshes) -> list[tuple[str, str]]:
    """Attitude in level axes, and the submerged part."""
    found = hull.particulars
    # No minus sign before a zero.
    change = round(found.volume_m3 / hull.upright.particulars.volume_m3 - 1, 6) + 0.0
    return [
        ("attitude", described(hull.attitude)),
        ("  wetted volume", f"{found.volume_m3:.6g} m3, {change:+.2%} of the upright hull's"),
        ("  deepest point", f"{found.draught_m:.4g} m under the water"),
        ("  buoyancy acts at", f"{_centre(hull)}, level axes"),
        ("  waterplane", f"{found.waterplane.area_m2:.6g} m2"),
    ]


def _centre(hull: HullMeshes) -> str:
    centre = hull.particulars.centre_of_buoyancy_m.round(9)
    return ", ".join(f"{value + 0.0:.4g}" for value in centre) + " m"

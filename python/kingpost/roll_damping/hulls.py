"""Sections of a hull from any kind of input."""

from __future__ import annotations

import os
from pathlib import Path

from ..errors import RollDampingError
from ..hydro.database_file import ENDING, read
from ..hydro.hull_files import HullFile
from ..hydro.hull_options import SHAPES, parse_shape
from ..hydro.meshes import parametric, whole
from ..hydro.surface import Surface
from .cutting import STATIONS, cut
from .sections import Sections

PANELS = 6000
"""Approximate number of panels of a parametric hull that is cut into sections."""


def sections_of(hull: str | Path, draught_m: float | None = None, stations: int = STATIONS) -> Sections:
    """Sections of a hull: a table, a hydrodynamic database, a mesh file or a parametric hull.

    Parameters
    ----------
    hull
        A CSV file of sections (`Sections.read`), a database ``NAME.hydro.json`` that has a hull mesh, a mesh
        file as `kingpost hydro` reads it, or a parametric hull such as
        ``box:length_m=20,beam_m=10,draught_m=2,depth_m=5``.
    draught_m
        Draught of a mesh file's hull; default: the water plane is z = 0.
    stations
        Number of sections into which a mesh is cut.

    Raises
    ------
    RollDampingError
        If a table is wrong, or a database has no mesh.
    HydrodynamicsError
        If the hull is wrong.

    >>> found = sections_of("box:length_m=20,beam_m=10,draught_m=2,depth_m=5", stations=5)
    >>> round(found.volume_m3, 6), round(found.midship_coefficient, 9)
    (400.0, 1.0)
    """
    path, text = Path(hull), str(hull)
    if path.suffix.lower() != ".csv" and os.path.isfile(path) and not path.name.endswith(ENDING):
        meshes = HullFile(path, draught_m).meshes(PANELS)
        return cut(whole(meshes.panels.surface, meshes.reflections), stations)
    if draught_m is not None:
        raise RollDampingError("draught_m", text, "a mesh file; other hulls have their own draught")
    if path.suffix.lower() == ".csv":
        return Sections.read(path)
    if path.name.endswith(ENDING):
        known = read(path).hull
        if known.mesh is None:
            raise RollDampingError("hull.mesh", "none", "a database with its hull's mesh, or the mesh", text)
        found = cut(Surface(known.mesh.vertices_m, known.mesh.triangles), stations)
        return found.with_draught(known.draught_m)
    if text.partition(":")[0] not in SHAPES:
        allowed = f"a table .csv, a database {ENDING}, a mesh file, or one of {', '.join(SHAPES)}"
        raise RollDampingError("hull", "no such file", allowed, text)
    meshes = parametric(parse_shape(text), text, PANELS)
    found = cut(whole(meshes.panels.surface, meshes.reflections), stations)
    return found.with_draught(meshes.particulars.draught_m)

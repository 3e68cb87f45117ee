"""Meshes of hulls: formats of meshio, and WAMIT's GDF."""

from __future__ import annotations

import contextlib
import io
import random
import tempfile
from functools import cache
from pathlib import Path

from kingpost.hydro.hull_files import HullFile
from kingpost.roll_damping.hulls import sections_of

from ..contract import Case
from ..mutations import TEXT_WAYS, damaged, damaged_bytes, encoded
from .netcdf import quick_probe

# A closed box of 20 x 10 x 5 m, 2 m deep.
POINTS = [(x, y, z) for x in (-10.0, 10.0) for y in (-5.0, 5.0) for z in (-2.0, 3.0)]
QUADS = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
TRIANGLES = [(a, b, c) for p, q, r, s in QUADS for a, b, c in ((p, q, r), (p, r, s))]
WRITTEN = {".stl": False, ".obj": False, ".ply": False, ".off": False, ".vtk": False, ".msh": False,
".mesh": False,
           ".inp": False, ".nas": False, ".vtu": False, ".su2": False, ".ugrid": False, ".avs": False,
           ".tec": False,
           ".f3grid": False, ".xml": False, ".wkt": False}  # fmt: skip
"""Tried endings; those that meshio cannot write are left out."""


@cache
def samples() -> dict[str, bytes]:
    """One file for each format, as text where there is such a form; GDF; binary STL."""
    import meshio

    found = {".gdf": _gdf().encode(), "binary.stl": b"", "by_hand.obj": _obj().encode()}
    mesh = meshio.Mesh(POINTS, [("triangle", TRIANGLES)])
    with tempfile.TemporaryDirectory() as folder:
        for ending in WRITTEN:
            path = Path(folder) / f"hull{ending}"
            for settings in ({"binary": False}, {}):
                with contextlib.suppress(Exception, SystemExit), contextlib.redirect_stdout(io.StringIO()):
                    mesh.write(path, **settings)
                    found[ending] = path.read_bytes()
                    break
        path = Path(folder) / "binary.stl"
        mesh.write(path, binary=True)
        found["binary.stl"] = path.read_bytes()
    return found


def _gdf() -> str:
    corners = [" ".join(f"{x:g}" for corner in quad for x in POINTS[corner]) for quad in QUADS]
    return "\n".join(["A box", "1 9.80665 ULEN GRAV", "0 0 ISX ISY", "6", *corners, ""])


def _obj() -> str:
    points = [f"v {x:g} {y:g} {z:g}" for x, y, z in POINTS]
    faces = [f"f {' '.join(f'{k + 1}//1' for k in quad)}" for quad in QUADS]
    return "\n".join(["# hull", "o hull", *points, "vn 0 0 1", "usemtl x", *faces, ""])


def drawn(draw: random.Random) -> Case:
    """Draw a wrong mesh, rarely with another ending."""
    likely = [".gdf", ".gdf", ".stl", ".stl", ".obj", "by_hand.obj", "binary.stl"]
    name = draw.choice(likely if draw.random() < 0.7 else sorted(samples()))
    content = samples()[name]
    try:
        text = content.decode()
    except UnicodeDecodeError:
        changed = damaged_bytes(draw, content)
    else:
        in_bytes = draw.random() < 0.1
        changed = damaged_bytes(draw, content) if in_bytes else encoded(draw, damaged(draw, text, TEXT_WAYS))
    ending = draw.choice(sorted(samples())) if draw.random() < 0.02 else name
    how = draw.choices(["panels", "draught", "sections"], [8, 1, 1])[0]
    return Case("meshes", {f"hull{Path(ending).suffix or ending}": changed}, (how,))


def use(case: Case, folder: Path) -> str:
    """Make panels, or sections for roll damping."""
    (name,) = case.files
    if case.arguments[0] == "sections":
        with quick_probe():
            sections_of(str(folder / name), None, 12)
        return "taken"
    with quick_probe():
        HullFile(folder / name, 2.0 if case.arguments[0] == "draught" else None).meshes(60)
    return "taken"

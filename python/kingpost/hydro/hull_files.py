"""Hulls from mesh files: STL, OBJ, other formats of meshio, and WAMIT's GDF."""

from __future__ import annotations

import contextlib
import io
import os
from collections.abc import Callable, Container
from dataclasses import dataclass
from itertools import takewhile
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ..errors import HydrodynamicsError, shortened
from ..output import irregular
from ..reading import text_of
from ..results.files import is_whole
from . import obj
from .database import Mesh
from .meshes import HullMeshes, whole
from .panels import Panels, of_triangles
from .stitching import stitched
from .surface import (
    LARGEST_M,
    SMALLEST_M,
    Particulars,
    Surface,
    check_closed,
    check_outward,
    open_edges,
    particulars,
)

if TYPE_CHECKING:
    from numpy.typing import NDArray

FARTHEST_M = 1e9
"""Largest distance of a point from the origin, m: enough for map coordinates."""
LARGEST_HULL = 2000
"""The most triangles of a hull mesh in a database."""
METRIC_GRAVITY = (9.7, 9.9)
"""Range of GRAV in a file in metres, m/s2; in feet it is 32.2."""
READ_TO_THEIR_END = (".stl",)
"""Formats whose readers terminate on any file; other formats are first read in a separate process."""
PACKED = (".gz", ".zip", ".bz2", ".xz", ".7z", ".zst")
MESH_TIME_LIMIT_S = 30.0
"""Time limit for reading a mesh in the separate process, s."""
INSTALL = 'pip install "meshio>=5.3"'


@dataclass(frozen=True)
class HullFile:
    """A mesh file, with the draught and the orientation of its normals.

    Attributes
    ----------
    path
        Path of the file; its frame: metres, x forward, y to port, z up.
    draught_m
        Depth of the lowest point under the water plane; `None`: z = 0 is the water plane.
    flip_normals
        Reverse all normals first.
    """

    path: Path
    draught_m: float | None = None
    flip_normals: bool = False

    def meshes(self, panels: int) -> HullMeshes:
        """Checked panels, particulars and closed hull, with approximately the given number of panels or
        more."""
        surface = self.placed()
        closed = self.check(surface)
        wetted = surface.below()
        found = particulars(wetted)
        reflections, fine = file_panels(wetted, panels, (0, 1))
        why_not = _too_large(len(surface.triangles)) if closed else "the mesh ends at the water line"
        mesh = None if why_not else Mesh(surface.vertices, surface.triangles)
        remarks = (*_joined(self.path, surface), *_across(found))
        return HullMeshes(self.path.name, reflections, fine, found, mesh, why_not, remarks=remarks)

    def placed(self) -> Surface:
        """The file's surface shifted to its draught, with z = 0 on the water plane."""
        surface = read(self.path)
        if self.flip_normals:
            surface = Surface(surface.vertices, surface.triangles[:, ::-1])
        if self.draught_m is None:
            return surface
        if not self.draught_m > 0:
            raise HydrodynamicsError("draught_m", f"{self.draught_m:g}", "a number greater than 0")
        lifted = surface.vertices - [0, 0, surface.vertices[:, 2].min() + self.draught_m]
        return Surface(lifted, surface.triangles)

    def check(self, surface: Surface) -> bool:
        """Refuse a surface that cannot be solved; return whether the hull is closed, deck included."""
        file = str(self.path)
        lowest, highest = surface.vertices[:, 2].min(), surface.vertices[:, 2].max()
        extent = float(np.ptp(surface.vertices, axis=0).max())
        tolerance = 1e-6 * extent
        if not SMALLEST_M <= extent <= LARGEST_M:
            allowed = (
                f"a mesh in metres, of {SMALLEST_M:g} to {LARGEST_M:g} m: scale it if it is in other units"
            )
            raise HydrodynamicsError("hull", f"a mesh of {extent:g} m", allowed, file)
        if lowest > -tolerance:
            raise HydrodynamicsError(
                "hull", f"a hull above the water, its lowest point at z = {lowest:.4g} m",
                "a hull that reaches below the water plane z = 0: give its draught with --draught-m", file,
            )  # fmt: skip
        edges = open_edges(surface)
        at_water = np.abs(surface.vertices[edges, 2]).max(initial=0.0) < tolerance
        if len(edges) and at_water and highest < tolerance:
            check_outward(surface, particulars(surface).volume_m3, file)
            return False
        check_closed(surface, file)
        if highest < tolerance:
            raise HydrodynamicsError(
                "hull", f"a hull that cannot float: all of it is under water, its top at z = {highest:.4g} m",
                f"a draught less than its depth of {highest - lowest:.4g} m, set with --draught-m", file,
            )  # fmt: skip
        return True


def file_panels(wetted: Surface, panels: int, axes: tuple[int, ...]) -> tuple[tuple[int, ...], Panels]:
    """The axes along which a wetted hull is symmetric, and the panels of the part to mirror."""
    reflections = tuple(axis for axis in axes if _symmetric(wetted, axis))
    part = wetted
    for axis in reflections:
        part = part.mirrored(axis).below(0.0, axis).mirrored(axis)
    # Side of triangles with approximately the wanted area.
    return reflections, of_triangles(part.refined(2 * (wetted.area / panels) ** 0.5))


def _too_large(triangles: int) -> str:
    if triangles <= LARGEST_HULL:
        return ""
    return f"the mesh has {triangles} triangles, more than {LARGEST_HULL}: decimate it for one"


def read(path: Path) -> Surface:
    """Triangles of a mesh file; equal points are merged, and panels that do not meet edge to edge are joined.

    Raises
    ------
    HydrodynamicsError
        If the file cannot be read or holds no surface.
    """
    return stitched(_as_written(path))


def _joined(path: Path, surface: Surface) -> tuple[str, ...]:
    """Return a note if panels were joined."""
    written = _as_written(path)
    joined = len(open_edges(written)) - len(open_edges(surface))
    if not joined:
        return ()
    return (f"{joined} open edges joined, of panels that do not meet edge to edge in {path.name}",)


def _across(found: Particulars) -> tuple[str, ...]:
    """Return a note if the hull is wider than long."""
    if found.beam_m <= found.length_m:
        return ()
    return (
        f"the hull is {found.length_m:.4g} m long and {found.beam_m:.4g} m wide: x must point to the bow; "
        "turn the mesh by 90 degrees about z if its bow is along y, else head seas are beam seas",
    )


def _as_written(path: Path) -> Surface:
    if not os.path.isfile(path):
        found = irregular(path) or "no such file"
        raise HydrodynamicsError("hull", found, "a mesh file or a parametric hull", str(path))
    surface = _READERS.get(path.suffix.lower(), _read_meshio)(path)
    if len(surface.triangles) == 0:
        raise HydrodynamicsError("hull", "no triangles and no quadrangles", "a surface mesh", str(path))
    wrong = surface.triangles[(surface.triangles < 0) | (surface.triangles >= len(surface.vertices))]
    if wrong.size:
        raise HydrodynamicsError(
            "hull", "a face with a point that is not in the file",
            f"faces of the {len(surface.vertices)} points that it lists", str(path),
        )  # fmt: skip
    _check_size(surface.vertices[np.unique(surface.triangles)], path)
    joined = surface.welded()
    if len(joined.triangles) == 0:
        raise HydrodynamicsError("hull", "faces without an area only", "a surface mesh", str(path))
    return joined


def _check_size(points: NDArray[np.float64], path: Path) -> None:
    """Refuse points that are not finite, or too far from the origin."""
    if not np.isfinite(points).all():
        raise HydrodynamicsError("hull", "a point that is not finite", "finite coordinates", str(path))
    if np.abs(points).max(initial=0.0) > FARTHEST_M:
        found = f"a point {np.abs(points).max():.3g} m from the origin"
        raise HydrodynamicsError("hull", found, f"points within {FARTHEST_M:g} m", str(path))


def _read_meshio(path: Path) -> Surface:
    try:
        import meshio
    except ImportError:
        raise HydrodynamicsError("meshio", "no such package", f"`{INSTALL}`, which installs it") from None
    _check_ending(path, meshio.extension_to_filetypes)
    if path.suffix.lower() not in READ_TO_THEIR_END and not is_whole(path, MESH_TIME_LIMIT_S):
        allowed = "STL, OBJ, GDF or another format that meshio reads, whole"
        raise HydrodynamicsError("hull", "a file that cannot be read to its end", allowed, str(path))
    try:
        # meshio prints some errors and exits.
        silent = contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO())
        with silent[0], silent[1], np.errstate(all="ignore"):
            found = meshio.read(path)
            cells = [found.get_cells_type(name) for name in ("triangle", "quad")]
            points = np.asarray(found.points, float)
            faces = [_halved(np.asarray(some)) for some in cells if len(some)]
    except (Exception, SystemExit) as error:
        reason = shortened(str(error).strip()) or type(error).__name__
        allowed = "STL, OBJ, GDF or another format that meshio reads"
        raise HydrodynamicsError(
            "hull", f"a file that cannot be read ({reason})", allowed, str(path)
        ) from None
    if not faces or points.ndim != 2 or points.shape[1] != 3:
        return Surface(np.zeros((0, 3)), np.zeros((0, 3), dtype=np.int64))
    return Surface(points, np.concatenate(faces))


def _check_ending(path: Path, known: Container[str]) -> None:
    """Refuse a file whose ending is that of a packed file or of an unsupported format."""
    ending = path.suffix.lower()
    if ending in PACKED:
        raise HydrodynamicsError(
            "hull", f"a packed file ({ending})", "the mesh itself: unpack it first", str(path)
        )
    if ending not in known:
        found = f"the format {ending}" if ending else "a name without an ending"
        allowed = "STL, OBJ, GDF or another format that meshio reads: convert it to one of them"
        raise HydrodynamicsError("hull", found, allowed, str(path))


def _halved(cells: NDArray[np.int64]) -> NDArray[np.int64]:
    """Cut quadrangles into two triangles each."""
    if cells.shape[1] == 3:
        return cells.astype(np.int64)
    return np.concatenate([cells[:, [0, 1, 2]], cells[:, [0, 2, 3]]]).astype(np.int64)


def _read_gdf(path: Path) -> Surface:
    """WAMIT's low-order geometry: title, ULEN and GRAV, ISX and ISY, number of panels, corners of each.

    Its panels are counter-clockwise seen from the water (WAMIT User Manual, version 7, chapter 6); ISX
    and ISY of 1 mean that x = 0 and y = 0 are planes of symmetry, and -1 means a wall there. Corners are in
    the length unit of GRAV, the acceleration of gravity, independent of ULEN.
    """
    lines = text_of(path, errors="replace").splitlines()[1:]
    allowed = "WAMIT's GDF: a title, ULEN GRAV, ISX ISY, the number of panels, twelve coordinates each"
    words = [line.split() for line in lines]
    try:
        gravity = float(words[0][1])
        symmetric = int(words[1][0]), int(words[1][1])
        count = int(words[2][0])
    except (ValueError, IndexError, OverflowError):
        raise HydrodynamicsError(
            "hull", "a file of another format or cut short", allowed, str(path)
        ) from None
    if len(words[2]) > 1 and _is_number(words[2][1]) and float(words[2][1]) != 0:
        found = f"a high-order geometry, of patches (IGDEF {words[2][1]})"
        raise HydrodynamicsError("hull", found, "a low-order one, of panels", str(path))
    numbers = list(takewhile(_is_number, (word for line in words[3:] for word in line)))
    if count < 0 or len(numbers) != 12 * count:
        found = f"{count} panels by the header, {len(numbers) / 12:.4g} in the file"
        raise HydrodynamicsError(
            "hull", found, "as many as the header has, each of twelve coordinates", str(path)
        )
    quads = np.array(numbers, dtype=float).reshape(count, 4, 3)
    if not METRIC_GRAVITY[0] <= gravity <= METRIC_GRAVITY[1]:
        found = f"GRAV {gravity:g}, a mesh that is not in metres" if gravity > 0 else f"GRAV {gravity:g}"
        allowed = "GRAV from {:g} to {:g} m/s2: scale corners, ULEN and GRAV to metres".format(
            *METRIC_GRAVITY
        )
        raise HydrodynamicsError("hull", found, allowed, str(path))
    for name, value in zip(("ISX", "ISY"), symmetric, strict=True):
        if value not in (0, 1):
            found = f"{name} {value}" + (", a wall along that plane" if value == -1 else "")
            raise HydrodynamicsError("hull", found, f"{name} 0, or 1 for a plane of symmetry", str(path))
    _check_size(quads.reshape(-1, 3), path)
    corners = np.arange(4 * count).reshape(count, 4)
    part = Surface(quads.reshape(-1, 3), _halved(corners))
    return whole(part.welded(), tuple(axis for axis in (0, 1) if symmetric[axis]))


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True


_READERS: dict[str, Callable[[Path], Surface]] = {".gdf": _read_gdf, ".obj": obj.read}


def _symmetric(surface: Surface, axis: int) -> bool:
    """Whether the mirror image of a surface has the same triangles."""
    return np.array_equal(_triangle_keys(surface), _triangle_keys(surface.mirrored(axis)))


def _triangle_keys(surface: Surface) -> NDArray[np.int64]:
    size = np.ptp(surface.vertices, axis=0).max()
    values = np.concatenate([surface.corners.mean(axis=1) / size, surface.area_vectors / size**2], axis=1)
    keys = np.round(values * 1e5).astype(np.int64)
    return keys[np.lexsort(keys.T)]

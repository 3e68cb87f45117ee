"""Wavefront OBJ: the points and faces of a mesh, as drawing programs write them.

Source: the OBJ format of Wavefront's Advanced Visualizer, appendix B1. Texture points, normals, colours after
the coordinates, groups and materials are ignored; each face may have any number of corners.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ..errors import HydrodynamicsError
from .surface import Surface

if TYPE_CHECKING:
    from numpy.typing import NDArray

CONCAVE = 1e-6
"""Limit of a concave corner as a share of its face's area; smaller ones are rounding."""


def read(path: Path) -> Surface:
    """Read the surface of an OBJ file; a face of more than three corners becomes a fan of triangles.

    Raises
    ------
    HydrodynamicsError
        If a line of a point or face is malformed, or a face is concave or refers to a missing point.
    """
    points: list[list[float]] = []
    faces: list[tuple[int, list[int]]] = []
    for number, words in _lines(path):
        try:
            if words[0] == "v":
                points.append([float(word) for word in words[1:4]])
            elif words[0] == "f":
                faces.append((number, [_place(word, len(points)) for word in words[1:]]))
        except (ValueError, IndexError):
            raise _wrong(
                path, number, f"{' '.join(words)[:60]!r}", "v x y z, or f with points as 1 or 1/2/3"
            ) from None
        if words[0] == "v" and len(points[-1]) < 3:
            raise _wrong(path, number, f"a point of {len(points[-1])} coordinates", "x y z")
    at = np.array(points, float).reshape(-1, 3)
    triangles = [corner for number, face in faces for corner in _fan(path, number, face, at)]
    return Surface(at, np.array(triangles, dtype=np.int64).reshape(-1, 3))


def _lines(path: Path) -> Iterator[tuple[int, list[str]]]:
    """Yield the words of each line with its number; a backslash continues a line on the next."""
    kept: list[str] = []
    with path.open(encoding="utf-8", errors="replace") as file:
        for number, line in enumerate(file, 1):
            text = line.split("#", 1)[0].rstrip()
            kept += text.removesuffix("\\").split()
            if kept and not text.endswith("\\"):
                yield number, kept
                kept = []


def _place(word: str, count: int) -> int:
    """The index of a point, counted from 0; negative ones count back from the last point so far."""
    index = int(word.split("/", 1)[0])
    return index - 1 if index > 0 else count + index


def _fan(path: Path, number: int, face: list[int], points: NDArray[np.float64]) -> list[tuple[int, int, int]]:
    if len(face) < 3:
        raise _wrong(path, number, f"a face of {len(face)} corners", "three or more")
    if min(face) < 0 or max(face) >= len(points):
        raise _wrong(path, number, "a face with a point that is not in the file", f"1 to {len(points)}")
    if not np.isfinite(points[face]).all():
        raise _wrong(path, number, "a point that is not finite", "finite coordinates")
    triangles = [(face[0], face[k], face[k + 1]) for k in range(1, len(face) - 1)]
    if len(triangles) > 1:
        a, b, c = np.moveaxis(points[np.array(triangles)], 1, 0)
        # Points so far away that products overflow are refused later, with the whole mesh.
        with np.errstate(over="ignore", invalid="ignore"):
            areas = np.cross(b - a, c - a)
            whole = areas.sum(axis=0)
            is_concave = (areas @ whole < -CONCAVE * (whole @ whole)).any()
        if is_concave:
            raise _wrong(
                path, number, f"a concave face of {len(face)} corners", "convex faces: triangulate the mesh"
            )
    return triangles


def _wrong(path: Path, number: int, found: str, allowed: str) -> HydrodynamicsError:
    return HydrodynamicsError("hull", found, allowed, f"{path}:{number}")

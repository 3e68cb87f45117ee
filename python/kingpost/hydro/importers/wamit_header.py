"""Header of WAMIT's STEM.out and STEM.mmx, and a hull's size from STEM.gdf.

Versions 6 and 7 write gravity, ULEN, depth and usually density, XBODY, volumes, centres of buoyancy and
gravity about XBODY, planes of symmetry; of several bodies the first is taken.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ...reading import text_of
from .foreign import reading_error

if TYPE_CHECKING:
    from numpy.typing import NDArray

_NUMBER = r"([-+]?\d*\.?\d+(?:[EeDd][-+]?\d+)?)"
_SYMMETRY = {"Y=0": "port_starboard", "X=0,Y=0": "both_planes"}
# The header ends where the first results begin.
_END = "Output from  WAMIT"


@dataclass(frozen=True)
class Header:
    """Values in SI units; `None` if missing."""

    gravity: float | None = None
    length_scale: float | None = None
    density: float | None = None
    depth: float | None = None
    reference: NDArray[np.float64] | None = None
    volume: float | None = None
    buoyancy: NDArray[np.float64] | None = None
    gravity_centre: NDArray[np.float64] | None = None
    symmetry: str | None = None
    restoring: NDArray[np.float64] | None = None


def beside(stem: Path) -> Header:
    """The header of STEM.out, otherwise that of STEM.mmx, otherwise an empty one."""
    for ending in (".out", ".mmx", ".OUT", ".MMX"):
        path = stem.with_suffix(ending)
        if path.is_file():
            return read(path)
    return Header()


def read(path: Path) -> Header:
    """Read the header of a file.

    Raises
    ------
    HydrodynamicsError
        If a body is rotated about the vertical: its forces are then in its own axes.
    """
    lines = []
    with open(path, encoding="latin-1") as file:
        for line in file:
            if _END in line or "Wave period" in line:
                break
            lines.append(line)
    text = "".join(lines)
    turned = _numbers(text, r"PHIBODY\s*=\s*" + _NUMBER)
    if turned is not None and turned[0] != 0.0:
        raise reading_error(f"PHIBODY {turned[0]:g}", "0: the body's axes are those of the waves", str(path))
    reference = _numbers(text, rf"XBODY\s*=\s*{_NUMBER}\s*YBODY\s*=\s*{_NUMBER}\s*ZBODY\s*=\s*{_NUMBER}")
    volumes = _numbers(text, rf"\(VOLX,VOLY,VOLZ\):\s*{_NUMBER}\s+{_NUMBER}\s+{_NUMBER}")
    depth = _numbers(text, r"Water depth:\s*" + _NUMBER)
    symmetry = re.search(r"Symmetr(?:y|ies):\s*([XY]=0(?:,\s*[XY]=0)?)", text)
    about = np.zeros(3) if reference is None else reference
    return Header(
        gravity=_single(text, r"Gravity:\s*"),
        length_scale=_single(text, r"Length scale:\s*"),
        density=_single(text, r"Water density:\s*"),
        depth=np.inf
        if "Water depth:        infinite" in text
        else None
        if depth is None
        else float(depth[0]),
        reference=reference,
        # Take the middle of three volumes, like WAMIT itself.
        volume=None if volumes is None else float(np.median(volumes)),
        buoyancy=_centre(text, r"Center of Buoyancy", about),
        gravity_centre=_gravity_centre(text, about),
        symmetry=None if symmetry is None else _SYMMETRY.get(symmetry[1].replace(" ", "")),
        restoring=_restoring(text),
    )


def _numbers(text: str, pattern: str) -> NDArray[np.float64] | None:
    found = re.search(pattern, text)
    return None if found is None else np.array([float(word.replace("D", "E")) for word in found.groups()])


def _single(text: str, name: str) -> float | None:
    found = _numbers(text, name + _NUMBER)
    return None if found is None else float(found[0])


def _centre(text: str, name: str, about: NDArray[np.float64]) -> NDArray[np.float64] | None:
    found = _numbers(text, rf"{name}\s*:?\s*\([^)]*\)\s*:?\s*{_NUMBER}\s+{_NUMBER}\s+{_NUMBER}")
    return None if found is None else found + about


def _gravity_centre(text: str, about: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """All three coordinates, or only the height for a freely floating hull: it is then vertically above the
    centre of buoyancy."""
    whole = _centre(text, r"Center of Gravity", about)
    height, buoyancy = (
        _single(text, r"Center of Gravity\s*\([^)]*\)\s*:?\s*"),
        _centre(text, "Center of Buoyancy", about),
    )
    if whole is not None or height is None or buoyancy is None:
        return whole
    return np.array([*buoyancy[:2], height + about[2]])


def _restoring(text: str) -> NDArray[np.float64] | None:
    """C' of the header with five digits; the numeric file has more."""
    found = np.zeros((6, 6))
    for label, places in (
        (r"C\(3,3\),C\(3,4\),C\(3,5\):", ((2, 2), (2, 3), (2, 4))),
        (r"C\(4,4\),C\(4,5\),C\(4,6\):", ((3, 3), (3, 4), (3, 5))),
        (r"C\(5,5\),C\(5,6\):", ((4, 4), (4, 5))),
    ):
        values = _numbers(text, label + rf"\s*{_NUMBER}" + rf"\.?\s+{_NUMBER}" * (len(places) - 1))
        if values is None:
            return None
        for (i, j), value in zip(places, values, strict=True):
            found[i, j] = value
            if j < 5:
                found[j, i] = value
    return found


def size(stem: Path, reference: NDArray[np.float64] | None) -> tuple[float, float, float] | None:
    """Length and beam of the water line and the draught from a low-order STEM.gdf or STEM_low.gdf, m."""
    names = [stem.name + ending for ending in (".gdf", ".GDF", "_low.gdf")]
    found = (_extents(stem.with_name(name), reference) for name in names if stem.with_name(name).is_file())
    return next((extents for extents in found if extents is not None), None)


def _extents(path: Path, reference: NDArray[np.float64] | None) -> tuple[float, float, float] | None:
    lines = text_of(path, "latin-1").splitlines()[1:]
    words = [line.split() for line in lines]
    try:
        symmetric = [int(float(word)) == 1 for word in words[1][:2]]
        count = int(words[2][0])
        flat = [float(word) for line in words[3:] for word in line][: 12 * count]
        points = np.array(flat).reshape(4 * count, 3)
    except (ValueError, IndexError):
        return None
    points = points + (0.0 if reference is None else reference)
    draught = -float(points[:, 2].min())
    at_water = points[points[:, 2] > -1e-3 * draught]
    if draught <= 0.0 or len(at_water) < 3:
        return None
    extents = [
        2.0 * np.abs(at_water[:, axis]).max() if symmetric[axis] else np.ptp(at_water[:, axis])
        for axis in (0, 1)
    ]
    return (*(float(extent) for extent in extents), draught)

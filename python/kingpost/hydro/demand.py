"""Estimate of the memory that a run of the panel method needs, made before the run.

The peak is that of one frequency: the matrices S and D of the solved part and of its influence on its mirror
images, 2 x 2^p matrices of n x n complex numbers for p planes of symmetry and n panels, factored in place
(`influence`). The estimate adds the present memory of the process, the waves of the problems, and the stored
results of all frequencies.
"""

from __future__ import annotations

import os
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from .far_field import ring_angles
from .panels import lid
from .symmetry import independent_directions

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from .database import Water
    from .meshes import HullMeshes

COMPLEX = 16
"""Bytes of a complex number."""
RESERVE = 60e6
"""Bytes that libraries load and reserve when the computation begins: measured."""
PER_PANEL = 4e3
"""Bytes of Capytaine's meshes and temporary arrays, for each panel of the whole hull: measured."""
COPIES = 5
"""Arrays of the size of all ring waves at the end of the run: rows, their sums for drift, and the file's."""
UNKNOWN = 300e6
"""Bytes of Python and its packages, if the system does not report them."""


@dataclass(frozen=True)
class Size:
    """Size of a run.

    Attributes
    ----------
    panels
        Panels to solve for, including those of a lid.
    lid_panels
        Panels of the lid.
    reflections
        Planes of symmetry.
    directions
        Number of wave directions to solve for.
    rings
        Number of angles of the ring waves.
    motions
        Six for each hull.
    """

    panels: int
    lid_panels: int
    reflections: int
    directions: int
    frequencies: int
    rings: int
    motions: int = 6

    @property
    def matrix_bytes(self) -> float:
        """Bytes of one matrix."""
        return float(COMPLEX * self.panels**2)


def size(
    hull: HullMeshes, with_lid: bool, water: Water, frequencies_rad_s: NDArray[np.float64], directions: int
) -> Size:
    """The size of a run of `solve.solve` with these settings."""
    lid_panels = len(lid(hull.panels, hull.panel_size_m).faces) if with_lid else 0
    return Size(
        panels=len(hull.panels.faces) + lid_panels,
        lid_panels=lid_panels,
        reflections=len(hull.reflections),
        directions=len(independent_directions(directions, hull.reflections)),
        frequencies=len(frequencies_rad_s),
        rings=ring_angles(hull, water, frequencies_rad_s, directions),
    )


def memory_bytes(run: Size) -> float:
    """Bytes that a run needs in addition to those of the process at its start.

    Two matrices of 1600 x 1600 complex numbers, and little else:

    >>> run = Size(1600, 0, 0, 12, 28, 240)
    >>> f"{run.matrix_bytes / 1e6:.0f} MB a matrix, {memory_bytes(run) / 1e6:.0f} MB in all"
    '41 MB a matrix, 161 MB in all'
    """
    images = 2**run.reflections
    whole, problems = run.panels * images, run.motions + run.directions
    # Potential, pressure and boundary condition of each problem, twice: once more for the ring waves.
    fields = 6 * COMPLEX * problems * whole
    kept = COPIES * COMPLEX * run.frequencies * problems * run.rings
    return RESERVE + 2 * images * run.matrix_bytes + fields + PER_PANEL * whole + kept


def process_bytes(run: Size) -> float:
    """Estimated peak memory of the whole process, bytes."""
    return max(peak_bytes(), resident_bytes() + memory_bytes(run))


def resident_bytes() -> float:
    """Present memory of this process, bytes; its peak if only that is known."""
    return _status("VmRSS") or peak_bytes()


def peak_bytes() -> float:
    """Peak memory of this process, bytes."""
    # On Linux getrusage also counts the memory of the parent process before exec.
    found = _status("VmHWM")
    if found is not None:
        return found
    try:
        import resource
    except ImportError:
        return UNKNOWN
    most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    # macOS counts bytes, others kibibytes.
    return float(most if sys.platform == "darwin" else most * 1024)


def _status(name: str) -> float | None:
    """Bytes from a line of Linux's process status, such as ``VmRSS:   1024 kB``."""
    try:
        lines = Path("/proc/self/status").read_text(encoding="ascii").splitlines()
    except (OSError, UnicodeDecodeError):
        return None
    values = [line.split()[1] for line in lines if line.startswith(f"{name}:")]
    return 1024.0 * float(values[0]) if values else None


def machine_bytes() -> float | None:
    """Memory of the machine, bytes, if it is known."""
    try:
        return float(os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE"))
    except (ValueError, OSError, AttributeError):
        return None

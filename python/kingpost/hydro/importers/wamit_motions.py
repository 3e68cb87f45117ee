"""Motions that WAMIT computed, STEM.4, compared with motions from the imported data.

(-w^2 (M + A) - i w (B + B_e) + C + C_e) xi = X per metre of amplitude, with the mass of STEM.frc: if both
agree, units, signs and phases were read correctly. The motions are those of that loading and are not
imported. STEM.frc has one of two forms (WAMIT User Manual, version 7, chapter 3): VCG and the radii of
gyration about XBODY, for a freely floating hull; or density, the centre of gravity and the matrices of mass,
damping and stiffness, each after 1 if it is present, 0 if it is absent.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ...errors import HydrodynamicsError
from ...reading import text_of
from .wamit_rows import of_six_motions, rows

if TYPE_CHECKING:
    from pathlib import Path

    from .foreign import Foreign

Responses: TypeAlias = tuple[NDArray[np.float64], NDArray[np.complex128]]
"""Directions, rad, and motions per metre of amplitude (frequency, direction, 6), of exp(-i w t)."""

WORTH_SAYING = 0.05
"""Differences of motions above this share of the largest are reported: WAMIT may compute motions with forces
from Haskind's relation and write those from diffraction; with large panels they differ by some percent."""


def notes(
    stem: Path, foreign: Foreign, density_kg_m3: float,
    responses: Callable[[NDArray[np.float64], str], Responses],
) -> list[str]:  # fmt: skip
    """Note on STEM.4; empty if it is missing or empty. It is only compared: an error in it does not refuse
    the other files.

    Parameters
    ----------
    responses
        Converts the file's rows and its name to responses in SI units.
    """
    four, said = stem.with_suffix(".4"), list(foreign.notes)
    if not four.is_file() or not four.stat().st_size:
        return []
    try:
        directions, motions = responses(of_six_motions(rows(four, (7,)), (2,), str(four), said), str(four))
    except HydrodynamicsError as error:
        return [f"{four.name} is not compared: found {error.found}, allowed: {error.allowed}"]
    theirs = foreign.directions_rad
    if directions.shape != theirs.shape or not np.allclose(directions, theirs):
        return [f"{four.name} is not compared: other headings than those of the wave forces"]
    reference = np.zeros(3) if foreign.reference_m is None else foreign.reference_m
    known = replace(foreign, density_kg_m3=density_kg_m3, reference_m=reference)
    said.append(note(four.name, motions, loading(stem.with_suffix(".frc"), known), known))
    return said[len(foreign.notes) :]


@dataclass(frozen=True)
class Loading:
    """Mass, added damping and added stiffness about XBODY, (6, 6)."""

    mass: NDArray[np.float64]
    damping: NDArray[np.float64]
    stiffness: NDArray[np.float64]


def loading(path: Path, foreign: Foreign) -> Loading | None:
    """Read the loading of STEM.frc; `None` if the file is missing or of another form."""
    if not path.is_file() or foreign.volume_m3 is None or foreign.centre_of_buoyancy_m is None:
        return None
    lines = [_numbers(line) for line in text_of(path, "latin-1").splitlines()[1:]]
    try:
        if len(lines[3]) == 3 and len(lines[1]) == 1:
            return _by_radii(lines, foreign)
        return _by_matrices(lines)
    except (IndexError, ValueError):
        return None


def _numbers(line: str) -> list[float]:
    """The numbers before the comment of a line."""
    found = []
    for word in line.replace(",", " ").split():
        try:
            found.append(float(word))
        except ValueError:
            break
    return found


def _by_radii(lines: list[list[float]], foreign: Foreign) -> Loading:
    mass = foreign.density_kg_m3 * foreign.volume_m3
    x, y = (foreign.centre_of_buoyancy_m - foreign.reference_m)[:2]
    radii = np.array([line[:3] for line in lines[2:5]])
    found = _about(mass, np.array([x, y, lines[1][0]]))
    found[3:, 3:] = mass * radii * np.abs(radii)
    return Loading(found, np.zeros((6, 6)), np.zeros((6, 6)))


def _about(mass: float, centre: NDArray[np.float64]) -> NDArray[np.float64]:
    x, y, z = centre
    found = np.diag([mass, mass, mass, 0.0, 0.0, 0.0])
    found[:3, 3:] = mass * np.array([[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]])
    found[3:, :3] = found[:3, 3:].T
    return found


def _by_matrices(lines: list[list[float]]) -> Loading:
    at, matrices = 3, []
    for _ in range(3):
        there = int(lines[at][0])
        at += 1
        matrices.append(np.array(lines[at : at + 6]) if there else np.zeros((6, 6)))
        at += 6 * there
    if any(matrix.shape != (6, 6) for matrix in matrices) or len(lines[2]) != 3:
        raise ValueError
    return Loading(*matrices)


def difference(motions: NDArray[np.complex128], weighed: Loading, foreign: Foreign) -> NDArray[np.float64]:
    """The largest difference of each motion from the given ones (frequency, direction, 6), over its largest;
    zero for negligible motions."""
    omega = foreign.frequencies_rad_s[:, None, None]
    impedance = (
        -(omega**2) * (weighed.mass + foreign.added_mass)
        - 1j * omega * (foreign.radiation_damping + weighed.damping)
        + foreign.restoring
        + weighed.stiffness
    )
    found = np.linalg.solve(impedance[:, None], foreign.excitation[..., None])[..., 0]
    largest = np.abs(motions).max(axis=(0, 1))
    moves = largest > 1e-4 * np.repeat([largest[:3].max(), largest[3:].max()], 3)
    return np.where(moves, np.abs(found - motions).max(axis=(0, 1)) / np.where(moves, largest, 1.0), 0.0)


def note(name: str, motions: NDArray[np.complex128], weighed: Loading | None, foreign: Foreign) -> str:
    """Note on a STEM.4 that was read."""
    if weighed is None or foreign.restoring is None or not foreign.restoring_includes_weight:
        return f"motions of {name} are not imported: they are for one loading, and no .frc file gives it"
    found = difference(motions, weighed, foreign)
    if found.max() <= WORTH_SAYING:
        return (
            f"motions of {name} are not imported; they agree with the imported data and the .frc file's "
            f"mass to {found.max():.2%} of the largest"
        )
    worst = ("surge", "sway", "heave", "roll", "pitch", "yaw")[int(found.argmax())]
    return (
        f"motions of {name} are not imported; they differ by {found.max():.1%} of the largest, in {worst}, "
        "from the imported data and the .frc file's mass: check --density-kg-m3, --reference-m, --time-sign"
    )

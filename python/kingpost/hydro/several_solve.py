"""The linear potential flow about several hulls together, by the panel method of Capytaine 3 (`solve`).

All hulls are one mesh with six rigid motions each. One frequency needs one pair of influence matrices, one
factorisation, and a right-hand side for each motion and each wave direction. The directions are those of
every hull's own grid: no direction is interpolated.

Between hulls, and in a narrow gap above all, added mass and damping change quickly near the frequencies at
which the water between them resonates. Frequencies are added where they do.
"""

from __future__ import annotations

import logging
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .airy import wave_number
from .partial import Partial, digest
from .several_mesh import Cluster, Member
from .solve import Flow, capytaine, capytaine_mesh, froude_krylov

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .database import Water

LOG = logging.getLogger(__name__)
QUICK_CHANGE = 0.2
"""A change of B or w A between neighbouring frequencies, over the peaks of its motions, that is followed by a
frequency between them. The fit of the memory is within a tenth of it."""
NARROWEST = 0.004
"""Smallest spacing of frequencies over their mean: a resonance damped by less than half of it is noise."""
MOST_ADDED = 60
"""The most frequencies that are added."""
TRIAL_PANELS, TRIAL_UNKNOWNS = 300, 500
"""Sizes of the trials for the estimate of the time: tenths of a second."""
SAME_ANGLE = 1e-9
"""Directions nearer than this are one, rad: rounding."""


@dataclass(frozen=True)
class SeveralCoefficients:
    """Results of the panel method: matrices as in `SeveralHulls`; forces (frequency, hull, direction, 6) in
    each hull's axes, directions and phase. `added_rad_s`: the frequencies that were added; `quick`: the
    largest change between neighbours that is left, and both frequencies, if it is quick."""

    frequencies_rad_s: NDArray[np.float64]
    added_mass: NDArray[np.float64]
    radiation_damping: NDArray[np.float64]
    added_mass_infinite: NDArray[np.float64]
    froude_krylov: NDArray[np.complex128]
    diffraction: NDArray[np.complex128]
    added_rad_s: tuple[float, ...]
    quick: tuple[float, float, float] | None
    solver: str


def solve_several(
    members: Sequence[Member],
    cluster: Cluster,
    water: Water,
    frequencies_rad_s: NDArray[np.float64],
    directions: int,
    refine: bool,
    update: Callable[[float], None] = lambda _done: None,
    partial: Partial | None = None,
) -> SeveralCoefficients:
    """Solve radiation and diffraction, one frequency at a time.

    Parameters
    ----------
    members, cluster
        The hulls, and their mesh.
    directions
        Number of wave directions on the circle.
    refine
        Add frequencies where the coefficients change quickly.
    update
        Called with the number of solved frequencies.
    partial
        Stores each solved frequency, and holds those of a stopped run.
    """
    module = capytaine()
    problem = ClusterFlow(module, cluster, water)
    angles, index = solved_directions(cluster.headings_rad, directions)
    partial = partial or Partial(None)
    partial.open(_settings(problem, cluster, directions))
    infinite = partial.kept("infinite", lambda: (problem.infinite(),))[0] * cluster.couplings
    update(1)
    rows: dict[float, tuple[NDArray, ...]] = {}

    def at(frequency: float) -> None:
        rows[frequency] = partial.kept(repr(frequency), lambda: problem.at(frequency, angles, index))
        LOG.info("%d frequencies solved: %g rad/s", len(rows), frequency)
        update(len(rows) + 1)

    for frequency in frequencies_rad_s.tolist():
        at(frequency)
    added: list[float] = []
    while refine and len(added) < MOST_ADDED and (between := _quickest(rows, infinite)) is not None:
        at(between)
        added.append(between)
    every = sorted(rows)
    added_mass, damping, forces = (np.array(part) for part in zip(*(rows[w] for w in every), strict=True))
    step = 2 * np.pi * np.arange(directions) / directions
    incident = [[froude_krylov(one.hull, water, w, step) for one in members] for w in every]
    return SeveralCoefficients(
        frequencies_rad_s=np.array(every),
        added_mass=added_mass * cluster.couplings,
        radiation_damping=damping * cluster.couplings,
        added_mass_infinite=infinite,
        froude_krylov=np.array(incident),
        diffraction=forces,
        added_rad_s=tuple(sorted(added)),
        quick=_quick_left(rows, infinite),
        solver=f"Capytaine {module.__version__}, direct boundary integral equation",
    )


def _settings(problem: ClusterFlow, cluster: Cluster, directions: int) -> str:
    """Digest of everything that the coefficients of one frequency depend on."""
    lids = () if cluster.cover is None else (cluster.cover.vertices, cluster.cover.faces)
    water, engine = problem.water, problem.engine.exportable_settings
    return digest([
        "several", problem.module.__version__, engine, cluster.reflections, cluster.panels.vertices,
        cluster.panels.faces, cluster.owners, cluster.origins_m, cluster.headings_rad, *lids,
        water.density_kg_m3, water.gravity_m_s2, water.depth_m, directions,
    ])  # fmt: skip


def solved_directions(
    headings_rad: NDArray[np.float64], directions: int
) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Directions in the axes of the cluster, and the index of each hull's own among them, (hull,
    direction)."""
    turn = 2 * np.pi
    wanted = turn / directions * np.arange(directions) + headings_rad[:, None]
    keys = np.round(np.mod(wanted, turn) / SAME_ANGLE).astype(np.int64) % round(turn / SAME_ANGLE)
    found, index = np.unique(keys, return_inverse=True)
    first = np.array([wanted.ravel()[np.argmax(index.ravel() == k)] for k in range(len(found))])
    return np.mod(first, turn), index.reshape(wanted.shape)


def _changes(
    rows: dict[float, tuple[NDArray, ...]], infinite: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Frequencies, and the largest change of B or w A between each two neighbours, over the peaks."""
    omega = np.array(sorted(rows))
    memory = np.array([rows[w][1] + 1j * w * (rows[w][0] - infinite) for w in omega])
    peaks = np.abs(np.diagonal(memory, axis1=1, axis2=2)).max(axis=0)
    # Motions that hardly make waves, such as the yaw of a body of revolution, have noise for a peak.
    moving = peaks > 1e-3 * np.abs(np.diagonal(infinite)) * omega[-1]
    scaled = (memory / np.sqrt(np.outer(peaks, peaks) + 1e-300))[:, moving][:, :, moving]
    return omega, np.abs(np.diff(scaled, axis=0)).max(axis=(1, 2), initial=0.0)


def _quickest(rows: dict[float, tuple[NDArray, ...]], infinite: NDArray[np.float64]) -> float | None:
    """The frequency between the two neighbours with the quickest change; `None` if all changes are slow or
    all such neighbours are near each other."""
    omega, change = _changes(rows, infinite)
    apart = np.diff(omega) / omega[1:] > 2 * NARROWEST
    change[~apart] = 0.0
    at = int(change.argmax())
    if change[at] <= QUICK_CHANGE:
        return None
    return float(f"{0.5 * (omega[at] + omega[at + 1]):.6g}")


def _quick_left(
    rows: dict[float, tuple[NDArray, ...]], infinite: NDArray[np.float64]
) -> tuple[float, float, float] | None:
    """The quickest change between neighbours with both frequencies; `None` if it is slow."""
    if len(rows) < 2:
        return None
    omega, change = _changes(rows, infinite)
    at = int(change.argmax())
    return (float(change[at]), float(omega[at]), float(omega[at + 1])) if change[at] > QUICK_CHANGE else None


class ClusterFlow(Flow):
    """All hulls as one body of Capytaine with six motions each.

    A dissipative surface between hulls would add its panels here, with the condition
    phi_n = (w^2 / g) (1 + i e) phi in the matrices of `at`.
    """

    def __init__(self, module: Any, cluster: Cluster, water: Water) -> None:
        super().__init__(module, water)
        self.cluster = cluster
        mesh = capytaine_mesh(module, cluster.panels, cluster.reflections)
        motions = cluster.motions(mesh.faces_centers)
        cover = cluster.cover
        lid_mesh = None if cover is None else capytaine_mesh(module, cover, cluster.reflections)
        self.hold(mesh, lid_mesh, {f"{k // 6} {k % 6}": motion for k, motion in enumerate(motions)})
        along_normal = np.einsum("mpi,pi->mp", motions, mesh.faces_normals)
        self.weights = along_normal * mesh.faces_areas

    def at(
        self, frequency: float, angles: NDArray[np.float64], index: NDArray[np.int64]
    ) -> tuple[NDArray, ...]:
        """Added mass, damping, and diffraction forces (hull, direction, 6) in each hull's axes and phase."""
        radiated = [self.radiation(self.body, motion, frequency) for motion in self.motions]
        scattered = [self.diffraction(angle, frequency) for angle in angles]
        forces = self._forces([*radiated, *scattered])
        count = len(self.motions)
        radiation, diffraction = forces[:count].T, forces[count:]
        k = wave_number(frequency, self.water)
        ahead = np.stack([np.cos(angles), np.sin(angles)])
        # From a crest at the first hull's origin to one at each hull's own.
        phase = np.exp(-1j * k * self.cluster.origins_m @ ahead)
        by_hull = np.array(np.split(diffraction, len(index), axis=1)) * phase[..., None]
        own = np.array([forces[at] for forces, at in zip(by_hull, index, strict=True)])
        return radiation.real / frequency**2, radiation.imag / frequency, own

    def seconds(self, frequency: float, directions: int) -> float:
        """Estimate the seconds of one frequency by a small trial on this machine."""
        from scipy.linalg import lu_factor

        part = self.cluster.panels
        trial = self.module.Mesh(
            part.vertices, part.corner_lists[:TRIAL_PANELS], auto_clean=False, auto_check=False
        )
        problem = self.diffraction(0.0, frequency)
        settings = {"free_surface": 0.0, "water_depth": problem.water_depth, "wavenumber": problem.wavenumber,
                    "adjoint_double_layer": False, "diagonal_term_in_double_layer": True}  # fmt: skip
        taken = []
        for _ in range(2):  # the first time also loads libraries
            start = time.perf_counter()
            self.engine.green_function.evaluate(trial, trial, early_dot_product=True, **settings)
            taken.append(time.perf_counter() - start)
        by_pair = taken[-1] / trial.nb_faces**2
        matrix = np.random.default_rng(0).standard_normal((TRIAL_UNKNOWNS,) * 2) + 1j * np.eye(TRIAL_UNKNOWNS)
        start = time.perf_counter()
        lu_factor(matrix, overwrite_a=True, check_finite=False)
        by_product = (time.perf_counter() - start) / (TRIAL_UNKNOWNS**3 / 3)
        images = 2 ** len(self.cluster.reflections)
        n = self.body.mesh_including_lid.nb_faces // images
        products = n**3 / 3 + 2 * n**2 * (len(self.motions) + directions)
        return images * (by_pair * n**2 + by_product * products)

    def _forces(self, problems: Sequence[Any]) -> NDArray[np.complex128]:
        """Forces of the pressure for each problem, (problem, motion): one solution for all right-hand
        sides."""
        first, mesh = problems[0], self.body.mesh_including_lid
        single, double = self.engine.build_matrices(
            mesh, mesh, free_surface=first.free_surface, water_depth=first.water_depth,
            wavenumber=first.wavenumber, adjoint_double_layer=False, diagonal_term_in_double_layer=True,
        )  # fmt: skip
        conditions = np.stack([one.boundary_condition for one in problems], axis=1)
        potential = double.solve(single @ conditions)[self.body.hull_mask]
        self.engine.forget()
        pressure = 1j * float(first.omega) * self.water.density_kg_m3 * potential
        return -(self.weights @ pressure).T

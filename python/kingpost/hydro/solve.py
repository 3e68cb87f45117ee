"""The linear potential flow about a hull at zero forward speed, by the panel method of Capytaine 3.

M. Ancellin & F. Dias, Capytaine: a Python-based linear potential flow solver, J. Open Source Software
4(36), 2019. The direct boundary integral equation, for the potential, is used: on equal panels its added
masses are several times as accurate as those of the source formulation.
"""

from __future__ import annotations

import logging
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import HydrodynamicsError
from . import finite_depth
from .airy import decay, wave_number
from .database import Water
from .far_field import FarField, ring_angles, ring_waves
from .influence import Engine
from .meshes import HullMeshes, whole
from .panels import Panels, lid
from .partial import Partial, digest
from .symmetry import allowed_couplings, independent_directions, whole_circle

if TYPE_CHECKING:
    from numpy.typing import NDArray

SHALLOWEST_LID = 0.5
"""Smallest draught, in panel sizes, for a lid: nearer to the bottom a lid makes the equations
ill-conditioned.

On a box of 20 x 10 m, below its irregular frequencies, a lid at 0.4 panel sizes changes damping by 1 %, at
0.1 by 9 %."""
PANELS_PER_WAVE = 4
"""Panels per length of the shortest wave."""
LOG = logging.getLogger(__name__)
INSTALL = 'pip install "capytaine>=3"'


@dataclass(frozen=True)
class Coefficients:
    """Results of the panel method; arrays as in `Database`."""

    added_mass: NDArray[np.float64]
    radiation_damping: NDArray[np.float64]
    added_mass_infinite: NDArray[np.float64]
    froude_krylov: NDArray[np.complex128]
    diffraction: NDArray[np.complex128]
    far_field: FarField
    lid_panels: int
    solver: str


def capytaine() -> Any:
    """Import Capytaine; raise an error with the install command if it is missing."""
    try:
        import capytaine
    except ImportError:
        raise HydrodynamicsError("capytaine", "no such package", f"`{INSTALL}`, which installs it") from None
    version = capytaine.__version__
    if int(version.split(".")[0]) < 3:
        raise HydrodynamicsError("capytaine", f"version {version}", f"3 or later: `{INSTALL}`")
    return capytaine


def solve(
    hull: HullMeshes,
    water: Water,
    frequencies_rad_s: NDArray[np.float64],
    directions: int,
    with_lid: bool,
    update: Callable[[float], None] = lambda _done: None,
    partial: Partial | None = None,
) -> Coefficients:
    """Solve radiation and diffraction, one frequency at a time.

    Parameters
    ----------
    hull
        The wetted panels and their symmetry.
    water
        Density, gravity and depth.
    frequencies_rad_s
        Increasing.
    directions
        Number of wave directions on the circle.
    with_lid
        Whether to close the inner water plane, which shifts irregular frequencies away.
    update
        Called with the number of solved frequencies.
    partial
        Stores each solved frequency, and holds those of a stopped run.
    """
    module = capytaine()
    cover = lid(hull.panels, hull.panel_size_m) if with_lid else None
    rings = ring_angles(hull, water, frequencies_rad_s, directions)
    problem = _Problem(module, hull, water, cover, rings)
    chosen = independent_directions(directions, hull.reflections)
    angles = 2 * np.pi * np.array(chosen) / directions
    partial = partial or Partial(None)
    partial.open(_settings(problem, hull, cover, frequencies_rad_s, directions))
    infinite = partial.kept("infinite", lambda: (problem.infinite(),))[0]
    update(1)
    rows = []
    for done, frequency in enumerate(frequencies_rad_s):
        row = partial.get(str(done))
        if row is None:
            row = problem.at(frequency, angles)
            partial.put(str(done), row)
            LOG.info("%d of %d frequencies solved: %g rad/s", done + 1, len(frequencies_rad_s), frequency)
        rows.append(row)
        update(done + 2)
    parts = (np.array(part) for part in zip(*rows, strict=True))
    added_mass, damping, diffraction, radiated, scattered = parts
    incident = np.array([froude_krylov(hull, water, w, angles) for w in frequencies_rad_s])
    couplings = allowed_couplings(hull.reflections)
    return Coefficients(
        added_mass=added_mass * couplings,
        radiation_damping=damping * couplings,
        added_mass_infinite=infinite * couplings,
        froude_krylov=whole_circle(incident, chosen, directions, hull.reflections),
        diffraction=whole_circle(diffraction, chosen, directions, hull.reflections),
        far_field=FarField(radiated, scattered, chosen),
        lid_panels=0 if cover is None else len(cover.faces) * 2 ** len(hull.reflections),
        solver=f"Capytaine {module.__version__}, direct boundary integral equation",
    )


def _settings(
    problem: _Problem, hull: HullMeshes, cover: Panels | None, frequencies_rad_s: NDArray[np.float64],
    directions: int,
) -> str:  # fmt: skip
    """Digest of everything that the coefficients depend on."""
    lids = () if cover is None else (cover.vertices, cover.faces)
    stands = () if hull.attitude is None else (hull.attitude,)
    water, engine = problem.water, problem.engine.exportable_settings
    return digest([
        problem.module.__version__, engine, hull.reflections, hull.panels.vertices, hull.panels.faces, *lids,
        *stands, water.density_kg_m3, water.gravity_m_s2, water.depth_m, frequencies_rad_s, directions,
        problem.rings,
    ])  # fmt: skip


class Flow:
    """Capytaine's problems for bodies with any number of motions, in water of some depth."""

    def __init__(self, module: Any, water: Water) -> None:
        self.module = module
        self.engine = Engine(finite_depth.green_function(module))
        self.solver = module.BEMSolver(engine=self.engine, method="direct")
        self.water = water
        depth = np.inf if water.depth_m is None else water.depth_m
        self.conditions = {"rho": water.density_kg_m3, "g": water.gravity_m_s2, "water_depth": depth}

    def hold(self, mesh: Any, lid_mesh: Any, motions: dict[str, Any]) -> None:
        """Take the wetted mesh, its lid, or `None`, and the motions."""
        self.bare = self.module.FloatingBody(mesh=mesh, dofs=motions)
        self.body = self.bare
        if lid_mesh is not None:
            self.body = self.module.FloatingBody(mesh=mesh, lid_mesh=lid_mesh, dofs=motions)
        self.motions = list(self.body.dofs)

    def infinite(self) -> NDArray[np.float64]:
        """Added mass at infinite frequency, where the potential vanishes on the water plane."""
        problems = [self.radiation(self.bare, motion, np.inf) for motion in self.motions]
        found = self.matrix([self.solved(problem).added_masses for problem in problems])
        self.engine.forget()
        return found

    def radiation(self, body: Any, motion: str, frequency: float) -> Any:
        """The problem of a motion in calm water."""
        return self.module.RadiationProblem(
            body=body, omega=frequency, radiating_dof=motion, **self.conditions
        )

    def diffraction(self, angle: float, frequency: float) -> Any:
        """The problem of held bodies in a wave."""
        return self.module.DiffractionProblem(
            body=self.body, omega=frequency, wave_direction=angle, **self.conditions
        )

    def solved(self, problem: Any) -> Any:
        """Capytaine's result of a problem."""
        return self.solver.solve(problem, _check_wavelength=False)

    def matrix(self, by_motion: Sequence[dict[str, Any]]) -> NDArray[np.float64]:
        """Rows are forces, columns motions."""
        return np.array([[float(column[force]) for column in by_motion] for force in self.motions])


class _Problem(Flow):
    """A hull as a Capytaine body."""

    def __init__(self, module: Any, hull: HullMeshes, water: Water, cover: Panels | None, rings: int) -> None:
        super().__init__(module, water)
        self.rings = rings
        motions = module.rigid_body_dofs(rotation_center=(0, 0, 0))
        mesh = capytaine_mesh(module, hull.panels, hull.reflections)
        self.hold(mesh, None if cover is None else capytaine_mesh(module, cover, hull.reflections), motions)

    def at(self, frequency: float, angles: NDArray[np.float64]) -> tuple[NDArray, ...]:
        """Added mass, damping, diffraction forces, and the ring waves radiated and scattered."""
        radiated = [self.solved(self.radiation(self.body, motion, frequency)) for motion in self.motions]
        scattered = [self.solved(self.diffraction(angle, frequency)) for angle in angles]
        added_mass = self.matrix([result.added_masses for result in radiated])
        damping = self.matrix([result.radiation_dampings for result in radiated])
        forces = np.array([[result.forces[motion] for motion in self.motions] for result in scattered])
        self.engine.forget()
        waves = self._ring_waves([*radiated, *scattered], frequency)
        return added_mass, damping, forces, waves[:6], waves[6:]

    def _ring_waves(self, results: Sequence[Any], frequency: float) -> NDArray[np.complex128]:
        shell = self.body.hull_mask
        potential = np.array([result.potential[shell] for result in results])
        velocity = np.array([result.problem.boundary_condition[shell] for result in results])
        return ring_waves(self.body.mesh, potential, velocity, frequency, self.water, self.rings)


def capytaine_mesh(module: Any, panels: Panels, reflections: Sequence[int]) -> Any:
    """Panels as Capytaine's mesh, mirrored."""
    mesh = module.Mesh(panels.vertices, panels.corner_lists, auto_clean=False, auto_check=False)
    for axis in reflections:
        mesh = module.ReflectionSymmetricMesh(mesh, plane="yOz" if axis == 0 else "xOz")
    return mesh


def froude_krylov(
    hull: HullMeshes, water: Water, frequency: float, angles: NDArray[np.float64]
) -> NDArray[np.complex128]:
    """Force of the undisturbed wave's pressure on the wetted hull, shape (directions, 6), per metre.

    -Int p n dS over triangles of the panels, with
    p = rho g cosh k(z + h) / cosh kh exp(i k (x cos b + y sin b)) at the midpoints of their edges.
    """
    surface = whole(hull.panels.surface, hull.reflections)
    points = surface.midpoints.reshape(-1, 3)
    areas = np.repeat(surface.area_vectors / 3, 3, axis=0)
    weights = np.concatenate([areas, np.cross(points, areas)], axis=1)
    k = wave_number(frequency, water)
    x, y, z = points.T
    height, _ = decay(k, z, water)
    pressure = water.density_kg_m3 * water.gravity_m_s2 * height
    # One direction at a time: all directions together need more memory than the matrices of a small hull.
    forces = [-(pressure * np.exp(1j * k * (np.cos(a) * x + np.sin(a) * y))) @ weights for a in angles]
    return np.array(forces)

"""Writers of other programs' hydrodynamic files from one database, for the tests of the importers.

Each follows the program's documentation independently: moments about a reference point, units, signs of
time, and the weight in the restoring matrix.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import hydro_samples as samples
import numpy as np
from kingpost.hydro.database import Database, Hull, Water, Waterplane

REFERENCE = np.array([1.0, 0.5, -2.0])
GRAVITY_CENTRE = np.array([0.4, 0.0, -1.2])


def database(highest: float = 2.4, count: int = 12) -> Database:
    """A hull that is not symmetric fore and aft, in four wave directions, physical in long waves.

    Four directions are too few for Haskind's relation to be looked at.
    """
    omega = np.geomspace(0.2, highest, count)
    s = 1j * omega[:, None, None]
    memory = samples.memory_of_bandpasses(omega) + 1e4 * s / ((s + 1.0) * (s + 1.7))
    infinite = np.diag([1.5e5, 1.6e5, 1.3e5, 2e5, 4e6, 3e5]) + 2e4 * np.eye(6)[[4, 3, 2, 1, 0, 5]]
    added_mass = infinite + memory.imag / omega[:, None, None]
    hull = Hull(
        draught_m=5.0, length_m=12.0, beam_m=10.0, volume_m3=262.0,
        centre_of_buoyancy_m=np.array([0.4, 0.0, -1.9]),
        waterplane=Waterplane(80.0, np.array([24.0, 0.0]), np.array([700.0, 0.0, 480.0])),
    )  # fmt: skip
    water = Water(1000.0, 9.81, None)
    directions = 0.5 * np.pi * np.arange(4)
    mass = water.density_kg_m3 * hull.volume_m3
    square = omega[:, None] ** 2
    excitation = np.zeros((len(omega), 4, 6), complex)
    ahead, athwart = np.cos(directions), np.sin(directions)
    excitation[:, :, 0] = -1j * square * (mass + added_mass[:, 0, 0, None]) * ahead
    excitation[:, :, 1] = -1j * square * (mass + added_mass[:, 1, 1, None]) * athwart
    excitation[:, :, 2] = 9810.0 * 80.0 - square * (mass + added_mass[:, 2, 2, None])
    # The slope of a long wave meets buoyancy's stiffness, its acceleration the added mass; k = w^2 / g.
    roll = 1000.0 * (480.0 - 262.0 * 1.9) - added_mass[:, 3, 1, None]
    pitch = 1000.0 * (700.0 - 262.0 * 1.9) + added_mass[:, 4, 0, None]
    excitation[:, :, 3] = (2e4 + 1j * roll) * athwart * square
    excitation[:, :, 4] = -9810.0 * 24.0 + (1e4 - 1j * pitch) * ahead * square
    excitation[:, :, 5] = (0.5 + 2j) * 1e3 * athwart * square
    return samples.database(
        omega, added_mass, memory.real, infinite, hull=hull, water=water, wave_directions_rad=directions,
        froude_krylov=0.7 * excitation, diffraction=0.3 * excitation,
    )  # fmt: skip


@dataclass
class About:
    """A database's numbers about a reference point: A_R = S^T A_O S, the velocities at O being S nu_R."""

    of: Database
    point: np.ndarray

    def __post_init__(self) -> None:
        # v_O = v_R + omega x (O - R), one column for each unit rotation.
        self.shift = np.eye(6)
        for axis in range(3):
            self.shift[:3, 3 + axis] = np.cross(np.eye(3)[axis], -self.point)

    def matrix(self, matrices: np.ndarray) -> np.ndarray:
        return self.shift.T @ matrices @ self.shift

    def force(self, forces: np.ndarray) -> np.ndarray:
        return np.einsum("ij,...i->...j", self.shift, forces)

    def restoring(self, gravity_centre: np.ndarray | None) -> np.ndarray:
        """Buoyancy's stiffness about the point by its definition, with weight where a centre is given."""
        hull, weight = self.of.hull, self.of.water.density_kg_m3 * self.of.water.gravity_m_s2
        (x, y, z), plane, volume = self.point, hull.waterplane, hull.volume_m3
        area, (ix, iy), (ixx, ixy, iyy) = plane.area_m2, plane.first_moments_m3, plane.second_moments_m4
        vertical = volume * (hull.centre_of_buoyancy_m[2] - z)
        if gravity_centre is not None:
            vertical -= volume * (gravity_centre[2] - z)
        found = np.zeros((6, 6))
        found[2, 2] = area
        found[2, 3] = found[3, 2] = iy - y * area
        found[2, 4] = found[4, 2] = -(ix - x * area)
        found[3, 3] = iyy - 2 * y * iy + y * y * area + vertical
        found[4, 4] = ixx - 2 * x * ix + x * x * area + vertical
        found[3, 4] = found[4, 3] = -(ixy - x * iy - y * ix + x * y * area)
        return weight * found


def write_bemio(path: Path, base: Database, *, scaled: bool = False, apart: bool = True) -> None:
    """As WEC-Sim's writeBEMIOH5; moments about cg; exp(+i w t)."""
    import h5py

    about, water, hull = About(base, REFERENCE), base.water, base.hull
    rho, weight = water.density_kg_m3, water.density_kg_m3 * water.gravity_m_s2
    omega = base.frequencies_rad_s[:, None, None]
    by_rho, by_omega, by_weight = (1.0, 1.0, 1.0) if scaled else (rho, rho * omega, weight)
    excitation = {"": base.excitation}
    if apart:
        excitation["froude-krylov/"] = base.froude_krylov
    with h5py.File(path, "w") as file:
        general, body = file.create_group("simulation_parameters"), file.create_group("body1")
        file["bem_data/code"] = np.bytes_(b"CAPYTAINE")
        general["scaled"], general["g"], general["rho"] = float(scaled), water.gravity_m_s2, rho
        general["water_depth"] = np.bytes_(b"infinite") if water.depth_m is None else water.depth_m
        general["w"] = base.frequencies_rad_s[:, None]
        general["wave_dir"] = np.degrees(base.wave_directions_rad)[:, None]
        body["properties/cg"], body["properties/cb"] = REFERENCE[:, None], hull.centre_of_buoyancy_m[:, None]
        body["properties/disp_vol"] = hull.volume_m3
        there = body.create_group("hydro_coeffs")
        there["added_mass/all"] = (about.matrix(base.added_mass) / by_rho).transpose(1, 2, 0)
        there["added_mass/inf_freq"] = about.matrix(base.added_mass_infinite) / by_rho
        there["radiation_damping/all"] = (about.matrix(base.radiation_damping) / by_omega).transpose(1, 2, 0)
        there["linear_restoring_stiffness"] = about.restoring(REFERENCE) / by_weight
        for name, forces in excitation.items():
            values = (about.force(forces) / by_weight).conj().transpose(2, 1, 0)
            there[f"excitation/{name}re"], there[f"excitation/{name}im"] = values.real, values.imag


def capytaine_dataset(base: Database, version: int):
    """As Capytaine's `assemble_dataset` and `separate_complex_values`, of version 2.3 or 3.0."""
    import xarray

    about, water, hull = About(base, REFERENCE), base.water, base.hull
    dofs = ["Surge", "Sway", "Heave", "Roll", "Pitch", "Yaw"]
    omega = np.append(base.frequencies_rad_s, np.inf)
    added_mass = about.matrix(np.concatenate([base.added_mass, base.added_mass_infinite[None]]))
    damping = about.matrix(np.concatenate([base.radiation_damping, np.zeros((1, 6, 6))]))
    nothing = np.full((1, *base.froude_krylov.shape[1:]), np.nan + 1j * np.nan)
    by_motion = ("omega", "influenced_dof", "radiating_dof")
    variables = {"added_mass": (by_motion, added_mass), "radiation_damping": (by_motion, damping),
                 "hydrostatic_stiffness": (by_motion[1:], about.restoring(GRAVITY_CENTRE))}  # fmt: skip
    for name, forces in (
        ("Froude_Krylov_force", base.froude_krylov),
        ("diffraction_force", base.diffraction),
    ):
        values = np.concatenate([about.force(forces), nothing])
        dims = ("complex", "omega", "wave_direction", "influenced_dof")
        variables[name] = (dims, np.stack([values.real, values.imag]))
    depth = np.inf if water.depth_m is None else water.depth_m
    coordinates = {"omega": omega, "influenced_dof": dofs, "radiating_dof": dofs, "complex": ["re", "im"],
                   "wave_direction": base.wave_directions_rad, "rho": water.density_kg_m3,
                   "g": water.gravity_m_s2, "water_depth": depth, "forward_speed": 0.0}  # fmt: skip
    found = xarray.Dataset(variables, coordinates, {"capytaine_version": f"{version}.0"})
    if version == 2:
        order = ("omega", "radiating_dof", "influenced_dof")
        return found.assign(added_mass=found.added_mass.transpose(*order),
                            radiation_damping=found.radiation_damping.transpose(*order))  # fmt: skip
    space = "space_coordinate"
    return found.assign_coords(
        rotation_center=(space, REFERENCE), center_of_mass=(space, GRAVITY_CENTRE)
    ).assign(
        center_of_buoyancy=(space, hull.centre_of_buoyancy_m),
        disp_mass=hull.volume_m3 * water.density_kg_m3,
        draught=hull.draught_m,
    )


@dataclass
class Wamit:
    """As WAMIT's numeric output, or that of others who write frequencies or the other sign of time."""

    length: float = 1.0
    by_period: bool = True
    sign: str = "+"
    header: bool = False
    infinite: bool = True
    apart: bool = False

    def write(self, stem: Path, base: Database) -> Path:
        about, rho, g = About(base, REFERENCE), base.water.density_kg_m3, base.water.gravity_m_s2
        power = np.repeat([1.0, self.length], 3)
        mass = rho * self.length**3 * np.outer(power, power)
        force = rho * g * self.length**2 * power
        first = 2 * np.pi / base.frequencies_rad_s if self.by_period else base.frequencies_rad_s
        head = ["   PER   I   J   A(I,J)   B(I,J)"] if self.header else []
        rows = list(head)
        if self.infinite:
            added = about.matrix(base.added_mass_infinite) / mass
            column = 0.0 if self.by_period else -1.0
            rows += [
                f"{column:13.6E} {i + 1} {j + 1} {added[i, j]:20.12E}" for i in range(6) for j in range(6)
            ]
        matrices = zip(first, about.matrix(base.added_mass), about.matrix(base.radiation_damping),
                       base.frequencies_rad_s, strict=True)  # fmt: skip
        for column, added, damping, omega in matrices:
            a, b = added / mass, damping / mass / omega
            rows += [f"{column:20.12E} {i + 1} {j + 1} {a[i, j]:20.12E} {b[i, j]:20.12E}"
                     for i in range(6) for j in range(6)]  # fmt: skip
        stem.with_suffix(".1").write_text("\n".join(rows) + "\n")
        for ending, forces in ((".3", base.excitation), (".3fk", base.froude_krylov)):
            if ending == ".3" or self.apart:
                values = about.force(forces) / force
                self._write_waves(stem.with_suffix(ending), head, first, base, values)
        restoring = about.restoring(None) / (rho * g * self.length**2 * np.outer(power, power))
        hst = [f"{i + 1} {j + 1} {restoring[i, j]:20.12E}" for i in range(6) for j in range(6)]
        stem.with_suffix(".hst").write_text("\n".join(head + hst) + "\n")
        return stem.with_suffix(".1")

    def _write_waves(self, path: Path, head: list[str], first: np.ndarray, base: Database, values) -> None:
        values = values.conj() if self.sign == "+" else values
        rows = list(head)
        for column, of_frequency in zip(first, values, strict=True):
            for direction, forces in zip(np.degrees(base.wave_directions_rad), of_frequency, strict=True):
                rows += [
                    f"{column:20.12E} {direction:9.4f} {i + 1} {abs(x):16.8E} {np.degrees(np.angle(x)):12.6f}"
                    f" {x.real:20.12E} {x.imag:20.12E}"
                    for i, x in enumerate(forces)
                ]
        path.write_text("\n".join(rows) + "\n")

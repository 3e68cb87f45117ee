"""Response of a listed box to regular waves, by Capytaine and closed forms only.

    python python/tests/peers/listed_box.py -o python/tests/peers/listed_box.json

writes `listed_box.json` again in some minutes. Kingpost is not used: the wetted part of a box that
lists at constant displacement is a prism, whose panels are made here; added mass, damping and excitation are
those of Capytaine's indirect boundary integral equation about the centre of gravity, with Capytaine's own
lid; stiffness is that of a wall-sided hull. The only damping is that of radiated waves and a stated one in
roll. The number of panels is finite: At a list of 5 deg and 0.7, 0.76 and 0.95 rad/s, 3200 panels of
Capytaine's direct equation have amplitudes that differ by up to 1.7 % of the largest roll abeam, 1.4 % of the
largest sway, 1.2 % of the largest heave, and 3.3 % of the largest sway in head seas, a fiftieth of that
abeam.

Axes: x forward, y to port, z up, level, the origin on the water plane at the middle of it, which is where the
middle of the upright water plane stays. Heel is positive to starboard. Waves of 1 m go to their direction and
have their crest at the origin at t = 0; a motion is Re{q exp(-i w t)}, of the centre of gravity.
"""

from __future__ import annotations

import argparse
import json
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

COMMAND = "python python/tests/peers/listed_box.py -o python/tests/peers/listed_box.json"
LENGTH, BEAM, DRAUGHT, DEPTH = 100.0, 24.0, 5.0, 9.0
KEEL_TO_GRAVITY, GYRATION = 6.0, (8.4, 25.0, 25.0)
DENSITY, GRAVITY = 1025.0, 9.80665
ROLL_DAMPING_RATIO = 0.05
LISTS_DEG = (2.0, 5.0, 10.0)
DIRECTIONS_DEG = (180.0, 90.0)
FREQUENCIES = (0.06, 0.15, 0.25, 0.35, 0.45, 0.52, 0.58, 0.64, 0.7, 0.76, 0.84, 0.95, 1.08, 1.2)
PANELS = 1600
MASS = DENSITY * LENGTH * BEAM * DRAUGHT


@dataclass(frozen=True)
class Listed:
    """The box at a list to starboard, rad, so small that neither deck nor bottom reaches the water plane."""

    heel: float

    def level(self, y: float, z: float) -> np.ndarray:
        """A point (y, z) of the upright section in the level axes."""
        cos, sin = np.cos(self.heel), np.sin(self.heel)
        return np.array([cos * y - sin * z, sin * y + cos * z])

    @property
    def buoyancy(self) -> np.ndarray:
        """Centre of buoyancy (y, z), hull axes: the wall-sided formulas."""
        tan, moment = np.tan(self.heel), BEAM**2 / (12 * DRAUGHT)
        return np.array([-moment * tan, -DRAUGHT / 2 + moment * tan**2 / 2])

    @property
    def gravity(self) -> np.ndarray:
        """Centre of gravity (y, z), hull axes: straight above that of buoyancy, by ballast to a side."""
        y, z = self.buoyancy
        height = KEEL_TO_GRAVITY - DRAUGHT
        return np.array([y + (height - z) * np.tan(self.heel), height])

    @property
    def section(self) -> np.ndarray:
        """Corners (y, z) of the wetted section, from the water line to port over the keel to starboard."""
        drop = BEAM / 2 * np.tan(self.heel)
        corners = [(BEAM / 2, -drop), (BEAM / 2, -DRAUGHT), (-BEAM / 2, -DRAUGHT), (-BEAM / 2, drop)]
        return np.array([self.level(*corner) for corner in corners])

    def stiffness(self) -> np.ndarray:
        """About the centre of gravity; the weight's part is in the lever of B over G."""
        y, z = self.level(*self.gravity)
        breadth = BEAM / np.cos(self.heel)
        area, lever = LENGTH * breadth, MASS / DENSITY * (self.level(*self.buoyancy)[1] - z)
        found = np.zeros((6, 6))
        found[2, 2], found[2, 3] = area, -area * y
        found[3, 2] = found[2, 3]
        found[3, 3] = area * (breadth**2 / 12 + y**2) + lever
        found[4, 4] = area * LENGTH**2 / 12 + lever
        return DENSITY * GRAVITY * found


def eased(count: int) -> np.ndarray:
    """From 0 to 1, closer together at both ends: the flow turns round the edges."""
    even = np.linspace(0, 1, count + 1)
    return (even + (1 - np.cos(np.pi * even)) / 2) / 2


def quads_between(corners: np.ndarray, first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """Panels of a quadrangle a, b, c, d in bilinear coordinates: first along a-b, second along a-d."""
    a, b, c, d = corners
    u, v = first[:, None, None], second[None, :, None]
    grid = (1 - u) * (1 - v) * a + u * (1 - v) * b + u * v * c + (1 - u) * v * d
    return np.stack(
        [grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]], axis=2
    ).reshape(-1, 4, 3)  # fmt: skip


def fore_half(section: np.ndarray, panels: int) -> np.ndarray:
    """Panels of the wetted half x >= 0, normals outward."""
    sides = [np.linalg.norm(section[k + 1] - section[k]) for k in range(3)]
    (y0, z0), (y1, z1) = section[2] - section[0], section[3] - section[1]
    end = abs(y0 * z1 - y1 * z0) / 2
    size = ((LENGTH * sum(sides) + 2 * end) / panels) ** 0.5
    counts = [max(2, round(side / size)) for side in sides]
    # Towards the end of the box, evenly from the middle.
    along = 2 * eased(2 * round(LENGTH / 2 / size))[round(LENGTH / 2 / size) :] - 1
    found = []
    for k, count in enumerate(counts):
        (y0, z0), (y1, z1) = section[k], section[k + 1]
        half = LENGTH / 2
        corners = np.array([[0, y0, z0], [half, y0, z0], [half, y1, z1], [0, y1, z1]])
        found.append(quads_between(corners, along, eased(count)))
    (y, z), x = section.T, LENGTH / 2
    end_corners = np.array([[x, y[k], z[k]] for k in (0, 3, 2, 1)])
    down = eased(max(counts[0], counts[2]))
    return np.concatenate([*found, quads_between(end_corners, eased(counts[1]), down)])


def solve(case: Listed, panels: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A, B (frequency, 6, 6) and X (frequency, direction, 6) about the centre of gravity, moments there."""
    import capytaine

    capytaine.set_logging("ERROR")
    quads = fore_half(case.section, panels)
    half = capytaine.Mesh(quads.reshape(-1, 3), np.arange(4 * len(quads)).reshape(-1, 4).tolist())
    mesh = capytaine.ReflectionSymmetricMesh(half, plane="yOz")
    centre = (0.0, *case.level(*case.gravity))
    dofs = capytaine.rigid_body_dofs(rotation_center=centre)
    body = capytaine.FloatingBody(mesh=mesh, lid_mesh=mesh.generate_lid(), dofs=dofs)
    solver = capytaine.BEMSolver(method="indirect")
    names, sea = list(body.dofs), {"rho": DENSITY, "g": GRAVITY, "water_depth": np.inf}
    added, damping, excitation = [], [], []
    for w in FREQUENCIES:
        radiated = [solver.solve(capytaine.RadiationProblem(body=body, omega=w, radiating_dof=one, **sea))
                    for one in names]  # fmt: skip
        added.append([[one.added_masses[force] for one in radiated] for force in names])
        damping.append([[one.radiation_dampings[force] for one in radiated] for force in names])
        excitation.append([forces(capytaine, solver, body, w, at, sea) for at in np.radians(DIRECTIONS_DEG)])
    return np.array(added), np.array(damping), np.array(excitation)


def forces(capytaine: object, solver: object, body: object, w: float, angle: float, sea: dict) -> list:
    """Froude-Krylov and diffraction force, surge to yaw."""
    problem = capytaine.DiffractionProblem(body=body, omega=w, wave_direction=angle, **sea)
    diffraction = solver.solve(problem).forces
    incident = capytaine.bem.airy_waves.froude_krylov_force(problem)
    return [diffraction[name] + incident[name] for name in body.dofs]


def answer(case: Listed, panels: int) -> dict[str, object]:
    """The case with its response (direction, frequency; sway, heave, roll)."""
    added, damping, excitation = solve(case, panels)
    stiffness = case.stiffness()
    mass = MASS * np.diag([1, 1, 1, *np.square(GYRATION)])
    critical = 2 * np.sqrt((mass + added[0])[3, 3] * stiffness[3, 3])
    # A round number that a scenario can state.
    extra = float(f"{ROLL_DAMPING_RATIO * critical:.3g}")
    damping[:, 3, 3] += extra
    w = np.array(FREQUENCIES)[:, None, None]
    impedance = -(w**2) * (mass + added) - 1j * w * damping + stiffness
    found = np.linalg.solve(impedance[:, None], excitation[..., None])[..., 0].transpose(1, 0, 2)
    y, z = case.gravity
    return {
        "list_deg": round(np.degrees(case.heel), 9),
        "centre_of_gravity_m": [0.0, round(y, 6), round(z, 6)],
        "metacentric_height_m": round(stiffness[3, 3] / (MASS * GRAVITY) - _off_centre(case), 5),
        "roll_damping_N_m_s": extra,
        "response": {
            f"{direction:g}": {
                motion: {"real": digits(values[:, k].real), "imaginary": digits(values[:, k].imag)}
                for motion, k in (("sway", 1), ("heave", 2), ("roll", 3))
            }
            for direction, values in zip(DIRECTIONS_DEG, found, strict=True)
        },
    }


def _off_centre(case: Listed) -> float:
    """What the waterplane's lever beside G adds to C44 over the weight, m: no part of GM."""
    y = case.level(*case.gravity)[0]
    return DENSITY * LENGTH * BEAM / np.cos(case.heel) * y**2 / MASS


def digits(values: np.ndarray) -> list[float]:
    return [float(f"{value:.5g}") for value in values]


def truth(panels: int) -> dict[str, object]:
    """All cases."""
    return {
        "command": COMMAND,
        "about": "response of a listed box in m and rad per m of wave amplitude, of its centre of gravity",
        "length_m": LENGTH, "beam_m": BEAM, "draught_m": DRAUGHT, "depth_m": DEPTH, "mass_kg": MASS,
        "keel_to_gravity_m": KEEL_TO_GRAVITY, "radii_of_gyration_m": GYRATION,
        "density_kg_m3": DENSITY, "gravity_m_s2": GRAVITY, "panels": panels,
        "frequencies_rad_s": FREQUENCIES, "directions_deg": DIRECTIONS_DEG,
        "cases": [answer(Listed(np.radians(heel)), panels) for heel in LISTS_DEG],
    }  # fmt: skip


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("-o", "--output", type=Path, required=True)
    options.add_argument("--panels", type=int, default=PANELS, help="of the wetted hull, about")
    given = options.parse_args()
    text = json.dumps(truth(given.panels), indent=1)
    # A list of numbers on a line.
    lines = re.sub(r"\[[^\[\]{}]*\]", lambda found: " ".join(found[0].split()), text)
    given.output.write_text(lines + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()

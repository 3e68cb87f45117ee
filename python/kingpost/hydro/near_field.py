"""Mean second-order force and moment on one hull among several, from the momentum of the water around it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from . import finite_depth
from .airy import decay, wave_number
from .control_surface import (
    ControlSurface,
    Points,
    Waterline,
    control_surface,
    distance,
    outline,
    waterline,
)
from .panels import Panels
from .solve import capytaine, capytaine_mesh
from .surface import particulars

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from .database import Water

NUDGE = 0.03
"""Half the distance of the two sheets of sources that make a dipole panel, in panel sizes."""
POINTS_AT_ONCE = 300
"""Number of points for which the influence of all panels is held in memory."""


@dataclass(frozen=True)
class WettedHull:
    """The whole wetted hull at rest, without planes of symmetry.

    Attributes
    ----------
    panels
        In the order of the potentials.
    reference_m
        Point of the hull to which its motions refer.
    """

    panels: Panels
    reference_m: NDArray[np.float64]


@dataclass(frozen=True)
class FirstOrder:
    """First-order solution for one regular wave of 1 m, with exp(-i w t).

    Attributes
    ----------
    hulls
        All hulls in the water.
    potential, normal_velocity
        Sum of the radiated and the diffracted potential, without the incident one, on the panels of all
        hulls; and its derivative along the outward normal.
    motions
        Motions of each hull, shape (hulls, 6), m and rad.
    """

    hulls: Sequence[WettedHull]
    water: Water
    frequency_rad_s: float
    direction_rad: float
    potential: NDArray[np.complex128]
    normal_velocity: NDArray[np.complex128]
    motions: NDArray[np.complex128]


def first_order(
    hulls: Sequence[WettedHull],
    water: Water,
    frequency_rad_s: float,
    direction_rad: float,
    radiated: NDArray[np.complex128],
    diffracted: NDArray[np.complex128],
    motions: NDArray[np.complex128],
) -> FirstOrder:
    """Sum the potentials of the motions of all hulls and of the diffracted wave.

    Parameters
    ----------
    radiated
        Potentials for a motion of 1 m or 1 rad of each hull, shape (hulls, 6, panels of all hulls).
    diffracted
        Potential of the wave diffracted by the held hulls, without the incident wave of 1 m.
    """
    normals, centres, owners = [], [], []
    for number, hull in enumerate(hulls):
        mesh = capytaine_mesh(capytaine(), hull.panels, ())
        normals.append(mesh.faces_normals)
        centres.append(mesh.faces_centers)
        owners.append(np.full(len(mesh.faces_centers), number))
    n, at, owner = np.concatenate(normals), np.concatenate(centres), np.concatenate(owners)
    arms = at - np.array([hull.reference_m for hull in hulls])[owner]
    moved = motions[owner, :3] + np.cross(motions[owner, 3:], arms)
    _, incident = _incident(at, frequency_rad_s, direction_rad, water)
    velocity = ((-1j * frequency_rad_s * moved - incident) * n).sum(axis=1)
    potential = diffracted + np.tensordot(motions, radiated, 2)
    return FirstOrder(hulls, water, frequency_rad_s, direction_rad, potential, velocity, motions)


def mean_force(
    waves: FirstOrder, which: int, away_m: float | None = None, spacing_m: float | None = None
) -> NDArray[np.float64]:
    """Mean force and moment of the water on one hull, per amplitude squared, shape (6,).

    Parameters
    ----------
    which
        Index of the hull.
    away_m
        Distance of the control surface from the hull; by default half the gap to the nearest other hull, but
        at most a quarter of the square root of the area of its outline.
    spacing_m
        Distance between the points of the control surface; by default half its distance from the hull, but at
        most an eighth of a wave length.
    """
    outlines = [outline(hull.panels) for hull in waves.hulls]
    gaps = [distance(outlines[which], other) for n, other in enumerate(outlines) if n != which]
    away = away_m or min([_extent(outlines[which]) / 4, *(gap / 2 for gap in gaps)])
    length = 2 * np.pi / wave_number(waves.frequency_rad_s, waves.water)
    surface = control_surface(
        waves.hulls[which].panels, away, spacing_m or min(away / 2, length / 8), waves.water.depth_m
    )
    return mean_force_inside(waves, which, surface)


def mean_force_inside(waves: FirstOrder, which: int, surface: ControlSurface) -> NDArray[np.float64]:
    """Mean force and moment on the hull inside a control surface."""
    hull, motion, water = waves.hulls[which], waves.motions[which], waves.water
    flow = _Flow(waves)
    found = _momentum(flow, surface, hull.reference_m, water)
    if surface.water_plane is None:
        return np.where([True, True, False, False, False, True], found, np.nan)
    line = waterline(hull.panels)
    weight = water.density_kg_m3 * water.gravity_m_s2
    inside = _raised_water(flow, surface.water_plane, hull.reference_m, water)
    inside -= _taken_by_hull(flow, line, hull, motion, water)
    inside -= submerged_moments(hull, motion)
    found[2:5] -= weight * inside
    return found


def _momentum(
    flow: _Flow, surface: ControlSurface, reference: NDArray[np.float64], water: Water
) -> NDArray[np.float64]:
    """Pressure and flux of momentum through the control surface, and the pressure on its moving rim."""
    shell, rim = surface.shell, surface.rim
    _, v = flow.at(shell.at_m)
    through = (v * shell.normals).sum(axis=1)[:, None]
    square = (np.abs(v) ** 2).sum(axis=1)[:, None]
    density, gravity = water.density_kg_m3, water.gravity_m_s2
    force = density * (square * shell.normals / 4 - (v * through.conj()).real / 2) * shell.weights[:, None]
    raised = np.abs(flow.elevation(rim.at_m))[:, None]
    edge = -density * gravity / 4 * raised**2 * rim.normals * rim.weights[:, None]
    total = np.zeros(6)
    for points, part in ((shell, force), (rim, edge)):
        total += np.concatenate([part.sum(axis=0), np.cross(points.at_m - reference, part).sum(axis=0)])
    return total


def _raised_water(
    flow: _Flow, plane: Points, reference: NDArray[np.float64], water: Water
) -> NDArray[np.float64]:
    """Int f <zeta_2> dS over the water plane, <zeta_2> = (<phi_z^2> - <phi_x^2> - <phi_y^2>) / 2 g."""
    _, v = flow.at(plane.at_m)
    across, along, up = np.abs(v.T) ** 2
    mean = (up - across - along) / (4 * water.gravity_m_s2)
    return _arms(plane.at_m, reference) @ (mean * plane.weights)


def _taken_by_hull(
    flow: _Flow, line: Waterline, hull: WettedHull, motion: NDArray[np.complex128], water: Water
) -> NDArray[np.float64]:
    """Int f <zeta d + s zeta^2 / 2> dl, the water above z = 0 whose place the hull takes.

    At height z the hull's side has moved outwards by d + s z, d = X . N - s X_z with the flare s.
    """
    points = line.points
    # Extrapolated from two points off the hull, between which the panels are smooth.
    near, far = (flow.elevation(points.at_m + points.normals * gap) for gap in flow.gaps_m)
    raised = 2 * near - far
    moved = _displacement(motion, points.at_m - hull.reference_m)
    outward = (moved * points.normals).sum(axis=1) - line.flare * moved[:, 2]
    mean = (raised * outward.conj()).real / 2 + line.flare * np.abs(raised) ** 2 / 4
    return _arms(points.at_m, hull.reference_m) @ (mean * points.weights)


def submerged_moments(hull: WettedHull, motion: NDArray[np.complex128]) -> NDArray[np.float64]:
    """Means of the second order of Int f dV over the part of the moving hull below z = 0, f = 1, y, -x.

    x and y are those of space, from the hull's reference point at rest. The hull turns by yaw, then pitch,
    then roll: R = R_z R_y R_x. The plane z = 0 is h = -X_z above the water plane of the hull, where X is the
    displacement, and by (roll^2 + pitch^2) / 2 times the height of the water plane over the reference point
    in the second order.
    """
    found = particulars(hull.panels.surface)
    reference, plane = hull.reference_m, found.waterplane
    surge, sway, _, roll, pitch, yaw = motion

    def mean(a: complex, b: complex) -> float:
        return float((a * b.conjugate()).real) / 2

    x, y, z = found.centre_of_buoyancy_m - reference
    turned_y = -(mean(yaw, yaw) + mean(roll, roll)) / 2 * y + mean(pitch, yaw) * z
    turned_x = (
        -(mean(yaw, yaw) + mean(pitch, pitch)) / 2 * x + mean(pitch, roll) * y + mean(yaw, roll) * z
    )
    total = found.volume_m3 * np.array([0.0, turned_y, -turned_x])
    # Moments of the water plane about the reference point.
    area, (sx, sy) = plane.area_m2, plane.first_moments_m3 - plane.area_m2 * reference[:2]
    xx, xy, yy = plane.second_moments_m4
    x0, y0 = reference[:2]
    first, second = np.array([area, sx, sy]), np.array([
        [sx, xx - x0 * (2 * sx + x0 * area), xy - x0 * sy - y0 * sx - x0 * y0 * area],
        [sy, xy - x0 * sy - y0 * sx - x0 * y0 * area, yy - y0 * (2 * sy + y0 * area)],
    ])  # fmt: skip
    # h = rise . (1, x, y), and the displacement of the water plane's points, aside . (1, x, y).
    up = -reference[2]
    rise = np.array([-motion[2], pitch, -roll])
    aside = {1: np.array([sway - roll * up, yaw, 0]), 0: np.array([surge + pitch * up, 0, -yaw])}
    moments = np.stack([first, *second])
    products = {axis: (np.outer(rise, way.conj()).real / 2 * moments).sum() for axis, way in aside.items()}
    total += np.array([0.0, products[1], -products[0]])
    total += (mean(roll, roll) + mean(pitch, pitch)) / 2 * up * np.array([area, sy, -sx])
    line = waterline(hull.panels)
    points = line.points
    height = np.abs(_displacement(motion, points.at_m - reference)[:, 2]) ** 2
    return total + _arms(points.at_m, reference) @ (line.flare * height * points.weights / 4)


class _Flow:
    """First-order potential and velocity anywhere in the water, from those on the panels.

    Green's identity: phi = Int (phi_n G - phi dG/dn) dS. The dipoles of a panel are two sheets of sources on
    either side of it, so that their velocity needs no second derivatives of G.
    """

    def __init__(self, waves: FirstOrder) -> None:
        module = capytaine()
        self.waves = waves
        self.green = finite_depth.green_function(module)
        corners = np.concatenate([hull.panels.vertices[hull.panels.faces] for hull in waves.hulls])
        faces = np.concatenate([hull.panels.faces for hull in waves.hulls])
        numbered = np.arange(4 * len(faces)).reshape(-1, 4)
        numbered[faces[:, 2] == faces[:, 3], 3] -= 1
        shape = capytaine_mesh(module, Panels(corners.reshape(-1, 3), numbered), ())
        size = np.sqrt(shape.faces_areas)
        self.gaps_m = 0.4 * float(size.min()), 0.8 * float(size.min())
        nudge = NUDGE * size[:, None] * shape.faces_normals
        self.sheets = [
            capytaine_mesh(module, Panels((corners + sign * nudge[:, None]).reshape(-1, 3), numbered), ())
            for sign in (1, -1)
        ]
        dipoles = waves.potential / (2 * NUDGE * size)
        self.strengths = [waves.normal_velocity / 2 - dipoles, waves.normal_velocity / 2 + dipoles]

    def at(self, points: NDArray[np.float64]) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
        """Potential and velocity, with those of the incident wave."""
        waves = self.waves
        potential, velocity = _incident(points, waves.frequency_rad_s, waves.direction_rad, waves.water)
        k = wave_number(waves.frequency_rad_s, waves.water)
        depth = np.inf if waves.water.depth_m is None else waves.water.depth_m
        settings = {"free_surface": 0.0, "water_depth": depth, "wavenumber": k, "early_dot_product": False,
                    "adjoint_double_layer": True, "diagonal_term_in_double_layer": False}  # fmt: skip
        for some in np.array_split(np.arange(len(points)), -(-len(points) // POINTS_AT_ONCE)):
            for sheet, strength in zip(self.sheets, self.strengths, strict=True):
                single, slopes = self.green.evaluate(points[some], sheet, **settings)
                potential[some] += single @ strength
                velocity[some] += (slopes @ strength).T if slopes.shape[0] == 3 else slopes @ strength
        return potential, velocity

    def elevation(self, points: NDArray[np.float64]) -> NDArray[np.complex128]:
        """Elevation of the free surface, i w phi / g."""
        waves = self.waves
        return 1j * waves.frequency_rad_s / waves.water.gravity_m_s2 * self.at(points)[0]


def _incident(
    points: NDArray[np.float64], frequency: float, direction: float, water: Water
) -> tuple[NDArray[Any], NDArray[Any]]:
    """Potential and velocity of a wave of 1 m."""
    k = wave_number(frequency, water)
    ahead = np.array([np.cos(direction), np.sin(direction)])
    height, slope = decay(k, points[:, 2], water)
    phase = -1j * water.gravity_m_s2 / frequency * np.exp(1j * k * points[:, :2] @ ahead)
    level = 1j * k * height * phase
    return height * phase, np.stack([ahead[0] * level, ahead[1] * level, slope * phase], axis=1)


def _displacement(motion: NDArray[np.complex128], arms: NDArray[np.float64]) -> NDArray[np.complex128]:
    return motion[:3] + np.cross(motion[3:], arms)


def _arms(points: NDArray[np.float64], reference: NDArray[np.float64]) -> NDArray[np.float64]:
    """f = 1, y, -x at points, from the reference point, shape (3, points)."""
    x, y, _ = (points - reference).T
    return np.stack([np.ones_like(x), y, -x])


def _extent(corners: NDArray[np.float64]) -> float:
    """Square root of the area of an outline."""
    x, y = corners.T
    return float(np.abs(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2) ** 0.5

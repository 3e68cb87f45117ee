"""First-order flow in regular waves anywhere in the water, from the potentials on the panels of all hulls."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from . import finite_depth
from .airy import decay, wave_number
from .panels import Panels
from .solve import capytaine, capytaine_mesh

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .database import Water

    Potential = NDArray[np.complex128]
    Velocity = NDArray[np.complex128]

NUDGE = 0.03
"""Half the distance of the two sheets of sources that make a dipole panel, in panel sizes.

Steps in Capytaine's tables and in its approximation of distant panels appear in the velocities divided by
it: at 0.03, 95 % of the velocities near a hemisphere of 324 panels are within 0.2 % of a wave's. The error of
the sheets themselves is 0.1 % one panel away from them."""
POINTS_AT_ONCE = 300
"""Number of points for which the influence of all panels is held in memory."""


@dataclass(frozen=True)
class WettedHull:
    """The whole wetted hull at rest, without planes of symmetry.

    Attributes
    ----------
    panels
        In the order of the potentials, counter-clockwise seen from the water.
    reference_m
        Point of the hull to which its motions refer.
    """

    panels: Panels
    reference_m: NDArray[np.float64]


@dataclass(frozen=True)
class FirstOrder:
    """First-order solutions for regular waves of 1 m of one frequency, with exp(-i w t).

    Attributes
    ----------
    hulls
        All hulls in the water.
    directions_rad
        Directions towards which the waves travel.
    potential, normal_velocity
        Sum of the radiated and the diffracted potential, without the incident one, on the panels of all
        hulls, and its derivative along the outward normal; shape (directions, panels).
    motions
        Motions of each hull, shape (directions, hulls, 6), m and rad.
    """

    hulls: Sequence[WettedHull]
    water: Water
    frequency_rad_s: float
    directions_rad: NDArray[np.float64]
    potential: Potential
    normal_velocity: NDArray[np.complex128]
    motions: NDArray[np.complex128]


def first_order(
    hulls: Sequence[WettedHull],
    water: Water,
    frequency_rad_s: float,
    directions_rad: NDArray[np.float64],
    radiated: Potential,
    diffracted: Potential,
    motions: NDArray[np.complex128],
) -> FirstOrder:
    """Sum the potentials of the motions of all hulls and of the diffracted waves.

    Parameters
    ----------
    radiated
        Potentials for a motion of 1 m or 1 rad of each hull, shape (hulls, 6, panels of all hulls).
    diffracted
        Potentials of the waves diffracted by the held hulls, without the incident waves of 1 m, shape
        (directions, panels of all hulls).
    motions
        As in `FirstOrder`.
    """
    meshes = [capytaine_mesh(capytaine(), hull.panels, ()) for hull in hulls]
    owner = np.repeat(np.arange(len(hulls)), [len(hull.panels.faces) for hull in hulls])
    normals, at = (
        np.concatenate([getattr(mesh, name) for mesh in meshes])
        for name in ("faces_normals", "faces_centers")
    )
    arms = at - np.array([hull.reference_m for hull in hulls])[owner]
    moved = motions[:, owner, :3] + np.cross(motions[:, owner, 3:], arms)
    incident = np.array([incident_wave(at, frequency_rad_s, way, water)[1] for way in directions_rad])
    velocity = ((-1j * frequency_rad_s * moved - incident) * normals).sum(axis=2)
    potential = diffracted + np.tensordot(motions, radiated, 2)
    return FirstOrder(hulls, water, frequency_rad_s, directions_rad, potential, velocity, motions)


def incident_wave(
    points: NDArray[np.float64], frequency: float, direction: float, water: Water
) -> tuple[Potential, Velocity]:
    """Potential and velocity of a wave of 1 m."""
    k = wave_number(frequency, water)
    ahead = np.array([np.cos(direction), np.sin(direction)])
    height, slope = decay(k, points[:, 2], water)
    phase = -1j * water.gravity_m_s2 / frequency * np.exp(1j * k * points[:, :2] @ ahead)
    level = 1j * k * height * phase
    return height * phase, np.stack([ahead[0] * level, ahead[1] * level, slope * phase], axis=1)


class Flow:
    """Potential and velocity by Green's identity, phi = Int (phi_n G - phi dG/dn) dS.

    A panel's dipoles are two sheets of sources on either side of it: their velocity needs no second
    derivatives of G.
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
        nudge = NUDGE * size[:, None] * shape.faces_normals
        self.sheets = [
            capytaine_mesh(module, Panels((corners + sign * nudge[:, None]).reshape(-1, 3), numbered), ())
            for sign in (1, -1)
        ]
        dipoles = waves.potential / (2 * NUDGE * size)
        self.strengths = [(waves.normal_velocity / 2 + sign * dipoles).T for sign in (-1, 1)]

    def at(self, points: NDArray[np.float64]) -> tuple[Potential, Velocity]:
        """Potential and velocity with those of the incident waves, shapes (directions, points) and
        (directions, points, 3)."""
        waves = self.waves
        frequency, water = waves.frequency_rad_s, waves.water
        incident = [incident_wave(points, frequency, way, water) for way in waves.directions_rad]
        potential, velocity = (np.array(parts) for parts in zip(*incident, strict=True))
        depth = np.inf if water.depth_m is None else water.depth_m
        settings = {
            "free_surface": 0.0, "water_depth": depth, "wavenumber": wave_number(frequency, water),
            "early_dot_product": False, "adjoint_double_layer": True, "diagonal_term_in_double_layer": False,
        }  # fmt: skip
        for some in np.array_split(np.arange(len(points)), -(-len(points) // POINTS_AT_ONCE)):
            for sheet, strength in zip(self.sheets, self.strengths, strict=True):
                # The slopes have the shape (3, points, panels).
                single, slopes = self.green.evaluate(points[some], sheet, **settings)
                potential[:, some] += (single @ strength).T
                velocity[:, some] += (slopes @ strength).transpose(2, 1, 0)
        return potential, velocity

    def elevation(self, points: NDArray[np.float64]) -> Potential:
        """Elevation of the free surface, i w phi / g, shape (directions, points)."""
        waves = self.waves
        return 1j * waves.frequency_rad_s / waves.water.gravity_m_s2 * self.at(points)[0]

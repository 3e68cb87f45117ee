"""Small hydrodynamic databases from closed forms and tables, for the tests."""

from __future__ import annotations

import numpy as np
from kingpost.hydro.database import Database, Hull, Provenance, Water, Waterplane

# A. Hulme, "The wave forces acting on a floating hemisphere undergoing forced periodic oscillations",
# Journal of Fluid Mechanics 121 (1982), heave: k a, A / (2/3 pi rho a^3), B / (2/3 pi rho a^3 omega).
HULME = np.array([
    [0.1, 0.8627, 0.1816], [0.2, 0.7938, 0.2793], [0.3, 0.7157, 0.3254], [0.4, 0.6452, 0.3410],
    [0.5, 0.5861, 0.3391], [0.6, 0.5381, 0.3271], [0.8, 0.4698, 0.2899], [1.0, 0.4284, 0.2484],
    [1.2, 0.4047, 0.2096], [1.6, 0.3871, 0.1469], [2.0, 0.3884, 0.1031], [3.0, 0.4111, 0.0452],
    [4.0, 0.4322, 0.0219], [6.0, 0.4574, 0.0066], [10.0, 0.4771, 0.0012],
])  # fmt: skip
HULME_INFINITE = 0.5


def hemisphere_hull(radius_m: float) -> Hull:
    """A floating hemisphere: V = 2/3 pi a^3, centre of buoyancy 3/8 a below the water."""
    inertia = np.pi * radius_m**4 / 4
    return Hull(
        draught_m=radius_m,
        length_m=2 * radius_m,
        beam_m=2 * radius_m,
        volume_m3=2 / 3 * np.pi * radius_m**3,
        centre_of_buoyancy_m=np.array([0.0, 0.0, -3 / 8 * radius_m]),
        waterplane=Waterplane(np.pi * radius_m**2, np.zeros(2), np.array([inertia, 0.0, inertia])),
    )


def database(frequencies, added_mass, damping, added_mass_infinite, **others) -> Database:
    """A database of a hemisphere of 5 m with these coefficients, without excitation unless given."""
    none = np.zeros((len(frequencies), 4, 6), complex)
    fields = {
        "title": "sample",
        "provenance": Provenance("tests", "closed form", "sample"),
        "water": Water(1000.0, 9.81, None),
        "hull": hemisphere_hull(5.0),
        "wave_directions_rad": 0.5 * np.pi * np.arange(4),
        "froude_krylov": none,
        "diffraction": none,
        **others,
    }
    return Database(
        frequencies_rad_s=np.asarray(frequencies, float),
        added_mass=added_mass,
        radiation_damping=damping,
        added_mass_infinite=added_mass_infinite,
        **fields,
    )


def floating_hemisphere() -> Database:
    """Hulme's hemisphere, radius 5 m, rho 1000, heave only."""
    mass = 1000.0 * 2 / 3 * np.pi * 5.0**3
    frequencies = np.sqrt(HULME[:, 0] * 9.81 / 5.0)
    added_mass, damping = np.zeros((2, len(HULME), 6, 6))
    infinite = np.zeros((6, 6))
    added_mass[:, 2, 2] = mass * HULME[:, 1]
    damping[:, 2, 2] = mass * frequencies * HULME[:, 2]
    infinite[2, 2] = mass * HULME_INFINITE
    return database(frequencies, added_mass, damping, infinite)


def memory_of_bandpasses(omega: np.ndarray) -> np.ndarray:
    """K(j omega) of a positive real rational matrix with K(0) = 0 for surge, heave and pitch, and sway alone.

    A sum of band passes w s / (s^2 + 2 z w s + w^2), each positive real and zero at 0, times positive
    definite matrices: nine poles of one group, two of the other.
    """
    s = 1j * np.asarray(omega)
    group, found = np.ix_([0, 2, 4], [0, 2, 4]), np.zeros((len(omega), 6, 6), complex)
    levers = np.array([1.0, 1.0, 5.0])
    root = np.array([[1.0, 0.2, -0.4], [0.1, 1.5, 0.3], [0.5, -0.2, 0.8]])
    for k, (natural, damping) in enumerate([(0.7, 0.4), (1.1, 0.3), (1.6, 0.5), (2.2, 0.35)]):
        turned = np.roll(root, k, axis=0) * levers
        gain = 1e5 * turned.T @ turned
        function = natural * s / (s**2 + 2 * damping * natural * s + natural**2)
        found[(slice(None), *group)] += gain * function[:, None, None]
    found[:, 1, 1] = 2e5 * s / ((s + 0.5) * (s + 2.0))
    return found


def decay_by_convolution(kernel, mass, stiffness, step):
    """Heave from 1 m at rest by M z'' + integral_0^t k(t - s) z'(s) ds + C z = 0.

    Average acceleration and trapezoids, with the memory as it is: no states, no fit.

    Parameters
    ----------
    kernel
        k at 0, step, 2 step, ..., kg/s2.
    mass
        M = m + A_inf, kg.
    stiffness
        C = rho g S, N/m.
    """
    position, velocity, acceleration = np.zeros((3, len(kernel)))
    position[0], acceleration[0] = 1.0, -stiffness / mass
    for i in range(len(kernel) - 1):
        past = step * (kernel[1 : i + 2][::-1] @ velocity[: i + 1] - 0.5 * kernel[i + 1] * velocity[0])
        ahead_velocity = velocity[i] + 0.5 * step * acceleration[i]
        ahead_position = position[i] + step * velocity[i] + 0.25 * step**2 * acceleration[i]
        whole = mass + 0.25 * step**2 * kernel[0] + 0.25 * step**2 * stiffness
        force = -stiffness * ahead_position - past - 0.5 * step * kernel[0] * ahead_velocity
        acceleration[i + 1] = force / whole
        velocity[i + 1] = ahead_velocity + 0.5 * step * acceleration[i + 1]
        position[i + 1] = ahead_position + 0.25 * step**2 * acceleration[i + 1]
    return position

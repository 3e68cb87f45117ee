"""Mean drift of a floating hull in regular waves, from the waves that it radiates and scatters.

H. Maruo, The drift of a body floating on waves, J. Ship Research 4(3), 1960; J. N. Newman, The drift force
and moment on ships in waves, J. Ship Research 11(1), 1967. Far from the hull the elevation is that of the
incident wave of amplitude a and of a ring wave,
a (exp(i k R cos(t - b)) + f(t) exp(i k R) / sqrt(R)). The hull receives the momentum and the angular momentum
lost by these two waves.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import TYPE_CHECKING

import numpy as np

from ..errors import HydrodynamicsError
from .airy import group_ratio, wave_number
from .attitude import placed, rotation
from .database import DriftLoading
from .symmetry import whole_circle

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from .database import Database, Hull, Water
    from .far_field import FarField

HORIZONTAL = [0, 1, 5]
RADII = ("roll_gyration_m", "pitch_gyration_m", "yaw_gyration_m")
ROUNDING = 1e-6
"""Tolerance of a radius: for a flat body the largest moment is the sum of the other two."""


@dataclass(frozen=True)
class Loading:
    """Loading of the hull, which determines its motion and thus its mean drift.

    Attributes
    ----------
    kg_m
        Height of the centre of gravity above the keel along the hull's z, m. The centre of gravity is
        vertically above the centre of buoyancy, also for an inclined hull.
    roll_gyration_m, pitch_gyration_m, yaw_gyration_m
        Radii of gyration about the centre of gravity, m.
    roll_damping_ratio
        Added viscous roll damping over the critical damping.
    """

    kg_m: float
    roll_gyration_m: float
    pitch_gyration_m: float
    yaw_gyration_m: float
    roll_damping_ratio: float = 0.05

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            least = 0.0 if field.name == "roll_damping_ratio" else np.nextafter(0, 1)
            if not least <= value < np.inf:
                raise HydrodynamicsError(f"--loading {field.name}", f"{value:g}", "a number greater than 0")
        radii = {name: getattr(self, name) for name in RADII}
        name = max(radii, key=lambda one: radii[one])
        most = np.sqrt(sum(radius**2 for one, radius in radii.items() if one != name))
        if radii[name] > most * (1 + ROUNDING):
            raise HydrodynamicsError(
                f"--loading {name}", f"{radii[name]:g}",
                f"at most {most:.6g}: no moment of inertia is greater than the sum of the other two",
            )  # fmt: skip

    @property
    def note(self) -> str:
        """Note on the loading for the database."""
        radii = (self.roll_gyration_m, self.pitch_gyration_m, self.yaw_gyration_m)
        return (
            f"mean drift of the hull free to move, its centre of gravity {self.kg_m:g} m above the keel, "
            f"radii of gyration {', '.join(f'{radius:g}' for radius in radii)} m, added roll damping of "
            f"{self.roll_damping_ratio:g} of the critical"
        )


def stored(loading: Loading, hull: Hull, water: Water) -> DriftLoading:
    """The loading as the database stores it."""
    radii = np.array([loading.roll_gyration_m, loading.pitch_gyration_m, loading.yaw_gyration_m])
    mass = water.density_kg_m3 * hull.volume_m3
    return DriftLoading(mass, loading.kg_m, radii, loading.roll_damping_ratio)


def mass_matrix(hull: Hull, water: Water, loading: Loading) -> NDArray[np.float64]:
    """Mass matrix of the hull about the database's origin, in the axes of the coefficients.

    Parameters
    ----------
    hull
        The hull from `build.standing`, here and in the other functions.
    """
    mass = water.density_kg_m3 * hull.volume_m3
    x, y, z = _centre_of_gravity(hull, loading)
    arm = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    radii = np.array([loading.roll_gyration_m, loading.pitch_gyration_m, loading.yaw_gyration_m])
    turn = _turn(hull)
    inertia = turn @ np.diag(radii**2) @ turn.T - arm @ arm
    return mass * np.block([[np.eye(3), -arm], [arm, inertia]])


def stiffness_matrix(hull: Hull, water: Water, loading: Loading) -> NDArray[np.float64]:
    """Restoring matrix about the origin; weight and buoyancy are on one vertical line.

    Raises
    ------
    HydrodynamicsError
        If the metacentric height is not positive: such a hull would capsize.
    """
    unit = water.density_kg_m3 * water.gravity_m_s2
    plane = hull.waterplane
    height = hull.volume_m3 * (hull.centre_of_buoyancy_m[2] - _centre_of_gravity(hull, loading)[2])
    (sx, sy), (sxx, sxy, syy) = plane.first_moments_m3, plane.second_moments_m4
    stiffness = np.zeros((6, 6))
    stiffness[2:5, 2:5] = unit * np.array([
        [plane.area_m2, sy, -sx],
        [sy, syy + height, -sxy],
        [-sx, -sxy, sxx + height],
    ])  # fmt: skip
    lowest = (syy - sy**2 / plane.area_m2 + height) / hull.volume_m3
    if lowest <= 0:
        # Along the hull's z, which is inclined to the vertical.
        most = loading.kg_m + lowest * _turn(hull)[2, 2]
        how = "as it is" if hull.attitude else "upright"
        allowed = f"less than {most:.4g} m, so that the hull stays {how}"
        raise HydrodynamicsError("--loading kg_m", f"{loading.kg_m:g}", allowed)
    return stiffness


def _centre_of_gravity(hull: Hull, loading: Loading) -> NDArray[np.float64]:
    """Centre of gravity on the vertical through the centre of buoyancy, KG above the keel along the hull's z.

    Of c = R r + (0, 0, h), with r_z = KG - T, the horizontal part is that of the centre of buoyancy.
    """
    x, y, _ = hull.centre_of_buoyancy_m
    height = loading.kg_m - hull.draught_m
    if hull.attitude is None:
        return np.array([x, y, height])
    turn = _turn(hull)
    aside = np.linalg.solve(turn[:2, :2], [x, y] - turn[:2, 2] * height)
    return placed(np.array([*aside, height]), hull.attitude)


def _turn(hull: Hull) -> NDArray[np.float64]:
    """From the hull's axes to those of the coefficients."""
    at = hull.attitude
    return np.eye(3) if at is None else rotation(at.roll_rad, at.pitch_rad)


def motions(database: Database, loading: Loading) -> NDArray[np.complex128]:
    """Motions q per metre of amplitude, shape (frequencies, directions, 6).

    (-w^2 (M + A) - i w B + C) q = X, for exp(-i w t), about the database's origin.
    """
    mass = mass_matrix(database.hull, database.water, loading)
    stiffness = stiffness_matrix(database.hull, database.water, loading)
    w = database.frequencies_rad_s[:, None, None]
    damping = database.radiation_damping.copy()
    inertia = mass + database.added_mass
    # Critical damping for roll about the axis on the water plane above the centre of gravity, which may
    # differ from the origin.
    roll = np.array([0.0, 0.0, -database.hull.centre_of_buoyancy_m[1], 1.0, 0.0, 0.0])
    critical = 2 * np.sqrt((roll @ inertia @ roll) * (roll @ stiffness @ roll))
    damping[:, 3, 3] += loading.roll_damping_ratio * critical
    impedance = -(w**2) * inertia - 1j * w * damping + stiffness
    return np.linalg.solve(impedance[:, None], database.excitation[..., None])[..., 0]


def drift(
    database: Database, far_field: FarField, loading: Loading, reflections: Sequence[int]
) -> NDArray[np.float64]:
    """Surge force, sway force and yaw moment per amplitude squared, shape (frequencies, directions, 3)."""
    water, count = database.water, len(database.wave_directions_rad)
    chosen = far_field.directions
    moved = motions(database, loading)[:, chosen]
    amplitudes = far_field.scattered + moved @ far_field.radiated
    angles = amplitudes.shape[2]
    found = np.zeros((len(amplitudes), len(chosen), 6))
    for n, frequency in enumerate(database.frequencies_rad_s):
        k, ratio = wave_number(frequency, water), group_ratio(frequency, water)
        for d, direction in enumerate(chosen):
            at = direction * angles // count
            found[n, d, HORIZONTAL] = mean_drift(amplitudes[n, d], at, k, ratio, water)
    return whole_circle(found, chosen, count, reflections)[:, :, HORIZONTAL]


def mean_drift(
    amplitude: NDArray[np.complex128], at: int, wave_number: float, group_ratio: float, water: Water
) -> NDArray[np.float64]:
    """Surge force, sway force and yaw moment per amplitude squared, in one regular wave.

    With E = rho g n / 2, n = c_g / c and the extinction s = -2 sqrt(2 pi / k) Re(f(b) exp(i pi / 4)):
    (F_x, F_y) = E (s (cos b, sin b) - Int abs(f)^2 (cos t, sin t) dt) and
    M_z = -(E / k) (Int Im(f* f') dt + 2 sqrt(2 pi / k) Im(f'(b) exp(i pi / 4))).

    Parameters
    ----------
    amplitude
        f at equally spaced angles of the whole circle, m^(1/2).
    at
        Index of the wave's direction b among the angles.
    """
    count = len(amplitude)
    angles = 2 * np.pi * np.arange(count) / count
    orders = np.fft.fftfreq(count, 1 / count)
    slope = np.fft.ifft(1j * orders * np.fft.fft(amplitude))
    step, turn = 2 * np.pi / count, np.exp(1j * np.pi / 4)
    beam = 2 * np.sqrt(2 * np.pi / wave_number)
    lost = -beam * (amplitude[at] * turn).real
    ring = np.abs(amplitude) ** 2 * step
    energy = water.density_kg_m3 * water.gravity_m_s2 * group_ratio / 2
    surge = lost * np.cos(angles[at]) - ring @ np.cos(angles)
    sway = lost * np.sin(angles[at]) - ring @ np.sin(angles)
    spin = (amplitude.conj() * slope).imag.sum() * step + beam * (slope[at] * turn).imag
    return energy * np.array([surge, sway, -spin / wave_number])

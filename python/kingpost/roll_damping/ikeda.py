"""Ikeda's method: the roll damping of a hull as the sum of friction, eddies, lift and bilge keels."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import RollDampingError
from .bilge_keels import BilgeKeels, bilge_keel_damping
from .coefficients import Coefficients, fitted
from .eddies import SHARPNESS, eddy_coefficient
from .friction import friction_damping, lift_damping
from .sections import Sections

if TYPE_CHECKING:
    import xarray

    from .sections import Array

COMPONENTS = ("friction", "eddies", "lift", "bilge_keel_force", "bilge_keel_pressure")
AMPLITUDES_DEG = (2.5, 5.0, 7.5, 10.0, 12.5, 15.0)
LARGEST_DEG = 60.0
# Ratio of the eddies by the two measures of sharpness above which there is a warning.
UNSURE = 1.25
ALLOWED = {"period_s": (0.1, 1e4), "density_kg_m3": (1.0, 1e5), "viscosity_m2_s": (1e-9, 1.0)}
"""Allowed ranges, wider than for any ship and liquid; the upper bound of KG is the length of the hull."""
LARGEST_M_S = 100.0
"""Largest forward speed, m/s: higher than for any ship."""
SEA_WATER_KG_M3 = 1025.0
SEA_WATER_M2_S = 1.19e-6
"""Kinematic viscosity of sea water at 15 degrees C (ITTC 7.5-02-01-03); fresh water has 1.14e-6."""


def from_sections(
    sections: Sections,
    keel_to_gravity_m: float,
    period_s: float,
    amplitudes_rad: Sequence[float] | Array | None = None,
    bilge_keels: BilgeKeels | None = None,
    speed_m_s: float = 0.0,
    density_kg_m3: float = SEA_WATER_KG_M3,
    viscosity_m2_s: float = SEA_WATER_M2_S,
    sharpness: str = "radius",
) -> xarray.Dataset:
    """Equivalent linear roll damping of a hull by Ikeda's method, without radiation damping.

    Radiation damping comes from potential theory: the hydrodynamic database of a scenario contains it, so it
    is not counted twice. The roll axis goes through the centre of gravity.

    Parameters
    ----------
    sections
        The hull: `Sections.read` of a table, or `sections_of` a mesh.
    keel_to_gravity_m
        KG, above the lowest point of the sections.
    period_s
        Roll period, usually the natural period.
    amplitudes_rad
        Roll amplitudes; default: 2.5, 5, ... 15 degrees.
    bilge_keels
        A pair of bilge keels, or `None`.
    speed_m_s
        Forward speed: at rest there is no lift.
    density_kg_m3, viscosity_m2_s
        Density and kinematic viscosity of the water.
    sharpness
        Measure of the sharpness of bilges in the eddies: their ``radius``, or the ``area`` of the section, as
        the formula is printed (`eddies.sharpness`).

    Returns
    -------
    xarray.Dataset
        ``damping`` by component and amplitude and their ``total``, N m s; ``linear`` and ``quadratic``, N m s
        and N m s^2, the non-negative coefficients with the best fit (relative least squares), and ``fitted``,
        their equivalent damping. The attribute ``warning`` is present if the eddies depend strongly on the
        measure of sharpness.

    Raises
    ------
    RollDampingError
        If a number is outside the range of ships.

    >>> barge = Sections.of_table({"x_m": [0, 50, 100], "beam_m": [20] * 3, "draught_m": [5] * 3,
    ...     "area_coefficient": [0.98] * 3})
    >>> found = from_sections(barge, keel_to_gravity_m=6, period_s=10, bilge_keels=BilgeKeels(0.4, 40))
    >>> float(found.damping.sel(component="lift").max())
    0.0
    >>> bool((found.fitted / found.total - 1 < 0.05).all())
    True
    """
    amplitudes = _amplitudes(amplitudes_rad)
    given = {"keel_to_gravity_m": keel_to_gravity_m, "period_s": period_s, "density_kg_m3": density_kg_m3,
             "viscosity_m2_s": viscosity_m2_s}  # fmt: skip
    allowed = {"keel_to_gravity_m": (0.0, float(np.ptp(sections.x_m)))} | ALLOWED
    for name, value in given.items():
        lower, upper = allowed[name]
        if not (lower <= value <= upper and value > 0):
            words = f"{lower:g} to {upper:g}" if lower else f"a number greater than 0, up to {upper:g}"
            raise RollDampingError(name, f"{value:g}", words)
    if not 0 <= speed_m_s <= LARGEST_M_S:
        raise RollDampingError("speed_m_s", f"{speed_m_s:g}", f"0 to {LARGEST_M_S:g}")
    frequency = 2 * math.pi / period_s
    depth = float(sections.draught_m.max()) - keel_to_gravity_m
    friction = friction_damping(sections, depth, frequency, density_kg_m3, viscosity_m2_s, speed_m_s)
    lift = lift_damping(sections, depth, density_kg_m3, speed_m_s)
    eddies = eddy_drag(sections, depth, density_kg_m3, sharpness) * _slowed(frequency, sections, speed_m_s)
    keels = np.zeros((2, len(amplitudes)))
    if bilge_keels is not None:
        of_keels = [
            bilge_keel_damping(sections, bilge_keels, depth, frequency, amplitude, density_kg_m3)
            for amplitude in amplitudes
        ]
        keels = np.array(of_keels).T
    flat = np.ones_like(amplitudes)
    naked = [friction * flat, Coefficients(0.0, eddies).equivalent(frequency, amplitudes), lift * flat]
    about: dict[str, Any] = given | {
        "speed_m_s": speed_m_s,
        "frequency_rad_s": frequency,
        "sharpness": sharpness,
    }
    if warning := _of_sharpness(sections, depth):
        about["warning"] = warning
    return _dataset(amplitudes, np.array([*naked, *keels]), about)


def eddy_drag(
    sections: Sections, axis_depth_m: float, density_kg_m3: float, sharpness: str = "radius"
) -> float:
    """The quadratic coefficient, N m s^2, of the eddies of the naked hull at rest:
    the sum of rho d^4 C_R dx / 2, `eddies.eddy_coefficient`."""
    if sharpness not in SHARPNESS:
        raise RollDampingError("sharpness", repr(sharpness), " or ".join(SHARPNESS))
    per_metre = sections.draught_m**4 * eddy_coefficient(sections, axis_depth_m, sharpness)
    return float(density_kg_m3 / 2 * per_metre @ sections.length_m)


def _of_sharpness(sections: Sections, axis_depth_m: float) -> str:
    """Return a warning if the eddies by the area differ much from those by the bilge radius; otherwise an
    empty text."""
    radius, area = (eddy_drag(sections, axis_depth_m, 1.0, by) for by in SHARPNESS)
    if max(radius, area) <= UNSURE * min(radius, area):
        return ""
    return (
        "very full sections: the eddies depend on the sharpness of the bilges. By the area, as the formula "
        f"is printed, they are {area / radius:.2g} times those by the radius"
    )


def _slowed(frequency_rad_s: float, sections: Sections, speed_m_s: float) -> float:
    """Reduction of the eddies by forward speed: (0.04 K)^2 / (1 + (0.04 K)^2), K = omega L / U (ITTC
    7.5-02-07-04.5, 2021, eq. 45)."""
    if not speed_m_s:
        return 1.0
    square = (0.04 * frequency_rad_s * sections.total_length_m / speed_m_s) ** 2
    return square / (1 + square)


def _amplitudes(given: Sequence[float] | Array | None) -> Array:
    found = np.radians(AMPLITUDES_DEG) if given is None else np.sort(np.asarray(given, float).ravel())
    most = math.radians(LARGEST_DEG) * (1 + 1e-9)
    inside = np.isfinite(found) & (found > 0) & (found <= most)
    if not len(found) or not inside.all():
        shown = ", ".join(f"{value:g}" for value in found[~inside]) or "none"
        raise RollDampingError("amplitudes_rad", shown, f"numbers greater than 0, up to {most:.4g}")
    if (np.diff(found) == 0).any():
        twice = found[np.flatnonzero(np.diff(found) == 0)[0]]
        raise RollDampingError("amplitudes_rad", f"{twice:g} twice", "each amplitude once")
    return found


def _dataset(amplitudes: Array, damping: Array, about: dict[str, Any]) -> xarray.Dataset:
    import xarray

    total = damping.sum(axis=0)
    frequency = float(about["frequency_rad_s"])
    best = fitted(amplitudes, total, frequency)
    again = best.equivalent(frequency, amplitudes)
    moment, drag = {"units": "N m s"}, {"units": "N m s^2"}
    return xarray.Dataset(
        {
            "damping": (("component", "amplitude"), damping, moment),
            "total": ("amplitude", total, moment),
            "fitted": ("amplitude", np.broadcast_to(again, amplitudes.shape), moment),
            "linear": ((), best.linear, moment),
            "quadratic": ((), best.quadratic, drag),
        },
        {"component": list(COMPONENTS), "amplitude": ("amplitude", amplitudes, {"units": "rad"})},
        about,
    )

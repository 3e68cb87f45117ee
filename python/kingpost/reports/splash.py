"""Report on objects that are lowered through the splash zone."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from ..analysis.splash_zone import IMMERSIONS, LEAST_SLAMMING, splash_zone
from .tables import kilograms, significant, table

if TYPE_CHECKING:
    import xarray

    from ..scenario import Scenario

FORCES = {
    "F_static": "static_force",
    "F_slam": "slamming_force",
    "F_D": "drag_force",
    "F_M": "mass_force",
    "F_rho": "buoyancy_force",
    "F_hyd": "hydrodynamic_force",
}
NONE = "-"
SMALLEST_KN = 1e8
"""Scale of printed forces, kN: forces below 1e-12 of it, 0.1 N, print as 0; the object then only touches the
water."""
LEAST = "the least without tests or theory (DNV-RP-N103, sec. 4.3.5),"


def sections(scenario: Scenario) -> list[list[str]]:
    """Effective coefficients of each object and, in waves, its characteristic loads by DNV-RP-N103."""
    objects = scenario.model["objects_in_water"]
    if not objects:
        return []
    found = splash_zone(scenario)
    if found.attrs["wave_amplitude_m"] == 0:
        return [_coefficients(objects, found)]
    return [[*_coefficients(objects, found), *_low_slamming(objects, found)], _loads(objects, found)]


def _coefficients(objects: list[dict[str, Any]], found: xarray.Dataset) -> list[str]:
    """Added mass and drag areas along x, y and z, and the slamming coefficient of the upright object."""
    rows = [("lowered object", "body", "added mass x, y, z", "C_D A x, y, z", "C_S", "on")]
    for one, slamming in zip(objects, found.slamming_coefficient.values, strict=True):
        coefficient = float(slamming.max())
        added = ", ".join(kilograms(mass) for mass in one["added_mass_kg"])
        drag = ", ".join(f"{area:.4g}" for area in one["drag_areas_m2"])
        origin = "given" if one["slamming_is_given"] else "by dA/dh"
        rows.append(
            (one["name"], one["body"], added, f"{drag} m2", f"{coefficient:.3g} {origin}",
             f"{one['projected_area_m2']:.4g} m2")
        )  # fmt: skip
    return table(rows, "<<<<<<")


def _low_slamming(objects: list[dict[str, Any]], found: xarray.Dataset) -> list[str]:
    """Lines on each C_S below the smallest value of the recommended practice."""
    coefficients = found.slamming_coefficient.values.max(axis=1)
    return [
        f"{one['name']}: C_S {coefficient:.3g} is below {LEAST} {LEAST_SLAMMING[one['is_cylinder']]:g}"
        for one, coefficient in zip(objects, coefficients, strict=True)
        if 0 < coefficient < LEAST_SLAMMING[one["is_cylinder"]]
    ]


def _loads(objects: list[dict[str, Any]], found: xarray.Dataset) -> list[str]:
    """Table of the loads by the simplified method, kN."""
    attributes = found.attrs
    speed, amplitude = attributes["lowering_speed_m_s"], attributes["wave_amplitude_m"]
    title = (
        f"splash zone in kN by the simplified method of DNV-RP-N103: upright, lowered at {speed:g} m/s, "
        f"the crane tip still, wave amplitude {amplitude:.3g} m, "
        f"Tz {attributes['zero_up_crossing_period_s']:.3g} s"
    )
    rows = [("object", "", *FORCES, "F_hyd / 0.9 F_static")]
    for k, one in enumerate(objects):
        for j, immersion in enumerate(IMMERSIONS):
            at = found.isel(object=k, immersion=j)
            forces = [significant(float(at[name]) / 1e3, SMALLEST_KN) for name in FORCES.values()]
            share = float(at.slack_utilisation)
            slack = NONE if math.isnan(share) else f"{share:.2f}{' slack' if share > 1 else ''}"
            rows.append((one["name"] if j == 0 else "", immersion, *forces, slack))
    return [title, *table(rows, "<<" + ">" * len(FORCES) + "<")]

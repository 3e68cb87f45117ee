"""Report of floating hulls."""

from __future__ import annotations

from math import degrees
from typing import TYPE_CHECKING, Any

from .tables import fixed, table

if TYPE_CHECKING:
    from ..scenario import Scenario

# Loads that swing by less than this share of their length are not reported.
SMALLEST_SHARE = 0.005


def sections(scenario: Scenario) -> list[list[str]]:
    """Draught, heel, trim, stability and righting arms of each hull in the water, and warnings; nothing
    for a scenario without one.

    Raises
    ------
    KingpostError
        When a hull cannot float.
    """
    found = scenario.hydrostatics
    of_hull = (_hull, _hanging, _tanks, _arms)
    parts = [section(hull) for hull in found["hulls"] for section in of_hull]
    return [*parts, [f"warning: {words}" for words in found["warnings"]]]


def _hull(hull: dict[str, Any]) -> list[str]:
    """Report of one hull at rest in still water; heights are over the keel, along the hull's z."""

    def both(quantity: str) -> tuple[str, str]:
        across, along = hull[quantity]
        return _metres(across), f"{_metres(along)} lengthwise"

    across = 0
    tanks = bool(hull["free_surfaces"])
    fluid = "hanging loads at their suspension points" + ", free surfaces" * tanks
    solid = "hanging loads as if fixed" + ", liquids as if frozen" * tanks
    rows = [
        ("displacement", f"{hull['displacement_kg'] / 1000:.3f} t", f"{hull['displacement_m3']:.3f} m3"),
        ("mass afloat", f"{hull['mass_kg'] / 1000:.3f} t", ""),
        ("draught", f"{hull['draught_m']:.4f} m", f"the database's is {hull['database_draught_m']:g} m"),
        ("heel", *_angle(hull["heel_rad"], "to starboard", "to port")),
        ("trim", *_angle(hull["trim_rad"], "by the bow", "by the stern")),
        ("KB", _metres(hull["keel_to_buoyancy_m"]), ""),
        ("BM", *both("metacentric_radius_m")),
        ("KM", *both("keel_to_metacentre_m")),
        ("KG", _metres(hull["keel_to_gravity_m"]), ""),
        ("KG, fluid", _metres(hull["fluid_keel_to_gravity_m"][across]), fluid),
        ("GM, fluid", *both("metacentric_height_m")),
        ("GM, solid", _metres(hull["solid_metacentric_height_m"][across]), solid),
    ]
    rests = "its mesh" if hull["rests_by_mesh"] else "linear hydrostatics"
    shape = "its mesh" if hull["by_mesh"] else "its database's waterplane"
    how = rests if rests == shape else f"{rests}; displacement, KB and BM of {shape} there"
    return [f"{hull['body']} afloat at rest in still water, by {how}", *table(rows, "<><")]


def _angle(radians: float, positive: str, negative: str) -> tuple[str, str]:
    """Format the magnitude of an angle in degrees and its side; no side if it is zero."""
    size = f"{abs(degrees(radians)):.4f}"
    way = "" if float(size) == 0 else positive if radians > 0 else negative
    return f"{size} deg", way


def _metres(value: float) -> str:
    return f"{fixed(value, 3)} m"


def _hanging(hull: dict[str, Any]) -> list[str]:
    rows = [("hanging load", "joint", "mass", "below the joint", "free in heel", "in trim")]
    for load in hull["hanging"]:
        if max(load["free_share"]) < SMALLEST_SHARE:
            continue
        shares = (f"{100 * share:.0f} %" for share in load["free_share"])
        rows.append((load["body"], load["joint"], f"{load['mass_kg'] / 1000:g} t", _metres(load["length_m"]),
                     *shares))  # fmt: skip
    return table(rows, "<<>>>>") if len(rows) > 1 else []


def _tanks(hull: dict[str, Any]) -> list[str]:
    """Table of the tanks: liquid, its height, and the change of GM by the free surfaces."""
    surfaces = hull["free_surfaces"]
    if not surfaces:
        return []
    added = [[-surface["correction_m"][k] for surface in surfaces] for k in (0, 1)]
    rows = [("tank", "body", "liquid", "over the keel", "GM", "GM lengthwise")]
    for surface, across, along in zip(surfaces, *added, strict=True):
        liquid = f"{surface['liquid_kg'] / 1000:.3f} t"
        height = _metres(surface["keel_to_liquid_m"])
        rows.append((surface["force"], surface["body"], liquid, height, _metres(across), _metres(along)))
    of_all, along = (sum(one) for one in added)
    return [f"free surfaces: GM {_metres(of_all)}, {_metres(along)} lengthwise", *table(rows, "<<>>>>")]


def _arms(hull: dict[str, Any]) -> list[str]:
    """GZ at constant displacement, free to trim, to the side of the list."""
    curve = hull["righting_arm"]
    if curve is None:
        return []
    side, points = curve["side"], curve["points"]
    rows = [
        (f"heel to {side}, deg", *(f"{degrees(point['heel_rad']):.0f}" for point in points)),
        ("GZ, m", *(fixed(point["arm_m"], 3) for point in points)),
        ("trim by the bow, deg", *(fixed(degrees(point["trim_rad"]), 2) for point in points)),
    ]
    of_mesh = "" if hull["rests_by_mesh"] else " of the mesh"
    return [f"righting arms{of_mesh} to {side}: {_range(curve, hull['rests_by_mesh'])}", *table(rows)]


def _range(curve: dict[str, Any], rests_by_mesh: bool) -> str:
    """Text on the equilibrium (if it is that of the curve), the largest arm and the range of stability."""
    rest, vanishing = curve["equilibrium_rad"], curve["vanishing_rad"]
    if rest is None:
        return "no equilibrium up to 90 deg"
    top = curve["largest"]
    reach = (
        "positive beyond to 90 deg"
        if vanishing is None
        else f"vanishing at {degrees(vanishing):.1f} deg, a range of {degrees(vanishing - rest):.1f} deg"
    )
    equilibrium = f"equilibrium at {fixed(degrees(rest), 2)} deg, " if rests_by_mesh else ""
    return f"{equilibrium}largest GZ {_metres(top['arm_m'])} at {degrees(top['heel_rad']):.1f} deg, {reach}"

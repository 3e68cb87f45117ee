"""Bodies of a scenario, and the water on them."""

from __future__ import annotations

import math
from typing import Any

from .deck import VESSEL, ZERO, Body, Deck, Point, Vector

PLACEHOLDER_KG = 1.0
"""Mass of a held body without its own: it does not move."""
HELD = {"hold_translation": True, "hold_rotation": True}


def rotated(body: Body, place: Vector) -> Vector:
    """Position in the world of a point of a body."""
    from scipy.spatial.transform import Rotation

    roll, pitch, yaw = body.orientation_rad
    turned = Rotation.from_euler("ZYX", (yaw, pitch, roll)).apply(place)
    x, y, z = (float(start + part) for start, part in zip(body.position_m, turned, strict=True))
    return x, y, z


def body(one: Body, deck: Deck) -> dict[str, Any]:
    """Fields of a body of the deck."""
    fields: dict[str, Any] = {"mass_kg": one.mass_kg or PLACEHOLDER_KG}
    has_inertia = any(one.moments_kg_m2)
    if has_inertia:
        fields["inertia"] = {"tensor": {"moments_kg_m2": list(one.moments_kg_m2)}}
    else:
        fields["shape"] = {"point": {}}
    if one.centre_m != ZERO:
        fields["centre_of_mass_m"] = list(one.centre_m)
    fields["joint"] = _joint(one, has_inertia, deck)
    return fields


def _joint(one: Body, has_inertia: bool, deck: Deck) -> dict[str, Any]:
    place: dict[str, Any] = {"position_m": list(one.position_m)}
    if any(one.orientation_rad):
        place["orientation_rad"] = list(one.orientation_rad)
    if one.motion == "fixed":
        return {"fixed": place}
    if one.motion == "pinned" and has_inertia and one.mass_kg:
        return {"spherical": place}
    initial = {**place, "position_m": list(rotated(one, one.centre_m))}
    free = one.motion == "free" and one.mass_kg > 0
    if free:
        held = {} if has_inertia else {"hold_rotation": True}
        if not has_inertia:
            deck.notes.convert(one.line, one.name, "does not turn, because it has no moments of inertia")
        return {"floating": {**held, "initial": initial}}
    if one.motion in ("free", "pinned"):
        lacks = "moments of inertia" if one.mass_kg else "mass"
        why = f"is held in place, because it has no {lacks} of its own"
        deck.notes.leave_out(one.line, f"the motion of {one.name}", why)
    elif not one.mass_kg:
        ship = "the vessel of the coupled points" if one.name == VESSEL else one.name
        why = f"is held by its floating joint; its mass, {PLACEHOLDER_KG:g} kg, is a placeholder"
        deck.notes.convert(one.line, ship, why)
    return {"floating": {**HELD, "initial": initial}}


def point(one: Point, mass_kg: float) -> dict[str, Any]:
    """Fields of the body of a free point."""
    initial = {"position_m": list(one.position_m)}
    joint = {"floating": {"hold_rotation": True, "initial": initial}}
    return {"mass_kg": mass_kg, "shape": {"point": {}}, "joint": joint}


def clump_weight(one: Point) -> dict[str, Any]:
    """Field of the section that ends at a free point between two lines; none for a bare point."""
    if one.is_bare:
        return {}
    fields = {"mass_kg": one.mass_kg, "volume_m3": one.volume_m3}
    return {"clump_weight": {**fields, "drag_area_m2": one.drag_area_m2, "added_mass": one.added_mass}}


def water_on_point(one: Point, name: str, deck: Deck) -> dict[str, Any]:
    """Forces of the water on the body of a free point, by name."""
    areas = (one.drag_area_m2,) * 3
    return _water(name, one.line, one.volume_m3, areas, (one.added_mass,) * 3, deck)


def water_on_body(one: Body, deck: Deck) -> dict[str, Any]:
    """Forces of the water on a free body, by name."""
    if one.motion != "free" or not one.mass_kg:
        return {}
    return _water(one.name, one.line, one.volume_m3, one.drag_areas_m2, one.added_mass, deck)


def _water(
    name: str, line: int | None, volume: float, areas: Vector, added: Vector, deck: Deck
) -> dict[str, Any]:
    has_drag = any(areas)
    if volume:
        radius = (3 * volume / (4 * math.pi)) ** (1 / 3)
        fields: dict[str, Any] = {
            "body": name,
            "position_m": [0.0] * 3,
            "shape": {"sphere": {"radius_m": radius}},
        }
        if any(added):
            fields["added_mass"] = {"coefficients": list(added)}
        if has_drag:
            ones = [float(area > 0) for area in areas]
            fields["drag"] = {"coefficients": ones, "areas_m2": [area or 1.0 for area in areas]}
        deck.notes.convert(line, f"{name}: volume {volume:g} m3", "is a sphere of this volume, `submerged`")
        return {f"{name}_water": {"submerged": fields}}
    if not has_drag:
        return {}
    factor = deck.water.density_kg_m3 / 2
    deck.notes.convert(line, f"{name}: CdA without a volume", "is quadratic damping against the water")
    damping = {"body": name, "linear_N_s2_m2": [factor * area for area in areas]}
    return {f"{name}_drag": {"quadratic_damping": damping}}

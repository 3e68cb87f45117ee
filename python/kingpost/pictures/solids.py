"""Solids of the bodies of a described model, as the app draws them, with less detail."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from .faces import Faces, Plan, ball, below, cuboid, joined, lofted, painted, round_bar
from .palette import colour, parsed

BALL_DENSITY_KG_M3 = 1100.0
"""Density of the ball that shows a point mass: a mass of one tonne has a diameter of 1.2 m, as in the app."""
BOOT_TOP = (-0.015, 0.055)
"""Lower and upper edge of the boot-top, relative to the water line, as shares of the hull's height."""
SHIP_RATIO = 3.5
"""Smallest ratio of length to beam of a box that is drawn with a bow."""
BOW_SHARE, RAKE = 0.24, 0.55
"""Length of the bow of a box as a share of the hull's length, and setback of its stem at the keel as a share
of the hull's height."""
LEVEL = 0.9
"""Smallest upward component of the normal of faces that are painted as deck."""
WATER_SHARE = 0.42
"""Height of the painted water line of a hull without data, as a share of the height of the hull."""


def solid_of(body: Mapping[str, Any], model: Mapping[str, Any], water_m: float | None) -> Faces:
    """Faces of a body in its axes (x forward, y to port, z up); none for a body without a shape.

    Parameters
    ----------
    body
        The body, as the model describes it.
    model
        Description of the model.
    water_m
        Height of the still water in the body's axes at the start; `None` without a sea.
    """
    own = parsed(body["colour"]) if body["colour"] else None
    hull = next((one for one in model["hulls"] if one["body"] == body["name"]), None)
    if hull is not None and hull["mesh"]:
        vertices = np.array(hull["mesh"]["vertices_m"], float)
        faces = vertices[np.array(hull["mesh"]["triangles"], int)]
        return _as_hull(faces, hull["origin_m"][2], own)
    sizes = sizes_of(body)
    if is_hull(body, model) and "width_m" in sizes:
        half = sizes["height_m"] / 2
        level = (2 * WATER_SHARE - 1) * half if water_m is None else float(np.clip(water_m, -half, half))
        return _as_hull(_shell(sizes), level, own)
    if "width_m" in sizes:
        return cuboid(
            (sizes["length_m"], sizes["width_m"], sizes["height_m"]), colour("plain") if own is None else own
        )
    if "axis" in sizes:
        plain = colour("plain") if own is None else own
        return round_bar(sizes["radius_m"], sizes["length_m"], sizes["axis"], plain)
    if body["shape"] is None:
        return joined([])
    radius = sizes.get("radius_m") or ball_radius_m(body["mass_kg"])
    return ball(radius, colour("load") if own is None else own)


def sizes_of(body: Mapping[str, Any]) -> dict[str, Any]:
    """Sizes of a body's shape by their names; empty without a shape and for a point.

    >>> sizes_of({"shape": {"sphere": {"radius_m": 2.0}}})
    {'radius_m': 2.0}
    """
    return next(iter(body["shape"].values())) if body["shape"] else {}


def ball_radius_m(mass_kg: float) -> float:
    """Radius of the ball that shows a point mass.

    >>> round(ball_radius_m(1000.0), 2)
    0.6
    """
    return float(np.cbrt(3 * mass_kg / (4 * np.pi * BALL_DENSITY_KG_M3)))


def is_hull(body: Mapping[str, Any], model: Mapping[str, Any]) -> bool:
    """Whether a body is a hull: it has hydrodynamic data, or it floats at the surface and carries a moving
    body."""
    if any(one["body"] == body["name"] for one in model["hulls"]):
        return True
    if not body["floats"] or body["is_submerged"]:
        return False
    joints = {one["body"]: one["kind"] for one in model["joints"]}
    carries = any(
        one["parent"] == body["name"] and joints.get(one["name"]) != "fixed" for one in model["bodies"]
    )
    return carries or joints.get(body["name"]) != "floating"


def _shell(sizes: Mapping[str, float]) -> np.ndarray:
    """Triangles of a box-shaped hull; one as slender as a ship has a raked bow."""
    length, beam, height = sizes["length_m"], sizes["width_m"], sizes["height_m"]
    if length < SHIP_RATIO * beam:
        return cuboid((length, beam, height), (0, 0, 0)).corners
    levels = [(z, _bowed(length, beam, RAKE * (height / 2 - z))) for z in (-height / 2, height / 2)]
    return lofted(levels, (0, 0, 0)).corners


def _bowed(length: float, beam: float, back_m: float) -> Plan:
    """Plan of a ship whose stem is set back by a distance."""
    shares = np.linspace(0.0, 1.0, 9)
    bow = BOW_SHARE * length
    x = length / 2 - bow + shares * max(bow - back_m, 0.2 * bow)
    half = beam / 2 * np.sqrt(np.maximum(0.0, 1 - shares**2.2))
    starboard = [(-length / 2, -beam / 2), *zip(x, -half, strict=True)]
    return [*starboard, *((a, -b) for a, b in reversed(starboard[:-1]))]


def _as_hull(faces: np.ndarray, water_m: float, own: np.ndarray | None) -> Faces:
    """Faces of a hull, painted below and above its water line."""
    low, high = faces[:, :, 2].min(), faces[:, :, 2].max()
    edges = [np.clip(water_m + share * (high - low), low, high) for share in BOOT_TOP]
    topsides = colour("hull") if own is None else own
    middle = below(below(faces, edges[1]), edges[0], -1.0)
    top = below(faces, edges[1], -1.0)
    normals = np.cross(top[:, 1] - top[:, 0], top[:, 2] - top[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    is_level = normals[:, 2] > LEVEL * lengths
    is_deck = is_level & (top[:, :, 2] > high - 1e-3 * (high - low)).all(axis=1)
    return joined([
        painted(below(faces, edges[0]), colour("bottom")),
        painted(middle, colour("stripe")),
        painted(top[~is_deck], topsides),
        painted(top[is_deck], colour("deck")),
    ])  # fmt: skip

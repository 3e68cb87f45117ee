"""Checks of hydrostatics against hand calculations of naval architecture."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ..analysis.vibration import modes
from .models import GRAVITY, G, scenario
from .rows import Compared, check, worst

AREA = "hydrostatics"
LENGTH, BEAM, DRAUGHT, RHO = 20.0, 10.0, 2.0, 1025.0
MASS = RHO * LENGTH * BEAM * DRAUGHT
EXACT = "the mesh of a box is exact: rounding and the equilibrium's 1e-9 m"
BOOK = "Barrass & Derrett, Ship Stability for Masters and Mates"


def barge(
    kg_m: float,
    mass_kg: float = MASS,
    off_m: float = 0.0,
    more: dict[str, Any] | None = None,
    forces: dict[str, Any] | None = None,
    **water: Any,
):
    """A box of 20 x 10 m, 5 m deep, its data taken at a draught of 2 m; its drawing frame is on the keel."""
    hull = {
        "mass_kg": mass_kg,
        "centre_of_mass_m": [0.0, off_m, kg_m],
        "inertia": {"radii_of_gyration": {"radii_m": [3.5, 6.0, 6.0]}},
        "joint": {"floating": {"initial": {"position_m": [0.0, off_m, kg_m - DRAUGHT]}}},
    }
    database = {"body": "hull", "database": "hydro/barge.hydro.json", "origin_m": [0, 0, DRAUGHT], **water}
    acting = {**GRAVITY, "water": {"hydrodynamics": database}, **(forces or {})}
    return scenario({"hull": hull, **(more or {})}, acting)


def hanging(mass_kg: float, top_m: float, rope_m: float) -> dict[str, Any]:
    """A point load on a rope of this length from a point at this height over the keel of `barge`."""
    hinge = {
        "first_axis": [1, 0, 0],
        "second_axis": [0, 1, 0],
        "position_m": [0, 0, top_m],
        "child_position_m": [0, 0, rope_m],
    }
    return {"parent": "hull", "mass_kg": mass_kg, "shape": {"point": {}}, "joint": {"universal": hinge}}


def _afloat(*arguments: Any, **options: Any) -> dict[str, Any]:
    return barge(*arguments, **options).hydrostatics["hulls"][0]


BM = BEAM**2 / (12 * DRAUGHT)


@check(
    "box-draught",
    "draught of a box of 500 t",
    area=AREA,
    unit="m",
    source="m / rho L B; Archimedes",
    tolerance=1e-9,
    why=EXACT,
)
def box_draught() -> Compared:
    return Compared(_afloat(2.5, 5e5, hydrostatics="mesh")["draught_m"], 5e5 / (RHO * LENGTH * BEAM))


@check(
    "box-kb",
    "height of the centre of buoyancy of a box",
    area=AREA,
    unit="m",
    source=f"T / 2; {BOOK}",
    tolerance=1e-9,
    why=EXACT,
)
def box_kb() -> Compared:
    return Compared(_afloat(2.5)["keel_to_buoyancy_m"], DRAUGHT / 2)


@check(
    "box-bm",
    "transverse metacentric radius of a box",
    area=AREA,
    unit="m",
    source=f"B^2 / 12 T; {BOOK}",
    tolerance=1e-9,
    why=EXACT,
)
def box_bm() -> Compared:
    return Compared(_afloat(2.5)["metacentric_radius_m"][0], BM)


@check(
    "box-bm-along",
    "longitudinal metacentric radius of a box",
    area=AREA,
    unit="m",
    source=f"L^2 / 12 T; {BOOK}",
    tolerance=1e-9,
    why=EXACT,
)
def box_bm_along() -> Compared:
    return Compared(_afloat(2.5)["metacentric_radius_m"][1], LENGTH**2 / (12 * DRAUGHT))


@check(
    "box-gm",
    "metacentric height of a box",
    area=AREA,
    unit="m",
    source=f"KB + BM - KG; {BOOK}",
    tolerance=1e-9,
    why=EXACT,
)
def box_gm() -> Compared:
    return Compared(_afloat(2.5)["metacentric_height_m"][0], DRAUGHT / 2 + BM - 2.5)


@check(
    "box-gz",
    "righting arms of a box up to deck immersion",
    area=AREA,
    unit="m",
    source=f"wall-sided formula (GM + BM/2 tan^2 a) sin a; {BOOK}",
    tolerance=1e-9,
    why=EXACT,
)
def box_gz() -> Compared:
    points = _afloat(2.5)["righting_arm"]["points"]
    # The bilge emerges at tan a = 2 T / B, before the deck is immersed.
    inside = [point for point in points if math.tan(point["heel_rad"]) <= 2 * DRAUGHT / BEAM]
    heel = np.array([point["heel_rad"] for point in inside])
    gm = DRAUGHT / 2 + BM - 2.5
    return worst([point["arm_m"] for point in inside], (gm + BM / 2 * np.tan(heel) ** 2) * np.sin(heel))


@check(
    "box-list",
    "heel of a box whose weights are 0.3 m to one side",
    area=AREA,
    unit="rad",
    source=f"(GM + BM/2 tan^2 a) sin a = d cos a; {BOOK}",
    tolerance=1e-8,
    why=EXACT,
)
def box_list() -> Compared:
    gm, offset = DRAUGHT / 2 + BM - 2.5, 0.3
    tangent = np.roots([BM / 2, 0.0, gm, -offset])
    exact = math.atan(float(tangent[np.abs(tangent.imag) < 1e-9].real[0]))
    return Compared(abs(_afloat(2.5, off_m=offset, hydrostatics="mesh")["heel_rad"]), exact)


@check(
    "box-loll",
    "angle of loll of a box with GM of -0.2 m, its weights 1 cm to one side",
    area=AREA,
    unit="rad",
    source=f"(GM + BM/2 tan^2 a) sin a = d cos a, tan^2 a = -2 GM / BM for d = 0; {BOOK}",
    tolerance=1e-7,
    why="the equilibrium's 1e-9 m over a small slope of the arm",
)
def box_loll() -> Compared:
    gm = -0.2
    offset = 0.01
    tangent = np.roots([BM / 2, 0.0, gm, -offset])
    exact = math.atan(float(tangent.real.max()))
    found = _afloat(DRAUGHT / 2 + BM - gm, off_m=offset, hydrostatics="mesh")
    return Compared(abs(found["heel_rad"]), exact)


@check(
    "hanging-load",
    "metacentric height of a box with a load of 10 t on 8 m of rope",
    area=AREA,
    unit="m",
    source=f"GM - m l / M; {BOOK}, ch. on suspended weights",
    tolerance=1e-8,
    why=EXACT,
)
def hanging_load() -> Compared:
    load, rope, top = 1e4, 8.0, 15.0
    found = _afloat(2.0, MASS - load, more={"load": hanging(load, top, rope)}, hydrostatics="mesh")
    kg = ((MASS - load) * 2.0 + load * (top - rope)) / MASS
    return Compared(found["metacentric_height_m"][0], DRAUGHT / 2 + BM - kg - load * rope / MASS)


@check(
    "slack-tank",
    "metacentric height of a box with a slack tank of 12 x 8 m",
    area=AREA,
    unit="m",
    source=f"GM - rho i / M; {BOOK}, ch. on free surface",
    tolerance=1e-8,
    why=EXACT,
)
def slack_tank() -> Compared:
    tank = {
        "body": "hull",
        "position_m": [0, 0, 1.0],
        "length_m": 12.0,
        "breadth_m": 8.0,
        "height_m": 2.0,
        "filling": 0.5,
    }
    found = _afloat(2.5, forces={"tank": {"slack_tank": tank}}, hydrostatics="mesh")
    return Compared(found["metacentric_height_m"][0], DRAUGHT / 2 + BM - 2.5 - RHO * 12 * 8**3 / 12 / MASS)


@check(
    "sphere-metacentre",
    "height of the metacentre of a floating sphere above its keel",
    area=AREA,
    unit="m",
    source="its centre: every section is a circle",
    tolerance=0.02,
    why="a mesh of 500 triangles: second order, (pi / 22)^2",
)
def sphere_metacentre() -> Compared:
    held = {"floating": {"initial": {"position_m": [0, 0, -2.0]}}}
    ball = {
        "mass_t": 261.8,
        "centre_of_mass_m": [0, 0, -2.0],
        "inertia": {"radii_of_gyration": {"radii_m": [2.8, 2.8, 2.8]}},
        "joint": held,
    }
    water = {"body": "ball", "database": "hydro/sphere.hydro.json"}
    one = scenario(
        {"ball": ball}, {**GRAVITY, "water": {"hydrodynamics": water}}, sea={"density_kg_m3": 1000}
    )
    return Compared(one.hydrostatics["hulls"][0]["keel_to_metacentre_m"][0], 5.0)


def _mode(name: str) -> float:
    """Period of a motion of a box without added mass, s."""
    found = modes(barge(2.5, added_mass=False, radiation=False))
    named = [str(one) for one in found.named_after.values]
    return float(2 * np.pi / found.angular_frequency.values[named.index(name)])


@check(
    "box-heave-period",
    "heave period of a box without added mass",
    area=AREA,
    unit="s",
    source="2 pi sqrt(T / g)",
    tolerance=1e-9,
    why="exact A, exact waterplane",
)
def box_heave_period() -> Compared:
    return Compared(_mode("hull.z"), 2 * np.pi * math.sqrt(DRAUGHT / G))


@check(
    "box-roll-period",
    "roll period of a box without added mass",
    area=AREA,
    unit="s",
    source=f"2 pi k / sqrt(g GM); {BOOK}",
    tolerance=1e-6,
    why="seven digits of the database, a quarter of whose sum is left in GM",
)
def box_roll_period() -> Compared:
    return Compared(_mode("hull.roll"), 2 * np.pi * 3.5 / math.sqrt(G * (DRAUGHT / 2 + BM - 2.5)))

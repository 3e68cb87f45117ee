"""Checks of lowered loads: wave kinematics over depth, splash zone, equilibria in deep water, rows while an
input moves."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ..analysis.splash_zone import splash_zone
from ..scenario import Scenario
from ..simulation.simulate import Simulation, run
from .hydrostatics import BM, DRAUGHT, MASS, RHO, barge, hanging
from .models import GRAVITY, G, scenario, settings, slider, value
from .rows import Compared, check, worst

AMPLITUDE, PERIOD, RADIUS, ADDED = 1.2, 6.0, 0.05, 0.5
DEPTHS = (0.4, -1.5, -4.0, -10.0, -20.0)
"""Heights of the small sphere, m; at the first it is submerged only in crests."""
OMEGA = 2 * math.pi / PERIOD
K = OMEGA**2 / G


def _stretched(method: str, z: float, elevation: np.ndarray) -> np.ndarray:
    """Decay of deep-water kinematics at the height z: DNV-RP-C205, sec. 3.3.3, written out."""
    if method == "wheeler":
        return np.exp(K * (z - elevation))
    if z <= 0:
        return np.full(len(elevation), math.exp(K * z))
    return np.full(len(elevation), {"none": 0.0, "vertical": 1.0, "extrapolated": 1.0 + K * z}[method])


def _stretching(method: str) -> Compared:
    wave = {"regular": {"height_m": 2 * AMPLITUDE, "period_s": PERIOD, "direction_deg": 0}}
    sea = {"waves": {"wave": wave}, "stretching": method, "ramp_s": 0}
    volume = 4 / 3 * math.pi * RADIUS**3
    ours, theirs = [], []
    for z in DEPTHS:
        held = {"prismatic": {"axis": [0, 0, 1], "position_m": [0, 0, z], "mode": "held"}}
        probe = {"mass_kg": 1.0, "shape": {"point": {}}, "joint": held}
        water = {
            "body": "probe",
            "shape": {"sphere": {"radius_m": RADIUS}},
            "added_mass": {"coefficients": [ADDED] * 3},
        }
        acting = {**GRAVITY, "water": {"submerged": water}}
        found = run(scenario({"probe": probe}, acting, sea=sea, simulation=settings(0.05, PERIOD)))
        phase = OMEGA * found.time.values
        elevation = AMPLITUDE * np.cos(phase)
        # Fully submerged, also with the slope of the surface.
        under = elevation > z + 1.5 * RADIUS
        size = RHO * ADDED * volume * AMPLITUDE * OMEGA**2 * _stretched(method, z, elevation)
        expected = size * np.array([-np.sin(phase), -np.cos(phase)])
        ours.append(found.submerged_inertia.values[under, 0][:, [0, 2]].T.ravel())
        theirs.append(expected[:, under].ravel())
    return worst(np.concatenate(ours), np.concatenate(theirs))


for _method in ("none", "vertical", "wheeler", "extrapolated"):
    check(
        f"stretching-{_method}",
        f"force of a wave on a small sphere at five heights, stretching {_method}",
        area="waves",
        unit="N",
        source="Airy's kinematics, DNV-RP-C205, sec. 3.3.3",
        tolerance=1e-9,
        why="rounding of phases, over the largest force",
    )(lambda method=_method: _stretching(method))


def _object(shape: dict[str, Any], mass_kg: float, added: float, drag: float, **more: Any) -> Scenario:
    """An object under a hook at the surface, in a regular wave of 2 m and 7 s."""
    held = {"prismatic": {"axis": [0, 0, 1], "position_m": [0, 0, 5], "mode": "held"}}
    body = {"mass_kg": mass_kg, "shape": {"point": {}}, "joint": held}
    water = {
        "body": "object",
        "shape": shape,
        "added_mass": {"coefficients": [0, 0, added]},
        "drag": {"coefficients": [0, 0, drag]},
        **more,
    }
    wave = {"regular": {"height_m": 2.0, "period_s": 7.0, "direction_deg": 0}}
    acting = {**GRAVITY, "water": {"submerged": water}}
    return scenario({"object": body}, acting, sea={"waves": {"wave": wave}})


@check(
    "simplified-lowering",
    "slack of a box, a pipe along and a sphere in the splash zone, three immersions",
    area="flow",
    source="DNV-RP-N103, sec. 4.3, each load by hand",
    tolerance=1e-6,
    why="an object that touches is immersed by 1e-6 of its height",
)
def simplified_lowering() -> Compared:
    omega, amplitude, lowering = 2 * math.pi / 7.0, 1.0, 0.5
    box = {"box": {"length_m": 4.0, "width_m": 3.0, "height_m": 2.0}}
    pipe = {"cylinder": {"radius_m": 0.5, "length_m": 6.0}}
    ball = {"sphere": {"radius_m": 1.0}}
    cap = math.pi * 1.0
    # For each immersion: V, depth of the centre of V, A_w, A, C_S A_S, share.
    by_hand: list[tuple[Scenario, float, float, list[tuple[float, ...]]]] = [
        (_object(box, 60e3, 1.0, 2.0), 60e3, 2.0 * 12.0,
         [(0, 0, 12, 0, 24.0, 0), (12, 0.5, 12, 12, 24.0, 0.5), (24, 1, 0, 24, 0, 1)]),
        (_object(pipe, 20e3, 0.3, 1.1, slamming={"coefficient": 3.0}), 20e3, 1.1 * math.pi * 0.25,
         [(0, 0, math.pi * 0.25, 0, 3 * math.pi * 0.25, 0),
          (math.pi * 0.75, 1.5, math.pi * 0.25, 0.3 * math.pi * 0.75, 3 * math.pi * 0.25, 0.5),
          (math.pi * 1.5, 3, 0, 0.3 * math.pi * 1.5, 0, 1)]),
        # A sphere's phi = s: 2 A_0 ds/dh = 2 C_A A_w; its centre of half lies at 3 R / 8.
        (_object(ball, 12e3, 0.5, 0.5), 12e3, 0.5 * math.pi,
         [(0, 0, 0, 0, cap, 0), (2 / 3 * math.pi, 3 / 8, math.pi, 1 / 3 * math.pi, cap, 0.5),
          (4 / 3 * math.pi, 1, 0, 2 / 3 * math.pi, 0, 1)]),
    ]  # fmt: skip
    ours, theirs = [], []
    for one, mass, drag_area, immersions in by_hand:
        ours.extend(splash_zone(one).slack_utilisation.values[0])
        for volume, centre, section, added, slamming, share in immersions:
            water = amplitude * omega * math.exp(-(omega**2) * centre / G)
            square = 0.5 * RHO * (lowering + water) ** 2
            along = square * (slamming + drag_area * share)
            inertia = RHO * (volume + added) * water * omega
            static = mass * G - RHO * G * volume
            theirs.append(math.hypot(along, inertia - RHO * G * section * amplitude) / (0.9 * static))
    return worst(np.array(ours), np.array(theirs))


def _hung(depth_m: float, stiffness: float, mass_kg: float) -> Compared:
    """Tension and stretch at equilibrium of a point mass on a massless wire, over weight and W L / EA."""
    wire = {
        "path": [
            {"point": {"body": "world", "position_m": [0, 0, 10]}},
            {"point": {"body": "load", "position_m": [0, 0, 0]}},
        ],
        "unstretched_length_m": depth_m + 10.0,
        "axial_stiffness_N": stiffness,
        "damping_time_s": 0.01,
    }
    load = slider(mass_kg, "z", position_m=[0, 0, -depth_m])
    one = Simulation(
        scenario(
            {"load": load},
            {**GRAVITY, "wire": {"rope": wire}},
            simulation=settings(0.001, 1.0, begin_at_equilibrium=True),
        )
    )
    stretch = -value(one, "position", "load", "z") - depth_m
    return worst(
        np.array([value(one, "rope_tension", "wire") / (mass_kg * G), stretch * stiffness]),
        np.array([1.0, mass_kg * G * (depth_m + 10.0)]),
    )


@check(
    "stiff-slings",
    "stretch of a sling of 1e10 N under 1,000 t at the surface",
    area="mooring",
    unit="N m",
    source="W L / EA",
    tolerance=1e-9,
    why="rounding of a height of 10 m over a stretch of 10 mm: 2e-13",
)
def stiff_slings() -> Compared:
    return _hung(0.0, 1e10, 1e6)


@check(
    "deep-equilibrium",
    "stretch of a wire of 3,000 m under 100 t",
    area="mooring",
    unit="N m",
    source="W L / EA",
    tolerance=1e-9,
    why="rounding of 3,000 m over a stretch of 15 m: 3e-14",
)
def deep_equilibrium() -> Compared:
    return _hung(2990.0, 2e8, 1e5)


@check(
    "submerged-hanging-load",
    "righting arms of a box with a load of 20 t and 6 m3 that hangs under water",
    area="hydrostatics",
    unit="m",
    source="its weight in water acts at the hanging point; wall-sided formula",
    tolerance=1e-8,
    why="the mesh of a box is exact: rounding and the equilibrium's 1e-9 m",
)
def submerged_hanging_load() -> Compared:
    load, volume, rope, top = 2e4, 6.0, 20.0, 9.0
    edge = volume ** (1 / 3)
    cube = {"box": {"length_m": edge, "width_m": edge, "height_m": edge}}
    water = {"submerged": {"body": "load", "shape": cube}}
    in_water = load - RHO * volume
    hull = barge(
        2.0,
        MASS - in_water,
        more={"load": hanging(load, top, rope)},
        forces={"wet": water},
        hydrostatics="mesh",
    ).hydrostatics
    points = [point for point in hull["hulls"][0]["righting_arm"]["points"] if 0 < point["heel_rad"] < 0.25]
    kg = ((MASS - in_water) * 2.0 + in_water * top) / MASS
    gm = DRAUGHT / 2 + BM - kg
    heel = np.array([point["heel_rad"] for point in points])
    by_hand = (gm + BM / 2 * np.tan(heel) ** 2) * np.sin(heel)
    return worst([point["arm_m"] for point in points], by_hand)


@check(
    "ramped-lever",
    "torque of a motor and speed of its wheel, row by row, while its lever moves",
    area="multibody",
    source="M of the ramp at the time of the row, the integral of M / J",
    tolerance=1e-9,
    why="rounding, over the largest of each",
)
def ramped_lever() -> Compared:
    wheel = {
        "mass_kg": 1000.0,
        "inertia": {"radii_of_gyration": {"radii_m": [0.3, 0.3, 0.3]}},
        "joint": {"revolute": {"name": "axle", "axis": [0, 0, 1]}},
    }
    steps = [
        {"name": "wait", "until": {"after_s": 1}},
        {"name": "go", "set": [{"input": "drive", "to": 1, "in_s": 4}]},
    ]
    one = scenario(
        {"wheel": wheel},
        simulation=settings(0.05, 6.0),
        drives={"drive": {"motor": {"joint": "axle", "torque_N_m": 1000, "history": "lever"}}},
        operation={"steps": steps},
    )
    found = run(one)
    moved = np.clip(found.time.values - 1, 0, 4)
    torque, speed = 250 * moved, 125 * moved**2 / 90 + 1000 / 90 * np.clip(found.time.values - 5, 0, None)
    ours = [found.joint_force.values[:, 0] / torque[-1], found.joint_velocity.values[:, 0] / speed[-1]]
    return worst(np.concatenate(ours), np.concatenate([torque / torque[-1], speed / speed[-1]]))

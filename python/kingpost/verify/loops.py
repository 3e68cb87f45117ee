"""Checks of closed loops against geometry and statics of mechanisms."""

from __future__ import annotations

import numpy as np

from ..analysis.vibration import modes
from ..simulation.simulate import run
from .models import GRAVITY, G, scenario, settings
from .rows import Compared, check, worst

AREA = "loops"
GROUND, CRANK, COUPLER, ROCKER = 3.5, 1.0, 3.0, 2.5
"""Lengths of a crank-rocker, m."""


def _bar(length: float, mass: float, **joint: object) -> dict[str, object]:
    hinge = {"axis": [0, -1, 0], "child_position_m": [-length / 2, 0, 0], **joint}
    shape = {"box": {"length_m": length, "width_m": 0.1, "height_m": 0.1}}
    return {"mass_kg": mass, "shape": shape, "joint": {"revolute": hinge}}


def _four_bar():
    """A four-bar linkage, cut open between coupler and rocker, with its crank driven at 2 rad/s through a
    whole turn."""
    bodies = {
        "crank": _bar(CRANK, 1.0, initial_angle_rad=1.0, mode={"prescribed": {"rate_rad_s": 2.0}}),
        "coupler": {
            "parent": "crank",
            **_bar(COUPLER, 2.0, position_m=[CRANK / 2, 0, 0], initial_angle_rad=-0.4),
        },
        "rocker": _bar(ROCKER, 3.0, position_m=[GROUND, 0, 0], initial_angle_rad=1.8),
    }
    pin = {
        "first": {"body": "coupler", "position_m": [COUPLER / 2, 0, 0]},
        "second": {"body": "rocker", "position_m": [ROCKER / 2, 0, 0]},
        "constraints": ["x", "z"],
        "start_gap_m": 0.5,
    }
    return run(scenario(bodies, GRAVITY, loops={"pin": pin}, simulation=settings(0.01, np.pi)))


def _rocker(crank: np.ndarray) -> np.ndarray:
    """Angle of the rocker, by the triangle between its pin and the crank's end, rad."""
    across, up = GROUND - CRANK * np.cos(crank), -CRANK * np.sin(crank)
    way = np.hypot(across, up)
    inner = np.arccos((way**2 + ROCKER**2 - COUPLER**2) / (2 * way * ROCKER))
    # Wrap to within half a turn of the initial angle, 1.8 rad.
    return 1.8 + np.remainder(np.arctan2(-up, -across) - inner - 1.8 + np.pi, 2 * np.pi) - np.pi


@check(
    "four-bar-angle",
    "rocker's angle over a turn of a four-bar linkage",
    area=AREA,
    unit="rad",
    source="Freudenstein 1955: two triangles",
    tolerance=1e-11,
    why="positions are brought back to 1e-12 m after every step",
)
def four_bar_angle() -> Compared:
    found = _four_bar()
    crank = found.joint_position.sel(coordinate="crank").values
    return worst(found.joint_position.sel(coordinate="rocker").values, _rocker(crank))


@check(
    "four-bar-rate",
    "rocker's rate over a turn of a four-bar linkage",
    area=AREA,
    unit="rad/s",
    source="r2 w2 sin(b - a) = r4 w4 sin(b - c); Hartenberg & Denavit 1964",
    tolerance=1e-10,
    why="rates are brought back to rounding after every step",
)
def four_bar_rate() -> Compared:
    found = _four_bar()
    crank = found.joint_position.sel(coordinate="crank").values
    rocker = _rocker(crank)
    end = np.array([GROUND + ROCKER * np.cos(rocker), ROCKER * np.sin(rocker)])
    coupler = np.arctan2(end[1] - CRANK * np.sin(crank), end[0] - CRANK * np.cos(crank))
    exact = 2.0 * CRANK * np.sin(coupler - crank) / (ROCKER * np.sin(coupler - rocker))
    return worst(found.joint_velocity.sel(coordinate="rocker").values, exact)


@check(
    "slider-crank",
    "position of the piston over a turn of a slider crank",
    area=AREA,
    unit="m",
    source="r cos a + sqrt(l^2 - r^2 sin^2 a); Hartenberg & Denavit 1964",
    tolerance=1e-11,
    why="positions are brought back to 1e-12 m after every step",
)
def slider_crank() -> Compared:
    bodies = {
        "crank": _bar(CRANK, 1.0, initial_angle_rad=0.3, mode={"prescribed": {"rate_rad_s": 2.0}}),
        "piston": {
            "mass_kg": 2.0,
            "shape": {"point": {}},
            "joint": {"prismatic": {"axis": [1, 0, 0], "initial_extension_m": 3.9}},
        },
    }
    tie = {
        "first": {"body": "crank", "position_m": [CRANK / 2, 0, 0]},
        "second": {"body": "piston"},
        "constraints": [{"distance": {"length_m": COUPLER}}],
        "start_gap_m": 0.5,
    }
    found = run(scenario(bodies, loops={"rod": tie}, simulation=settings(0.01, np.pi)))
    angle = found.joint_position.sel(coordinate="crank").values
    exact = CRANK * np.cos(angle) + np.sqrt(COUPLER**2 - (CRANK * np.sin(angle)) ** 2)
    return worst(found.joint_position.sel(coordinate="piston").values, exact)


@check(
    "parallelogram-mode",
    "frequency of a level bar that swings on two equal rods",
    area=AREA,
    unit="rad/s",
    source="sqrt(g / l): every point circles alike; Routh, Elementary Rigid Dynamics",
    tolerance=1e-9,
    why="exact A; hangers of 1e-6 of the mass take 1e-6 / 12 of it",
)
def parallelogram_mode() -> Compared:
    hanger = {"mass_kg": 1e-9, "inertia": {"tensor": {"moments_kg_m2": [1e-9, 1e-9, 1e-9]}}}
    hinge = {"axis": [0, 1, 0], "child_position_m": [0, 0, 2.0]}
    bar = {"axis": [0, 1, 0], "position_m": [0, 0, -0.0], "child_position_m": [-1.5, 0, 0]}
    bodies = {
        "left": {**hanger, "joint": {"revolute": hinge}},
        "bar": {
            "parent": "left",
            "mass_kg": 5.0,
            "shape": {"box": {"length_m": 3.0, "width_m": 0.1, "height_m": 0.1}},
            "joint": {"revolute": bar},
        },
    }
    tie = {
        "first": {"body": "world", "position_m": [3.0, 0, 0]},
        "second": {"body": "bar", "position_m": [1.5, 0, 0]},
        "constraints": [{"distance": {"length_m": 2.0}}],
    }
    found = modes(scenario(bodies, GRAVITY, loops={"right": tie}))
    return Compared(float(found.angular_frequency.values.max()), np.sqrt(G / 2.0))


@check(
    "stay-force",
    "pull of the stay of a level boom with a load at its end",
    area=AREA,
    unit="N",
    source="statics: (m/2 + M) g / sin(b)",
    tolerance=1e-9,
    why="one linear system: rounding",
)
def stay_force() -> Compared:
    boom = {
        "mass_kg": 300.0,
        "shape": {"box": {"length_m": 8.0, "width_m": 0.3, "height_m": 0.3}},
        "joint": {"revolute": {"axis": [0, 1, 0], "child_position_m": [-4.0, 0, 0]}},
    }
    load = {
        "parent": "boom",
        "mass_kg": 1000.0,
        "shape": {"point": {}},
        "joint": {"fixed": {"position_m": [4.0, 0, 0]}},
    }
    stay = {
        "first": {"body": "world", "position_m": [0, 0, 6.0]},
        "second": {"body": "boom", "position_m": [4.0, 0, 0]},
        "constraints": [{"distance": {"length_m": 10.0}}],
    }
    found = run(
        scenario({"boom": boom, "load": load}, GRAVITY, loops={"stay": stay}, simulation=settings(0.01, 0.02))
    )
    force = found.loop_reaction.isel(time=0).sel(loop="stay")
    ours = float(np.linalg.norm([force.sel(component=f"force_{axis}") for axis in "xyz"]))
    return Compared(ours, (150.0 + 1000.0) * G / 0.6)

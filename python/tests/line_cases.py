"""Scenarios with one line with mass, for comparisons with closed forms."""

from __future__ import annotations

from typing import Any

import numpy as np
from kingpost import Scenario, Simulation
from kingpost.verify.models import GRAVITY, G, scenario, settings

DRY = 1e-9
"""Diameter of a line that displaces no water, m."""


def section(length_m: float, elements: int, **more: Any) -> dict[str, Any]:
    """A section of steel wire in air, without damping, with these fields instead."""
    wire = {"mass_kg_per_m": 30.0, "diameter_m": DRY, "axial_stiffness_N": 8e8, "damping_time_s": 0.0}
    return {"unstretched_length_m": length_m, "elements": elements} | wire | more


def between(first: Any, second: Any, *sections: dict[str, Any], **more: Any) -> dict[str, Any]:
    """Gravity, and a line between two ends: each a body, or a point of the world."""
    first, second = (
        {"body": end} if isinstance(end, str) else {"body": "world", "position_m": list(end)}
        for end in (first, second)
    )
    line = {"first": first, "second": second, "sections": list(sections), "points_along": 0} | more
    return GRAVITY | {"line": {"line": line}}


def fixed(place_m: list[float]) -> dict[str, Any]:
    """A body of no importance, fixed at a place: a line needs one at an end."""
    return {"mass_kg": 1.0, "shape": {"point": {}}, "joint": {"fixed": {"position_m": place_m}}}


def of_two_ends(
    first_m: list[float], second_m: list[float], part: dict[str, Any], sea: Any = None, **line: Any
) -> Scenario:
    """A line at rest between two places of the world."""
    forces = between("post", second_m, part, **line)
    more = {"sea": sea} if sea else {}
    return scenario({"post": fixed(first_m)}, forces, simulation=settings(0.01, 1.0), **more)


def hanging(
    load_kg: float,
    part: dict[str, Any],
    *,
    floats: bool = False,
    aside_rad: float = 0.0,
    speed_m_s: float = 0.0,
    top: dict[str, Any] | None = None,
    **simulation: Any,
) -> Scenario:
    """A load that hangs at rest on a line and slides up and down with this speed at first, or floats, at this
    angle to the vertical at first.

    The line stretches by (M + m L / 2) g L / EA. With a `top` its upper end moves as that mode of a joint."""
    length, stiffness = part["unstretched_length_m"], part["axial_stiffness_N"]
    carried = (load_kg + part["mass_kg_per_m"] * length / 2) * G * float(np.cos(aside_rad))
    stretched = length * (1 + carried / stiffness)
    place = [stretched * float(np.sin(aside_rad)), 0.0, -stretched * float(np.cos(aside_rad))]
    slide = {"prismatic": {"axis": [0, 0, 1], "position_m": place, "initial_speed_m_s": speed_m_s}}
    free = {"floating": {"hold_rotation": True, "initial": {"position_m": place}}}
    point: dict[str, Any] = {"point": {}}
    bodies = {"load": {"mass_kg": load_kg, "shape": point, "joint": free if floats else slide}}
    if top:
        moves = {"prismatic": {"axis": [0, 0, 1], "mode": top}}
        bodies["top"] = {"mass_kg": 1.0, "shape": point, "joint": moves}
    forces = between("top" if top else [0.0, 0.0, 0.0], "load", part)
    return scenario(bodies, forces, simulation={**settings(0.05, 1.0, integrator="rk4"), **simulation})


def node_states(elements: int) -> tuple[slice, slice]:
    """The states that are positions and velocities of the nodes between the ends of the only line. Its states
    are the last ones; behind them are two energies, velocities of its two ends and impulses owed to them."""
    nodes, memory = 2 * elements - 1, 14
    return slice(-6 * nodes - memory, -3 * nodes - memory), slice(-3 * nodes - memory, -memory)


OWED = slice(-6, None)
"""The states that are the impulses owed to the ends of the only line."""


def set_velocity(simulation: Simulation, elements: int, velocity_m_s: list[float]) -> None:
    """Gives all nodes of the only line this velocity."""
    state = simulation.state
    states, (_, velocities) = state.s.copy(), node_states(elements)
    states[velocities] = np.tile(velocity_m_s, 2 * elements - 1)
    simulation.set_state(state.q, state.v, states)

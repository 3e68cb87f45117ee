"""Small scenarios built in code, and helpers to read their runs."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from .. import gallery
from ..scenario import Scenario
from ..simulation.simulate import Simulation

G = 9.80665
"""Default acceleration of gravity, m/s2."""
GRAVITY = {"gravity": {"gravity": {}}}


def scenario(
    bodies: Mapping[str, Any],
    forces: Mapping[str, Any] | None = None,
    files: Mapping[str, str] | None = None,
    **more: Any,
) -> Scenario:
    """A scenario of bodies and forces; `more` are the file's other keys, such as ``simulation``.

    Its files are the given ones, by name, or those of the gallery.

    >>> ball = {"mass_kg": 1, "shape": {"point": {}}, "joint": {"prismatic": {"axis": [0, 0, 1]}}}
    >>> scenario({"ball": ball}).model["bodies"][0]["name"]
    'ball'
    """
    text = {"version": 1, "title": "verification", "bodies": bodies, "forces": forces or {}, **more}
    if files is None:
        return Scenario(json.dumps(text), str(Path(gallery.find("paper")).parent / "verification.yaml"))
    with tempfile.TemporaryDirectory() as folder:
        for name, content in files.items():
            (Path(folder) / name).write_text(content, encoding="utf-8")
        # The files of a scenario are read when it is made.
        return Scenario(json.dumps(text), str(Path(folder) / "verification.yaml"))


def settings(step_s: float, duration_s: float, **more: Any) -> dict[str, Any]:
    """``simulation`` of a scenario that records every step."""
    return {"step_s": step_s, "duration_s": duration_s, "record_every_s": step_s, **more}


def rod(length_m: float, mass_kg: float, **joint: Any) -> dict[str, Any]:
    """A thin rod that hangs on a hinge about y at its upper end."""
    moment = mass_kg * length_m**2 / 12
    hinge = {"axis": [0, 1, 0], "child_position_m": [0, 0, length_m / 2], **joint}
    return {
        "mass_kg": mass_kg,
        "inertia": {"tensor": {"moments_kg_m2": [moment, moment, 0]}},
        "joint": {"revolute": hinge},
    }


def slider(mass_kg: float, axis: str = "x", **joint: Any) -> dict[str, Any]:
    """A point mass that slides along an axis of the world."""
    direction = [float(axis == one) for one in "xyz"]
    return {
        "mass_kg": mass_kg,
        "shape": {"point": {}},
        "joint": {"prismatic": {"axis": direction, **joint}},
    }


def free_body(moments_kg_m2: list[float], mass_kg: float = 1.0, **initial: Any) -> dict[str, Any]:
    """A body that floats freely."""
    return {
        "mass_kg": mass_kg,
        "inertia": {"tensor": {"moments_kg_m2": moments_kg_m2}},
        "joint": {"floating": {"initial": initial}},
    }


def value(simulation: Simulation, variable: str, *labels: str) -> float:
    """Present value of one channel, by the name of its variable and its labels.

    >>> one = scenario({"ball": slider(2.0, "x", initial_extension_m=3.0)})
    >>> value(Simulation(one), "joint_position", "ball")
    3.0
    """
    for channel in simulation.channels:
        if channel["variable"] != variable:
            continue
        sizes = [len(names) for names in channel["labels"]]
        places = [names.index(label) for names, label in zip(channel["labels"], labels, strict=True)]
        offset = int(np.ravel_multi_index(places, sizes)) if sizes else 0
        return float(simulation.row()[channel["offset"] + offset])
    raise KeyError(variable)


def crossings(t: np.ndarray, x: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Times at which x goes through zero, on the cubic through x and its rate v at both ends of a step.

    The cubic's error is (h^4 / 384) x'''', so that with a step of a thousandth of a period it is rounding.

    >>> t = np.linspace(0, 10, 1001)
    >>> abs(crossings(t, np.cos(t), -np.sin(t)) - np.pi * np.array([0.5, 1.5, 2.5])).max() < 1e-11
    np.True_
    """
    found = []
    for i in np.flatnonzero(np.sign(x[:-1]) * np.sign(x[1:]) < 0):
        h = t[i + 1] - t[i]
        rise = x[i + 1] - x[i]
        cubic = [h * (v[i] + v[i + 1]) - 2 * rise, 3 * rise - h * (2 * v[i] + v[i + 1]), h * v[i], x[i]]
        roots = np.roots(cubic)
        inside = roots[(np.abs(roots.imag) < 1e-9) & (roots.real > -1e-9) & (roots.real < 1 + 1e-9)].real
        found.append(t[i] + h * inside[0])
    return np.array(found)


def stiffness(simulation: Simulation, mass: np.ndarray) -> np.ndarray:
    """-M dA/dq of the linearised system: stiffness in the coordinates, N/m and N m/rad.

    `mass` is the caller's M*, so that the engine's mass matrix is not used.
    """
    linear = simulation.linearize()
    n = len(linear.coordinates)
    return -mass @ linear.A.values[n : 2 * n, :n]

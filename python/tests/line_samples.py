"""Small scenarios with lines with mass, for tests."""

from __future__ import annotations

import copy
from typing import Any

SECTION: dict[str, Any] = {
    "unstretched_length_m": 850,
    "elements": 12,
    "mass_kg_per_m": 685,
    "diameter_m": 0.333,
    "axial_stiffness_N": 3.27e9,
    "damping_time_s": 0.02,
    "drag_along": 0.05,
    "added_mass_along": 0.5,
}
"""Chain of a published mooring: 200 m of water, 779.6 m to its anchor."""

CHAIN: dict[str, Any] = {
    "version": 1,
    "title": "A chain under a fairlead",
    "simulation": {"step_s": 0.05, "duration_s": 4, "record_every_s": 0.25},
    "sea": {
        "depth_m": 200,
        "waves": {"swell": {"regular": {"height_m": 2, "period_s": 9, "direction_deg": 20}}},
    },
    "bodies": {
        "fairlead": {
            "mass_t": 50,
            "shape": {"sphere": {"radius_m": 0.1}},
            "joint": {
                "prismatic": {
                    "axis": [0, 0, 1],
                    "position_m": [0, 0, -14],
                    "mode": {"oscillation": {"amplitude_m": 2.5, "period_s": 9, "ramp_s": 4}},
                }
            },
        }
    },
    "forces": {
        "gravity": {"gravity": {}},
        "chain": {
            "line": {
                "first": {"body": "fairlead", "position_m": [0, 0, 0]},
                "second": {"body": "world", "position_m": [779.6, 0, -200]},
                "sections": [SECTION],
                "seabed": {"friction": 0.7},
            }
        },
    },
}


PAID_OUT: dict[str, Any] = {
    **CHAIN,
    "title": "A load in the sea on a wire from a drum",
    "bodies": {
        "drum": {
            "mass_t": 10,
            "shape": {"cylinder": {"radius_m": 1, "length_m": 2, "axis": "y"}},
            "joint": {
                "revolute": {
                    "name": "winch",
                    "axis": [0, 1, 0],
                    "position_m": [-20, 0, 10],
                    "mode": {
                        "prescribed": {
                            "rate_rad_s": 1,
                            "history": "pulse",
                            "pulse": {"rise_s": 2, "hold_s": 8},
                        }
                    },
                }
            },
        },
        "load": {
            "mass_t": 300,
            "shape": {"sphere": {"radius_m": 0.1}},
            "joint": {"prismatic": {"name": "lift", "axis": [0, 0, 1], "position_m": [0, 0, -150]}},
        },
    },
    "forces": {
        "gravity": {"gravity": {}},
        "chain": {
            "line": {
                "path": [
                    {"drum": {"joint": "winch", "radius_m": 1}},
                    {
                        "sheave": {
                            "body": "world",
                            "position_m": [0, 0, 20],
                            "radius_m": 0.5,
                            "axis": [0, 1, 0],
                            "efficiency_hoisting": 0.97,
                            "efficiency_lowering": 0.97,
                        }
                    },
                    {"point": {"body": "load", "position_m": [0, 0, 0]}},
                ],
                "sections": [
                    {
                        **SECTION,
                        "unstretched_length_m": 169.7,
                        "elements": 4,
                        "mass_kg_per_m": 30,
                        "diameter_m": 0.07,
                        "axial_stiffness_N": 8e8,
                    }
                ],
            }
        },
    },
}
"""A wire of 170 m in waves, paid out at 1 m/s over a drum and a sheave with friction."""


def chain(**line: Any) -> dict[str, Any]:
    """The chain, with these fields of the line instead; None leaves a field out."""
    given = copy.deepcopy(CHAIN)
    fields = given["forces"]["chain"]["line"]
    for name, value in line.items():
        if value is None:
            fields.pop(name)
        else:
            fields[name] = value
    return given


def with_section(**fields: Any) -> dict[str, Any]:
    """The chain with these fields of its section instead."""
    return chain(sections=[{**SECTION, **fields}])

"""Typical mistakes in scenarios of lifts, drawn at random: a rope on one body, a winch that never stops."""

from __future__ import annotations

import copy
import math
import random
from typing import Any

Document = dict[str, Any]

COLUMNS = [
    "time", "load.position.z", "lift.position.z", "hoist_rope.rope_tension", "fall.rope_tension", "nothing",
    "", "operation.operation_step", "operation_step", "energy_error", "deck.contact_normal_force",
]  # fmt: skip


def of_kind(document: Document, section: str, kind: str) -> list[Document]:
    entries = document.get(section)
    found = (
        [entry.get(kind) for entry in entries.values() if isinstance(entry, dict)]
        if isinstance(entries, dict)
        else []
    )
    return [entry for entry in found if isinstance(entry, dict)]


def bodies(document: Document) -> list[str]:
    found = document.get("bodies")
    return [*found, "world"] if isinstance(found, dict) else ["world"]


def stations(document: Document, draw: random.Random) -> list[Document]:
    """The path of a rope or a tugger line."""
    ropes = of_kind(document, "forces", "rope") + of_kind(document, "forces", "tugger_line")
    paths = [path for rope in ropes if isinstance(path := rope.get("path"), list)]
    return draw.choice(paths) if paths else []


def both_ends_on_one_body(document: Document, draw: random.Random) -> str:
    body = draw.choice(bodies(document))
    for station in stations(document, draw):
        for kind in ("point", "sheave"):
            if isinstance(station, dict) and isinstance(station.get(kind), dict):
                station[kind]["body"] = body
    return f"a rope with all of its places on {body}"


def a_sheave_elsewhere(document: Document, draw: random.Random) -> str:
    path = stations(document, draw)
    sheaves = [
        entry["sheave"] for entry in path if isinstance(entry, dict) and isinstance(entry.get("sheave"), dict)
    ]
    if not sheaves:
        return "no sheave"
    sheave = draw.choice(sheaves)
    where = [draw.choice([0, 0.3, -0.3, 3, 15, -11, 1e6]) for _ in range(3)]
    sheave |= {"body": draw.choice(bodies(document)), "position_m": where}
    if draw.random() < 0.5:
        sheave["axis"] = draw.choice(
            [[1, 0, 0], [0, -1, 0], [0, 0, 1], [0, 0, 0], [1e-200, 0, 0], [1e200, 1e200, 0]]
        )
    return f"a sheave on {sheave['body']} at {where}, axis {sheave.get('axis')}"


def a_place_more(document: Document, draw: random.Random) -> str:
    """A place of a rope stands twice, at a spot of its own or at the same."""
    path = stations(document, draw)
    if not path:
        return "no path"
    k, to = draw.randrange(len(path)), draw.randrange(len(path) + 1)
    entry = copy.deepcopy(path[k])
    if isinstance(entry, dict) and draw.random() < 0.5:
        for kind in ("point", "sheave"):
            if isinstance(entry.get(kind), dict):
                entry[kind]["position_m"] = [draw.uniform(-5, 5) for _ in range(3)]
    path.insert(to, entry)
    return f"place {k} of a rope stands at {to} too"


def a_length(document: Document, draw: random.Random) -> str:
    ropes = of_kind(document, "forces", "rope")
    if not ropes:
        return "no rope"
    rope = draw.choice(ropes)
    rope["unstretched_length_m"] = draw.choice([1e-9, 0.1, 1, 12, 30, 100, 140, 150, 1e4, 1e9, 1e300])
    rope["axial_stiffness_N"] = draw.choice([rope.get("axial_stiffness_N"), 1e-9, 1, 1e12, 1e300])
    rope["series_stiffness_N_per_m"] = draw.choice([None, 1e-9, 1e6, 1e300])
    return f"a rope of {rope['unstretched_length_m']} m, EA {rope['axial_stiffness_N']}"


def a_winch_that_never_stops(document: Document, draw: random.Random) -> str:
    drives = of_kind(document, "drives", "controlled_drive") + of_kind(
        document, "drives", "linear_controlled_drive"
    )
    if not drives:
        return "no drive"
    drive = draw.choice(drives)
    for name in list(drive):
        if "limit" in name or "stiffness" in name or "damping" in name or "response" in name:
            drive[name] = draw.choice([drive[name], 1e-9, 1, 1e3, 1e9, 1e15, 1e300])
    kinds = {"speed": "rate_rad_s", "position": "angle_rad", "torque": "torque_N_m"}
    kind = draw.choice(sorted(kinds))
    value = draw.choice([-1e9, 1e9, -100, 100, 1e300, -3])
    drive["set_point"] = {kind: {kinds[kind]: value}}
    return f"a drive to {kind} {value}"


def a_drum_elsewhere(document: Document, draw: random.Random) -> str:
    """A drum on a joint that is no hinge, or that the rope cannot leave."""
    path = stations(document, draw)
    joints = ["slew", "luff", "winch", "travel", "hull", "load", "lift", "pendant", "world", "winch.angle"]
    joint, radius = draw.choice(joints), draw.choice([0.1, 0.6, 2, 20, 1e-9])
    station = {
        "drum": {
            "joint": joint,
            "radius_m": radius,
            "pays_out": draw.choice(["with_negative_rate", "with_positive_rate"]),
        }
    }
    if not path:
        return "no path"
    path[0 if draw.random() < 0.8 else draw.randrange(len(path))] = station
    return f"a drum of {radius} m on {joint}"


def a_load_in_the_deck(document: Document, draw: random.Random) -> str:
    contacts = of_kind(document, "forces", "contact")
    if not contacts:
        return "no contact"
    contact = draw.choice(contacts)
    contact["penetration_tolerance_m"] = draw.choice([1e-9, 0.1, 10, 1e6])
    side = contact.get(draw.choice(["load", "surface"]))
    if isinstance(side, dict):
        side["position_m"] = [0, 0, draw.choice([-3, -0.5, 0, 0.2, 0.5, 3])]
        side["orientation_rad"] = [draw.choice([0, 1e-9, 0.7, 3.2, 1e6]), 0, 0]
    return f"a load in its surface, within {contact['penetration_tolerance_m']} m"


def another_shape(document: Document, draw: random.Random) -> str:
    sides = [side for contact in of_kind(document, "forces", "contact") for side in contact.values()]
    sides += of_kind(document, "forces", "submerged")
    sides = [side for side in sides if isinstance(side, dict) and "shape" in side]
    if not sides:
        return "no shape"
    a, b, c = (draw.choice([1e-9, 1e-3, 0.4, 1, 3, 100, 1e9]) for _ in range(3))
    points = draw.choice(
        [[], [[0, 0, 0]], [[0, 0, 0]] * 3, [[a, b, c]] * 65, [[a, 0, 0], [0, b, 0], [0, 0, c]]]
    )
    shapes = [
        {"box": {"length_m": a, "width_m": b, "height_m": c}},
        {"cylinder": {"radius_m": a, "length_m": b, "axis": draw.choice("xyz")}},
        {"sphere": {"radius_m": a}},
        {"points": {"positions_m": points}},
        {
            "plane": {
                "normal": draw.choice([[0, 0, 1], [0, 0, -1], [0, 0, 0], [1e-200, 1e-200, 0], [1, 1e200, 0]])
            }
        },
        {"plane": {}},
    ]
    shape = draw.choice(shapes)
    draw.choice(sides)["shape"] = shape
    return f"a shape {str(shape)[:80]}"


def steps(document: Document) -> list[Any]:
    operation = document.setdefault("operation", {"steps": []})
    if not isinstance(operation, dict):
        operation = document["operation"] = {"steps": []}
    found = operation.setdefault("steps", [])
    if not isinstance(found, list):
        found = operation["steps"] = []
    return found


def a_condition(draw: random.Random) -> Any:
    """One that holds at once, never, or that says nothing."""
    value: dict[str, Any] = {"column": draw.choice(COLUMNS)}
    for bound in draw.choice([[], ["above"], ["below"], ["above", "below"]]):
        value[bound] = draw.choice([0, 1, -1, 1e9, math.nan, math.inf, "x"])
    if draw.random() < 0.3:
        value["unit"] = draw.choice(["deg", "kN", "t", "m", "s", "1", "", "furlong"])
    after = {"after_s": draw.choice([0, 1e-9, 0.1, 1e9, -1, math.nan])}
    return draw.choice(
        [{"value": value}, after, {}, {"all": []}, {"any": [after]}, {"all": [after, {"value": value}]}]
    )


def another_condition(document: Document, draw: random.Random) -> str:
    found = [step for step in steps(document) if isinstance(step, dict)]
    until = a_condition(draw)
    depth = draw.choice([0, 0, 1, 2, 20, 100])
    for _ in range(depth):
        until = {draw.choice(["all", "any"]): [until]}
    step = draw.choice(found) if found else {"name": "wait"}
    step["until"] = until
    if not found:
        steps(document).append(step)
    return f"a condition at depth {depth}: {str(until)[-100 - 10 * depth :][:120]}"


def steps_without_time(document: Document, draw: random.Random) -> str:
    """Many steps that end as they begin."""
    count = draw.choice([1, 10, 1000])
    steps(document)[:] = [{"name": f"step {k}", "until": {"after_s": 0}} for k in range(count)]
    return f"{count} steps of no time"


def another_move(document: Document, draw: random.Random) -> str:
    move = {
        "input": draw.choice(["hoist", "slewing", "travelling", "fall", "hoist_rope", "deck", "none", ""])
    }
    move["to"] = draw.choice([0, 1, -1, 0.5, 2, -70, 1e9, 1e308, math.nan, math.inf, None, "on"])
    for name in draw.sample(["at_s", "in_s", "unit"], draw.randrange(4)):
        move[name] = draw.choice(
            ["deg", "deg/s", "kN", "rad"] if name == "unit" else [0, 0.1, 1, -1, 1e-12, 1e9, math.inf]
        )
    found = steps(document)
    step = {
        "name": draw.choice(["move", "", "move", "x" * 300, 3, None]),
        "set": [move] * draw.choice([1, 1, 2, 50]),
    }
    if draw.random() < 0.5:
        step["until"] = a_condition(draw)
    if draw.random() < 0.3:
        step["time_out_s"] = draw.choice([0, 1e-9, 0.1, 1e9, -1])
    found.insert(draw.randrange(len(found) + 1), step)
    return f"a step {str(step)[:150]}"


def another_limit(document: Document, draw: random.Random) -> str:
    columns = [
        "nothing",
        "",
        "hull.roll",
        "load.roll",
        "time",
        "fall.rope_tension",
        "hoist_rope.rope_tension",
        "roll",
        ".",
    ]
    limit = {"column": draw.choice(columns)}
    for bound in draw.sample(
        ["at_most", "at_least", "within", "unit", "from_s", "enabled"], draw.randrange(5)
    ):
        limit[bound] = draw.choice([0, -1, 1, 1e9, math.nan, math.inf, "deg", True])
    limits = document.setdefault("limits", {})
    if isinstance(limits, dict):
        limits[draw.choice(["one", "", "a.b", "heel", "hook_load", "x y"])] = limit
    return f"a limit {limit}"


def a_body_off(document: Document, draw: random.Random) -> str:
    """A body that others name is not there, or hangs on another."""
    found = document.get("bodies")
    if not isinstance(found, dict) or not found:
        return "no bodies"
    name = draw.choice(sorted(found))
    if isinstance(found[name], dict):
        found[name] |= draw.choice(
            [
                {"enabled": False},
                {"parent": draw.choice(bodies(document))},
                {"mass_kg": 1e-9},
                {"mass_kg": 1e12},
            ]
        )
    return f"body {name} changed: {str(found[name])[:80]}"


def another_step(document: Document, draw: random.Random) -> str:
    simulation = document.get("simulation")
    if not isinstance(simulation, dict):
        return "no simulation"
    schemes = [
        "rk4",
        "forward_euler",
        "dormand_prince",
        "newmark",
        "generalized_alpha",
        "implicit_midpoint",
        "euler",
    ]
    simulation["integrator"] = draw.choice(schemes)
    simulation["step_s"] = draw.choice([0.01, 0.05, 0.5, 5, 1e-6, 1e-12, 0.003])
    simulation["begin_at_equilibrium"] = draw.choice([True, False])
    if draw.random() < 0.3:
        simulation["form"] = draw.choice(["recursive", "moving_frame", "moving_frame_without_d"])
    return f"{simulation['integrator']} in steps of {simulation['step_s']}"


PLANS = [
    both_ends_on_one_body, a_sheave_elsewhere, a_sheave_elsewhere, a_place_more, a_length,
    a_winch_that_never_stops, a_drum_elsewhere, a_load_in_the_deck, another_shape, another_shape,
    another_condition, another_condition,
    steps_without_time, another_move, another_move, another_limit, a_body_off, another_step,
]  # fmt: skip

"""Report of a model."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from ..results.units import engineering
from . import hydrostatics, sea, splash
from .run import steps
from .tables import fixed, kilograms, masses, table

if TYPE_CHECKING:
    from ..scenario import Scenario

WORLD = "world"
FREE = "floating"
"""Kind of the joint of a body with six degrees of freedom."""
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?")


def text(scenario: Scenario, coordinates: Sequence[str]) -> str:
    """The model of a scenario: bodies, joints, closed loops, parameters, drives, forces, sensors,
    controllers, and how its hulls float."""
    described = scenario.model
    settings = scenario.resolved["simulation"]
    mass = sum(body["mass_kg"] for body in described["bodies"])
    sections = [
        [scenario.title],
        _parts(described["parts"]),
        _bodies(described, {hull["body"] for hull in scenario.hydrostatics["hulls"]}),
        _places(described["bodies"]),
        [
            f"total mass: {kilograms(mass)}",
            f"free coordinates ({len(coordinates)}): {', '.join(coordinates)}",
        ],
        _loops("closed loop", described["loops"]),
        _loops("connection", described["connections"]),
        _parameters(described["parameters"]),
        _elements(described, "drives"),
        _prescribed(described["joints"]),
        _elements(described, "forces"),
        _elements(described, "sensors"),
        _elements(described, "controllers"),
        _steps(described),
        _task(described["task"]),
        sea.lines(scenario),
        *splash.sections(scenario),
        *hydrostatics.sections(scenario),
        [f"warning: {words}" for words in described["warnings"]],
        [
            f"{settings['integrator']}, {settings['duration_s']:g} s {steps(settings)}, "
            f"recorded every {settings['record_every_s']:g} s"
        ],
    ]
    return "\n\n".join("\n".join(lines) for lines in sections if lines)


def data(scenario: Scenario, coordinates: Sequence[str]) -> dict[str, Any]:
    """Content of `text` in SI units: the engine's description, the settings, and the hydrostatics."""
    given = scenario.resolved
    return {
        "title": scenario.title,
        "coordinates": list(coordinates),
        "model": scenario.model,
        "sea": given.get("sea"),
        "wind": given.get("wind"),
        "simulation": given["simulation"],
        "hydrostatics": scenario.hydrostatics,
    }


def is_unstable(scenario: Scenario) -> bool:
    """Whether a hull capsizes: in still water its metacentric height is negative, or it rests keel up."""
    return any(
        min(hull["metacentric_height_m"]) < 0 or abs(hull["heel_rad"]) > math.pi / 2
        for hull in scenario.hydrostatics["hulls"]
    )


def _parts(parts: list[dict[str, Any]]) -> list[str]:
    """The parts of the scenario and the position of each."""
    rows = [("part", "is", "on", "at")]
    for part in parts:
        at = ", ".join(f"{x:g}" for x in part["position_m"])
        rows.append((part["name"], part["part"], part["on"], f"{at} m"))
    return table(rows, "<<<<") if parts else []


def _bodies(described: dict[str, Any], afloat: set[str]) -> list[str]:
    joints = {joint["body"]: joint for joint in described["joints"]}
    rows = [("body", "mass", "parent", "joint")]
    weighed = masses([body["mass_kg"] for body in described["bodies"]])
    for body, mass in zip(described["bodies"], weighed, strict=True):
        joint = joints.get(body["name"])
        how = f"{_kind(joint, afloat)} {joint['name']}" if joint else ""
        rows.append((body["name"], mass, body.get("parent") or WORLD, how))
    return table(rows, "<><<")


def _places(bodies: list[dict[str, Any]]) -> list[str]:
    """The places of floating bodies whose drawing frame does not begin at their centre of mass."""
    rows = [("at the start, m", "centre of mass", "origin of the drawing frame")]
    for body in bodies:
        if place := body.get("at_start"):
            points = (place["centre_of_mass_m"], place["drawing_frame_m"])
            rows.append((body["name"], *(", ".join(fixed(x, 3) for x in point) for point in points)))
    return table(rows, "<<<") if len(rows) > 1 else []


def _kind(joint: dict[str, Any], afloat: set[str]) -> str:
    """Name the kind of a joint. A load with six degrees of freedom is called free, a hull floating."""
    kind: str = joint["kind"]
    return "free" if kind == FREE and joint["body"] not in afloat else kind


def _loops(what: str, loops: list[dict[str, Any]]) -> list[str]:
    if not loops:
        return []
    rows = [(what, "between", "constraints", "")]
    for loop in loops:
        between = f"{loop['first']['body']} and {loop['second']['body']}"
        state = {None: "", True: "begins released", False: "begins engaged"}[loop.get("begins_released")]
        rows.append((loop["name"], between, ", ".join(loop["constraints"]), state))
    return table(rows, "<<<<")


def _steps(described: dict[str, Any]) -> list[str]:
    """The steps of the operation: what each moves, by which drive, and what ends it."""
    if not described["steps"]:
        return []
    kinds = {element["name"]: element["kind"] for element in described["elements"]}
    kinds |= {connection["name"]: "connection" for connection in described["connections"]}
    rows = [("step", "operation", "moves", "until", "time-out")]
    for number, step in enumerate(described["steps"], start=1):
        moves = [_move(move, kinds) for move in step["moves"]] or [""]
        limit = "" if step.get("time_out_s") is None else f"{step['time_out_s']:g} s"
        rows.append((str(number), step["name"], moves[0], step["until"], limit))
        rows += [("", "", move, "", "") for move in moves[1:]]
    return table(rows, "><<<>")


def _task(task: dict[str, Any] | None) -> list[str]:
    """The task for whoever moves the levers: its stages, and what ends each."""
    if task is None:
        return []
    stages = [(str(number), one["name"], one["until"]) for number, one in enumerate(task["stages"], start=1)]
    return [f"task: {task['text']}", *table([("stage", "task", "until"), *stages], "><<")]


def _move(move: dict[str, Any], kinds: dict[str, str]) -> str:
    """Name an input with its element, its new value, and when it moves."""
    shown, size = engineering(move["unit"])
    unit = "" if shown == "1" else f" {shown}"
    kind = f", {kinds[move['input']]}" if move["input"] in kinds else ""
    begins = f" at {move['at_s']:g} s" if move["at_s"] else ""
    lasts = f" in {move['in_s']:g} s" if move["in_s"] else ""
    return f"{move['input']}{kind}: to {move['to'] / size:.6g}{unit}{begins}{lasts}"


def _parameters(parameters: list[dict[str, Any]]) -> list[str]:
    if not parameters:
        return []
    rows = [("parameter", "value", "", "")]
    for parameter in parameters:
        rows.append((parameter["name"], written(parameter["value"]), parameter.get("unit") or "",
                     parameter.get("label") or ""))  # fmt: skip
    return table(rows, "<><<")


def _elements(described: dict[str, Any], group: str) -> list[str]:
    """Forces, drives, sensors or controllers with their facts. Without elements of a kind there is no
    section."""
    rows = [(group, "", "", "")]
    for element in described["elements"]:
        if element["group"] == group:
            on = "on" if element["enabled"] else "off"
            rows.append((element["name"], element["kind"], on, facts(element["facts"])))
    if len(rows) > 1:
        return table(rows, "<<<<")
    return [] if group in ("sensors", "controllers") else [f"{group}: none"]


def facts(given: list[dict[str, str]]) -> str:
    """Facts in a line, in engineering units.

    >>> facts([{"label": "target", "value": "1.5708", "unit": "rad"},
    ...        {"label": "joint", "value": "luff", "unit": ""}])
    'target 90 deg, joint luff'
    """
    return ", ".join(_fact(fact) for fact in given)


def _fact(fact: dict[str, str]) -> str:
    shown, size = engineering(fact["unit"])
    value = fact["value"]
    if size != 1.0:
        value = NUMBER.sub(lambda found: f"{float(found.group()) / size:.5g}", value)
    return f"{fact['label']} {value} {shown}".rstrip()


def _prescribed(joints: list[dict[str, Any]]) -> list[str]:
    """The joints that are held or follow a prescribed motion."""
    rows = [("prescribed", "")]
    rows += [(joint["name"], facts(joint["prescribed"])) for joint in joints if joint["prescribed"]]
    return table(rows, "<<") if len(rows) > 1 else []


def written(value: Any) -> str:
    """The value of a parameter as a scenario writes it.

    >>> written(True), written(-10.0), written("pulse")
    ('true', '-10', 'pulse')
    """
    if isinstance(value, bool):
        return str(value).lower()
    return f"{value:g}" if isinstance(value, int | float) else str(value)

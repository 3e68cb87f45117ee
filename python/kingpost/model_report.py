"""What the command line prints of a model."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from . import hydrostatics_report
from .report import steps, table

if TYPE_CHECKING:
    from .scenario import Scenario

WORLD = "world"


def text(scenario: Scenario, coordinates: Sequence[str]) -> str:
    """What a scenario builds: bodies, joints, closed loops, parameters, drives and forces, and how its
    hulls float."""
    resolved = scenario.resolved
    described = scenario.model
    settings = resolved["simulation"]
    mass = sum(body["mass_kg"] for body in described["bodies"])
    drives = resolved.get("drives", {})
    sections = [
        [scenario.title],
        _parts(described["parts"]),
        _bodies(described),
        [f"total mass: {mass:g} kg", f"free coordinates ({len(coordinates)}): {', '.join(coordinates)}"],
        _loops(described["loops"]),
        _parameters(described["parameters"]),
        _laws("drives", {name: law for name, law in drives.items() if "cylinder" not in law}),
        _cylinders({name: law["cylinder"] for name, law in drives.items() if "cylinder" in law}),
        _prescribed(resolved),
        _laws("forces", resolved.get("forces", {})),
        _sea(described["sea"]),
        *hydrostatics_report.sections(scenario),
        [f"warning: {words}" for words in described["warnings"]],
        [
            f"{settings['integrator']}, {settings['duration_s']:g} s {steps(settings)}, "
            f"recorded every {settings['record_every_s']:g} s"
        ],
    ]
    return "\n\n".join("\n".join(lines) for lines in sections if lines)


def _parts(parts: list[dict[str, Any]]) -> list[str]:
    """What the scenario is made of, and where each part stands."""
    rows = [("part", "is", "on", "at")]
    for part in parts:
        at = ", ".join(f"{x:g}" for x in part["position_m"])
        rows.append((part["name"], part["part"], part["on"], f"{at} m"))
    return table(rows, "<<<<") if parts else []


def _bodies(described: dict[str, Any]) -> list[str]:
    joints = {joint["body"]: joint for joint in described["joints"]}
    rows = [("body", "mass", "parent", "joint")]
    for body in described["bodies"]:
        joint = joints.get(body["name"])
        how = f"{joint['kind']} {joint['name']}" if joint else ""
        rows.append((body["name"], f"{body['mass_kg']:g} kg", body.get("parent") or WORLD, how))
    return table(rows, "<><<")


def _sea(sea: dict[str, Any] | None) -> list[str]:
    """What is cut off the spectra of the sea, if anything."""
    lines = []
    for cut in sea["cut_spectra"] if sea else []:
        whole, kept = cut["significant_height_m"], 1 - cut["energy_cut_off"]
        lines.append(
            f"{cut['name']}: {100 * cut['energy_cut_off']:.2g} % of the spectrum's energy is cut off: "
            f"Hs {whole * kept**0.5:.4g} m of {whole:.4g} m"
        )
    return lines


def _loops(loops: list[dict[str, Any]]) -> list[str]:
    if not loops:
        return []
    rows = [("closed loop", "between", "constraints")]
    for loop in loops:
        between = f"{loop['first']['body']} and {loop['second']['body']}"
        rows.append((loop["name"], between, ", ".join(loop["constraints"])))
    return table(rows, "<<<")


def _parameters(parameters: list[dict[str, Any]]) -> list[str]:
    if not parameters:
        return []
    rows = [("parameter", "value", "", "")]
    for parameter in parameters:
        rows.append((parameter["name"], written(parameter["value"]), parameter.get("unit") or "",
                     parameter.get("label") or ""))  # fmt: skip
    return table(rows, "<><<")


def _laws(heading: str, laws: dict[str, Any]) -> list[str]:
    if not laws:
        return [f"{heading}: none"]
    rows = [(heading, "", "", "")]
    for name, law in laws.items():
        ((kind, fields),) = law.items()
        rows.append((name, kind.replace("_", " "), on_or_off(fields), _fields(fields)))
    return table(rows, "<<<<")


def on_or_off(fields: dict[str, Any]) -> str:
    """Whether a law acts."""
    return "on" if fields["enabled"] else "off"


def _cylinders(cylinders: dict[str, Any]) -> list[str]:
    """Hydraulic cylinders: their pins in the drawing frames, and what bounds them."""
    if not cylinders:
        return []
    rows = [("hydraulic cylinder", "", "pins, m", "stroke, m", "push, N", "pull, N", "speed, m/s", "target")]
    for name, cylinder in cylinders.items():
        rows.append((
            name,
            on_or_off(cylinder),
            " to ".join(f"{pin['body']} {written(pin['position_m'])}" for pin in _ends(cylinder)),
            f"{cylinder['shortest_m']:g} to {cylinder['longest_m']:g}",
            *(f"{cylinder[f'{limit}_limit_N']:g}" for limit in ("push", "pull")),
            f"{cylinder['speed_limit_m_s']:g}",
            target(cylinder["target"]),
        ))  # fmt: skip
    return table(rows, "<<<<>>><")


def _ends(law: dict[str, Any]) -> list[dict[str, Any]]:
    return [law["first"], law["second"]]


def target(given: str | dict[str, Any]) -> str:
    """What a cylinder is after.

    >>> target("hold"), target({"length": {"length_m": 7.2}})
    ('hold', '7.2 m')
    """
    return given if isinstance(given, str) else f"{given['length']['length_m']:g} m"


def _fields(fields: dict[str, Any]) -> str:
    """A law's fields as a scenario writes them; of a pulse and a list what is the history.

    >>> _fields({"enabled": True, "joint": "luff", "target_rad": 0.5, "pulse": None})
    'joint: luff, target_rad: 0.5'
    """
    hidden = {"enabled", "pulse", "list"} - {fields.get("history")}
    return ", ".join(f"{name}: {written(value)}" for name, value in fields.items() if name not in hidden)


def _prescribed(resolved: dict[str, Any]) -> list[str]:
    """The joints that a given rate moves, or that go a given way."""
    rows = [("prescribed", "")]
    for name, body in resolved["bodies"].items():
        ((_, joint),) = body["joint"].items()
        mode = joint.get("mode")
        if body["enabled"] and isinstance(mode, dict):
            ((_, given),) = mode.items()
            rows.append((joint.get("name") or name, _fields(given)))
    return table(rows, "<<") if len(rows) > 1 else []


def written(value: Any) -> str:
    """A value as a scenario writes it.

    >>> written(True), written(-10.0), written("pulse"), written([0, 0.5]), written({"rise_s": 1})
    ('true', '-10', 'pulse', '[0, 0.5]', '{rise_s: 1}')
    """
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, dict):
        return f"{{{', '.join(f'{name}: {written(entry)}' for name, entry in value.items())}}}"
    if isinstance(value, list):
        return f"[{', '.join(map(written, value))}]"
    return f"{value:g}" if isinstance(value, int | float) else str(value)

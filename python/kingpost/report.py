"""What the command line prints of a run and of a model."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from .results import gravity_m_s2

if TYPE_CHECKING:
    import xarray

    from .scenario import Scenario

# Share of the energy in play beyond which a summary warns that the step is too large.
WORST_ENERGY_ERROR = 0.01

# Rows of a table that a summary prints.
MOST_ROWS = 20

# Ends of the names of axes that slide, in joints of several axes.
SLIDING_AXES = (".x", ".y", ".translation", ".shear_y", ".shear_z")

ANGLES = {"roll": "x", "pitch": "y", "yaw": "z"}


def table(rows: Iterable[Sequence[str]], align: str = "") -> list[str]:
    """Cells in columns; `align` has ``<`` or ``>`` for each (default: the first ``<``).

    >>> table([("ship", "1"), ("arm", "10")])
    ['ship   1', 'arm   10']
    >>> table([("ship", "1"), ("arm", "10")], "><")
    ['ship  1', ' arm  10']
    """
    rows = list(rows)
    if not rows:
        return []
    align = align or "<".ljust(len(rows[0]), ">")
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    formats = [f"{{:{side}{width}}}" for side, width in zip(align, widths, strict=True)]
    form = "  ".join(formats)
    return [form.format(*row).rstrip() for row in rows]


def summary(results: xarray.Dataset, scenario: Scenario) -> str:
    """Final time, motion of each ship, joints, energy and momentum of a run.

    Angles in degrees, rates in rad/s: roll, pitch and yaw rate are the body's angular velocity
    about its x, y and z axis.
    """
    time = results["time"].values
    simulation = scenario.resolved["simulation"]
    lines = [
        scenario.title,
        f"{time[-1]:g} s by {simulation['integrator']} in steps of {simulation['step_s']:g} s, "
        f"{len(time)} records",
    ]
    for body in ships(scenario):
        lines += ["", *_ship(results, body)]
    if results.sizes.get("coordinate", 0):
        lines += ["", *_joints(results, scenario), "", *_reactions(results)]
    return "\n".join([*lines, "", *_ledger(results)])


def ships(scenario: Scenario) -> list[str]:
    """Names of the bodies that float."""
    joints = scenario.model["joints"]
    return [joint["body"] for joint in joints if joint["kind"] == "floating"]


def _ship(results: xarray.Dataset, body: str) -> list[str]:
    rows = [(body, *ANGLES)]
    angle = [np.degrees(results[name].sel(body=body).values) for name in ANGLES]
    rate = [results["angular_velocity"].sel(body=body, axis=axis).values for axis in "xyz"]
    rows.append(("angle at the end, deg", *(fixed(values[-1], 4) for values in angle)))
    rows.append(("largest angle, deg", *(fixed(largest(values), 4) for values in angle)))
    rows.append(("rate at the end, rad/s", *(fixed(values[-1], 6) for values in rate)))
    rows.append(("largest rate, rad/s", *(fixed(largest(values), 6) for values in rate)))
    return table(rows)


def fixed(value: float, places: int) -> str:
    """A number with a fixed count of decimals, and no sign on a zero.

    >>> fixed(-0.00001, 4), fixed(-0.0617, 4)
    ('0.0000', '-0.0617')
    """
    return f"{value:z.{places}f}"


def significant(value: float, scale: float) -> str:
    """A number with five digits; 0 where it is rounding beside `scale`.

    >>> significant(17922.43, 2e4), significant(1e-8, 2e4)
    ('17922', '0')
    """
    return f"{0.0 if abs(value) < 1e-12 * scale else value:.5g}"


def joules(value: float) -> str:
    """An energy with the prefix that suits its size.

    >>> joules(171588.0), joules(-0.0)
    ('171.588 kJ', '0 J')
    """
    for size, unit in ((1e9, "GJ"), (1e6, "MJ"), (1e3, "kJ")):
        if abs(value) >= size:
            return f"{value / size:.6g} {unit}"
    return f"{value + 0.0:.6g} J"


def largest(values: np.ndarray) -> float:
    """The value that is largest in size, with its sign.

    >>> float(largest(np.array([1.0, -3.0, 2.0])))
    -3.0
    """
    return values[np.argmax(np.abs(values))]


def _joints(results: xarray.Dataset, scenario: Scenario) -> list[str]:
    """Each joint coordinate: where it ends, the largest values, and the force or torque it carries."""
    rows = [("joint", "position", "largest", "", "rate", "largest", "", "largest force", "")]
    most_force = float(np.abs(results["joint_reaction"].values).max())
    slides = {joint["name"] for joint in scenario.model["joints"] if joint["kind"] == "prismatic"}
    for name in results["coordinate"].values:
        position, rate, force = (
            results[variable].sel(coordinate=name)
            for variable in ("joint_position", "joint_velocity", "joint_force")
        )
        rows.append((
            str(name),
            *(fixed(value, 6) for value in (position.values[-1], largest(position.values))),
            _unit(position, _slides(str(name), slides)),
            *(fixed(value, 6) for value in (rate.values[-1], largest(rate.values))),
            _unit(rate, _slides(str(name), slides)),
            significant(largest(force.values), most_force),
            _unit(force, _slides(str(name), slides)),
        ))  # fmt: skip
    return table(_shortened(rows), "<>><>><><")


def _slides(coordinate: str, prismatic: set[str]) -> bool:
    """Whether a coordinate is a length: of a prismatic joint, or of a sliding axis of several.

    >>> _slides("boom.1.shear_z", set()), _slides("boom.1.torsion", set()), _slides("slide", {"slide"})
    (True, False, True)
    """
    return coordinate in prismatic or coordinate.endswith(SLIDING_AXES)


def _unit(values: xarray.DataArray, slides: bool) -> str:
    """The unit of one coordinate, where the channel names that of turning and that of sliding."""
    units = values.attrs["units"].split(" or ")
    return units[-1 if slides else 0]


def _reactions(results: xarray.Dataset) -> list[str]:
    """What each joint carries at most: the lengths of its force and of its moment."""
    force, moment = (
        np.linalg.norm(
            results["joint_reaction"].sel(component=[f"{kind}_{axis}" for axis in "xyz"]), axis=-1
        ).max(axis=0)
        for kind in ("force", "moment")
    )
    most = max(force.max(), moment.max())
    rows = [("reaction, largest", "force", "", "moment", "")]
    for name, f, m in zip(results["joint"].values, force, moment, strict=True):
        rows.append((str(name), significant(f, most), "N", significant(m, most), "N m"))
    return table(_shortened(rows), "<><><")


def _shortened(rows: list[tuple[str, ...]]) -> list[tuple[str, ...]]:
    """A heading and the first rows under it; the rest is in the results."""
    left = len(rows) - 1 - MOST_ROWS
    if left <= 0:
        return rows
    more = (f"and {left} more, in the results", *("" for _ in rows[0][1:]))
    return [*rows[: 1 + MOST_ROWS], more]


def _ledger(results: xarray.Dataset) -> list[str]:
    last = results.isel(time=-1)
    work = float(last["work_done"])
    error = float(last["energy_error"])
    relative = f" ({error / work:+.2e} of the work done)" if work else ""
    rows = [
        ("kinetic energy", joules(float(last["kinetic_energy"]))),
        ("potential energy", joules(float(last["potential_energy"]))),
        ("work done", joules(work)),
        ("energy dissipated", joules(float(last["energy_dissipated"]))),
        ("energy error", f"{error:+.3e} J{relative}"),
        ("momentum error", f"{float(last['momentum_error']):.3e} N m s"),
    ]
    lines = table(rows, "<<")
    scale = max(abs(work), float(last["kinetic_energy"]))
    if abs(error) > WORST_ENERGY_ERROR * scale:
        off = f"{abs(error) / scale:.1%}"
        lines += ["", f"warning: the energy is off by {off}: take a smaller simulation.step_s"]
    return lines


def model(scenario: Scenario, coordinates: Sequence[str]) -> str:
    """What a scenario builds: bodies, joints, parameters, drives and forces."""
    resolved = scenario.resolved
    described = scenario.model
    settings = resolved["simulation"]
    mass = sum(body["mass_kg"] for body in described["bodies"])
    sections = [
        [scenario.title],
        _bodies(described),
        [f"total mass: {mass:g} kg", f"free coordinates ({len(coordinates)}): {', '.join(coordinates)}"],
        _parameters(described["parameters"]),
        _laws("drives", resolved.get("drives", {})),
        _prescribed(resolved),
        _laws("forces", resolved.get("forces", {})),
        _falling(resolved),
        [
            f"{settings['integrator']}, {settings['duration_s']:g} s in steps of "
            f"{settings['step_s']:g} s, recorded every {settings['record_every_s']:g} s"
        ],
    ]
    return "\n\n".join("\n".join(lines) for lines in sections if lines)


def _bodies(described: dict[str, Any]) -> list[str]:
    joints = {joint["body"]: joint for joint in described["joints"]}
    rows = [("body", "mass", "parent", "joint")]
    for body in described["bodies"]:
        joint = joints.get(body["name"])
        how = f"{joint['kind']} {joint['name']}" if joint else ""
        rows.append((body["name"], f"{body['mass_kg']:g} kg", body.get("parent") or "world", how))
    return table(rows, "<><<")


def _parameters(parameters: list[dict[str, Any]]) -> list[str]:
    if not parameters:
        return []
    rows = [("parameter", "value", "", "")]
    for parameter in parameters:
        rows.append((parameter["name"], text(parameter["value"]), parameter.get("unit") or "",
                     parameter.get("label") or ""))  # fmt: skip
    return table(rows, "<><<")


def _laws(heading: str, laws: dict[str, Any]) -> list[str]:
    if not laws:
        return [f"{heading}: none"]
    rows = [(heading, "", "", "")]
    for name, law in laws.items():
        ((kind, fields),) = law.items()
        rows.append((name, kind.replace("_", " "), "on" if fields["enabled"] else "off", _fields(fields)))
    return table(rows, "<<<<")


def _fields(fields: dict[str, Any]) -> str:
    """A law's fields as a scenario writes them; a pulse only where it is the history.

    >>> _fields({"enabled": True, "joint": "luff", "target_rad": 0.5, "pulse": None})
    'joint: luff, target_rad: 0.5'
    """
    hidden = {"enabled"} if fields.get("history") == "pulse" else {"enabled", "pulse"}
    return ", ".join(f"{name}: {text(value)}" for name, value in fields.items() if name not in hidden)


def _prescribed(resolved: dict[str, Any]) -> list[str]:
    """The joints that a given rate moves."""
    rows = [("prescribed", "")]
    for name, body in resolved["bodies"].items():
        ((_, joint),) = body["joint"].items()
        mode = joint.get("mode")
        if body["enabled"] and isinstance(mode, dict):
            rows.append((joint.get("name") or name, _fields(mode["prescribed"])))
    return table(rows, "<<") if len(rows) > 1 else []


def _falling(resolved: dict[str, Any]) -> list[str]:
    """A note on each floating body that gravity pulls on and nothing carries."""
    if not gravity_m_s2(resolved):
        return []
    floating = {
        name: body["joint"].get("floating") for name, body in resolved["bodies"].items() if body["enabled"]
    }
    free = [name for name, joint in floating.items() if joint and not joint["hold_translation"]]
    return [f"note: gravity acts and nothing carries {name}: it falls" for name in free]


def text(value: Any) -> str:
    """A value as a scenario writes it.

    >>> text(True), text(-10.0), text("pulse"), text([0, 0.5]), text({"rise_s": 1})
    ('true', '-10', 'pulse', '[0, 0.5]', '{rise_s: 1}')
    """
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, dict):
        return f"{{{', '.join(f'{name}: {text(entry)}' for name, entry in value.items())}}}"
    if isinstance(value, list):
        return f"[{', '.join(map(text, value))}]"
    return f"{value:g}" if isinstance(value, int | float) else str(value)

"""Report of a run."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING, Any

import numpy as np

from ..results.columns import columns, unit_of
from ..results.entries import events_of, limits_of, model_warnings_of, warnings_of
from ..results.units import engineering
from .selection import is_single_force, is_single_number
from .tables import fixed, joules, largest, significant, table, unit_cell

if TYPE_CHECKING:
    import xarray

    from ..scenario import Scenario

# Largest number of rows of a table in a summary.
MOST_ROWS = 20

AXES = ("x", "y", "z")
ANGLES = {"roll": "x", "pitch": "y", "yaw": "z"}


def summary(results: xarray.Dataset, scenario: Scenario) -> str:
    """Final time, motion of each ship, joints, closed loops, named points, forces and drives, energy and
    momentum of a run.

    Forces in kN, angles in degrees, rates in rad/s: roll, pitch and yaw rate are the body's angular velocity
    about its x, y and z axis.
    """
    time = results["time"].values
    simulation = scenario.resolved["simulation"]
    lines = [
        scenario.title,
        f"{time[-1]:g} s by {simulation['integrator']} {steps(simulation)}, {len(time)} records",
    ]
    for body in ships(scenario):
        lines += ["", *_ship(results, body)]
    if results.sizes.get("coordinate", 0):
        reactions = _reactions(results, "joint", "reaction, largest")
        lines += ["", *_joints(results), "", *reactions]
    if results.sizes.get("loop", 0):
        lines += ["", *_reactions(results, "loop", "loop reaction, largest"), *_loop_error(results)]
    for block in (_points(results), _elements(results)):
        if block:
            lines += ["", *block]
    lines += ["", *_ledger(results)]
    return "\n".join(lines)


def numbers(results: xarray.Dataset, scenario: Scenario) -> dict[str, Any]:
    """The outcome of a run, in SI units: its end, events, warnings and limits, and the last, smallest and
    largest value of each column."""
    of_columns = {
        name: {"unit": unit_of(series), "last": series.values[-1], "smallest": series.values.min(),
               "largest": series.values.max()}
        for name, series in columns(results)
    }  # fmt: skip
    return {
        "title": scenario.title,
        "status": results.attrs["status"],
        "time_s": results["time"].values[-1],
        "records": results.sizes["time"],
        "limits": limits_of(results),
        "events": events_of(results),
        "warnings": warnings_of(results),
        "model_warnings": model_warnings_of(results),
        "columns": of_columns,
    }


def steps(simulation: dict[str, Any]) -> str:
    """Text on the step size of a scenario's integrator.

    >>> steps({"integrator": "rk4", "step_s": 0.001})
    'in steps of 0.001 s'
    >>> steps({"integrator": "dormand_prince", "dormand_prince": {"largest_step_s": 0.1}})
    'in steps that it chooses, at most 0.1 s'
    """
    if simulation["integrator"] == "dormand_prince":
        largest_s = simulation["dormand_prince"]["largest_step_s"]
        return f"in steps that it chooses, at most {largest_s:g} s"
    return f"in steps of {simulation['step_s']:g} s"


def ships(scenario: Scenario) -> list[str]:
    """Names of the bodies that float, and of ships that waves move."""
    return [body["name"] for body in scenario.model["bodies"] if body["floats"]]


def _ship(results: xarray.Dataset, body: str) -> list[str]:
    rows = [(body, *ANGLES)]
    angle = [np.degrees(results[name].sel(body=body).values) for name in ANGLES]
    rate = [results["angular_velocity"].sel(body=body, axis=axis).values for axis in "xyz"]
    rows.append(("angle at the end, deg", *(fixed(values[-1], 4) for values in angle)))
    rows.append(("largest angle, deg", *(fixed(largest(values), 4) for values in angle)))
    rows.append(("rate at the end, rad/s", *(fixed(values[-1], 6) for values in rate)))
    rows.append(("largest rate, rad/s", *(fixed(largest(values), 6) for values in rate)))
    return table(rows)


def _joints(results: xarray.Dataset) -> list[str]:
    """Table of the joint coordinates: value at the end, largest values, and the transmitted force or
    torque."""
    rows: list[tuple[str, ...]] = [
        ("joint", "position", "largest", "", "rate", "largest", "", "largest force", "")
    ]
    in_degrees = 180 / np.pi
    most_force = float(np.abs(results["joint_reaction"].values).max())
    for name in results["coordinate"].values:
        position, rate, force = (
            results[variable].sel(coordinate=name)
            for variable in ("joint_position", "joint_velocity", "joint_force")
        )
        turns = unit_of(position) == "rad"
        scale, unit, places = (in_degrees, "deg", 4) if turns else (1.0, "m", 6)
        rows.append((
            str(name),
            *(fixed(scale * value, places) for value in (position.values[-1], largest(position.values))),
            unit,
            *(fixed(value, 6) for value in (rate.values[-1], largest(rate.values))),
            unit_of(rate),
            *_shown(largest(force.values), most_force, unit_of(force)),
        ))  # fmt: skip
    return table(_shortened(rows), "<>><>><><")


def _shown(value: float, most: float, unit: str) -> tuple[str, str]:
    """A number with its engineering unit."""
    shown, size = engineering(unit)
    return significant(value / size, most / size), shown


def _points(results: xarray.Dataset) -> list[str]:
    """The range of named points, such as a crane tip, in each direction, and their largest speed."""
    if not results.sizes.get("point", 0):
        return []
    rows: list[tuple[str, ...]] = [("point, range, m", *AXES, "largest speed, m/s")]
    for name in results["point"].values:
        position, velocity = (
            results[variable].sel(point=name).values for variable in ("point_position", "point_velocity")
        )
        speed = np.linalg.norm(velocity, axis=-1).max()
        rows.append((str(name), *(fixed(value, 4) for value in np.ptp(position, axis=0)), fixed(speed, 4)))
    return table(_shortened(rows))


def _reactions(results: xarray.Dataset, dim: str, heading: str) -> list[str]:
    """The largest reaction of each joint or closed loop: the magnitudes of its force and its moment."""
    force, moment = (
        np.linalg.norm(
            results[f"{dim}_reaction"].sel(component=[f"{kind}_{axis}" for axis in "xyz"]), axis=-1
        ).max(axis=0)
        for kind in ("force", "moment")
    )
    most = max(force.max(), moment.max())
    rows: list[tuple[str, ...]] = [(heading, "force", "", "moment", "")]
    for name, f, m in zip(results[dim].values, force, moment, strict=True):
        rows.append((str(name), *_shown(f, most, "N"), *_shown(m, most, "N m")))
    return table(_shortened(rows), "<><><")


def _loop_error(results: xarray.Dataset) -> list[str]:
    """The largest error of the closed loops, and its constraint."""
    worst = np.abs(results["loop_error"].values).max(axis=0)
    constraint = str(results["constraint"].values[worst.argmax()])
    unit = unit_of(results["loop_error"].sel(constraint=constraint))
    return [f"loop error, largest: {worst.max():.1e} {unit} along {constraint}"]


def _elements(results: xarray.Dataset) -> list[str]:
    """Scalar outputs of forces and drives: at the end, the smallest and the largest."""
    rows: list[tuple[str, ...]] = [("force or drive", "", "at the end", "smallest", "largest", "")]
    shown = [variable for variable in results.data_vars.values() if is_single_number(variable)]
    names = Counter(variable.attrs["long_name"] for variable in shown)
    # Forces first: hook load and line tensions matter most.
    for variable in sorted(shown, key=lambda one: not is_single_force(one)):
        # Both ends of a rope have the same short name.
        is_shared = names[variable.attrs["long_name"]] > 1
        words = variable.attrs["description" if is_shared else "long_name"]
        (things,) = (dim for dim in variable.dims if dim != "time")
        for thing in results[things].values:
            series = variable.sel({things: thing})
            unit, size = engineering(unit_of(series))
            values = (series.values[-1], series.values.min(), series.values.max())
            most = np.abs(series.values).max()
            shown_values = (significant(value / size, most / size) for value in values)
            rows.append((str(thing), words, *shown_values, unit_cell(unit)))
    return table(_shortened(rows), "<<>>><") if len(rows) > 1 else []


def _shortened(rows: list[tuple[str, ...]]) -> list[tuple[str, ...]]:
    """Print a heading and the first rows of a table; all rows are in the results."""
    left = len(rows) - 1 - MOST_ROWS
    if left <= 0:
        return rows
    more = (f"and {left} more, in the results", *("" for _ in rows[0][1:]))
    return [*rows[: 1 + MOST_ROWS], more]


def _ledger(results: xarray.Dataset) -> list[str]:
    last = results.isel(time=-1)
    energy, momentum = (float(results[f"{of}_scale"].max()) for of in ("energy", "momentum"))
    error, off = float(last["energy_error"]), float(last["momentum_error"])
    rows = [
        ("kinetic energy", joules(float(last["kinetic_energy"]))),
        ("potential energy", joules(float(last["potential_energy"]))),
        ("work done", joules(float(last["work_done"]))),
        ("energy dissipated", joules(float(last["energy_dissipated"]))),
        ("energy error", f"{error:+.3e} J{_share(error, energy, 'energy')}"),
        ("momentum error", f"{off:.3e} N m s{_share(off, momentum, 'angular momentum')}"),
    ]
    return table(rows, "<<")


def _share(error: float, scale: float, of: str) -> str:
    """An error relative to the largest energy or momentum in the run so far; the app shows the same."""
    return f" ({error / scale:+.2e} of the largest {of} in play)" if scale else ""

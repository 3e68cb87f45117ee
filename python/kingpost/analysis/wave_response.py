"""Linear response of every column of the results to regular waves about rest."""

from __future__ import annotations

import difflib
from collections.abc import Sequence
from fnmatch import fnmatchcase
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import results
from ..errors import KingpostError
from ..scenario import Overrides, Scenario, as_scenario
from ..simulation.python_warnings import record_warnings
from ..simulation.simulate import Simulation
from .response import DIRECTIONS_DEG, PHASE, frequencies_that_all_cover, onto_ends, within_one_turn

if TYPE_CHECKING:
    import xarray
    from numpy.typing import ArrayLike

REASONS = {
    "not_smooth": "its derivative at rest does not exist, or differs between the two sides",
    "second_order": "at rest it changes with the square of motions or waves",
    "over_time": "it is an integral over the run, or its time",
    "sampled": "it is held between the samples of its element",
}
"""Reasons why a column has no linear response to small waves."""


def wave_response(
    scenario_or_simulation: Scenario | Simulation | str | Path,
    columns: Sequence[str] | None = None,
    directions_rad: ArrayLike | None = None,
    frequencies_rad_s: ArrayLike | None = None,
    overrides: Overrides | None = None,
    **parameters: Any,
) -> xarray.Dataset:
    """Compute the amplitudes of columns of the results per metre of wave amplitude, about rest in still
    water.

    With A of the exact linearisation, the accelerations b by the waves' forces f, and the derivatives C and
    D of a row of results by states and by forces, ``H = C (-i w - A)^-1 b + D f + E``; E is the direct part
    of the waves in a column, such as their elevation in an air gap. Under the wave elevation ``Re{a e^(-i w
    t)}`` at the reference point the column is ``mean + Re{a H e^(-i w t)}`` (for a hull alone Newman, *Marine
    Hydrodynamics*, 1977, sec. 6.17). Held and prescribed joints and sampled outputs are constant; effects of
    second order at rest, such as quadratic damping and drift, do not contribute.

    Parameters
    ----------
    scenario_or_simulation
        A scenario, with the crane at the start of a run; or a simulation, with the crane in its present
        state.
    columns
        Names or patterns (with ``*``) of columns, such as ``hull.roll``; default: all.
    directions_rad
        Directions that the waves travel towards, counter-clockwise from the world's x, rad; default: every 45
        degrees.
    frequencies_rad_s
        Angular frequencies, rad/s; default: those of `kingpost.rao`, and more about each resonance.
    overrides, parameters
        Values that override those of a scenario.

    Returns
    -------
    xarray.Dataset
        ``response`` (the amplitude) and ``response_phase`` (the lag behind the crest at the reference
        point, rad) by ``column``, ``direction`` (rad) and ``omega`` (rad/s); by ``column`` the value at
        rest, ``mean``, whether it is ``linear``, and if not the ``reason``. `complex_amplitude` of
        `kingpost.analysis.response` puts both parts together. Attributes: ``reference_m``, ``heading_rad``,
        ``resonances_rad_s`` with ``resonance_decays_per_s``, ``warning``.

    Raises
    ------
    KingpostError
        If there is no equilibrium, no waves act, a database does not cover a frequency, or a column is
        unknown.

    >>> found = wave_response("offshore_vessel", ["hull.roll", "load.acceleration.z"], [np.pi / 2], [0.3])
    >>> found.response.sizes["column"], bool(found.linear.all())
    (2, True)
    """
    simulation = as_simulation(scenario_or_simulation, overrides, parameters)
    given = np.deg2rad(DIRECTIONS_DEG) if directions_rad is None else np.atleast_1d(directions_rad)
    directions = within_one_turn(np.asarray(given, float))
    covered = frequencies_that_all_cover(simulation.scenario)
    asked = covered if frequencies_rad_s is None else onto_ends(frequencies_rad_s, covered)
    chosen = [] if columns is None else matching(simulation, columns)
    found = simulation.column_response(directions, asked, chosen, about_resonances=frequencies_rad_s is None)
    return _dataset(simulation, found)


def matching(simulation: Simulation, patterns: Sequence[str]) -> list[str]:
    """Return the columns whose names match one of the patterns, without repetitions, in the order of the
    patterns.

    Parameters
    ----------
    simulation
        Simulation whose columns are searched.
    patterns
        Names, with ``*`` for any letters.

    Returns
    -------
    list of str
        Names of columns.

    Raises
    ------
    KingpostError
        If a pattern matches no column.

    >>> matching(Simulation("paper"), ["ship.ro*", "ship.yaw"])
    ['ship.roll', 'ship.yaw']
    """
    every = [name for channel in simulation.channels for name in channel["columns"]]
    found: dict[str, None] = {}
    for pattern in patterns:
        like = [name for name in every if fnmatchcase(name, pattern)]
        if not like:
            near = difflib.get_close_matches(pattern, every, n=3) or every[:3]
            raise KingpostError(
                f"columns: found {pattern!r}, allowed: a column of the results, as {', '.join(near)}"
            )
        found |= dict.fromkeys(like)
    return list(found)


def as_simulation(
    given: Scenario | Simulation | str | Path, overrides: Overrides | None, parameters: dict[str, Any]
) -> Simulation:
    """Return the given simulation, or the simulation of a scenario with overrides."""
    if not isinstance(given, Simulation):
        return Simulation(as_scenario(given, overrides, parameters))
    if overrides or parameters:
        raise KingpostError("overrides: found some for a simulation, allowed: for a scenario only")
    return given


def _dataset(simulation: Simulation, found: dict[str, Any]) -> xarray.Dataset:
    import xarray

    h = np.moveaxis(found["amplitudes"], -1, 0)
    not_linear = found["not_linear"]
    dims = ("column", "direction", "omega")
    amplitude = {"long_name": "amplitude for each metre of wave amplitude"}
    lag = {"units": "rad", "long_name": "lag behind the crest at the reference point"}
    variables = {
        "response": (dims, np.abs(h), amplitude),
        f"response{PHASE}": (dims, np.angle(h), lag),
        "mean": ("column", np.array(found["mean"], float), {"long_name": "value at rest in still water"}),
        "linear": ("column", [reason is None for reason in not_linear]),
        "reason": ("column", np.array([REASONS[reason] if reason else "" for reason in not_linear], str)),
    }
    units = np.array(found["units"], str)
    per_metre = np.array([f"{unit}/m" for unit in found["units"]], str)
    about = {"units": "rad", "long_name": "direction that the waves go to, from x counter-clockwise"}
    coordinates = {
        "column": np.array(found["columns"], str),
        "direction": ("direction", np.array(found["directions_rad"]), about),
        "omega": (
            "omega",
            np.array(found["frequencies_rad_s"]),
            {"units": "rad/s", "long_name": "angular frequency"},
        ),
        results.unit_coordinate("response"): ("column", per_metre),
        results.unit_coordinate("mean"): ("column", units),
    }
    attributes = results.attributes(simulation.scenario, "about rest in still water")
    attributes["reference_m"] = found["reference_m"]
    attributes["heading_rad"] = found["heading_rad"]
    attributes["resonances_rad_s"] = [one["frequency_rad_s"] for one in found["resonances"]]
    attributes["resonance_decays_per_s"] = [one["decay_per_s"] for one in found["resonances"]]
    record_warnings(attributes, [*simulation.scenario.model["warnings"], *found["warnings"]])
    return xarray.Dataset(variables, coordinates, attributes)

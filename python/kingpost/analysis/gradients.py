"""Gradients: a run with the exact derivatives of every result with respect to parameters."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import results
from ..scenario import Overrides, Scenario, as_scenario
from ..simulation.simulate import Progress

if TYPE_CHECKING:
    import xarray

    from ..results.channels import Channel

DERIVATIVE = "_derivative"
"""Suffix of the name of a variable's derivatives."""
PER_UNIT = " per unit of the parameter"
"""Suffix of the units of derivatives."""


def gradient(
    scenario_or_path: Scenario | str | Path,
    names: str | Sequence[str],
    overrides: Overrides | None = None,
    *,
    progress: Progress | None = None,
    **parameters: Any,
) -> xarray.Dataset:
    """Run a scenario with the derivatives of every result with respect to parameters.

    The whole run is computed with dual numbers. Between events these are the derivatives of the computed
    numbers, exact to rounding, for this scheme and step. Across an event, whose time depends on the
    parameter, they are the derivatives of the motion, within the scheme's error. Four names cost about one
    run of dual numbers.

    Parameters
    ----------
    scenario_or_path, overrides, parameters
        Scenario and overrides, as in `run`.
    names
        Parameters, or dotted paths of numbers, with respect to which to differentiate. The derivative is per
        the parameter's own unit: per degree for an angle in degrees.
    progress
        Called at intervals with the simulated time, s; the time starts again for every four names.

    Returns
    -------
    xarray.Dataset
        The variables of `run`, and for each variable, such as ``roll``, its derivatives, here
        ``roll_derivative``, with ``parameter`` as the first dimension.

    Raises
    ------
    ScenarioError
        If the scenario is wrong, or a name has no derivative because it switches something, or changes the
        structure, the stepping or the times at which laws change their form.
    RunError
        When the motion diverges; `.results` holds what was computed.
    KeyboardInterrupt
        On Ctrl-C; `.results` holds the results so far, for the names that were reached. The same holds for
        any exception from `progress`.

    >>> found = gradient("paper", "crane_x_m", {"simulation.duration_s": 0.1})
    >>> found.roll_derivative.dims
    ('parameter', 'time', 'body')
    """
    scenario = as_scenario(scenario_or_path, overrides, parameters)
    names = [names] if isinstance(names, str) else [str(name) for name in names]
    rows, derivatives, channels_json, error = scenario._built.gradient(names, progress)
    channels = json.loads(channels_json)
    status = "finished" if error is None else str(error) or "interrupted"
    names = names[: len(derivatives)]
    run = results.dataset(scenario, channels, rows, status)
    found = _with_derivatives(run, scenario, channels, names, derivatives)
    if error is not None:
        error.results = found
        raise error
    return found


def _with_derivatives(
    run: xarray.Dataset,
    scenario: Scenario,
    channels: list[Channel],
    names: list[str],
    derivatives: list[np.ndarray],
) -> xarray.Dataset:
    along = [results.dataset(scenario, channels, rows, "") for rows in derivatives]
    units = {parameter["name"]: parameter.get("unit") for parameter in scenario.model["parameters"]}
    found = run.assign_coords(parameter=np.array(names, str))
    found = found.assign_coords(
        parameter_unit=("parameter", np.array([units.get(name) or "" for name in names], str))
    )
    for name, variable in run.data_vars.items():
        values = np.stack([each[name].values for each in along])
        about = variable.attrs | {
            "long_name": f"derivative of {variable.attrs['long_name']}",
            "column": ".".join(
                f"{part}{DERIVATIVE}.{{parameter}}" if part == name else part
                for part in variable.attrs["column"].split(".")
            ),
        }
        if "units" in about:
            about["units"] += PER_UNIT
        else:
            of_variable = np.char.add(
                variable.coords[results.unit_coordinate(name)].values.astype(str), PER_UNIT
            )
            unit_dims = ("parameter", *variable.coords[results.unit_coordinate(name)].dims)
            per_unit = np.broadcast_to(of_variable, (len(names), *of_variable.shape))
            found = found.assign_coords(
                {results.unit_coordinate(f"{name}{DERIVATIVE}"): (unit_dims, per_unit)}
            )
        found[f"{name}{DERIVATIVE}"] = (("parameter", *variable.dims), values, about)
    return found

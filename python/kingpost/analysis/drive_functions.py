"""Drive functions that keep a load in place, found with exact gradients of whole runs."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import KingpostError
from ..scenario import Overrides, Scenario, as_scenario
from ..simulation.simulate import run
from .gradients import DERIVATIVE, gradient

if TYPE_CHECKING:
    import xarray

Array = NDArray[np.float64]
KIND = "drive_function"
"""Kind of the controllers whose commands are found."""


@dataclass(frozen=True)
class DriveFunctions:
    """Commands of drive functions and the remaining deviations; made by `drive_functions`.

    Attributes
    ----------
    scenario
        The scenario with the commands found.
    commands
        The commands of each controller, in the SI unit of its input.
    deviation_before, deviation
        Root mean square deviation of each column from its wanted values, with the commands of the given
        scenario and with the commands found, SI units.
    iterations
        Number of steps of the search, each with one exact gradient.
    results
        The run with the commands found.
    """

    scenario: Scenario
    commands: dict[str, list[float]]
    deviation_before: dict[str, float]
    deviation: dict[str, float]
    iterations: int
    results: xarray.Dataset


def drive_functions(
    scenario_or_path: Scenario | str | Path,
    controllers: str | Sequence[str],
    overrides: Overrides | None = None,
    *,
    wanted: Mapping[str, float | ArrayLike | None],
    weights: Mapping[str, float] | None = None,
    from_s: float = 0.0,
    iterations: int = 20,
    tolerance: float = 1e-6,
    **parameters: Any,
) -> DriveFunctions:
    """Find the commands of drive functions that bring columns of a run nearest to their wanted values.

    Over the records of the run from ``from_s`` on, with the columns y, the wanted values w and the weights g,
    it minimises over all commands ``p``

    ``J = mean over time of sum_i g_i^2 (y_i - w_i)^2``

    by the method of Gauss and Newton in a trust region (`scipy.optimize.least_squares`; Moré, *Lecture Notes
    in Mathematics* 630, 1978, p. 105), with the exact derivatives dy/dp of the whole run by `gradient`: the
    drives' lags and limits, the ropes and the swing of the load are part of it. On a moving base these are
    the drive functions of Maczyński & Wojciech, "Stabilization of load's position in offshore cranes", *J.
    Offshore Mech. Arct. Eng.* 134(2), 2012, 021101.

    Parameters
    ----------
    scenario_or_path, overrides, parameters
        Scenario and overrides, as in `run`. The functions are found for the base motion or the sea of this
        scenario.
    controllers
        The controllers ``drive_function`` whose commands are found. Their times stay.
    wanted
        For each column of the results its value, or values over the records of the whole run, in SI units;
        None for its value at the start of the run.
    weights
        Weights g of the columns, per SI unit; default: 1.
    from_s
        Records before this time do not count, for example while a motion grows from rest.
    iterations
        Largest number of steps of the search.
    tolerance
        The search ends when a step lowers J by less than this share of it.

    Returns
    -------
    DriveFunctions
        The commands, the scenario with them, and the deviations with and without.

    Raises
    ------
    KingpostError
        If a controller is not an enabled ``drive_function``, a column is unknown, or a function moves none of
        the columns.
    ScenarioError
        If the scenario is wrong.
    RunError
        When a run with commands of the search diverges; `.results` holds what was computed.

    Examples
    --------
    A cage of 1 kg on a spring of 40 N/m is to follow a ramp. The force for it grows with the distance.

    >>> joint = {"name": "slide", "axis": [1, 0, 0], "spring": {"stiffness_N_per_m": 40, "rest_m": 0}}
    >>> cage = {"mass_kg": 1, "shape": {"point": {}}, "joint": {"prismatic": joint | {"damping_N_s_m": 4}}}
    >>> push = {"linear_motor": {"joint": "slide", "force_N": 100, "history": "lever"}}
    >>> curve = {"to": "push", "time_s": [0, 1, 2, 3, 4], "command": [0, 0, 0, 0, 0]}
    >>> import json
    >>> scenario = Scenario(json.dumps({
    ...     "version": 1, "title": "Cage", "simulation": {"step_s": 0.01, "duration_s": 4},
    ...     "bodies": {"cage": cage}, "drives": {"push": push},
    ...     "controllers": {"f": {"drive_function": curve}},
    ... }), "cage.json")
    >>> ramp = np.linspace(0, 0.4, 401)
    >>> found = drive_functions(scenario, "f", wanted={"slide.joint_position": ramp}, from_s=1)
    >>> round(found.deviation_before["slide.joint_position"], 2)
    0.26
    >>> found.deviation["slide.joint_position"] < 0.005
    True
    """
    scenario = as_scenario(scenario_or_path, overrides, parameters)
    names = [controllers] if isinstance(controllers, str) else [str(name) for name in controllers]
    search = _Search(scenario, _paths(scenario, names), dict(wanted), dict(weights or {}), from_s)
    start = np.array([scenario[path] for path in search.paths], float)
    before = search.deviations(start)
    found = search.least(start, iterations, tolerance)
    commands = dict(zip(search.paths, found.tolist(), strict=True))
    return DriveFunctions(
        scenario.with_overrides(commands),
        {name: [value for path, value in commands.items() if _of(path) == name] for name in names},
        before,
        search.deviations(found),
        search.gradients,
        search.recorded(found),
    )


def _of(path: str) -> str:
    """The controller of a command's path."""
    return path.split(".")[1]


def _paths(scenario: Scenario, names: Sequence[str]) -> list[str]:
    """The dotted paths of all commands of these controllers."""
    given = {
        name: kind[KIND]
        for name, kind in scenario.resolved.get("controllers", {}).items()
        if KIND in kind and kind[KIND]["enabled"]
    }
    for name in names:
        if name not in given:
            allowed = ", ".join(given) or f"none: the scenario has no {KIND} that is enabled"
            raise KingpostError(f"controllers: found {name}, allowed: {allowed}")
    return [
        f"controllers.{name}.{KIND}.command.{k}" for name in names for k in range(len(given[name]["command"]))
    ]


class _Search:
    """Runs for given commands and their gradients, each computed once."""

    def __init__(
        self,
        scenario: Scenario,
        paths: list[str],
        wanted: dict[str, float | ArrayLike | None],
        weights: dict[str, float],
        from_s: float,
    ) -> None:
        self.scenario, self.paths, self.wanted, self.from_s = scenario, paths, wanted, from_s
        if not wanted:
            raise KingpostError("wanted: found no column, allowed: at least one column of the results")
        for name, weight in weights.items():
            if name not in wanted:
                raise KingpostError(f"weights: found {name}, allowed: {', '.join(wanted)}")
            if not (math.isfinite(weight) and weight > 0):
                raise KingpostError(f"weights.{name}: found {weight}, allowed: a number greater than 0")
        self.weights = {name: weights.get(name, 1.0) for name in wanted}
        self.gradients = 0
        self._run: tuple[bytes, xarray.Dataset] | None = None

    def recorded(self, commands: Array) -> xarray.Dataset:
        """The run with these commands."""
        key = commands.tobytes()
        if self._run is None or self._run[0] != key:
            self._run = key, run(self._with(commands))
        return self._run[1]

    def deviations(self, commands: Array) -> dict[str, float]:
        """The root mean square deviation of each column."""
        found = self._deviations(self.recorded(commands))
        return {name: float(np.sqrt(np.mean(column**2))) for name, column in found.items()}

    def least(self, start: Array, iterations: int, tolerance: float) -> Array:
        """The commands that minimise J, searched from these commands."""
        from scipy.optimize import least_squares

        found = least_squares(
            self._residuals, start, self._derivatives, x_scale="jac", ftol=tolerance, max_nfev=iterations
        )
        return np.asarray(found.x, float)

    def _with(self, commands: Array) -> Scenario:
        return self.scenario.with_overrides(dict(zip(self.paths, commands.tolist(), strict=True)))

    def _deviations(self, recorded: xarray.Dataset) -> dict[str, Array]:
        counted = self._counted(recorded)
        found = {}
        for name, value in self.wanted.items():
            column = recorded.kingpost[name].values
            aim = column[0] if value is None else np.asarray(value, float)
            if np.ndim(aim) and np.shape(aim) != column.shape:
                allowed = f"one number, or {len(column)}, one for each record"
                raise KingpostError(f"wanted.{name}: found the shape {np.shape(aim)}, allowed: {allowed}")
            found[name] = (column - aim)[counted]
        return found

    def _counted(self, recorded: xarray.Dataset) -> NDArray[np.bool_]:
        times_s = recorded.time.values
        counted: NDArray[np.bool_] = times_s >= self.from_s
        if not counted.any():
            raise KingpostError(f"from_s: found {self.from_s}, allowed: at most {times_s[-1]}")
        return counted

    def _residuals(self, commands: Array) -> Array:
        found = self._deviations(self.recorded(commands))
        return np.concatenate([self._share(name, column) for name, column in found.items()])

    def _derivatives(self, commands: Array) -> Array:
        found = gradient(self._with(commands), self.paths)
        self.gradients += 1
        counted = self._counted(found)
        parts = []
        for name, value in self.wanted.items():
            along = _along(found, name)
            parts.append(self._share(name, (along - along[0] if value is None else along)[counted]))
        jacobian = np.concatenate(parts)
        for name in dict.fromkeys(map(_of, self.paths)):
            if not jacobian[:, [_of(path) == name for path in self.paths]].any():
                allowed = f"a function that moves {' or '.join(self.wanted)}"
                raise KingpostError(f"controllers: found {name}, allowed: {allowed}")
        return jacobian

    def _share(self, name: str, column: Array) -> Array:
        return column * (self.weights[name] / math.sqrt(len(column)))


def _along(found: xarray.Dataset, name: str) -> Array:
    """The derivatives of a column: a row for each time, a column for each parameter."""
    column = found.kingpost[name]
    derivative = found[f"{column.name}{DERIVATIVE}"]
    at = {dim: column.coords[dim].item() for dim in derivative.dims if dim not in ("parameter", "time")}
    values: Array = derivative.sel(at).transpose("time", "parameter").values
    return values

"""Simulations: a thin, labelled face on the engine.

Units are SI, angles in radians. The world's z points up; a ship's x points forward, y to
port, z up. Roll, pitch and yaw are the intrinsic z-y-x angles about x, y and z.
"""

from __future__ import annotations

import json
import logging
from collections.abc import Callable
from copy import copy
from dataclasses import asdict
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import markup
from ..errors import KingpostError
from ..scenario import Overrides, Scenario, as_scenario, load
from . import step_limit
from .linear import Equilibrium, Linearization, labelled
from .matrices import MovingFrame
from .outcomes import every_warning
from .records import DrawnLine, Event, Input, LeverMove, Limit, State, Warning
from .telling import tell

if TYPE_CHECKING:
    import xarray
    from numpy.typing import ArrayLike, NDArray

Progress = Callable[[float], None]
LOG = logging.getLogger(__name__)


class Simulation:
    """One run of a scenario, stepped by hand.

    >>> simulation = Simulation(load("paper", motor_1=True))
    >>> simulation.step(500)
    >>> round(simulation.time_s, 9)
    0.5
    >>> simulation.coordinates
    ['ship.roll', 'ship.pitch', 'ship.yaw', 'slew', 'luff']
    """

    def __init__(self, scenario: Scenario | str | Path) -> None:
        # A copy: a scenario that is edited later leaves this simulation alone.
        self.scenario = copy(scenario) if isinstance(scenario, Scenario) else load(scenario)
        self.results: xarray.Dataset | None = None
        self._engine = self.scenario._engine()

    def reset(self, seed: int | None = None) -> None:
        """Go back to the scenario's start, with another seed if one is given.

        Parameters
        ----------
        seed
            Of the random seas, gusts and noise; the scenario's unless given.

        Raises
        ------
        ScenarioError
            When the seed is no whole number from 0 on.

        >>> simulation = Simulation(load("paper"))
        >>> simulation.step(5)
        >>> simulation.reset()
        >>> simulation.time_s
        0.0
        """
        if seed is None:
            self._engine.reset()
            return
        self.scenario = self.scenario.with_overrides({"simulation.seed": seed})
        self._engine = self.scenario._engine()

    def step(self, n: int = 1) -> None:
        """Advance `n` steps of the scenario's step size.

        Parameters
        ----------
        n
            How many steps, each of `step_s`.

        Raises
        ------
        RunError
            When the motion diverges; the state stays at the last good step.
        KingpostError
            When `n` is no whole number from 0 on.

        >>> simulation = Simulation(load("paper"))
        >>> simulation.step(500)
        >>> round(simulation.time_s, 9)
        0.5
        """
        if isinstance(n, bool) or not isinstance(n, int | np.integer) or n < 0:
            raise KingpostError(f"n: found {n!r}, allowed: a whole number not less than 0")
        self._engine.step(int(n))

    def run(self, progress: Progress | None = None) -> xarray.Dataset:
        """Run from here to the scenario's duration and return what was recorded.

        The attributes ``events``, ``warnings`` and ``limits`` say what happened, what one should know of it,
        and how the scenario's limits held, as JSON; ``model_warnings`` has what was known before. Each
        warning is a `KingpostWarning` too.

        `progress` is called now and then with the time in seconds.

        Parameters
        ----------
        progress
            Called now and then with the time, s.

        Returns
        -------
        xarray.Dataset
            A row for each record along ``time`` (s), every variable with its ``units`` (`kingpost.results`).

        Raises
        ------
        RunError
            When the motion diverges; `.results` holds what was computed.
        KeyboardInterrupt
            On Ctrl-C; `.results` holds what was computed. So it is with whatever `progress` raises.

        >>> results = Simulation(load("paper", {"simulation.duration_s": 0.1})).run()
        >>> results.sizes["time"]
        11
        """
        from ..results.dataset import dataset

        known = self.model_warnings
        rows, error = self._engine.run(progress)
        status = "finished" if error is None else str(error) or "interrupted"
        LOG.info("%s: %s at %g s, %d rows", self.scenario.title, status, self.time_s, len(rows))
        results = dataset(self.scenario, self.channels, rows, status)
        results.attrs["events"] = json.dumps([asdict(event) for event in self.events])
        results.attrs["warnings"] = json.dumps([asdict(warning) for warning in self.warnings])
        results.attrs["limits"] = json.dumps([asdict(limit) for limit in self.limits])
        results.attrs["model_warnings"] = json.dumps(known)
        self.results = results
        tell(every_warning(results.attrs))
        if error is not None:
            error.results = results
            raise error
        return results

    def time_history(self, name: str, period_s: tuple[float, float] | None = None) -> xarray.DataArray:
        """A column of what `run` recorded last, over a period.

        Parameters
        ----------
        name
            Of the column, as ``arm.tip.point_position.z``.
        period_s
            From and to, s, both included; the whole run without.

        Returns
        -------
        xarray.DataArray
            Along ``time`` (s), with its ``units``.

        Raises
        ------
        KingpostError
            When nothing was run, there is no such column, or no record in the period.

        >>> simulation = Simulation(load("paper", {"simulation.duration_s": 0.5}))
        >>> _ = simulation.run()
        >>> simulation.time_history("ship.roll", (0.2, 0.3)).sizes["time"]
        11
        """
        from ..results.columns import column

        if self.results is None:
            raise KingpostError("time_history: found no run, allowed: after Simulation.run()")
        return column(self.results, name, period_s)

    def _repr_html_(self) -> str:
        heading = (
            f"{self.scenario.title}, at {self.time_s:g} s of {self.scenario['simulation.duration_s']:g} s"
        )
        free = zip(self.coordinates, self.coordinate_units, strict=True)
        inputs = [(one.name, one.value, one.unit, one.lower, one.upper) for one in self.inputs.values()]
        return "".join([
            markup.table(heading, free, ("free coordinate", "unit")),
            markup.table("Inputs", inputs, ("name", "value", "unit", "from", "to")) if inputs else "",
        ])  # fmt: skip

    @property
    def events(self) -> list[Event]:
        """What has happened so far, in order of time; a data set holds it as JSON in ``attrs["events"]``.

        >>> Simulation("paper").events
        []
        """
        return [Event(*event) for event in self._engine.events()]

    @property
    def model_warnings(self) -> list[str]:
        """What one should know before a run from here: of the model, and of a step that is too long for its
        scheme (`kingpost.stable_step`).

        >>> Simulation(load("paper", {"simulation.step_s": 0.001})).model_warnings
        []
        """
        settings, known = self.scenario.resolved["simulation"], list(self.scenario.model["warnings"])
        try:
            too_long = step_limit.warning(settings, lambda: self._engine.linearize()[0])
        except KingpostError:
            # What cannot be linearised where it begins, the run itself says better.
            return known
        return known if too_long is None else [*known, too_long]

    @property
    def warnings(self) -> list[Warning]:
        """What one should know of the rows so far, in order of time; a data set holds it as JSON in
        ``attrs["warnings"]``.

        >>> Simulation("paper").warnings
        []
        """
        return [Warning(**warning) for warning in json.loads(self._engine.warnings_json())]

    @property
    def limits(self) -> list[Limit]:
        """How the scenario's limits held in the rows so far; a data set holds it as JSON in
        ``attrs["limits"]``.

        >>> limits = {"limits": {"roll": {"column": "ship.roll", "within": 10, "unit": "deg"}}}
        >>> simulation = Simulation(load("paper").with_overrides({**limits, "simulation.duration_s": 1}))
        >>> _ = simulation.run()
        >>> simulation.limits[0].held
        True
        """
        return [Limit(**limit) for limit in json.loads(self._engine.limits_json())]

    @property
    def lever_moves(self) -> list[LeverMove]:
        """What `set_input` has set so far, in order of time."""
        return [LeverMove(*move) for move in self._engine.lever_moves()]

    def operation(self) -> dict[str, Any]:
        """What was set by hand as the ``operation`` of a scenario: a run with it gives the same bits.

        It has what `set_input` has set in this simulation since its start or its last `reset`; what came
        before a `restore` of another's snapshot is not in it, and no parameter that was set under way.

        Returns
        -------
        dict
            The section ``operation`` of a scenario.

        Raises
        ------
        KingpostError
            When the scenario has an operation that is enabled: the two would be one beside the other.

        >>> by_hand = Simulation("lowering_by_winch")
        >>> by_hand.step(20)
        >>> by_hand.set_input("hoist", -10.0)
        >>> by_hand.step(20)
        >>> replayed = Simulation(by_hand.scenario.with_overrides({"operation": by_hand.operation()}))
        >>> replayed.step(40)
        >>> bool((replayed.state.q == by_hand.state.q).all())
        True
        """
        return json.loads(self._engine.operation_json())

    @property
    def time_s(self) -> float:
        """Time, s."""
        return self._engine.time_s()

    @property
    def step_s(self) -> float:
        """Step size, s."""
        return self._engine.step_s()

    @property
    def evaluations(self) -> int:
        """Evaluations of the right-hand side by the integrator so far: what its steps cost."""
        return self._engine.evaluations()

    @property
    def state(self) -> State:
        """A copy of the motion now."""
        return State(self._engine.time_s(), *self._engine.motion())

    def set_state(self, q: ArrayLike, v: ArrayLike, s: ArrayLike | None = None) -> None:
        """Replace the motion; arrays as in `State`, with unit quaternions.

        Without `s` the energy and momentum ledger begins anew here.

        Parameters
        ----------
        q
            Positions, as `State.q`.
        v
            Velocities, as `State.v`.
        s
            Further states, as `State.s`; they stay unless given.

        Raises
        ------
        KingpostError
            When a length is wrong or a value is not finite.

        >>> simulation = Simulation(load("paper"))
        >>> state = simulation.state
        >>> simulation.step(5)
        >>> simulation.set_state(state.q, state.v, state.s)
        >>> bool((simulation.state.q == state.q).all())
        True
        """
        self._engine.set_state(_vector(q), _vector(v), None if s is None else _vector(s))

    def snapshot(self) -> bytes:
        """The complete state. A run resumed from it gives the same bits.

        Returns
        -------
        bytes
            Of this scenario alone.

        >>> simulation = Simulation(load("paper"))
        >>> start = simulation.snapshot()
        >>> simulation.step(5)
        >>> simulation.restore(start)
        >>> simulation.time_s
        0.0
        """
        return self._engine.snapshot()

    def restore(self, snapshot: bytes) -> None:
        """Go back to a `snapshot` of the same scenario.

        Parameters
        ----------
        snapshot
            What `snapshot` gave.

        Raises
        ------
        KingpostError
            When it is of another scenario, or no snapshot.

        >>> simulation = Simulation(load("paper"))
        >>> simulation.restore(simulation.snapshot())
        """
        self._engine.restore(snapshot)

    @property
    def inputs(self) -> dict[str, Input]:
        """The inputs by name, with unit, limits and present value."""
        return {row[0]: Input(*row) for row in self._engine.inputs()}

    def set_input(self, name: str, value: float) -> None:
        """Set an input; it holds until it is set again.

        Parameters
        ----------
        name
            Of the input, one of `inputs`.
        value
            In the input's unit, between its bounds.

        Raises
        ------
        KingpostError
            When there is no such input, or the value is beyond its bounds.

        >>> simulation = Simulation(load("lowering_by_winch"))
        >>> simulation.set_input("hoist", 0.1)
        >>> simulation.inputs["hoist"].value
        0.1
        """
        self._engine.set_input(name, value)

    def set_parameter(self, name: str, value: bool | float | str) -> None:
        """Set a parameter that is `live` in the scenario while the run goes on, from the next step on.

        Time, motion and inputs stay; what the change does to energy is booked in the ledger. `reset` leads to
        the start of the scenario with the new value.

        Parameters
        ----------
        name
            Of a parameter that can change during a run.
        value
            In the parameter's unit.

        Raises
        ------
        KingpostError
            When there is no such live parameter, when it may not have the value, and when the value changes
            what the run is made of; the error names the parameter.

        >>> simulation = Simulation(load("barge"))
        >>> simulation.set_parameter("significant_height_m", 2.0)
        """
        scenario = self.scenario.with_overrides({name: value})
        self._engine.set_parameter(name, json.dumps(scenario.overrides[-1][1]))
        self.scenario = scenario

    @property
    def coordinates(self) -> list[str]:
        """Names of the free coordinates, in the order of the mass matrix."""
        return [name for name, _ in self._engine.coordinates()]

    @property
    def coordinate_units(self) -> list[str]:
        """SI unit of each of `coordinates`: m, or rad of what turns.

        >>> Simulation("paper").coordinate_units
        ['rad', 'rad', 'rad', 'rad', 'rad']
        """
        return [unit for _, unit in self._engine.coordinates()]

    @cached_property
    def channels(self) -> list[dict[str, Any]]:
        """What is recorded: name, unit, frame, dimensions, labels and place in a row."""
        return json.loads(self._engine.channels_json())

    def row(self) -> NDArray[np.float64]:
        """The values of all channels now.

        Returns
        -------
        numpy.ndarray
            Shape (values,), in the order of `channels`, SI units.

        >>> simulation = Simulation(load("paper"))
        >>> simulation.row().shape == (sum(channel["len"] for channel in simulation.channels),)
        True
        """
        return self._engine.row()

    def poses(self) -> NDArray[np.float64]:
        """Pose of each body: x, y, z (m, world) and quaternion w, x, y, z. Shape (bodies, 7).

        Returns
        -------
        numpy.ndarray
            Shape (bodies, 12): position (m, world) and rotation matrix by rows.

        >>> Simulation(load("paper")).poses().shape[0]
        3
        """
        return self._engine.poses()

    def lines(self) -> list[DrawnLine]:
        """The lines to draw beside the bodies, where they are now.

        Returns
        -------
        list of DrawnLine
            Points in m, world.

        >>> [(line.name, line.style, line.points_m.shape) for line in Simulation(load("chain")).lines()]
        []
        """
        lines = json.loads(self._engine.lines_json())
        points = self._engine.line_points().reshape(-1, 3)
        ends = np.cumsum([line["points"] for line in lines], dtype=int)
        return [
            DrawnLine(line["name"], line["style"], line["radius_m"], points[end - line["points"] : end])
            for line, end in zip(lines, ends, strict=True)
        ]

    def acceleration(self, tau: ArrayLike | None = None) -> NDArray[np.float64]:
        """Accelerations of the free coordinates now (m/s2 or rad/s2).

        `tau` adds a generalized force per free coordinate (N or N m) to the loads that act.

        Parameters
        ----------
        tau
            A generalized force for each free coordinate, shape (coordinates,), N or N m.

        Returns
        -------
        numpy.ndarray
            Shape (coordinates,), m/s2 or rad/s2.

        Raises
        ------
        KingpostError
            When `tau` has another length.

        >>> Simulation(load("paper")).acceleration().shape
        (5,)
        """
        return self._engine.acceleration(None if tau is None else _vector(tau))

    def mass_matrix(self) -> NDArray[np.float64]:
        """Reduced mass matrix M* = B^T M B of the free coordinates (kg, kg m, kg m2).

        Returns
        -------
        numpy.ndarray
            Shape (coordinates, coordinates), symmetric.

        >>> Simulation(load("paper")).mass_matrix().shape
        (5, 5)
        """
        return self._engine.mass_matrix()

    def constraint_matrix(self) -> NDArray[np.float64]:
        """J of the closed loops over the free coordinates: J v = 0. Shape (constraints, coordinates).

        Returns
        -------
        numpy.ndarray
            Shape (constraints, coordinates).

        >>> Simulation(load("paper")).constraint_matrix().shape
        (0, 5)
        """
        return self._engine.constraint_matrix()

    def bias_force(self) -> NDArray[np.float64]:
        """Bias force N* v of the free coordinates (N or N m).

        Returns
        -------
        numpy.ndarray
            Shape (coordinates,).

        >>> Simulation(load("paper")).bias_force().shape
        (5,)
        """
        return self._engine.bias_force()

    def moving_frame(self) -> MovingFrame:
        """The matrices of the moving frame method now, by name.

        Frame connection matrices ``E_ship`` and ``E_tower/ship``, their rates ``Omega_..``,
        rotations ``R_..``, then ``B``, ``B_dot``, ``X_dot``, ``M``, ``D``, ``F``, ``q_dot``,
        ``M_star``, ``N_star`` and ``F_star``, and where there are any ``q_ddot_given`` of prescribed
        motions and ``J`` of closed loops, with labels and units by row and column; their LaTeX,
        their formulas and their CSV files (`MovingFrame`).

        Returns
        -------
        MovingFrame
            The matrices by name.

        >>> matrices = Simulation(load("paper")).moving_frame()
        >>> matrices["M_star"].sel(row="slew", column="slew")["unit"].item()
        'kg m^2'
        """
        return MovingFrame(self._engine.moving_frame(), self._engine.symbols_json)

    def linearize(self) -> Linearization:
        """A and B of the linearised system here, exact to rounding.

        Returns
        -------
        Linearization
            A, B and the rates, with names and units.

        >>> linear = Simulation(load("paper")).linearize()
        >>> linear.states[:2], linear.inputs
        (['ship.roll', 'ship.pitch'], [])
        """
        return labelled(*self._engine.linearize())

    def settle(self) -> Equilibrium:
        """Move to an equilibrium near here, all rates zero, and begin the ledger anew there.

        Returns
        -------
        Equilibrium
            How it was found.

        Raises
        ------
        KingpostError
            When there is none; the state stays as it was.

        >>> simulation = Simulation(load("chain"))
        >>> simulation.settle().residual < 1e-6
        True
        """
        return Equilibrium(*self._engine.settle())

    def wave_response(self, directions_rad: ArrayLike, frequencies_rad_s: ArrayLike) -> dict[str, Any]:
        """What `kingpost.rao` labels: complex amplitudes of all motions by direction and frequency, with
        the crane as it stands now; no frequencies ask for those of the hull's database, refined.

        Parameters
        ----------
        directions_rad
            That the waves go to, rad.
        frequencies_rad_s
            Angular frequencies; none ask for those of the database.

        Returns
        -------
        dict
            ``real`` and ``imaginary`` parts of all motions, flat, with the names of what moves.

        Raises
        ------
        KingpostError
            When nothing comes to rest, or a database does not cover a frequency.

        >>> found = Simulation(load("barge")).wave_response([0.0], [1.0])
        >>> found["places"]
        ['ship', 'tower', 'arm', 'load', 'tower.top', 'arm.tip']
        """
        waves = {
            "directions_rad": np.asarray(directions_rad, float).tolist(),
            "frequencies_rad_s": np.asarray(frequencies_rad_s, float).tolist(),
        }
        return json.loads(self._engine.wave_response_json(json.dumps(waves)))

    def hydrostatics(self) -> dict[str, Any]:
        """As the attribute `Scenario.hydrostatics`, with the crane as it stands now: held and prescribed
        coordinates stay, the rest comes to rest in still water. The simulation itself does not move.

        Returns
        -------
        dict
            As `Scenario.hydrostatics`.

        Raises
        ------
        KingpostError
            When a hull is heavier than what it displaces wholly under water.

        >>> simulation = Simulation(load("barge"))
        >>> simulation.hydrostatics()["hulls"][0]["body"]
        'ship'
        """
        return json.loads(self._engine.hydrostatics_json())


def run(
    scenario_or_path: Scenario | str | Path, overrides: Overrides | None = None, **parameters: Any
) -> xarray.Dataset:
    """Run a scenario from start to end.

    Parameters
    ----------
    scenario_or_path
        A scenario, a file or a name of the gallery.
    overrides
        Values by parameter name or by dotted field path.
    parameters
        Values by parameter name.

    Returns
    -------
    xarray.Dataset
        A row for each record along ``time`` (s), every variable with its ``units`` (`kingpost.results`).

    Raises
    ------
    ScenarioError
        When the scenario or an override is wrong.
    RunError
        When the motion diverges; `.results` holds what was computed.

    >>> results = run("paper", {"simulation.duration_s": 0.5}, crane_x_m=0, crane_y_m=0)
    >>> round(float(results.angular_velocity.sel(body="ship", axis="y")[-1]), 5)
    0.19709
    """
    return Simulation(as_scenario(scenario_or_path, overrides, parameters)).run()


def _vector(values: ArrayLike) -> NDArray[np.float64]:
    return np.ascontiguousarray(values, dtype=np.float64).ravel()

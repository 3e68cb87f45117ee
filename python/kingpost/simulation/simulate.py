"""Simulations: a thin interface to the engine that adds labels.

Units are SI, angles in radians. The world's z points up; a ship's x points forward, y to
port, z up. Roll, pitch and yaw are the intrinsic z-y-x angles about x, y and z.
"""

from __future__ import annotations

import json
import logging
from collections.abc import Callable
from copy import copy
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import markup
from ..engine import engine
from ..errors import KingpostError, shortened
from ..given import number, numbers
from ..scenario import Overrides, Scenario, as_scenario, load
from .equations import Equations
from .observed import Observed
from .outcomes import every_warning
from .python_warnings import emit_warnings
from .records import Input, State

if TYPE_CHECKING:
    import xarray
    from numpy.typing import ArrayLike

Progress = Callable[[float], None]
LOG = logging.getLogger(__name__)
MOST_STEPS = 10**15
"""Largest number of steps in one call: beyond it the time is no longer exact."""


class Simulation(Observed, Equations):
    """One run of a scenario, advanced step by step.

    >>> simulation = Simulation(load("paper", motor_1=True))
    >>> simulation.step(500)
    >>> round(simulation.time_s, 9)
    0.5
    >>> simulation.coordinates
    ['ship.roll', 'ship.pitch', 'ship.yaw', 'slew', 'luff']
    """

    def __init__(self, scenario: Scenario | str | Path) -> None:
        # A copy: later edits of the scenario do not change this simulation.
        self.scenario = copy(scenario) if isinstance(scenario, Scenario) else load(scenario)
        self.results: xarray.Dataset | None = None
        self._engine = engine.Simulation(self.scenario._built)

    def reset(self, seed: int | None = None) -> None:
        """Go back to the start of the scenario, with another seed if one is given.

        Parameters
        ----------
        seed
            Seed of the random seas, gusts and noise; default: the scenario's seed.

        Raises
        ------
        ScenarioError
            If the seed is not a whole number from 0 on.

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
        self._engine = engine.Simulation(self.scenario._built)

    def step(self, n: int = 1) -> None:
        """Advance `n` steps of the scenario's step size.

        Parameters
        ----------
        n
            Number of steps, each of `step_s`.

        Raises
        ------
        RunError
            If the motion diverges; the state is then that of the last good step.
        KingpostError
            If `n` is not a whole number from 0 on.

        >>> simulation = Simulation(load("paper"))
        >>> simulation.step(500)
        >>> round(simulation.time_s, 9)
        0.5
        """
        if isinstance(n, bool) or not isinstance(n, int | np.integer) or not 0 <= n <= MOST_STEPS:
            raise KingpostError(f"n: found {n!r}, allowed: a whole number from 0 to {MOST_STEPS:.0e}")
        self._engine.step(int(n))

    def run(self, progress: Progress | None = None) -> xarray.Dataset:
        """Run from the present time to the scenario's duration and return the recorded results.

        The variables along ``event``, ``warning`` and ``limit`` hold the events, the warnings and the results
        of the scenario's limits; warnings from before the run have the code ``model``. Each warning is also a
        `KingpostWarning`.

        `progress` is called at intervals with the time in seconds.

        Parameters
        ----------
        progress
            Called at intervals with the time, s.

        Returns
        -------
        xarray.Dataset
            A row for each record along ``time`` (s), every variable with its ``units`` (`kingpost.results`).

        Raises
        ------
        RunError
            When the motion diverges; `.results` holds what was computed.
        KeyboardInterrupt
            On Ctrl-C; `.results` holds what was computed. The same holds for any exception from `progress`.

        >>> results = Simulation(load("paper", {"simulation.duration_s": 0.1})).run()
        >>> results.sizes["time"]
        11
        """
        from ..results import entries
        from ..results.dataset import dataset

        known = self.model_warnings
        rows, error = self._engine.run(progress)
        status = "finished" if error is None else str(error) or "interrupted"
        LOG.info("%s: %s at %g s, %d rows", self.scenario.title, status, self.time_s, len(rows))
        results = entries.with_entries(
            dataset(self.scenario, self.channels, rows, status),
            events=json.loads(self._engine.events_json()),
            warnings=json.loads(self._engine.warnings_json()),
            limits=json.loads(self._engine.limits_json()),
            model_warnings=known,
        )
        self.results = results
        emit_warnings(every_warning(results))
        if error is not None:
            error.results = results
            raise error
        return results

    def time_history(self, name: str, period_s: tuple[float, float] | None = None) -> xarray.DataArray:
        """A column of the last `run`, over a period.

        Parameters
        ----------
        name
            Name of the column, such as ``arm.tip.point_position.z``.
        period_s
            First and last time, s, both included; default: the whole run.

        Returns
        -------
        xarray.DataArray
            Along ``time`` (s), with its ``units``.

        Raises
        ------
        KingpostError
            If nothing was run, the column is unknown, or there is no record in the period.

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
            markup.figure(self),
            markup.table(heading, free, ("free coordinate", "unit")),
            markup.table("Inputs", inputs, ("name", "value", "unit", "from", "to")) if inputs else "",
        ])  # fmt: skip

    @property
    def time_s(self) -> float:
        """Time, s."""
        return self._engine.clock()[0]

    @property
    def step_s(self) -> float:
        """Step size, s."""
        return self._engine.clock()[1]

    @property
    def evaluations(self) -> int:
        """Evaluations of the right-hand side by the integrator so far: the cost of its steps."""
        return self._engine.clock()[2]

    @property
    def state(self) -> State:
        """Copy of the present state."""
        return State(self._engine.clock()[0], *self._engine.motion())

    def set_state(self, q: ArrayLike, v: ArrayLike, s: ArrayLike | None = None) -> None:
        """Replace the state; arrays as in `State`, with unit quaternions. Without `s` the ledger of energy
        and momentum restarts at the present time.

        Parameters
        ----------
        q
            Positions, as `State.q`.
        v
            Velocities, as `State.v`.
        s
            Further states, as `State.s`; unchanged if not given.

        Raises
        ------
        KingpostError
            If a length is wrong or a value is not finite.

        >>> simulation = Simulation(load("paper"))
        >>> state = simulation.state
        >>> simulation.step(5)
        >>> simulation.set_state(state.q, state.v, state.s)
        >>> bool((simulation.state.q == state.q).all())
        True
        """
        self._engine.set_state(numbers("q", q), numbers("v", v), None if s is None else numbers("s", s))

    def snapshot(self) -> bytes:
        """The complete state. A run resumed from it gives the same bits.

        Returns
        -------
        bytes
            Snapshot, valid for this scenario only.

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
            The return value of `snapshot`.

        Raises
        ------
        KingpostError
            If `snapshot` belongs to another scenario, or is not a snapshot.

        >>> simulation = Simulation(load("paper"))
        >>> simulation.restore(simulation.snapshot())
        """
        if not isinstance(snapshot, bytes | bytearray | memoryview):
            found = shortened(repr(snapshot), 40)
            raise KingpostError(f"snapshot: found {found}, allowed: the bytes of Simulation.snapshot()")
        self._engine.restore(bytes(snapshot))

    @property
    def inputs(self) -> dict[str, Input]:
        """The inputs by name, with unit, bounds and present value."""
        return {row[0]: Input(*row) for row in self._engine.inputs()}

    def set_input(self, name: str, value: float) -> None:
        """Set an input, which keeps the value until it is set again.

        Parameters
        ----------
        name
            Name of the input, one of `inputs`.
        value
            Value in the input's unit, between its bounds.

        Raises
        ------
        KingpostError
            If there is no such input, or the value is outside its bounds.

        >>> simulation = Simulation(load("lowering_by_winch"))
        >>> simulation.set_input("hoist", 0.1)
        >>> simulation.inputs["hoist"].value
        0.1
        """
        self._engine.set_input(str(name), number(f"input {name}", value))

    def set_parameter(self, name: str, value: bool | float | str) -> None:
        """Set a parameter that is `live` in the scenario during a run, from the next step on. Time, motion
        and inputs are unchanged; the ledger records the change of energy. `reset` returns to the start of the
        scenario with the new value.

        Parameters
        ----------
        name
            Name of a parameter that can change during a run.
        value
            Value in the parameter's unit.

        Raises
        ------
        KingpostError
            If there is no such live parameter, the value is not allowed, or the value changes the structure
            of the run; the error names the parameter.

        >>> simulation = Simulation(load("barge"))
        >>> simulation.set_parameter("significant_height_m", 2.0)
        """
        scenario = self.scenario.with_overrides({name: value})
        self._engine.set_parameter(name, json.dumps(scenario.overrides[-1][1]))
        self.scenario = scenario


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

"""Events, warnings, channels and poses of a simulation."""

from __future__ import annotations

import json
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import KingpostError
from . import step_limit
from .records import DrawnLine, Event, LeverMove, Limit, LimitBounds, Warning

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ..engine import engine
    from ..results.channels import Channel
    from ..scenario import Scenario


class Observed:
    """The attributes of `kingpost.Simulation` that show its events, warnings, channels and poses."""

    scenario: Scenario
    _engine: engine.Simulation
    _warned_of: tuple[Any, list[str]] | None = None
    """State for which warnings were last computed, and these warnings."""

    @property
    def events(self) -> list[Event]:
        """The events so far, in order of time; a data set holds them along ``event``.

        >>> from kingpost import Simulation, load
        >>> Simulation("paper").events
        []
        """
        return [Event(**event) for event in json.loads(self._engine.events_json())]

    @property
    def model_warnings(self) -> list[str]:
        """Warnings about the model in its present state, and about a step that is too long for the scheme
        (`kingpost.stable_step`).

        >>> from kingpost import Simulation, load
        >>> Simulation(load("paper", {"simulation.step_s": 0.001})).model_warnings
        []
        """
        # A run requests again the warnings that its command has printed: compute the eigenvalues once for
        # each state.
        state = (self.scenario.overrides, self._engine.snapshot())
        if self._warned_of is None or self._warned_of[0] != state:
            self._warned_of = state, self._warnings_before_a_run()
        return list(self._warned_of[1])

    def _warnings_before_a_run(self) -> list[str]:
        settings, known = self.scenario.resolved["simulation"], list(self.scenario.model["warnings"])
        count = 2 * len(self.coordinates)
        if count > step_limit.MOST_STATES:
            return [*known, step_limit.left_out(count)]
        try:
            too_long = step_limit.warning(settings, self.linear_in_calm)
        except KingpostError:
            # If the start cannot be linearised, the error of the run itself is clearer.
            return known
        return known if too_long is None else [*known, too_long]

    def linear_in_calm(self) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
        """A of x' = A x in calm water, which costs less than in waves, and the marks of states that elements
        advance themselves.

        Returns
        -------
        tuple of numpy.ndarray
            A, shape (states, states), and the marks, shape (states,).

        >>> from kingpost import Simulation
        >>> matrix, advanced = Simulation("chain").linear_in_calm()
        >>> matrix.shape == (advanced.size, advanced.size)
        True
        """
        a, _, _, names = self._engine.linearize(in_waves=False)
        return a, np.array(json.loads(names)["advanced"], bool)

    @property
    def warnings(self) -> list[Warning]:
        """Warnings from the rows so far, in order of time; a data set holds them along ``warning``.

        >>> from kingpost import Simulation, load
        >>> Simulation("paper").warnings
        []
        """
        return [Warning(**warning) for warning in json.loads(self._engine.warnings_json())]

    @property
    def limits(self) -> list[Limit]:
        """Results of the scenario's limits in the rows so far; a data set holds them along ``limit``.

        >>> from kingpost import Simulation, load
        >>> limits = {"limits": {"roll": {"column": "ship.roll", "within": 10, "unit": "deg"}}}
        >>> simulation = Simulation(load("paper").with_overrides({**limits, "simulation.duration_s": 1}))
        >>> _ = simulation.run()
        >>> simulation.limits[0].held
        True
        """
        return [Limit(**limit) for limit in json.loads(self._engine.limits_json())]

    @property
    def limit_bounds(self) -> list[LimitBounds]:
        """Bounds of the scenario's limits, in SI units.

        >>> from kingpost import Simulation, load
        >>> limits = {"limits": {"roll": {"column": "ship.roll", "at_most": 180, "unit": "deg"}}}
        >>> Simulation(load("paper").with_overrides(limits)).limit_bounds[0].at_most
        3.141592653589793
        """

        def bounds(one: dict[str, Any]) -> LimitBounds:
            ends = (one["at_least"], one["at_most"])
            least, most = (None if end is None else end * one["unit_si"] for end in ends)
            return LimitBounds(one["name"], one["column"], least, most, one["percentile"])

        return [bounds(one) for one in self.scenario.model["limits"]]

    @property
    def lever_moves(self) -> list[LeverMove]:
        """The lever moves that `set_input` has made so far, in order of time."""
        return [LeverMove(*move) for move in self._engine.lever_moves()]

    def operation(self) -> dict[str, Any]:
        """The inputs set by hand, as the section ``operation`` of a scenario: a run with it gives the same
        bits.

        It contains every `set_input` of this simulation since its start or its last `reset`. It does not
        contain inputs from before a `restore` of another simulation's snapshot, nor parameters set during the
        run.

        Returns
        -------
        dict
            The section ``operation`` of a scenario.

        Raises
        ------
        KingpostError
            If the scenario has an enabled operation: there would be two.

        >>> from kingpost import Simulation, load
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
    def coordinates(self) -> list[str]:
        """Names of the free coordinates, in the order of the mass matrix."""
        return [name for name, _ in self._engine.coordinates()]

    @property
    def coordinate_units(self) -> list[str]:
        """SI unit of each of `coordinates`: m or rad.

        >>> from kingpost import Simulation, load
        >>> Simulation("paper").coordinate_units
        ['rad', 'rad', 'rad', 'rad', 'rad']
        """
        return [unit for _, unit in self._engine.coordinates()]

    @cached_property
    def channels(self) -> list[Channel]:
        """The recorded channels: name, unit, frame, dimensions, labels and place in a row."""
        return json.loads(self._engine.channels_json())

    def row(self) -> NDArray[np.float64]:
        """The values of all channels now.

        Returns
        -------
        numpy.ndarray
            Shape (values,), in the order of `channels`, SI units.

        >>> from kingpost import Simulation, load
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
            Shape (bodies, 7).

        >>> from kingpost import Simulation, load
        >>> Simulation(load("paper")).poses().shape[0]
        3
        """
        return self._engine.poses()

    def lines(self) -> list[DrawnLine]:
        """The lines to draw in addition to the bodies, at their present places.

        Returns
        -------
        list of DrawnLine
            Points in m, world.

        >>> from kingpost import Simulation, load
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

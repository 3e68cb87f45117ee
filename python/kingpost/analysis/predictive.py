"""Model-predictive control on the exact linearisation about rest, with limits of inputs and states."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..errors import KingpostError
from ..scenario import Overrides, Scenario, as_scenario
from ..simulation.simulate import Simulation
from .quadratic_program import Bounds, minimum
from .riccati import Matrix, check_reach, places, sampled, solve, weights_of

Limits = Mapping[str, tuple[float, float]]
"""Lower and upper limit by name, in SI units."""


@dataclass(frozen=True)
class Plan:
    """Plan of a predictive regulator over its horizon.

    Attributes
    ----------
    inputs
        Each input in each period of the horizon, shape (periods, inputs); the first row is the action now.
    states
        The predicted states at the end of each period, shape (periods, states).
    beyond
        Smallest excess of the states over their limits that the limited inputs can reach; 0 if all limits
        hold.
    """

    inputs: Matrix
    states: Matrix
    beyond: float


@dataclass(frozen=True)
class PredictiveRegulator:
    """A regulator that plans ahead within limits at each sample; made by `mpc`.

    It minimises, over the inputs of N periods T from the state x_0 on,

    ``J = integral from 0 to N T of (x' Q x + u' R u) + x_N' P x_N``

    with u held in each period, P the least cost of the unlimited regulator from there on (so that without an
    active limit it is `lqr`), and limits of inputs, of their rates, and of the states at the ends of the
    periods (Rawlings, Mayne & Diehl, *Model Predictive Control*, 2nd ed., 2017, ch. 1-2).

    Attributes
    ----------
    states
        Names of the states x.
    inputs
        Names of the inputs u.
    period_s
        T, s.
    horizon
        N.
    gains
        K of the unlimited regulator ``u = -K x``, shape (inputs, states).
    held, moved
        The matrices of ``x_(k+1) = held x_k + moved u_k``.
    """

    states: list[str]
    inputs: list[str]
    period_s: float
    horizon: int
    gains: Matrix
    held: Matrix
    moved: Matrix
    _cost: tuple[Matrix, Matrix, Matrix, Matrix]
    _input_limits: Matrix
    _rate_limits: Matrix
    _state_limits: list[tuple[int, float, float]]

    def action(self, x: ArrayLike, before: ArrayLike | None = None) -> Matrix:
        """The inputs of the next period; the arguments are those of `plan`.

        Parameters
        ----------
        x
            The states now.
        before
            The inputs of the last period.

        Returns
        -------
        numpy.ndarray
            A value for each input, in its unit.

        Examples
        --------
        >>> import kingpost
        >>> inputs = ["slewing.target_offset"]
        >>> states = ["slew", "slew.rate", "pendant.first", "pendant.first.rate"]
        >>> regulator = kingpost.mpc("slew_without_swing", inputs=inputs, states=states,
        ...     Q={"slew": 1, "pendant.first": 20}, R=[1], period_s=0.2, horizon=20,
        ...     input_limits={"slewing.target_offset": (-0.1, 0.1)})
        >>> regulator.action([0.5, 0, 0, 0]).round(6).tolist()
        [0.1]
        """
        return self.plan(x, before).inputs[0]

    def plan(self, x: ArrayLike, before: ArrayLike | None = None) -> Plan:
        """The inputs of all periods, and the states that they lead to.

        Parameters
        ----------
        x
            The states now: deviations from rest, or from another rest of the linear model, such as a slewed
            crane. In the order of ``states``, SI units.
        before
            The inputs of the last period, from which limits of rates are counted; default: 0.

        Returns
        -------
        Plan
            The inputs and the states.

        Raises
        ------
        KingpostError
            If the states are not finite numbers, one for each state.

        Examples
        --------
        >>> import kingpost
        >>> inputs = ["slewing.target_offset"]
        >>> states = ["slew", "slew.rate", "pendant.first", "pendant.first.rate"]
        >>> regulator = kingpost.mpc("slew_without_swing", inputs=inputs, states=states,
        ...     Q={"slew": 1, "pendant.first": 20}, R=[1], period_s=0.2, horizon=20)
        >>> plan = regulator.plan([0.1, 0, 0, 0])
        >>> bool(abs(plan.inputs[0] + regulator.gains @ [0.1, 0, 0, 0]).max() < 1e-9)
        True
        """
        start = _numbers("x", x, len(self.states))
        last = np.zeros(len(self.inputs)) if before is None else _numbers("before", before, len(self.inputs))
        free, forced = self._prediction
        weight, by_state = self._condensed
        found, beyond = minimum(weight, by_state @ start, self._bounds(start, last))
        ahead = (free @ start + forced @ found).reshape(self.horizon, -1)
        return Plan(found.reshape(self.horizon, -1), ahead, beyond)

    @cached_property
    def _prediction(self) -> tuple[Matrix, Matrix]:
        """States at the ends of the periods: by the state now, and by the inputs."""
        n, m = self.moved.shape
        free, forced = np.zeros((self.horizon, n, n)), np.zeros((self.horizon, n, self.horizon, m))
        power = np.eye(n)
        for k in range(self.horizon):
            for later in range(k, self.horizon):
                forced[later, :, later - k] = power @ self.moved
            power = self.held @ power
            free[k] = power
        return free.reshape(-1, n), forced.reshape(self.horizon * n, -1)

    @cached_property
    def _condensed(self) -> tuple[Matrix, Matrix]:
        """H and F of ``J / 2 = u' H u / 2 + (F x_0)' u + ...`` over the inputs of all periods."""
        q, cross, r, p = self._cost
        (n, m), size = self.moved.shape, self.horizon
        free, forced = self._prediction
        # States at the beginnings of the periods and at the end of the last one, each with its weight.
        at_first = np.vstack([np.eye(n), free])
        by_inputs = np.vstack([np.zeros((n, size * m)), forced])
        weights = np.zeros((n * (size + 1), n * (size + 1)))
        mixed = np.zeros((n * (size + 1), size * m))
        for k in range(size):
            weights[k * n : (k + 1) * n, k * n : (k + 1) * n] = q
            mixed[k * n : (k + 1) * n, k * m : (k + 1) * m] = cross
        weights[-n:, -n:] = p
        mutual = by_inputs.T @ mixed
        whole = by_inputs.T @ weights @ by_inputs + np.kron(np.eye(size), r) + mutual + mutual.T
        return (whole + whole.T) / 2, (by_inputs.T @ weights + mixed.T) @ at_first

    def _bounds(self, start: Matrix, last: Matrix) -> Bounds:
        """Limits of the inputs, of their changes, and of states."""
        m, size = len(self.inputs), self.horizon
        free, forced = self._prediction
        every = np.eye(size * m)
        hard = [(every, np.tile(self._input_limits[0], size), np.tile(self._input_limits[1], size))]
        if np.isfinite(self._rate_limits).any():
            change = every - np.eye(size * m, k=-m)
            offset = np.concatenate([last, np.zeros((size - 1) * m)])
            steps = np.tile(self._rate_limits * self.period_s, size)
            hard.append((change, offset - steps, offset + steps))
        rows, n = [], len(self.states)
        for state, lower, upper in self._state_limits:
            of_state, now = forced[state::n], free[state::n] @ start
            rows.append((of_state, lower - now, upper - now))
        return Bounds(hard, rows)


def _numbers(what: str, given: ArrayLike, count: int) -> Matrix:
    try:
        found = np.asarray(given, float)
    except (TypeError, ValueError):
        raise KingpostError(f"{what}: found {given!r}, allowed: {count} numbers") from None
    if found.shape != (count,) or not np.isfinite(found).all():
        raise KingpostError(f"{what}: found {given!r}, allowed: {count} finite numbers")
    return found


def mpc(
    scenario_or_path: Scenario | str | Path,
    overrides: Overrides | None = None,
    *,
    inputs: Sequence[str],
    states: Sequence[str] | None = None,
    Q: Mapping[str, float] | ArrayLike,  # noqa: N803
    R: Mapping[str, float] | ArrayLike,  # noqa: N803
    period_s: float,
    horizon: int,
    input_limits: Limits | None = None,
    input_rates: Mapping[str, float] | None = None,
    state_limits: Limits | None = None,
    **parameters: Any,
) -> PredictiveRegulator:
    """Model-predictive control of small motions about rest, within limits.

    The model is that of `lqr`: A and B of `Simulation.linearize` at the equilibrium, exact, with the inputs
    held between samples. Needs the extra ``control``.

    Parameters
    ----------
    scenario_or_path, overrides, parameters
        Scenario and overrides, as in `run`. Its controllers do not act.
    inputs
        Names of the inputs u that the regulator sets.
    states
        Names of the states x that it predicts, of `Linearization.states`; None for all. Others are held at
        rest.
    Q, R
        Weights, as in `lqr`.
    period_s
        Sampling period, s.
    horizon
        Number of periods that it plans.
    input_limits
        Lower and upper limit of inputs by name; without one, the scenario's bounds of the input.
    input_rates
        Largest change of inputs by name, per second.
    state_limits
        Lower and upper limit of states by name, at the ends of the periods. If no inputs within their limits
        hold them, the plan exceeds them as little as possible.

    Returns
    -------
    PredictiveRegulator
        The regulator.

    Raises
    ------
    KingpostError
        As of `lqr`, or if a horizon or limit is not allowed, or Clarabel is not installed.

    Examples
    --------
    A mass of 2 kg on a slide that a force of at most 1 N brings to rest.

    >>> joint = {"prismatic": {"name": "slide", "axis": [1, 0, 0]}}
    >>> body = {"mass_kg": 2, "shape": {"point": {}}, "joint": joint}
    >>> drive = {"linear_motor": {"joint": "slide", "force_N": 1, "history": "lever"}}
    >>> cage = {"version": 1, "title": "Cage", "bodies": {"cage": body}, "drives": {"push": drive}}
    >>> import json
    >>> scenario = Scenario(json.dumps(cage), "cage.json")
    >>> regulator = mpc(scenario, inputs=["push"], Q={"slide": 1}, R=[0.1], period_s=0.5, horizon=10)
    >>> regulator.action([9, 0]).round(6).tolist()
    [-1.0]
    """
    if not (math.isfinite(period_s) and period_s > 0):
        raise KingpostError(f"period_s: found {period_s}, allowed: a number greater than 0")
    if isinstance(horizon, bool) or not isinstance(horizon, int | np.integer) or horizon < 1:
        raise KingpostError(f"horizon: found {horizon!r}, allowed: a whole number from 1 on")
    simulation = Simulation(as_scenario(scenario_or_path, overrides, parameters))
    simulation.settle()
    linear = simulation.linearize()
    chosen, set_ = linear.states if states is None else list(states), list(inputs)
    rows, columns = places("states", chosen, linear.states), places("inputs", set_, linear.inputs)
    a, b = linear.A.values[np.ix_(rows, rows)], linear.B.values[np.ix_(rows, columns)]
    q, r = weights_of("Q", Q, chosen), weights_of("R", R, set_, positive=True)
    check_reach(a, b, chosen)
    gains, p = solve(a, b, q, r, period_s)
    held, moved, weight, cross, of_input = sampled(a, b, q, r, period_s)
    own = {name: (simulation.inputs[name].lower, simulation.inputs[name].upper) for name in set_}
    within = own | _limits("input_limits", input_limits, set_)
    beside = _limits("state_limits", state_limits, chosen)
    rates = _limits("input_rates", {name: (-one, one) for name, one in (input_rates or {}).items()}, set_)
    return PredictiveRegulator(
        chosen,
        set_,
        period_s,
        int(horizon),
        gains,
        held,
        moved,
        (weight, cross, of_input, p),
        np.array([within[name] for name in set_]).T,
        np.array([rates.get(name, (0, math.inf))[1] for name in set_]),
        [(chosen.index(name), *span) for name, span in beside.items()],
    )


def _limits(what: str, given: Limits | None, names: list[str]) -> dict[str, tuple[float, float]]:
    """Limits by name, from lower to upper."""
    if not given:
        return {}
    places(what, list(given), names)
    for name, (lower, upper) in given.items():
        if not lower <= upper:
            raise KingpostError(f"{what} {name}: found {lower} to {upper}, allowed: from lower to upper")
    return {name: (float(lower), float(upper)) for name, (lower, upper) in given.items()}

"""Linear-quadratic regulators on the exact linearisation about rest."""

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
from ..simulation.linear import RATE
from ..simulation.python_warnings import emit_warnings
from ..simulation.simulate import Simulation
from .riccati import (
    NO_REST,
    SMALLEST_SHARE,
    Matrix,
    check_reach,
    closed_loop,
    places,
    solve,
    unreached,
    weights_of,
)

if TYPE_CHECKING:
    import xarray

SLOW = 0.1
"""Damping ratio below which a warning names an oscillation that no input moves: it lasts for several
periods."""


@dataclass(frozen=True)
class Regulator:
    """A linear-quadratic regulator ``u = -K x``; made by `lqr`.

    Attributes
    ----------
    gains
        K, dimensions ``input`` and ``state``.
    cost_matrix
        P, dimensions ``state`` and ``other``: from x0 the cost is ``x0' P x0``.
    eigenvalues
        Eigenvalues of the closed loop of the states in the design, 1/s; with a sampling period T they are
        ``ln(z) / T`` of the sampled eigenvalues z.
    all_eigenvalues
        Closed-loop eigenvalues of all states of the scenario with the regulator, 1/s.
    period_s
        Sampling period, s; None if it acts continuously.
    unmoved
        Descriptions of the slowly decaying oscillations that the inputs do not move: the feedback does not
        change them.
    """

    gains: xarray.DataArray
    cost_matrix: xarray.DataArray
    eigenvalues: NDArray[np.complex128]
    all_eigenvalues: NDArray[np.complex128]
    period_s: float | None = None
    unmoved: tuple[str, ...] = ()

    def cost(self, x0: ArrayLike) -> float:
        """The cost ``x0' P x0`` from a state.

        Parameters
        ----------
        x0
            The states x0, in the order and the units of ``gains``.

        Returns
        -------
        float
            The cost, in the units of the weights.

        Examples
        --------
        >>> import xarray
        >>> one = xarray.DataArray([[2.0]], {"state": ["x"], "other": ["x"]})
        >>> Regulator(one.rename(other="input"), one, np.zeros(1), np.zeros(1)).cost([3.0])
        18.0
        """
        start = np.asarray(x0, float)
        return float(start @ self.cost_matrix.values @ start)

    def scenario(self, scenario: Scenario, controller: str) -> Scenario:
        """Return the scenario with these gains in a controller that reads the states' columns and sets the
        inputs.

        A coordinate's column is ``slew.joint_position``, its rate's ``slew.joint_velocity``; a drive's state
        is read by its own name. Columns that are no states of the regulator get the gain 0.

        Parameters
        ----------
        scenario
            A scenario with the controller.
        controller
            The controller's name.

        Returns
        -------
        Scenario
            The scenario with these gains, and the sampling period if there is one.

        Raises
        ------
        KingpostError
            If there is no such controller, it does not read a state, or it does not set an input.

        Examples
        --------
        >>> import kingpost
        >>> slew = kingpost.load("slew_without_swing", feedback=True)
        >>> inputs = ["slewing.target_offset", "luffing.target_offset"]
        >>> weights = {"slew": 1, "luff": 1, "pendant.first": 20, "pendant.second": 20}
        >>> regulator = kingpost.lqr(slew, inputs=inputs, Q=weights, R=[1, 1], period_s=0.1)
        >>> regulator.scenario(slew, "swing_feedback").title == slew.title
        True
        """
        controllers = scenario.resolved.get("controllers", {})
        feedback = {
            name: (kind, given)
            for name, tagged in controllers.items()
            for kind, given in tagged.items()
            if "reads" in given
        }
        if controller not in feedback:
            allowed = ", ".join(feedback) or "none: the scenario has no state feedback"
            raise KingpostError(f"controller: found {controller}, allowed: {allowed}")
        kind, given = feedback[controller]
        lead = f"controllers.{controller}.{kind}"
        columns = [read["column"] for read in given["reads"]]
        targets = [steer["to"] for steer in given["steers"]]
        # The name of a drive's state is also the name of its column.
        states = self.gains["state"].values.tolist()
        wanted = {state if state in columns else column_of(state): state for state in states}
        _all_there(f"{lead}.reads", wanted, columns)
        _all_there(f"{lead}.steers", self.gains["input"].values.tolist(), targets)
        changes: dict[str, Any] = {}
        for name in self.gains["input"].values.tolist():
            row = self.gains.sel(input=name)
            gains = [float(row.sel(state=wanted[c])) if c in wanted else 0.0 for c in columns]
            changes[f"{lead}.steers.{targets.index(name)}.gains"] = gains
        if self.period_s is not None:
            changes[f"{lead}.period_s"] = self.period_s
        return scenario.with_overrides(changes)


def _all_there(field: str, wanted: Mapping[str, str] | Sequence[str], found: Sequence[str]) -> None:
    missing = [name for name in wanted if name not in found]
    if missing:
        raise KingpostError(f"{field}: found {', '.join(found)}, allowed: also {', '.join(missing)}")


def column_of(state: str) -> str:
    """The column that shows a coordinate or its rate.

    >>> column_of("slew"), column_of("pendant.first.rate")
    ('slew.joint_position', 'pendant.first.joint_velocity')
    """
    if state.endswith(RATE):
        return f"{state.removesuffix(RATE)}.joint_velocity"
    return f"{state}.joint_position"


def lqr(
    scenario_or_path: Scenario | str | Path,
    overrides: Overrides | None = None,
    *,
    inputs: Sequence[str],
    states: Sequence[str] | None = None,
    Q: Mapping[str, float] | ArrayLike,  # noqa: N803
    R: Mapping[str, float] | ArrayLike,  # noqa: N803
    period_s: float | None = None,
    **parameters: Any,
) -> Regulator:
    """The linear-quadratic regulator ``u = -K x`` of small motions about rest.

    It minimises ``J = integral of x' Q x + u' R u`` for ``x' = A x + B u``, with A and B exact, of
    `Simulation.linearize` at the equilibrium. With the solution P of ``A' P + P A - P B R^-1 B' P + Q = 0``,
    ``K = R^-1 B' P`` and the least cost is ``x0' P x0`` (Anderson & Moore, *Optimal Control: Linear Quadratic
    Methods*, 1990, ch. 2-3). With a sampling period u is held between samples; x and J stay those between
    the samples too (Van Loan, "Computing integrals involving the matrix exponential", *IEEE Trans. Autom.
    Control* 23(3), 1978).

    Parameters
    ----------
    scenario_or_path, overrides, parameters
        Scenario and overrides, as in `run`. Its controllers do not act.
    inputs
        Names of the inputs u that the regulator sets.
    states
        Names of the states x that it reads, of `Linearization.states`; None for all. Other states are held at
        rest in the design: a ship, for example. ``all_eigenvalues`` shows their effect on the closed loop.
    Q, R
        Weights: by name, as ``{"slew": 1}`` with 0 for the others, as a diagonal, or as a symmetric matrix.
        Q is positive semidefinite, R positive definite.
    period_s
        Sampling period, s; None for a continuous regulator.

    Returns
    -------
    Regulator
        Gains, cost and the eigenvalues of the closed loop.

    Raises
    ------
    KingpostError
        If a name is unknown, a weight is not allowed, the inputs do not move a mode that does not decay (the
        error names it), or such a mode has no weight in Q. For a slowly decaying mode that the inputs do not
        move there is a warning, and ``unmoved`` names it.

    Examples
    --------
    A mass of 2 kg on a slide, and its position and force weighed equally: the double integrator.

    >>> joint = {"prismatic": {"name": "slide", "axis": [1, 0, 0]}}
    >>> body = {"mass_kg": 2, "shape": {"point": {}}, "joint": joint}
    >>> drive = {"linear_motor": {"joint": "slide", "force_N": 1, "history": "lever"}}
    >>> cage = {"version": 1, "title": "Cage", "bodies": {"cage": body}, "drives": {"push": drive}}
    >>> import json
    >>> scenario = Scenario(json.dumps(cage), "cage.json")
    >>> lqr(scenario, inputs=["push"], Q={"slide": 1}, R=[1]).gains.values.round(6).tolist()
    [[1.0, 2.0]]
    """
    simulation = Simulation(as_scenario(scenario_or_path, overrides, parameters))
    simulation.settle()
    linear = simulation.linearize()
    chosen = linear.states if states is None else list(states)
    rows = places("states", chosen, linear.states)
    columns = places("inputs", list(inputs), linear.inputs)
    whole_a, whole_b = linear.A.values, linear.B.values[:, columns]
    a, b = whole_a[np.ix_(rows, rows)], whole_b[rows]
    q = weights_of("Q", Q, chosen)
    r = weights_of("R", R, list(inputs), positive=True)
    if period_s is not None and not (math.isfinite(period_s) and period_s > 0):
        raise KingpostError(f"period_s: found {period_s}, allowed: a number greater than 0, or None")
    check_reach(a, b, chosen)
    unmoved = tuple(_slow(value, about) for value, about in unreached(a, b, chosen) if _is_slow(value))
    emit_warnings(unmoved)
    gains, cost = solve(a, b, q, r, period_s)
    closed = closed_loop(a, b, gains, period_s)
    if not closed[0].real < -(SMALLEST_SHARE**0.5) * abs(closed).max():
        raise KingpostError(NO_REST.format(f"an eigenvalue of {closed[0].real:.1g}/s"))
    embedded = np.zeros((len(columns), len(whole_a)))
    embedded[:, rows] = gains
    return Regulator(
        _labelled("gains", gains, {"input": list(inputs), "state": chosen}),
        _labelled("cost_matrix", cost, {"state": chosen, "other": chosen}),
        closed,
        closed_loop(whole_a, whole_b, embedded, period_s),
        period_s,
        unmoved,
    )


def _is_slow(value: complex) -> bool:
    return value.imag > 0 and -value.real < SLOW * abs(value)


def _slow(value: complex, about: str) -> str:
    """Warning about an oscillation that the inputs do not move.

    >>> _slow(complex(-0.01, 0.7), "lift")
    'the inputs do not move the mode of period 8.976 s in which lift takes part (damping ratio 0.0143)'
    """
    return (
        f"the inputs do not move the mode of period {2 * math.pi / value.imag:.4g} s in which {about} takes "
        f"part (damping ratio {-value.real / abs(value):.3g})"
    )


def _labelled(name: str, values: Matrix, labels: dict[str, list[str]]) -> xarray.DataArray:
    import xarray

    coords = {dim: np.array(of, str) for dim, of in labels.items()}
    return xarray.DataArray(values, coords, tuple(labels), name)

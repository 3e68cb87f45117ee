"""The linearised system about a state, with the names of its states."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

RATE = ".rate"
"""Suffix of the name of a coordinate's rate."""


@dataclass(frozen=True)
class Linearization:
    """A and B of ``x' = rates + A x + B u`` about one state, exact to rounding.

    The states x are small motions from that state, in this order:

    1. the free coordinates, such as ``slew`` (m or rad). A floating body moves along the world's axes
       and turns by a rotation vector in its own axes;
    2. their rates, such as ``slew.rate`` (m/s or rad/s), in the same axes;
    3. the states of drives and forces, such as ``luffing.wanted_length`` of a lever (m).

    The inputs u are changes of `Simulation.inputs`. Held and prescribed coordinates are not states;
    prescribed coordinates keep their motion. With closed loops, all coordinates of the open tree are states,
    and `Simulation.constraint_matrix` times x is zero for the coordinates and for their rates. A scenario
    without D is linearised with D.

    Attributes
    ----------
    A
        Derivative of the rate of the row's state by the column's state, dimensions ``row`` and ``column``.
    B
        Derivative of the rate of the row's state by the column's input.
    rates
        The rates at the state itself, by ``row``: zero at an equilibrium.
    units
        SI unit of each state.
    remembers
        Whether each state is a memory of past motion, such as a state of radiated waves or of a filter.
    advanced
        Whether explicit schemes leave each state to its element, which advances it implicitly (lines).
    input_units
        Unit of each input.
    warning
        A warning or None: if a prescribed coordinate moves or accelerates, A holds at one instant only.
    """

    A: xarray.DataArray
    B: xarray.DataArray
    rates: xarray.DataArray
    units: list[str]
    remembers: NDArray[np.bool_]
    advanced: NDArray[np.bool_]
    input_units: list[str]
    warning: str | None = None

    @property
    def states(self) -> list[str]:
        """Names of the states."""
        return self.A["row"].values.tolist()

    @property
    def inputs(self) -> list[str]:
        """Names of the inputs."""
        return self.B["column"].values.tolist()

    @property
    def coordinates(self) -> list[str]:
        """Names of the free coordinates, which are the first states; their rates follow."""
        return self.states[: sum(name.endswith(RATE) for name in self.states)]


def labelled(a: NDArray, b: NDArray, rates: NDArray, names_json: str) -> Linearization:
    """The engine's arrays with their names."""
    import xarray

    names = json.loads(names_json)
    states, inputs = names["states"], names["inputs"]

    def matrix(name: str, values: NDArray, columns: list[str]) -> xarray.DataArray:
        labels = {"row": np.array(states, str), "column": np.array(columns, str)}
        return xarray.DataArray(values, labels, ("row", "column"), name)

    along = xarray.DataArray(rates, {"row": np.array(states, str)}, ("row",), "rates")
    return Linearization(
        matrix("A", a, states),
        matrix("B", b, inputs),
        along,
        names["units"],
        np.array(names["remembers"], bool),
        np.array(names["advanced"], bool),
        names["input_units"],
        names["warning"],
    )


@dataclass(frozen=True)
class Equilibrium:
    """How an equilibrium was found.

    Attributes
    ----------
    iterations
        Number of Newton iterations.
    residual
        Largest remaining acceleration, m/s2 or rad/s2.
    """

    iterations: int
    residual: float

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
"""Ends the name of a coordinate's rate."""


@dataclass(frozen=True)
class Linearization:
    """A and B of ``x' = rates + A x + B u`` about one state, exact to rounding.

    The states x are small motions from there, in this order:

    1. the free coordinates, as ``slew`` (m or rad). A floating body moves along the world's axes
       and turns by a rotation vector in its own axes;
    2. their rates, as ``slew.rate`` (m/s or rad/s), in the same axes;
    3. what drives and forces keep, as ``luffing.wanted_length`` of a lever (m).

    The inputs u are changes of `Simulation.inputs`. Held and prescribed coordinates are not among
    the states; prescribed ones keep the motion that they have. Where there are closed loops all
    coordinates of the open tree are, and motions are such that `Simulation.constraint_matrix` times
    x vanishes, for the coordinates and for their rates. Equations without D are linearised with it.

    Attributes
    ----------
    A
        Rate of the row's state by the column's, dimensions ``row`` and ``column``.
    B
        Rate of the row's state by the column's input.
    rates
        The rates at the state itself, by ``row``: zero at an equilibrium.
    units
        SI unit of each state.
    remembers
        Whether each state only remembers how something moved, as radiated waves do and filters.
    input_units
        Unit of each input.
    warning
        What A does not say, or None: where a prescribed coordinate moves or accelerates, A is that of
        one instant.
    """

    A: xarray.DataArray
    B: xarray.DataArray
    rates: xarray.DataArray
    units: list[str]
    remembers: NDArray[np.bool_]
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
        """Names of the free coordinates: the states begin with them, then come their rates."""
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
        names["input_units"],
        names["warning"],
    )


@dataclass(frozen=True)
class Equilibrium:
    """How an equilibrium was found.

    Attributes
    ----------
    iterations
        Newton's iterations.
    residual
        Largest acceleration that is left, m/s2 or rad/s2.
    """

    iterations: int
    residual: float

"""The longest step at which an explicit scheme is stable, by the eigenvalues where a run begins."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from ..errors import KingpostError
from ..scenario import Scenario
from ..simulation.simulate import Simulation

if TYPE_CHECKING:
    from pathlib import Path

    from numpy.typing import NDArray

GROWTH: dict[str, Callable[[NDArray[np.complex128]], NDArray[np.complex128]]] = {
    "forward_euler": lambda z: 1 + z,
    "midpoint_euler": lambda z: 1 + z,
    "rk4": lambda z: 1 + z * (1 + z / 2 * (1 + z / 3 * (1 + z / 4))),
}
"""What a step h makes of a motion exp(lambda t), z = h lambda (Hairer & Wanner, *Solving Ordinary
Differential Equations II*, 1996, sec. IV.2)."""
DAMPED = 0.02
"""Motions with a smaller ratio of damping are not judged: Euler's method makes them grow at any step."""
LONGEST_S, HALVINGS = 1e3, 60


def stable_step(scenario_or_simulation: Scenario | Simulation | str | Path) -> float | None:
    """The longest stable step of a scenario's scheme, s; None where the scheme has no such limit.

    A step beyond it makes the quickest damped motion grow: a cylinder's pressure, a stop, the torsion of a
    boom. It holds where the run begins; a stop that is met later is stiffer than that. Dormand and Prince's
    scheme chooses its own steps, implicit ones are stable at any.

    >>> print(f"{stable_step('flexible_boom'):.2g}")
    0.00084
    """
    given = scenario_or_simulation
    simulation = given if isinstance(given, Simulation) else Simulation(given)
    growth = GROWTH.get(simulation.scenario.resolved["simulation"]["integrator"])
    if growth is None:
        return None
    values = np.linalg.eigvals(simulation.linearize().A.to_numpy())
    values = values[-values.real > DAMPED * np.abs(values)]
    # Motions that take an hour have no part in it, nor has what rounding leaves of none.
    values = values[np.abs(values) > 1 / LONGEST_S]
    if not values.size:
        return None
    return float(min(_limit(growth, value) for value in values))


def warning(simulation: Simulation) -> str | None:
    """What to say of a step that is too long, before a run; None where it is not."""
    settings = simulation.scenario.resolved["simulation"]
    try:
        limit = stable_step(simulation)
    except KingpostError:
        # What cannot be linearised where it begins, the run itself says better.
        return None
    if limit is None or settings["step_s"] <= limit:
        return None
    return (
        f"the step of {settings['step_s']:g} s is too long for {settings['integrator']}: its quickest motion "
        f"grows by steps beyond {limit:.2g} s, where the run begins; take shorter ones, dormand_prince, "
        "which chooses them, or an implicit scheme (docs/schemes.md)"
    )


def _limit(growth: Callable[[NDArray[np.complex128]], NDArray[np.complex128]], value: complex) -> float:
    """The step at which a damped motion begins to grow, by scanning outward and halving."""
    steps = np.geomspace(1e-3, 1e2, 2000) / abs(value)
    grows = np.flatnonzero(np.abs(growth(steps * value)) > 1)
    if not grows.size or grows[0] == 0:
        return float(steps[-1] if not grows.size else steps[0])
    low, high = steps[grows[0] - 1], steps[grows[0]]
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        low, high = (low, middle) if abs(growth(np.array(middle * value))) > 1 else (middle, high)
    return float(low)

"""The longest step at which an explicit scheme is stable, by the eigenvalues at the start of a run."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..simulation.simulate import Simulation
from ..simulation.step_limit import longest_step_s

if TYPE_CHECKING:
    from pathlib import Path

    from ..scenario import Scenario


def stable_step(scenario_or_simulation: Scenario | Simulation | str | Path) -> float | None:
    """The longest stable step of a scenario's scheme, s; None if the scheme has no such limit.

    With a longer step the fastest damped motion diverges: the pressure of a cylinder, a stop, the torsion of
    a boom. The limit holds at the start of the run; a stop that is reached later may require a shorter step.
    The scheme of Dormand and Prince controls its step, and implicit schemes are stable at any step.

    Parameters
    ----------
    scenario_or_simulation
        A scenario, a file or a name of the gallery, at the start of its run; or a simulation in its present
        state.

    Returns
    -------
    float or None
        s; `None` if the scheme has no such limit.

    Raises
    ------
    KingpostError
        If the scenario cannot be linearised there.

    >>> print(f"{stable_step('flexible_boom'):.2g}")
    0.00084
    """
    given = scenario_or_simulation
    simulation = given if isinstance(given, Simulation) else Simulation(given)
    settings = simulation.scenario.resolved["simulation"]
    return longest_step_s(settings["integrator"], *simulation.linear_in_calm(), settings["step_s"])

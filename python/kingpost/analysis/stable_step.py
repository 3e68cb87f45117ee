"""The longest step at which an explicit scheme is stable, by the eigenvalues where a run begins."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..simulation.simulate import Simulation
from ..simulation.step_limit import longest_step_s

if TYPE_CHECKING:
    from pathlib import Path

    from ..scenario import Scenario


def stable_step(scenario_or_simulation: Scenario | Simulation | str | Path) -> float | None:
    """The longest stable step of a scenario's scheme, s; None where the scheme has no such limit.

    A step beyond it makes the quickest damped motion grow: a cylinder's pressure, a stop, the torsion of a
    boom. It holds where the run begins; a stop that is met later is stiffer than that. Dormand and Prince's
    scheme chooses its own steps, implicit ones are stable at any.

    Parameters
    ----------
    scenario_or_simulation
        A scenario, a file or a name of the gallery, where its run begins; or a simulation as it stands.

    Returns
    -------
    float or None
        s; `None` where the scheme has no such limit.

    Raises
    ------
    KingpostError
        When the scenario cannot be linearised there.

    >>> print(f"{stable_step('flexible_boom'):.2g}")
    0.00084
    """
    given = scenario_or_simulation
    simulation = given if isinstance(given, Simulation) else Simulation(given)
    integrator = simulation.scenario.resolved["simulation"]["integrator"]
    return longest_step_s(integrator, simulation.linearize().A.to_numpy())

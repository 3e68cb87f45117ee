"""Kingpost: ships with cranes at sea by the moving frame method.

>>> import kingpost
>>> results = kingpost.run("paper", crane_x_m=0, crane_y_m=0)
>>> float(results.time[-1])
3.0
"""

from . import lift_rules, verify
from .batch import Batch
from .engine import engine
from .errors import KingpostError, RunError, ScenarioError
from .gradients import gradient
from .linear import Equilibrium, Linearization
from .records import Input, State
from .response import rao
from .scenario import Scenario, load
from .simulate import Simulation, run
from .stable_step import stable_step
from .vibration import equilibrium, modes

__version__: str = engine.__version__

__all__ = [
    "Batch",
    "Equilibrium",
    "Input",
    "KingpostError",
    "Linearization",
    "RunError",
    "Scenario",
    "ScenarioError",
    "Simulation",
    "State",
    "__version__",
    "equilibrium",
    "gradient",
    "lift_rules",
    "load",
    "modes",
    "rao",
    "run",
    "stable_step",
    "verify",
]

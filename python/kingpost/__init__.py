"""Kingpost: ships with cranes at sea by the moving frame method.

>>> import kingpost
>>> results = kingpost.run("paper", crane_x_m=0, crane_y_m=0)
>>> float(results.time[-1])
3.0
"""

import logging

from . import forking, results, verify
from .accessor import Accessor
from .analysis import extremes, fatigue, lift_rules, statistics
from .analysis.drive_functions import DriveFunctions, drive_functions
from .analysis.gradients import gradient
from .analysis.predictive import Plan, PredictiveRegulator, mpc
from .analysis.range_graphs import line_fatigue, range_graph
from .analysis.regulator import Regulator, lqr
from .analysis.response import rao
from .analysis.spectral import spectral_response
from .analysis.splash_zone import splash_zone
from .analysis.stable_step import stable_step
from .analysis.vibration import equilibrium, modes
from .analysis.wave_response import wave_response
from .engine import engine
from .errors import KingpostError, KingpostWarning, RunError, ScenarioError
from .pictures import picture
from .scenario import Scenario, load
from .simulation.batch import Batch
from .simulation.linear import Equilibrium, Linearization
from .simulation.records import Input, State
from .simulation.simulate import Simulation, run
from .study.study import Study, open_study

# A library does not print its log: the program that imports it decides where log messages go.
logging.getLogger(__name__).addHandler(logging.NullHandler())

forking.watch()

__version__: str = engine.__version__

__all__ = [
    "Accessor",
    "Batch",
    "DriveFunctions",
    "Equilibrium",
    "Input",
    "KingpostError",
    "KingpostWarning",
    "Linearization",
    "Plan",
    "PredictiveRegulator",
    "Regulator",
    "RunError",
    "Scenario",
    "ScenarioError",
    "Simulation",
    "State",
    "Study",
    "__version__",
    "drive_functions",
    "equilibrium",
    "extremes",
    "fatigue",
    "gradient",
    "lift_rules",
    "line_fatigue",
    "load",
    "lqr",
    "modes",
    "mpc",
    "open_study",
    "picture",
    "range_graph",
    "rao",
    "results",
    "run",
    "spectral_response",
    "splash_zone",
    "stable_step",
    "statistics",
    "verify",
    "wave_response",
]

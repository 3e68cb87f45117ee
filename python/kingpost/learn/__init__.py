"""Environments for learning controllers, in the interface of Gymnasium (docs/learning.md).

Importing this module registers the environments of `IDS`, such as ``Kingpost/AntiSway-v0``. It needs the
extra ``learn``.
"""

from __future__ import annotations

from .acting import Policy
from .baselines import BASELINES
from .contenders import contenders, trained
from .environment import ShipCraneEnv
from .evolution import Training, train
from .network import NeuralPolicy, read_policy
from .registered import IDS, register
from .scores import score
from .task import Action, Observation, Task
from .tasks import anti_sway, heave_compensation, landing, roll_reduction, three_axis
from .vector import ShipCraneVectorEnv

register()

__all__ = [
    "BASELINES",
    "IDS",
    "Action",
    "NeuralPolicy",
    "Observation",
    "Policy",
    "ShipCraneEnv",
    "ShipCraneVectorEnv",
    "Task",
    "Training",
    "anti_sway",
    "contenders",
    "heave_compensation",
    "landing",
    "read_policy",
    "roll_reduction",
    "score",
    "three_axis",
    "train",
    "trained",
]

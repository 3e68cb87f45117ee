"""Environments for learning controllers, in the interfaces of Gymnasium and of PettingZoo (docs/learning.md).

Importing this module registers the environments of `IDS`, such as ``Kingpost/AntiSway-v0``. It needs the
extra ``learn``; `ShipCraneParallelEnv` needs the extra ``pettingzoo``.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ..errors import KingpostError
from .agents import Agent
from .baselines import BASELINES
from .benchmarks import benchmarks
from .environment import ShipCraneEnv
from .evolution import Training, train
from .network import NeuralPolicy, read_policy
from .policies import Policy
from .pretrained import trained
from .registered import IDS, register
from .scores import score
from .task import Action, Observation, Task
from .tasks import anti_sway, anti_sway_at_sea, heave_compensation, landing, roll_reduction, three_axis
from .vector import ShipCraneVectorEnv

if TYPE_CHECKING:
    from .parallel import ShipCraneParallelEnv as ShipCraneParallelEnv

register()


def __getattr__(name: str) -> Any:
    """`ShipCraneParallelEnv`. It is not in `__all__`, so that `import *` works without PettingZoo."""
    if name != "ShipCraneParallelEnv":
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    try:
        from .parallel import ShipCraneParallelEnv
    except ModuleNotFoundError:
        raise KingpostError(
            f'{name}: found no PettingZoo, allowed: with pip install "kingpost[pettingzoo]"'
        ) from None
    return ShipCraneParallelEnv


__all__ = [
    "BASELINES",
    "IDS",
    "Action",
    "Agent",
    "NeuralPolicy",
    "Observation",
    "Policy",
    "ShipCraneEnv",
    "ShipCraneVectorEnv",
    "Task",
    "Training",
    "anti_sway",
    "anti_sway_at_sea",
    "benchmarks",
    "heave_compensation",
    "landing",
    "read_policy",
    "roll_reduction",
    "score",
    "three_axis",
    "train",
    "trained",
]

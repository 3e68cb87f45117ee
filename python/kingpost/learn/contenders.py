"""Controllers whose scores are compared: classical ones, those that know the equations, trained ones."""

from __future__ import annotations

from collections.abc import Callable

from .acting import Policy
from .baselines import BASELINES
from .carried import FILES, trained
from .model_based import linear_quadratic, predictive
from .sampled import sampled
from .task import Task

BY_MODEL: dict[str, dict[str, Callable[[Task], Policy]]] = {
    "Kingpost/AntiSway-v0": {
        "LQR (`kingpost.lqr`)": linear_quadratic,
        "predictive (`kingpost.mpc`)": predictive,
        "predictive, by sampling around the policy": sampled,
    },
}


def contenders(environment: str) -> dict[str, Callable[[Task], Policy]]:
    """All controllers of an environment by name.

    >>> list(contenders("Kingpost/AntiSway-v0"))[-1]
    'trained policy'
    """
    found = BASELINES[environment] | BY_MODEL.get(environment, {})
    if environment in FILES:
        policy = trained(environment)
        found["trained policy"] = lambda task: policy
    return found

"""Controllers whose scores are compared: classical, model-based and trained ones."""

from __future__ import annotations

from collections.abc import Callable

from .baselines import BASELINES
from .cem_mpc import cem_mpc
from .model_based import linear_quadratic, predictive
from .policies import Policy
from .pretrained import FILES, trained
from .task import Task

BY_SAMPLING = "predictive, by sampling around the policy"
LINEAR: dict[str, Callable[[Task], Policy]] = {
    "LQR (`kingpost.lqr`)": linear_quadratic,
    "predictive (`kingpost.mpc`)": predictive,
}
BY_MODEL: dict[str, dict[str, Callable[[Task], Policy]]] = {
    "Kingpost/AntiSway-v0": LINEAR | {BY_SAMPLING: cem_mpc},
    "Kingpost/AntiSwayAtSea-v0": LINEAR,
}
FIXED_BASE = "Kingpost/AntiSway-v0"


CALM = {"significant_height_m": 0.001}
"""Sea that a plan assumes if the future waves are unknown."""


def _in_calm_water(task: Task) -> Policy:
    return cem_mpc(task, foreseen=CALM)


def benchmarks(environment: str, at_sea: bool = False) -> dict[str, Callable[[Task], Policy]]:
    """All controllers of an environment by name, including those for a ship in a sea.

    >>> list(benchmarks("Kingpost/AntiSway-v0"))[-1]
    'trained policy'
    >>> [name for name in benchmarks("Kingpost/AntiSway-v0", at_sea=True) if "calm" in name]
    ['predictive, by sampling around the policy, as if the water were calm from now on']
    """
    found = BASELINES[environment] | BY_MODEL.get(environment, {})
    if at_sea:
        found[f"{BY_SAMPLING}, as if the water were calm from now on"] = _in_calm_water
    if environment == "Kingpost/AntiSwayAtSea-v0":
        found["policy trained on a fixed base"] = trained(FIXED_BASE).of
    if environment in FILES:
        found["trained policy"] = trained(environment).of
    return found

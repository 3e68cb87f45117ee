"""Controllers whose scores are compared: classical ones, those that know the equations, trained ones."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from ..errors import KingpostError
from .acting import Policy
from .baselines import BASELINES
from .model_based import linear_quadratic, predictive
from .network import NeuralPolicy, read_policy
from .task import Task

POLICIES = Path(__file__).parent / "policies"
FILES = {"Kingpost/AntiSway-v0": "anti_sway.json"}
"""The file of each environment's trained policy."""
BY_MODEL: dict[str, dict[str, Callable[[Task], Policy]]] = {
    "Kingpost/AntiSway-v0": {
        "LQR (`kingpost.lqr`)": linear_quadratic,
        "predictive (`kingpost.mpc`)": predictive,
    },
}


def trained(environment: str) -> NeuralPolicy:
    """The policy that the package carries for an environment.

    Parameters
    ----------
    environment
        Name of the environment.

    Returns
    -------
    NeuralPolicy
        The policy; its ``about`` says how it was trained.

    Raises
    ------
    KingpostError
        If there is none for this environment.

    >>> trained("Kingpost/AntiSway-v0").observations[:2]
    ('slew_error', 'luff_error')
    """
    if environment not in FILES:
        raise KingpostError(f"environment: found {environment}, allowed: {', '.join(FILES)}")
    return read_policy(POLICIES / FILES[environment])


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

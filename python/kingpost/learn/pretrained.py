"""Trained policies in the package."""

from __future__ import annotations

from pathlib import Path

from ..errors import KingpostError
from .network import NeuralPolicy, read_policy

POLICIES = Path(__file__).parent / "weights"
FILES = {
    "Kingpost/AntiSway-v0": "anti_sway.json",
    "Kingpost/AntiSwayAtSea-v0": "anti_sway_at_sea.json",
}
"""The file of each environment's trained policy."""


def trained(environment: str) -> NeuralPolicy:
    """Read the trained policy of an environment.

    Parameters
    ----------
    environment
        Name of the environment.

    Returns
    -------
    NeuralPolicy
        The policy; its attribute ``about`` describes the training.

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

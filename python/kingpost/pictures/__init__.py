"""Pictures of described models without a browser."""

from .drawing import Drawing
from .picture import picture, png, scenario_of_run

__all__ = ["Drawing", "picture", "png", "scenario_of_run"]

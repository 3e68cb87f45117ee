"""Pictures of described models without a browser."""

from .drawing import Drawing, Viewpoint
from .picture import picture, png, scenario_of_run

__all__ = ["Drawing", "Viewpoint", "picture", "png", "scenario_of_run"]

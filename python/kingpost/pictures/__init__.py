"""Pictures of described models without a browser."""

from .drawing import Drawing, Viewpoint
from .notebook import ELEMENT, use_app
from .picture import picture, png, scenario_of_run

__all__ = ["ELEMENT", "Drawing", "Viewpoint", "picture", "png", "scenario_of_run", "use_app"]

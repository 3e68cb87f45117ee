"""The tasks that are registered with Gymnasium, a file each."""

from .anti_sway import anti_sway
from .anti_sway_at_sea import anti_sway_at_sea
from .heave_compensation import heave_compensation
from .landing import landing
from .roll_reduction import roll_reduction
from .three_axis import three_axis

__all__ = ["anti_sway", "anti_sway_at_sea", "heave_compensation", "landing", "roll_reduction", "three_axis"]

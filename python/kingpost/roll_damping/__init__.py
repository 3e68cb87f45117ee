"""Viscous roll damping of a hull: by Ikeda's method from its sections, or from a decay test.

`from_sections` and `from_decay` give the equivalent linear damping over the amplitude, and the coefficients
that the forces ``viscous_damping`` and ``quadratic_damping`` of a scenario take.
"""

from .bilge_keels import BilgeKeels
from .coefficients import Coefficients, fragment
from .decay import DecayFit, from_decay
from .hulls import sections_of
from .ikeda import from_sections
from .record import DecayRecord
from .sections import Sections

__all__ = [
    "BilgeKeels",
    "Coefficients",
    "DecayFit",
    "DecayRecord",
    "Sections",
    "fragment",
    "from_decay",
    "from_sections",
    "sections_of",
]

"""Numerical checks of the moving frame method, for the lessons.

Each function returns an `xarray.Dataset` with labelled dimensions and units.
"""

from .rotations import exponential_sums, rodrigues, skew, unskew
from .switch import with_and_without_d
from .variation import restricted_variation, restricted_variation_of_body
from .work import virtual_work

__all__ = [
    "exponential_sums",
    "restricted_variation",
    "restricted_variation_of_body",
    "rodrigues",
    "skew",
    "unskew",
    "virtual_work",
    "with_and_without_d",
]

"""Largest value in a given duration, estimated from several runs, with its uncertainty over their seeds.

- `extreme`: a Gumbel distribution of the largest value of each run;
- `weibull`, `over_threshold`: the tail of all peaks of the runs, a Weibull distribution, a generalised Pareto
  or an exponential one.

Each has quantiles for the length of an operation and intervals that hold their confidence from five runs on.
Runs are independent, peaks of one run are not: so the jackknife leaves out whole runs to find the
uncertainty.
"""

from .gumbel import EULER, THREE_HOURS_S, Extreme, extreme
from .peaks import over_threshold, peaks, weibull
from .tail import DISTRIBUTIONS, TailExtreme

__all__ = [
    "DISTRIBUTIONS",
    "EULER",
    "THREE_HOURS_S",
    "Extreme",
    "TailExtreme",
    "extreme",
    "over_threshold",
    "peaks",
    "weibull",
]

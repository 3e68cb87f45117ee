"""Largest value in a given duration, estimated from several runs, with its uncertainty over their seeds.

- `extreme`: a Gumbel distribution of the largest value of each run;
- `weibull`, `over_threshold`: the tail of all peaks of the runs, a Weibull distribution, a generalised Pareto
  or an exponential one;
- `one_off`: the order statistics of the largest values of an operation that happens once, which are never
  extrapolated;
- `Joined`: the largest value of several parts of an operation, each of one of these kinds.

Those of stationary runs have quantiles for the length of an operation and intervals that hold their
confidence from five runs on. Runs are independent, peaks of one run are not: so the jackknife leaves out
whole runs to find the uncertainty.
"""

from .gumbel import EULER, THREE_HOURS_S, Extreme, extreme
from .joined import Constant, Joined, Largest
from .one_off import (
    OneOff,
    one_off,
    seeds_for_interval,
    seeds_for_quantile,
    seeds_without_exceedance,
)
from .peaks import over_threshold, peaks, weibull
from .tail import DISTRIBUTIONS, TailExtreme

__all__ = [
    "DISTRIBUTIONS",
    "EULER",
    "THREE_HOURS_S",
    "Constant",
    "Extreme",
    "Joined",
    "Largest",
    "OneOff",
    "TailExtreme",
    "extreme",
    "one_off",
    "over_threshold",
    "peaks",
    "seeds_for_interval",
    "seeds_for_quantile",
    "seeds_without_exceedance",
    "weibull",
]

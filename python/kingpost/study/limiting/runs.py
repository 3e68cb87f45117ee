"""Limiting sea by time-domain runs: the significant height at which a limit is exceeded with the accepted
probability."""

from __future__ import annotations

from collections.abc import Hashable
from typing import TYPE_CHECKING

import numpy as np

from ...analysis.extremes import seeds_for_quantile
from ...errors import KingpostError
from ...results.entries import axes_of, sea_attributes, sea_of
from ..reduce import FINISHED, NOT_RUN
from .largest import Maxima

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

    from ...scenario import ParameterValue

    Numbers = NDArray[np.float64]
    Values = dict[str, list[ParameterValue]]

FEWEST_SEEDS = 5
CERTAIN = (np.inf, np.inf, np.inf, 1.0)
"""Quantile of the excess, its interval and the probability where a run ended early."""
FOUND, ABOVE, BELOW, NOT_KNOWN = "found", "above", "below", "not known"


def limiting_heights(
    results: xarray.Dataset,
    acceptance: float | None = None,
    operation_s: float | None = None,
    confidence: float = 0.9,
) -> xarray.Dataset:
    """Find the largest significant height at which each limit is exceeded with the accepted probability.

    At each height, the excess of a run's worst value over its bound has a distribution over the seeds, and
    the height is the one at which its quantile 1 - `acceptance` is 0:

    - of stationary runs a Gumbel distribution, extrapolated to the operation's duration (`extreme`);
    - of runs that happen once the order statistics of the seeds, without an extrapolation (`one_off`), joined
      with the Gumbel distributions of their stationary steps, each extrapolated to its own duration.

    No quantile passes the physical bounds of the column. Between two heights it is interpolated linearly:
    exact if the response is proportional to the height. If sampling makes it fall with the height, the
    largest of lower heights counts. Heights are not extrapolated.

    A run that ended early (a divergence, say) counts as one in which every limit without a value was
    exceeded: P of its case is 1.

    Parameters
    ----------
    results
        Results of a study whose axes are a grid: `limit_worst` and `status` along ``run``, the axes,
        ``at_least`` and ``at_most`` as coordinates, the attributes ``axes``, ``sea``, ``duration_s`` and
        ``after_s``; the coordinates ``limit_from_s`` and ``limit_until_s`` of limits that count for a part of
        a run.
    acceptance
        Accepted probability; default: that of the study.
    operation_s
        Duration of the operation of stationary runs, s; default: that of the study.
    confidence
        Confidence of the intervals.

    Returns
    -------
    xarray.Dataset
        Along ``limit`` and the axes without the height: ``limiting_height`` (m); ``limiting_height_low`` and
        ``limiting_height_high``, its interval over seeds, from the intervals of the quantile at each height:
        0 if the smallest height may already be too large, as with too few seeds, and the largest height if no
        height is shown to be too large; and
        ``limiting_height_state``: ``found``; ``above``: the accepted probability is not reached at the
        largest height of the study, which is then the limiting height; ``below``: it is exceeded at the
        smallest height, and the limiting height is then 0; ``not known``. ``limiting_height_of_all`` is the
        smallest over the limits, and ``governs`` names the limit. ``probability`` is P, along ``limit`` and
        all axes, ``ended_early`` counts runs.

    Raises
    ------
    KingpostError
        If runs are missing, there are too few seeds (`fewest_seeds`), no limits or no axis of the height, the
        axes are not a grid, or a duration is given for runs that happen once.
    """
    import xarray

    axes, height = _axes(results)
    acceptance = float(results.attrs["acceptance"] if acceptance is None else acceptance)
    if not 0 < acceptance < 1:
        raise KingpostError(f"acceptance: found {acceptance:g}, allowed: between 0 and 1")
    excess = Maxima.of_limits(results)
    if excess.one_off and operation_s is not None:
        allowed = "none for runs that happen once"
        raise KingpostError(f"operation_s: found {operation_s:g}, allowed: {allowed}")
    operation_s = float(results.attrs["operation_s"] if operation_s is None else operation_s)
    grid, values = _grid(results, axes, fewest_seeds(acceptance, excess.one_off))
    status = results["status"].values[grid]
    missing = int((status == NOT_RUN).sum())
    if missing:
        raise KingpostError(f"runs: found {missing} that have not run, allowed: all, as with --resume")
    found = _of_cases(excess, grid, status, (acceptance, operation_s, confidence))
    # The height is the last axis, in increasing order.
    at = axes.index(height)
    order = np.argsort(values[height])
    heights = np.asarray(values[height], float)[order]
    found = np.moveaxis(found, at + 2, -1)[..., order]
    ended = np.take((status != FINISHED).sum(axis=-1), order, axis=at)
    rising = np.maximum.accumulate(found[:3], axis=-1)
    passes = _passes(heights, rising)
    others = [name for name in axes if name != height]
    metre = {"units": "m", "long_name": "largest significant height that keeps the limit"}
    dims = ["limit", *others]
    smallest = passes[0].min(axis=0)
    governs = np.asarray(results["limit"].values, str)[np.argmin(passes[0], axis=0)]
    variables: dict[str, tuple[object, ...]] = {
        "limiting_height": (dims, passes[0], metre),
        "limiting_height_low": (dims, passes[1], metre),
        "limiting_height_high": (dims, passes[2], metre),
        "limiting_height_state": (dims, _state(rising[0])),
        "limiting_height_of_all": (others, smallest, metre),
        "governs": (others, governs),
        "probability": ([*dims, height], found[3], {"units": "1"}),
        "ended_early": (axes, ended),
    }
    about = {name: results.attrs[name] for name in ("title", "fingerprint") if name in results.attrs}
    about |= sea_attributes(sea_of(results)) | {
        "acceptance": acceptance,
        "confidence": confidence,
        "one_off": int(excess.one_off),
        "seeds": grid.shape[-1],
    }
    about |= {} if excess.one_off else {"operation_s": operation_s}
    coordinates = _coordinates(results, others, values) | {height: (height, heights, results[height].attrs)}
    return xarray.Dataset(variables, coordinates, about)


def fewest_seeds(acceptance: float, one_off: bool) -> int:
    """Number of seeds from which there are limiting heights.

    >>> fewest_seeds(0.1, one_off=True), fewest_seeds(0.1, one_off=False)
    (7, 5)
    """
    return max(FEWEST_SEEDS, seeds_for_quantile(acceptance)) if one_off else FEWEST_SEEDS


def _coordinates(results: xarray.Dataset, names: list[str], values: Values) -> dict[Hashable, object]:
    """Coordinates of the axes, and the properties of each limit."""
    found: dict[Hashable, object] = {
        name: (name, np.asarray(values[name]), results[name].attrs) for name in names
    }
    of_limits = (name for name in results.coords if results[name].dims == ("limit",))
    return found | {name: results[name].variable for name in of_limits}


def _axes(results: xarray.Dataset) -> tuple[list[str], str]:
    axes = axes_of(results)
    height = sea_of(results).get("significant_height")
    if height not in axes:
        raise KingpostError(f"significant height: found no axis of it among {', '.join(axes)}, allowed: one")
    if "limit" not in results.sizes:
        raise KingpostError("limits: found none, allowed: one or more, in the scenario or in the study")
    return axes, height


def _grid(results: xarray.Dataset, axes: list[str], fewest: int) -> tuple[NDArray[np.intp], Values]:
    """Indices of the runs along the axes and then the seeds, and the values of each axis."""
    values = {name: list(dict.fromkeys(results[name].values.tolist())) for name in axes}
    shape = [len(values[name]) for name in axes]
    seeds = list(dict.fromkeys(results["seed"].values.tolist()))
    if len(seeds) < fewest:
        raise KingpostError(f"seeds: found {len(seeds)}, allowed: {fewest} or more")
    size = int(np.prod(shape)) * len(seeds)
    if size != results.sizes["run"]:
        drawn = f"{results.sizes['run']} runs of which the axes' values make {size}"
        raise KingpostError(f"axes: found {drawn}, allowed: a grid, of axes with values or a range")
    places = [[values[name].index(value) for value in results[name].values.tolist()] for name in axes]
    places.append([seeds.index(seed) for seed in results["seed"].values.tolist()])
    found = np.empty((*shape, len(seeds)), np.intp)
    found[tuple(np.array(places))] = np.arange(results.sizes["run"])
    return found, values


def _of_cases(
    excess: Maxima,
    grid: NDArray[np.intp],
    status: NDArray[np.int8],
    by: tuple[float, float, float],
) -> Numbers:
    """Quantile of the largest excess, the upper and the lower end of its interval, and the probability that
    it is above 0, along limits and axes.

    `grid` and `status` are along axes and seeds; `by` has the accepted probability, the duration of the
    operation and the confidence.
    """
    limits, shape = excess.of_run.shape[1], grid.shape[:-1]
    found = np.empty((4, limits, *shape))
    for at in np.ndindex(*shape):
        ended = bool((status[at] != FINISHED).any())
        for limit in range(limits):
            place = (slice(None), limit, *at)
            found[place] = CERTAIN if ended else _of_one(excess, grid[at], limit, by)
    return found


def _of_one(
    excess: Maxima, runs: NDArray[np.intp], limit: int, by: tuple[float, float, float]
) -> tuple[float, float, float, float]:
    acceptance, operation_s, confidence = by
    largest, most = excess.largest(runs, limit, operation_s), float(excess.most[limit])
    if largest is None:
        return (np.nan,) * 4
    low, high = largest.interval(1 - acceptance, confidence)
    quantile = largest.quantile(1 - acceptance)
    probability = largest.exceedance(0.0) if most > 0 else 0.0
    return min(quantile, most), min(high, most), min(low, most), probability


def _passes(heights: Numbers, rising: Numbers) -> Numbers:
    """Height at which a rising excess passes 0, interpolated linearly; 0 if it is passed at the smallest."""
    found = np.where(rising[..., 0] > 0, 0.0, np.where(rising[..., -1] <= 0, heights[-1], np.nan))
    for k in range(len(heights) - 1):
        first, second = rising[..., k], rising[..., k + 1]
        with np.errstate(invalid="ignore", divide="ignore"):
            share = np.where(np.isneginf(first), 1.0, -first / (second - first))
        at = heights[k] + share * (heights[k + 1] - heights[k])
        found = np.where((first <= 0) & (second > 0), at, found)
    return np.where(np.isnan(rising).any(axis=-1), np.nan, found)


def _state(rising: Numbers) -> NDArray[np.str_]:
    state = np.where(rising[..., 0] > 0, BELOW, np.where(rising[..., -1] <= 0, ABOVE, FOUND))
    return np.where(np.isnan(rising).any(axis=-1), NOT_KNOWN, state)

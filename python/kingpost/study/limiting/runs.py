"""Limiting sea by time-domain runs: the significant height at which a limit is exceeded with the accepted
probability."""

from __future__ import annotations

from collections.abc import Hashable
from typing import TYPE_CHECKING

import numpy as np

from ...analysis.extremes import Extreme, extreme
from ...errors import KingpostError
from ...results.entries import axes_of, sea_attributes, sea_of
from ..reduce import FINISHED, NOT_RUN

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

    from ...scenario import ParameterValue

    Numbers = NDArray[np.float64]
    Values = dict[str, list[ParameterValue]]

FEWEST_SEEDS = 5
CERTAIN, NEVER = -3.4, 30.0
"""Reduced variates -ln(-ln(1 - P)) that represent P = 1 and P = 1e-13."""
FOUND, ABOVE, BELOW, NOT_KNOWN = "found", "above", "below", "not known"


def limiting_heights(
    results: xarray.Dataset,
    acceptance: float | None = None,
    operation_s: float | None = None,
    confidence: float = 0.9,
) -> xarray.Dataset:
    """Find the largest significant height at which each limit is exceeded with the accepted probability.

    At each height a Gumbel distribution is fitted over the seeds to the excess of a run's worst value over
    its bound, and extrapolated to the operation's duration: P is the probability that the excess is above 0
    (`extreme`). Between two heights the reduced variate -ln(-ln(1 - P)) is interpolated linearly over 1 / Hs.
    This is exact if the response is proportional to the height: the variate is then (L / Hs - mu) / beta. If
    sampling makes P fall with the height, the largest P of lower heights counts. Heights are not
    extrapolated.

    A run that ended early (a divergence, say) counts as one in which every limit without a value was
    exceeded: P of its case is 1.

    Parameters
    ----------
    results
        Results of a study whose axes are a grid: `limit_worst` and `status` along ``run``, the axes,
        ``at_least`` and ``at_most`` as coordinates, the attributes ``axes``, ``sea``, ``duration_s`` and
        ``after_s``; the coordinate ``limit_from_s`` of limits that begin later.
    acceptance
        Accepted probability; default: that of the study.
    operation_s
        Duration of the operation, s; default: that of the study.
    confidence
        Confidence of the intervals.

    Returns
    -------
    xarray.Dataset
        Along ``limit`` and the axes without the height: ``limiting_height`` (m); ``limiting_height_low`` and
        ``limiting_height_high``, its interval over seeds, from the intervals of P at each height; and
        ``limiting_height_state``: ``found``; ``above``: the accepted probability is not reached at the
        largest height of the study, which is then the limiting height; ``below``: it is exceeded at the
        smallest height, and the limiting height is then 0; ``not known``. ``limiting_height_of_all`` is the
        smallest over the limits, and ``governs`` names the limit. ``probability`` is P, along ``limit`` and
        all axes, ``ended_early`` counts runs.

    Raises
    ------
    KingpostError
        If runs are missing, there are fewer than five seeds, no limits or no axis of the height, or the axes
        are not a grid.
    """
    import xarray

    axes, height = _axes(results)
    acceptance = float(results.attrs["acceptance"] if acceptance is None else acceptance)
    if not 0 < acceptance < 1:
        raise KingpostError(f"acceptance: found {acceptance:g}, allowed: between 0 and 1")
    record_s = _records_s(results)
    operation_s = float(results.attrs["operation_s"] if operation_s is None else operation_s)
    grid, values = _grid(results, axes)
    beyond, status = _beyond(results)[grid], results["status"].values[grid]
    missing = int((status == NOT_RUN).sum())
    if missing:
        raise KingpostError(f"runs: found {missing} that have not run, allowed: all, as with --resume")
    reduced = _reduced(beyond, status, record_s, operation_s, confidence)
    # The height is the last axis, in increasing order.
    at = axes.index(height)
    order = np.argsort(values[height])
    heights = np.asarray(values[height], float)[order]
    reduced = np.moveaxis(reduced, at + 2, -1)[..., order]
    ended = np.take((status != FINISHED).sum(axis=-1), order, axis=at)
    falling = np.minimum.accumulate(reduced, axis=-1)
    found = _passes(heights, falling, -np.log(-np.log1p(-acceptance)))
    others = [name for name in axes if name != height]
    metre = {"units": "m", "long_name": "largest significant height that keeps the limit"}
    dims = ["limit", *others]
    smallest = found[0].min(axis=0)
    governs = np.asarray(results["limit"].values, str)[np.argmin(found[0], axis=0)]
    variables: dict[str, tuple[object, ...]] = {
        "limiting_height": (dims, found[0], metre),
        "limiting_height_low": (dims, found[1], metre),
        "limiting_height_high": (dims, found[2], metre),
        "limiting_height_state": (dims, _state(falling[0], -np.log(-np.log1p(-acceptance)))),
        "limiting_height_of_all": (others, smallest, metre),
        "governs": (others, governs),
        "probability": ([*dims, height], -np.expm1(-np.exp(-reduced[0])), {"units": "1"}),
        "ended_early": (axes, ended),
    }
    about = {name: results.attrs[name] for name in ("title", "fingerprint") if name in results.attrs}
    about |= sea_attributes(sea_of(results)) | {
        "acceptance": acceptance,
        "operation_s": operation_s,
        "confidence": confidence,
    }
    coordinates = _coordinates(results, others, values) | {height: (height, heights, results[height].attrs)}
    return xarray.Dataset(variables, coordinates, about)


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


def _grid(results: xarray.Dataset, axes: list[str]) -> tuple[NDArray[np.intp], Values]:
    """Indices of the runs along the axes and then the seeds, and the values of each axis."""
    values = {name: list(dict.fromkeys(results[name].values.tolist())) for name in axes}
    shape = [len(values[name]) for name in axes]
    seeds = list(dict.fromkeys(results["seed"].values.tolist()))
    if len(seeds) < FEWEST_SEEDS:
        raise KingpostError(f"seeds: found {len(seeds)}, allowed: {FEWEST_SEEDS} or more")
    size = int(np.prod(shape)) * len(seeds)
    if size != results.sizes["run"]:
        drawn = f"{results.sizes['run']} runs of which the axes' values make {size}"
        raise KingpostError(f"axes: found {drawn}, allowed: a grid, of axes with values or a range")
    places = [[values[name].index(value) for value in results[name].values.tolist()] for name in axes]
    places.append([seeds.index(seed) for seed in results["seed"].values.tolist()])
    found = np.empty((*shape, len(seeds)), np.intp)
    found[tuple(np.array(places))] = np.arange(results.sizes["run"])
    return found, values


def _beyond(results: xarray.Dataset) -> Numbers:
    """Excess of the worst value over its bound for each run and limit; negative inside the bounds."""
    worst = results["limit_worst"].transpose("run", "limit").values
    least, most = results["at_least"].values, results["at_most"].values
    return np.fmax(worst - most, least - worst)


def _records_s(results: xarray.Dataset) -> Numbers:
    """Time for which each limit is evaluated in a run, s."""
    duration_s, after_s = (float(results.attrs[name]) for name in ("duration_s", "after_s"))
    if "limit_from_s" not in results.coords:
        return np.full(results.sizes["limit"], duration_s - after_s)
    left_s: Numbers = duration_s - np.maximum(results["limit_from_s"].values, after_s)
    return np.where(left_s > 0, left_s, np.nan)


def _reduced(
    beyond: Numbers,
    status: NDArray[np.int8],
    record_s: Numbers,
    operation_s: float,
    confidence: float,
) -> Numbers:
    """Reduced variates of P and of the upper and lower end of its interval, along limits and axes.

    `beyond` is along axes, seeds and limits, `record_s` along limits.
    """
    shape = beyond.shape[:-2]
    found = np.empty((3, beyond.shape[-1], *shape))
    for at in np.ndindex(*shape):
        for limit in range(beyond.shape[-1]):
            values = beyond[(*at, slice(None), limit)]
            ended = status[at] != FINISHED
            if ended.any():
                found[(slice(None), limit, *at)] = CERTAIN
            elif not np.isfinite(values).all():
                found[(slice(None), limit, *at)] = np.nan
            elif np.ptp(values) <= 1e-12 * np.abs(values).max(initial=0.0):
                found[(slice(None), limit, *at)] = CERTAIN if values[0] > 0 else NEVER
            else:
                found[(slice(None), limit, *at)] = _of_one(
                    extreme(values, record_s[limit], operation_s), confidence
                )
    return np.clip(found, CERTAIN, NEVER)


def _of_one(found: Extreme, confidence: float) -> tuple[float, float, float]:
    low, high = found.exceedance_interval(0.0, confidence)
    with np.errstate(divide="ignore"):
        ends = [
            float(-np.log(-np.log1p(-p))) if 0 < p < 1 else (NEVER if p == 0 else CERTAIN)
            for p in (high, low)
        ]
    return -found.location / found.scale, ends[0], ends[1]


def _passes(heights: Numbers, reduced: Numbers, wanted: float) -> Numbers:
    """Height at which a falling variate passes the wanted value, interpolated linearly over 1 / height."""
    found = np.where(reduced[..., 0] < wanted, 0.0, np.where(reduced[..., -1] >= wanted, heights[-1], np.nan))
    for k in range(len(heights) - 1):
        first, second = reduced[..., k], reduced[..., k + 1]
        with np.errstate(invalid="ignore", divide="ignore"):
            share = (first - wanted) / (first - second)
            inverse = 1 / heights[k] + share * (1 / heights[k + 1] - 1 / heights[k])
        found = np.where((first >= wanted) & (second < wanted), 1 / inverse, found)
    return np.where(np.isnan(reduced).any(axis=-1), np.nan, found)


def _state(reduced: Numbers, wanted: float) -> NDArray[np.str_]:
    state = np.where(reduced[..., 0] < wanted, BELOW, np.where(reduced[..., -1] >= wanted, ABOVE, FOUND))
    return np.where(np.isnan(reduced).any(axis=-1), NOT_KNOWN, state)

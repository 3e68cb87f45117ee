"""Screening of a study: its limits in every case by linear response in the frequency domain. Cases that
differ only in their sea share one solution of the linear equations, over which their spectra are integrated.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ... import results
from ...analysis import spectral
from ...analysis.wave_response import matching
from ...errors import KingpostError
from ...scenario import Overrides, Scenario, as_scenario
from ...simulation.records import LimitBounds
from ...simulation.simulate import Simulation
from .limiting_height import limiting_height
from .seas import HEIGHT, Axis, moments, sea_of

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

    Numbers = NDArray[np.float64]

ACCEPTANCE = 0.1
"""Default of the accepted probability that a limit is exceeded in the operation."""
NOTHING = 1e-6
"""Variances below this share of the column's largest are left out of the interpolation error."""


def screen(
    scenario: Scenario | str | Path,
    axes: Mapping[str, Sequence[object]],
    columns: Sequence[str] = (),
    limits: Mapping[str, object] | None = None,
    operation_s: float = spectral.HALF_HOUR_S,
    acceptance: float = ACCEPTANCE,
    height: str | None = None,
    overrides: Overrides | None = None,
) -> xarray.Dataset:
    """Compute standard deviations and limits by linear response in every case of some axes, and the limiting
    sea.

    The largest significant height at which a limit is exceeded in the operation with a probability of at
    most `acceptance` is where ``1 - exp(-(T / Tz) exp(-(L - mean)^2 / (2 sigma^2)))`` (Rice, *Bell Syst.
    Tech. J.* 24, 1945) is that probability; the limit that governs has the smallest such height. The variance
    of a column may have a part proportional to the height squared and a constant part, such as a swell beside
    the wind sea. If the spectra of the cases have this form, the height is solved for, independent of the
    heights on the axis; otherwise it is interpolated between two of these, and NaN outside them.

    Parameters
    ----------
    scenario
        Scenario with waves, in its state at the start of a run.
    axes
        Values by the name of a parameter or the path of a field: the cases are all combinations. Several
        names, separated by commas, form one axis whose values are lists: values drawn together.
    columns
        Names or patterns (with ``*``) of columns, in addition to those of the limits.
    limits
        Limits that replace or extend those of the scenario, in the same form.
    operation_s
        Duration of the operation, s.
    acceptance
        Accepted probability that a limit is exceeded in the operation.
    height
        Axis of the significant height; default: the axis whose name or field is ``significant_height_m``.
    overrides
        Overrides of the scenario in all cases.

    Returns
    -------
    xarray.Dataset
        Along the axes: ``mean``, ``standard_deviation`` and ``zero_up_crossing_period`` (s) by ``column``,
        and the ``probability`` by ``limit``. Along the axes without that of the height: ``limiting_height``
        (m) by ``limit``, and over all limits ``limiting_height_of_all`` with the limit that ``governs``.
        ``reason`` is the reason why a column has no linear response; limits of such a column are not
        screened. ``interpolation_error`` is the largest of all cases.

    Raises
    ------
    KingpostError
        If no case has waves and an equilibrium, or an axis or a number is not allowed.

    >>> axes = {"significant_height_m": [1.0, 2.0], "peak_period_s": [8.0, 9.0]}
    >>> limits = {"pitch": {"column": "hull.pitch", "within": 1, "unit": "deg"}}
    >>> found = screen("offshore_vessel", axes, limits=limits, overrides={"waves": True})
    >>> found.standard_deviation.sizes
    Frozen({'significant_height_m': 2, 'peak_period_s': 2, 'column': 1})
    """
    _check(operation_s, acceptance, axes)
    base = as_scenario(scenario, dict(overrides or {}) | ({"limits": dict(limits)} if limits else {}), {})
    named = [Axis.of(base, name, values) for name, values in axes.items()]
    statistics = _statistics(base, named, columns)
    return _dataset(base, named, statistics, operation_s, acceptance, _height_axis(named, height))


def _check(operation_s: float, acceptance: float, axes: Mapping[str, Sequence[object]]) -> None:
    if not (operation_s > 0 and np.isfinite(operation_s)):
        raise KingpostError(f"operation_s: found {operation_s:g}, allowed: finite and greater than 0")
    if not 0 < acceptance < 1:
        raise KingpostError(f"acceptance: found {acceptance:g}, allowed: between 0 and 1")
    empty = [name for name, values in axes.items() if not len(values)]
    if empty:
        raise KingpostError(f"axes: found no values of {empty[0]}, allowed: one or more")


@dataclass(frozen=True)
class Statistics:
    """Mean and spectral moments in every case, along the axes and then the columns."""

    columns: list[str]
    units: list[str]
    not_linear: dict[str, str]
    bounds: list[LimitBounds]
    mean: Numbers
    m0: Numbers
    m2: Numbers
    interpolation_error: float
    warnings: list[str]


def _statistics(base: Scenario, axes: Sequence[Axis], columns: Sequence[str]) -> Statistics:
    shape = tuple(len(axis.values) for axis in axes)
    solved: list[tuple[list[tuple[int, ...]], spectral.Transfer, Numbers]] = []
    bounds: list[LimitBounds] = []
    warnings: dict[str, None] = {}
    failed: KingpostError | None = None
    for overrides, cases in _cases_by_model(axes):
        seas = [sea_of(base.resolved, axes, case) for case in cases]
        try:
            simulation = Simulation(base.with_overrides(overrides) if overrides else base)
            bounds = simulation.limit_bounds
            names = matching(simulation, [*columns, *(one.column for one in bounds)])
            found, of_seas, said = moments(simulation, names, seas)
        except KingpostError as error:
            failed = failed or error
            warnings[f"{_in_words(overrides)}: {error}"] = None
            continue
        solved.append((cases, found, of_seas))
        warnings |= dict.fromkeys(said)
    if not solved:
        raise failed or KingpostError("axes: found no case, allowed: one or more values of each")
    first = solved[0][1]
    parts = np.full((4, *shape, len(first.columns)), np.nan)
    not_linear: dict[str, str] = {}
    for cases, found, of_seas in solved:
        at = (slice(None), *np.array(cases, int).reshape(len(cases), len(axes)).T)
        parts[at] = np.concatenate([np.broadcast_to(found.mean, of_seas[:1].shape), of_seas])
        not_linear |= found.not_linear
    mean, m0, m2, halved = parts
    with np.errstate(invalid="ignore", divide="ignore"):
        off = np.abs(np.sqrt(halved / m0) - 1)
        # For motions that are zero by symmetry there is only rounding error.
        counts = m0 > NOTHING * np.nanmax(m0, axis=tuple(range(len(axes))), initial=0.0)
    worst = float(np.max(off, initial=0.0, where=np.isfinite(off) & counts))
    return Statistics(first.columns, first.units, not_linear, bounds, mean, m0, m2, worst, list(warnings))


def _cases_by_model(axes: Sequence[Axis]) -> Iterator[tuple[dict[str, object], list[tuple[int, ...]]]]:
    """Yield the overrides of each model, with its cases as indices of the values along each axis."""
    of_model = [axis for axis in axes if not axis.is_of_the_sea]
    for chosen in product(*(range(len(axis.values)) for axis in of_model)):
        fixed = dict(zip((axis.name for axis in of_model), chosen, strict=True))
        overrides = {k: v for axis in of_model for k, v in axis.overrides[fixed[axis.name]].items()}
        numbers = [[fixed[axis.name]] if axis.name in fixed else range(len(axis.values)) for axis in axes]
        yield overrides, list(product(*numbers))


def _in_words(overrides: Mapping[str, object]) -> str:
    return ", ".join(f"{name} {value}" for name, value in overrides.items()) or "the scenario"


def _height_axis(axes: Sequence[Axis], given: str | None) -> int | None:
    if given is not None:
        for k, axis in enumerate(axes):
            if axis.name == given:
                return k
        raise KingpostError(f"height: found {given!r}, allowed: {', '.join(axis.name for axis in axes)}")
    found = [k for k, axis in enumerate(axes) if axis.name == HEIGHT or axis.is_of_the_height]
    return found[0] if len(found) == 1 else None


def _dataset(
    base: Scenario,
    axes: Sequence[Axis],
    found: Statistics,
    operation_s: float,
    acceptance: float,
    height: int | None,
) -> xarray.Dataset:
    import xarray

    dims = [axis.name for axis in axes]
    sigma, period = spectral.deviation_and_period(found.m0, found.m2)
    at = [found.columns.index(one.column) for one in found.bounds]
    probability = [
        spectral.exceedance(
            (one.at_least, one.at_most),
            found.mean[..., k],
            sigma[..., k],
            period[..., k],
            operation_s,
            one.percentile,
        )
        for one, k in zip(found.bounds, at, strict=True)
    ]
    variables: dict[str, tuple[object, ...]] = {
        "mean": ([*dims, "column"], found.mean),
        "standard_deviation": ([*dims, "column"], sigma),
        "zero_up_crossing_period": ([*dims, "column"], period, {"units": "s"}),
        "reason": ("column", np.array([found.not_linear.get(name, "") for name in found.columns], str)),
        "limit_column": ("limit", np.array([one.column for one in found.bounds], str)),
    }
    if found.bounds:
        variables["probability"] = ([*dims, "limit"], np.stack(probability, axis=-1), {"units": "1"})
    if height is not None and found.bounds:
        heights = np.asarray(axes[height].values, float)
        over = [dim for k, dim in enumerate(dims) if k != height]
        first = [np.moveaxis(of, height, 0) for of in (found.mean, found.m0, found.m2)]
        each = [
            limiting_height(
                heights,
                (one.at_least, one.at_most),
                first[0][..., k],
                first[1][..., k],
                first[2][..., k],
                operation_s,
                acceptance,
                one.percentile,
            )
            for one, k in zip(found.bounds, at, strict=True)
        ]
        limiting = np.stack(each, axis=-1)
        names = np.array([one.name for one in found.bounds], str)
        known = np.where(np.isnan(limiting), np.inf, limiting)
        smallest = np.where(np.isnan(limiting).all(axis=-1), np.nan, known.min(axis=-1))
        governs = np.where(np.isfinite(smallest), names[known.argmin(axis=-1)], "")
        metre = {"units": "m", "long_name": "largest significant height that keeps the limit"}
        variables["limiting_height"] = ([*over, "limit"], limiting, metre)
        variables["limiting_height_of_all"] = (over, smallest, metre)
        variables["governs"] = (over, governs)
    unit = ("column", np.array(found.units, str))
    coordinates: dict[str, object] = {axis.name: (axis.name, _labels(axis)) for axis in axes} | {
        "column": np.array(found.columns, str),
        "limit": np.array([one.name for one in found.bounds], str),
        results.unit_coordinate("mean"): unit,
        results.unit_coordinate("standard_deviation"): unit,
    }
    attributes = results.attributes(base, "screened by linear response") | {
        "operation_s": operation_s,
        "acceptance": acceptance,
        "interpolation_error": found.interpolation_error,
    }
    if found.warnings:
        attributes["warning"] = "; ".join(found.warnings)
    return xarray.Dataset(variables, coordinates, attributes)


def _labels(axis: Axis) -> NDArray[np.generic]:
    """Values of an axis as a coordinate; for axes drawn together, the number of the draw."""
    return np.arange(len(axis.values)) if "," in axis.name else np.asarray(axis.values)

"""Response spectra of columns in a random sea, by their linear response to waves.

The sea and the linear responses to it are stationary and Gaussian. For a column with the amplitude H per
metre of wave amplitude the spectral moments are ``m_n = Int Int w^n S(w) D(b) |H(w, b)|^2 db dw`` (Faltinsen,
*Sea Loads on Ships and Offshore Structures*, 1990, sec. 2.3). They give the standard deviation
``sqrt(m0)``, the zero up-crossing period ``Tz = 2 pi sqrt(m0 / m2)``, and by Rice's rate of up-crossings the
extremes in a given duration.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import results
from ..errors import KingpostError
from ..scenario import Overrides, Scenario
from ..simulation.python_warnings import record_warnings
from ..simulation.records import WaveSystem
from ..simulation.simulate import Simulation
from .random_sea import (
    BESIDE,
    SPREAD,
    directions_of,
    grid_between,
    lines_of,
    nodes_of,
    random_sea,
    trapezoidal,
)
from .response import frequencies_that_all_cover
from .statistics import EULER
from .wave_response import REASONS, as_simulation, matching

if TYPE_CHECKING:
    import xarray
    from numpy.typing import ArrayLike, NDArray

    Numbers = NDArray[np.float64]

HALF_HOUR_S = 1800.0
MOST_LINES = 400
"""Largest number of waves of a single frequency at which the response is solved exactly."""
HARDLY_DAMPED = 1e-3
"""Damping ratio below which a run needs hundreds of periods to reach the resonance peak."""
LEFT_OUT = 0.01
"""Share of a sea's energy outside the databases' frequencies above which a warning is given."""


@dataclass(frozen=True)
class Transfer:
    """Squared frequency responses of columns on a grid for integration.

    Attributes
    ----------
    columns, units
        Of the results.
    mean
        Value of each column at rest in still water.
    not_linear
        Reason, by column, for each column without a linear response.
    directions_rad
        Directions that the waves travel towards.
    omega_rad_s
        The grid, rad/s.
    squares
        |H|^2, shape (directions, frequencies, columns); NaN for a column without response.
    halved
        |H|^2 interpolated from every second frequency of the response.
    linearised
        Lines with mass whose drag is linearised for a random sea.
    warnings
        Warnings.
    """

    columns: list[str]
    units: list[str]
    mean: Numbers
    not_linear: dict[str, str]
    directions_rad: Numbers
    omega_rad_s: Numbers
    squares: Numbers
    halved: Numbers
    linearised: list[str]
    warnings: list[str]

    @property
    def weights(self) -> Numbers:
        """Weights of the trapezoidal rule over the frequencies, rad/s."""
        return trapezoidal(self.omega_rad_s)


def spectral_response(
    scenario_or_simulation: Scenario | Simulation | str | Path,
    columns: Sequence[str] | None = None,
    duration_s: float = HALF_HOUR_S,
    overrides: Overrides | None = None,
    **parameters: Any,
) -> xarray.Dataset:
    """Compute standard deviations, periods and extremes of columns in the scenario's sea without a run.

    The wave spectra are those from which runs draw their waves (`Simulation.sea_spectra`); the response is
    that of `kingpost.wave_response`. The largest value in `duration_s` is expected at ``mean + sigma (c +
    0.577 / c)``, ``c = sqrt(2 ln(T / Tz))`` (Davenport, *Proc. ICE* 28(2), 1964), and a limit L is exceeded
    in this duration with the probability ``1 - exp(-(T / Tz) exp(-(L - mean)^2 / (2 sigma^2)))`` (Rice, *Bell
    Syst. Tech. J.* 24, 1945).

    Lines with mass move by their own inertia and drag, in the waves at their nodes. The drag, quadratic in
    the velocity of the water relative to the line, is replaced by its mean and the mean of its slope over
    the Gaussian velocities of the response itself, found by iteration (Borgman, *J. Waterways Harbors Div.
    ASCE* 93(WW2), 1967; Atalik & Utku, *Earthquake Eng. Struct. Dyn.* 4, 1976); a current enters as the mean
    velocity. Lines without drag are at rest between their ends, like in `kingpost.wave_response`.

    Parameters
    ----------
    scenario_or_simulation
        Scenario or simulation with waves. The crane is at the start of a run, or in the state of the
        simulation.
    columns
        Names or patterns (with ``*``) of columns, in addition to those of the scenario's limits; default:
        all.
    duration_s
        Duration for the extremes, s.
    overrides, parameters
        Values that override those of a scenario.

    Returns
    -------
    xarray.Dataset
        By ``column``: ``mean``, ``standard_deviation``, ``significant_amplitude``,
        ``zero_up_crossing_period`` (s), ``expected_maximum``, ``expected_minimum``, ``linear`` and
        ``reason``, and ``interpolation_error``, the relative change of the standard deviation if every second
        frequency of the response is left out. By ``limit``: ``limit_column`` and the ``probability`` that the
        limit is exceeded in `duration_s`. Attribute ``drag``: the kind of linearisation, and the lines whose
        drag is part of the response.

    Raises
    ------
    KingpostError
        If no wave system is enabled, there is no equilibrium, a column is unknown, the duration is not
        greater than 0, or the drag in this sea is not found.

    >>> found = spectral_response("offshore_vessel", ["hull.pitch"], waves=True)
    >>> round(float(np.rad2deg(found.standard_deviation[0])), 2)
    1.13
    """
    import xarray

    if not (duration_s > 0 and np.isfinite(duration_s)):
        raise KingpostError(f"duration_s: found {duration_s:g}, allowed: finite and greater than 0")
    simulation = as_simulation(scenario_or_simulation, overrides, parameters)
    bounds = simulation.limit_bounds
    chosen = None if columns is None else matching(simulation, [*columns, *(one.column for one in bounds)])
    (systems,) = simulation.sea_spectra([], SPREAD)
    if not systems:
        raise KingpostError(
            "sea.waves: found no enabled wave system, allowed: a wave system with enabled: true"
        )
    sea = random_sea(simulation, systems)
    found = transfer(simulation, chosen, directions_of(systems), nodes_of(systems), lines_of(systems), sea)
    (systems,) = simulation.sea_spectra(found.omega_rad_s, SPREAD)
    m0, m2, halved = moments_in(found, systems)
    sigma, period = deviation_and_period(m0, m2)
    largest = expected_largest(sigma, period, duration_s)
    with np.errstate(invalid="ignore", divide="ignore"):
        error = np.where(m0 > 0, np.abs(np.sqrt(halved / m0) - 1), 0.0)
    at = {name: k for k, name in enumerate(found.columns)}
    probability = [
        exceedance(
            (one.at_least, one.at_most), found.mean[k], sigma[k], period[k], duration_s, one.percentile
        )
        for one in bounds
        for k in [at[one.column]]
    ]
    least = found.mean - largest
    slack = [k for k, name in enumerate(found.columns) if name.endswith(ONE_SIDED) and least[k] < 0]
    units = ("column", np.array(found.units, str))
    own = {results.unit_coordinate(name): units for name in OF_UNIT}
    variables = {
        "mean": ("column", found.mean),
        "standard_deviation": ("column", sigma),
        "significant_amplitude": ("column", 2 * sigma),
        "zero_up_crossing_period": ("column", period, {"units": "s"}),
        "expected_maximum": ("column", found.mean + largest),
        "expected_minimum": ("column", np.where(np.isin(np.arange(len(least)), slack), 0.0, least)),
        "interpolation_error": ("column", error, {"units": "1"}),
        "linear": ("column", [name not in found.not_linear for name in found.columns]),
        "reason": ("column", np.array([found.not_linear.get(name, "") for name in found.columns], str)),
        "limit_column": ("limit", np.array([one.column for one in bounds], str)),
        "probability": ("limit", np.array(probability, float), {"units": "1"}),
    }
    coordinates = {
        "column": np.array(found.columns, str),
        "limit": np.array([one.name for one in bounds], str),
        **own,
    }
    attributes = results.attributes(simulation.scenario, "about rest, by the spectrum of the sea")
    attributes["duration_s"] = duration_s
    attributes["drag"] = f"{STOCHASTIC}: {', '.join(found.linearised)}" if found.linearised else NO_DRAG
    about_model = simulation.scenario.model["warnings"]
    of_slack = [f"{found.columns[k]}: {SLACK}; without it, {least[k]:.3g} {found.units[k]}" for k in slack]
    record_warnings(
        attributes,
        [
            *about_model,
            *found.warnings,
            *beyond_the_data(found, systems),
            *of_slack,
            *of_one_frequency(found, systems),
        ],
    )
    return xarray.Dataset(variables, coordinates, attributes)


STOCHASTIC = "stochastic linearisation, for Gaussian velocities, of the drag on lines"
NO_DRAG = "no quadratic drag: it is zero at rest"
REGULAR = (
    "the drag on lines is linearised for a Gaussian motion; for the motion in a regular wave it is a third "
    "too large"
)
ONE_SIDED = ("tension", "normal_force")
"""Suffixes of the names of columns that are never negative."""
SLACK = "its least value is 0: it goes slack or lifts off in this sea, which a linear response leaves out"
OF_UNIT = ("mean", "standard_deviation", "significant_amplitude", "expected_maximum", "expected_minimum")


def transfer(
    simulation: Simulation,
    columns: Sequence[str] | None,
    directions_rad: ArrayLike,
    nodes_rad_s: ArrayLike,
    lines_rad_s: ArrayLike = (),
    sea: dict[str, Any] | None = None,
) -> Transfer:
    """Compute the squared response of columns on a grid over the frequencies that all databases cover.

    Cubic splines interpolate real and imaginary parts between the engine's frequencies, which are closer than
    the peak's width about each resonance.

    Parameters
    ----------
    simulation
        The simulation in its present state.
    columns
        Names of the columns; default: all.
    directions_rad
        Directions that the waves travel towards, rad.
    nodes_rad_s
        Further frequencies of the grid, rad/s.
    lines_rad_s
        Frequencies of single waves, rad/s: at these the response is exact, if there are at most `MOST_LINES`.
    sea
        Random sea for which the drag on lines is linearised, as for `Simulation.column_response`.

    Returns
    -------
    Transfer
        The response on the grid.

    >>> found = transfer(Simulation("barge"), ["ship.roll"], [0.5], [1.0])
    >>> found.squares.shape == (1, len(found.omega_rad_s), 1)
    True
    """
    covered = frequencies_that_all_cover(simulation.scenario)
    lines = np.asarray(lines_rad_s, float)
    if len(covered) and len(lines) <= MOST_LINES:
        within = lines[(lines > covered[0]) & (lines < covered[-1])]
        covered = np.unique(np.concatenate([covered, within]))
    found = simulation.column_response(directions_rad, covered, columns or (), about_resonances=True, sea=sea)
    omega = np.array(found["frequencies_rad_s"])
    grid = grid_between(omega, np.concatenate([np.asarray(nodes_rad_s, float), lines]))
    not_linear = {
        name: REASONS[reason]
        for name, reason in zip(found["columns"], found["not_linear"], strict=True)
        if reason
    }
    every_second = np.unique(np.append(np.arange(0, len(omega), 2), len(omega) - 1))
    return Transfer(
        columns=found["columns"],
        units=found["units"],
        mean=np.array(found["mean"], float),
        not_linear=not_linear,
        directions_rad=np.array(found["directions_rad"]),
        omega_rad_s=grid,
        squares=_squares(omega, found["amplitudes"], grid),
        halved=_squares(omega[every_second], found["amplitudes"][:, every_second], grid),
        linearised=found["linearised"],
        warnings=[*found["warnings"], *_peaks(found["resonances"], omega)],
    )


def _squares(omega: Numbers, amplitudes: NDArray[np.complex128], grid: Numbers) -> Numbers:
    from scipy.interpolate import CubicSpline

    none = np.isnan(amplitudes[0, 0])
    known = np.where(none, 0.0, amplitudes)
    h = CubicSpline(omega, known, axis=1)(grid)
    squares = h.real**2 + h.imag**2
    squares[..., none] = np.nan
    return squares


def _peaks(resonances: list[dict[str, float]], omega: Numbers) -> list[str]:
    """Warn about motions with little or no damping in the range of frequencies."""
    return [
        f"a motion of {one['frequency_rad_s']:.4g} rad/s has a damping ratio of {ratio:.1e}: a run sees "
        "its peak only after hundreds of periods"
        for one in resonances
        if omega[0] <= one["frequency_rad_s"] <= omega[-1]
        if (ratio := one["decay_per_s"] / one["frequency_rad_s"]) < HARDLY_DAMPED
    ]


def moments_in(found: Transfer, systems: Sequence[WaveSystem]) -> tuple[Numbers, Numbers, Numbers]:
    """m0 and m2 of each column in a sea with a density on the grid, and m0 by `Transfer.halved`."""
    parts = np.zeros((3, len(found.columns)))
    for one in systems:
        at = np.searchsorted(found.directions_rad, np.asarray(one["directions_rad"]) - BESIDE)
        if len(at):
            density = np.asarray(one["density_m2_s"]) * found.weights
            parts += moments_of(found, density)[:, at].mean(axis=1)
        for omega, direction, variance in one["lines"]:
            toward = np.searchsorted(found.directions_rad, direction - BESIDE)
            k = np.argmin(np.abs(found.omega_rad_s - omega))
            if np.isclose(found.omega_rad_s[k], omega):
                square, half = found.squares[toward, k], found.halved[toward, k]
                parts += variance * np.stack([square, omega**2 * square, half])
    m0, m2, halved = parts
    return m0, m2, halved


def moments_of(found: Transfer, weighted: Numbers) -> Numbers:
    """m0, m2 and m0 by `Transfer.halved`, by direction and column, of densities times the weights.

    Further dimensions of the densities, before that of the frequency, follow the first dimension of the
    result.
    """
    m0 = np.einsum("...k,dkc->...dc", weighted, found.squares)
    m2 = np.einsum("...k,dkc->...dc", weighted * found.omega_rad_s**2, found.squares)
    halved = np.einsum("...k,dkc->...dc", weighted, found.halved)
    return np.stack([m0, m2, halved])


def deviation_and_period(m0: Numbers, m2: Numbers) -> tuple[Numbers, Numbers]:
    """Standard deviation and zero up-crossing period, s; the period of a constant column is NaN."""
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.sqrt(m0), 2 * np.pi * np.sqrt(m0 / m2)


def expected_largest(sigma: ArrayLike, period_s: ArrayLike, duration_s: float) -> Numbers:
    """Expected excess of the largest value in a duration over the mean (Davenport 1964).

    >>> round(float(expected_largest(1.0, 8.0, 10800.0)), 2)
    3.95
    """
    sigma, period = np.asarray(sigma, float), np.asarray(period_s, float)
    with np.errstate(invalid="ignore", divide="ignore"):
        c = np.sqrt(2 * np.log(np.maximum(duration_s / period, math.e)))
    return np.where(sigma == 0, 0.0, sigma * (c + EULER / c))


def exceedance(
    bounds: tuple[float | None, float | None],
    mean: ArrayLike,
    sigma: ArrayLike,
    period_s: ArrayLike,
    duration_s: float,
    percentile: float = 100.0,
) -> Numbers:
    """Probability that a Gaussian process leaves its bounds in a duration, by Rice's rate of crossings.

    For a percentile below 100, the share of the time outside the bounds is compared with the allowed one: the
    probability is 0 or 1.

    Parameters
    ----------
    bounds
        Smallest and largest allowed value; None for no bound.
    mean, sigma
        Mean and standard deviation of the process.
    period_s
        Zero up-crossing period of the process, s.
    duration_s
        The time, s.
    percentile
        Percentage of the time in which the process must be within its bounds.

    Returns
    -------
    numpy.ndarray
        The probability; 1 if the mean is outside a bound.

    >>> round(float(exceedance((None, 4.0), 0.0, 1.0, 8.0, 10800.0)), 3)
    0.364
    >>> [float(exceedance((None, most), 0.0, 1.0, 8.0, 10800.0, 95.0)) for most in (1.64, 1.65)]
    [1.0, 0.0]
    """
    if percentile < 100:
        return np.where(share_outside(bounds, mean, sigma) > 1 - percentile / 100, 1.0, 0.0)
    mean, sigma, period = (np.asarray(x, float) for x in (mean, sigma, period_s))
    crossings = np.zeros(np.broadcast_shapes(mean.shape, sigma.shape, period.shape))
    beyond = np.zeros(crossings.shape, bool)
    for bound, side in zip(bounds, (-1.0, 1.0), strict=True):
        if bound is not None:
            margin = side * (bound - mean)
            beyond = beyond | (margin < 0)
            with np.errstate(invalid="ignore", divide="ignore"):
                rate = duration_s / period * np.exp(-0.5 * (margin / sigma) ** 2)
            crossings = crossings + np.where(sigma == 0, 0.0, rate)
    return np.where(beyond, 1.0, -np.expm1(-crossings))


def share_outside(bounds: tuple[float | None, float | None], mean: ArrayLike, sigma: ArrayLike) -> Numbers:
    """Share of the time for which a Gaussian process is outside its bounds.

    >>> round(float(share_outside((-1.0, 1.0), 0.0, 1.0)), 4)
    0.3173
    """
    from scipy import stats

    mean, sigma = np.asarray(mean, float), np.asarray(sigma, float)
    outside = np.zeros(np.broadcast_shapes(mean.shape, sigma.shape))
    for bound, side in zip(bounds, (-1.0, 1.0), strict=True):
        if bound is not None:
            margin = side * (bound - mean)
            # At rest the mean is inside or outside for all the time.
            share = stats.norm.sf(margin / np.where(sigma > 0, sigma, 1.0))
            outside = outside + np.where(sigma > 0, share, margin < 0)
    return np.where(np.isnan(sigma), np.nan, outside)


def of_one_frequency(found: Transfer, systems: Sequence[WaveSystem]) -> list[str]:
    """Warn about drag that is linearised for a Gaussian sea, if a regular wave has most of the energy."""
    largest = max((line[2] for one in systems for line in one["lines"]), default=0.0)
    whole = sum(one["variance_m2"] for one in systems)
    return [REGULAR] if found.linearised and largest > 0.5 * whole else []


def beyond_the_data(found: Transfer, systems: Sequence[WaveSystem]) -> list[str]:
    """Warn about wave systems with energy at frequencies outside the databases, at which no wave forces
    act."""
    said = []
    for one in systems:
        within = float(np.asarray(one["density_m2_s"]) @ found.weights)
        whole = float(one["variance_m2"])
        if whole > 0 and 1 - within / whole > LEFT_OUT:
            said.append(
                f"sea.waves.{one['name']}: {1 - within / whole:.1%} of its energy is beyond the frequencies "
                "that the databases cover, and moves nothing"
            )
    return said

"""Variances of the waves of a sea by direction and frequency, on the grid of the integration."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ..simulation.records import WaveSystem
from ..simulation.simulate import Simulation
from .response import frequencies_that_all_cover

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Numbers = NDArray[np.float64]

SPREAD = 24
"""Number of directions of equal energy that represent a short-crested sea."""
PARTS = 8
"""Number of integration steps between two frequencies of the response."""
BESIDE = 1e-9
"""Distance of the grid points on either side of a band's end, as a share of its frequency."""


def trapezoidal(grid: Numbers) -> Numbers:
    """Weights of the trapezoidal rule on a grid.

    >>> trapezoidal(np.array([0.0, 1.0, 3.0]))
    array([0.5, 1.5, 1. ])
    """
    steps = np.diff(grid)
    return 0.5 * (np.append(steps, 0.0) + np.append(0.0, steps))


def grid_between(omega: Numbers, nodes: Numbers) -> Numbers:
    """`PARTS` steps between two frequencies, and the nodes between the first and the last one."""
    cut = omega[:-1, None] + np.arange(PARTS) / PARTS * np.diff(omega)[:, None]
    between = nodes[(nodes > omega[0]) & (nodes < omega[-1])]
    return np.unique(np.concatenate([cut.ravel(), omega[-1:], between]))


def random_sea(simulation: Simulation, systems: Sequence[WaveSystem]) -> dict[str, Any] | None:
    """Variances of a sea by direction and frequency, for `Simulation.column_response`; None if no database
    covers a frequency.

    Parameters
    ----------
    simulation
        The simulation, for the frequencies that its databases cover and the densities.
    systems
        Wave systems of its sea, with `SPREAD` directions.

    Returns
    -------
    dict or None
        ``waves`` and ``variances_m2``.

    >>> simulation = Simulation("offshore_vessel_moored")
    >>> sea = random_sea(simulation, simulation.sea_spectra([], SPREAD)[0])
    >>> round(4 * float(np.sqrt(np.sum(sea["variances_m2"]))), 1)
    2.5
    """
    covered = frequencies_that_all_cover(simulation.scenario)
    if not len(covered):
        return None
    grid = grid_between(covered, np.concatenate([nodes_of(systems), lines_of(systems)]))
    directions = directions_of(systems)
    variances = np.zeros((len(directions), len(grid)))
    (dense,) = simulation.sea_spectra(grid, SPREAD)
    for one in dense:
        at = np.searchsorted(directions, np.asarray(one["directions_rad"]) - BESIDE)
        if len(at):
            variances[at] += np.asarray(one["density_m2_s"]) * trapezoidal(grid) / len(at)
        for omega, direction, variance in one["lines"]:
            k = np.argmin(np.abs(grid - omega))
            if np.isclose(grid[k], omega):
                variances[np.searchsorted(directions, direction - BESIDE), k] += variance
    waves = {"directions_rad": directions.tolist(), "frequencies_rad_s": grid.tolist()}
    return {"waves": waves, "variances_m2": variances.tolist()}


def directions_of(systems: Sequence[WaveSystem]) -> Numbers:
    """Directions of a sea's wave systems without repetitions, rad."""
    every = [one["directions_rad"] + [line[1] for line in one["lines"]] for one in systems]
    return np.unique(np.concatenate([np.asarray(one, float) for one in every]))


def nodes_of(systems: Sequence[WaveSystem]) -> Numbers:
    """Frequencies at which a system's spectral density has a kink, and frequencies next to the ends of bands,
    rad/s."""
    ends = [
        end * (1 + side) for one in systems for end in one["band_rad_s"] or () for side in (-BESIDE, BESIDE)
    ]
    return np.unique([*ends, *(node for one in systems for node in one["nodes_rad_s"])])


def lines_of(systems: Sequence[WaveSystem]) -> Numbers:
    """Frequencies of the regular waves without repetitions, rad/s."""
    return np.unique([line[0] for one in systems for line in one["lines"]])

"""Cases: the points of a study's axes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np

from ...scenario import ParameterValue
from .content import Axis, Interval, Samples

SAMPLE, CELL = "sample", "cell"


@dataclass(frozen=True)
class Cases:
    """Every combination of the axes' values, the last axis fastest.

    Attributes
    ----------
    names
        Names of the axes, in their order.
    values
        Values of each axis, one value for each case.
    drawn
        For axes that are drawn together, the number of the draw of each case: ``sample`` of a Latin
        hypercube, ``cell`` of a scatter table.
    """

    names: tuple[str, ...]
    values: dict[str, list[ParameterValue]]
    drawn: dict[str, list[int]]
    count: int
    sizes: tuple[int, ...] = ()
    """Number of points of each axis; axes that are drawn together count as one."""

    def corners(self) -> Iterator[int]:
        """Cases at the first and last points of all axes."""
        for ends in product(*(sorted({0, size - 1}) for size in self.sizes)):
            case = 0
            for end, size in zip(ends, self.sizes, strict=True):
                case = case * size + end
            yield case

    def overrides(self, case: int) -> list[tuple[str, ParameterValue]]:
        """Return the overrides of the scenario in a case."""
        return [(name, self.values[name][case]) for name in self.names]


def values_of(axis: Axis) -> list[ParameterValue]:
    """Return the values of an axis that is not drawn together with others.

    >>> values_of({"range": {"from": 6.0, "to": 8.0, "count": 3}})
    [6.0, 7.0, 8.0]
    >>> values_of({"values": [1.0, 2.5]})
    [1.0, 2.5]
    """
    if "values" in axis:
        return list(axis["values"])
    numbers = axis["range"]
    return np.linspace(numbers["from"], numbers["to"], numbers["count"]).tolist()


def latin_hypercube(axes: Mapping[str, Interval], count: int, seed: int) -> list[tuple[float, ...]]:
    """Draw samples of several axes: each axis is divided into as many strips as there are samples, and each
    strip contains one (McKay, Beckman & Conover, *Technometrics* 21(2), 1979), by
    `scipy.stats.qmc.LatinHypercube`.

    >>> found = latin_hypercube({"x": {"from": 0.0, "to": 4.0}, "y": {"from": 1.0, "to": 2.0}}, 4, seed=1)
    >>> sorted(int(x) for x, _ in found)
    [0, 1, 2, 3]
    """
    from scipy.stats import qmc

    lower = [axis["from"] for axis in axes.values()]
    upper = [axis["to"] for axis in axes.values()]
    sampler = qmc.LatinHypercube(len(axes), seed=np.random.default_rng(seed))
    return [tuple(row) for row in qmc.scale(sampler.random(count), lower, upper).tolist()]


def cases(
    axes: Mapping[str, Axis],
    samples: Samples | None = None,
    cells: Callable[[], Sequence[tuple[float, float]]] | None = None,
) -> Cases:
    """Build the cases of a study.

    Parameters
    ----------
    axes
        Axes by name, in the form of the study file.
    samples
        ``count`` and ``seed`` of the Latin hypercube.
    cells
        Function that returns significant height and peak period of each sea with occurrences in a scatter
        table.

    >>> found = cases({"x": {"values": [1, 2]}, "y": {"values": ["a", "b"]}})
    >>> [found.overrides(case) for case in range(found.count)][:2]
    [[('x', 1), ('y', 'a')], [('x', 1), ('y', 'b')]]
    """
    factors: list[tuple[tuple[str, ...], Sequence[tuple[ParameterValue, ...]], str]] = []
    hypercube = {name: axis["latin_hypercube"] for name, axis in axes.items() if "latin_hypercube" in axis}
    scattered = {name: axis["scatter"] for name, axis in axes.items() if "scatter" in axis}
    for name, axis in axes.items():
        if name in hypercube:
            if name == next(iter(hypercube)):
                assert samples is not None
                drawn = latin_hypercube(hypercube, samples["count"], samples["seed"])
                factors.append((tuple(hypercube), drawn, SAMPLE))
        elif name in scattered:
            if name == next(iter(scattered)):
                assert cells is not None
                factors.append((tuple(scattered), _of_scatter(scattered, cells()), CELL))
        else:
            factors.append(((name,), [(value,) for value in values_of(axis)], ""))
    values: dict[str, list[ParameterValue]] = {name: [] for name in axes}
    indices = list(product(*(range(len(points)) for _, points, _ in factors)))
    draws: dict[str, list[int]] = {}
    for k, (names, points, drawn_as) in enumerate(factors):
        at = [index[k] for index in indices]
        for j, name in enumerate(names):
            values[name] = [points[i][j] for i in at]
        if drawn_as:
            draws[drawn_as] = at
    sizes = tuple(len(points) for _, points, _ in factors)
    return Cases(tuple(axes), values, draws, len(indices), sizes)


def _of_scatter(
    scattered: Mapping[str, str], cells: Sequence[tuple[float, float]]
) -> list[tuple[float, ...]]:
    places = [("significant_height", "peak_period").index(what) for what in scattered.values()]
    return [tuple(cell[place] for place in places) for cell in cells]

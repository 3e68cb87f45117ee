"""Moments of cases that differ only in their sea, as sums over one common response."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from ...analysis import random_sea, spectral
from ...errors import KingpostError
from ...scenario import Scenario
from ...simulation.records import WaveSystem
from ...simulation.simulate import Simulation

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Numbers = NDArray[np.float64]

HEIGHT = "significant_height_m"
NOT_DRAWN = ("parameters",)
"""Fields of a resolved scenario that describe its origin, not its model."""


@dataclass(frozen=True)
class Sea:
    """Sea common to several cases: its wave systems turned to direction 0, and the direction of each
    system."""

    key: str
    directions_rad: tuple[float, ...]


@dataclass(frozen=True)
class Axis:
    """An axis of a study, with the changes of the resolved scenario by each of its values.

    Attributes
    ----------
    name
        Name of the axis.
    values
        Values along the axis.
    overrides
        Overrides for each value.
    changes
        Changes for each value: the new value by the path of a field.
    """

    name: str
    values: list[object]
    overrides: list[dict[str, object]]
    changes: list[dict[tuple[str, ...], object]]

    @classmethod
    def of(cls, base: Scenario, name: str, values: Sequence[object]) -> Axis:
        """Make an axis of a scenario."""
        names = [part.strip() for part in name.split(",")]
        are_drawn = len(names) > 1
        each = (value if are_drawn and isinstance(value, Iterable) else [value] for value in values)
        overrides = [dict(zip(names, one, strict=True)) for one in each]
        flat = _flat(base.resolved)
        resolved = [_flat(base.with_overrides(one).resolved) for one in overrides]
        # If one value of the axis changes a field, all values have it among their changes, also those equal
        # to the base.
        touched = {path for one in resolved for path in one | flat if one.get(path) != flat.get(path)}
        changes = [{path: one.get(path) for path in sorted(touched)} for one in resolved]
        return cls(name, list(values), overrides, changes)

    @property
    def is_of_the_sea(self) -> bool:
        """Whether the axis changes only waves."""
        return all(path[:2] == ("sea", "waves") for change in self.changes for path in change)

    @property
    def is_of_the_height(self) -> bool:
        """Whether the axis changes only the significant height of waves."""
        paths = [path for change in self.changes for path in change]
        return self.is_of_the_sea and bool(paths) and all(path[-1] == HEIGHT for path in paths)


def _flat(tree: object, path: tuple[str, ...] = ()) -> dict[tuple[str, ...], object]:
    """The leaves of a resolved scenario by their paths; lists are leaves."""
    if not isinstance(tree, dict) or (path and not tree):
        return {path: tree}
    entries = ((key, value) for key, value in tree.items() if path or key not in NOT_DRAWN)
    return {leaf: value for key, below in entries for leaf, value in _flat(below, (*path, key)).items()}


def sea_of(resolved: Mapping[str, Any], axes: Sequence[Axis], case: tuple[int, ...]) -> Sea:
    """Return the sea of a case: the changes of the waves by its values, with directions separated."""
    waves = {name: dict(one) for name, one in (resolved.get("sea") or {}).get("waves", {}).items()}
    flat = _flat(waves)
    for axis, k in zip(axes, case, strict=True):
        flat |= {path[2:]: value for path, value in axis.changes[k].items() if path[:2] == ("sea", "waves")}
    names = list(waves) + [path[0] for path in flat if path[0] not in waves]
    directions = dict.fromkeys(names, 0.0)
    for path, value in reversed(flat.items()):
        if path[-1] == "direction_rad" and isinstance(value, int | float):
            directions[path[0]] = value
    tree: dict[str, Any] = {}
    for path, value in flat.items():
        if value is None:
            continue
        branch = tree
        for key in path[:-1]:
            branch = branch.setdefault(key, {})
        branch[path[-1]] = 0.0 if path[-1] == "direction_rad" else value
    return Sea(json.dumps(tree), tuple(directions[name] for name in tree))


def moments(
    simulation: Simulation, columns: list[str], seas: Sequence[Sea]
) -> tuple[spectral.Transfer, Numbers, list[str]]:
    """Compute m0, m2 and m0 of the halved response for each sea and column."""
    keys = {key: k for k, key in enumerate(dict.fromkeys(sea.key for sea in seas))}
    trees = [json.loads(key) for key in keys]
    shapes = simulation.sea_spectra([], random_sea.SPREAD, trees)
    if not all(shapes):
        raise KingpostError("sea.waves: found a case without any, allowed: a wave system with enabled: true")
    # By key: the index of each enabled system among those of the sea.
    running = [
        [list(tree).index(one["name"]) for one in one_sea]
        for tree, one_sea in zip(trees, shapes, strict=True)
    ]
    turned = [_turned(shapes[keys[sea.key]], running[keys[sea.key]], sea) for sea in seas]
    directions = np.unique(np.concatenate([random_sea.directions_of(one) for one in turned]))
    nodes = np.unique(np.concatenate([random_sea.nodes_of(one) for one in shapes]))
    lines = np.unique(np.concatenate([random_sea.lines_of(one) for one in shapes]))
    found = spectral.transfer(simulation, columns, directions, nodes, lines)
    densities = simulation.sea_spectra(found.omega_rad_s, random_sea.SPREAD, trees)
    # By key and system: moments by direction and column, for all directions.
    every = [[_weighted(found, one) for one in one_sea] for one_sea in densities]
    sums = np.zeros((3, len(seas), len(found.columns)))
    for case, (sea, systems) in enumerate(zip(seas, turned, strict=True)):
        for one, known in zip(systems, every[keys[sea.key]], strict=True):
            if known is not None:
                at = np.searchsorted(
                    found.directions_rad, np.array(one["directions_rad"]) - random_sea.BESIDE
                )
                sums[:, case] += known[:, at].mean(axis=1)
            if one["lines"]:
                sums[:, case] += spectral.moments_in(found, [{**one, "directions_rad": []}])
    said = dict.fromkeys(
        [*found.warnings, *(w for one in densities for w in spectral.beyond_the_data(found, one))]
    )
    return found, sums, list(said)


def _weighted(found: spectral.Transfer, system: WaveSystem) -> Numbers | None:
    if not system["directions_rad"]:
        return None
    return spectral.moments_of(found, np.asarray(system["density_m2_s"]) * found.weights)


def _turned(systems: Sequence[WaveSystem], numbers: Sequence[int], sea: Sea) -> list[WaveSystem]:
    """Turn wave systems from direction 0 to their directions in a sea."""

    def turn(one: WaveSystem, direction: float) -> WaveSystem:
        lines = [(omega, direction, variance) for omega, _, variance in one["lines"]]
        return {**one, "directions_rad": [direction + to for to in one["directions_rad"]], "lines": lines}

    return [turn(one, sea.directions_rad[k]) for one, k in zip(systems, numbers, strict=True)]

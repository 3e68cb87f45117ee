"""Performance of every controller and device in seas from small to well beyond the limits of its drives.
Beyond a limit the residual must grow. Instability must not occur: a drive at its limit must not increase the
motion above the uncontrolled one, and a small increase of the sea must not cause a large increase of the
motion. Each quantity is compared with that in the same sea without the controller; all heights have the same
realisation, scaled.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
import xarray

from ...errors import KingpostWarning
from ...reports.tables import table
from ...simulation.batch import FINISHED, Batch
from ..rows import FAILED, PASSED
from .standard import SETTLED_S
from .sweep_cases import SWEEPS, Sweep

LARGEST_SHARE = 1.0
"""Limit of the remaining motion over the motion without the controller: of standard deviations and of
maxima."""
LARGEST_GROWTH = 1.0
"""Limit of the growth: the largest increase of the remaining motion per metre of Hs, over the largest
increase without the controller.

A saturated input leaves the excess: u - clip(u) never grows faster than u. A jump between two states, or the
onset of an oscillation that the controller causes, would grow faster.
"""
ROUNDING = 1e-12


@dataclass(frozen=True)
class Degraded:
    """A sweep: one number for each significant height in each array."""

    name: str
    heights_m: np.ndarray
    without: np.ndarray
    """Standard deviation of the motion without the controller or device, in `unit`."""
    left: np.ndarray
    """Standard deviation of the motion with the controller or device, in `unit`."""
    largest: np.ndarray
    """Largest motion with the controller or device over the largest motion without it."""
    at_a_limit: np.ndarray
    """Share of the time at a limit."""
    finished: bool
    """Whether all runs reached their end."""
    unit: str = "m"

    @property
    def share(self) -> np.ndarray:
        """Remaining motion over the motion without the controller or device, 1."""
        return self.left / self.without

    @property
    def growth(self) -> float:
        """Largest increase of the remaining motion per metre of Hs, over the largest increase without the
        controller."""
        steps = np.diff(self.heights_m, prepend=0.0)
        with_it, without = (np.diff(one, prepend=0.0) / steps for one in (self.left, self.without))
        return float(with_it.max() / without.max())

    @property
    def shortfalls(self) -> list[str]:
        """Violations of the claim that performance degrades smoothly under saturation, never to
        instability."""
        statements = {
            "a run ended early": self.finished,
            f"the residual is {self.share.max():.2f} of the motion": self.share.max() <= LARGEST_SHARE,
            f"the largest motion is {self.largest.max():.2f} times the uncontrolled one": self.largest.max()
            <= LARGEST_SHARE,
            f"grows {self.growth:.2f} times as fast": self.growth <= LARGEST_GROWTH,
            "the residual falls with Hs": bool((np.diff(self.left) >= 0).all()),
            "the time at a limit falls with Hs": bool((np.diff(self.at_a_limit) >= -ROUNDING).all()),
        }
        return [what for what, holds in statements.items() if not holds]

    @property
    def verdict(self) -> str:
        """`PASSED` or `FAILED`."""
        return FAILED if self.shortfalls else PASSED


def cases() -> Iterator[str]:
    """The names of the sweeps.

    >>> len(list(cases()))
    9
    """
    return iter(SWEEPS)


@lru_cache(maxsize=2)
def _runs(
    scenario: str,
    given: tuple[tuple[str, Any], ...],
    height: str,
    heights_m: tuple[float, ...],
    length_s: float,
) -> xarray.Dataset:
    """Runs of all heights after the start-up; the last two are cached, because consecutive sweeps share
    them."""
    settings = dict(given) | {"simulation.duration_s": length_s}
    with warnings.catch_warnings(action="ignore", category=KingpostWarning):
        # Ignore warnings of submerged decks and of stops in the higher seas: the table shows the result.
        found = Batch(scenario, {height: list(heights_m)}, settings).run()
    return found.sel(time=slice(min(SETTLED_S, 0.5 * length_s), None))


def _motion(runs: xarray.Dataset, sweep: Sweep) -> tuple[np.ndarray, np.ndarray]:
    """Standard deviation and largest distance from the mean, over all columns together, for each run."""
    columns = np.stack([runs.kingpost[name].values for name in sweep.moves])
    off = columns - columns.mean(axis=-1, keepdims=True)
    squares = sweep.factor**2 * (off**2).sum(axis=0)
    return np.sqrt(squares.mean(axis=-1)), np.sqrt(squares.max(axis=-1))


def measure(name: str, length_s: float | None = None, heights_m: Sequence[float] | None = None) -> Degraded:
    """Run one of `SWEEPS`, optionally with other heights or a shorter length."""
    sweep = SWEEPS[name]
    heights = tuple(sweep.heights_m if heights_m is None else heights_m)
    sizes = (sweep.height, heights, sweep.length_s if length_s is None else length_s)
    off, on = (_runs(sweep.scenario, sweep.given + how, *sizes) for how in (sweep.without, ()))
    (without, largest_without), (left, largest) = _motion(off, sweep), _motion(on, sweep)
    reached = np.zeros(on.kingpost[sweep.moves[0]].shape, dtype=bool)
    for column, (lowest, highest) in sweep.limits().items():
        values = on.kingpost[column].values
        reached |= (values <= lowest) | (values >= highest)
    return Degraded(
        name,
        np.array(heights),
        without,
        left,
        largest=largest / largest_without,
        at_a_limit=reached.mean(axis=-1),
        finished=all((one["status"].values == FINISHED).all() for one in (off, on)),
        unit=sweep.unit,
    )


def measured(update: Callable[[float], None]) -> list[Degraded]:
    """Every sweep; `update` is called after each."""
    rows = []
    for done, name in enumerate(cases(), 1):
        rows.append(measure(name))
        update(done)
    return rows


HEAD = ("beyond the limits", "Hs, m", "without", "left", "left, %", "largest, %", "time at a limit, %")
STATEMENTS = ("degrades smoothly", "left, at most", "largest, at most", "growth, at most", "verdict")


def text(rows: Sequence[Degraded]) -> str:
    """Table of all seas, and table of the statements with their limits."""
    seas = [
        (
            row.name,
            f"{height:g}",
            f"{row.without[i]:.3f} {row.unit}",
            f"{row.left[i]:.3f} {row.unit}",
            f"{100 * row.share[i]:.1f}",
            f"{100 * row.largest[i]:.0f}",
            f"{100 * row.at_a_limit[i]:.1f}",
        )
        for row in rows
        for i, height in enumerate(row.heights_m)
    ]
    worst = [
        (
            row.name,
            *(f"{one:.2f}" for one in (row.share.max(), row.largest.max(), row.growth)),
            "; ".join([row.verdict, *row.shortfalls]),
        )
        for row in rows
    ]
    allowed = ("allowed", f"{LARGEST_SHARE:g}", f"{LARGEST_SHARE:g}", f"{LARGEST_GROWTH:g}", "")
    asked = (
        "asked for: no more motion than without, of standard deviations and of largest values; no metre of\n"
        "Hs adds more than one does without; what is left and the time at a limit never fall; every run ends"
    )
    return "\n".join(
        [*table([HEAD, *seas], "<>>>>>>"), "", *table([STATEMENTS, *worst, allowed], "<>>><"), asked]
    )

"""Outcomes of runs: limits and warnings, as data and as text. The same warning of several runs is given once.
The command line, `warnings.warn` and files use the same words.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from ..results.entries import (
    EventEntry,
    LimitEntry,
    WarningEntry,
    events_of,
    limits_of,
    model_warnings_of,
    warnings_of,
)
from .records import OFF_BALANCE, PARTS

if TYPE_CHECKING:
    import xarray

# Pattern of a number; digits in a name such as leg_2 do not match.
NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[+-]?\d+)?")
PARTED = "parted at"


def kind_of(warning: Mapping[str, object]) -> tuple[str, str, str]:
    """Code and name of a warning, and its text without numbers: warnings that differ only in their numbers
    are of one kind.

    >>> kind_of({"code": "large_heel", "name": "ship", "text": "it heeled to 24.3 deg"})
    ('large_heel', 'ship', 'it heeled to # deg')
    """
    return str(warning["code"]), str(warning["name"]), NUMBER.sub("#", str(warning["text"]))


@dataclass(frozen=True)
class Outcome:
    """The outcome of a run, as data sets hold it.

    Attributes
    ----------
    seed
        Seed of the run; or its number in a `Batch` whose runs differ in something else.
    limits, warnings
        The limits and warnings, as dictionaries.
    counted_by
        The meaning of `seed`: ``seed`` or ``run``.
    """

    seed: int
    limits: list[LimitEntry]
    warnings: list[WarningEntry]
    counted_by: str = "seed"

    @property
    def is_off_balance(self) -> bool:
        """Whether the energy balance of the run is violated; its numbers are then unreliable."""
        return any(warning["code"] == OFF_BALANCE for warning in self.warnings)


def of_run(results: xarray.Dataset, seed: int) -> Outcome:
    """The outcome of a run, from its data set."""
    return with_partings(seed, limits_of(results), warnings_of(results), events_of(results))


def with_partings(
    seed: int,
    limits: list[LimitEntry],
    warnings: list[WarningEntry],
    events: Sequence[EventEntry] = (),
    counted_by: str = "seed",
) -> Outcome:
    """The outcome of a run; each rope that parted is among its warnings, with the time."""
    told = {warning["name"] for warning in warnings if warning["code"] == PARTS}
    untold = [
        WarningEntry(
            time_s=event["time_s"],
            code=PARTS,
            name=event["element"],
            value=None,
            bound=None,
            unit="",
            text=PARTS,
        )
        for event in events
        if event["code"] == PARTS and event["element"] not in told
    ]
    every = [_with_time_of_parting(warning) for warning in warnings + untold]
    return Outcome(seed, limits, every, counted_by)


def _with_time_of_parting(warning: WarningEntry) -> WarningEntry:
    """A warning; if a rope parts, its text contains the time.

    >>> warning = {"time_s": 67.2913, "code": "parts", "name": "whip", "text": "parts: its load"}
    >>> _with_time_of_parting(warning)["text"]
    'parted at 67.29 s: its load'
    """
    if warning["code"] != PARTS:
        return warning
    return {**warning, "text": f"{PARTED} {warning['time_s']:.2f} s{warning['text'].removeprefix(PARTS)}"}


def every_warning(results: xarray.Dataset) -> list[str]:
    """All warnings of a run, from its data set: those before the run, ropes that parted, and the other
    warnings of the engine.

    >>> import xarray
    >>> from kingpost.results.entries import with_entries
    >>> every_warning(with_entries(xarray.Dataset(), model_warnings=["nothing carries the ship"]))
    ['nothing carries the ship']
    """
    of_parting, others = in_words([of_run(results, int(results.attrs.get("seed", 0)))])
    return [*model_warnings_of(results), *of_parting, *others]


def in_words(outcomes: Sequence[Outcome]) -> tuple[list[str], list[str]]:
    """Warnings of the engine: of ropes that parted, and the others. Warnings of several runs that differ only
    in their numbers are given once."""
    alike: dict[tuple[str, str, str], dict[int, list[str]]] = {}
    for run, outcome in enumerate(outcomes):
        for warning in outcome.warnings:
            alone = (warning["code"], warning["name"], warning["text"])
            kind = kind_of(warning) if len(outcomes) > 1 else alone
            alike.setdefault(kind, {}).setdefault(run, []).append(warning["text"])
    of_parting: list[str] = []
    others: list[str] = []
    for (code, name, _), texts in alike.items():
        first = next(iter(texts.values()))[0]
        named = f"{name} {first}" if code == PARTS else f"{name}: {first}"
        several = f"in {len(texts)} of {len(outcomes)} runs{_range(outcomes, texts)}, first: "
        said = several + named if len(outcomes) > 1 else named
        (of_parting if code == PARTS else others).append(said)
    return of_parting, others


def _range(outcomes: Sequence[Outcome], texts: Mapping[int, Sequence[str]]) -> str:
    """The range of the first number in the texts, with the seeds of its smallest and largest value."""
    numbers = [(found.group(), outcomes[run]) for run, told in texts.items()
               for text in told if (found := NUMBER.search(text))]  # fmt: skip
    ends = [end(numbers, key=lambda one: float(one[0])) for end in (min, max)] if numbers else []
    if not ends or ends[0][0] == ends[1][0]:
        return ""
    smallest, largest = (f"{number} ({of.counted_by} {of.seed})" for number, of in ends)
    return f", from {smallest} to {largest}"

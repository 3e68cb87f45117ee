"""Outcomes of runs: limits and warnings, as data and as text. The same warning of several runs is given once.
The command line, `warnings.warn` and files use the same words.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ..results.entries import (
    EventEntry,
    LimitEntry,
    WarningEntry,
    events_of,
    limits_of,
    model_warnings_of,
    warnings_of,
)
from .records import PARTS

# Pattern of a number; digits in a name such as leg_2 do not match.
NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[+-]?\d+)?")
PARTED = "parted at"
ENERGY, OFF_BALANCE = "energy", "is off its balance by"
"""Name of the warning about the energy balance, and the first words of its text."""


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
        return any(one["name"] == ENERGY and one["text"].startswith(OFF_BALANCE) for one in self.warnings)


def of_run(attributes: Mapping[str, Any], seed: int) -> Outcome:
    """The outcome of a run, from the attributes of its data set."""
    return with_partings(seed, limits_of(attributes), warnings_of(attributes), events_of(attributes))


def with_partings(
    seed: int,
    limits: list[LimitEntry],
    warnings: list[WarningEntry],
    events: Sequence[EventEntry] = (),
    counted_by: str = "seed",
) -> Outcome:
    """The outcome of a run; each rope that parted is among its warnings, with the time."""
    told = {warning["name"] for warning in warnings if warning["text"].startswith(PARTS)}
    untold = [
        WarningEntry(time_s=event["time_s"], name=event["element"], text=PARTS)
        for event in events
        if event["what"] == PARTS and event["element"] not in told
    ]
    every = [_with_time_of_parting(warning) for warning in warnings + untold]
    return Outcome(seed, limits, every, counted_by)


def _with_time_of_parting(warning: WarningEntry) -> WarningEntry:
    """A warning; if a rope parts, its text contains the time.

    >>> _with_time_of_parting({"time_s": 67.2913, "name": "whip", "text": "parts: its load"})["text"]
    'parted at 67.29 s: its load'
    """
    text = warning["text"]
    if not text.startswith(PARTS):
        return warning
    parted = f"{PARTED} {warning['time_s']:.2f} s{text.removeprefix(PARTS)}"
    return WarningEntry(time_s=warning["time_s"], name=warning["name"], text=parted)


def every_warning(attributes: Mapping[str, Any]) -> list[str]:
    """All warnings of a run, from the attributes of its data set: those before the run, ropes that parted,
    and the other warnings of the engine.

    >>> every_warning({"warnings": '[{"time_s": 4.0, "name": "ship", "text": "it heeled"}]'})
    ['ship: it heeled']
    """
    of_parting, others = in_words([of_run(attributes, int(attributes.get("seed", 0)))])
    return [*model_warnings_of(attributes), *of_parting, *others]


def in_words(outcomes: Sequence[Outcome]) -> tuple[list[str], list[str]]:
    """Warnings of the engine: of ropes that parted, and the others. Warnings of several runs that differ only
    in their numbers are given once."""
    alike: dict[tuple[str, str], dict[int, list[str]]] = {}
    for run, outcome in enumerate(outcomes):
        for warning in outcome.warnings:
            pattern = NUMBER.sub("#", warning["text"]) if len(outcomes) > 1 else warning["text"]
            alike.setdefault((warning["name"], pattern), {}).setdefault(run, []).append(warning["text"])
    of_parting: list[str] = []
    others: list[str] = []
    for (name, _), texts in alike.items():
        first = next(iter(texts.values()))[0]
        named = f"{name} {first}" if first.startswith(PARTED) else f"{name}: {first}"
        several = f"in {len(texts)} of {len(outcomes)} runs{_range(outcomes, texts)}, first: "
        said = several + named if len(outcomes) > 1 else named
        (of_parting if first.startswith(PARTED) else others).append(said)
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

"""What came of runs: how limits held, what the engine warned of, and both in words.

Of several runs each warning stands once. The command line, `warnings.warn` and files have the same words.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from .records import PARTS

# Not the digits of a name, as in leg_2.
NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[+-]?\d+)?")
PARTED = "parted at"
ENERGY, OFF_BALANCE = "energy", "is off its balance by"
"""The name of a warning and how its text begins."""


@dataclass(frozen=True)
class Outcome:
    """What came of a run, as data sets have it.

    Attributes
    ----------
    seed
        Its seed; or the number of the run of a `Batch` whose runs differ in something else.
    limits, warnings
        As dictionaries.
    counted_by
        What `seed` is, ``seed`` or ``run``.
    """

    seed: int
    limits: list[dict[str, Any]]
    warnings: list[dict[str, Any]]
    counted_by: str = "seed"

    @property
    def is_off_balance(self) -> bool:
        """Whether the energy of the run does not balance, so that its numbers are not to be trusted."""
        return any(one["name"] == ENERGY and one["text"].startswith(OFF_BALANCE) for one in self.warnings)


def of_run(attributes: Mapping[str, Any], seed: int) -> Outcome:
    """What came of a run, by the attributes of its data set."""
    names = ("limits", "warnings", "events")
    return with_partings(seed, *(json.loads(attributes.get(name, "[]")) for name in names))


def with_partings(
    seed: int,
    limits: list[dict[str, Any]],
    warnings: list[dict[str, Any]],
    events: Sequence[dict[str, Any]] = (),
    counted_by: str = "seed",
) -> Outcome:
    """What came of a run; among its warnings each rope that parted, with the time."""
    told = {warning["name"] for warning in warnings if warning["text"].startswith(PARTS)}
    untold = [{"time_s": event["time_s"], "name": event["element"], "text": PARTS}
              for event in events if event["what"] == PARTS and event["element"] not in told]  # fmt: skip
    every = [_with_time_of_parting(warning) for warning in warnings + untold]
    return Outcome(seed, limits, every, counted_by)


def _with_time_of_parting(warning: dict[str, Any]) -> dict[str, Any]:
    """A warning; of a rope that parts with the time in its text.

    >>> _with_time_of_parting({"time_s": 67.2913, "name": "whip", "text": "parts: its load"})["text"]
    'parted at 67.29 s: its load'
    """
    text = warning["text"]
    if not text.startswith(PARTS):
        return warning
    return warning | {"text": f"{PARTED} {warning['time_s']:.2f} s{text.removeprefix(PARTS)}"}


def every_warning(attributes: Mapping[str, Any]) -> list[str]:
    """What one should know of a run, by the attributes of its data set: what was known before, which ropes
    parted, and what else the engine warned of.

    >>> every_warning({"warnings": '[{"time_s": 4.0, "name": "ship", "text": "it heeled"}]'})
    ['ship: it heeled']
    """
    of_parting, others = in_words([of_run(attributes, int(attributes.get("seed", 0)))])
    return [*json.loads(attributes.get("model_warnings", "[]")), *of_parting, *others]


def in_words(outcomes: Sequence[Outcome]) -> tuple[list[str], list[str]]:
    """What the engine warned of, of ropes that parted and of the rest; what it said of several runs, but for
    its numbers, once."""
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
    """The smallest and the largest first number of texts that differ in it, with the seeds of their runs."""
    numbers = [(found.group(), outcomes[run]) for run, told in texts.items()
               for text in told if (found := NUMBER.search(text))]  # fmt: skip
    ends = [end(numbers, key=lambda one: float(one[0])) for end in (min, max)] if numbers else []
    if not ends or ends[0][0] == ends[1][0]:
        return ""
    smallest, largest = (f"{number} ({of.counted_by} {of.seed})" for number, of in ends)
    return f", from {smallest} to {largest}"

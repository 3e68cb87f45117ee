"""Report of a run's events: important ones one by one, then counts of repeating ones."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

from ..results.entries import EventEntry, events_of
from ..simulation.batch import FINISHED
from ..simulation.records import REPEATING
from .tables import table

if TYPE_CHECKING:
    import xarray

# If one element has more events than this, they are only counted: a load may leave the water in every wave.
MOST_OF_ONE = 4


def events(results: xarray.Dataset) -> list[str]:
    """Events of a run: a row for each important event, in order of time, then a row for each element with
    repeating events."""
    found = events_of(results)
    often = Counter(map(_kind, found))
    repeats = {kind for kind, count in often.items() if kind[1] in REPEATING or count > MOST_OF_ONE}
    single = [event for event in found if _kind(event) not in repeats]
    repeated = [event for event in found if _kind(event) in repeats]
    if results.attrs.get("status", FINISHED) != FINISHED:
        end_s = float(results["time"].values[-1])
        single.append({"time_s": end_s, "element": "", "code": "", "what": "the run ends early"})
    tables = [lines for lines in (_in_order(single), _counted(repeated)) if lines]
    return [line for lines in tables for line in ("", *lines)][1:]


def _kind(event: EventEntry) -> tuple[str, str, str]:
    return event["element"], event["code"], event["what"]


def _in_order(events: list[EventEntry]) -> list[str]:
    rows = [(f"{event['time_s']:.2f}", event["element"], event["what"]) for event in events]
    return table([("at, s", "", "event"), *rows], "><<") if rows else []


def _counted(events: list[EventEntry]) -> list[str]:
    """A row for each element: the count of each of its events, the first and the last time."""
    of_things: dict[str, list[EventEntry]] = {}
    for event in events:
        of_things.setdefault(event["element"], []).append(event)
    rows = [("repeating events", "", "first at, s", "last at, s")]
    for thing, own in of_things.items():
        often = Counter(event["what"] for event in own)
        words = ", ".join(f"{what} {_times(count)}" for what, count in often.items())
        rows.append((thing, words, f"{own[0]['time_s']:.2f}", f"{own[-1]['time_s']:.2f}"))
    return table(rows, "<<>>") if events else []


def _times(count: int) -> str:
    return "once" if count == 1 else f"{count} times"

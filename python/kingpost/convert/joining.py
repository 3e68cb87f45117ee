"""Lines that free points join become one line with sections."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass
from itertools import pairwise

from .deck import Deck, Segment

JOINED = "joins two lines, which are sections of one line"
WITH_WEIGHT = f"{JOINED} with a clump weight"


@dataclass
class Joined:
    """Segments in their order between two points."""

    ends: tuple[str, str]
    parts: list[Segment]

    @property
    def name(self) -> str:
        """Names of the segments together."""
        first, *rest = self.parts
        return "_".join([first.name, *(part.name.removeprefix("line_") for part in rest)])

    @property
    def joints(self) -> list[str]:
        """Names of the points between the segments."""
        return [
            next(end for end in before.ends if end in after.ends) for before, after in pairwise(self.parts)
        ]


def attached(lines: list[Segment]) -> dict[str, list[Segment]]:
    """Lines by the points that they connect to."""
    found: dict[str, list[Segment]] = defaultdict(list)
    for line in lines:
        for end in line.ends:
            found[end].append(line)
    return found


def joined(deck: Deck) -> list[Joined]:
    """Join lines at free points that connect two of them."""
    at = attached(deck.lines)
    joints = {name for name, lines in at.items() if len(lines) == 2 and deck.points[name].body is None}
    used: set[str] = set()
    found = []
    for line in deck.lines:
        if line.name in used:
            continue
        used.add(line.name)
        first, before = _walk(line, line.ends[0], at, joints, used)
        last, after = _walk(line, line.ends[1], at, joints, used)
        found.append(Joined((first, last), [*reversed(before), line, *after]))
    inside = joints - {end for one in found for end in one.ends}
    for name in inside:
        point = deck.points[name]
        deck.notes.convert(point.line, name, JOINED if point.is_bare else WITH_WEIGHT)
    return found


def _walk(
    line: Segment, end: str, at: dict[str, list[Segment]], joints: set[str], used: set[str]
) -> tuple[str, list[Segment]]:
    """Follow lines from an end, up to a point that does not join two; mark them as used."""
    found: list[Segment] = []
    while end in joints:
        (following,) = [one for one in at[end] if one is not line] or [line]
        if following.name in used:
            break
        used.add(following.name)
        found.append(following)
        line, end = following, following.ends[1 - following.ends.index(end)]
    return end, found

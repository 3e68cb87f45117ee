"""Lines that free points join become one line with sections, or lines that are fastened to each other."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass
from itertools import pairwise

from .deck import Deck, Segment

JOINED = "joins two lines, which are sections of one line"
MEETING = "joins lines, which are fastened to one of them: second_on"
FREE = "is the free end of a line"
WITH_WEIGHT = "with a clump weight"


@dataclass
class Joined:
    """Segments in their order between two points.

    Attributes
    ----------
    on
        The line to which the second end is fastened, and the section of it whose end is there.
    is_free
        Whether the second end is free, or other lines are fastened to it.
    """

    ends: tuple[str, str]
    parts: list[Segment]
    on: tuple[Joined, int] | None = None
    is_free: bool = False

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
    """Join lines at free points: two to one line, three and more to lines that are fastened to each other.

    Free points of lines in a circle, and of lines that no body holds, stay the ends of lines.
    """
    at = attached(deck.lines)
    free = {name for name in at if deck.points[name].body is None}
    chains = _chains(deck, at, {name for name in free if len(at[name]) == 2})
    _note(deck, free - {end for one in chains for end in one.ends}, JOINED)
    found = []
    for tree in _trees(chains, free):
        lines = _fastened(tree, free)
        found += lines or tree
        for end in free & {end for line in lines for end in (*line.joints, line.ends[1])}:
            if len(at[end]) != 2:
                _note(deck, {end}, MEETING if len(at[end]) > 2 else FREE)
    return found


def _note(deck: Deck, points: set[str], why: str) -> None:
    for name in points:
        point = deck.points[name]
        deck.notes.convert(point.line, name, why if point.is_bare else f"{why} {WITH_WEIGHT}")


def _chains(deck: Deck, at: dict[str, list[Segment]], joints: set[str]) -> list[Joined]:
    """Lines with those that continue them at points that connect two."""
    used: set[str] = set()
    found = []
    for line in deck.lines:
        if line.name in used:
            continue
        used.add(line.name)
        first, before = _walk(line, line.ends[0], at, joints, used)
        last, after = _walk(line, line.ends[1], at, joints, used)
        found.append(Joined((first, last), [*reversed(before), line, *after]))
    return found


def _trees(lines: list[Joined], free: set[str]) -> list[list[Joined]]:
    """Groups of lines that free points connect."""
    groups: list[list[Joined]] = []
    for line in lines:
        ends = free & set(line.ends)
        meeting = [group for group in groups if any(ends & set(one.ends) for one in group)]
        groups = [group for group in groups if group not in meeting]
        groups.append([*(one for group in meeting for one in group), line])
    return groups


def _fastened(tree: list[Joined], free: set[str]) -> list[Joined]:
    """Lines that are fastened to each other; none if they cannot be.

    Each begins where a body holds it. It goes through joints to the one at which it is fastened to a line
    that goes on from there; the first line ends freely at the last joint, or beyond.
    """
    ends = [end for line in tree for end in line.ends if end in free]
    loose = [end for end in ends if ends.count(end) == 1]
    between = [line for line in tree if set(line.ends) <= free]
    if not ends or len(loose) > 1 or len(between) != len(set(ends)) - 1:
        return []
    coming: dict[str, list[Joined]] = {end: [] for end in ends}
    for line in tree:
        if line not in between:
            joint = next(end for end in line.ends if end in free)
            coming[joint].append(_towards(joint, line))
    last = (loose or ends)[0]
    found: list[Joined] = []
    for joint, onward in reversed(_outwards(last, between)):
        if not coming[joint]:
            return []
        carrier, *others = coming[joint]
        for line in others:
            line.on = (carrier, len(carrier.parts) - 1)
        found += others
        if onward is None:
            carrier.is_free = True
            return [carrier, *reversed(found)]
        following = next(end for end in onward.ends if end != joint)
        carrier.ends = (carrier.ends[0], following)
        carrier.parts = carrier.parts + _towards(following, onward).parts
        coming[following].append(carrier)
    return []


def _towards(joint: str, line: Joined) -> Joined:
    """A line with its second end at a joint."""
    if line.ends[1] == joint:
        return Joined(line.ends, line.parts)
    return Joined((line.ends[1], joint), line.parts[::-1])


def _outwards(last: str, between: list[Joined]) -> list[tuple[str, Joined | None]]:
    """Joints from the last one outwards, each with the line that leads from it towards the last one."""
    order: list[tuple[str, Joined | None]] = [(last, None)]
    for joint, onward in order:
        others = [line for line in between if line is not onward and joint in line.ends]
        order += [(next(end for end in line.ends if end != joint), line) for line in others]
    return order


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

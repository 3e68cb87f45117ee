"""The scenario of a mooring system."""

from __future__ import annotations

import math
import re
from typing import Any

from . import loads
from .deck import WORLD, Body, Deck, Point, Segment, Vector
from .joining import Joined, attached, joined

DURATION_S, RECORD_EVERY_S = 100.0, 0.1
JUNCTION_SHARE = 0.1
"""Mass of the body of a free point without mass, over half the mass of the segments that meet there."""
FIXED = "fixed_points"
PLACEHOLDER = {"mass_kg": loads.PLACEHOLDER_KG, "shape": {"point": {}}, "joint": {"fixed": {}}}
NO_TYPE = "no line has this type"


def build(deck: Deck, title: str) -> dict[str, Any]:
    """Fields of the scenario.

    Notes on what changes are added to the deck.
    """
    _note_types(deck)
    lines = joined(deck)
    return _Builder(deck, lines).fields(title)


def _note_types(deck: Deck) -> None:
    used = {line.kind.name for line in deck.lines}
    for name, kind in deck.types.items():
        if name in used:
            deck.notes.left_out += kind.notes.left_out
            deck.notes.converted += kind.notes.converted
        else:
            deck.notes.leave_out(kind.line, name, NO_TYPE)


def section(part: Segment, deck: Deck) -> dict[str, Any]:
    """Fields of a section of a line."""
    kind = part.kind
    fields: dict[str, Any] = {
        "unstretched_length_m": part.length_m,
        "elements": elements(part),
        "mass_kg_per_m": kind.mass_kg_per_m,
        "diameter_m": kind.diameter_m,
        "axial_stiffness_N": kind.stiffness_n,
    }
    if kind.bending_n_m2:
        fields["bending_stiffness_N_m2"] = kind.bending_n_m2
    time = _damping_time(part)
    if time is not None:
        fields["damping_time_s"] = time
    if kind.damping_n_s is not None and kind.damping_n_s < 0:
        share = -kind.damping_n_s
        of = f"{share:g} of the critical damping of a segment of {_span(part):.4g} m"
        why = f"damping_time_s {time:.4g}: {of}"
        deck.notes.convert(part.line, f"{part.name}: BA {kind.damping_n_s:g} of {kind.name}", why)
    return fields | {
        "added_mass_across": kind.added_mass_across,
        "added_mass_along": kind.added_mass_along,
        "drag_across": kind.drag_across,
        "drag_along": kind.drag_along,
    }


def elements(part: Segment) -> int:
    """Number of elements: half the segments, rounded up, because an element has two nodes."""
    return (part.segments + 1) // 2


def _span(part: Segment) -> float:
    return part.length_m / part.segments


def _damping_time(part: Segment) -> float | None:
    """Damping over stiffness, s. A negative one is a share of sqrt(EA m) times the length of a segment."""
    kind = part.kind
    if kind.damping_n_s is None:
        return None
    if kind.damping_n_s >= 0:
        return kind.damping_n_s / kind.stiffness_n
    critical = _span(part) * math.sqrt(kind.stiffness_n * kind.mass_kg_per_m)
    return -kind.damping_n_s * critical / kind.stiffness_n


class _Builder:
    """Builds bodies and forces; keeps the names that are in use."""

    def __init__(self, deck: Deck, lines: list[Joined]) -> None:
        self.deck = deck
        self.lines = lines
        self.at = attached(deck.lines)
        self.bodies: dict[str, Any] = {}
        self.forces: dict[str, Any] = {"gravity": {"gravity": {"acceleration_m_s2": deck.water.gravity_m_s2}}}
        self.carriers: dict[str, str] = {}
        self.names: dict[int, str] = {}
        self.is_stiff = False

    def fields(self, title: str) -> dict[str, Any]:
        """All fields of the scenario."""
        deck = self.deck
        self._deepen()
        for one in deck.bodies.values():
            self.bodies[one.name] = loads.body(one, deck)
            self.forces |= loads.water_on_body(one, deck)
            self._note_stiffness(one)
        self._points()
        for line in self.lines:
            self.names[id(line)] = self._name(line.name, self.forces, "line")
            self.forces[self.names[id(line)]] = {}
        for line in self.lines:
            self.forces[self.names[id(line)]]["line"] = self._line(line)
        if not self.bodies:
            self.bodies[FIXED] = PLACEHOLDER
            deck.notes.convert(
                None, FIXED, f"a body of {loads.PLACEHOLDER_KG:g} kg, because a scenario has one"
            )
        sea: dict[str, Any] = {"density_kg_m3": deck.water.density_kg_m3}
        if deck.water.depth_m:
            sea["depth_m"] = deck.water.depth_m
        deck.notes.convert(None, "segments", "half as many elements, because an element has two nodes")
        found = {"version": 1, "title": title, "simulation": self._simulation(), "sea": sea}
        return found | {"bodies": self.bodies, "forces": self.forces}

    def _deepen(self) -> None:
        """Lower the seabed to the lowest point, as MoorDyn does."""
        lowest: tuple[float, Point | None] = (-self.deck.water.depth_m, None)
        for name in self.at:
            point = self.deck.points[name]
            z = self._position(point)[2]
            if z < lowest[0]:
                lowest = z, point
        if lowest[1] is not None:
            self.deck.water.depth_m = -lowest[0]
            why = f"is below the seabed: sea.depth_m is its depth, {-lowest[0]:g} m"
            self.deck.notes.convert(lowest[1].line, lowest[1].name, why)

    def _position(self, point: Point) -> Vector:
        body = self.deck.bodies.get(point.body or "")
        return point.position_m if body is None else loads.rotated(body, point.position_m)

    def _points(self) -> None:
        """Bodies of free points; those that join lines need none."""
        ends = {end for line in self.lines for end in line.ends[: 1 if line.on or line.is_free else 2]}
        for name, point in self.deck.points.items():
            if name not in self.at:
                if not name.startswith("rod_"):
                    self.deck.notes.leave_out(point.line, name, "no line connects to it")
            elif point.body is not None:
                self.carriers[name] = point.body
                self._note_carried(point)
            elif name in ends:
                self._free_point(name, point)

    def _note_carried(self, point: Point) -> None:
        if point.mass_kg or point.volume_m3 or point.drag_area_m2:
            why = "a point of a body has no mass, volume and drag of its own: add them to the body"
            self.deck.notes.leave_out(point.line, f"mass, volume and drag of {point.name}", why)

    def _free_point(self, name: str, point: Point) -> None:
        meeting = [part for line in self.lines for part in self._parts_at(line, name)]
        mass = point.mass_kg
        if not mass:
            mass = JUNCTION_SHARE * sum(part.kind.mass_kg_per_m * _span(part) / 2 for part in meeting)
            why = f"is a body of {mass:.4g} kg, a tenth of half the segments that meet there"
            self.deck.notes.convert(point.line, f"{name}, without mass", why)
        given = self._name(name, self.bodies, "point")
        self.bodies[given] = loads.point(point, mass)
        self.carriers[name] = given
        self.forces |= loads.water_on_point(point, given, self.deck)
        whole = mass + self.deck.water.density_kg_m3 * point.volume_m3 * point.added_mass
        self.is_stiff |= self._is_too_light(meeting, whole)

    def _note_stiffness(self, body: Body) -> None:
        if body.motion != "free" or not body.mass_kg:
            return
        carried = [name for name, point in self.deck.points.items() if point.body == body.name]
        meeting = [part for name in carried for line in self.lines for part in self._parts_at(line, name)]
        added = self.deck.water.density_kg_m3 * body.volume_m3 * min(body.added_mass)
        self.is_stiff |= self._is_too_light(meeting, body.mass_kg + added)

    def _parts_at(self, line: Joined, name: str) -> list[Segment]:
        ends = zip(line.ends, (line.parts[0], line.parts[-1]), strict=True)
        return [part for end, part in ends if end == name]

    def _is_too_light(self, meeting: list[Segment], mass: float) -> bool:
        """Whether a step of the deck is too long for a body between elements of these segments."""
        step = self.deck.step_s or 0.0
        rate = sum(4 * part.kind.stiffness_n * elements(part) / part.length_m for part in meeting) / mass
        damping = max((_damping_time(part) or 0.01 for part in meeting), default=0.0)
        return rate * step * (step + damping) > 1

    def _line(self, line: Joined) -> dict[str, Any]:
        fields: dict[str, Any] = {"first": self._pin(line.ends[0])}
        joints = line.joints
        if line.is_free:
            fields["second_free"] = True
            joints = [*joints, line.ends[1]]
        elif line.on:
            carrier, at = line.on
            fields["second_on"] = {"line": self.names[id(carrier)], "section": at}
        else:
            fields["second"] = self._pin(line.ends[1])
            if fields["first"]["body"] == fields["second"]["body"]:
                fields["second"]["body"] = self._beside(fields["second"]["body"], line)
        fields["sections"] = [section(part, self.deck) for part in line.parts]
        for before, joint in zip(fields["sections"], joints, strict=False):
            before.update(loads.clump_weight(self.deck.points[joint]))
        water = self.deck.water
        if water.depth_m and water.stiffness_n_per_m3:
            fields["seabed"] = {
                "friction": water.friction,
                "stiffness_N_per_m3": water.stiffness_n_per_m3,
                "damping_time_s": water.damping_n_s_per_m3 / water.stiffness_n_per_m3,
            }
        return fields

    def _pin(self, end: str) -> dict[str, Any]:
        point = self.deck.points[end]
        place = point.position_m if point.body is not None else (0.0, 0.0, 0.0)
        return {"body": self.carriers[end], "position_m": list(place)}

    def _beside(self, body: str, line: Joined) -> str:
        """A further body on the same carrier: the ends of a line are on two bodies."""
        name = FIXED if body == WORLD else f"{body}_points"
        self.bodies.setdefault(name, PLACEHOLDER if body == WORLD else {"parent": body, **PLACEHOLDER})
        why = f"its second end is on {name}, a body of 1 kg fixed to {body}, because both ends are on {body}"
        self.deck.notes.convert(line.parts[-1].line, line.name, why)
        return name

    def _simulation(self) -> dict[str, Any]:
        deck, step = self.deck, self.deck.step_s or 0.0
        record = max(deck.record_every_s or RECORD_EVERY_S, step)
        fields: dict[str, Any] = {"step_s": step, "duration_s": DURATION_S, "record_every_s": record}
        deck.notes.convert(None, "no duration", f"simulation.duration_s is {DURATION_S:g} s")
        if self.is_stiff:
            why = "simulation.integrator is dormand_prince, which chooses its steps: rk4 needs short ones"
            deck.notes.convert(None, "light bodies between stiff lines", why)
            return {"integrator": "dormand_prince", **fields}
        return fields

    def _name(self, given: str, used: dict[str, Any], word: str) -> str:
        """Name in the form of a scenario's names that is not in use.

        A name that has no letters at its start gets a word there.
        """
        small = re.sub(r"[^a-z0-9]+", "_", given.lower()).strip("_")
        name = small if re.match("[a-z]", small) and small != WORLD else f"{word}_{small}".strip("_")
        number, found = 1, name
        while found in used or found in self.deck.bodies:
            number += 1
            found = f"{name}_{number}"
        return found

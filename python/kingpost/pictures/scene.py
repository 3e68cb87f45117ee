"""A described model as faces and threads at its present poses."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from .deckhouse import deckhouse
from .faces import Faces, ball, joined, round_bar
from .palette import colour
from .solids import is_hull, solid_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ..simulation.records import DrawnLine

PIN, ROD = 0.6, 0.3
"""Radius of the pin of a closed loop over the thickness of its more slender body, and of a rod over that of
its pins: as in the app."""
CORNERS = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])


class Scene:
    """Bodies, lines and linkages of a model, built once and moved for each picture.

    Parameters
    ----------
    model
        Description of the model (`Scenario.model`).
    poses
        Poses of the bodies at the start, shape (bodies, 7), as `Simulation.poses` gives them.
    """

    def __init__(self, model: Mapping[str, Any], poses: NDArray[np.float64]) -> None:
        self.model = model
        self.has_sea = bool(model["sea"])
        bodies = model["bodies"]
        self._names = [body["name"] for body in bodies]
        # The still water is at height 0.
        water = [-pose[2] if self.has_sea else None for pose in poses]
        solids = [solid_of(body, model, level) for body, level in zip(bodies, water, strict=True)]
        self.boxes = [solid.box for solid in solids]
        self._thicknesses = {
            body["name"]: float((high - low).min())
            for body, (low, high) in zip(bodies, self.boxes, strict=True)
        }
        self._rods = [
            loop for loop in [*model["loops"], *model["connections"]] if "distance" in loop["constraints"]
        ]
        pins: list[list[Faces]] = [[] for _ in bodies]
        for loop in [*model["loops"], *model["connections"]]:
            for end in (loop["first"], loop["second"]):
                if end["body"] in self._names:
                    pin = ball(self._pin_radius(loop), colour("pin")).moved(end["position_m"])
                    pins[self._names.index(end["body"])].append(pin)
        houses = [self._house(k, solid, poses) for k, solid in enumerate(solids)]
        solids = [joined([*parts, *own]) for *parts, own in zip(solids, houses, pins, strict=True)]
        self.boxes = [solid.box for solid in solids]
        self._faces = joined(solids)
        self._body = np.repeat(np.arange(len(solids)), [len(solid.corners) for solid in solids])
        self.watched = self._hung()

    def _house(self, k: int, solid: Faces, poses: NDArray[np.float64]) -> Faces:
        """Deckhouse of a body that is a hull."""
        if not len(solid.corners) or not is_hull(self.model["bodies"][k], self.model):
            return joined([])
        turn, at = _turn(poses[k, 3:]), poses[k, :3]
        others = [
            self.corners_m(poses, [other])
            for other in range(len(poses))
            if other != k and self._is_drawn(other)
        ]
        boxes = [(points.min(axis=0), points.max(axis=0)) for points in ((one - at) @ turn for one in others)]
        return deckhouse(solid, boxes)

    def _is_drawn(self, k: int) -> bool:
        return bool((self.boxes[k][0] != self.boxes[k][1]).any())

    def _pin_radius(self, loop: Mapping[str, Any]) -> float:
        found = PIN * min(self._thicknesses.get(loop[end]["body"], np.inf) for end in ("first", "second"))
        return found if np.isfinite(found) else 0.1

    def _hung(self) -> int:
        """Index of the body that hangs on the crane: the last one that carries nothing and is no hull."""
        parents = {body["parent"] for body in self.model["bodies"]}
        joints = {one["body"]: one["kind"] for one in self.model["joints"]}
        ends = [
            k
            for k, body in enumerate(self.model["bodies"])
            if body["name"] not in parents
            and not is_hull(body, self.model)
            and joints.get(body["name"]) != "fixed"
        ]
        free = [k for k in ends if self.model["bodies"][k]["floats"]]
        return (free or ends or [len(self._names) - 1])[-1]

    def corners_m(
        self, poses: NDArray[np.float64], bodies: Sequence[int] | None = None
    ) -> NDArray[np.float64]:
        """Corners of the boxes around bodies, world; default: all bodies."""
        drawn = [k for k in range(len(self.boxes)) if self._is_drawn(k)] or range(len(self.boxes))
        which = drawn if bodies is None else bodies
        found = []
        for k in which:
            low, high = self.boxes[k]
            found.append((low + CORNERS * (high - low)) @ _turn(poses[k, 3:]).T + poses[k, :3])
        return np.concatenate(found)

    def faces(self, poses: NDArray[np.float64], lines: Sequence[DrawnLine]) -> Faces:
        """Faces of all bodies, tubes, pins and rods at their present places, world."""
        turns = np.stack([_turn(pose[3:]) for pose in poses])
        corners = np.einsum("fij,fkj->fki", turns[self._body], self._faces.corners)
        corners += poses[self._body, None, :3]
        return joined([
            Faces(corners, self._faces.colours),
            *(_drawn(line) for line in lines if line.radius_m > 0),
            *(self._rod(loop, poses) for loop in self._rods),
        ])  # fmt: skip

    def _rod(self, loop: Mapping[str, Any], poses: NDArray[np.float64]) -> Faces:
        ends = [self._at(loop[end], poses) for end in ("first", "second")]
        return tube(ends[0], ends[1], ROD * self._pin_radius(loop), colour("pin"))

    def _at(self, point: Mapping[str, Any], poses: NDArray[np.float64]) -> NDArray[np.float64]:
        position = np.array(point["position_m"], float)
        if point["body"] not in self._names:
            return position
        pose = poses[self._names.index(point["body"])]
        return _turn(pose[3:]) @ position + pose[:3]


def threads(lines: Sequence[DrawnLine]) -> list[NDArray[np.float64]]:
    """Points of the lines that are too thin to be drawn to scale, world, m."""
    return [line.points_m for line in lines if line.radius_m == 0 and len(line.points_m) > 1]


def _drawn(line: DrawnLine) -> Faces:
    """Faces of a line with a radius: a ball for one point, tubes between several."""
    paint = colour(line.style)
    if len(line.points_m) == 1:
        return ball(line.radius_m, paint).moved(line.points_m[0])
    ends = zip(line.points_m, line.points_m[1:], strict=False)
    return joined([tube(start, end, line.radius_m, paint) for start, end in ends])


def tube(
    start: NDArray[np.float64], end: NDArray[np.float64], radius_m: float, paint: NDArray[np.float64]
) -> Faces:
    """A round tube between two points."""
    way = end - start
    length = float(np.linalg.norm(way))
    if length == 0:
        return joined([])
    along = way / length
    aside = np.cross(along, np.eye(3)[np.abs(along).argmin()])
    aside /= np.linalg.norm(aside)
    axes = np.stack([aside, np.cross(along, aside), along])
    upright = round_bar(radius_m, length, "z", paint)
    return Faces(upright.corners @ axes + (start + end) / 2, upright.colours)


def _turn(quaternion: NDArray[np.float64]) -> NDArray[np.float64]:
    """Rotation matrix of a unit quaternion w, x, y, z."""
    w, x, y, z = quaternion
    return np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ])  # fmt: skip

"""Where a rod stands for a rope and does what no rope does: it pushes, or its load goes over the top."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Iterator

    import xarray
    from numpy.typing import NDArray

    from .scenario import Scenario

WORLD = "world"
PENDANTS = ("universal", "spherical")
"""Joints by which a load swings to all sides, as on a rope."""
SMALLEST_PUSH = 1e-6
"""Of the largest force that a rod carries in the run: a push of less is rounding."""


def warnings(results: xarray.Dataset, scenario: Scenario) -> list[str]:
    """What no rope does, in words: a load pushed from its joint, or that swings beyond
    90 degrees from where it hangs; a massless rod of a closed loop that pushes."""
    resolved = scenario.resolved
    lines = [words for name, up in pendants(resolved) for words in _of_pendant(results, resolved, name, up)]
    return [
        *lines,
        *(words for name, ends in rods(resolved) for words in _of_rod(results, resolved, name, ends)),
    ]


def pendants(resolved: dict[str, Any]) -> Iterator[tuple[str, NDArray[np.float64]]]:
    """Loads that hang on a rope by what a scenario says: where gravity acts, bodies that carry no other and
    swing to all sides about a point off their centre; with the unit vector from the centre to the
    joint, body axes.

    >>> joint = {"universal": {"child_position_m": [0, 0, 20], "first": {"mode": "free"}}}
    >>> load = {"enabled": True, "parent": "boom", "centre_of_mass_m": [0, 0, 0], "joint": joint}
    >>> gravity = {"gravity": {"gravity": {"enabled": True}}}
    >>> [(name, up.tolist()) for name, up in pendants({"bodies": {"load": load}, "forces": gravity})]
    [('load', [0.0, 0.0, 1.0])]
    """
    if not any(law.get("gravity", {}).get("enabled") for law in resolved.get("forces", {}).values()):
        return
    bodies = {name: body for name, body in resolved["bodies"].items() if body["enabled"]}
    carrying = {body.get("parent") for body in bodies.values()}
    for name, body in bodies.items():
        ((kind, joint),) = body["joint"].items()
        if kind not in PENDANTS or name in carrying or not body.get("parent") or not _swings(joint):
            continue
        arm = np.subtract(joint["child_position_m"], body.get("centre_of_mass_m") or [0, 0, 0])
        if length := float(np.linalg.norm(arm)):
            yield name, arm / length


def _swings(joint: dict[str, Any]) -> bool:
    """Whether its axes are free, and no spring keeps them."""
    axes = [joint[axis] for axis in ("first", "second") if axis in joint]
    free = all(axis["mode"] == "free" and not axis.get("spring") for axis in axes)
    return free and joint.get("mode", "free") == "free"


def rods(resolved: dict[str, Any]) -> Iterator[tuple[str, list[dict[str, Any]]]]:
    """The closed loops that are one distance, with their ends.

    >>> end = {"body": "load", "position_m": [0, 0, 0]}
    >>> rod = {"enabled": True, "first": end, "second": end, "constraints": [{"distance": {"length_m": 3}}]}
    >>> [name for name, _ in rods({"loops": {"pendant": rod, "pin": rod | {"constraints": ["x", "z"]}}})]
    ['pendant']
    """
    for name, loop in resolved.get("loops", {}).items():
        is_rod = len(loop["constraints"]) == 1 and "distance" in loop["constraints"][0]
        if loop["enabled"] and is_rod and not isinstance(loop["constraints"][0], str):
            yield name, [loop["first"], loop["second"]]


def _of_pendant(
    results: xarray.Dataset, resolved: dict[str, Any], body: str, up: NDArray[np.float64]
) -> Iterator[str]:
    time = results["time"].values
    ((_, joint),) = resolved["bodies"][body]["joint"].items()
    name = joint.get("name") or body
    if body not in results["body"].values or name not in results["joint"].values:
        return
    reaction = results["joint_reaction"].sel(joint=name)
    pull = sum(reaction.sel(component=f"force_{axis}").values * up[i] for i, axis in enumerate("xyz"))
    yield from _push(f"{name}: the pendant of {body}", pull, time)
    height = np.clip(_turned(results, body, up)[:, 2], -1, 1)
    angle = np.degrees(np.arccos(height))
    if angle.max() > 90:
        at = time[np.argmax(angle > 90)]
        yield (
            f"{name}: {body} swings to {angle.max():.1f} deg from where it hangs, beyond 90 deg first at "
            f"{at:g} s: a rope would go slack; this rod does not"
        )


def _of_rod(
    results: xarray.Dataset, resolved: dict[str, Any], name: str, ends: list[dict[str, Any]]
) -> Iterator[str]:
    """Its force is in the axes of its first end, taken for those of the body: a rod needs no others."""
    first, second = ends
    if any(first.get("orientation_rad") or []) or not all(_is_there(results, end) for end in ends):
        return
    reaction = results["loop_reaction"].sel(loop=name)
    force = np.stack([reaction.sel(component=f"force_{axis}").values for axis in "xyz"], axis=-1)
    if first["body"] != WORLD:
        force = _rotated(results["orientation"].sel(body=first["body"]).values, force)
    way = _place(results, resolved, second) - _place(results, resolved, first)
    length = np.linalg.norm(way, axis=-1)
    pull = -(force * way).sum(axis=-1) / np.where(length > 0, length, 1)
    yield from _push(f"{name}: the rod", pull, results["time"].values)


def _push(what: str, pull: NDArray[np.float64], time: NDArray[np.float64]) -> Iterator[str]:
    if pull.min() < -SMALLEST_PUSH * np.abs(pull).max():
        at = time[np.argmin(pull)]
        yield (
            f"{what} pushes with {-pull.min():.5g} N, at {at:g} s: a rope would go slack; "
            "from there on this run is not that of a load on a rope"
        )


def _is_there(results: xarray.Dataset, end: dict[str, Any]) -> bool:
    """Whether the results have its body; of a flexible one they have segments."""
    return end["body"] == WORLD or end["body"] in results["body"].values


def _place(results: xarray.Dataset, resolved: dict[str, Any], end: dict[str, Any]) -> NDArray[np.float64]:
    """A point of a body in the world, m; it is given in the body's drawing frame."""
    if end["body"] == WORLD:
        return np.asarray(end["position_m"], float)
    centre = resolved["bodies"][end["body"]].get("centre_of_mass_m") or [0, 0, 0]
    place = results["position"].sel(body=end["body"]).values
    return place + _turned(results, end["body"], np.subtract(end["position_m"], centre))


def _turned(results: xarray.Dataset, body: str, vector: NDArray[np.float64]) -> NDArray[np.float64]:
    quaternion = results["orientation"].sel(body=body).values
    return _rotated(quaternion, np.broadcast_to(vector, (len(quaternion), 3)))


def _rotated(quaternion: NDArray[np.float64], vector: NDArray[np.float64]) -> NDArray[np.float64]:
    """Vectors in body axes, in the world's.

    >>> _rotated(np.array([[0.5, 0.5, 0.5, 0.5]]), np.array([[1.0, 0.0, 0.0]])).tolist()
    [[0.0, 1.0, 0.0]]
    """
    w, along = quaternion[:, :1], quaternion[:, 1:]
    across = 2 * np.cross(along, vector)
    return vector + w * across + np.cross(along, across)
